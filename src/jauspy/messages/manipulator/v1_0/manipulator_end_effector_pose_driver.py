"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications


@jd.message(_SERVICE, 0x4604)
class ReportToolOffset(jd.Message):
    """ReportToolOffset (0x4604): Tells where the tool point is.

    tool_point_coordinate_x: -15..15 meter. Position of the tool point along X of the frame of the last joint, in metres
    tool_point_coordinate_y: -15..15 meter. Position of the tool point along Y of the frame of the last joint, in metres
    tool_point_coordinate_z: -15..15 meter. Position of the tool point along Z of the frame of the last joint, in metres
    """
    tool_point_coordinate_x: float = jd.field("ToolPointCoordinateX", jd.real("I", -15.0, 15.0, "meter"))
    tool_point_coordinate_y: float = jd.field("ToolPointCoordinateY", jd.real("I", -15.0, 15.0, "meter"))
    tool_point_coordinate_z: float = jd.field("ToolPointCoordinateZ", jd.real("I", -15.0, 15.0, "meter"))


@jd.message(_SERVICE, 0x2604, query=True)
class QueryToolOffset(jd.Message):
    """QueryToolOffset (0x2604): Asks where the tool point is."""
    REPORT = ReportToolOffset


@jd.message(_SERVICE, 0x0604, command=True)
class SetToolOffset(jd.Message):
    """SetToolOffset (0x0604): Sets where the tool point is.

    tool_point_coordinate_x: -15..15 meter. Position of the tool point along X of the frame of the last joint, in metres
    tool_point_coordinate_y: -15..15 meter. Position of the tool point along Y of the frame of the last joint, in metres
    tool_point_coordinate_z: -15..15 meter. Position of the tool point along Z of the frame of the last joint, in metres
    """
    tool_point_coordinate_x: float = jd.field("ToolPointCoordinateX", jd.real("I", -15.0, 15.0, "meter"))
    tool_point_coordinate_y: float = jd.field("ToolPointCoordinateY", jd.real("I", -15.0, 15.0, "meter"))
    tool_point_coordinate_z: float = jd.field("ToolPointCoordinateZ", jd.real("I", -15.0, 15.0, "meter"))


@jd.message(_SERVICE, 0x0610, command=True)
class SetEndEffectorPose(jd.Message):
    """SetEndEffectorPose (0x0610): Sets the pose to move the tool point to.

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


@jd.message(_SERVICE, 0x0607, command=True)
class SetMotionProfile(jd.Message):
    """SetMotionProfile (0x0607): Sets limits of speed and acceleration of each joint.

    motion_profile_list: 0..255 items. The joints, from the base
    """
    RevoluteMotionProfileRec = manipulator_v1_0_types.RevoluteMotionProfileRec
    PrismaticMotionProfileRec = manipulator_v1_0_types.PrismaticMotionProfileRec
    motion_profile_list: list[manipulator_v1_0_types.RevoluteMotionProfileRec | manipulator_v1_0_types.PrismaticMotionProfileRec] = jd.field("MotionProfileList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_motion_profile_rec=manipulator_v1_0_types.RevoluteMotionProfileRec, prismatic_motion_profile_rec=manipulator_v1_0_types.PrismaticMotionProfileRec)))


@jd.message(_SERVICE, 0x4610)
class ReportCommandedEndEffectorPose(jd.Message):
    """ReportCommandedEndEffectorPose (0x4610): Tells the commanded pose of the tool point.

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


@jd.message(_SERVICE, 0x2610, query=True)
class QueryCommandedEndEffectorPose(jd.Message):
    """QueryCommandedEndEffectorPose (0x2610): Asks for the commanded pose of the tool point."""
    REPORT = ReportCommandedEndEffectorPose


@jd.message(_SERVICE, 0x4607)
class ReportMotionProfile(jd.Message):
    """ReportMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint.

    motion_profile_list: 0..255 items. The joints, from the base
    """
    RevoluteMotionProfileRec = manipulator_v1_0_types.RevoluteMotionProfileRec
    PrismaticMotionProfileRec = manipulator_v1_0_types.PrismaticMotionProfileRec
    motion_profile_list: list[manipulator_v1_0_types.RevoluteMotionProfileRec | manipulator_v1_0_types.PrismaticMotionProfileRec] = jd.field("MotionProfileList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_motion_profile_rec=manipulator_v1_0_types.RevoluteMotionProfileRec, prismatic_motion_profile_rec=manipulator_v1_0_types.PrismaticMotionProfileRec)))


@jd.message(_SERVICE, 0x2607, query=True)
class QueryMotionProfile(jd.Message):
    """QueryMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""
    REPORT = ReportMotionProfile
