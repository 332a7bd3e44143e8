"""A PID controller for one joint: efforts out of errors."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Gains:
    """Effort per error, per integrated error, per change of error; `i_limit` bounds what integration may add."""

    p: float
    i: float = 0.0
    d: float = 0.0
    i_limit: float = math.inf


class Pid:
    """The output stays within `limit` either way; what the limit cuts off is not integrated (anti-windup)."""

    def __init__(self, gains: Gains, limit: float) -> None:
        self.gains = gains
        self.limit = limit
        self._integral = 0.0

    def reset(self) -> None:
        """Forget what was integrated."""
        self._integral = 0.0

    def update(self, error: float, rate: float, dt: float, feed_forward: float = 0.0) -> float:
        """The effort for an error that changes by `rate` per second, after `dt` seconds, on top of `feed_forward`."""
        gains, integral, limit = self.gains, self._integral, self.limit
        wanted = feed_forward + gains.p * error + gains.d * rate + integral
        within = -limit <= wanted <= limit
        if within or error * wanted < 0.0:
            integral, most = integral + gains.i * error * dt, gains.i_limit
            self._integral = integral if -most <= integral <= most else math.copysign(most, integral)
        return wanted if within else math.copysign(limit, wanted)
