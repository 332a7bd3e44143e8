"""urn:jaus:jss:mobility:GlobalWaypointDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalWaypointDriver", "1.1")

@jd.derived(_SERVICE)
class SetTravelSpeed(mobility_v1_0_global_waypoint_driver.SetTravelSpeed): ...

@jd.derived(_SERVICE)
class SetTravelSpeedExt(mobility_v1_1_global_loiter_driver.SetTravelSpeedExt): ...

@jd.derived(_SERVICE)
class SetGlobalWaypoint(mobility_v1_0_global_waypoint_driver.SetGlobalWaypoint): ...


@jd.message(_SERVICE, 0x04AC, presence="B", command=True)
class SetGlobalWaypointExt(jd.Message):
    """SetGlobalWaypointExt (0x04AC): Sets the waypoint on the globe to drive to, with a choice of the vertical datum.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is true north
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
    z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("I", 0.0, 10000.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed

@jd.derived(_SERVICE)
class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt): ...

@jd.derived(_SERVICE)
class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    REPORT = ReportTravelSpeedExt

@jd.derived(_SERVICE)
class ReportGlobalWaypoint(mobility_v1_0_global_waypoint_driver.ReportGlobalWaypoint): ...

@jd.derived(_SERVICE)
class QueryGlobalWaypoint(mobility_v1_0_global_waypoint_driver.QueryGlobalWaypoint):
    REPORT = ReportGlobalWaypoint


@jd.message(_SERVICE, 0x44AC, presence="B")
class ReportGlobalWaypointExt(jd.Message):
    """ReportGlobalWaypointExt (0x44AC): Tells the waypoint on the globe, with its vertical datum.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is true north
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
    z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("I", 0.0, 10000.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24AC, query=True)
class QueryGlobalWaypointExt(jd.Message):
    """QueryGlobalWaypointExt (0x24AC): Asks for the waypoint on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalWaypointExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x3F)
