"""What a robot holds, as the efforts of its joints tell: mass and centre of mass, with their uncertainty."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector

Array = NDArray[np.float64]

MEMORY: Final = 1.0
"""Seconds of motion after which a measurement has lost most of its weight."""
EXPECTED_MASS: Final = 5.0
"""Kilograms: the standard deviation of a mass of which nothing is known."""
EXPECTED_MOMENT: Final = 0.3
"""Kilogram metres: the same of the first moment of mass about the tool."""
EXPECTED_LEVER: Final = 0.12
"""Metres: the same of the distance of a load's centre from the tool along each axis."""
FARTHEST: Final = 1.0
"""Metres from the tool beyond which no centre of mass is."""
LEAST: Final = 0.02
"""Kilograms below which an estimate says that nothing is held."""


@dataclass(frozen=True, slots=True)
class Payload:
    """A load as a mass at a point."""

    mass: float = 0.0
    """Kilograms."""
    center: Vector = (0.0, 0.0, 0.0)
    """Centre of mass in the frame of the tool, metres."""
    mass_deviation: float = math.inf
    """Kilograms, as standard deviation; infinite until something is known."""


NOTHING: Final = Payload()


class PayloadIdentifier:
    """Least squares with fading memory for mass and first moment of mass (kg, kg m along the axes of the tool).

    They act linearly on the efforts of the joints: the coefficients are a row for each joint. What is not observable
    in the motions so far, as a centre along the vertical, stays near zero.
    """

    def __init__(self) -> None:
        self._prior = np.diag([EXPECTED_MASS**-2.0, *[EXPECTED_MOMENT**-2.0] * 3])
        self.reset()

    def reset(self) -> None:
        """Forget everything."""
        self._information, self._vector = np.zeros((4, 4)), np.zeros(4)
        self._squares = self._count = 0.0

    def add(self, rows: Array, efforts: Array, deviations: Array, dt: float) -> Payload:
        """Learn from efforts beyond those of the robot alone; the estimate `dt` seconds after the last measurement.

        `rows`: shape (n, 4), efforts for each kilogram and kilogram metre; `efforts` and `deviations`: shape (n,),
        N m or N.
        """
        keep = math.exp(-dt / MEMORY)
        scaled, weighed = rows / deviations[:, None], efforts / deviations
        self._information = keep * self._information + scaled.T @ scaled
        self._vector = keep * self._vector + scaled.T @ weighed
        self._squares = keep * self._squares + float(weighed @ weighed)
        self._count = keep * self._count + len(rows)
        return self._estimate()

    def _estimate(self) -> Payload:
        covariance = np.linalg.inv(self._information + self._prior)
        found = covariance @ self._vector
        misfit = self._squares - 2.0 * float(found @ self._vector) + float(found @ self._information @ found)
        # larger misfits than those of the noise are errors of the model, which count as noise
        scale = max(1.0, misfit / max(1.0, self._count - 4.0))
        # the centre of a light load is near the tool: what the motions have not shown of it stays there
        lever = max(LEAST, float(found[0])) * EXPECTED_LEVER
        prior = np.diag([EXPECTED_MASS**-2.0, *[min(EXPECTED_MOMENT, lever) ** -2.0] * 3])
        covariance = np.linalg.inv(self._information / scale + prior)
        found = covariance @ self._vector / scale
        deviation = math.sqrt(float(covariance[0, 0]))
        mass = float(found[0])
        if mass < LEAST:
            return Payload(mass_deviation=deviation)
        center = found[1:] / mass
        center *= min(1.0, FARTHEST / max(FARTHEST, float(np.linalg.norm(center))))
        x, y, z = center.tolist()
        return Payload(mass, (x, y, z), deviation)
