"""urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_list_driver as manipulator_v1_0_manipulator_end_effector_pose_list_driver
from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_driver as manipulator_v1_0_manipulator_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver", "1.0")

@jd.derived(_SERVICE)
class ExecuteList(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile): ...

@jd.derived(_SERVICE)
class ReportActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.QueryActiveElement):
    REPORT = ReportActiveElement

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications

@jd.derived(_SERVICE)
class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile): ...

@jd.derived(_SERVICE)
class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    REPORT = ReportMotionProfile

@jd.derived(_SERVICE)
class ReportCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.ReportCommandedJointPositions): ...

@jd.derived(_SERVICE)
class QueryCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.QueryCommandedJointPositions):
    REPORT = ReportCommandedJointPositions
