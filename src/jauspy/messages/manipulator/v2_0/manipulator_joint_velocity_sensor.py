"""urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor", "2.0")


@jd.message(_SERVICE, 0x4603)
class ReportJointVelocity(jd.Message):
    """ReportJointVelocity (0x4603): Tells the velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """
    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec
    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec] = jd.field("JointVelocityList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout()))


@jd.message(_SERVICE, 0x2603, query=True)
class QueryJointVelocity(jd.Message):
    """QueryJointVelocity (0x2603): Asks for the velocity of each joint."""
    REPORT = ReportJointVelocity
