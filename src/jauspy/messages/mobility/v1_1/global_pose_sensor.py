"""urn:jaus:jss:mobility:GlobalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_pose_sensor as mobility_v1_0_global_pose_sensor
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalPoseSensor", "1.1")

@jd.derived(_SERVICE)
class SetGlobalPose(mobility_v1_0_global_pose_sensor.SetGlobalPose): ...


@jd.message(_SERVICE, 0x04A2, presence="H", command=True)
class SetGlobalPoseExt(jd.Message):
    """SetGlobalPoseExt (0x04A2): Sets the present pose on the globe, with a choice of the vertical datum.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    horizontal_rms: 0..100 meter, optional. Root mean square error of latitude and longitude, in metres
    vertical_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
    horizontal_rms: float | None = jd.field("HorizontalRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    vertical_rms: float | None = jd.field("VerticalRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class SetGeomagneticProperty(mobility_v1_0_global_pose_sensor.SetGeomagneticProperty): ...

@jd.derived(_SERVICE)
class ReportGlobalPose(mobility_v1_0_global_pose_sensor.ReportGlobalPose): ...

@jd.derived(_SERVICE)
class QueryGlobalPose(mobility_v1_0_global_pose_sensor.QueryGlobalPose):
    REPORT = ReportGlobalPose


@jd.message(_SERVICE, 0x44A2, presence="H")
class ReportGlobalPoseExt(jd.Message):
    """ReportGlobalPoseExt (0x44A2): Tells the pose on the globe, with several vertical datums, heading and course.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is true north
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude_agl: float | None = jd.field("AltitudeAGL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_msl: float | None = jd.field("AltitudeMSL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_asf: float | None = jd.field("AltitudeASF", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    depth: float | None = jd.field("Depth", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    xy_position_rms: float | None = jd.field("XYPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    z_position_rms: float | None = jd.field("ZPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24A2, query=True)
class QueryGlobalPoseExt(jd.Message):
    """QueryGlobalPoseExt (0x24A2): Asks for the pose on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalPoseExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x7FFF)

@jd.derived(_SERVICE)
class ReportGeomagneticProperty(mobility_v1_0_global_pose_sensor.ReportGeomagneticProperty): ...

@jd.derived(_SERVICE)
class QueryGeomagneticProperty(mobility_v1_0_global_pose_sensor.QueryGeomagneticProperty):
    REPORT = ReportGeomagneticProperty
