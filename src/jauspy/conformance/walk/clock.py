"""SetTime: taken it moves the component's clock, and ignored it does not."""

from __future__ import annotations

from datetime import datetime, timedelta
from typing import Final

from jauspy.conformance.checks import Check
from jauspy.conformance.outcome import Failed, Skipped
from jauspy.conformance.walk.stimulus import Aftermath, Stimulus
from jauspy.conformance.walk.walker import OBSERVER, Walker
from jauspy.messages.core import QueryTime, ReportTime, SetTime
from jauspy.services.units import date_stamp, time_stamp

AHEAD: Final = 20.0
"""Timeouts that the clock is put forward; put back at the end of the step."""
TOLERANCE: Final = 5.0
"""Timeouts; an answer alone may take one."""
BOTH: Final = 3
"""Presence bits of time and date."""
CLOCK: Final = "clock of the component"


def _ask(walker: Walker, *checks: Check) -> ReportTime:
    return walker.client(OBSERVER).ask(QueryTime(BOTH), ReportTime, *checks, to=walker.component)


def _moment(report: ReportTime) -> datetime:
    """What it tells; without a date that day of some month. Raises `ValueError` for a time that there is not."""
    time, date = report.time_stamp, report.date_stamp
    if time is None:
        raise Skipped("ReportTime has no time of day, which would show what SetTime does")
    year, month, day = (2000 + date.year, date.month, date.day) if date else (2000, 1, time.day)
    return datetime(year, month, day, time.hour, time.minutes, time.seconds, time.milliseconds * 1000)  # noqa: DTZ001 - only differences count


def _read(walker: Walker, role: str) -> None:  # noqa: ARG001 - a Prepare
    walker.tester.memory.pop(CLOCK, None)
    report = _ask(walker)
    try:
        told = _moment(report)
    except ValueError as error:
        raise Failed(f"ReportTime tells a time that there is not: {error}") from error
    walker.tester.memory[CLOCK] = told - timedelta(seconds=walker.tester.now), report.date_stamp is not None


def _set(walker: Walker, ahead: float) -> SetTime:
    """The time that the component has told, and that has passed since, and some more."""
    began, dated = walker.tester.memory[CLOCK]
    wanted = began + timedelta(seconds=walker.tester.now + ahead)
    return SetTime(time_stamp=time_stamp(wanted), date_stamp=date_stamp(wanted) if dated else None)


def _is_set(then: Aftermath) -> None:
    walker = then.walker
    ahead = AHEAD * walker.tester.timeout if then.outcome.acts else 0.0

    def problem(report: ReportTime) -> str:
        began, _ = walker.tester.memory[CLOCK]
        try:
            off = (_moment(report) - began).total_seconds() - walker.tester.now - ahead
        except ValueError as error:
            return f"it tells a time that there is not: {error}"
        return f"it is {off:+.1f} s off" if abs(off) > TOLERANCE * walker.tester.timeout else ""

    _ask(walker, Check("tells the time that was set" if ahead else "tells the time as before", problem))


def _put_back(walker: Walker, role: str) -> None:
    if CLOCK in walker.tester.memory:
        walker.client(role).send(_set(walker, 0.0), to=walker.component)
        walker.look()


CLOCKS: Final = (
    Stimulus(
        "SetTime",
        lambda walker: _set(walker, AHEAD * walker.tester.timeout),
        before=_read,
        after=_put_back,
        verify=_is_set,
    ),
)
