"""Closed-loop control of a pan-tilt unit: angles and angular velocities (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import (
    ReportCommandedPanTiltJointPositions,
    ReportCommandedPanTiltJointVelocity,
    SetPanTiltJointPositions,
    SetPanTiltJointVelocity,
)
from jauspy.services.manipulator.joints import JointDriver, PositionDriver


class PanTiltJointPositionDriver(PositionDriver, urn="urn:jaus:jss:manipulator:PanTiltJointPositionDriver"):
    """Radians, positive to the right and upwards; angles beyond a joint's limits are limited."""

    def pan_tilt_motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return self.motion_profile_exists()

    def set_pan_tilt_joint_efforts(self, msg: SetPanTiltJointPositions) -> None:
        """Look there. The standard's definition gives the action this name."""
        self.go([msg.joint1_position, msg.joint2_position])

    def report_commanded_pan_tilt_joint_positions(self) -> ReportCommandedPanTiltJointPositions:
        """What was commanded, while it holds; else where the unit looks."""
        return ReportCommandedPanTiltJointPositions(*(self.commanded or self.arm.state().positions))


class PanTiltJointVelocityDriver(JointDriver, urn="urn:jaus:jss:manipulator:PanTiltJointVelocityDriver"):
    """rad/s, positive to the right and upwards; a joint stops at its limit."""

    def pan_tilt_motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return self.motion_profile_exists()

    def set_pan_tilt_joint_velocity(self, msg: SetPanTiltJointVelocity) -> None:
        """Turn like that until the next command."""
        found = [msg.joint1_velocity, msg.joint2_velocity]
        self.arm.at_velocities(self, found)
        self.commanded = found

    def report_commanded_pan_tilt_joint_velocity(self) -> ReportCommandedPanTiltJointVelocity:
        """What was commanded, while it holds; else zero."""
        return ReportCommandedPanTiltJointVelocity(*(self.commanded or (0.0, 0.0)))
