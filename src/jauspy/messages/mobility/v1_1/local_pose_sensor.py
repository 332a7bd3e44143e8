"""urn:jaus:jss:mobility:LocalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import local_pose_sensor as mobility_v1_0_local_pose_sensor
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalPoseSensor", "1.1")

@jd.derived(_SERVICE)
class SetLocalPose(mobility_v1_0_local_pose_sensor.SetLocalPose): ...


@jd.message(_SERVICE, 0x04A3, presence="H", command=True)
class SetLocalPoseExt(jd.Message):
    """SetLocalPoseExt (0x04A3): Sets the present pose, with a wider range and a choice of the vertical datum.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    z_position: optional. Vertical position and its datum
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    ZPosition = mobility_v1_0_types.ZPosition
    x: float | None = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    z_position: mobility_v1_0_types.ZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.ZPosition.layout(), default=None)
    xy_position_rms: float | None = jd.field("XYPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    z_position_rms: float | None = jd.field("ZPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportLocalPose(mobility_v1_0_local_pose_sensor.ReportLocalPose): ...

@jd.derived(_SERVICE)
class QueryLocalPose(mobility_v1_0_local_pose_sensor.QueryLocalPose):
    REPORT = ReportLocalPose


@jd.message(_SERVICE, 0x44A3, presence="H")
class ReportLocalPoseExt(jd.Message):
    """ReportLocalPoseExt (0x44A3): Tells the pose, with a wider range and several vertical datums.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    z_local: -50000..50000 meter, optional. Position along Z of the local frame, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is along X
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    x: float | None = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    altitude_agl: float | None = jd.field("AltitudeAGL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_msl: float | None = jd.field("AltitudeMSL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_asf: float | None = jd.field("AltitudeASF", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    depth: float | None = jd.field("Depth", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    z_local: float | None = jd.field("ZLocal", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    xy_position_rms: float | None = jd.field("XYPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    z_position_rms: float | None = jd.field("ZPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)


@jd.message(_SERVICE, 0x24A3, query=True)
class QueryLocalPoseExt(jd.Message):
    """QueryLocalPoseExt (0x24A3): Asks for the pose in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalPoseExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0xFFFF)
