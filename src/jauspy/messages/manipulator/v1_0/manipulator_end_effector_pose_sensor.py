"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications

@jd.derived(_SERVICE)
class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset): ...

@jd.derived(_SERVICE)
class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    REPORT = ReportToolOffset

@jd.derived(_SERVICE)
class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset): ...


@jd.message(_SERVICE, 0x4615)
class ReportEndEffectorPose(jd.Message):
    """ReportEndEffectorPose (0x4615): Tells the pose of the tool point.

    tool_point_coordinate_x: -30..30 meter. Position of the tool point along X, in metres
    tool_point_coordinate_y: -30..30 meter. Position of the tool point along Y, in metres
    tool_point_coordinate_z: -30..30 meter. Position of the tool point along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """
    tool_point_coordinate_x: float = jd.field("ToolPointCoordinateX", jd.real("I", -30.0, 30.0, "meter"))
    tool_point_coordinate_y: float = jd.field("ToolPointCoordinateY", jd.real("I", -30.0, 30.0, "meter"))
    tool_point_coordinate_z: float = jd.field("ToolPointCoordinateZ", jd.real("I", -30.0, 30.0, "meter"))
    d_component_of_unit_quaternion_q: float = jd.field("DComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    a_component_of_unit_quaternion_q: float = jd.field("AComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    b_component_of_unit_quaternion_q: float = jd.field("BComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    c_component_of_unit_quaternion_q: float = jd.field("CComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))


@jd.message(_SERVICE, 0x2615, query=True)
class QueryEndEffectorPose(jd.Message):
    """QueryEndEffectorPose (0x2615): Asks for the pose of the tool point."""
    REPORT = ReportEndEffectorPose
