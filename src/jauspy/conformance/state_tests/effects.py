"""Commands and settings whose effect a report shows: accepted ones must have it, ignored ones must not.

Settings are put back: limits are halved and the clock is put forward for a step.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from types import MappingProxyType
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, near, value_of
from jauspy.conformance.results import Failed, Skipped, StepOutcome
from jauspy.conformance.state_tests.behaviour import TruthValue
from jauspy.conformance.state_tests.explorer import Explorer, Prepare, Stimulus, StimulusResult, no_preparation
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.core import QueryTime, ReportTime, SetTime
from jauspy.messages.manipulator import (
    QueryEndEffectorEffort,
    QueryJointMotionProfile,
    QueryPanTiltMotionProfile,
    QueryToolOffset,
    ReportEndEffectorEffort,
    ReportJointMotionProfile,
    ReportPanTiltMotionProfile,
    ReportToolOffset,
    SetEndEffectorEffort,
    SetJointMotionProfile,
    SetPanTiltMotionProfile,
    SetToolOffset,
)
from jauspy.messages.mobility import (
    QueryAccelerationLimit,
    QueryGeomagneticProperty,
    QueryGlobalPose,
    QueryGlobalPoseExt,
    QueryGlobalVector,
    QueryGlobalVectorExt,
    QueryLocalPose,
    QueryLocalPoseExt,
    QueryLocalVector,
    QueryLocalVectorExt,
    QueryWrenchEffort,
    ReportAccelerationLimit,
    ReportGeomagneticProperty,
    ReportGlobalPose,
    ReportGlobalPoseExt,
    ReportGlobalVector,
    ReportGlobalVectorExt,
    ReportLocalPose,
    ReportLocalPoseExt,
    ReportLocalVector,
    ReportLocalVectorExt,
    ReportWrenchEffort,
    SetAccelerationLimit,
    SetGeomagneticProperty,
    SetGlobalPose,
    SetGlobalPoseExt,
    SetGlobalVector,
    SetGlobalVectorExt,
    SetLocalPose,
    SetLocalPoseExt,
    SetLocalVector,
    SetLocalVectorExt,
    SetTravelSpeedExt,
    SetWrenchEffort,
)
from jauspy.messages.ugv import QuerySkidSteerEffort, ReportSkidSteerEffort, SetSkidSteerEffort
from jauspy.services.units import date_stamp, time_stamp

SLOW: Final = 0.05
"""m/s; too slow for a visible motion during a step."""
Speed = SetTravelSpeedExt.Speed
BEFORE: Final = "before the command"


def over_ground(speed: float) -> Any:
    """The speed as the messages with more fields encode it."""
    return Speed(Speed.Choice.SPEED_OVER_GROUND, speed)


def effect(
    command: Callable[[float], Message],
    query: Message,
    report: type[Message],
    field: str,
    change: float,
    *,
    truths: Mapping[str, TruthValue] = MappingProxyType({}),
    variant: str = "",
    prepare: Prepare = no_preparation,
    cleanup: Prepare = no_preparation,
    of: str = "",
) -> Stimulus:
    """A command that changes one number slightly; afterwards the client restores it."""

    def reported(explorer: Explorer) -> float:
        found = value_of(explorer.client(OBSERVER).ask(query, report, to=explorer.component), field)
        if found is None:
            raise Skipped(f"{report.NAME} has no {field}, which would show what the command does")
        return float(found)

    def before(explorer: Explorer, role: str) -> None:
        explorer.tester.memory.pop(BEFORE, None)
        prepare(explorer, role)
        explorer.tester.memory[BEFORE] = reported(explorer)

    def verify(then: StimulusResult) -> None:
        explorer = then.explorer
        wanted = explorer.tester.memory[BEFORE] + (change if then.outcome.acts else 0.0)
        right = near(abs(change) / 4, **{field: wanted})
        explorer.client(OBSERVER).ask_until_right(query, report, right, to=explorer.component)

    def after(explorer: Explorer, role: str) -> None:
        if BEFORE in explorer.tester.memory:
            explorer.client(role).send(command(explorer.tester.memory[BEFORE]), to=explorer.component)
            explorer.observe()
        cleanup(explorer, role)

    return Stimulus(
        command(0.0).NAME,
        lambda explorer: command(explorer.tester.memory[BEFORE] + change),
        variant,
        truths,
        before=before,
        after=after,
        verify=verify,
        of=of,
    )


EFFECTS: Final = (
    effect(
        lambda percent: SetWrenchEffort(propulsive_linear_effort_x=percent),
        QueryWrenchEffort(1),
        ReportWrenchEffort,
        "propulsive_linear_effort_x",
        1.0,
    ),
    effect(
        lambda percent: SetSkidSteerEffort(percent, percent),
        QuerySkidSteerEffort(),
        ReportSkidSteerEffort,
        "left_side_propulsive_effort",
        1.0,
    ),
    effect(SetEndEffectorEffort, QueryEndEffectorEffort(), ReportEndEffectorEffort, "end_effector_effort", 1.0),
    effect(lambda x: SetLocalPose(x=x), QueryLocalPose(1), ReportLocalPose, "x", 2.0),
    effect(lambda degrees: SetGlobalPose(latitude=degrees), QueryGlobalPose(1), ReportGlobalPose, "latitude", 0.001),
    effect(SetLocalVector, QueryLocalVector(0), ReportLocalVector, "speed", SLOW),
    effect(SetGlobalVector, QueryGlobalVector(1), ReportGlobalVector, "speed", SLOW),
    effect(lambda x: SetLocalPoseExt(x=x), QueryLocalPoseExt(1), ReportLocalPoseExt, "x", 2.0),
    effect(
        lambda degrees: SetGlobalPoseExt(latitude=degrees),
        QueryGlobalPoseExt(1),
        ReportGlobalPoseExt,
        "latitude",
        0.001,
    ),
    effect(SetGeomagneticProperty, QueryGeomagneticProperty(), ReportGeomagneticProperty, "magnetic_variation", 0.1),
    effect(
        lambda speed: SetLocalVectorExt(speed=over_ground(speed)),
        QueryLocalVectorExt(0),
        ReportLocalVectorExt,
        "speed__value",
        SLOW,
    ),
    effect(
        lambda speed: SetGlobalVectorExt(speed=over_ground(speed)),
        QueryGlobalVectorExt(0),
        ReportGlobalVectorExt,
        "speed__value",
        SLOW,
    ),
    effect(lambda x: SetToolOffset(x, 0.0, 0.0), QueryToolOffset(), ReportToolOffset, "tool_point_coordinate_x", 0.1),
)
"""Percent; too little to move a robot."""


LIMITS_BEFORE: Final = "limits before"


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit in `field` of `part`. Command and report have the same body, so `part` applies to both."""

    command: type[Message]
    query: Message
    report: type[Message]
    field: str
    part: Callable[[Any], Any] = lambda message: message

    def stimulus(self) -> Stimulus:
        """The command that halves the limit."""
        return Stimulus(
            self.command.NAME, self._halved, before=self._read, after=self._set_back, verify=self._is_in_force
        )

    def _read(self, explorer: Explorer, role: str) -> None:  # noqa: ARG002 - a Prepare
        """Remember the reported limits, if there are any."""
        explorer.tester.memory.pop(LIMITS_BEFORE, None)
        try:
            limits = explorer.client(OBSERVER).ask(self.query, self.report, to=explorer.component)
        except StepOutcome:
            return  # the step of the query fails if this is wrong
        if self._value(limits) is not None:
            explorer.tester.memory[LIMITS_BEFORE] = limits

    def _value(self, message: Message) -> float | None:
        part = self.part(message)
        return None if part is None else getattr(part, self.field)

    def _halved(self, explorer: Explorer) -> Message:
        if LIMITS_BEFORE not in explorer.tester.memory:
            return neutral(self.command)
        command = self._original(explorer)
        setattr(self.part(command), self.field, getattr(self.part(command), self.field) / 2)
        return command

    def _original(self, explorer: Explorer) -> Message:
        body: bytes = explorer.tester.memory[LIMITS_BEFORE].encode()[2:]
        return self.command.decode(self.command.CODE.to_bytes(2, "little") + body)

    def _set_back(self, explorer: Explorer, role: str) -> None:
        if LIMITS_BEFORE in explorer.tester.memory:
            explorer.client(role).send(self._original(explorer), to=explorer.component)
            explorer.observe()

    def _is_in_force(self, then: StimulusResult) -> None:
        explorer = then.explorer
        if (limits := explorer.tester.memory.get(LIMITS_BEFORE)) is None:
            return
        before = getattr(self.part(limits), self.field)
        wanted = before / 2 if then.outcome.acts else before

        def problem(report: Message) -> str:
            value = self._value(report)
            right = value is not None and abs(value - wanted) <= before / 8
            return "" if right else f"{self.field} is {value}, not {wanted:g}"

        explorer.client(OBSERVER).ask(
            self.query, self.report, Check("contains the limit that is in force", problem), to=explorer.component
        )


def _first_joint(message: Any) -> Any:
    return next(iter(message.joint_motion_profile_list), None)


LIMITS: Final = tuple(
    limit.stimulus()
    for limit in (
        Limit(
            SetJointMotionProfile, QueryJointMotionProfile(), ReportJointMotionProfile, "joint_max_speed", _first_joint
        ),
        Limit(SetPanTiltMotionProfile, QueryPanTiltMotionProfile(), ReportPanTiltMotionProfile, "joint1_max_speed"),
        Limit(
            SetAccelerationLimit,
            QueryAccelerationLimit(1, SetAccelerationLimit.CommandType.MAX_ACCELERATION),
            ReportAccelerationLimit,
            "acceleration_x",
        ),
    )
)


CLOCK_STEP: Final = 20.0
"""Timeouts by which the clock is put forward; it is put back at the end of the step."""
TOLERANCE: Final = 5.0
"""Timeouts; an answer alone may take one."""
BOTH: Final = 3
"""Presence bits of time and date."""
CLOCK: Final = "clock of the component"


def _ask(explorer: Explorer, *checks: Check) -> ReportTime:
    return explorer.client(OBSERVER).ask(QueryTime(BOTH), ReportTime, *checks, to=explorer.component)


def _date_and_time(report: ReportTime) -> datetime:
    """The reported time; without a date, that day of January 2000. Raises `ValueError` if there is no such time."""
    time, date = report.time_stamp, report.date_stamp
    if time is None:
        raise Skipped("ReportTime has no time of day, so the effect of SetTime cannot be verified")
    year, month, day = (2000 + date.year, date.month, date.day) if date else (2000, 1, time.day)
    return datetime(year, month, day, time.hour, time.minutes, time.seconds, time.milliseconds * 1000)  # noqa: DTZ001 - only differences count


def _read(explorer: Explorer, role: str) -> None:  # noqa: ARG001 - a Prepare
    explorer.tester.memory.pop(CLOCK, None)
    report = _ask(explorer)
    try:
        reported = _date_and_time(report)
    except ValueError as error:
        raise Failed(f"ReportTime has an invalid time: {error}") from error
    explorer.tester.memory[CLOCK] = reported - timedelta(seconds=explorer.tester.now), report.date_stamp is not None


def _set(explorer: Explorer, ahead: float) -> SetTime:
    """The present time of the component's clock, plus `ahead` seconds."""
    began, dated = explorer.tester.memory[CLOCK]
    wanted = began + timedelta(seconds=explorer.tester.now + ahead)
    return SetTime(time_stamp=time_stamp(wanted), date_stamp=date_stamp(wanted) if dated else None)


def _is_set(then: StimulusResult) -> None:
    explorer = then.explorer
    ahead = CLOCK_STEP * explorer.tester.timeout if then.outcome.acts else 0.0

    def problem(report: ReportTime) -> str:
        began, _ = explorer.tester.memory[CLOCK]
        try:
            off = (_date_and_time(report) - began).total_seconds() - explorer.tester.now - ahead
        except ValueError as error:
            return f"it has an invalid time: {error}"
        return f"it is {off:+.1f} s off" if abs(off) > TOLERANCE * explorer.tester.timeout else ""

    _ask(explorer, Check("has the time that was set" if ahead else "has the unchanged time", problem))


def _put_back(explorer: Explorer, role: str) -> None:
    if CLOCK in explorer.tester.memory:
        explorer.client(role).send(_set(explorer, 0.0), to=explorer.component)
        explorer.observe()


CLOCK_STIMULI: Final = (
    Stimulus(
        "SetTime",
        lambda explorer: _set(explorer, CLOCK_STEP * explorer.tester.timeout),
        before=_read,
        after=_put_back,
        verify=_is_set,
    ),
)
