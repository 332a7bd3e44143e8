"""urn:jaus:jss:manipulator:PanTiltJointPositionDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointPositionDriver", "1.0")


@jd.message(_SERVICE, 0x4620, presence="B", kw_only=True)
class ReportPanTiltSpecifications(jd.Message):
    """ReportPanTiltSpecifications (0x4620): Tells mounting and limits of the pan-tilt unit.

    pan_tilt_coordinate_sys_x: -30..30 meter, optional. Position of the unit on the vehicle along X, in metres
    pan_tilt_coordinate_sys_y: -30..30 meter, optional. Position of the unit on the vehicle along Y, in metres
    pan_tilt_coordinate_sys_z: -30..30 meter, optional. Position of the unit on the vehicle along Z, in metres
    d_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of k
    joint1_min_value: -25.1327412287..25.1327412287 radian. Smallest position of the pan joint, in radians
    joint1_max_value: -25.1327412287..25.1327412287 radian. Largest position of the pan joint, in radians
    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint2_min_value: -25.1327412287..25.1327412287 radian. Smallest position of the tilt joint, in radians
    joint2_max_value: -25.1327412287..25.1327412287 radian. Largest position of the tilt joint, in radians
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    """
    pan_tilt_coordinate_sys_x: float | None = jd.field("PanTiltCoordinateSysX", jd.real("I", -30.0, 30.0, "meter"), default=None)
    pan_tilt_coordinate_sys_y: float | None = jd.field("PanTiltCoordinateSysY", jd.real("I", -30.0, 30.0, "meter"), default=None)
    pan_tilt_coordinate_sys_z: float | None = jd.field("PanTiltCoordinateSysZ", jd.real("I", -30.0, 30.0, "meter"), default=None)
    d_component_of_unit_quaternion_q: float | None = jd.field("DComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0), default=None)
    a_component_of_unit_quaternion_q: float | None = jd.field("AComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0), default=None)
    b_component_of_unit_quaternion_q: float | None = jd.field("BComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0), default=None)
    c_component_of_unit_quaternion_q: float | None = jd.field("CComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0), default=None)
    joint1_min_value: float = jd.field("Joint1MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint1_max_value: float = jd.field("Joint1MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint1_max_speed: float = jd.field("Joint1MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint2_min_value: float = jd.field("Joint2MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_max_value: float = jd.field("Joint2MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_max_speed: float = jd.field("Joint2MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2620, query=True)
class QueryPanTiltSpecifications(jd.Message):
    """QueryPanTiltSpecifications (0x2620): Asks for mounting and limits of the pan-tilt unit.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportPanTiltSpecifications
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x7F)


@jd.message(_SERVICE, 0x4628)
class ReportCommandedPanTiltJointPositions(jd.Message):
    """ReportCommandedPanTiltJointPositions (0x4628): Tells the commanded angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """
    joint1_position: float = jd.field("Joint1Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_position: float = jd.field("Joint2Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))


@jd.message(_SERVICE, 0x2628, query=True)
class QueryCommandedPanTiltJointPositions(jd.Message):
    """QueryCommandedPanTiltJointPositions (0x2628): Asks for the commanded angles."""
    REPORT = ReportCommandedPanTiltJointPositions


@jd.message(_SERVICE, 0x4627)
class ReportPanTiltMotionProfile(jd.Message):
    """ReportPanTiltMotionProfile (0x4627): Tells the limits of speed and acceleration.

    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint1_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the pan joint, in radians per second squared
    joint1_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the pan joint, in radians per second squared
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    joint2_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the tilt joint, in radians per second squared
    joint2_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the tilt joint, in radians per second squared
    """
    joint1_max_speed: float = jd.field("Joint1MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint1_max_acceleration_rate: float = jd.field("Joint1MaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint1_max_deceleration_rate: float = jd.field("Joint1MaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint2_max_speed: float = jd.field("Joint2MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint2_max_acceleration_rate: float = jd.field("Joint2MaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint2_max_deceleration_rate: float = jd.field("Joint2MaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))


@jd.message(_SERVICE, 0x2627, query=True)
class QueryPanTiltMotionProfile(jd.Message):
    """QueryPanTiltMotionProfile (0x2627): Asks for the limits of speed and acceleration."""
    REPORT = ReportPanTiltMotionProfile


@jd.message(_SERVICE, 0x0622, command=True)
class SetPanTiltJointPositions(jd.Message):
    """SetPanTiltJointPositions (0x0622): Sets the angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """
    joint1_position: float = jd.field("Joint1Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_position: float = jd.field("Joint2Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))


@jd.message(_SERVICE, 0x0627, command=True)
class SetPanTiltMotionProfile(jd.Message):
    """SetPanTiltMotionProfile (0x0627): Sets limits of speed and acceleration.

    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint1_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the pan joint, in radians per second squared
    joint1_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the pan joint, in radians per second squared
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    joint2_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the tilt joint, in radians per second squared
    joint2_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the tilt joint, in radians per second squared
    """
    joint1_max_speed: float = jd.field("Joint1MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint1_max_acceleration_rate: float = jd.field("Joint1MaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint1_max_deceleration_rate: float = jd.field("Joint1MaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint2_max_speed: float = jd.field("Joint2MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
    joint2_max_acceleration_rate: float = jd.field("Joint2MaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
    joint2_max_deceleration_rate: float = jd.field("Joint2MaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
