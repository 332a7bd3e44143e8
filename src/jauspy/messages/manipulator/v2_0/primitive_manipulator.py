"""urn:jaus:jss:manipulator:PrimitiveManipulator 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitiveManipulator", "2.0")


@jd.message(_SERVICE, 0x4601)
class ReportJointEffort(jd.Message):
    """ReportJointEffort (0x4601): Tells the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """
    JointEffortRec = manipulator_v1_0_types.JointEffortRec
    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec] = jd.field("JointEffortList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout()))


@jd.message(_SERVICE, 0x2601, query=True)
class QueryJointEffort(jd.Message):
    """QueryJointEffort (0x2601): Asks for the effort of each joint."""
    REPORT = ReportJointEffort


@jd.message(_SERVICE, 0x0601, command=True)
class SetJointEffort(jd.Message):
    """SetJointEffort (0x0601): Sets the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """
    JointEffortRec = manipulator_v1_0_types.JointEffortRec
    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec] = jd.field("JointEffortList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout()))
