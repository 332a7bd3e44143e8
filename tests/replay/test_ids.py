"""Ids inside messages, and reports of events, of a replay."""

from __future__ import annotations

import dataclasses
import re
import typing
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from jauspy.codec.message import Message, Struct
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryServiceList, ReportControl, ReportStatus, ReportSubsystemList
from jauspy.messages.core.v1_1.events import Event
from jauspy.messages.mobility import ReportLocalPose
from jauspy.replay import events
from jauspy.replay.comparison import Comparison
from jauspy.replay.events import EventReport, EventReports, event_differences
from jauspy.replay.ids import has_ids, with_other_ids

DOCS = Path(__file__).parents[2] / "docs" / "replay.md"


def other(id: JausID) -> JausID:
    """101 is 7 now, and the client 42.1.1 is 50.1.9."""
    if id == JausID(42, 1, 1):
        return JausID(50, 1, 9)
    return replace(id, subsystem=7) if id.subsystem == 101 else id


def holder(*parts: int) -> ReportControl:
    return ReportControl(*parts, authority_code=3)


def ids(message: Message) -> list[Any]:
    return re.findall(r"subsystem_id=(\d+)", str(message))


def test_ids_are_changed_wherever_they_are() -> None:
    assert with_other_ids(holder(42, 1, 1), other) == holder(50, 1, 9)
    event = Event(event_id=3, sequence_number=9, report_message=holder(101, 1, 2))
    assert with_other_ids(event, other).report_message == holder(7, 1, 2)  # type: ignore[attr-defined]
    rows = [{"subsystem_id": n, "node_id": 1, "component_id": 1} for n in (101, 5)]
    found = with_other_ids(ReportSubsystemList.from_dict(_with_lists(ReportSubsystemList, rows)), other)
    assert ids(found) == ["7", "5"]


def _with_lists(kind: type[Message], rows: list[dict[str, int]]) -> dict[str, Any]:
    (name,) = [field.name for field in dataclasses.fields(kind)]  # type: ignore[arg-type]
    return {name: rows}


def test_what_has_no_such_id_is_the_same_object() -> None:
    for message in (holder(42, 1, 2), holder(0, 0, 0), ReportLocalPose(x=1.0), QueryServiceList([])):
        assert with_other_ids(message, other) is message


def _structures(kind: type[Struct], name: str, seen: frozenset[type]) -> bool:
    """True if a structure, or one in it, has ids."""
    if kind in seen:
        return False
    if has_ids(kind, name):
        return True
    hints = typing.get_type_hints(kind)
    for field in dataclasses.fields(kind):  # type: ignore[arg-type]
        types = [hints.get(field.name)]
        while types:
            found = types.pop()
            types += typing.get_args(found)
            is_struct = isinstance(found, type) and issubclass(found, Struct) and not issubclass(found, Message)
            if is_struct and _structures(found, field.name, seen | {kind}):
                return True
    return False


@pytest.mark.slow
def test_the_documentation_lists_the_messages_with_ids() -> None:
    """By the definitions; not those that only have a message, which may have ids, inside."""
    found = {entry.name for entry in registry.entries if _structures(entry.load(), "", frozenset())}
    section = DOCS.read_text().partition("### Ids inside messages")[2].partition("Not changed")[0]
    rows = [line for line in section.splitlines() if line.startswith("| ") and "messages |" not in line]
    assert found == set(re.findall(r"\b(?:[A-Z]+[a-z]+){2,}\b", "".join(row.split("|")[2] for row in rows)))


def status(*names: str) -> list[EventReport]:
    made = [ReportStatus.from_dict({"status": name, "reserved": 0}) for name in names]
    return [EventReport(float(number), message) for number, message in enumerate(made)]


def differences(old: list[EventReport], new: list[EventReport], *, whole: bool = True, **settings: Any) -> list[Any]:
    return [row[1:] for row in event_differences(old, new, Comparison(**settings), whole=whole)]


def test_reports_of_events_are_compared_by_their_changes() -> None:
    ready = status("READY", "READY", "STANDBY", "READY")
    assert differences(ready, status("READY", "STANDBY", "STANDBY", "READY", "READY")) == []
    assert differences(ready, status("READY", "EMERGENCY", "READY")) == [("status", "STANDBY", "EMERGENCY")]
    assert differences(ready, []) == [("", "ReportStatus", "(no report)")]
    assert differences(ready, status("READY", "STANDBY")) == []  # one at the end may be cut off
    assert differences(ready, status("READY")) == [("", "ReportStatus", "(no report)")]
    assert differences(status("READY"), ready) == [("", "(no report)", "ReportStatus")]
    assert differences(status("READY"), ready, whole=False) == []


def test_numbers_of_reports_are_compared_if_strict() -> None:
    one, two = ([EventReport(0.0, ReportLocalPose(x=x))] for x in (1.0, 2.0))
    assert differences(one, two) == []
    assert differences(one, two, strict=True) == [("x", "1.0", "2.0")]


def test_reports_are_bounded(monkeypatch: Any) -> None:
    monkeypatch.setattr(events, "MAX_REPORTS", 3)
    reports = EventReports()
    for number in range(5):
        reports.add((JausID(42, 1, 1), JausID(101, 1, 1), number), 0.0, ReportLocalPose(x=1.0))
    assert len(reports.by_event) == 3
