"""urn:jaus:jss:iop:EnhancedGlobalWaypointListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:EnhancedGlobalWaypointListDriver", "1.0")


@jd.message(_SERVICE, 0xF22C)
class ReportEnhancedGlobalWaypointInformation(jd.Message):
    """ReportEnhancedGlobalWaypointInformation (0xF22C): Gives the added data of the waypoints.

    waypoint_information_list: 0..255 items. Waypoint information
    """
    WaypointInformationRec = iop_v1_0_types.WaypointInformationRec
    waypoint_information_list: list[iop_v1_0_types.WaypointInformationRec] = jd.field("WaypointInformationList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.WaypointInformationRec.layout()))


@jd.message(_SERVICE, 0xF22A, query=True)
class QueryEnhancedGlobalWaypointInformation(jd.Message):
    """QueryEnhancedGlobalWaypointInformation (0xF22A): Asks for the added data of the waypoints.

    presence_vector: Bits of the optional fields wanted, as in SetEnhancedGlobalWaypointInformation (bit 0 DirectionOfTravel, bit 1 WaitTime)
    """
    REPORT = ReportEnhancedGlobalWaypointInformation
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))


@jd.message(_SERVICE, 0xF22B)
class ReportGlobalWaypointStatus(jd.Message):
    """ReportGlobalWaypointStatus (0xF22B): Tells how the run of the global waypoint list is getting on.

    suspended_time: in second. How long the vehicle has been held at this waypoint
    waypoint_status: WaypointStatus. State of the run, or the fault that stopped it
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
    waypoint_status: ReportGlobalWaypointStatus.WaypointStatus | int = jd.field("WaypointStatus", lambda: jd.Number("B", jd.Values(ReportGlobalWaypointStatus.WaypointStatus)))


@jd.message(_SERVICE, 0xF229, query=True)
class QueryGlobalWaypointStatus(jd.Message):
    """QueryGlobalWaypointStatus (0xF229): Asks how the run of the global waypoint list is getting on."""
    REPORT = ReportGlobalWaypointStatus


@jd.message(_SERVICE, 0xF228, command=True)
class SetEnhancedGlobalWaypointInformation(jd.Message):
    """SetEnhancedGlobalWaypointInformation (0xF228): Gives waypoints of the list their added data.

    waypoint_information_list: 0..255 items. Waypoint information
    """
    WaypointInformationRec = iop_v1_0_types.WaypointInformationRec
    waypoint_information_list: list[iop_v1_0_types.WaypointInformationRec] = jd.field("WaypointInformationList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.WaypointInformationRec.layout()))
