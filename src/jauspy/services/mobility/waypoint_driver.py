"""What LocalWaypointDriver and GlobalWaypointDriver have in common: one waypoint, driven to once a speed is set."""

from __future__ import annotations

from typing import Any

from jauspy.services.completion import Completion
from jauspy.services.mobility.travel import WaypointFollower
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoint import Waypoint


class WaypointDriver(WaypointFollower):
    """The waypoint may be set before Ready. A new one on the way keeps the speed; reaching it ends the drive.

    Of two such drivers in a component the one that was given its waypoint last is meant by SetTravelSpeed.
    The command that set out, or last changed the drive, has been carried out when the waypoint is reached.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._command = Completion()

    def waypoint_exists(self, msg: Any) -> bool:
        """To drive: a waypoint that this client has set. To report: any of this kind that was set or driven to."""
        if msg.IS_COMMAND:
            return self.vehicle.goal is not None and self.is_mine(self.vehicle.goal)
        return self.is_mine(self.vehicle.waypoint)

    def is_mine(self, waypoint: Waypoint | None) -> bool:
        """True for waypoints in this driver's frame."""
        raise NotImplementedError(f"{type(self).__name__}.is_mine")

    def take(self, waypoint: Waypoint) -> None:
        """Drive here next, or now when this driver is under way."""
        self.vehicle.goal = self.vehicle.waypoint = waypoint
        if self.drives:
            self._set_out(waypoint, self.vehicle.pilot.travel_speed)

    def set_travel_speed(self, msg: Any) -> None:
        """Set out for the waypoint, or go on faster or slower; zero waits."""
        speed, goal = self.usable_speed(msg), self.vehicle.goal
        if speed is None or goal is None:
            return
        if not self.drives:
            self._set_out(goal, speed)
            return
        self.vehicle.pilot.travel_speed = speed
        if speed:
            self._begin()

    def set_travel_speed_ext(self, msg: Any) -> None:
        """As `set_travel_speed`, of several kinds."""
        self.set_travel_speed(msg)

    def arrived(self) -> None:
        """That was all."""
        self._command(True)
        super().arrived()

    def taken_over(self) -> None:
        """The waypoint was not reached."""
        self._command(False)

    def _set_out(self, waypoint: Waypoint, speed: float) -> None:
        self.travel(waypoint, speed, is_last=True)
        self._begin()

    def _begin(self) -> None:
        """What is being handled ends with this drive; the command before it does not hold any more."""
        self._command(False)
        self._command = self.host.begin_command()

    def control_lost(self) -> None:
        """The next client does not drive to a waypoint that it has not set."""
        super().control_lost()
        self.vehicle.goal = None
