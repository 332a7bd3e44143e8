"""Limits of joints' motions, as in the motion profile (AS6057), and speeds with which motions take a given time."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError
from jauspy.messages.manipulator import SetJointMotionProfile

MIN_SPEED: Final = 0.002
"""rad/s or m/s that a motion profile has at least: zero would mean no limit."""
DURATION_ROUNDING: Final = 1e-6
"""Seconds by which a duration may be shorter than possible (rounding)."""
LEAST_SHARE: Final = 0.02
"""Part of its limits that a joint keeps on a straight way of others: with less it could not hold itself."""


@dataclass(frozen=True, slots=True)
class MotionLimits:
    """Limits of a joint's motion: rad/s and rad/s^2, or m/s and m/s^2; infinite where there is none.

    The speed profile is a trapezoid.
    """

    speed: float = math.inf
    acceleration: float = math.inf
    deceleration: float = math.inf

    def check(self) -> None:
        """Raise `ConfigError` unless all are above zero."""
        for name in ("speed", "acceleration", "deceleration"):
            value = getattr(self, name)
            check_number(value, name)
            if not value > 0:
                raise ConfigError(f"{name} {value:g} must be above 0; math.inf is no limit")

    @property
    def _ramps(self) -> float:
        """Seconds that both ramps take for a unit of speed, halved: what they add to the time at that speed."""
        return (1.0 / self.acceleration + 1.0 / self.deceleration) / 2.0

    def least_duration(self, way: float) -> float:
        """The least time in seconds for a motion of this many radians or metres."""
        way, ramps = abs(way), self._ramps
        if not way:
            return 0.0
        if not ramps:
            return way / self.speed
        top = min(self.speed, math.sqrt(way / ramps))
        return way / top + ramps * top

    def speed_for(self, way: float, duration: float) -> float | None:
        """The speed with which the motion takes `duration` seconds; None if the joint is not as fast."""
        way, ramps = abs(way), self._ramps
        if duration < self.least_duration(way) - DURATION_ROUNDING or not duration:
            return None
        if not ramps:
            return way / duration
        speed = (duration - math.sqrt(max(0.0, duration * duration - 4.0 * ramps * way))) / (2.0 * ramps)
        return min(speed, self.speed)


def motion_limits(record: Any) -> MotionLimits:
    """The limits of one joint; zero, with which the joint could not move, means no limit."""
    values = record.joint_max_speed, record.joint_max_acceleration_rate, record.joint_max_deceleration_rate
    return MotionLimits(*(value or math.inf for value in values))


def speeds_for(
    limits: Mapping[str, MotionLimits], start: Sequence[float], end: Sequence[float], duration: float
) -> dict[str, float]:
    """The speed of each joint with which its motion takes `duration` seconds."""
    speeds = dict[str, float]()
    for (name, limit), first, last in zip(limits.items(), start, end, strict=True):
        speed = limit.speed_for(last - first, duration)
        if speed is None:
            least = limit.least_duration(last - first)
            raise ConfigError(f"{name} needs at least {least:.2f} s for its way, and not {duration:g} s")
        speeds[name] = max(speed, MIN_SPEED)
    return speeds


def straight_limits(
    limits: Mapping[str, MotionLimits], start: Sequence[float], end: Sequence[float], duration: float = 0.0
) -> dict[str, MotionLimits]:
    """Limits with which all joints have the same part of their ways behind them at any time, from rest to rest.

    The motion takes `duration` seconds, or with 0 as long as the slowest joint needs; `ConfigError` if that is longer.
    """
    whole, ways = _whole_way(limits, start, end), [abs(b - a) for a, b in zip(start, end, strict=True)]
    speed = whole.speed_for(1.0, duration) if duration and any(ways) else whole.speed
    if speed is None:
        raise ConfigError(f"the joints need at least {whole.least_duration(1.0):.2f} s, and not {duration:g} s")
    return {
        name: MotionLimits(
            max(_share(speed, way, limit.speed), MIN_SPEED),
            _share(whole.acceleration, way, limit.acceleration),
            _share(whole.deceleration, way, limit.deceleration),
        )
        for (name, limit), way in zip(limits.items(), ways, strict=True)
    }


def straight_duration(limits: Mapping[str, MotionLimits], start: Sequence[float], end: Sequence[float]) -> float:
    """The least time in seconds of a straight way of all joints, from rest to rest."""
    return _whole_way(limits, start, end).least_duration(1.0)


def _whole_way(limits: Mapping[str, MotionLimits], start: Sequence[float], end: Sequence[float]) -> MotionLimits:
    """The limits of the part of the way that is done, 0 to 1, with which no joint exceeds its own."""
    ways = [abs(last - first) for first, last in zip(start, end, strict=True)]
    moving = [(limit, way) for limit, way in zip(limits.values(), ways, strict=True) if way]
    return MotionLimits(
        min((limit.speed / way for limit, way in moving), default=math.inf),
        min((limit.acceleration / way for limit, way in moving), default=math.inf),
        min((limit.deceleration / way for limit, way in moving), default=math.inf),
    )


def _share(whole: float, way: float, limit: float) -> float:
    return limit if math.isinf(whole) else max(whole * way, LEAST_SHARE * limit if math.isfinite(limit) else 0.0)


def limited_by(limits: Mapping[str, MotionLimits], speeds: Mapping[str, float]) -> dict[str, MotionLimits]:
    """The limits of each joint with at most its speed."""
    return {name: replace(limit, speed=min(limit.speed, speeds.get(name, math.inf))) for name, limit in limits.items()}


def profile_record(limits: MotionLimits, *, is_revolute: bool) -> Any:
    """The profile of one joint; zero means no limit."""
    kinds = SetJointMotionProfile
    make: Any = kinds.RevoluteJointMotionProfileRec if is_revolute else kinds.PrismaticJointMotionProfileRec
    values = limits.speed, limits.acceleration, limits.deceleration
    return make(*(0.0 if math.isinf(value) else value for value in values))
