"""Alarms: shown while their cause lasts and until they are acknowledged, and bounded."""

from __future__ import annotations

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")

from jauspy.console.alarms import MAX_ALARMS, Alarm, Alarms
from jauspy.console.panels.status import kind_of

LOW = Alarm("battery", "battery 12 %")
LOST = Alarm("control", "control was lost", is_urgent=True)


def texts(alarms: Alarms) -> list[tuple[str, bool, bool]]:
    return [(alarm.text, alarm.is_acknowledged, alarm.has_ended) for alarm in alarms.shown]


def test_an_alarm_sounds_until_it_is_acknowledged() -> None:
    alarms = Alarms()
    assert alarms.update([LOW]) == [LOW]
    assert not alarms.is_loud
    assert alarms.update([LOW, LOST]) == [LOST]
    assert alarms.is_loud
    assert [alarm.key for alarm in alarms.shown] == ["control", "battery"], "urgent ones first"
    assert {alarm.key for alarm in alarms.acknowledge()} == {"battery", "control"}
    assert not alarms.is_loud
    assert alarms.update([Alarm("battery", "battery 11 %"), LOST]) == []
    assert texts(alarms) == [("control was lost", True, False), ("battery 11 %", True, False)]
    assert alarms.update([Alarm("failure", "x"), Alarm("battery", "battery 11 %")]) == [Alarm("failure", "x")]
    assert [alarm.key for alarm in alarms.shown] == ["failure", "battery"], "as the causes are ordered"
    alarms.acknowledge()
    assert alarms.update([]) == []
    assert len(alarms) == 0


def test_an_alarm_that_is_over_stays_until_it_is_acknowledged_and_may_come_again() -> None:
    alarms = Alarms()
    alarms.update([LOST])
    alarms.update([])
    assert texts(alarms) == [("control was lost", False, True)]
    assert alarms.is_loud
    assert alarms.update([LOST]) == [LOST]
    alarms.acknowledge()
    alarms.update([])
    assert alarms.update([LOST]) == [LOST], "the same cause again is a new alarm"
    assert alarms.is_loud
    alarms.update([])
    alarms.acknowledge()
    assert len(alarms) == 0


def test_alarms_are_bounded() -> None:
    alarms = Alarms()
    for number in range(5 * MAX_ALARMS):
        alarms.update([Alarm(f"{number}", "x")])
    assert len(alarms) == MAX_ALARMS
    assert f"{5 * MAX_ALARMS - 1}" in {alarm.key for alarm in alarms.shown}
    alarms.update(Alarm(f"at once {number}", "x") for number in range(2 * MAX_ALARMS))
    assert len(alarms) == MAX_ALARMS


def test_events_have_kinds() -> None:
    assert kind_of("emergency stop of all: 10 of 10 components stopped") == "stop"
    assert kind_of("robot 101 inc1 does not answer any more") == "problem"
    assert kind_of("local operates robot 101 with authority 127") == "control"
    assert kind_of("robot 101 inc1 has appeared") == "info"
