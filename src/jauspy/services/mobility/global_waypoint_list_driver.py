"""GlobalWaypointListDriver: through a list of waypoints on the globe (AS6009)."""

from __future__ import annotations

from jauspy.codec.message import Message
from jauspy.messages.mobility import (
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
)
from jauspy.services.mobility.waypoint import GlobalWaypoint, global_waypoint
from jauspy.services.mobility.waypoint_list_driver import WaypointListDriver


class GlobalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:GlobalWaypointListDriver"):
    """Its elements are SetGlobalWaypoint and SetGlobalWaypointExt messages. The vehicle needs an origin."""

    element_types = (SetGlobalWaypoint, SetGlobalWaypointExt)

    def attached(self) -> None:
        """Check that the vehicle has an origin: `ConfigError` if not."""
        super().attached()
        self.vehicle.georeference()

    def waypoint_of(self, message: Message) -> GlobalWaypoint:
        """What an element says."""
        assert isinstance(message, SetGlobalWaypoint | SetGlobalWaypointExt)
        return global_waypoint(message)

    def waypoint_exists(self) -> bool:
        """There is a global waypoint to report."""
        return isinstance(self.waypoint(), GlobalWaypoint)

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None
