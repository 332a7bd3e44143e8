"""How long a joint takes for a way, when its speed rises, stays and falls evenly; and the speed for a given time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

ROUNDING: Final = 1e-6
"""Seconds by which a duration may be too short."""


@dataclass(frozen=True, slots=True)
class MotionLimits:
    """Limits of a joint's motion: rad/s and rad/s^2, or m/s and m/s^2; infinite where there is none."""

    speed: float = math.inf
    acceleration: float = math.inf
    deceleration: float = math.inf

    @property
    def _ramps(self) -> float:
        """Seconds that both ramps take for a unit of speed, halved: what they add to the time at that speed."""
        return (1.0 / self.acceleration + 1.0 / self.deceleration) / 2.0

    def least_duration(self, way: float) -> float:
        """Seconds that the joint takes at least for a way in radians or metres."""
        way, ramps = abs(way), self._ramps
        if not way:
            return 0.0
        if not ramps:
            return way / self.speed
        top = min(self.speed, math.sqrt(way / ramps))
        return way / top + ramps * top

    def speed_for(self, way: float, duration: float) -> float | None:
        """The speed with which the joint takes `duration` seconds for a way; None if it cannot be as fast."""
        way, ramps = abs(way), self._ramps
        if duration < self.least_duration(way) - ROUNDING or not duration:
            return None
        if not ramps:
            return way / duration
        speed = (duration - math.sqrt(max(0.0, duration * duration - 4.0 * ramps * way))) / (2.0 * ramps)
        return min(speed, self.speed)
