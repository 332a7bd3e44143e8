"""ModularArm: moves an arm of any number of servo modules. Lists are in the order of the joints, base to tip."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import quaternion
from jauspy.ids import JausID
from jauspy.messages.cell import (
    MoveModularArm,
    ReportModularArmSpecification,
    ReportModularArmState,
    SetModularArmController,
    SetModularArmOrder,
)
from jauspy.platform.modular.arm import ArmController, ModularArm
from jauspy.platform.modular.parts import CellSetup
from jauspy.services.manipulator.joints import CHECK_PERIOD
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion
from jauspy.services.units import sent_text

MAX_TOLD: Final = 64
"""Clients of which the service remembers which joints were reported to them."""
CHANGED: Final = "motion refused: the joints have changed since they were reported to this client"
_TIMER: Final = "modular arm motion"

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


class ArmMotionControl:
    """Commands a modular arm for the services of its component."""

    def __init__(self, arm: ModularArm) -> None:
        self.arm = arm
        self._holding = False

    def move(self, positions: Sequence[float], duration: float) -> int:
        """Move the joints, in radians and seconds; NaN leaves one as it is. Returns the number of the motion."""
        self._holding = False
        return self.arm.move(positions, duration)

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
        """Number of the motion of the present command."""
        self._told: OrderedDict[JausID, tuple[str, ...]] = OrderedDict()
        """The joints that were last reported to a client."""
        self._refusal = ""

    def move_modular_arm(self, msg: MoveModularArm, source: JausID) -> None:
        """Begin a motion; the command is completed when it has ended, and has failed if it ended early."""
        self._end_command(False)
        present = self._arm.state().joints
        self._refusal = CHANGED if self._told.get(source, present) != present else ""
        if self._refusal:
            self.host.count("joints_changed", f"{source}: {self._refusal}")
            self._control.stop()
            self.host.begin_command()(False)
            return
        positions = [math.nan if position.position is None else position.position for position in msg.position_list]
        self._motion = self._control.move(positions, msg.motion_duration_rec.duration)
        self._command = self.host.begin_command()
        self.host.set_timer(_TIMER, self.host.now + CHECK_PERIOD, self._check)

    def hold_modular_arm(self) -> None:
        """Brake and hold; runs also when Ready is left."""
        self._end_command(False)
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
        self.hold_modular_arm()

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
            error=sent_text(self._refusal or state.error),
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

    def _check(self) -> None:
        state = self._arm.state()
        if state.moving or state.motion < self._motion:
            self.host.set_timer(_TIMER, self.host.now + CHECK_PERIOD, self._check)
        else:
            self._end_command(not state.error)

    def _end_command(self, succeeded: bool) -> None:
        self.host.cancel_timer(_TIMER)
        ended, self._command = self._command, CommandCompletion()
        ended(succeeded)
