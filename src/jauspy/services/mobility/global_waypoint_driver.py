"""GlobalWaypointDriver: to one waypoint on the globe (AS6009)."""

from __future__ import annotations

from jauspy.messages.mobility import (
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
)
from jauspy.services.mobility.waypoint import GlobalWaypoint, Waypoint, global_waypoint
from jauspy.services.mobility.waypoint_driver import WaypointDriver


class GlobalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:GlobalWaypointDriver"):
    """As LocalWaypointDriver, by latitude, longitude and true heading. The vehicle needs an origin."""

    def attached(self) -> None:
        """Check that there is one: `ConfigError` if not."""
        super().attached()
        self.vehicle.georeference()

    def is_mine(self, waypoint: Waypoint | None) -> bool:
        """True for global waypoints."""
        return isinstance(waypoint, GlobalWaypoint)

    def set_waypoint(self, msg: SetGlobalWaypoint) -> None:
        """From the controlling client, also in Standby."""
        self.take(global_waypoint(msg))

    def set_waypoint_ext(self, msg: SetGlobalWaypointExt) -> None:
        """As `set_waypoint`, with a choice of vertical datums, which a platform on the ground does not mind."""
        self.take(global_waypoint(msg))

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None
