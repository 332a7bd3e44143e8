"""urn:jaus:jss:mobility:LocalWaypointListDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_waypoint_driver as mobility_v1_0_local_waypoint_driver
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver
from jauspy.messages.mobility.v1_1 import global_path_segment_driver as mobility_v1_1_global_path_segment_driver
from jauspy.messages.mobility.v1_1 import local_waypoint_driver as mobility_v1_1_local_waypoint_driver


class ExecuteList(mobility_v1_1_global_path_segment_driver.ExecuteList):
    """ExecuteList (0x041E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class ExecuteListExt(mobility_v1_1_global_path_segment_driver.ExecuteListExt):
    """ExecuteListExt (0x04AE): Starts the list at an element, at one of several kinds of speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeedExt]]


class QueryLocalWaypoint(mobility_v1_0_local_waypoint_driver.QueryLocalWaypoint):
    """QueryLocalWaypoint (0x240D): Asks for the waypoint in the local frame being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportLocalWaypoint]]


class QueryLocalWaypointExt(mobility_v1_1_local_waypoint_driver.QueryLocalWaypointExt):
    """QueryLocalWaypointExt (0x24AD): Asks for the waypoint in the local frame in its wider form."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportLocalWaypointExt]]


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class ReportLocalWaypoint(mobility_v1_0_local_waypoint_driver.ReportLocalWaypoint):
    """ReportLocalWaypoint (0x440D): Tells the waypoint in the local frame being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class ReportLocalWaypointExt(mobility_v1_1_local_waypoint_driver.ReportLocalWaypointExt):
    """ReportLocalWaypointExt (0x44AD): Tells the waypoint in the local frame, with its vertical datum."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointListDriver"
    VERSION = "1.1"


QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
QueryLocalWaypoint.REPORT = ReportLocalWaypoint
QueryLocalWaypointExt.REPORT = ReportLocalWaypointExt
QueryActiveElement.REPORT = ReportActiveElement
