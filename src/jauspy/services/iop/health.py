"""HealthReporter: the health of a robot's components, hours of operation, and reminders of maintenance (AEODRS)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Final, Protocol, TypeAlias

from annotated_types import Interval, Len

from jauspy.messages.exp import (
    QueryReminder,
    ReportHealthDetails,
    ReportHealthSummary,
    ReportHourMeter,
    ReportReminder,
    ReportReminderSummary,
    ResetReminder,
)
from jauspy.platform.tables import Converted, Table
from jauspy.services.iop.communicator import Communicator
from jauspy.services.service import Service
from jauspy.services.units import sent_text

CHECK_PERIOD: Final = 1.0
"""Seconds between two tests in the background."""
LONG_QUEUE: Final = 64 << 10
"""Bytes that wait for a client above which the operator is warned: half a second at 1 Mbit/s."""
MINUTE: Final = 60.0
MAX_MINUTES: Final = 0xFFFFFFFF
MAX_NAMES: Final = 5
"""Messages that one entry names."""
MAX_ENTRIES: Final = 255
"""Entries of a list on the wire."""

Severity: TypeAlias = ReportHealthDetails.Severity
Code: TypeAlias = ReportHealthDetails.Code


@dataclass(frozen=True, slots=True)
class HealthEntry:
    """The health of one part, as a service of a component of this node reports it."""

    component: int
    service: str
    """URN."""
    severity: Severity
    code: Code
    """The kind of part; NONE if it works."""
    text: str
    """What the part is, and what is wrong."""


HealthCheck: TypeAlias = Callable[[], Iterable[HealthEntry]]


def _hours(hours: float) -> float:
    return hours * 3600.0


@dataclass(frozen=True, slots=True)
class Reminder(Table):
    """A reminder of maintenance: the table `[[health.reminders]]`."""

    id: Annotated[int, Interval(ge=0, le=255)]
    text: Annotated[str, Len(1, 200)]
    """What is to be done, for people."""
    interval: Annotated[float, Interval(gt=0.0, le=1e6), Converted(_hours)]
    """Seconds (hours in the file) of operation after which it is due."""


class HourMeter(Protocol):
    """Counts how long the robot has been on, and since when each reminder was reset."""

    @property
    def total(self) -> float:
        """Seconds in all."""
        ...

    def add(self, seconds: float) -> None:
        """Count further seconds."""
        ...

    def since_reset(self, reminder: int) -> float:
        """Seconds since the last reset of a reminder, or since the beginning."""
        ...

    def reset(self, reminder: int) -> None:
        """Reset a reminder."""
        ...


class HoursInMemory:
    """An `HourMeter` that begins at zero with each start of the robot."""

    def __init__(self, total: float = 0.0, resets: dict[int, float] | None = None) -> None:
        self._total = total
        self._resets = {} if resets is None else resets
        """Total seconds at the last reset, by the id of the reminder."""

    @property
    def total(self) -> float:
        """Same as `HourMeter.total`."""
        return self._total

    @property
    def resets(self) -> dict[int, float]:
        """Total seconds at the last reset of reminders, by id."""
        return dict(self._resets)

    def add(self, seconds: float) -> None:
        """Same as `HourMeter.add`."""
        self._total += max(0.0, seconds)

    def since_reset(self, reminder: int) -> float:
        """Same as `HourMeter.since_reset`."""
        return max(0.0, self._total - self._resets.get(reminder, 0.0))

    def reset(self, reminder: int) -> None:
        """Same as `HourMeter.reset`."""
        self._resets[reminder] = self._total


@dataclass(frozen=True, slots=True)
class _Logged:
    entry: HealthEntry
    time: datetime
    """When the entry became what it is."""


class HealthReporter(Service, urn="urn:jaus:jss:exp:aeodrs:HealthReporter"):
    """Runs the checks at the start, in the background and on command, and keeps their latest results.

    A reminder whose id does not exist is reported with an interval of zero and a text that says so.
    """

    def __init__(
        self, checks: Sequence[HealthCheck], reminders: Sequence[Reminder] = (), meter: HourMeter | None = None
    ) -> None:
        self._checks = checks
        self._reminders = {reminder.id: reminder for reminder in reminders}
        self._meter = meter or HoursInMemory()
        self._counted = 0.0
        self._logged: list[_Logged] = []

    def attached(self) -> None:
        """Check at the start, and from now on."""
        self._counted = self.host.now
        self._check()
        self.every(CHECK_PERIOD, self._check)

    @property
    def entries(self) -> list[HealthEntry]:
        """The latest results."""
        return [logged.entry for logged in self._logged]

    def update_health_reporter_action(self) -> None:
        """Run the checks; they take no time, so that none is ever pending."""
        self._check()

    def reset_reminder_action(self, msg: ResetReminder) -> None:
        """Begin the interval of a reminder anew; one that does not exist is counted."""
        if msg.reminder_id in self._reminders:
            self._meter.reset(msg.reminder_id)
        else:
            self.host.count("unknown_reminder", f"{msg}")

    def send_report_health_details(self) -> ReportHealthDetails:
        """All entries, by component (FD01)."""
        kind, found = ReportHealthDetails, dict[int, list[ReportHealthDetails.ComponentStatuRec]]()
        for logged in self._logged:
            records = found.setdefault(logged.entry.component, [])
            if len(records) < MAX_ENTRIES:
                records.append(_record(logged))
        return kind([kind.DetailedStatuSeq(kind.ComponentRec(id), rows) for id, rows in found.items()][:MAX_ENTRIES])

    def send_report_health_summary(self) -> ReportHealthSummary:
        """The worst of each component (FD02)."""
        kind, worst = ReportHealthSummary, dict[int, int]()
        for entry in self.entries:
            worst[entry.component] = max(worst.get(entry.component, 0), entry.severity)
        rows = [
            kind.SummaryStatuSeq(kind.ComponentRec(id), kind.SeverityRec(kind.Severity(severity)))
            for id, severity in worst.items()
        ]
        return kind(rows[:MAX_ENTRIES])

    def send_report_hour_meter(self) -> ReportHourMeter:
        """Minutes that the robot has been on (FD03)."""
        return ReportHourMeter(_minutes(self._meter.total))

    def send_report_reminder_summary(self) -> ReportReminderSummary:
        """The reminders that are due (FD04)."""
        kind = ReportReminderSummary
        return kind(
            [
                kind.ReminderSummaryRec(reminder.id, kind.ReminderStatus(self._is_due(reminder)))
                for reminder in self._reminders.values()
            ]
        )

    def send_report_reminder(self, msg: QueryReminder) -> ReportReminder:
        """One reminder (FD05)."""
        status = ReportReminder.ReminderStatus
        reminder = self._reminders.get(msg.reminder_id)
        if reminder is None:
            known = ", ".join(map(str, self._reminders)) or "none"
            text = sent_text(f"there is no reminder {msg.reminder_id}; there are: {known}")
            return ReportReminder(msg.reminder_id, status.NOT_EXPIRED, text, 0, 0)
        elapsed = self._meter.since_reset(reminder.id)
        due = status(self._is_due(reminder))
        return ReportReminder(
            reminder.id, due, sent_text(reminder.text), _minutes(reminder.interval), _minutes(elapsed)
        )

    def _queues(self) -> list[HealthEntry]:
        """What waits to be sent to clients whose links the Communicator of this component measures."""
        communicator = self.host.service(Communicator)
        return [
            HealthEntry(
                self.host.id.component,
                Communicator.urn,
                Severity.WARN if size > LONG_QUEUE else Severity.NONE,
                Code.NONE,
                f"{size >> 10} kB wait to be sent to {client}" if size > LONG_QUEUE else f"little waits for {client}",
            )
            for client, size in (communicator.queues() if communicator is not None else {}).items()
        ]

    def _left_out(self) -> list[HealthEntry]:
        """What the limits of links to these clients have left out."""
        communicator = self.host.service(Communicator)
        entries = []
        for client, counts in (communicator.left_out() if communicator is not None else {}).items():
            most = sorted(counts.items(), key=lambda entry: -entry[1])[:MAX_NAMES]
            if most:
                text = f"the link to {client} leaves out {', '.join(f'{count} {name}' for name, count in most)} in 10 s"
                entries.append(HealthEntry(self.host.id.component, Communicator.urn, Severity.INFO, Code.NONE, text))
        return entries

    def _is_due(self, reminder: Reminder) -> bool:
        return self._meter.since_reset(reminder.id) >= reminder.interval

    def _check(self) -> None:
        now = self.host.now
        self._meter.add(now - self._counted)
        self._counted = now
        before = {logged.entry: logged.time for logged in self._logged}
        entries = [entry for check in self._checks for entry in check()]
        entries += [
            HealthEntry(self.host.id.component, self.urn, Severity.INFO, Code.NONE, f"due: {reminder.text}")
            for reminder in self._reminders.values()
            if self._is_due(reminder)
        ]
        entries += self._queues()
        entries += self._left_out()
        time = self.host.utc_time
        self._logged = [_Logged(entry, before.get(entry, time)) for entry in entries]


def _record(logged: _Logged) -> ReportHealthDetails.ComponentStatuRec:
    entry, time = logged.entry, logged.time
    stamp = ReportHealthDetails.Logtime(
        milliseconds=time.microsecond // 1000, seconds=time.second, minute=time.minute, hour=time.hour, day=time.day
    )
    return ReportHealthDetails.ComponentStatuRec(
        sent_text(entry.service), entry.severity, entry.code, stamp, sent_text(entry.text)
    )


def _minutes(seconds: float) -> int:
    return min(MAX_MINUTES, int(seconds / MINUTE))
