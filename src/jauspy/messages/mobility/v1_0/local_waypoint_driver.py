"""urn:jaus:jss:mobility:LocalWaypointDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalWaypointDriver", "1.0")

@jd.derived(_SERVICE)
class SetTravelSpeed(mobility_v1_0_global_waypoint_driver.SetTravelSpeed): ...


@jd.message(_SERVICE, 0x040D, presence="B", command=True)
class SetLocalWaypoint(jd.Message):
    """SetLocalWaypoint (0x040D): Sets the waypoint in the local frame to drive to.

    x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is along X
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    x: float = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"))
    y: float = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"))
    z: float | None = jd.field("Z", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
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


@jd.message(_SERVICE, 0x440D, presence="B")
class ReportLocalWaypoint(jd.Message):
    """ReportLocalWaypoint (0x440D): Tells the waypoint in the local frame being driven to.

    x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is along X
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    x: float = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"))
    y: float = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"))
    z: float | None = jd.field("Z", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("H", 0.0, 100.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x240D, query=True)
class QueryLocalWaypoint(jd.Message):
    """QueryLocalWaypoint (0x240D): Asks for the waypoint in the local frame being driven to.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalWaypoint
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x3F)
