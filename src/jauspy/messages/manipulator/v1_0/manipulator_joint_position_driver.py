"""urn:jaus:jss:manipulator:ManipulatorJointPositionDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointPositionDriver", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications


@jd.message(_SERVICE, 0x4608)
class ReportCommandedJointPositions(jd.Message):
    """ReportCommandedJointPositions (0x4608): Tells the commanded position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """
    JointPositionRec = manipulator_v1_0_types.JointPositionRec
    joint_position_list: list[manipulator_v1_0_types.JointPositionRec] = jd.field("JointPositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointPositionRec.layout()))


@jd.message(_SERVICE, 0x2608, query=True)
class QueryCommandedJointPositions(jd.Message):
    """QueryCommandedJointPositions (0x2608): Asks for the commanded position of each joint."""
    REPORT = ReportCommandedJointPositions

@jd.derived(_SERVICE)
class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile): ...

@jd.derived(_SERVICE)
class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    REPORT = ReportMotionProfile


@jd.message(_SERVICE, 0x0602, command=True)
class SetJointPositions(jd.Message):
    """SetJointPositions (0x0602): Sets the position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """
    JointPositionRec = manipulator_v1_0_types.JointPositionRec
    joint_position_list: list[manipulator_v1_0_types.JointPositionRec] = jd.field("JointPositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointPositionRec.layout()))

@jd.derived(_SERVICE)
class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile): ...
