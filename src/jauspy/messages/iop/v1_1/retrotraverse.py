"""urn:jaus:jss:iop:Retrotraverse 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:Retrotraverse", "1.1")


@jd.message(_SERVICE, 0xDC51, command=True)
class CancelRetrotraverse(jd.Message):
    """CancelRetrotraverse (0xDC51): Ends a retrotraverse under way."""


@jd.message(_SERVICE, 0xFC50, presence="B", kw_only=True)
class ReportRetrotraverseStatus(jd.Message):
    """ReportRetrotraverseStatus (0xFC50): State and settings of the retrotraverse.

    retrotraverse_action_rec: Retrotraverse action
    global_waypoint_rec: optional. A waypoint on the globe; absent fields are free
    """
    GlobalWaypointRec = mobility_v1_0_types.GlobalWaypointRec

    @jd.bit_field("B")
    class Parameters(jd.Struct):
        """Kind of travel.

        travel_method: bit 0. Travel method.
        direction: bit 1. Direction.
        """
        travel_method: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        direction: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record()
    class RetrotraverseActionRec(jd.Struct):
        """Retrotraverse action.

        distance: 0..1000000 meter. How far to go back along the path; with a target waypoint, the most to travel before stopping (then zero sets no limit)
        max_speed: 0..327.67 meter per second. Speed limit; zero means no faster than on the way out
        parameters: Kind of travel
        standoff_distance: 0..100000 meter. Radius about the destination that must not be entered
        """
        distance: float = jd.field("Distance", jd.real("I", 0.0, 1000000.0, "meter"))
        max_speed: float = jd.field("MaxSpeed", jd.real("H", 0.0, 327.67, "meter per second"))
        parameters: ReportRetrotraverseStatus.Parameters = jd.field("Parameters", lambda: ReportRetrotraverseStatus.Parameters.layout())
        standoff_distance: float = jd.field("StandoffDistance", jd.real("I", 0.0, 100000.0, "meter"))

    class RetrotraverseStatus(IntEnum):
        RETROTRAVERSE_INACTIVE = 0
        REORIENTING_FOR_RETROTRAVERSE = 1
        RETROTRAVERSE_ACTIVE = 2

    @jd.record("B")
    class RetrotraverseStatusRec(jd.Struct):
        """retrotraverse_status: RetrotraverseStatus. What the vehicle is doing
        percent_complete: 0..100, optional. Part done, in percent; left out while the status is 0
        """
        retrotraverse_status: ReportRetrotraverseStatus.RetrotraverseStatus | int = jd.field("RetrotraverseStatus", lambda: jd.Number("B", jd.Values(ReportRetrotraverseStatus.RetrotraverseStatus)))
        percent_complete: float | None = jd.field("PercentComplete", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    retrotraverse_action_rec: ReportRetrotraverseStatus.RetrotraverseActionRec = jd.field("RetrotraverseActionRec", lambda: ReportRetrotraverseStatus.RetrotraverseActionRec.layout())
    global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec | None = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout(), default=None)
    retrotraverse_status_rec: ReportRetrotraverseStatus.RetrotraverseStatusRec = jd.field("RetrotraverseStatusRec", lambda: ReportRetrotraverseStatus.RetrotraverseStatusRec.layout())
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xEC50, query=True)
class QueryRetrotraverseStatus(jd.Message):
    """QueryRetrotraverseStatus (0xEC50): Asks whether and how far a retrotraverse has gone."""
    REPORT = ReportRetrotraverseStatus


@jd.message(_SERVICE, 0xDC50, presence="B", command=True)
class StartRetrotraverse(jd.Message):
    """StartRetrotraverse (0xDC50): Starts a retrotraverse.

    retrotraverse_action_rec: Retrotraverse action
    global_waypoint_rec: optional. A waypoint on the globe; absent fields are free
    """
    GlobalWaypointRec = mobility_v1_0_types.GlobalWaypointRec

    @jd.bit_field("B")
    class Parameters(jd.Struct):
        """Kind of travel.

        travel_method: bit 0. Travel method.
        direction: bit 1. Direction.
        """
        travel_method: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        direction: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record()
    class RetrotraverseActionRec(jd.Struct):
        """Retrotraverse action.

        distance: 0..1000000 meter. How far to go back along the path; with a target waypoint, the most to travel before stopping (then zero sets no limit)
        max_speed: 0..327.67 meter per second. Speed limit; zero means no faster than on the way out
        parameters: Kind of travel
        standoff_distance: 0..100000 meter. Radius about the destination that must not be entered
        """
        distance: float = jd.field("Distance", jd.real("I", 0.0, 1000000.0, "meter"))
        max_speed: float = jd.field("MaxSpeed", jd.real("H", 0.0, 327.67, "meter per second"))
        parameters: StartRetrotraverse.Parameters = jd.field("Parameters", lambda: StartRetrotraverse.Parameters.layout())
        standoff_distance: float = jd.field("StandoffDistance", jd.real("I", 0.0, 100000.0, "meter"))

    retrotraverse_action_rec: StartRetrotraverse.RetrotraverseActionRec = jd.field("RetrotraverseActionRec", lambda: StartRetrotraverse.RetrotraverseActionRec.layout())
    global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec | None = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout(), default=None)
    reserved_presence: int = 0
