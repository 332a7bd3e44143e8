"""What the drivers to waypoints have in common: the travel speed, and the way to one waypoint."""

from __future__ import annotations

from jauspy.messages.mobility import ReportTravelSpeed, ReportTravelSpeedExt
from jauspy.services.mobility.courses import DEFAULT_TOLERANCE, Goal, PlanarPoint, WaypointCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.field_ranges import speed_over_ground, unsigned_speed
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoint import LocalWaypoint, Waypoint


class WaypointFollower(Driver):
    """Drives to waypoints at the pilot's travel speed."""

    travels = True

    def travel(self, waypoint: Waypoint, speed: float, *, is_last: bool) -> None:
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
        frame = vehicle.local
        return frame.place(waypoint.x, waypoint.y), None if yaw is None else frame.heading(yaw)
    globe = vehicle.georeference()
    return globe.place(waypoint.latitude, waypoint.longitude), None if yaw is None else globe.heading(yaw)
