"""urn:jaus:jss:mobility:LocalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_waypoint_driver as mobility_v1_0_local_waypoint_driver


class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList):
    """ExecuteList (0x041E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryLocalWaypoint(mobility_v1_0_local_waypoint_driver.QueryLocalWaypoint):
    """QueryLocalWaypoint (0x240D): Asks for the waypoint in the local frame being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportLocalWaypoint]]


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"


class ReportLocalWaypoint(mobility_v1_0_local_waypoint_driver.ReportLocalWaypoint):
    """ReportLocalWaypoint (0x440D): Tells the waypoint in the local frame being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.0"


QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryLocalWaypoint.REPORT = ReportLocalWaypoint
QueryActiveElement.REPORT = ReportActiveElement
