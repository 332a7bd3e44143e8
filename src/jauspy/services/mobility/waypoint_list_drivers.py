"""LocalWaypointListDriver and GlobalWaypointListDriver: drive through a list of waypoints (AS6009)."""

from __future__ import annotations

from typing import Any

from jauspy.codec.message import Message
from jauspy.messages.mobility import (
    ReportActiveElement,
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
)
from jauspy.services.core.list_manager import ListDriver
from jauspy.services.mobility.waypoint_drivers import WaypointFollower
from jauspy.services.mobility.waypoints import GlobalWaypoint, LocalWaypoint, Waypoint, global_waypoint, local_waypoint


class WaypointListDriver(WaypointFollower, ListDriver):
    """Executes the list at the speed of ExecuteList; the robot stops at the last waypoint.

    A component has one list. With both drivers it may hold waypoints of both kinds; each driver executes its own.
    """

    def waypoint_of(self, message: Message) -> Waypoint:
        """The waypoint of an element's message."""
        raise NotImplementedError(f"{type(self).__name__}.waypoint_of")

    def waypoint(self) -> Waypoint | None:
        """To report: the active element, else the waypoint last set or driven to, else the first of the list."""
        if not self.elements.active and self.vehicle.waypoint is not None:
            return self.vehicle.waypoint
        message = self.elements.message(self.elements.active or next(iter(self.elements.list.order), 0))
        return self.waypoint_of(message) if isinstance(message, self.element_types) else None

    # --- actions

    def execute_waypoint_list(self, msg: Any) -> None:
        """Start, or restart, at the given element."""
        speed = self.usable_speed(msg)
        if speed is not None:
            self._start(msg.element_uid, speed)

    def _start(self, uid: int, speed: float) -> None:
        self.elements.execute(uid)
        self.vehicle.pilot.travel_speed = speed

    def modify_travel_speed(self, msg: Any) -> None:
        """Change the speed; zero waits. Ignored while no list is executed."""
        speed = self.usable_speed(msg)
        if speed is not None and self.elements.active:
            self.vehicle.pilot.travel_speed = speed

    def begin_element(self, uid: int, message: Message) -> None:
        """Drive to the waypoint."""
        is_last = self.elements.list.next(uid) == 0
        self.drive_to(self.waypoint_of(message), self.vehicle.pilot.travel_speed, is_last=is_last)

    def end_elements(self) -> None:
        """Stop, unless the list goes on with an element of another driver."""
        if not self.elements.active:
            self.vehicle.pilot.release(self)

    def on_arrival(self) -> None:
        """Go on with the next element."""
        self.elements.done()

    def on_preempted(self) -> None:
        """Stop the list, unless its next element belongs to another list driver."""
        if self.elements.active and not isinstance(self.vehicle.pilot.driver, WaypointListDriver):
            self.elements.stop()

    # --- reports

    def report_active_element(self) -> ReportActiveElement:
        """The active element, 0 for none."""
        return ReportActiveElement(element_uid=self.elements.active)


class LocalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:LocalWaypointListDriver"):
    """Its elements are SetLocalWaypoint and SetLocalWaypointExt messages."""

    element_types = (SetLocalWaypoint, SetLocalWaypointExt)

    def waypoint_of(self, message: Message) -> LocalWaypoint:
        """The waypoint of an element's message."""
        assert isinstance(message, SetLocalWaypoint | SetLocalWaypointExt)
        return local_waypoint(message)

    def waypoint_exists(self) -> bool:
        """True if there is a local waypoint to report."""
        return isinstance(self.waypoint(), LocalWaypoint)

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None


class GlobalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:GlobalWaypointListDriver"):
    """Its elements are SetGlobalWaypoint and SetGlobalWaypointExt messages. The vehicle needs an origin."""

    element_types = (SetGlobalWaypoint, SetGlobalWaypointExt)

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        super().attached()
        self.vehicle.global_frame()

    def waypoint_of(self, message: Message) -> GlobalWaypoint:
        """The waypoint of an element's message."""
        assert isinstance(message, SetGlobalWaypoint | SetGlobalWaypointExt)
        return global_waypoint(message)

    def waypoint_exists(self) -> bool:
        """True if there is a global waypoint to report."""
        return isinstance(self.waypoint(), GlobalWaypoint)

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None
