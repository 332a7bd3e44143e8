"""urn:jaus:jss:mobility:GlobalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver


class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList):
    """ExecuteList (0x041E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryGlobalWaypoint(mobility_v1_0_global_waypoint_driver.QueryGlobalWaypoint):
    """QueryGlobalWaypoint (0x240C): Asks for the waypoint on the globe being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportGlobalWaypoint]]


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"


class ReportGlobalWaypoint(mobility_v1_0_global_waypoint_driver.ReportGlobalWaypoint):
    """ReportGlobalWaypoint (0x440C): Tells the waypoint on the globe being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointListDriver"
    VERSION = "1.0"


QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryGlobalWaypoint.REPORT = ReportGlobalWaypoint
QueryActiveElement.REPORT = ReportActiveElement
