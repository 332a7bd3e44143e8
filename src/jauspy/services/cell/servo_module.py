"""ServoModule: moves and measures one servo module. The frame of the world has z up, as that of the robot's files."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

from jauspy.messages.cell import (
    ReportServoGains,
    ReportServoSpecification,
    ReportServoState,
    SetServoGains,
    SetServoTarget,
)
from jauspy.platform.joints import ControlMode, Gains, Target
from jauspy.platform.modular.parts import PartType
from jauspy.platform.modular.servo import ServoModule
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.units import sent_text

_MODES: Final[Mapping[int, ControlMode]] = {
    SetServoTarget.Mode.POSITION_MODE: ControlMode.POSITION,
    SetServoTarget.Mode.VELOCITY_MODE: ControlMode.VELOCITY,
    SetServoTarget.Mode.EFFORT_MODE: ControlMode.EFFORT,
}


class ServoControl:
    """Commands a servo module for the services of its component."""

    def __init__(self, servo: ServoModule, type: PartType) -> None:
        self.servo = servo
        self.type = type
        self._holding = False

    def follow(self, target: Target, feed_forward: float) -> None:
        """Follow a target; `feed_forward` in newton metres."""
        self._holding = False
        self.servo.command(target, feed_forward)

    def stop(self) -> None:
        """Hold, unless it already does: each new hold would take the position of a sagging joint."""
        if not self._holding:
            self._holding = True
            self.servo.hold()


class ServoModuleService(ContinuousCommands, urn="urn:jauspy:cell:ServoModule"):
    """A servo module. While a modular arm moves it, targets are ignored and counted, and the reported state shows this.

    Velocities and torques end without a further target, positions do not.
    """

    def __init__(self, control: ServoControl) -> None:
        self._control = control
        self._servo = control.servo

    def set_servo_target(self, msg: SetServoTarget) -> None:
        """Follow a target; one with a value that is not a finite number is ignored and counted."""
        feed_forward = msg.feed_forward or 0.0
        mode = _MODES.get(msg.mode)
        if mode is None or not math.isfinite(msg.value) or not math.isfinite(feed_forward):
            self.host.count("invalid_target", f"{msg}")
        elif self._servo.state().claimed_by:
            self.host.count("claimed", f"{msg}")
        else:
            self._control.follow(Target(mode, msg.value), feed_forward)
            if mode is ControlMode.POSITION:
                self.expect_no_command()
            else:
                self.expect_next_command(self._control.stop)

    def set_servo_gains(self, msg: SetServoGains) -> None:
        """Set the gains; those that are negative or not finite numbers are ignored, all of them, and counted."""
        position = Gains(msg.position_p, msg.position_i, msg.position_d, _limit(msg.position_i_limit))
        velocity = Gains(msg.velocity_p, msg.velocity_i, msg.velocity_d, _limit(msg.velocity_i_limit))
        if _are_valid(position) and _are_valid(velocity):
            self._servo.set_gains(position, velocity)
        else:
            self.host.count("invalid_gains", f"{msg}")

    def hold_servo(self) -> None:
        """Hold the position; runs when Ready is left."""
        self.expect_no_command()
        self._control.stop()

    def control_lost(self) -> None:
        """Hold the position: the next client must not inherit a motion."""
        super().control_lost()
        self.hold_servo()

    def report_servo_state(self) -> ReportServoState:
        """Position, velocity, torque, supply and orientation of the module, as it measures them."""
        state = self._servo.state()
        (w, x, y, z), rate, acceleration = state.orientation, state.angular_velocity, state.acceleration
        return ReportServoState(
            position=state.position,
            velocity=state.velocity,
            torque=state.torque,
            current=state.current,
            temperature=state.temperature,
            voltage=state.voltage,
            orientation_w=w,
            orientation_x=x,
            orientation_y=y,
            orientation_z=z,
            angular_velocity_x=rate[0],
            angular_velocity_y=rate[1],
            angular_velocity_z=rate[2],
            acceleration_x=acceleration[0],
            acceleration_y=acceleration[1],
            acceleration_z=acceleration[2],
            claimed_by=sent_text(state.claimed_by),
        )

    def report_servo_gains(self) -> ReportServoGains:
        """The gains that were last set."""
        position, velocity = self._servo.gains()
        return ReportServoGains(
            position_p=position.p,
            position_i=position.i,
            position_d=position.d,
            position_i_limit=_sent_limit(position),
            velocity_p=velocity.p,
            velocity_i=velocity.i,
            velocity_d=velocity.d,
            velocity_i_limit=_sent_limit(velocity),
        )

    def report_servo_specification(self) -> ReportServoSpecification:
        """The data sheet."""
        type, data = self._control.type, self._control.type.servo
        assert data is not None, "a servo module has a data sheet"
        return ReportServoSpecification(
            sent_text(self._servo.name),
            type=sent_text(type.name),
            max_torque=data.max_torque,
            max_speed=data.max_speed,
            stiffness=data.stiffness,
            torque_constant=data.torque_constant,
        )


def _limit(sent: float | None) -> float:
    return math.inf if sent is None else sent


def _sent_limit(gains: Gains) -> float | None:
    return gains.i_limit if math.isfinite(gains.i_limit) else None


def _are_valid(gains: Gains) -> bool:
    """The integral part may be without limit."""
    return all(0.0 <= value < math.inf for value in (gains.p, gains.i, gains.d)) and gains.i_limit >= 0.0
