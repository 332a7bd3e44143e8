"""urn:jaus:jss:mobility:GlobalPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalPoseSensor", "1.0")


@jd.message(_SERVICE, 0x0402, presence="H", command=True)
class SetGlobalPose(jd.Message):
    """SetGlobalPose (0x0402): Sets the pose on the globe that the sensor is to assume as the present one.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x0412, command=True)
class SetGeomagneticProperty(jd.Message):
    """SetGeomagneticProperty (0x0412): Sets the magnetic variation at the present place.

    magnetic_variation: -3.14159265359..3.14159265359 radian. Angle from true to magnetic north, in radians; positive to the east
    """
    magnetic_variation: float = jd.field("MagneticVariation", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))


@jd.message(_SERVICE, 0x4402, presence="H")
class ReportGlobalPose(jd.Message):
    """ReportGlobalPose (0x4402): Tells the pose on the globe.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2402, query=True)
class QueryGlobalPose(jd.Message):
    """QueryGlobalPose (0x2402): Asks for the pose on the globe.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalPose
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x1FF)


@jd.message(_SERVICE, 0x4412)
class ReportGeomagneticProperty(jd.Message):
    """ReportGeomagneticProperty (0x4412): Tells the magnetic variation in use.

    magnetic_variation: -3.14159265359..3.14159265359 radian. Angle from true to magnetic north, in radians; positive to the east
    """
    magnetic_variation: float = jd.field("MagneticVariation", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))


@jd.message(_SERVICE, 0x2412, query=True)
class QueryGeomagneticProperty(jd.Message):
    """QueryGeomagneticProperty (0x2412): Asks for the magnetic variation in use."""
    REPORT = ReportGeomagneticProperty
