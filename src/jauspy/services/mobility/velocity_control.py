"""Closed-loop velocity control of a skid-steered chassis: wanted and measured motion to efforts."""

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


@dataclass(frozen=True, slots=True)
class AxisGains:
    """Of one axis. Efforts are fractions of the full one; the rest is in m/s, or rad/s, and seconds."""

    forward: float
    """Effort per unit of wanted velocity: what the drive needs by and large."""
    breakaway: float
    """Effort that only overcomes friction; tracks that skid sideways need some before anything turns."""
    proportional: float
    integral: float


SPEED_GAINS = AxisGains(forward=0.64, breakaway=0.01, proportional=0.15, integral=0.6)
TURN_RATE_GAINS = AxisGains(forward=0.27, breakaway=0.06, proportional=0.05, integral=0.4)
"""Between those of inc1 as it is simulated with and without physics; the integral makes up for the difference."""

BREAKAWAY_BAND = 0.1
"""Velocity (m/s, rad/s) from which on the whole breakaway effort is added, so that it does not jump at zero."""


class AxisControl:
    """PI control with feed-forward; the integral does not grow while the effort is at its limit."""

    def __init__(self, gains: AxisGains) -> None:
        self._gains = gains
        self._integral = 0.0

    def reset(self) -> None:
        """Forget what was learned about the resistance."""
        self._integral = 0.0

    def effort(self, wanted: float, measured: float, dt: float) -> float:
        """The effort, -1..1, for the next `dt` seconds."""
        gains, error = self._gains, wanted - measured
        feed_forward = gains.forward * wanted + gains.breakaway * clamp(wanted / BREAKAWAY_BAND)
        integral = self._integral + gains.integral * error * dt
        effort = feed_forward + gains.proportional * error + integral
        if abs(effort) <= 1.0 or effort * error < 0.0:
            self._integral = integral
        return clamp(effort)


class VelocityControl:
    """Both axes of the chassis."""

    def __init__(self) -> None:
        self._speed, self._turn = AxisControl(SPEED_GAINS), AxisControl(TURN_RATE_GAINS)

    def reset(self) -> None:
        """Start anew."""
        self._speed.reset()
        self._turn.reset()

    def efforts(self, wanted: PlanarVelocity, measured: PlanarVelocity, dt: float) -> tuple[float, float]:
        """Efforts forward and to the right, -1..1."""
        return (
            self._speed.effort(wanted.speed, measured.speed, dt),
            self._turn.effort(wanted.turn_rate, measured.turn_rate, dt),
        )


def clamp(value: float, most: float = 1.0) -> float:
    """The value within -most..most."""
    return min(most, max(-most, value))
