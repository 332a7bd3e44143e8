"""urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver", "2.0")


@jd.message(_SERVICE, 0x0603, command=True)
class SetJointVelocity(jd.Message):
    """SetJointVelocity (0x0603): Sets the velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """
    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec
    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec] = jd.field("JointVelocityList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout()))


@jd.message(_SERVICE, 0x4611)
class ReportCommandedJointVelocity(jd.Message):
    """ReportCommandedJointVelocity (0x4611): Tells the commanded velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """
    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec
    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec] = jd.field("JointVelocityList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout()))


@jd.message(_SERVICE, 0x2611, query=True)
class QueryCommandedJointVelocity(jd.Message):
    """QueryCommandedJointVelocity (0x2611): Asks for the commanded velocity of each joint."""
    REPORT = ReportCommandedJointVelocity
