"""Bringing one coordinate to its target with an effort: proportional, limited, and stubborn against friction."""

from __future__ import annotations

import math
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Tuning:
    """Efforts in percent; errors in metres or radians, rates in the same per second, times in seconds."""

    gain: float
    """Effort per unit of error."""
    most: float
    """The largest effort."""
    least: float
    """The smallest effort on the way to the target, so that the last bit does not take forever."""
    tolerance: float
    """An error this small is no error."""
    standstill: float
    """A rate this small is none."""
    look_ahead: float = 0.3
    """The error is taken as it will be after this time: of reports, of commands, and of the chassis."""
    nudge: float = 4.0
    """Effort that each report adds while friction holds the robot off its target."""


FORWARD = Tuning(gain=90.0, most=60.0, least=12.0, tolerance=0.02, standstill=0.02)
TURN = Tuning(gain=60.0, most=50.0, least=12.0, tolerance=0.02, standstill=0.05)


@dataclass(slots=True)
class Approach:
    """One approach to one target; call `effort` with each report, until `arrived`."""

    tuning: Tuning
    arrived: bool = False
    _push: float = field(default=0.0)

    def effort(self, error: float, rate: float) -> float:
        """The effort for an error (target minus value) and the rate at which the value grows."""
        tuning = self.tuning
        still = abs(rate) <= tuning.standstill
        if abs(error) <= tuning.tolerance:
            self.arrived, self._push = still, 0.0
            return 0.0
        self.arrived = False
        self._push = min(self._push + tuning.nudge, tuning.most) if still else 0.0
        wanted = tuning.gain * (error - rate * tuning.look_ahead)
        if wanted * error > 0:  # not braking
            wanted = math.copysign(max(abs(wanted), tuning.least) + self._push, wanted)
        return max(-tuning.most, min(tuning.most, wanted))
