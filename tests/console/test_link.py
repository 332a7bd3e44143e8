"""The panel Link: what it shows, and what it warns of."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")

from jauspy.console.panels.link import alarm, described, queue_alarm
from jauspy.ocu.state import HealthReport, LinkHealth


def test_values_in_short():
    assert described(LinkHealth(True, 0.0234, 0.02)) == "23 ms there and back, 2 % lost or late"
    assert described(LinkHealth(True, None, 0.0)) == "0 % lost or late"
    assert described(LinkHealth(True, 0.02, 0.0, 1_234_000.0)) == "20 ms there and back, 0 % lost or late, 1.23 Mbit/s"


def test_alarm_of_long_queues():
    now = datetime(2026, 1, 1, tzinfo=UTC)
    urn = "urn:jaus:jss:iop:Communicator"
    short = HealthReport(110, urn, "NONE", "NONE", "little waits for 42.1.1", now)
    long = replace(short, severity="WARN", text="195 kB wait to be sent to 42.1.1")
    other = replace(long, service="urn:jaus:jss:exp:aeodrs:HealthReporter", text="the disk is full")
    assert queue_alarm([short, other]) == ""
    assert queue_alarm([short, other, long]) == "195 kB wait to be sent to 42.1.1"


@pytest.mark.parametrize(
    ("health", "text"),
    [
        (LinkHealth(True, 0.02, 0.0), ""),
        (LinkHealth(True, 0.02, 0.19), ""),
        (LinkHealth(True, 0.02, 0.35), "35 % of the packets are lost or late"),
        (LinkHealth(True, 0.8, 0.0), "0.8 s there and back"),
        (LinkHealth(False, None, 1.0), "do not arrive here"),
    ],
)
def test_alarms(health: LinkHealth, text: str):
    assert text in alarm(health)
    assert bool(alarm(health)) == bool(text)
