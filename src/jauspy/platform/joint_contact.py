"""Contact of an arm with something in its way, found from the efforts of its motors and the model of the arm.

The momentum of the deviation from the setpoints is observed, as the whole momentum in De Luca, Albu-Schaeffer, Haddadin
and Hirzinger, "Collision Detection and Safe Reaction with the DLR-III Lightweight Manipulator Arm", IROS 2006. What the
setpoints need is known from the feed-forward of the controllers. SI units; vectors are in the order of the joints.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

GAIN: Final = 60.0
"""1/s: the observed external effort follows the true one with a time constant of 17 ms."""
THRESHOLD_SHARE: Final = 0.1
"""Part of a joint's greatest effort from which on an external effort is a contact.

In the tasks of the cell with nothing in the way, half of that is observed at most (`docs/cell.md`).
"""
UNCERTAIN: Final = 4.0
"""Factor of the threshold while the model is not certain: the weight of a load whose mass is not known yet acts as an
external effort, and joints that are far from their setpoints do not move as those would."""
SUSPICION: Final = 0.7
"""Part of the threshold from which on a load is no longer identified: the contact would count as one."""


class JointContactObserver:
    """Observes the external efforts on the joints of a group whose controllers are fed forward."""

    def __init__(self, max_efforts: Sequence[float]) -> None:
        self.external = np.zeros(len(max_efforts))
        """External efforts (N m or N), late by 17 ms; positive in the direction of the joint."""
        self.thresholds = THRESHOLD_SHARE * np.array(max_efforts)
        """External efforts from which on there is a contact."""
        self._deviation = np.zeros(len(max_efforts))
        """Momentum that external efforts have caused, less what of it is observed."""

    def update(self, inertia: Array, changes: Array, accelerations: Array, beyond: Array, dt: float) -> None:
        """Take in the last `dt` seconds.

        `inertia`: shape (n, n); `changes` of the measured velocities; `accelerations` of the setpoints; `beyond`: the
        efforts of the motors beyond those that the setpoints need.
        """
        momentum = inertia @ (changes - dt * accelerations)
        self._deviation = self._deviation + momentum - dt * (beyond + self.external)
        self.external = GAIN * self._deviation

    def suspects(self, *, certain: bool) -> bool:
        """True from most of the effort of a contact on."""
        return self._largest(certain=certain) > SUSPICION

    def touched(self, *, certain: bool) -> Sequence[int]:
        """The joints whose external effort is a contact, the one furthest beyond its threshold first."""
        if self._largest(certain=certain) <= 1.0:
            return ()
        ratios = np.abs(self.external) / self.thresholds
        return [int(joint) for joint in np.argsort(-ratios) if ratios[joint] > 1.0]

    def _largest(self, *, certain: bool) -> float:
        largest = float((np.abs(self.external) / self.thresholds).max(initial=0.0))
        return largest if certain else largest / UNCERTAIN
