"""LocalWaypointListDriver: through a list of waypoints in the local frame (AS6009)."""

from __future__ import annotations

from jauspy.codec.message import Message
from jauspy.messages.mobility import (
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
)
from jauspy.services.mobility.waypoint import LocalWaypoint, local_waypoint
from jauspy.services.mobility.waypoint_list_driver import WaypointListDriver


class LocalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:LocalWaypointListDriver"):
    """Its elements are SetLocalWaypoint and SetLocalWaypointExt messages."""

    element_types = (SetLocalWaypoint, SetLocalWaypointExt)

    def waypoint_of(self, message: Message) -> LocalWaypoint:
        """What an element says."""
        assert isinstance(message, SetLocalWaypoint | SetLocalWaypointExt)
        return local_waypoint(message)

    def waypoint_exists(self) -> bool:
        """There is a local waypoint to report."""
        return isinstance(self.waypoint(), LocalWaypoint)

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None
