"""urn:jaus:jss:mobility:VelocityStateDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:VelocityStateDriver", "1.0")


@jd.message(_SERVICE, 0x0415, presence="B", command=True)
class SetVelocityCommand(jd.Message):
    """SetVelocityCommand (0x0415): Sets the wanted velocity, its default, or one of its limits.

    command_type: CommandType. Whether this is the wanted velocity, its default, or a limit
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    class CommandType(IntEnum):
        SET_CURRENT_COMMAND = 0
        SET_MAX_ALLOWED = 1
        SET_MIN_ALLOWED = 2
        SET_DEFAULT_COMMAND = 3

    command_type: SetVelocityCommand.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(SetVelocityCommand.CommandType)))
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x0416, presence="B", command=True)
class SetAccelerationLimit(jd.Message):
    """SetAccelerationLimit (0x0416): Sets the limits of acceleration or deceleration.

    command_type: CommandType. Whether speeding up or slowing down is limited
    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Limit along X, in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Limit along Y, in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Limit along Z, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Z, in radians per second squared
    """

    class CommandType(IntEnum):
        SET_MAX_ALLOWED = 1
        SET_MIN_ALLOWED = 2

    command_type: SetAccelerationLimit.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(SetAccelerationLimit.CommandType)))
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4415, presence="B")
class ReportVelocityCommand(jd.Message):
    """ReportVelocityCommand (0x4415): Tells the wanted velocity, its default, or one of its limits.

    command_type: CommandType. Whether this is the wanted velocity, its default, or a limit
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    class CommandType(IntEnum):
        SET_CURRENT_COMMAND = 0
        SET_MAX_ALLOWED = 1
        SET_MIN_ALLOWED = 2
        SET_DEFAULT_COMMAND = 3

    command_type: ReportVelocityCommand.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(ReportVelocityCommand.CommandType)))
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2415, query=True)
class QueryVelocityCommand(jd.Message):
    """QueryVelocityCommand (0x2415): Asks for the wanted velocity, its default, or one of its limits.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    command_type: Which velocity is asked for; as in the report
    """
    REPORT = ReportVelocityCommand
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))
    command_type: int = jd.field("CommandType", jd.Number("B"))


@jd.message(_SERVICE, 0x4416, presence="B")
class ReportAccelerationLimit(jd.Message):
    """ReportAccelerationLimit (0x4416): Tells the limits of acceleration or deceleration.

    command_type: CommandType. Whether speeding up or slowing down is limited
    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Limit along X, in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Limit along Y, in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Limit along Z, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Z, in radians per second squared
    """

    class CommandType(IntEnum):
        SET_MAX_ALLOWED = 1
        SET_MIN_ALLOWED = 2

    command_type: ReportAccelerationLimit.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(ReportAccelerationLimit.CommandType)))
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2416, query=True)
class QueryAccelerationLimit(jd.Message):
    """QueryAccelerationLimit (0x2416): Asks for the limits of acceleration or deceleration.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    command_type: Which limit is asked for; as in the report
    """
    REPORT = ReportAccelerationLimit
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))
    command_type: int = jd.field("CommandType", jd.Number("B"))
