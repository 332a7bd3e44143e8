"""urn:jaus:jss:mobility:LocalPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalPoseSensor", "1.0")


@jd.message(_SERVICE, 0x0403, presence="H", command=True)
class SetLocalPose(jd.Message):
    """SetLocalPose (0x0403): Sets the pose that the sensor is to assume as the present one.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time of the measurement
    """
    TimeStamp = core_v1_0_types.TimeStamp
    x: float | None = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    z: float | None = jd.field("Z", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4403, presence="H")
class ReportLocalPose(jd.Message):
    """ReportLocalPose (0x4403): Tells the pose.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time of the measurement
    """
    TimeStamp = core_v1_0_types.TimeStamp
    x: float | None = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    z: float | None = jd.field("Z", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2403, query=True)
class QueryLocalPose(jd.Message):
    """QueryLocalPose (0x2403): Asks for the pose.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalPose
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x1FF)
