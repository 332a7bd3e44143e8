"""urn:jauspy:cell:ServoModule 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:ServoModule", "1.0")


@jd.message(_SERVICE, 0xDA60, presence="B", command=True)
class SetServoTarget(jd.Message):
    """SetServoTarget (0xDA60): Follows a position, velocity or torque until the next target.

    mode: Mode. What the value is
    value: Position in radians, velocity in radians per second, or torque in newton metres
    feed_forward: in newton meter, optional. Torque that is added to that of the controller, in newton metres; zero when left out
    """

    class Mode(IntEnum):
        POSITION_MODE = 0
        VELOCITY_MODE = 1
        EFFORT_MODE = 2

    mode: SetServoTarget.Mode | int = jd.field("Mode", lambda: jd.Number("B", jd.Values(SetServoTarget.Mode)))
    value: float = jd.field("Value", jd.Number("d"))
    feed_forward: float | None = jd.field("FeedForward", jd.Number("f", jd.ANY, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xDA61, presence="B", command=True, kw_only=True)
class SetServoGains(jd.Message):
    """SetServoGains (0xDA61): Sets the gains of the position and velocity controllers.

    position_p: Torque per error, in newton metres per radian
    position_i: Torque per integrated error, in newton metres per radian and second
    position_d: Torque per rate of change of the error, in newton metre seconds per radian
    position_i_limit: in newton meter, optional. Limit of the integral part, in newton metres; none when left out
    velocity_p: Torque per error, in newton metres per rad/s
    velocity_i: Torque per integrated error, in newton metres per rad/s and second
    velocity_d: Torque per rate of change of the error, in newton metre seconds per rad/s
    velocity_i_limit: in newton meter, optional. Limit of the integral part, in newton metres; none when left out
    """
    position_p: float = jd.field("PositionP", jd.Number("f"))
    position_i: float = jd.field("PositionI", jd.Number("f"))
    position_d: float = jd.field("PositionD", jd.Number("f"))
    position_i_limit: float | None = jd.field("PositionILimit", jd.Number("f", jd.ANY, "newton meter"), default=None)
    velocity_p: float = jd.field("VelocityP", jd.Number("f"))
    velocity_i: float = jd.field("VelocityI", jd.Number("f"))
    velocity_d: float = jd.field("VelocityD", jd.Number("f"))
    velocity_i_limit: float | None = jd.field("VelocityILimit", jd.Number("f", jd.ANY, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xFA60, presence="I")
class ReportServoState(jd.Message):
    """ReportServoState (0xFA60): Tells what the module measures.

    position: in radian, optional. Position of the output, of any number of turns, in radians
    velocity: in radian per second, optional. Velocity of the output, in radians per second
    torque: in newton meter, optional. Torque at the output, measured by the spring, in newton metres
    current: in ampere, optional. Current of the motor, in amperes
    temperature: in degree Celsius, optional. Temperature of the windings, in degrees Celsius
    voltage: in volt, optional. Voltage of the supply, in volts
    orientation_w: optional. W of the unit quaternion from the frame of the part to that of the world, z up
    orientation_x: optional. X of the unit quaternion from the frame of the part to that of the world, z up
    orientation_y: optional. Y of the unit quaternion from the frame of the part to that of the world, z up
    orientation_z: optional. Z of the unit quaternion from the frame of the part to that of the world, z up
    angular_velocity_x: in radian per second, optional. Angular velocity of the housing about X of its own frame, in radians per second
    angular_velocity_y: in radian per second, optional. Angular velocity of the housing about Y of its own frame, in radians per second
    angular_velocity_z: in radian per second, optional. Angular velocity of the housing about Z of its own frame, in radians per second
    acceleration_x: in meter per second squared, optional. Specific force along X of the housing's own frame, in m/s^2; at rest 9.81 upward
    acceleration_y: in meter per second squared, optional. Specific force along Y of the housing's own frame, in m/s^2; at rest 9.81 upward
    acceleration_z: in meter per second squared, optional. Specific force along Z of the housing's own frame, in m/s^2; at rest 9.81 upward
    claimed_by: up to 255 characters, optional. Name of the modular arm or car that moves the module; empty when clients may
    """
    position: float | None = jd.field("Position", jd.Number("d", jd.ANY, "radian"), default=None)
    velocity: float | None = jd.field("Velocity", jd.Number("f", jd.ANY, "radian per second"), default=None)
    torque: float | None = jd.field("Torque", jd.Number("f", jd.ANY, "newton meter"), default=None)
    current: float | None = jd.field("Current", jd.Number("f", jd.ANY, "ampere"), default=None)
    temperature: float | None = jd.field("Temperature", jd.Number("f", jd.ANY, "degree Celsius"), default=None)
    voltage: float | None = jd.field("Voltage", jd.Number("f", jd.ANY, "volt"), default=None)
    orientation_w: float | None = jd.field("OrientationW", jd.Number("f"), default=None)
    orientation_x: float | None = jd.field("OrientationX", jd.Number("f"), default=None)
    orientation_y: float | None = jd.field("OrientationY", jd.Number("f"), default=None)
    orientation_z: float | None = jd.field("OrientationZ", jd.Number("f"), default=None)
    angular_velocity_x: float | None = jd.field("AngularVelocityX", jd.Number("f", jd.ANY, "radian per second"), default=None)
    angular_velocity_y: float | None = jd.field("AngularVelocityY", jd.Number("f", jd.ANY, "radian per second"), default=None)
    angular_velocity_z: float | None = jd.field("AngularVelocityZ", jd.Number("f", jd.ANY, "radian per second"), default=None)
    acceleration_x: float | None = jd.field("AccelerationX", jd.Number("f", jd.ANY, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("AccelerationY", jd.Number("f", jd.ANY, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("AccelerationZ", jd.Number("f", jd.ANY, "meter per second squared"), default=None)
    claimed_by: str | None = jd.field("ClaimedBy", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xEA60, query=True)
class QueryServoState(jd.Message):
    """QueryServoState (0xEA60): Asks for what the module measures.

    presence_vector: Which fields the report is to have, by bit
    """
    REPORT = ReportServoState
    presence_vector: int = jd.field("PresenceVector", jd.Number("I"), default=0x1FFFF)


@jd.message(_SERVICE, 0xFA61, presence="B", kw_only=True)
class ReportServoGains(jd.Message):
    """ReportServoGains (0xFA61): Tells the gains of the position and velocity controllers.

    position_p: Torque per error, in newton metres per radian
    position_i: Torque per integrated error, in newton metres per radian and second
    position_d: Torque per rate of change of the error, in newton metre seconds per radian
    position_i_limit: in newton meter, optional. Limit of the integral part, in newton metres; none when left out
    velocity_p: Torque per error, in newton metres per rad/s
    velocity_i: Torque per integrated error, in newton metres per rad/s and second
    velocity_d: Torque per rate of change of the error, in newton metre seconds per rad/s
    velocity_i_limit: in newton meter, optional. Limit of the integral part, in newton metres; none when left out
    """
    position_p: float = jd.field("PositionP", jd.Number("f"))
    position_i: float = jd.field("PositionI", jd.Number("f"))
    position_d: float = jd.field("PositionD", jd.Number("f"))
    position_i_limit: float | None = jd.field("PositionILimit", jd.Number("f", jd.ANY, "newton meter"), default=None)
    velocity_p: float = jd.field("VelocityP", jd.Number("f"))
    velocity_i: float = jd.field("VelocityI", jd.Number("f"))
    velocity_d: float = jd.field("VelocityD", jd.Number("f"))
    velocity_i_limit: float | None = jd.field("VelocityILimit", jd.Number("f", jd.ANY, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xEA61, query=True)
class QueryServoGains(jd.Message):
    """QueryServoGains (0xEA61): Asks for the gains."""
    REPORT = ReportServoGains


@jd.message(_SERVICE, 0xFA62)
class ReportServoSpecification(jd.Message):
    """ReportServoSpecification (0xFA62): Tells name, type and limits.

    name: up to 255 characters. Name of the part
    type: up to 255 characters. Type of the part
    max_torque: in newton meter. Largest torque at the output, in newton metres
    max_speed: in radian per second. Largest speed of the output, in radians per second
    stiffness: Of the spring between gear and output, in newton metres per radian
    torque_constant: Torque at the output per current, in newton metres per ampere
    """
    name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
    type: str = jd.field("Type", jd.Text(count=jd.Count("B", 0, 255)))
    max_torque: float = jd.field("MaxTorque", jd.Number("f", jd.ANY, "newton meter"))
    max_speed: float = jd.field("MaxSpeed", jd.Number("f", jd.ANY, "radian per second"))
    stiffness: float = jd.field("Stiffness", jd.Number("f"))
    torque_constant: float = jd.field("TorqueConstant", jd.Number("f"))


@jd.message(_SERVICE, 0xEA62, query=True)
class QueryServoSpecification(jd.Message):
    """QueryServoSpecification (0xEA62): Asks for name, type and limits."""
    REPORT = ReportServoSpecification
