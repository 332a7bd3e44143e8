"""The kinds of course that the pilot can follow; each says, again and again, how to move on."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol

from jauspy.geometry.poses import Pose
from jauspy.services.mobility.velocity_control import STANDSTILL, AccelerationLimits, PlanarVelocity, clamp

TURN_GAIN = 1.8
"""Turn rate per heading error, 1/s."""
MAX_DRIVING_ERROR = 0.8
"""Heading error, rad, from which on the robot only turns."""


def steer_to_heading(error: float, speed: float, max_turn_rate: float) -> PlanarVelocity:
    """The motion that takes the heading error (rad, positive when the heading lies to the right) to zero.

    The speed, negative for backward, fades as the error grows: a curve that is driven slowly is a narrow one.
    """
    fade = max(0.0, 1.0 - (error / MAX_DRIVING_ERROR) ** 2)
    return PlanarVelocity(speed * fade, clamp(TURN_GAIN * error, max_turn_rate))


def heading_error(heading: float, wanted: float) -> float:
    """The shorter way round from one heading to another, -pi..pi, positive to the right."""
    return math.remainder(wanted - heading, math.tau)


HEADING_TOLERANCE: Final = 0.03
"""Radians from a heading at which a robot that shall stand there stops turning."""


class Course(Protocol):
    """Where to go."""

    @property
    def limits(self) -> AccelerationLimits | None:
        """How fast the motion may change; None: as the chassis likes it."""
        ...

    def steer(self, pose: Pose, /) -> PlanarVelocity | None:
        """The motion wanted at a pose (JAUS axes, world); None when there is nothing more to do."""
        ...


@dataclass(frozen=True, slots=True)
class VelocityCourse:
    """A motion that is given as such."""

    motion: PlanarVelocity
    limits: AccelerationLimits

    def steer(self, _: Pose) -> PlanarVelocity:
        """Always the same."""
        return self.motion


@dataclass(frozen=True, slots=True)
class VectorCourse:
    """A heading in the world, which may change with its frame, at a speed (m/s, negative backward)."""

    heading: Callable[[], float]
    speed: float
    max_turn_rate: float
    limits: None = None

    def steer(self, pose: Pose) -> PlanarVelocity:
        """Towards the heading, without an end."""
        error = heading_error(pose.yaw, self.heading())
        if self.speed == 0.0 and abs(error) < HEADING_TOLERANCE:
            return STANDSTILL
        return steer_to_heading(error, self.speed, self.max_turn_rate)


@dataclass(frozen=True, slots=True)
class Halt:
    """Slows down and waits."""

    limits: None = None

    def steer(self, _: Pose) -> PlanarVelocity:
        """Stand still."""
        return STANDSTILL


def reversed_yaw(yaw: float) -> float:
    """The direction in which a robot drives that drives backward."""
    return math.remainder(yaw + math.pi, math.tau)


MIN_LOOK_AHEAD = 0.6
"""Metres ahead on the leg that the robot steers for when it is slow."""
LOOK_AHEAD_TIME = 0.7
"""Seconds of driving ahead when it is fast."""


@dataclass(frozen=True, slots=True)
class PlanarPoint:
    """A place on the ground, metres."""

    x: float
    y: float

    def to(self, other: PlanarPoint) -> tuple[float, float]:
        """Distance (m) and direction (rad, from x towards y) of another point."""
        return math.hypot(other.x - self.x, other.y - self.y), math.atan2(other.y - self.y, other.x - self.x)


@dataclass(frozen=True, slots=True)
class Leg:
    """From where the robot was to where it shall be."""

    start: PlanarPoint
    end: PlanarPoint

    def ahead(self, here: PlanarPoint, look_ahead: float) -> PlanarPoint:
        """The point of the leg to steer for: as far along as the robot is, and `look_ahead` metres more."""
        length, direction = self.start.to(self.end)
        covered = self._covered(here, direction)
        along = min(length, max(0.0, covered) + look_ahead)
        return PlanarPoint(self.start.x + along * math.cos(direction), self.start.y + along * math.sin(direction))

    def passed(self, here: PlanarPoint) -> bool:
        """True when the robot is abeam of the end, or beyond it."""
        length, direction = self.start.to(self.end)
        return self._covered(here, direction) >= length

    def _covered(self, here: PlanarPoint, direction: float) -> float:
        return (here.x - self.start.x) * math.cos(direction) + (here.y - self.start.y) * math.sin(direction)


def look_ahead(speed: float, path_tolerance: float | None) -> float:
    """Metres to look ahead at that speed; a narrow path is followed more closely."""
    wanted = max(MIN_LOOK_AHEAD, LOOK_AHEAD_TIME * abs(speed))
    return wanted if path_tolerance is None else min(wanted, max(0.2, path_tolerance))


DEFAULT_TOLERANCE: Final = 0.3
"""Metres within which a waypoint counts as reached that says nothing about it."""
STOP_TOLERANCE: Final = 0.1
"""Metres up to which a waypoint where the robot shall stop is approached, whatever its tolerance."""
FINAL_SPEED: Final = 0.1
"""Speed of the last centimetres, m/s."""
PASSING_SPEED: Final = 0.4
"""Speed, m/s, at which a waypoint is passed when there are more."""


@dataclass(frozen=True, slots=True)
class Goal:
    """A waypoint in the world, JAUS axes: metres and radians, None for what it leaves open."""

    point: PlanarPoint
    heading: float | None = None
    tolerance: float = DEFAULT_TOLERANCE
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
        self._start: PlanarPoint | None = None
        self._reached = False

    def steer(self, pose: Pose) -> PlanarVelocity | None:
        """The motion at that pose; None once the waypoint is reached and the heading, too, if it has one."""
        goal, speed = self._goal(), self._speed()
        here = PlanarPoint(pose.x, pose.y)
        self._start = self._start or here
        if speed == 0.0:
            return STANDSTILL
        leg = Leg(self._start, goal.point)
        self._reached = self._reached or is_reached(goal, leg, here)
        if self._reached:
            return self._align(pose.yaw, goal.heading)
        return self._drive(pose, leg, goal, speed)

    def _drive(self, pose: Pose, leg: Leg, goal: Goal, speed: float) -> PlanarVelocity:
        here = PlanarPoint(pose.x, pose.y)
        _, bearing = here.to(leg.ahead(here, look_ahead(speed, goal.path_tolerance)))
        yaw = reversed_yaw(pose.yaw) if speed < 0.0 else pose.yaw
        remaining, _ = here.to(goal.point)
        slowed = min(abs(speed), self._approach(remaining, goal))
        return steer_to_heading(heading_error(yaw, bearing), math.copysign(slowed, speed), self._max_turn_rate)

    def _approach(self, remaining: float, goal: Goal) -> float:
        """The speed from which the robot can still slow down; half of its deceleration is kept in reserve."""
        final = FINAL_SPEED if goal.is_last or goal.heading is not None else PASSING_SPEED
        return math.sqrt(final**2 + self._deceleration * remaining)

    def _align(self, yaw: float, heading: float | None) -> PlanarVelocity | None:
        if heading is None or abs(error := heading_error(yaw, heading)) < HEADING_TOLERANCE:
            return None
        return steer_to_heading(error, 0.0, self._max_turn_rate)


def is_reached(goal: Goal, leg: Leg, here: PlanarPoint) -> bool:
    """Within the tolerance; where the robot stops it goes on, as near as it gets, to within `STOP_TOLERANCE` of the point."""
    distance, _ = here.to(goal.point)
    if distance > goal.tolerance:
        return False
    return not goal.is_last or distance <= STOP_TOLERANCE or leg.passed(here)
