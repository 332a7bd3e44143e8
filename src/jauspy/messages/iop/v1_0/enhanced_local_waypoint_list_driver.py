"""urn:jaus:jss:iop:EnhancedLocalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:EnhancedLocalWaypointListDriver", "1.0")


@jd.message(_SERVICE, 0xF224)
class ReportEnhancedLocalWaypointInformation(jd.Message):
    """ReportEnhancedLocalWaypointInformation (0xF224): Tells the additional data of the waypoints.

    waypoint_information_list: 0..255 items. One entry a waypoint
    """
    WaypointInformationRec = iop_v1_0_types.WaypointInformationRec
    waypoint_information_list: list[iop_v1_0_types.WaypointInformationRec] = jd.field("WaypointInformationList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.WaypointInformationRec.layout()))


@jd.message(_SERVICE, 0xF222, query=True)
class QueryEnhancedLocalWaypointInformation(jd.Message):
    """QueryEnhancedLocalWaypointInformation (0xF222): Asks for the additional data of the waypoints.

    presence_vector: Which optional fields are wanted; bits as in the list of SetEnhancedLocalWaypointInformation
    """
    REPORT = ReportEnhancedLocalWaypointInformation
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))


@jd.message(_SERVICE, 0xF223)
class ReportLocalWaypointStatus(jd.Message):
    """ReportLocalWaypointStatus (0xF223): Tells how far the waypoint list has proceeded.

    suspended_time: in second. Time spent waiting at the present waypoint
    waypoint_status: WaypointStatus. State of the list's execution
    """

    class WaypointStatus(IntEnum):
        NO_PLAN = 0
        PLAN_LOADED = 1
        EXECUTING = 2
        PAUSED = 3
        TIMED_WAIT = 4
        COMPLETE = 5
        FAULT = 6
        NON_SPECIFIC_FAULT = 7
        VEHICLE_UNRESPONSIVE = 8
        OUTSIDE_CORRIDOR = 9
        INVALID_SENSOR_DATA = 10
        NO_PLAN_FAULT = 11
        INVALID_PLAN = 12
        NO_PATH_AVAILABLE = 13

    suspended_time: int = jd.field("SuspendedTime", jd.Number("H", jd.ANY, "second"))
    waypoint_status: ReportLocalWaypointStatus.WaypointStatus | int = jd.field("WaypointStatus", lambda: jd.Number("B", jd.Values(ReportLocalWaypointStatus.WaypointStatus)))


@jd.message(_SERVICE, 0xF221, query=True)
class QueryLocalWaypointStatus(jd.Message):
    """QueryLocalWaypointStatus (0xF221): Asks how far the waypoint list has proceeded."""
    REPORT = ReportLocalWaypointStatus


@jd.message(_SERVICE, 0xF220, command=True)
class SetEnhancedLocalWaypointInformation(jd.Message):
    """SetEnhancedLocalWaypointInformation (0xF220): Sets the additional data of the waypoints.

    waypoint_information_list: 0..255 items. One entry a waypoint
    """
    WaypointInformationRec = iop_v1_0_types.WaypointInformationRec
    waypoint_information_list: list[iop_v1_0_types.WaypointInformationRec] = jd.field("WaypointInformationList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.WaypointInformationRec.layout()))
