"""The sensors of the end effector: pose and velocity of the tool point (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportEndEffectorPose, ReportEndEffectorVelocityState
from jauspy.platform.vectors import Vector, add, cross, difference, scaled
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.quaternion import quaternion
from jauspy.services.service import Service


class EndEffectorPoseSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"):
    """Metres and a quaternion in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_pose(self) -> ReportEndEffectorPose:
        """The tool point, and the attitude of the last joint's frame."""
        last = self._arm.frames()[-1]
        return ReportEndEffectorPose(*last.apply(self._arm.tool), *quaternion(last.rotation))


class EndEffectorVelocityStateSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"):
    """rad/s and m/s in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_velocity_state(self) -> ReportEndEffectorVelocityState:
        """How the tool point moves, and how the last link turns: each joint adds its part."""
        turning, moving = velocity(self._arm)
        return ReportEndEffectorVelocityState(*turning, *moving)


def velocity(arm: Arm) -> tuple[Vector, Vector]:
    """Angular and linear velocity of the tool point."""
    frames = arm.frames()
    tool = frames[-1].apply(arm.tool)
    turning = moving = (0.0, 0.0, 0.0)
    for frame, link, rate in zip(frames, arm.geometry.links, arm.state().velocities, strict=True):
        axis = scaled(frame.turn((0.0, 0.0, 1.0)), rate)
        if link.is_revolute:
            turning = add(turning, axis)
            moving = add(moving, cross(axis, difference(tool, frame.position)))
        else:
            moving = add(moving, axis)
    return turning, moving
