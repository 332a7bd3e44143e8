"""urn:jaus:jss:manipulator:ManipulatorJointPositionSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointPositionSensor", "1.0")


@jd.message(_SERVICE, 0x4602)
class ReportJointPositions(jd.Message):
    """ReportJointPositions (0x4602): Tells the position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """
    JointPositionRec = manipulator_v1_0_types.JointPositionRec
    joint_position_list: list[manipulator_v1_0_types.JointPositionRec] = jd.field("JointPositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointPositionRec.layout()))


@jd.message(_SERVICE, 0x2602, query=True)
class QueryJointPositions(jd.Message):
    """QueryJointPositions (0x2602): Asks for the position of each joint."""
    REPORT = ReportJointPositions

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications
