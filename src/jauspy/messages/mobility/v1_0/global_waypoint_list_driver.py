"""urn:jaus:jss:mobility:GlobalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalWaypointListDriver", "1.0")

@jd.derived(_SERVICE)
class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed

@jd.derived(_SERVICE)
class ReportGlobalWaypoint(mobility_v1_0_global_waypoint_driver.ReportGlobalWaypoint): ...

@jd.derived(_SERVICE)
class QueryGlobalWaypoint(mobility_v1_0_global_waypoint_driver.QueryGlobalWaypoint):
    REPORT = ReportGlobalWaypoint

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
