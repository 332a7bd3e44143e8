"""urn:jaus:jss:manipulator:PrimitiveManipulator 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitiveManipulator", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications


@jd.message(_SERVICE, 0x4601)
class ReportJointEfforts(jd.Message):
    """ReportJointEfforts (0x4601): Tells the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """
    JointEffortRec = manipulator_v1_0_types.JointEffortRec
    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec] = jd.field("JointEffortList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout()))


@jd.message(_SERVICE, 0x2601, query=True)
class QueryJointEfforts(jd.Message):
    """QueryJointEfforts (0x2601): Asks for the effort of each joint."""
    REPORT = ReportJointEfforts


@jd.message(_SERVICE, 0x0601, command=True)
class SetJointEfforts(jd.Message):
    """SetJointEfforts (0x0601): Sets the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """
    JointEffortRec = manipulator_v1_0_types.JointEffortRec
    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec] = jd.field("JointEffortList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout()))
