"""urn:jaus:jss:mobility:AccelerationStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import acceleration_state_sensor as mobility_v1_0_acceleration_state_sensor

_SERVICE = jd.Service("urn:jaus:jss:mobility:AccelerationStateSensor", "1.1")

@jd.derived(_SERVICE)
class ReportAccelerationState(mobility_v1_0_acceleration_state_sensor.ReportAccelerationState): ...

@jd.derived(_SERVICE)
class QueryAccelerationState(mobility_v1_0_acceleration_state_sensor.QueryAccelerationState):
    REPORT = ReportAccelerationState


@jd.message(_SERVICE, 0x44B7, presence="H")
class ReportAccelerationStateExt(jd.Message):
    """ReportAccelerationStateExt (0x44B7): Tells the acceleration, with a time of measurement in nanoseconds.

    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..1000 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_rms: float | None = jd.field("Acceleration_RMS", jd.real("I", 0.0, 100.0, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    rotational_acceleration_rms: float | None = jd.field("RotationalAcceleration_RMS", jd.real("H", 0.0, 1000.0, "radian per second squared"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24B7, query=True)
class QueryAccelerationStateExt(jd.Message):
    """QueryAccelerationStateExt (0x24B7): Asks for the acceleration with its finer time of measurement.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportAccelerationStateExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x3FF)
