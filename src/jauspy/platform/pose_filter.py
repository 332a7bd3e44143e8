"""An extended Kalman filter of a pose on the ground: how the errors of dead reckoning grow, and how fixes reduce them.

The state: x, y (m), yaw (rad), the errors of the encoders' scale, of the gyroscope's bias (rad/s) and of its scale, and
the slow errors of the fixes in x and y (m). See docs/adr/0111-localisation.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, TypeAlias

Row: TypeAlias = list[float]

X, Y, YAW, SCALE, BIAS, GAIN, DRIFT_X, DRIFT_Y = range(8)
STATES: Final = 8


@dataclass(frozen=True, slots=True)
class Motion:
    """What dead reckoning measured: metres and radians in the frame of the filter, and in how many seconds."""

    x: float
    y: float
    yaw: float
    dt: float
    position_variance: float
    """m^2, that this motion adds along each axis."""
    yaw_variance: float
    bias_variance: float


class PoseFilter:
    """`deviations`: of the state, at the start."""

    def __init__(self, x: float, y: float, yaw: float, deviations: Iterable[float]) -> None:
        self.state = [x, y, yaw, 0.0, 0.0, 0.0, 0.0, 0.0]
        self.covariance = [
            [deviation**2 if row == column else 0.0 for column in range(STATES)]
            for row, deviation in enumerate(deviations)
        ]

    def move(self, motion: Motion) -> None:
        """Move by what dead reckoning measured."""
        state = self.state
        x, y = motion.x * (1.0 + state[SCALE]), motion.y * (1.0 + state[SCALE])
        state[X] += x
        state[Y] += y
        state[YAW] += motion.yaw * (1.0 + state[GAIN]) - motion.dt * state[BIAS]
        rows = self.covariance
        self._mix(rows, motion, x, y)
        for row in rows:  # the same for the columns: F P F'
            yaw, scale = row[YAW], row[SCALE]
            row[X] += motion.x * scale - y * yaw
            row[Y] += motion.y * scale + x * yaw
            row[YAW] = yaw - motion.dt * row[BIAS] + motion.yaw * row[GAIN]
        rows[X][X] += motion.position_variance
        rows[Y][Y] += motion.position_variance
        rows[YAW][YAW] += motion.yaw_variance
        rows[BIAS][BIAS] += motion.bias_variance

    @staticmethod
    def _mix(rows: list[Row], motion: Motion, x: float, y: float) -> None:
        yaw, scale, bias, gain = rows[YAW], rows[SCALE], rows[BIAS], rows[GAIN]
        rows[X] = [a - y * b + motion.x * c for a, b, c in zip(rows[X], yaw, scale, strict=True)]
        rows[Y] = [a + x * b + motion.y * c for a, b, c in zip(rows[Y], yaw, scale, strict=True)]
        rows[YAW] = [a - motion.dt * b + motion.yaw * c for a, b, c in zip(yaw, bias, gain, strict=True)]

    def fade(self, kept: float, deviation: float) -> None:
        """Forget the slow errors of the fixes to a part of `kept`; they have this deviation in the long run."""
        rows = self.covariance
        for index in (DRIFT_X, DRIFT_Y):
            self.state[index] *= kept
            rows[index] = [kept * value for value in rows[index]]
            for row in rows:
                row[index] *= kept
            rows[index][index] += (1.0 - kept * kept) * deviation**2

    def observe(self, indices: tuple[int, ...], measured: float, deviation: float) -> None:
        """Correct by a measurement of the sum of some states."""
        rows = self.covariance
        across = [sum(row[index] for index in indices) for row in rows]
        spread = sum(across[index] for index in indices) + deviation**2
        if spread <= 0.0:
            return
        error = measured - sum(self.state[index] for index in indices)
        gains = [each / spread for each in across]
        self.state = [value + gain * error for value, gain in zip(self.state, gains, strict=True)]
        self.covariance = [
            [value - gain * other for value, other in zip(row, across, strict=True)]
            for row, gain in zip(rows, gains, strict=True)
        ]

    def surprise(self, indices: tuple[int, ...], measured: float, deviation: float) -> float:
        """How many standard deviations a measurement of the sum of some states is from what is expected."""
        spread = sum(self.covariance[a][b] for a in indices for b in indices) + deviation**2
        error = abs(measured - sum(self.state[index] for index in indices))
        return error / math.sqrt(spread) if spread > 0.0 else 0.0

    def declare(self, indices: Iterable[int], deviation: float) -> None:
        """Take states as known with this deviation, whatever was known before."""
        for index in indices:
            for row in self.covariance:
                row[index] = 0.0
            self.covariance[index] = [0.0] * STATES
            self.covariance[index][index] = deviation**2

    @property
    def horizontal_rms(self) -> float:
        """Root mean square of the error of x and y together, metres."""
        return math.sqrt(max(0.0, self.covariance[X][X] + self.covariance[Y][Y]))

    @property
    def yaw_rms(self) -> float:
        """Radians."""
        return math.sqrt(max(0.0, self.covariance[YAW][YAW]))
