"""One straight leg to a waypoint, followed by looking ahead along it."""

from __future__ import annotations

import math
from dataclasses import dataclass

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
