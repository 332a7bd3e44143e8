"""The sensors of the end effector: pose and velocity of the tool point (AS6057)."""

from __future__ import annotations

from jauspy.geometry.vectors import quaternion
from jauspy.messages.manipulator import ReportEndEffectorPose, ReportEndEffectorVelocityState
from jauspy.services.manipulator.arm import Arm
from jauspy.services.service import Service


class EndEffectorPoseSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"):
    """Metres and a quaternion in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_pose(self) -> ReportEndEffectorPose:
        """The tool point, and the attitude of the last joint's frame."""
        tool = self._arm.kinematic_state().tool
        return ReportEndEffectorPose(*tool.position, *quaternion(tool.rotation))


class EndEffectorVelocityStateSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"):
    """rad/s and m/s in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_velocity_state(self) -> ReportEndEffectorVelocityState:
        """How the tool point moves, and how the last link turns: each joint adds its part."""
        turning, moving = self._arm.kinematic_state().velocity(self._arm.state().velocities)
        return ReportEndEffectorVelocityState(*turning, *moving)
