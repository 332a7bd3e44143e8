"""ManipulatorEndEffectorVelocityStateDriver: moves the tool on a straight line, and turns it (AS6057)."""

from __future__ import annotations

from typing import Final

from jauspy.messages.manipulator import ReportCommandedEndEffectorVelocityState, SetEndEffectorVelocityState
from jauspy.services.manipulator.arm import Arm, ArmDriver
from jauspy.services.manipulator.tool_motion import ToolMotion

CONTROL_PERIOD: Final = 0.02
"""Seconds between two looks at where the tool is, and new velocities of the joints."""
VELOCITY_RESOLUTION: Final = 1e-7
"""rad/s or m/s below which a velocity was meant to be zero, which lies between two steps of its field."""
ZERO_VELOCITY: Final = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class EndEffectorVelocityStateDriver(
    ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
):
    """rad/s and m/s in the manipulator's coordinate system, as EndEffectorVelocityStateSensor reports them.

    Within the motion profile: what would be too fast for a joint is slower as a whole. At the end of its reach the tool
    stops on its line.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._commanded = ZERO_VELOCITY
        self._motion: ToolMotion | None = None

    def motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def set_end_effector_velocity_state(self, msg: SetEndEffectorVelocityState) -> None:
        """Move like that until the next command."""
        turning = (
            _velocity(msg.angular_velocity_component_x),
            _velocity(msg.angular_velocity_component_y),
            _velocity(msg.angular_velocity_component_z),
        )
        moving = (
            _velocity(msg.linear_velocity_component_x),
            _velocity(msg.linear_velocity_component_y),
            _velocity(msg.linear_velocity_component_z),
        )
        self.arm.take(self)
        self._commanded = (*turning, *moving)
        if self._motion is not None:
            self._motion.follow(turning, moving)  # at the next look, however many commands come until then
            return
        self._motion = ToolMotion(self.arm)
        self._motion.follow(turning, moving)
        self.every(CONTROL_PERIOD, self._look)
        self._look()

    def taken_over(self) -> None:
        """What was commanded does not hold any more."""
        self._commanded, self._motion = ZERO_VELOCITY, None
        self.host.cancel_timer(self._look)

    def report_commanded_end_effector_velocity_state(self) -> ReportCommandedEndEffectorVelocityState:
        """What was commanded, while it holds; else zero."""
        return ReportCommandedEndEffectorVelocityState(*self._commanded)

    def _look(self) -> None:
        motion = self._motion
        if motion is None:
            return
        self.arm.at_velocities(self, motion.rates(CONTROL_PERIOD))
        if motion.is_over:
            self.arm.stop()


def _velocity(value: float) -> float:
    return 0.0 if abs(value) < VELOCITY_RESOLUTION else value
