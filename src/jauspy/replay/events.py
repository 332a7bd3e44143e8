"""Reports of events: those of a recording, those that come while it is replayed, and how they differ."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple, TypeAlias

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.replay.comparison import Comparison

MAX_REPORTS: Final = 100_000
"""Reports of events that are kept; later ones are left out."""
NO_REPORT: Final = "(no report)"

EventKey: TypeAlias = tuple[JausID, JausID, int]
"""The client, the component and the number of an event, all as recorded."""


class EventReport(NamedTuple):
    """What one Event message reports."""

    time: float
    """Seconds; of the recording after the first request."""
    message: Message


class EventReports:
    """The reports of events in the order in which they came."""

    def __init__(self) -> None:
        self.by_event: dict[EventKey, list[EventReport]] = {}
        self._count = 0

    def add(self, key: EventKey, time: float, message: Message) -> None:
        """Add a report, unless there are too many."""
        if self._count < MAX_REPORTS:
            self._count += 1
            self.by_event.setdefault(key, []).append(EventReport(time, message))


def event_of(message: Message) -> tuple[int, Message] | None:
    """Number and report of an Event; None for other messages, and for reports that are not decoded."""
    if message.NAME != "Event":
        return None
    report, number = getattr(message, "report_message", None), getattr(message, "event_id", None)
    return (number, report) if isinstance(report, Message) and isinstance(number, int) else None


def event_differences(
    recorded: list[EventReport], live: list[EventReport], comparison: Comparison, *, whole: bool
) -> Iterator[tuple[float, str, str, str]]:
    """Time in the recording, field, recorded and live value of each difference between the reports of one event.

    How many reports of a periodic event come is chance, so reports are taken together that have no differences from
    the one before. Of what is left, reports at the same place are compared. Those beyond the end of the other list are
    differences, but not one at the end, which the end of the recording may have cut off, and none unless `whole`.
    """
    before, now = _distinct(recorded, comparison), _distinct(live, comparison)
    for old, new in zip(before, now, strict=False):
        for path, recorded_value, live_value in comparison.differences(old.message, new.message):
            yield old.time, path, recorded_value, live_value
    last = recorded[-1].time if recorded else 0.0
    if not now and before:
        yield before[0].time, "", before[0].message.NAME, NO_REPORT
    elif whole:
        for old in before[len(now) + 1 :]:
            yield old.time, "", old.message.NAME, NO_REPORT
        for new in now[len(before) + 1 :]:
            yield last, "", NO_REPORT, new.message.NAME


def _distinct(reports: list[EventReport], comparison: Comparison) -> list[EventReport]:
    found: list[EventReport] = []
    for report in reports:
        if not found or next(comparison.differences(found[-1].message, report.message), None) is not None:
            found.append(report)
    return found
