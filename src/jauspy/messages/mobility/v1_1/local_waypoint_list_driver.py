"""urn:jaus:jss:mobility:LocalWaypointListDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_waypoint_driver as mobility_v1_0_local_waypoint_driver
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver
from jauspy.messages.mobility.v1_1 import global_path_segment_driver as mobility_v1_1_global_path_segment_driver
from jauspy.messages.mobility.v1_1 import local_waypoint_driver as mobility_v1_1_local_waypoint_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalWaypointListDriver", "1.1")

@jd.derived(_SERVICE)
class ExecuteList(mobility_v1_1_global_path_segment_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ExecuteListExt(mobility_v1_1_global_path_segment_driver.ExecuteListExt): ...

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

@jd.derived(_SERVICE)
class ReportLocalWaypointExt(mobility_v1_1_local_waypoint_driver.ReportLocalWaypointExt): ...

@jd.derived(_SERVICE)
class QueryLocalWaypointExt(mobility_v1_1_local_waypoint_driver.QueryLocalWaypointExt):
    REPORT = ReportLocalWaypointExt

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
