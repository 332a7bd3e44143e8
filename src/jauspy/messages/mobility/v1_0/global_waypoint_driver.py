"""urn:jaus:jss:mobility:GlobalWaypointDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalWaypointDriver", "1.0")


@jd.message(_SERVICE, 0x040A, command=True)
class SetTravelSpeed(jd.Message):
    """SetTravelSpeed (0x040A): Sets the speed on the way.

    speed: 0..327.67 meter per second. Speed on the way, in metres per second
    """
    speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))


@jd.message(_SERVICE, 0x040C, presence="B", command=True)
class SetGlobalWaypoint(jd.Message):
    """SetGlobalWaypoint (0x040C): Sets the waypoint on the globe to drive to.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is true north
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("H", 0.0, 100.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed


@jd.message(_SERVICE, 0x440C, presence="B")
class ReportGlobalWaypoint(jd.Message):
    """ReportGlobalWaypoint (0x440C): Tells the waypoint on the globe being driven to.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is true north
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("H", 0.0, 100.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x240C, query=True)
class QueryGlobalWaypoint(jd.Message):
    """QueryGlobalWaypoint (0x240C): Asks for the waypoint on the globe being driven to.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalWaypoint
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x3F)
