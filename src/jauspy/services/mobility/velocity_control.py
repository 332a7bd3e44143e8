"""Closed-loop velocity control of a chassis: wanted and measured velocity to efforts."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from jauspy.platform.chassis import SPEED_ON_GROUND, Chassis


@dataclass(frozen=True, slots=True)
class PlanarVelocity:
    """Speed forward and to the right in m/s, and turn rate in rad/s, positive to the right (JAUS: z down)."""

    speed: float = 0.0
    turn_rate: float = 0.0
    sideways: float = 0.0

    def clamped(self, max_speed: float, max_turn_rate: float) -> PlanarVelocity:
        """Each axis limited to what the chassis can do."""
        speed, sideways = clamp(self.speed, max_speed), clamp(self.sideways, max_speed)
        return PlanarVelocity(speed, clamp(self.turn_rate, max_turn_rate), sideways)

    def feasible(self, chassis: Chassis) -> PlanarVelocity:
        """The nearest velocity that the chassis can drive: with limited curvature, sideways only if possible."""
        turn_rate = self.turn_rate
        if chassis.min_turn_radius:
            turn_rate = clamp(turn_rate, abs(self.speed) / chassis.min_turn_radius)
        return PlanarVelocity(self.speed, turn_rate, self.sideways if chassis.moves_sideways else 0.0)


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
        _ramp(velocity.sideways, wanted.sideways, limits.acceleration * dt, limits.deceleration * dt),
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


SPEED_GAINS = AxisGains(forward=0.53, breakaway=0.01, proportional=0.15, integral=0.6)
TURN_RATE_GAINS = AxisGains(forward=0.27, breakaway=0.06, proportional=0.05, integral=0.4)
"""Mean of the best gains for inc1 with and without physics; the integral compensates the difference."""

SKIDDING_GAINS = AxisGains(forward=0.25, breakaway=0.12, proportional=0.15, integral=0.8)
"""Turn rate of wheels that skid, which rub more than tracks do."""

BREAKAWAY_BAND = 0.1
"""Velocity (m/s, rad/s) below which the breakaway effort is proportional, so that it does not jump at zero."""
FADE_TIME = 1.5
"""Seconds in which the integral of the turn rate fades while a robot is to drive straight on.

With one track on a kerb it would stay as it was: the robot does not turn, while one track slips and the other rests.
"""


class AxisControl:
    """PI control with feed-forward and anti-windup; the integral fades in `fade_time` seconds while 0 is wanted."""

    def __init__(self, gains: AxisGains, *, fade_time: float = math.inf) -> None:
        self._gains = gains
        self._fade_time = fade_time
        self._integral = 0.0

    def reset(self) -> None:
        """Clear the integral."""
        self._integral = 0.0

    def effort(self, wanted: float, measured: float, dt: float) -> float:
        """The effort, -1..1, for the next `dt` seconds."""
        gains, error = self._gains, wanted - measured
        feed_forward = gains.forward * wanted + gains.breakaway * clamp(wanted / BREAKAWAY_BAND)
        if abs(wanted) < BREAKAWAY_BAND:
            self._integral *= math.exp(-dt / self._fade_time)
        integral = self._integral + gains.integral * error * dt
        effort = feed_forward + gains.proportional * error + integral
        if abs(effort) <= 1.0 or effort * error < 0.0:
            self._integral = integral
        return clamp(effort)


@dataclass(frozen=True, slots=True)
class Efforts:
    """-1..1: forward, turning to the right (the steering of a chassis that steers), and to the right."""

    forward: float
    right_turn: float
    sideways: float


class VelocityControl:
    """Speed and turn rate of the chassis."""

    def __init__(self, chassis: Chassis) -> None:
        self._chassis = chassis
        speed, turn = SPEED_GAINS, TURN_RATE_GAINS
        if chassis.wheel_radius:
            speed, turn = replace(speed, forward=SPEED_ON_GROUND / chassis.max_speed), SKIDDING_GAINS
        if chassis.moves_sideways:
            lever = (chassis.wheel_base + chassis.track_separation) / 2.0
            turn = replace(turn, forward=lever / chassis.max_speed, breakaway=0.01)
        self._speed, self._sideways = AxisControl(speed), AxisControl(speed)
        self._turn = AxisControl(turn, fade_time=FADE_TIME)

    def reset(self) -> None:
        """Clear the integrals."""
        for axis in (self._speed, self._turn, self._sideways):
            axis.reset()

    def efforts(self, wanted: PlanarVelocity, measured: PlanarVelocity, dt: float) -> Efforts:
        """The efforts for the next `dt` seconds."""
        forward = self._speed.effort(wanted.speed, measured.speed, dt)
        if self._chassis.min_turn_radius:
            return Efforts(forward, self._steering(wanted), 0.0)
        turn = self._turn.effort(wanted.turn_rate, measured.turn_rate, dt)
        if not self._chassis.moves_sideways:
            return Efforts(forward, turn, 0.0)
        return Efforts(forward, turn, self._sideways.effort(wanted.sideways, measured.sideways, dt))

    def _steering(self, wanted: PlanarVelocity) -> float:
        """The angle for the curvature of the wanted velocity, as a fraction of the greatest angle."""
        if not wanted.speed:
            return 0.0
        tangent = (
            wanted.turn_rate / wanted.speed * self._chassis.min_turn_radius * math.tan(self._chassis.steering_angle)
        )
        return clamp(math.atan(tangent) / self._chassis.steering_angle)


def clamp(value: float, limit: float = 1.0) -> float:
    """The value limited to -limit..limit."""
    return min(limit, max(-limit, value))
