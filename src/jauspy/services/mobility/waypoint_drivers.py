"""What LocalWaypointDriver and GlobalWaypointDriver have in common: one waypoint, driven to once a speed is set."""

from __future__ import annotations

from typing import Any

from jauspy.geometry.poses import PlanarPoint
from jauspy.messages.mobility import (
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    ReportTravelSpeed,
    ReportTravelSpeedExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
)
from jauspy.services.mobility.courses import DEFAULT_TOLERANCE, Goal, WaypointCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.field_ranges import speed_over_ground, unsigned_speed
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoints import GlobalWaypoint, LocalWaypoint, Waypoint, global_waypoint, local_waypoint
from jauspy.services.state_machine import CommandCompletion


class WaypointFollower(Driver):
    """Drives to waypoints at the pilot's travel speed."""

    uses_travel_speed = True

    def drive_to(self, waypoint: Waypoint, speed: float, *, is_last: bool) -> None:
        """Set out for a waypoint; the robot stops there if it is the last one."""
        vehicle = self.vehicle
        course = WaypointCourse(
            lambda: goal_of(vehicle, waypoint, is_last=is_last),
            lambda: vehicle.pilot.travel_speed,
            deceleration=vehicle.chassis.deceleration,
            max_turn_rate=vehicle.chassis.max_turn_rate,
        )
        vehicle.pilot.follow(self, course)
        vehicle.pilot.travel_speed = speed
        vehicle.waypoint = waypoint

    def report_travel_speed(self) -> ReportTravelSpeed:
        """Zero unless the platform is under way to a waypoint; without the direction, which only the wider form has."""
        return ReportTravelSpeed(speed=unsigned_speed(self.vehicle.pilot.travel_speed))

    def report_travel_speed_ext(self) -> ReportTravelSpeedExt:
        """As `report_travel_speed`, negative backward."""
        return ReportTravelSpeedExt(speed=speed_over_ground(self.vehicle.pilot.travel_speed))


def goal_of(vehicle: Vehicle, waypoint: Waypoint, *, is_last: bool) -> Goal:
    """Where a waypoint lies in the world as its frame is now."""
    attitude = waypoint.attitude
    point, heading = _placed(vehicle, waypoint)
    tolerance = DEFAULT_TOLERANCE if attitude.tolerance is None else attitude.tolerance
    return Goal(point, heading, tolerance, attitude.path_tolerance, is_last)


def _placed(vehicle: Vehicle, waypoint: Waypoint) -> tuple[PlanarPoint, float | None]:
    yaw = waypoint.attitude.yaw
    if isinstance(waypoint, LocalWaypoint):
        frame = vehicle.local_frame
        return frame.to_world(waypoint.x, waypoint.y), None if yaw is None else frame.heading_to_world(yaw)
    globe = vehicle.global_frame()
    return globe.to_world(waypoint.latitude, waypoint.longitude), None if yaw is None else globe.heading_to_world(yaw)


class WaypointDriver(WaypointFollower):
    """The waypoint may be set before Ready. A new one on the way keeps the speed; reaching it ends the drive.

    Of two such drivers in a component the one that was given its waypoint last is meant by SetTravelSpeed.
    The command that set out, or last changed the drive, has been carried out when the waypoint is reached.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._command = CommandCompletion()

    def waypoint_exists(self, msg: Any) -> bool:
        """To drive: a waypoint that this client has set. To report: any of this kind that was set or driven to."""
        if msg.IS_COMMAND:
            return self.vehicle.goal is not None and self.accepts(self.vehicle.goal)
        return self.accepts(self.vehicle.waypoint)

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """True for waypoints in this driver's frame."""
        raise NotImplementedError(f"{type(self).__name__}.is_mine")

    def set_target(self, waypoint: Waypoint) -> None:
        """Drive here next, or now when this driver is under way."""
        self.vehicle.goal = self.vehicle.waypoint = waypoint
        if self.is_driving:
            self._start(waypoint, self.vehicle.pilot.travel_speed)

    def set_travel_speed(self, msg: Any) -> None:
        """Set out for the waypoint, or go on faster or slower; zero waits."""
        speed, goal = self.usable_speed(msg), self.vehicle.goal
        if speed is None or goal is None:
            return
        if not self.is_driving:
            self._start(goal, speed)
            return
        self.vehicle.pilot.travel_speed = speed
        if speed:
            self._begin()

    def set_travel_speed_ext(self, msg: Any) -> None:
        """As `set_travel_speed`, of several kinds."""
        self.set_travel_speed(msg)

    def on_arrival(self) -> None:
        """That was all."""
        self._command(True)
        super().on_arrival()

    def on_preempted(self) -> None:
        """The waypoint was not reached."""
        self._command(False)

    def _start(self, waypoint: Waypoint, speed: float) -> None:
        self.drive_to(waypoint, speed, is_last=True)
        self._begin()

    def _begin(self) -> None:
        """What is being handled ends with this drive; the command before it does not hold any more."""
        self._command(False)
        self._command = self.host.begin_command()

    def control_lost(self) -> None:
        """The next client does not drive to a waypoint that it has not set."""
        super().control_lost()
        self.vehicle.goal = None


class LocalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:LocalWaypointDriver"):
    """Follows the straight line from where it is; when the local frame is set meanwhile, the waypoint goes with it."""

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """True for local waypoints."""
        return isinstance(waypoint, LocalWaypoint)

    def set_waypoint(self, msg: SetLocalWaypoint) -> None:
        """From the controlling client, also in Standby."""
        self.set_target(local_waypoint(msg))

    def set_waypoint_ext(self, msg: SetLocalWaypointExt) -> None:
        """As `set_waypoint`, with a choice of vertical datums, which a platform on the ground does not mind."""
        self.set_target(local_waypoint(msg))

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None


class GlobalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:GlobalWaypointDriver"):
    """As LocalWaypointDriver, by latitude, longitude and true heading. The vehicle needs an origin."""

    def attached(self) -> None:
        """Check that there is one: `ConfigError` if not."""
        super().attached()
        self.vehicle.global_frame()

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """True for global waypoints."""
        return isinstance(waypoint, GlobalWaypoint)

    def set_waypoint(self, msg: SetGlobalWaypoint) -> None:
        """From the controlling client, also in Standby."""
        self.set_target(global_waypoint(msg))

    def set_waypoint_ext(self, msg: SetGlobalWaypointExt) -> None:
        """As `set_waypoint`, with a choice of vertical datums, which a platform on the ground does not mind."""
        self.set_target(global_waypoint(msg))

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint as it was set."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None
