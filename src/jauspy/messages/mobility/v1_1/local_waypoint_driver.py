"""urn:jaus:jss:mobility:LocalWaypointDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver
from jauspy.messages.mobility.v1_0 import local_waypoint_driver as mobility_v1_0_local_waypoint_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalWaypointDriver", "1.1")

@jd.derived(_SERVICE)
class SetTravelSpeed(mobility_v1_0_global_waypoint_driver.SetTravelSpeed): ...

@jd.derived(_SERVICE)
class SetTravelSpeedExt(mobility_v1_1_global_loiter_driver.SetTravelSpeedExt): ...

@jd.derived(_SERVICE)
class SetLocalWaypoint(mobility_v1_0_local_waypoint_driver.SetLocalWaypoint): ...


@jd.message(_SERVICE, 0x04AD, presence="B", command=True)
class SetLocalWaypointExt(jd.Message):
    """SetLocalWaypointExt (0x04AD): Sets the waypoint in the local frame to drive to, with a choice of the vertical datum.

    x: -20000000..20000000 meter. Position along X, in metres
    y: -20000000..20000000 meter. Position along Y, in metres
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is along X
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    ZPosition = mobility_v1_0_types.ZPosition
    x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
    y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
    z_position: mobility_v1_0_types.ZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.ZPosition.layout(), default=None)
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
class ReportLocalWaypoint(mobility_v1_0_local_waypoint_driver.ReportLocalWaypoint): ...

@jd.derived(_SERVICE)
class QueryLocalWaypoint(mobility_v1_0_local_waypoint_driver.QueryLocalWaypoint):
    REPORT = ReportLocalWaypoint


@jd.message(_SERVICE, 0x44AD, presence="B")
class ReportLocalWaypointExt(jd.Message):
    """ReportLocalWaypointExt (0x44AD): Tells the waypoint in the local frame, with its vertical datum.

    x: -20000000..20000000 meter. Position along X, in metres
    y: -20000000..20000000 meter. Position along Y, in metres
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is along X
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    ZPosition = mobility_v1_0_types.ZPosition
    x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
    y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
    z_position: mobility_v1_0_types.ZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.ZPosition.layout(), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("I", 0.0, 10000.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24AD, query=True)
class QueryLocalWaypointExt(jd.Message):
    """QueryLocalWaypointExt (0x24AD): Asks for the waypoint in the local frame in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalWaypointExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x3F)
