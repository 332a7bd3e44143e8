"""Closed-loop velocity control of a skid-steered chassis: wanted and measured velocity to efforts."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PlanarVelocity:
    """Forward speed in m/s, and turn rate in rad/s, positive to the right (JAUS: z down)."""

    speed: float = 0.0
    turn_rate: float = 0.0

    def clamped(self, max_speed: float, max_turn_rate: float) -> PlanarVelocity:
        """Each axis limited to what the chassis can do."""
        return PlanarVelocity(clamp(self.speed, max_speed), clamp(self.turn_rate, max_turn_rate))


STANDSTILL = PlanarVelocity()


@dataclass(frozen=True, slots=True)
class AccelerationLimits:
    """Away from and towards standstill: m/s^2, and rad/s^2 about z."""

    acceleration: float
    deceleration: float
    turn_acceleration: float
    turn_deceleration: float


def ramped(velocity: PlanarVelocity, wanted: PlanarVelocity, limits: AccelerationLimits, dt: float) -> PlanarVelocity:
    """The velocity after `dt` seconds, within the limits, on the way to the wanted one."""
    return PlanarVelocity(
        _ramp(velocity.speed, wanted.speed, limits.acceleration * dt, limits.deceleration * dt),
        _ramp(velocity.turn_rate, wanted.turn_rate, limits.turn_acceleration * dt, limits.turn_deceleration * dt),
    )


def _ramp(value: float, wanted: float, up: float, down: float) -> float:
    """Grows by at most `up` or falls by at most `down`; a change of sign stops at zero first."""
    if value * wanted < 0.0:
        wanted = 0.0
    step = up if abs(wanted) > abs(value) else down
    return wanted if abs(wanted - value) <= step else value + math.copysign(step, wanted - value)


@dataclass(frozen=True, slots=True)
class AxisGains:
    """Gains of one axis: efforts as fractions of the full effort, per m/s or rad/s, and seconds."""

    forward: float
    """Feed-forward: effort per unit of wanted velocity."""
    breakaway: float
    """Feed-forward against static friction, which is large for tracks that skid sideways."""
    proportional: float
    integral: float


SPEED_GAINS = AxisGains(forward=0.64, breakaway=0.01, proportional=0.15, integral=0.6)
TURN_RATE_GAINS = AxisGains(forward=0.27, breakaway=0.06, proportional=0.05, integral=0.4)
"""Between the best gains for inc1 with and without physics; the integral compensates the difference."""

BREAKAWAY_BAND = 0.1
"""Velocity (m/s, rad/s) below which the breakaway effort is proportional, so that it does not jump at zero."""


class AxisControl:
    """PI control with feed-forward and anti-windup."""

    def __init__(self, gains: AxisGains) -> None:
        self._gains = gains
        self._integral = 0.0

    def reset(self) -> None:
        """Clear the integral."""
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
    """Speed and turn rate of the chassis."""

    def __init__(self) -> None:
        self._speed, self._turn = AxisControl(SPEED_GAINS), AxisControl(TURN_RATE_GAINS)

    def reset(self) -> None:
        """Clear both integrals."""
        self._speed.reset()
        self._turn.reset()

    def efforts(self, wanted: PlanarVelocity, measured: PlanarVelocity, dt: float) -> tuple[float, float]:
        """Efforts forward and to the right, -1..1."""
        return (
            self._speed.effort(wanted.speed, measured.speed, dt),
            self._turn.effort(wanted.turn_rate, measured.turn_rate, dt),
        )


def clamp(value: float, limit: float = 1.0) -> float:
    """The value limited to -limit..limit."""
    return min(limit, max(-limit, value))
