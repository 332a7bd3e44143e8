"""The velocities and accelerations that a client may ask for."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from jauspy.messages.mobility import SetAccelerationLimit
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.velocity_control import AccelerationLimits, PlanarVelocity, clamp

ROUNDING: Final = 1e-3
"""m/s, rad/s: a velocity at its limit may have been rounded upward on the wire, where rates have steps as large."""
MIN_ACCELERATION_LIMIT: Final = 0.05
"""m/s^2, rad/s^2: a limit of zero would keep a moving platform moving for ever."""


@dataclass(frozen=True, slots=True)
class VelocityRange:
    """From the least to the most velocity, of both axes."""

    least: PlanarVelocity
    most: PlanarVelocity

    @classmethod
    def of(cls, chassis: Chassis) -> VelocityRange:
        """All that the chassis can do."""
        return cls(
            PlanarVelocity(-chassis.max_speed, -chassis.max_turn_rate),
            PlanarVelocity(chassis.max_speed, chassis.max_turn_rate),
        )

    def contains(self, motion: PlanarVelocity) -> bool:
        """True for a motion that is neither too fast nor too slow."""
        return _within(self.least.speed, motion.speed, self.most.speed) and _within(
            self.least.turn_rate, motion.turn_rate, self.most.turn_rate
        )


def _within(least: float, value: float, most: float) -> bool:
    return least - ROUNDING <= value <= most + ROUNDING


def clamped(motion: PlanarVelocity, chassis: Chassis) -> PlanarVelocity:
    """The motion, or as much of it as the chassis can do."""
    return PlanarVelocity(clamp(motion.speed, chassis.max_speed), clamp(motion.turn_rate, chassis.max_turn_rate))


def updated_limits(limits: AccelerationLimits, msg: SetAccelerationLimit, chassis: Chassis) -> AccelerationLimits:
    """The limits after a command; what it leaves out stays, and the chassis sets the upper bound."""
    x, yaw = msg.acceleration_x, msg.yaw_acceleration
    if msg.command_type == SetAccelerationLimit.CommandType.MAX_ACCELERATION:
        return replace(
            limits,
            acceleration=_limit(x, limits.acceleration, chassis.acceleration),
            turn_acceleration=_limit(yaw, limits.turn_acceleration, chassis.turn_acceleration),
        )
    return replace(
        limits,
        deceleration=_limit(x, limits.deceleration, chassis.deceleration),
        turn_deceleration=_limit(yaw, limits.turn_deceleration, chassis.turn_acceleration),
    )


def _limit(wanted: float | None, present: float, most: float) -> float:
    return present if wanted is None else min(most, max(MIN_ACCELERATION_LIMIT, abs(wanted)))
