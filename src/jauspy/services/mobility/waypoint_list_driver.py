"""What LocalWaypointListDriver and GlobalWaypointListDriver have in common: the elements of a list, one by one."""

from __future__ import annotations

from typing import Any

from jauspy.codec.message import Message
from jauspy.messages.mobility import ReportActiveElement
from jauspy.services.core.list_manager import ListDriver
from jauspy.services.mobility.travel import Traveller
from jauspy.services.mobility.waypoint import Waypoint


class WaypointListDriver(Traveller, ListDriver):
    """Carries out the list at the speed of ExecuteList; the robot stops at the last waypoint.

    A component has one list. With both drivers in it, it may hold waypoints of both kinds, and each goes for its own.
    """

    def waypoint_of(self, message: Message) -> Waypoint:
        """What an element says."""
        raise NotImplementedError(f"{type(self).__name__}.waypoint_of")

    def waypoint(self) -> Waypoint | None:
        """What is reported: the active element, else what was last set or driven to, else the list's first one."""
        if not self.elements.active and self.vehicle.waypoint is not None:
            return self.vehicle.waypoint
        message = self.elements.message(self.elements.active or next(iter(self.elements.list.order), 0))
        return self.waypoint_of(message) if isinstance(message, self.element_types) else None

    # --- actions

    def execute_waypoint_list(self, msg: Any) -> None:
        """Start, or start over, from the element that is named."""
        speed = self.usable_speed(msg)
        if speed is not None:
            self._set_out(msg.element_uid, speed)

    def _set_out(self, uid: int, speed: float) -> None:
        self.elements.execute(uid)
        self.vehicle.pilot.travel_speed = speed

    def modify_travel_speed(self, msg: Any) -> None:
        """Go on faster or slower; zero waits. Ignored while no list is carried out."""
        speed = self.usable_speed(msg)
        if speed is not None and self.elements.active:
            self.vehicle.pilot.travel_speed = speed

    def begin_element(self, uid: int, message: Message) -> None:
        """The next waypoint."""
        is_last = self.elements.list.next(uid) == 0
        self.travel(self.waypoint_of(message), self.vehicle.pilot.travel_speed, is_last=is_last)

    def end_elements(self) -> None:
        """Stop, unless the next element is another driver's: then the list is still active, and it takes over."""
        if not self.elements.active:
            self.vehicle.pilot.release(self)

    def arrived(self) -> None:
        """On to the next one."""
        self.elements.done()

    def taken_over(self) -> None:
        """Another service drives now, or nobody may: the list is not carried out any more."""
        if self.elements.active and not isinstance(self.vehicle.pilot.driver, WaypointListDriver):
            self.elements.stop()

    # --- reports

    def report_active_element(self) -> ReportActiveElement:
        """The element that is being carried out, 0 for none."""
        return ReportActiveElement(element_uid=self.elements.active)
