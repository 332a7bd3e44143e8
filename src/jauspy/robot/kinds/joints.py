"""The service JointDescription of the kinds that move joints."""

from __future__ import annotations

from jauspy.geometry.fingers import FingerWidth
from jauspy.platform.contract import RobotParts
from jauspy.services.manipulator import Arm, JointDescription


def joint_description(robot: RobotParts, arm: Arm, width: FingerWidth | None = None) -> JointDescription | None:
    """The service that describes the joints of `arm`; None if they are no group of the robot."""
    for name, group in robot.groups.items():
        if group.joints[0].name == arm.joints.joints[0].name:
            return JointDescription(name, group, arm, width)
    return None
