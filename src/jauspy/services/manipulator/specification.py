"""ManipulatorSpecificationService: the manipulator's geometry and limits, out of its description (AS6057)."""

from __future__ import annotations

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.messages.manipulator import ManipulatorCoordinateSystemRec, ReportManipulatorSpecifications
from jauspy.services.manipulator.arm import Arm
from jauspy.services.service import Service


class ManipulatorSpecification(Service, urn="urn:jaus:jss:manipulator:ManipulatorSpecificationService"):
    """Lengths in metres, angles in radians; positions count from the axes of `denavit_hartenberg`."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_manipulator_specifications(self) -> ReportManipulatorSpecifications:
        """The coordinate system is in the vehicle's frame: x forward, y right, z down."""
        first, *others = self._arm.geometry.links
        names = [ReportManipulatorSpecifications.JointNameRec(link.joint.name[:255]) for link in (first, *others)]
        return ReportManipulatorSpecifications(
            manipulator_coordinate_system_rec=coordinate_system(self._arm.geometry.base),
            first_joint_parameters=_first_revolute(first) if first.is_revolute else _first_prismatic(first),
            joint_specification_list=[_revolute(link) if link.is_revolute else _prismatic(link) for link in others],
            joint_names_list=names,
        )


def coordinate_system(base: Transform) -> ManipulatorCoordinateSystemRec:
    """Where the manipulator stands on the vehicle."""
    frame = JAUS_FROM_REP_103 @ base
    return ManipulatorCoordinateSystemRec(*frame.position, *quaternion(frame.rotation))


def _first_revolute(link: DHLink) -> ReportManipulatorSpecifications.RevoluteJoint1OffsetRec:
    joint = link.joint
    return ReportManipulatorSpecifications.RevoluteJoint1OffsetRec(
        link.offset, joint.lower + link.zero_position, joint.upper + link.zero_position, joint.velocity, joint.effort
    )


def _first_prismatic(link: DHLink) -> ReportManipulatorSpecifications.PrismaticJoint1AngleRec:
    joint = link.joint
    return ReportManipulatorSpecifications.PrismaticJoint1AngleRec(
        link.angle, joint.lower + link.zero_position, joint.upper + link.zero_position, joint.velocity, joint.effort
    )


def _revolute(link: DHLink) -> ReportManipulatorSpecifications.RevoluteJointSpecificationRec:
    joint = link.joint
    return ReportManipulatorSpecifications.RevoluteJointSpecificationRec(
        link.length,
        link.twist,
        link.offset,
        joint.lower + link.zero_position,
        joint.upper + link.zero_position,
        joint.velocity,
        joint.effort,
    )


def _prismatic(link: DHLink) -> ReportManipulatorSpecifications.PrismaticJointSpecificationRec:
    joint = link.joint
    return ReportManipulatorSpecifications.PrismaticJointSpecificationRec(
        link.length,
        link.twist,
        link.angle,
        joint.lower + link.zero_position,
        joint.upper + link.zero_position,
        joint.velocity,
        joint.effort,
    )
