"""Courses, which the pilot follows: the wanted velocity as a function of the pose (docs/adr/0037-guidance.md).

Poses are in the world, in JAUS axes: metres, and headings in radians, positive to the right.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol

from jauspy.geometry.poses import PlanarPoint, Pose
from jauspy.services.mobility.velocity_control import STANDSTILL, AccelerationLimits, PlanarVelocity, clamp

TURN_GAIN: Final = 1.8
"""Turn rate per heading error, 1/s."""
MAX_DRIVING_ERROR: Final = 0.8
"""Heading error, rad, above which the robot turns on the spot."""
NARROW_PATH: Final = 0.15
NARROW_DRIVING_ERROR: Final = 0.2
"""Path tolerance, metres, below which that angle is less, rad: from 0.8 rad a robot drives 10 cm beside its leg."""
HEADING_TOLERANCE: Final = 0.03
"""Heading error, rad, below which a robot that stands does not turn."""
MIN_LOOK_AHEAD: Final = 0.6
"""Metres ahead on the leg that the robot steers for when it is slow."""
LEAST_LOOK_AHEAD: Final = 0.35
"""Metres where the path tolerance is narrow: with less a robot some centimetres off its leg turns by so much that its
corners are farther off than before."""
LOOK_AHEAD_TIME: Final = 0.7
"""Seconds of driving ahead when it is fast."""
DEFAULT_TOLERANCE: Final = 0.3
"""Metres within which a waypoint without a tolerance counts as reached."""
STOP_TOLERANCE: Final = 0.1
"""Metres to which the robot approaches a waypoint where it stops, whatever the tolerance."""
FINAL_SPEED: Final = 0.1
"""m/s of the last centimetres to a stop."""
CURVE_MARGIN: Final = 1.4
"""Radius of a curve, as a multiple of the narrowest one, that can well be driven."""
CURVE_SPEED: Final = 0.3
"""m/s at which a chassis that cannot turn on the spot drives curves, at least."""
PASSING_SPEED: Final = 0.4
"""m/s at which a waypoint is passed when more follow."""
PASSING_TIME: Final = 0.3
"""Seconds in which a waypoint's tolerance is driven at least: a narrow one is passed slowly."""


class Course(Protocol):
    """A course for the pilot."""

    @property
    def limits(self) -> AccelerationLimits | None:
        """Limits of changes of velocity; None for those of the chassis."""
        ...

    def steer(self, pose: Pose, /) -> PlanarVelocity | None:
        """The velocity wanted at a pose; None at the end of the course."""
        ...


@dataclass(frozen=True, slots=True)
class Halt:
    """Slows down and stops."""

    limits: None = None

    def steer(self, _: Pose) -> PlanarVelocity:
        """Return zero velocity."""
        return STANDSTILL


@dataclass(frozen=True, slots=True)
class VelocityCourse:
    """A constant velocity."""

    velocity: PlanarVelocity
    limits: AccelerationLimits

    def steer(self, _: Pose) -> PlanarVelocity:
        """The same at each pose."""
        return self.velocity


@dataclass(frozen=True, slots=True)
class VectorCourse:
    """A heading, which is read each time since its frame may be set, and a speed (m/s, negative backward)."""

    heading: Callable[[], float]
    speed: float
    max_turn_rate: float
    min_turn_radius: float = 0.0
    """Metres; a chassis that cannot turn on the spot drives a curve, and stands if the speed is zero."""
    limits: None = None

    def steer(self, pose: Pose) -> PlanarVelocity:
        """Towards the heading; never None."""
        error = heading_error(pose.yaw, self.heading())
        if self.speed == 0.0 and (self.min_turn_radius or abs(error) < HEADING_TOLERANCE):
            return STANDSTILL
        return steer_to_heading(error, self.speed, self.max_turn_rate, self.min_turn_radius)


def steer_to_heading(
    error: float,
    speed: float,
    max_turn_rate: float,
    min_turn_radius: float = 0.0,
    *,
    max_driving_error: float = MAX_DRIVING_ERROR,
) -> PlanarVelocity:
    """The velocity that reduces a heading error (rad, positive when the heading lies to the right).

    The speed (m/s, negative backward) falls as the error grows, and is 0 above `max_driving_error` (rad): the slower a
    curve is driven, the narrower it is. With a `min_turn_radius` (metres) the chassis does not turn on the spot: it
    keeps the speed and turns as it can.
    """
    turn_rate = clamp(TURN_GAIN * error, max_turn_rate)
    if min_turn_radius:
        slowed = math.copysign(min(abs(speed), max(CURVE_SPEED, max_turn_rate * min_turn_radius)), speed)
        driven = slowed if abs(error) > HEADING_TOLERANCE else speed
        return PlanarVelocity(driven, clamp(turn_rate, abs(driven) / min_turn_radius))
    fade = max(0.0, 1.0 - (error / max_driving_error) ** 2)
    return PlanarVelocity(speed * fade, turn_rate)


def heading_error(heading: float, wanted: float) -> float:
    """The smaller angle from one heading to another, -pi..pi, positive to the right."""
    return math.remainder(wanted - heading, math.tau)


def reversed_yaw(yaw: float) -> float:
    """The direction of travel of a robot that drives backward."""
    return math.remainder(yaw + math.pi, math.tau)


class BoundedCourse:
    """Another course, which ends after a distance (metres) at the latest."""

    def __init__(self, course: Course, distance: float) -> None:
        self._course = course
        self._left = distance
        self._position: PlanarPoint | None = None

    @property
    def limits(self) -> AccelerationLimits | None:
        """Those of the other course."""
        return self._course.limits

    def steer(self, pose: Pose) -> PlanarVelocity | None:
        """The velocity of the other course; None once the distance is driven."""
        before, self._position = self._position, PlanarPoint(pose.x, pose.y)
        if before is not None:
            self._left -= before.to(self._position)[0]
        return self._course.steer(pose) if self._left > 0.0 else None


@dataclass(frozen=True, slots=True)
class Leg:
    """The straight line to a waypoint, from the one before it or from where the robot was."""

    start: PlanarPoint
    end: PlanarPoint

    def ahead(self, position: PlanarPoint, look_ahead: float, *, ends: bool = True) -> PlanarPoint:
        """The point of the leg to steer for: `look_ahead` metres beyond the one abeam of the robot.

        Where the leg `ends`, not beyond its end. A robot that passes the end must not turn towards it, beside it.
        """
        length, direction = self.start.to(self.end)
        distance = max(0.0, self.covered(position, direction)) + look_ahead
        if ends:
            distance = min(length, distance)
        return PlanarPoint(self.start.x + distance * math.cos(direction), self.start.y + distance * math.sin(direction))

    def passed(self, position: PlanarPoint) -> bool:
        """True if the robot is abeam of the end, or beyond it."""
        length, direction = self.start.to(self.end)
        return self.covered(position, direction) >= length

    def covered(self, position: PlanarPoint, direction: float | None = None) -> float:
        """Metres of the leg, from its start, to the point abeam of a position; `direction` of the leg, if known."""
        direction = self.start.to(self.end)[1] if direction is None else direction
        return (position.x - self.start.x) * math.cos(direction) + (position.y - self.start.y) * math.sin(direction)


def look_ahead(speed: float, path_tolerance: float | None) -> float:
    """Metres to look ahead at a speed; less where the path tolerance is narrow."""
    wanted = max(MIN_LOOK_AHEAD, LOOK_AHEAD_TIME * abs(speed))
    return wanted if path_tolerance is None else min(wanted, max(LEAST_LOOK_AHEAD, path_tolerance))


@dataclass(frozen=True, slots=True)
class CourseGoal:
    """A waypoint in the world, metres and radians; None for values that were not commanded."""

    point: PlanarPoint
    heading: float | None = None
    tolerance: float = DEFAULT_TOLERANCE
    path_tolerance: float | None = None
    is_last: bool = True
    """The robot stops here."""


class WaypointCourse:
    """Along a straight leg to `goal`, slower towards its end, then to its heading, if it has one.

    `goal` and `speed` (m/s; negative drives backward, zero waits) are read each time, since the frame of the
    waypoint and the speed may be set. `deceleration` (m/s^2), `max_turn_rate` (rad/s) and `min_turn_radius` (metres)
    are those of the chassis. One that cannot turn on the spot first drives on if the waypoint is inside its narrowest
    curve, and takes no heading at the waypoint.
    """

    limits: None = None

    def __init__(
        self,
        goal: Callable[[], CourseGoal],
        speed: Callable[[], float],
        *,
        deceleration: float,
        max_turn_rate: float,
        min_turn_radius: float = 0.0,
        start: Callable[[], PlanarPoint] | None = None,
    ) -> None:
        self._goal = goal
        self._speed = speed
        self._deceleration = deceleration
        self._max_turn_rate = max_turn_rate
        self._min_turn_radius = min_turn_radius
        self._start = start
        self._reached = False
        self._drives_on = False

    def steer(self, pose: Pose) -> PlanarVelocity | None:
        """The velocity wanted at a pose; None once the waypoint, and its heading, are reached."""
        goal, speed = self._goal(), self._speed()
        position = PlanarPoint(pose.x, pose.y)
        self._start = self._start or (lambda: position)
        if speed == 0.0:
            return STANDSTILL
        leg = Leg(self._start(), goal.point)
        self._reached = self._reached or is_reached(goal, leg, position)
        if self._reached:
            return self._align(pose.yaw, goal.heading)
        return self._drive(pose, leg, goal, speed)

    def _drive(self, pose: Pose, leg: Leg, goal: CourseGoal, speed: float) -> PlanarVelocity:
        position = PlanarPoint(pose.x, pose.y)
        ends = goal.is_last or goal.path_tolerance is None
        _, bearing = position.to(leg.ahead(position, look_ahead(speed, goal.path_tolerance), ends=ends))
        yaw = reversed_yaw(pose.yaw) if speed < 0.0 else pose.yaw
        remaining, _ = position.to(goal.point)
        slowed = math.copysign(min(abs(speed), self._approach_speed(remaining, goal)), speed)
        error = heading_error(yaw, bearing)
        if self._min_turn_radius:
            slowed = speed if abs(error) > MAX_DRIVING_ERROR else slowed
            self._drives_on = self._is_inside_curve(position, yaw, error, goal)
            error = 0.0 if self._drives_on else error
        is_narrow = goal.path_tolerance is not None and goal.path_tolerance < NARROW_PATH
        most = NARROW_DRIVING_ERROR if is_narrow else MAX_DRIVING_ERROR
        return steer_to_heading(error, slowed, self._max_turn_rate, self._min_turn_radius, max_driving_error=most)

    def _is_inside_curve(self, position: PlanarPoint, yaw: float, error: float, goal: CourseGoal) -> bool:
        """True if the narrowest curve towards the goal does not reach it."""
        side = yaw + math.copysign(math.pi / 2.0, error)
        radius = self._min_turn_radius
        centre = PlanarPoint(position.x + radius * math.cos(side), position.y + radius * math.sin(side))
        distance, _ = centre.to(goal.point)
        return distance < radius * (CURVE_MARGIN if self._drives_on else 1.0)

    def _approach_speed(self, remaining: float, goal: CourseGoal) -> float:
        """The speed from which half of the chassis' deceleration suffices to slow down."""
        passing = min(PASSING_SPEED, max(FINAL_SPEED, goal.tolerance / PASSING_TIME))
        final = FINAL_SPEED if goal.is_last or goal.heading is not None else passing
        return math.sqrt(final**2 + self._deceleration * remaining)

    def _align(self, yaw: float, heading: float | None) -> PlanarVelocity | None:
        if self._min_turn_radius or heading is None or abs(error := heading_error(yaw, heading)) < HEADING_TOLERANCE:
            return None
        return steer_to_heading(error, 0.0, self._max_turn_rate)


def is_reached(goal: CourseGoal, leg: Leg, position: PlanarPoint) -> bool:
    """Within the tolerance; at the last waypoint also abeam of the point or within `STOP_TOLERANCE` of it.

    A robot that is past a waypoint, within the tolerance of the path, does not turn back for it.
    """
    distance, _ = position.to(goal.point)
    if distance > goal.tolerance:
        return goal.path_tolerance is not None and distance <= goal.path_tolerance and leg.passed(position)
    return not goal.is_last or distance <= STOP_TOLERANCE or leg.passed(position)
