"""urn:jaus:jss:mobility:VelocityStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:VelocityStateSensor", "1.0")


@jd.message(_SERVICE, 0x4404, presence="H")
class ReportVelocityState(jd.Message):
    """ReportVelocityState (0x4404): Tells the velocity.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..3.14159265359 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    time_stamp: optional. Time within the month, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_rms: float | None = jd.field("Velocity_RMS", jd.real("I", 0.0, 100.0, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("H", -32.768, 32.767, "radian per second"), default=None)
    rate_rms: float | None = jd.field("Rate_RMS", jd.real("H", 0.0, 3.141592653589793, "radian per second"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2404, query=True)
class QueryVelocityState(jd.Message):
    """QueryVelocityState (0x2404): Asks for the velocity.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportVelocityState
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x1FF)
