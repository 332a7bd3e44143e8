"""urn:jaus:jss:mobility:AccelerationStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:AccelerationStateSensor", "1.0")


@jd.message(_SERVICE, 0x4417, presence="H")
class ReportAccelerationState(jd.Message):
    """ReportAccelerationState (0x4417): Tells the acceleration.

    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..3.14159265359 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_stamp: optional. Time within the month, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_rms: float | None = jd.field("Acceleration_RMS", jd.real("I", 0.0, 100.0, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    rotational_acceleration_rms: float | None = jd.field("RotationalAcceleration_RMS", jd.real("H", 0.0, 3.141592653589793, "radian per second squared"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2417, query=True)
class QueryAccelerationState(jd.Message):
    """QueryAccelerationState (0x2417): Asks for the acceleration.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportAccelerationState
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x1FF)
