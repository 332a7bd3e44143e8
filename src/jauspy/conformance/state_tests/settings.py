"""Limits that are set and told in the same words: one is halved for the moment of a step, and all of it set back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Failed, Outcome, Skipped
from jauspy.conformance.state_tests.explorer import Aftermath, Stimulus, Walker
from jauspy.conformance.state_tests.sample_messages import neutral
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.core import QueryTime, ReportTime, SetTime
from jauspy.messages.manipulator import (
    QueryJointMotionProfile,
    QueryPanTiltMotionProfile,
    ReportJointMotionProfile,
    ReportPanTiltMotionProfile,
    SetJointMotionProfile,
    SetPanTiltMotionProfile,
)
from jauspy.messages.mobility import QueryAccelerationLimit, ReportAccelerationLimit, SetAccelerationLimit
from jauspy.services.units import date_stamp, time_stamp

TOLD: Final = "limits before"


@dataclass(frozen=True, slots=True)
class Mirror:
    """`part` is what has the `field`, in the command as in the report: their bodies are the same."""

    command: type[Message]
    query: Message
    report: type[Message]
    field: str
    part: Callable[[Any], Any] = lambda message: message

    def stimulus(self) -> Stimulus:
        """The command with the half."""
        return Stimulus(
            self.command.NAME, self._halved, before=self._read, after=self._set_back, verify=self._is_in_force
        )

    def _read(self, walker: Walker, role: str) -> None:  # noqa: ARG002 - a Prepare
        """What it tells; nothing where there is no limit yet."""
        walker.tester.memory.pop(TOLD, None)
        try:
            told = walker.client(OBSERVER).ask(self.query, self.report, to=walker.component)
        except Outcome:
            return  # the step of the query says so, if that is wrong
        if self._value(told) is not None:
            walker.tester.memory[TOLD] = told

    def _value(self, message: Message) -> float | None:
        part = self.part(message)
        return None if part is None else getattr(part, self.field)

    def _halved(self, walker: Walker) -> Message:
        if TOLD not in walker.tester.memory:
            return neutral(self.command)
        command = self._as_told(walker)
        setattr(self.part(command), self.field, getattr(self.part(command), self.field) / 2)
        return command

    def _as_told(self, walker: Walker) -> Message:
        body: bytes = walker.tester.memory[TOLD].encode()[2:]
        return self.command.decode(self.command.CODE.to_bytes(2, "little") + body)

    def _set_back(self, walker: Walker, role: str) -> None:
        if TOLD in walker.tester.memory:
            walker.client(role).send(self._as_told(walker), to=walker.component)
            walker.look()

    def _is_in_force(self, then: Aftermath) -> None:
        walker = then.walker
        if (told := walker.tester.memory.get(TOLD)) is None:
            return
        before = getattr(self.part(told), self.field)
        wanted = before / 2 if then.outcome.acts else before

        def problem(report: Message) -> str:
            value = self._value(report)
            right = value is not None and abs(value - wanted) <= before / 8
            return "" if right else f"{self.field} is {value}, not {wanted:g}"

        walker.client(OBSERVER).ask(
            self.query, self.report, Check("tells the limit that is in force", problem), to=walker.component
        )


def _first_joint(message: Any) -> Any:
    return next(iter(message.joint_motion_profile_list), None)


MIRRORS: Final = tuple(
    each.stimulus()
    for each in (
        Mirror(
            SetJointMotionProfile, QueryJointMotionProfile(), ReportJointMotionProfile, "joint_max_speed", _first_joint
        ),
        Mirror(SetPanTiltMotionProfile, QueryPanTiltMotionProfile(), ReportPanTiltMotionProfile, "joint1_max_speed"),
        Mirror(
            SetAccelerationLimit,
            QueryAccelerationLimit(1, SetAccelerationLimit.CommandType.MAX_ACCELERATION),
            ReportAccelerationLimit,
            "acceleration_x",
        ),
    )
)


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
