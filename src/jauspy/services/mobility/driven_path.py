"""The path that a vehicle has driven, thinned and bounded, so that it can be driven back (ADR 183)."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.geometry.poses import PlanarPoint

MAX_POINTS: Final = 4096
"""Points that are kept; the oldest is forgotten first. At least 800 m of winding path, up to 4 km of straight one."""
SPACING: Final = 0.05
"""Metres between two positions that are looked at."""
MAX_SEGMENT: Final = 1.0
"""Metres between two points, at most."""
TOLERANCE: Final = 0.03
"""Metres by which the straight line between two points may miss where the vehicle was."""
JOINT_STEP: Final = 0.05
"""Radians or metres by which a joint has to move for another point."""
SPEED_STEP: Final = 0.15
"""m/s by which the speed has to change for another point."""


@dataclass(frozen=True, slots=True)
class PathPoint:
    """A point of the path, in the world, in JAUS axes; the rest tells how it was reached from the point before."""

    position: PlanarPoint
    backward: bool = False
    """True if the vehicle drove backward."""
    speed: float = 0.0
    """Fastest, in m/s."""
    tilted: bool = False
    """True on a slope or stairs."""
    joints: tuple[float, ...] = ()
    """Positions of the joints that carry tracks, such as flippers, in rad or m."""


class DrivenPath:
    """The points where a vehicle was, oldest first.

    Of each straight piece only the ends are kept, of a curve as many points as its shape needs. A vehicle that stands
    or turns on the spot adds nothing, unless its joints move.
    """

    def __init__(self, max_points: int = MAX_POINTS) -> None:
        self._points: deque[PathPoint] = deque(maxlen=max_points)
        self._open: list[PathPoint] = []
        """Positions since the last point, on a straight line with it: at most `MAX_SEGMENT` / `SPACING`."""

    def __len__(self) -> int:
        return len(self._points) + bool(self._open)

    @property
    def points(self) -> tuple[PathPoint, ...]:
        """The points, oldest first."""
        return (*self._points, self._segment()) if self._open else tuple(self._points)

    def record(self, point: PathPoint) -> None:
        """Add where the vehicle is now."""
        if not self._points:
            self._points.append(point)
            return
        newest = self._open[-1] if self._open else self._points[-1]
        distance, _ = newest.position.to(point.position)
        if _differ(newest.joints, point.joints):
            self._end_segment()
            self._add_joints(replace(point, position=newest.position) if distance < SPACING else point)
        elif distance >= SPACING:
            if self._open and self._needs_point(point):
                self._end_segment()
            self._open.append(point)

    def end_at(self, point: PathPoint) -> None:
        """Make this the last point, however near it is to the one before."""
        self._end_segment()
        if not self._points or self._points[-1].position.to(point.position)[0] > 0.0:
            self._points.append(point)

    def cut(self, count: int, end: PathPoint) -> None:
        """Keep the oldest `count` points, and let the path end here."""
        self._open.clear()
        while len(self._points) > count:
            self._points.pop()
        self.end_at(end)

    def _needs_point(self, point: PathPoint) -> bool:
        start, newest = self._points[-1].position, self._open[-1]
        length, _ = start.to(point.position)
        return (
            point.backward != newest.backward
            or point.tilted != newest.tilted
            or abs(point.speed - self._open[0].speed) > SPEED_STEP
            or length > MAX_SEGMENT
            or any(distance_to(start, point.position, passed.position) > TOLERANCE for passed in self._open)
        )

    def _segment(self) -> PathPoint:
        return replace(
            self._open[-1],
            speed=max(point.speed for point in self._open),
            tilted=any(point.tilted for point in self._open),
        )

    def _end_segment(self) -> None:
        if self._open:
            self._points.append(self._segment())
            self._open.clear()

    def _add_joints(self, point: PathPoint) -> None:
        """Add a point for joints that moved; of a vehicle that stands, the first and the last position count."""
        points = self._points
        if len(points) > 1 and points[-1].position == points[-2].position == point.position:
            points.pop()
        points.append(point)


def _differ(some: Sequence[float], others: Sequence[float]) -> bool:
    return any(abs(a - b) > JOINT_STEP for a, b in zip(some, others, strict=False))


def distance_to(start: PlanarPoint, end: PlanarPoint, point: PlanarPoint) -> float:
    """Metres from a point to the straight line between two others."""
    length, direction = start.to(end)
    dx, dy = point.x - start.x, point.y - start.y
    along = dx * math.cos(direction) + dy * math.sin(direction)
    nearest = min(length, max(0.0, along))
    return math.hypot(dx - nearest * math.cos(direction), dy - nearest * math.sin(direction))
