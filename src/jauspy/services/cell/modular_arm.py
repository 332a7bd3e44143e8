"""ModularArm: moves an arm of any number of servo modules. Lists are in the order of the joints, base to tip."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import quaternion
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.cell import (
    MoveModularArm,
    QueryModularArmMotionResult,
    ReportModularArmMotionResult,
    ReportModularArmSpecification,
    ReportModularArmState,
    SetModularArmController,
    SetModularArmOrder,
    SetModularArmTrajectory,
)
from jauspy.platform.modular.arm import CHANGED, ArmController, ModularArm, MotionResult, TrajectoryPoint
from jauspy.platform.modular.parts import CellSetup
from jauspy.services.manipulator.arm import CHECK_PERIOD
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion
from jauspy.services.units import sent_text

MAX_TOLD: Final = 64
"""Clients of which the service remembers which joints were reported to them."""
MAX_RESULTS: Final = 32
"""Motions of which the service remembers the result."""
_TIMER: Final = "modular arm motion"
_LOG: Final = get_logger("jauspy.cell")

_Controller: Final = SetModularArmController.Controller
_CONTROLLERS: Final[Mapping[int, ArmController]] = {
    _Controller.INDEPENDENT_PID: ArmController.PID,
    _Controller.INVERSE_DYNAMICS: ArmController.MODEL,
}
_Reported: Final = ReportModularArmState
_REPORTED: Final = {
    ArmController.PID: _Reported.Controller.INDEPENDENT_PID,
    ArmController.MODEL: _Reported.Controller.INVERSE_DYNAMICS,
}


def motion_command(positions: Iterable[float], duration: float = 0.0) -> MoveModularArm:
    """The command for a motion to these positions, in radians; with NaN a joint stays as it is.

    `duration` in seconds; with 0 the motion takes as long as the limits of the joints demand.
    """
    kind = MoveModularArm
    rows = [kind.JointPositionRec(None if math.isnan(position) else position) for position in positions]
    return kind(kind.MotionDurationRec(duration), rows)


def trajectory_command(
    joints: Iterable[str], points: Iterable[TrajectoryPoint], number: int = 0
) -> SetModularArmTrajectory:
    """The command for a motion of these joints through points; `number` is that of the client, 1 to 2^32 - 1.

    Without joints it is for all, base to tip. A joint that stays must not be among them: the message has no place for
    NaN as a position.
    """
    kind = SetModularArmTrajectory
    record, names = kind.ModularArmTrajectoryRec(number), [kind.JointNameRec(name) for name in joints]
    rows = [kind.TrajectoryPointSeq(kind.PointTimeRec(point.time), _joint_values(point)) for point in points]
    return kind(record, names, rows)


def _joint_values(point: TrajectoryPoint) -> list[SetModularArmTrajectory.JointValuesRec]:
    free = (math.nan,) * len(point.positions)
    rows = zip(point.positions, point.velocities or free, point.accelerations or free, strict=True)
    return [SetModularArmTrajectory.JointValuesRec(q, _given(v), _given(a)) for q, v, a in rows]


def _given(value: float) -> float | None:
    return None if math.isnan(value) else value


def _read_points(msg: SetModularArmTrajectory) -> list[TrajectoryPoint]:
    free = math.nan
    return [
        TrajectoryPoint(
            point.point_time_rec.time,
            tuple(value.position for value in point.value_list),
            tuple(free if value.velocity is None else value.velocity for value in point.value_list),
            tuple(free if value.acceleration is None else value.acceleration for value in point.value_list),
        )
        for point in msg.point_list
    ]


class ArmMotionControl:
    """Commands a modular arm for the services of its component."""

    def __init__(self, arm: ModularArm) -> None:
        self.arm = arm
        self._holding = False

    def move(self, positions: Sequence[float], duration: float, known: Sequence[str] | None) -> int:
        """Move the joints, in radians and seconds; NaN leaves one as it is. Returns the number of the motion.

        The arm refuses it if it has other joints than those `known`.
        """
        self._holding = False
        return self.arm.move(positions, duration, known=known)

    def follow(
        self, joints: Sequence[str] | None, points: Sequence[TrajectoryPoint], known: Sequence[str] | None
    ) -> int:
        """Move these joints, or all, through points; as `move`."""
        self._holding = False
        return self.arm.follow(joints, points, known=known)

    def stop(self) -> None:
        """Hold, unless it already does."""
        if not self._holding:
            self._holding = True
            self.arm.hold()


class ModularArmService(Service, urn="urn:jauspy:cell:ModularArm"):
    """An arm of servo modules.

    After a wrong command the joints hold, and the report of the state contains the reason. A motion is also refused if
    its client was told other joints than those that the arm has now: a module may have been replaced meanwhile.
    """

    def __init__(self, control: ArmMotionControl, cell: CellSetup) -> None:
        self._control = control
        self._arm = control.arm
        self._cell = cell
        self._command = CommandCompletion()
        self._motion = 0
        """Number that the arm reports for the present motion."""
        self._number = 0
        """Number that the client has given to it."""
        self._results: OrderedDict[int, tuple[MotionResult, str]] = OrderedDict()
        """Result and reason of the last motions, by the client's numbers."""
        self._told: OrderedDict[JausID, tuple[str, ...]] = OrderedDict()
        """The joints that were last reported to a client."""

    def move_modular_arm(self, msg: MoveModularArm, source: JausID) -> None:
        """Begin a motion; the command is completed when it has ended, and has failed if it ended early."""
        positions = [math.nan if position.position is None else position.position for position in msg.position_list]
        self._end(MotionResult.REPLACED, "another motion took its place")
        self._follow_motion(0, self._control.move(positions, msg.motion_duration_rec.duration, self._told.get(source)))

    def set_modular_arm_trajectory(self, msg: SetModularArmTrajectory, source: JausID) -> None:
        """Begin a motion through points; as above."""
        self._end(MotionResult.REPLACED, "another motion took its place")
        names = [joint.name for joint in msg.joint_list]
        known = None if names else self._told.get(source)
        motion = self._control.follow(names or None, _read_points(msg), known)
        self._follow_motion(msg.modular_arm_trajectory_rec.motion_number, motion)

    def hold_modular_arm(self) -> None:
        """Brake and hold."""
        self._end(MotionResult.STOPPED, "the arm was told to hold")
        self._control.stop()

    def end_modular_arm_motion(self) -> None:
        """Brake and hold, because Ready is left."""
        self._end(MotionResult.STOPPED, "the arm has left the state Ready, or lost the client in control")
        self._control.stop()

    def set_modular_arm_controller(self, msg: SetModularArmController) -> None:
        """Select the controller of the joints."""
        if (controller := _CONTROLLERS.get(msg.controller)) is not None:
            self._arm.set_controller(controller)

    def set_modular_arm_order(self, msg: SetModularArmOrder, source: JausID) -> None:
        """Set the order of the joints, or determine it from the assembly."""
        self._told.pop(source, None)
        self._arm.set_order([joint.name for joint in msg.joint_list])

    def control_lost(self) -> None:
        """Hold: the next client must not inherit a motion."""
        super().control_lost()
        self.end_modular_arm_motion()

    def _tell(self, client: JausID, joints: tuple[str, ...]) -> None:
        self._told[client] = joints
        self._told.move_to_end(client)
        if len(self._told) > MAX_TOLD:
            self._told.popitem(last=False)

    def report_modular_arm_state(self, source: JausID) -> ReportModularArmState:
        """Joints and motion."""
        state = self._arm.state()
        self._tell(source, state.joints)
        tip = Transform.from_pose(state.tip_pose)
        (x, y, z), (qw, qx, qy, qz) = tip.position, quaternion(tip.rotation)
        motion = _Reported.ModularArmMotionRec(
            moving=_Reported.Moving(state.moving),
            controller=_REPORTED[state.controller],
            payload=state.payload,
            tip_x=x,
            tip_y=y,
            tip_z=z,
            tip_orientation_w=qw,
            tip_orientation_x=qx,
            tip_orientation_y=qy,
            tip_orientation_z=qz,
            error=sent_text(state.error),
        )
        rows = zip(state.joints, state.positions, state.velocities, state.efforts, state.targets, strict=False)
        return _Reported(motion, [_Reported.ModularJointRec(sent_text(name), *values) for name, *values in rows])

    def report_modular_arm_specification(self, source: JausID) -> ReportModularArmSpecification:
        """The modules of the arm, and the limits of its joints."""
        report, state = ReportModularArmSpecification, self._arm.state()
        self._tell(source, state.joints)
        types = {part.name: self._cell.types[part.type] for part in self._cell.parts}
        limits = [
            report.JointLimitsRec(sent_text(name), sent_text(types[name].name), data.max_torque, data.max_speed)
            for name in state.joints
            if name in types and (data := types[name].servo)
        ]
        parts = [report.ArmPartRec(sent_text(name)) for name in state.parts]
        return report(report.ModularArmEndsRec(sent_text(state.base), sent_text(state.tip)), limits, parts)

    def report_modular_arm_motion_result(self, query: QueryModularArmMotionResult) -> ReportModularArmMotionResult:
        """How a motion ended, by its number; that of the last one for 0."""
        self._look()
        number = query.motion_number or self._number
        result, reason = self._results.get(number, (MotionResult.UNKNOWN, ""))
        if result is MotionResult.UNKNOWN:
            last = f" among the last {MAX_RESULTS}" if self._results else " since the component was started"
            reason = f"the arm has taken no motion{f' of the number {number}' if number else ''}{last}"
        report = ReportModularArmMotionResult
        return report(number, report.Result[result.name], sent_text(reason))

    def _follow_motion(self, number: int, motion: int) -> None:
        """Have the command completed when the motion has ended."""
        self._number, self._motion = number, motion
        self._results[number] = MotionResult.IN_PROGRESS, ""
        self._results.move_to_end(number)
        if len(self._results) > MAX_RESULTS:
            self._results.popitem(last=False)
        self._command = self.host.begin_command()
        self.host.set_timer(_TIMER, self.host.now + CHECK_PERIOD, self._check)

    def _check(self) -> None:
        if not self._look():
            self.host.set_timer(_TIMER, self.host.now + CHECK_PERIOD, self._check)

    def _look(self) -> bool:
        """Take over what the arm's state says of the present motion; True unless it is in progress."""
        if not self._in_progress:
            return True
        state = self._arm.state()
        if state.motion != self._motion or state.result is MotionResult.IN_PROGRESS:
            return False  # the state may be one from before the motion was begun
        if state.error.endswith(CHANGED):
            self.host.count("joints_changed", state.error)
        if state.result is MotionResult.BLOCKED:
            self.host.count("blocked", state.error)
            _LOG.warning("%s: %s", self.host.id, state.error)
        self._end(state.result, state.error)
        return True

    @property
    def _in_progress(self) -> bool:
        return self._results.get(self._number, (MotionResult.UNKNOWN, ""))[0] is MotionResult.IN_PROGRESS

    def _end(self, result: MotionResult, reason: str) -> None:
        """Note the end of the present motion, if it is in progress, and complete its command."""
        if self._in_progress:
            self._results[self._number] = result, reason
        self.host.cancel_timer(_TIMER)
        ended, self._command = self._command, CommandCompletion()
        ended(result is MotionResult.REACHED)
