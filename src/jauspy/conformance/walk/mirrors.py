"""Limits that are set and told in the same words: one is halved for the moment of a step, and all of it set back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from jauspy.codec.base import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Outcome
from jauspy.conformance.walk.explorer import OBSERVER, Aftermath, Stimulus, Walker
from jauspy.conformance.walk.sample_messages import neutral
from jauspy.messages.manipulator import (
    QueryJointMotionProfile,
    QueryPanTiltMotionProfile,
    ReportJointMotionProfile,
    ReportPanTiltMotionProfile,
    SetJointMotionProfile,
    SetPanTiltMotionProfile,
)
from jauspy.messages.mobility import QueryAccelerationLimit, ReportAccelerationLimit, SetAccelerationLimit

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
