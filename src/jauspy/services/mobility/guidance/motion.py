"""What guidance asks the chassis to do, and how fast that may change."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PlanarVelocity:
    """Speed forward in m/s, and turn rate in rad/s, positive to the right (JAUS: z down)."""

    speed: float = 0.0
    turn_rate: float = 0.0


STANDSTILL = PlanarVelocity()


@dataclass(frozen=True, slots=True)
class AccelerationLimits:
    """How fast a motion may change: m/s^2 away from and towards standstill, and the same about z in rad/s^2."""

    acceleration: float
    deceleration: float
    turn_acceleration: float
    turn_deceleration: float


def ramped(motion: PlanarVelocity, wanted: PlanarVelocity, limits: AccelerationLimits, dt: float) -> PlanarVelocity:
    """The motion `dt` seconds later, on its way to the wanted one."""
    return PlanarVelocity(
        _ramp(motion.speed, wanted.speed, limits.acceleration * dt, limits.deceleration * dt),
        _ramp(motion.turn_rate, wanted.turn_rate, limits.turn_acceleration * dt, limits.turn_deceleration * dt),
    )


def _ramp(value: float, wanted: float, up: float, down: float) -> float:
    """Slower by at most `down`, faster by at most `up`; a change of direction stops at zero first."""
    if value * wanted < 0.0:
        wanted = 0.0
    step = up if abs(wanted) > abs(value) else down
    return wanted if abs(wanted - value) <= step else value + math.copysign(step, wanted - value)
