"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver", "1.0")


@jd.message(_SERVICE, 0x061E, presence="B")
class ExecuteList(jd.Message):
    """ExecuteList (0x061E): Starts the list at an element, at a speed.

    element_uid: optional. The element to start with
    """
    element_uid: int | None = jd.field("ElementUID", jd.Number("H"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile): ...

@jd.derived(_SERVICE)
class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset): ...

@jd.derived(_SERVICE)
class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset): ...

@jd.derived(_SERVICE)
class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    REPORT = ReportToolOffset


@jd.message(_SERVICE, 0x461E)
class ReportActiveElement(jd.Message):
    """ReportActiveElement (0x461E): Tells which element of the list is being carried out.

    element_uid: The element being carried out; 0 when there is none
    """
    element_uid: int = jd.field("ElementUID", jd.Number("H"))


@jd.message(_SERVICE, 0x261E, query=True)
class QueryActiveElement(jd.Message):
    """QueryActiveElement (0x261E): Asks which element of the list is being carried out."""
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
class ReportCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportCommandedEndEffectorPose): ...

@jd.derived(_SERVICE)
class QueryCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryCommandedEndEffectorPose):
    REPORT = ReportCommandedEndEffectorPose
