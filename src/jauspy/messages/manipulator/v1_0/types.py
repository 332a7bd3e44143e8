"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd


@jd.record()
class EndEffectorPoseRec(jd.Struct):
    """tool_point_coordinate_x: -30..30 meter. Position of the tool point along X, in metres
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


@jd.record()
class PanTiltJointPositionRec(jd.Struct):
    """joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """
    joint1_position: float = jd.field("Joint1Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_position: float = jd.field("Joint2Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))


@jd.record()
class ActuatorForceTorqueRec(jd.Struct):
    """joint_force_torque: Torque of a revolute or force of a prismatic joint"""

    class JointForceTorqueChoice(IntEnum):
        NEWTON_METER = 1
        NEWTON = 2

    @jd.variable(lambda cls: jd.Choice(cls, {1: jd.real("I", -1000.0, 1000.0, "newton meter"), 2: jd.real("I", -500.0, 500.0, "newton")}, jd.Values(ActuatorForceTorqueRec.JointForceTorqueChoice)))
    class JointForceTorque(jd.Struct):
        """Torque of a revolute or force of a prismatic joint.

        1: newton meter, -1000..1000 newton meter
        2: newton, -500..500 newton
        """
        choice: ActuatorForceTorqueRec.JointForceTorqueChoice | int
        value: float

    joint_force_torque: ActuatorForceTorqueRec.JointForceTorque = jd.field("JointForceTorque", lambda: ActuatorForceTorqueRec.JointForceTorque.layout())


@jd.record()
class ManipulatorCoordinateSystemRec(jd.Struct):
    """manipulator_coordinate_sys_x: -30..30 meter. Position of the base on the vehicle along X, in metres
    manipulator_coordinate_sys_y: -30..30 meter. Position of the base on the vehicle along Y, in metres
    manipulator_coordinate_sys_z: -30..30 meter. Position of the base on the vehicle along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """
    manipulator_coordinate_sys_x: float = jd.field("ManipulatorCoordinateSysX", jd.real("I", -30.0, 30.0, "meter"))
    manipulator_coordinate_sys_y: float = jd.field("ManipulatorCoordinateSysY", jd.real("I", -30.0, 30.0, "meter"))
    manipulator_coordinate_sys_z: float = jd.field("ManipulatorCoordinateSysZ", jd.real("I", -30.0, 30.0, "meter"))
    d_component_of_unit_quaternion_q: float = jd.field("DComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    a_component_of_unit_quaternion_q: float = jd.field("AComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    b_component_of_unit_quaternion_q: float = jd.field("BComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
    c_component_of_unit_quaternion_q: float = jd.field("CComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))


@jd.record("B")
class RevoluteJoint1OffsetRec(jd.Struct):
    """joint1_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
    joint1_min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
    joint1_max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
    joint1_max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
    joint1_max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
    """
    joint1_offset: float = jd.field("Joint1Offset", jd.real("H", -10.0, 10.0, "meter"))
    joint1_min_value: float | None = jd.field("Joint1MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
    joint1_max_value: float | None = jd.field("Joint1MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
    joint1_max_speed: float | None = jd.field("Joint1MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"), default=None)
    joint1_max_torque: float | None = jd.field("Joint1MaxTorque", jd.real("I", 0.0, 5000.0, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.record("B")
class PrismaticJoint1AngleRec(jd.Struct):
    """joint1_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
    joint1_min_value: -10..10 meter. Smallest position, in metres
    joint1_max_value: -10..10 meter. Largest position, in metres
    joint1_max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
    joint1_max_force: 0..5000 newton, optional. Largest force, in newtons
    """
    joint1_angle: float = jd.field("Joint1Angle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    joint1_min_value: float = jd.field("Joint1MinValue", jd.real("I", -10.0, 10.0, "meter"))
    joint1_max_value: float = jd.field("Joint1MaxValue", jd.real("I", -10.0, 10.0, "meter"))
    joint1_max_speed: float | None = jd.field("Joint1MaxSpeed", jd.real("I", -5.0, 5.0, "meter per second"), default=None)
    joint1_max_force: float | None = jd.field("Joint1MaxForce", jd.real("I", 0.0, 5000.0, "newton"), default=None)
    reserved_presence: int = 0


@jd.record("B")
class RevoluteJointSpecificationRec(jd.Struct):
    """link_length: -10..10 meter. Distance to the axis of the joint before, in metres
    twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
    joint_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
    min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
    max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
    max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
    max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
    """
    link_length: float = jd.field("LinkLength", jd.real("H", -10.0, 10.0, "meter"))
    twist_angle: float = jd.field("TwistAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    joint_offset: float = jd.field("JointOffset", jd.real("H", -10.0, 10.0, "meter"))
    min_value: float | None = jd.field("MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
    max_value: float | None = jd.field("MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
    max_speed: float | None = jd.field("MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"), default=None)
    max_torque: float | None = jd.field("MaxTorque", jd.real("I", 0.0, 5000.0, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.record("B")
class PrismaticJointSpecificationRec(jd.Struct):
    """link_length: -10..10 meter. Distance to the axis of the joint before, in metres
    twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
    joint_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
    min_value: -10..10 meter. Smallest position, in metres
    max_value: -10..10 meter. Largest position, in metres
    max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
    max_force: 0..5000 newton, optional. Largest force, in newtons
    """
    link_length: float = jd.field("LinkLength", jd.real("H", -10.0, 10.0, "meter"))
    twist_angle: float = jd.field("TwistAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    joint_angle: float = jd.field("JointAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    min_value: float = jd.field("MinValue", jd.real("I", -10.0, 10.0, "meter"))
    max_value: float = jd.field("MaxValue", jd.real("I", -10.0, 10.0, "meter"))
    max_speed: float | None = jd.field("MaxSpeed", jd.real("I", -5.0, 5.0, "meter per second"), default=None)
    max_force: float | None = jd.field("MaxForce", jd.real("I", 0.0, 5000.0, "newton"), default=None)
    reserved_presence: int = 0


@jd.record()
class RevoluteMotionProfileRec(jd.Struct):
    """joint_max_speed: 0..31.4159265359 radian per second. Largest speed, in radians per second
    joint_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration, in radians per second squared
    joint_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration, in radians per second squared
    """
    joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))


@jd.record()
class PrismaticMotionProfileRec(jd.Struct):
    """joint_max_speed: 0..5 meter per second. Largest speed, in metres per second
    joint_max_acceleration_rate: 0..20 meter per second squared. Largest acceleration, in metres per second squared
    joint_max_deceleration_rate: 0..20 meter per second squared. Largest deceleration, in metres per second squared
    """
    joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 5.0, "meter per second"))
    joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))
    joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))


@jd.record()
class JointPositionRec(jd.Struct):
    """joint_position: Angle of a revolute or travel of a prismatic joint"""

    class JointPositionChoice(IntEnum):
        RADIAN = 1
        METER = 2

    @jd.variable(lambda cls: jd.Choice(cls, {1: jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), 2: jd.real("I", -10.0, 10.0, "meter")}, jd.Values(JointPositionRec.JointPositionChoice)))
    class JointPosition(jd.Struct):
        """Angle of a revolute or travel of a prismatic joint.

        1: radian, -25.1327412287..25.1327412287 radian
        2: meter, -10..10 meter
        """
        choice: JointPositionRec.JointPositionChoice | int
        value: float

    joint_position: JointPositionRec.JointPosition = jd.field("JointPosition", lambda: JointPositionRec.JointPosition.layout())


@jd.record()
class JointVelocityRec(jd.Struct):
    """joint_velocity: Velocity of a revolute or prismatic joint"""

    class JointVelocityChoice(IntEnum):
        RADIAN_PER_SECOND = 1
        METER_PER_SECOND = 2

    @jd.variable(lambda cls: jd.Choice(cls, {1: jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"), 2: jd.real("I", -5.0, 5.0, "meter per second")}, jd.Values(JointVelocityRec.JointVelocityChoice)))
    class JointVelocity(jd.Struct):
        """Velocity of a revolute or prismatic joint.

        1: radian per second, -31.4159265359..31.4159265359 radian per second
        2: meter per second, -5..5 meter per second
        """
        choice: JointVelocityRec.JointVelocityChoice | int
        value: float

    joint_velocity: JointVelocityRec.JointVelocity = jd.field("JointVelocity", lambda: JointVelocityRec.JointVelocity.layout())


@jd.record()
class JointEffortRec(jd.Struct):
    """joint_effort: -100..100. Effort, in percent of the maximum"""
    joint_effort: float = jd.field("JointEffort", jd.real("H", -100.0, 100.0))
