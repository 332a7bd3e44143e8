"""The service JointDescription of the kinds that move joints."""

from __future__ import annotations

from typing import Final

from jauspy.geometry.fingers import FingerWidth
from jauspy.geometry.frames import joint_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import JointKind
from jauspy.platform.contract import RobotParts
from jauspy.platform.joints import JointGroup
from jauspy.services.iop import EndEffectorForceTorqueSensor
from jauspy.services.manipulator import Arm, JointDescription
from jauspy.services.manipulator.specification import tool_rotation

MOTOR_DATA: Final = "electrical data of motors: a battery ([battery]), or drives on CAN"


def joint_description(robot: RobotParts, arm: Arm, width: FingerWidth | None = None) -> JointDescription | None:
    """The service that describes the joints of `arm`; None if they are no group of the robot."""
    found = _group_of(robot, arm)
    return None if found is None else JointDescription(*found, arm, width)


def end_effector_load(robot: RobotParts, arm: Arm) -> EndEffectorForceTorqueSensor | None:
    """The service for a sensor of force and torque on a link that the tip of `arm` is fixed to; None without one."""
    found = _group_of(robot, arm)
    if found is None:
        return None
    _, group = found
    tip = Transform()
    for joint in reversed(group.chain):
        sensor = next((one for one in robot.force_torque.values() if one.setup.link == joint.child), None)
        if sensor is not None:
            return EndEffectorForceTorqueSensor(sensor, tip, Transform(tool_rotation(group, arm)))
        if joint.kind is not JointKind.FIXED:
            return None
        tip = joint_frame(joint, 0.0) @ tip
    return None


def _group_of(robot: RobotParts, arm: Arm) -> tuple[str, JointGroup] | None:
    """The group of the robot with the joints of `arm`, and its name."""
    return next(
        ((name, group) for name, group in robot.groups.items() if group.joints[0].name == arm.joints.joints[0].name),
        None,
    )
