"""JointDescription: names and positions of joints as the description of the robot (URDF) has them.

The standard counts positions from axes of its own, and does not report where the description has its zero; this service
of jauspy does, so that clients can use the numbers of the description.
"""

from __future__ import annotations

from typing import Final

from jauspy.geometry.frames import joint_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import Rotation, quaternion
from jauspy.messages.description import ReportJointDescription
from jauspy.platform.joints import JointGroup
from jauspy.services.manipulator.arm import REPORTED_ANGLES, Arm
from jauspy.services.service import Service

_TYPES: Final = {
    JointKind.REVOLUTE: ReportJointDescription.JointType.REVOLUTE,
    JointKind.PRISMATIC: ReportJointDescription.JointType.PRISMATIC,
    JointKind.CONTINUOUS: ReportJointDescription.JointType.CONTINUOUS,
}


class JointDescription(Service, urn="urn:jauspy:description:JointDescription"):
    """The group `name` of a robot, whose joints `arm` counts in its own way."""

    def __init__(self, name: str, group: JointGroup, arm: Arm) -> None:
        self._name, self._group, self._arm = name, group, arm

    def report_joint_description(self) -> ReportJointDescription:
        """Radians, metres, newtons and newton metres."""
        tool = quaternion(tool_rotation(self._group, self._arm))
        group = ReportJointDescription.GroupRec(self._name[:255], *tool)
        links = self._arm.geometry.links
        rows = zip(self._group.joints, links, strict=True)
        return ReportJointDescription(group, [_record(joint, link.joint, link.zero_position) for joint, link in rows])


def tool_rotation(group: JointGroup, arm: Arm) -> Rotation:
    """Turns directions in the group's tip link into those of the last joint's frame, as drivers to poses count it."""
    tip = Transform()
    for joint in group.chain:
        tip = tip @ joint_frame(joint, 0.0)
    zero = arm.geometry.from_urdf([0.0] * len(arm.geometry.links))
    return (arm.geometry.forward(zero).inverse() @ tip).rotation


def _record(joint: Joint, counted: Joint, zero: float) -> ReportJointDescription.JointRec:
    directions = ReportJointDescription.Direction
    return ReportJointDescription.JointRec(
        joint.name[:255],
        _TYPES[joint.kind],
        directions.SAME if counted.axis == joint.axis else directions.REVERSED,
        zero,
        max(-REPORTED_ANGLES / 2.0, joint.lower),
        min(REPORTED_ANGLES / 2.0, joint.upper),
        joint.velocity,
        joint.effort,
    )
