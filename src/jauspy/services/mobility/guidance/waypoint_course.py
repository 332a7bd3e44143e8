"""The way to one waypoint: along a straight leg, slower towards its end, and then to the wanted heading."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.poses import Pose
from jauspy.services.mobility.guidance.course import LOOKS_THERE, reversed_yaw
from jauspy.services.mobility.guidance.heading import head_for, turn_of
from jauspy.services.mobility.guidance.leg import Leg, Point, look_ahead
from jauspy.services.mobility.guidance.motion import STANDSTILL, Motion

TOLERANCE: Final = 0.3
"""Metres within which a waypoint counts as reached that says nothing about it."""
CLOSE: Final = 0.1
"""Metres up to which a waypoint where the robot shall stop is approached, whatever its tolerance."""
SLOWEST: Final = 0.1
"""Speed of the last centimetres, m/s."""
PASSING: Final = 0.4
"""Speed, m/s, at which a waypoint is passed when there are more."""


@dataclass(frozen=True, slots=True)
class Goal:
    """A waypoint in the world, JAUS axes: metres and radians, None for what it leaves open."""

    point: Point
    heading: float | None = None
    tolerance: float = TOLERANCE
    path_tolerance: float | None = None
    is_last: bool = True
    """The robot stops here."""


class WaypointCourse:
    """Drives to `goal`, asked for anew each time since its frame may be set meanwhile, at `speed` (m/s).

    A negative speed drives backward; zero waits. `deceleration` (m/s^2) and `max_turn_rate` (rad/s) are the chassis'.
    """

    limits: None = None

    def __init__(
        self, goal: Callable[[], Goal], speed: Callable[[], float], *, deceleration: float, max_turn_rate: float
    ) -> None:
        self._goal = goal
        self._speed = speed
        self._deceleration = deceleration
        self._max_turn_rate = max_turn_rate
        self._start: Point | None = None
        self._reached = False

    def steer(self, pose: Pose) -> Motion | None:
        """The motion at that pose; None once the waypoint is reached and the heading, too, if it has one."""
        goal, speed = self._goal(), self._speed()
        here = Point(pose.x, pose.y)
        self._start = self._start or here
        if speed == 0.0:
            return STANDSTILL
        leg = Leg(self._start, goal.point)
        self._reached = self._reached or is_reached(goal, leg, here)
        if self._reached:
            return self._align(pose.yaw, goal.heading)
        return self._drive(pose, leg, goal, speed)

    def _drive(self, pose: Pose, leg: Leg, goal: Goal, speed: float) -> Motion:
        here = Point(pose.x, pose.y)
        _, bearing = here.to(leg.ahead(here, look_ahead(speed, goal.path_tolerance)))
        yaw = reversed_yaw(pose.yaw) if speed < 0.0 else pose.yaw
        remaining, _ = here.to(goal.point)
        slowed = min(abs(speed), self._approach(remaining, goal))
        return head_for(turn_of(yaw, bearing), math.copysign(slowed, speed), self._max_turn_rate)

    def _approach(self, remaining: float, goal: Goal) -> float:
        """The speed from which the robot can still slow down; half of its deceleration is kept in reserve."""
        final = SLOWEST if goal.is_last or goal.heading is not None else PASSING
        return math.sqrt(final**2 + self._deceleration * remaining)

    def _align(self, yaw: float, heading: float | None) -> Motion | None:
        if heading is None or abs(error := turn_of(yaw, heading)) < LOOKS_THERE:
            return None
        return head_for(error, 0.0, self._max_turn_rate)


def is_reached(goal: Goal, leg: Leg, here: Point) -> bool:
    """Within the tolerance; where the robot stops it goes on, as near as it gets, to within `CLOSE` of the point."""
    distance, _ = here.to(goal.point)
    if distance > goal.tolerance:
        return False
    return not goal.is_last or distance <= CLOSE or leg.passed(here)
