"""ManipulatorSpecification, JointMotionProfile, ToolOffset (AS6057), and jauspy's JointDescription."""

from __future__ import annotations

from typing import Final

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.fingers import FingerWidth
from jauspy.geometry.frames import joint_frame
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import Rotation, quaternion
from jauspy.messages.description import ReportBlockedJoints, ReportJointDescription
from jauspy.messages.manipulator import (
    ManipulatorCoordinateSystemRec,
    ReportJointMotionProfile,
    ReportManipulatorSpecifications,
    ReportToolOffset,
    SetJointMotionProfile,
    SetToolOffset,
)
from jauspy.platform.joints import JointGroup
from jauspy.services.manipulator.arm import REPORTED_ANGLES, Arm, MotionProfile
from jauspy.services.service import Service


class ManipulatorSpecification(Service, urn="urn:jaus:jss:manipulator:ManipulatorSpecificationService"):
    """Denavit-Hartenberg parameters and limits of the joints, metres and radians."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_manipulator_specifications(self) -> ReportManipulatorSpecifications:
        """Report joints and the manipulator's coordinate system in the vehicle's frame: x forward, y right, z down."""
        first, *others = self._arm.geometry.links
        names = [ReportManipulatorSpecifications.JointNameRec(link.joint.name[:255]) for link in (first, *others)]
        return ReportManipulatorSpecifications(
            manipulator_coordinate_system_rec=coordinate_system(self._arm.geometry.base),
            first_joint_parameters=_first_revolute(first) if first.is_revolute else _first_prismatic(first),
            joint_specification_list=[_revolute(link) if link.is_revolute else _prismatic(link) for link in others],
            joint_names_list=None if self.host.older_versions else names,  # version 1.0 of the report has no names
        )


def coordinate_system(base: Transform) -> ManipulatorCoordinateSystemRec:
    """Frame of the manipulator on the vehicle."""
    frame = JAUS_FROM_REP_103 @ base
    return ManipulatorCoordinateSystemRec(*frame.position, *quaternion(frame.rotation))


def _first_revolute(link: DHLink) -> ReportManipulatorSpecifications.RevoluteJoint1OffsetRec:
    joint = link.joint
    return ReportManipulatorSpecifications.RevoluteJoint1OffsetRec(
        link.offset, *_turning_limits(link), joint.velocity, joint.effort
    )


def _turning_limits(link: DHLink) -> tuple[float | None, float | None]:
    """Left out for a joint that turns without end."""
    if link.joint.kind is JointKind.CONTINUOUS:
        return None, None
    return link.joint.lower + link.zero_position, link.joint.upper + link.zero_position


def _first_prismatic(link: DHLink) -> ReportManipulatorSpecifications.PrismaticJoint1AngleRec:
    joint = link.joint
    return ReportManipulatorSpecifications.PrismaticJoint1AngleRec(
        link.angle, joint.lower + link.zero_position, joint.upper + link.zero_position, joint.velocity, joint.effort
    )


def _revolute(link: DHLink) -> ReportManipulatorSpecifications.RevoluteJointSpecificationRec:
    joint = link.joint
    least, greatest = _turning_limits(link)
    return ReportManipulatorSpecifications.RevoluteJointSpecificationRec(
        link_length=link.length,
        twist_angle=link.twist,
        joint_offset=link.offset,
        min_value=least,
        max_value=greatest,
        max_speed=joint.velocity,
        max_torque=joint.effort,
    )


def _prismatic(link: DHLink) -> ReportManipulatorSpecifications.PrismaticJointSpecificationRec:
    joint = link.joint
    return ReportManipulatorSpecifications.PrismaticJointSpecificationRec(
        link_length=link.length,
        twist_angle=link.twist,
        joint_angle=link.angle,
        min_value=joint.lower + link.zero_position,
        max_value=joint.upper + link.zero_position,
        max_speed=joint.velocity,
        max_force=joint.effort,
    )


class JointMotionProfile(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointMotionProfile"):
    """Limits of speed and acceleration, at most those of the joints; in force from the next command on."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def motion_profile_exists(self) -> bool:
        """Always True: without a command the limits of the joints apply."""
        return True

    def set_joint_motion_profile(self, msg: SetJointMotionProfile) -> None:
        """Set the profiles; ignored, and counted, unless there is one of the right kind for each joint."""
        records, links = msg.joint_motion_profile_list, self._arm.geometry.links
        revolute = [isinstance(record, SetJointMotionProfile.RevoluteJointMotionProfileRec) for record in records]
        if revolute != [link.is_revolute for link in links]:
            self.host.count("wrong_joints", f"{msg}")
            return
        self._arm.profiles = tuple(
            limited_profile(
                MotionProfile(r.joint_max_speed, r.joint_max_acceleration_rate, r.joint_max_deceleration_rate),
                MotionProfile.of(link.joint),
            )
            for r, link in zip(records, links, strict=True)
        )

    def report_joint_motion_profile(self) -> ReportJointMotionProfile:
        """The profiles in force."""
        rows = zip(self._arm.profiles, self._arm.geometry.links, strict=True)
        return ReportJointMotionProfile([_record(profile, link) for profile, link in rows])


def limited_profile(profile: MotionProfile, limits: MotionProfile) -> MotionProfile:
    """The profile limited to that of the joint; a zero, with which the joint would not move, means no limit."""
    return MotionProfile(
        min(profile.speed or limits.speed, limits.speed),
        min(profile.acceleration or limits.acceleration, limits.acceleration),
        min(profile.deceleration or limits.deceleration, limits.deceleration),
    )


def _record(
    profile: MotionProfile, link: DHLink
) -> ReportJointMotionProfile.RevoluteJointMotionProfileRec | ReportJointMotionProfile.PrismaticJointMotionProfileRec:
    values = (profile.speed, profile.acceleration, profile.deceleration)
    if link.is_revolute:
        return ReportJointMotionProfile.RevoluteJointMotionProfileRec(*values)
    return ReportJointMotionProfile.PrismaticJointMotionProfileRec(*values)


class ToolOffset(Service, urn="urn:jaus:jss:manipulator:ManipulatorToolOffsetService"):
    """The tool point in the last joint's frame, metres; at first that of the URDF."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def set_tool_offset(self, msg: SetToolOffset) -> None:
        """Use this point in the services of the end effector."""
        self._arm.tool = (msg.tool_point_coordinate_x, msg.tool_point_coordinate_y, msg.tool_point_coordinate_z)

    def report_tool_offset(self) -> ReportToolOffset:
        """The tool point."""
        return ReportToolOffset(*self._arm.tool)


_TYPES: Final = {
    JointKind.REVOLUTE: ReportJointDescription.JointType.REVOLUTE,
    JointKind.PRISMATIC: ReportJointDescription.JointType.PRISMATIC,
    JointKind.CONTINUOUS: ReportJointDescription.JointType.CONTINUOUS,
}


class JointDescription(Service, urn="urn:jauspy:description:JointDescription"):
    """The joints of the group `name` as the description of the robot (URDF) has them.

    `arm` has them in the convention of AS6057. AS6057 measures positions in DH frames, and does not report the zero of
    the description; this service of jauspy does, so that clients can use the values of the description.
    """

    def __init__(self, name: str, group: JointGroup, arm: Arm, width: FingerWidth | None = None) -> None:
        self._name, self._group, self._arm = name, group, arm
        self._width = width or FingerWidth(0.0)

    def report_joint_description(self) -> ReportJointDescription:
        """Radians, metres, newtons and newton metres."""
        tool = quaternion(tool_rotation(self._group, self._arm))
        group = ReportJointDescription.GroupRec(self._name[:255], *tool, self._width.at_zero)
        links = self._arm.geometry.links
        rows = zip(self._group.joints, links, strict=True)
        rates = self._width.rates
        return ReportJointDescription(
            group,
            [_description(joint, link.joint, link.zero_position, rates.get(joint.name, 0.0)) for joint, link in rows],
        )

    def report_blocked_joints(self) -> ReportBlockedJoints:
        """The joints that kept the last command to positions from being carried out; as of the description."""
        self._arm.notice_contact()  # also one at the end of the motion, when the command is done
        return ReportBlockedJoints(
            [
                ReportBlockedJoints.BlockedJointRec(blocked.joint.name[:255], blocked.effort, blocked.short)
                for blocked in self._arm.blocked
            ]
        )


def tool_rotation(group: JointGroup, arm: Arm) -> Rotation:
    """Turns directions in the group's tip link into those of the last joint's frame, as drivers to poses count it."""
    tip = Transform()
    for joint in group.chain:
        tip = tip @ joint_frame(joint, 0.0)
    zero = arm.geometry.from_urdf([0.0] * len(arm.geometry.links))
    return (arm.geometry.forward(zero).inverse() @ tip).rotation


def _description(joint: Joint, counted: Joint, zero: float, width_rate: float) -> ReportJointDescription.JointRec:
    directions = ReportJointDescription.Direction
    return ReportJointDescription.JointRec(
        joint_name=joint.name[:255],
        joint_type=_TYPES[joint.kind],
        direction=directions.SAME if counted.axis == joint.axis else directions.REVERSED,
        zero_position=zero,
        lower_limit=max(-REPORTED_ANGLES / 2.0, joint.lower),
        upper_limit=min(REPORTED_ANGLES / 2.0, joint.upper),
        max_speed=joint.velocity,
        max_effort=joint.effort,
        width_rate=width_rate,
    )
