"""LocalWaypointDriver: to one waypoint in the local frame (AS6009)."""

from __future__ import annotations

from jauspy.messages.mobility import (
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
)
from jauspy.services.mobility.waypoint import LocalWaypoint, Waypoint, local_waypoint
from jauspy.services.mobility.waypoint_driver import WaypointDriver


class LocalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:LocalWaypointDriver"):
    """Follows the straight line from where it is; when the local frame is set meanwhile, the waypoint goes with it."""

    def is_mine(self, waypoint: Waypoint | None) -> bool:
        """True for local waypoints."""
        return isinstance(waypoint, LocalWaypoint)

    def set_waypoint(self, msg: SetLocalWaypoint) -> None:
        """From the controlling client, also in Standby."""
        self.take(local_waypoint(msg))

    def set_waypoint_ext(self, msg: SetLocalWaypointExt) -> None:
        """As `set_waypoint`, with a choice of vertical datums, which a platform on the ground does not mind."""
        self.take(local_waypoint(msg))

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None
