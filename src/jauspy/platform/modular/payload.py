"""Estimates the mass of the box at the tip of an arm from the torques that the springs measure."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.dynamics import ArmModel

Array = NDArray[np.float64]

SMOOTHING: Final = 0.02
"""Seconds over which torques and accelerations are averaged, both in the same way."""

MEMORY: Final = 0.25
"""Seconds after which a measurement has lost most of its weight."""

LARGEST: Final = 20.0
"""Kilograms: no estimate is larger."""


class PayloadEstimator:
    """Least squares with fading memory: spring torques less those of the arm alone, over those of each kilogram.

    The springs are behind the gears, so friction does not disturb. A box that still rests on something counts only by
    what the arm carries of it.
    """

    def __init__(self, model: ArmModel, joints: int) -> None:
        self._model = model
        self._last: Array | None = None
        self._acceleration, self._torque = np.zeros(joints), np.zeros(joints)
        self._product = self._square = 0.0

    def update(self, q: Array, v: Array, spring: Array, dt: float) -> float:
        """The mass (kg) after another `dt` seconds."""
        if self._last is None:
            self._last, self._torque = v, spring
            return 0.0
        part = min(1.0, dt / SMOOTHING)
        self._acceleration = self._acceleration + part * ((v - self._last) / dt - self._acceleration)
        self._torque = self._torque + part * (spring - self._torque)
        self._last = v
        without, each = self._model.load_torques(q, v, self._acceleration)
        keep = 1.0 - dt / MEMORY
        self._product = keep * self._product + float(each @ (self._torque - without))
        self._square = keep * self._square + float(each @ each)
        return min(LARGEST, max(0.0, self._product / self._square)) if self._square > 1e-9 else 0.0
