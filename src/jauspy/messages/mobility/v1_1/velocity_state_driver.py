"""urn:jaus:jss:mobility:VelocityStateDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import velocity_state_driver as mobility_v1_0_velocity_state_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:VelocityStateDriver", "1.1")

@jd.derived(_SERVICE)
class SetVelocityCommand(mobility_v1_0_velocity_state_driver.SetVelocityCommand): ...


@jd.message(_SERVICE, 0x04B5, presence="B", command=True)
class SetVelocityCommandExt(jd.Message):
    """SetVelocityCommandExt (0x04B5): As SetVelocityCommand, with a choice between speed over ground and through the medium.

    command_type: CommandType. The wanted velocity, its default, or a limit; over ground (SOG) or through the medium (SRM)
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    class CommandType(IntEnum):
        SET_COMMAND_SOG = 0
        SET_MAX_SOG = 1
        SET_MIN_SOG = 2
        SET_DEFAULT_SOG = 3
        SET_COMMAND_SRM = 4
        SET_MAX_SRM = 5
        SET_MIN_SRM = 6
        SET_DEFAULT_SRM = 7

    command_type: SetVelocityCommandExt.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(SetVelocityCommandExt.CommandType)))
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
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
        MAX_ACCELERATION = 1
        MAX_DECELERATION = 2

    command_type: SetAccelerationLimit.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(SetAccelerationLimit.CommandType)))
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportVelocityCommand(mobility_v1_0_velocity_state_driver.ReportVelocityCommand): ...

@jd.derived(_SERVICE)
class QueryVelocityCommand(mobility_v1_0_velocity_state_driver.QueryVelocityCommand):
    REPORT = ReportVelocityCommand


@jd.message(_SERVICE, 0x44B5, presence="B")
class ReportVelocityCommandExt(jd.Message):
    """ReportVelocityCommandExt (0x44B5): As ReportVelocityCommand, for speed over ground or through the medium.

    command_type: CommandType. The wanted velocity, its default, or a limit; over ground (SOG) or through the medium (SRM)
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    class CommandType(IntEnum):
        SET_COMMAND_SOG = 0
        SET_MAX_SOG = 1
        SET_MIN_SOG = 2
        SET_DEFAULT_SOG = 3
        SET_COMMAND_SRM = 4
        SET_MAX_SRM = 5
        SET_MIN_SRM = 6
        SET_DEFAULT_SRM = 7

    command_type: ReportVelocityCommandExt.CommandType | int = jd.field("CommandType", lambda: jd.Number("B", jd.Values(ReportVelocityCommandExt.CommandType)))
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24B5, query=True)
class QueryVelocityCommandExt(jd.Message):
    """QueryVelocityCommandExt (0x24B5): As QueryVelocityCommand, for speed over ground or through the medium.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    command_type: Which velocity is asked for; as in the report
    """
    REPORT = ReportVelocityCommandExt
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
        MAX_ACCELERATION = 1
        MAX_DECELERATION = 2

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
