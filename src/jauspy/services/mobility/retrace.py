"""Retracing: the way back along a driven path, and the course that follows it (docs/adr/0183-lost-links.md)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from jauspy.geometry.poses import PlanarPoint, Pose
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.courses import (
    FINAL_SPEED,
    HEADING_TOLERANCE,
    LOOK_AHEAD_TIME,
    MAX_DRIVING_ERROR,
    STOP_TOLERANCE,
    Leg,
    heading_error,
    reversed_yaw,
    steer_to_heading,
)
from jauspy.services.mobility.driven_path import PathPoint, distance_to
from jauspy.services.mobility.velocity_control import STANDSTILL, PlanarVelocity

LOOK_AHEAD: Final = 0.35
"""Metres ahead on the path that the vehicle steers for when it is slow; less than to a waypoint, for narrow corners."""
SHARPEST_CURVE: Final = 0.9
"""Radians between two legs above which the vehicle stops and turns on the spot."""
LOWEST_SPEED: Final = 0.2
"""m/s at which a piece is driven back that was driven slower."""
MAX_DEVIATION: Final = 1.0
"""Metres from the path at which the vehicle has lost it."""
MAX_WAIT: Final = 250
"""Steps of the pilot, of 20 ms, for which the vehicle waits for its flippers."""


@dataclass(frozen=True, slots=True)
class RetraceLeg:
    """A straight piece of the way back."""

    line: Leg
    backward: bool
    """True if the vehicle drives this piece backward."""
    speed: float
    """m/s on the way out."""
    tilted: bool
    joints: tuple[float, ...]
    """Positions of the flippers at its end."""
    kept: int
    """Points of the path that are older than this piece."""

    @property
    def length(self) -> float:
        """Metres."""
        return self.line.start.to(self.line.end)[0]


def way_back(points: Sequence[PathPoint], *, nose_first: bool = False) -> list[RetraceLeg]:
    """The way from the newest of these points to the oldest.

    The vehicle keeps the headings of the way out, and so drives backward where it drove forward; with `nose_first` it
    turns about.
    """
    return [
        RetraceLeg(
            line=Leg(newer.position, older.position),
            backward=not (nose_first or newer.backward),
            speed=newer.speed,
            tilted=newer.tilted,
            joints=older.joints,
            kept=index + 1,
        )
        for index, (older, newer) in reversed(list(enumerate(pairwise(points))))
    ]


def length_of(legs: Sequence[RetraceLeg]) -> float:
    """Metres of a way."""
    return sum(leg.length for leg in legs)


def shortened(legs: Sequence[RetraceLeg], distance: float) -> list[RetraceLeg]:
    """The first metres of a way."""
    found: list[RetraceLeg] = []
    for leg in legs:
        if distance <= 0.0:
            break
        if leg.length <= distance:
            found.append(leg)
        else:
            end = leg.line.ahead(leg.line.start, distance)
            # the flippers stay as they are in the middle of a piece
            joints = found[-1].joints if found else ()
            found.append(RetraceLeg(Leg(leg.line.start, end), leg.backward, leg.speed, leg.tilted, joints, leg.kept))
        distance -= leg.length
    return found


def distance_abeam(legs: Sequence[RetraceLeg], point: PlanarPoint) -> float:
    """Metres along a way to where it comes nearest to a point."""
    nearest, best, covered = math.inf, 0.0, 0.0
    for leg in legs:
        length, direction = leg.line.start.to(leg.line.end)
        dx, dy = point.x - leg.line.start.x, point.y - leg.line.start.y
        along = min(length, max(0.0, dx * math.cos(direction) + dy * math.sin(direction)))
        if (miss := distance_to(leg.line.start, leg.line.end, point)) < nearest:
            nearest, best = miss, covered + along
        covered += length
    return best


def distance_to_circle(legs: Sequence[RetraceLeg], centre: PlanarPoint, radius: float) -> float:
    """Metres along a way until it enters a circle; its whole length if it does not."""
    covered = 0.0
    for leg in legs:
        length, direction = leg.line.start.to(leg.line.end)
        dx, dy = leg.line.start.x - centre.x, leg.line.start.y - centre.y
        if math.hypot(dx, dy) <= radius:
            return covered
        half = dx * math.cos(direction) + dy * math.sin(direction)
        root = half * half - (dx * dx + dy * dy - radius * radius)
        if root >= 0.0 and 0.0 <= (entry := -half - math.sqrt(root)) <= length:
            return covered + entry
        covered += length
    return covered


class RetraceCourse:
    """Along the legs of a way back; slower where the vehicle has to stop, which it does to reverse or at sharp corners.

    `max_speed`: m/s; 0 is that of the way out, which is never exceeded on slopes. `path_tolerance`: metres from the
    path at which the course ends, with `lost` true. `move_joints` commands the positions of the flippers, and returns
    whether they have reached them.
    """

    limits: None = None

    def __init__(
        self,
        legs: Sequence[RetraceLeg],
        chassis: Chassis,
        *,
        max_speed: float = 0.0,
        path_tolerance: float = MAX_DEVIATION,
        move_joints: Callable[[tuple[float, ...]], bool] = lambda _: True,
    ) -> None:
        self._legs = list(legs)
        self._chassis = chassis
        self._max_speed = max_speed
        self._path_tolerance = path_tolerance
        self._move_joints = move_joints
        self._leg = 0
        self._waited = 0
        self._total = self._left = length_of(legs)
        self._stops = [_stops_between(leg, after) for leg, after in zip(legs, [*legs[1:], None], strict=True)]
        self._beyond, self._to_stop = _distances(legs, self._stops)
        self.lost = False
        """True if the vehicle has left the path."""
        self.reorients = False
        """True while the vehicle turns on the spot before it can follow the path."""

    @property
    def completed(self) -> float:
        """Share of the way that is driven, 0..1."""
        return 1.0 - self._left / self._total if self._total else 1.0

    @property
    def distance_left(self) -> float:
        """Metres."""
        return self._left

    @property
    def kept(self) -> int:
        """Points of the path that are not driven back yet."""
        if self._leg < len(self._legs):
            return self._legs[self._leg].kept
        return self._legs[-1].kept if self._legs else 0

    def steer(self, pose: Pose) -> PlanarVelocity | None:
        """The velocity wanted at a pose; None at the end of the way, or off the path."""
        position = PlanarPoint(pose.x, pose.y)
        while self._leg < len(self._legs):
            leg = self._legs[self._leg]
            if leg.joints and not self._move_joints(leg.joints) and self._waited < MAX_WAIT:
                self._waited += 1
                return STANDSTILL
            if not self._is_done(leg, position):
                return self._follow(leg, pose, position)
            self._leg += 1
            self._waited = 0
        self._left = 0.0
        return None

    def _is_done(self, leg: RetraceLeg, position: PlanarPoint) -> bool:
        if leg.length == 0.0 or leg.line.passed(position):
            return True
        return self._stops[self._leg] and position.to(leg.line.end)[0] <= STOP_TOLERANCE

    def _follow(self, leg: RetraceLeg, pose: Pose, position: PlanarPoint) -> PlanarVelocity | None:
        if distance_to(leg.line.start, leg.line.end, position) > self._path_tolerance:
            self.lost = True
            return None
        to_stop = self._until_stop(position)
        speed = self._speed(leg, to_stop)
        _, bearing = position.to(self._ahead(position, max(LOOK_AHEAD, LOOK_AHEAD_TIME * speed)))
        error = heading_error(reversed_yaw(pose.yaw) if leg.backward else pose.yaw, bearing)
        radius = self._chassis.min_turn_radius
        self.reorients = not radius and abs(error) > MAX_DRIVING_ERROR
        if radius and abs(error) < HEADING_TOLERANCE:
            error = 0.0
        return steer_to_heading(error, -speed if leg.backward else speed, self._chassis.max_turn_rate, radius)

    def _speed(self, leg: RetraceLeg, to_stop: float) -> float:
        as_before = max(LOWEST_SPEED, leg.speed)
        speed = self._max_speed or as_before
        if leg.tilted:
            speed = min(speed, as_before)
        return min(speed, math.sqrt(FINAL_SPEED**2 + self._chassis.deceleration * to_stop))

    def _until_stop(self, position: PlanarPoint) -> float:
        """Metres to where the vehicle stops next; counts what is left of the whole way, too."""
        to_end = position.to(self._legs[self._leg].line.end)[0]
        self._left = min(self._left, to_end + self._beyond[self._leg])
        return to_end + self._to_stop[self._leg]

    def _ahead(self, position: PlanarPoint, distance: float) -> PlanarPoint:
        """The point of the way to steer for, not beyond the next stop."""
        line = self._legs[self._leg].line
        for index in range(self._leg, len(self._legs)):
            line = self._legs[index].line
            start = position if index == self._leg else line.start
            left = max(0.0, line.start.to(line.end)[0] - line.covered(start))
            if distance <= left or self._stops[index]:
                return line.ahead(start, distance)
            distance -= left
        return line.end


def _stops_between(leg: RetraceLeg, after: RetraceLeg | None) -> bool:
    """True if the vehicle stops between these legs: to reverse, turn on the spot or wait for flippers."""
    if after is None or after.length == 0.0 or leg.backward != after.backward:
        return True
    turn = heading_error(leg.line.start.to(leg.line.end)[1], after.line.start.to(after.line.end)[1])
    return leg.length > 0.0 and abs(turn) > SHARPEST_CURVE


def _distances(legs: Sequence[RetraceLeg], stops: Sequence[bool]) -> tuple[list[float], list[float]]:
    """Metres from the end of each leg to the end of the way, and to the next stop."""
    beyond, to_stop = [0.0] * len(legs), [0.0] * len(legs)
    for index in range(len(legs) - 2, -1, -1):
        length = legs[index + 1].length
        beyond[index] = beyond[index + 1] + length
        to_stop[index] = 0.0 if stops[index] else to_stop[index + 1] + length
    return beyond, to_stop
