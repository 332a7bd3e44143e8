"""urn:jaus:jss:mobility:LocalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_waypoint_driver as mobility_v1_0_local_waypoint_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalWaypointListDriver", "1.0")

@jd.derived(_SERVICE)
class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed

@jd.derived(_SERVICE)
class ReportLocalWaypoint(mobility_v1_0_local_waypoint_driver.ReportLocalWaypoint): ...

@jd.derived(_SERVICE)
class QueryLocalWaypoint(mobility_v1_0_local_waypoint_driver.QueryLocalWaypoint):
    REPORT = ReportLocalWaypoint

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
