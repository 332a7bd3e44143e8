"""Contact of a modular arm with something in its way, found from the torques of its springs and its model.

The generalized momentum is observed: De Luca, Albu-Schaeffer, Haddadin and Hirzinger, "Collision Detection and Safe
Reaction with the DLR-III Lightweight Manipulator Arm", IROS 2006. The springs are behind the gears, so that friction of
the gears does not disturb. SI units; vectors are in the order of the chain.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.control_laws import JointMeasurements
from jauspy.platform.modular.dynamics import ArmModel

Array = NDArray[np.float64]

GAIN: Final = 60.0
"""1/s: the observed external torque follows the true one with a time constant of 17 ms."""

THRESHOLD_SHARE: Final = 0.15
"""Part of a module's largest torque from which on an external torque is a contact.

In motions of the cell's tasks with nothing in the way, half of that was observed at most: errors of the model and of
the payload, and parts that are put down.
"""

ON_WHEELS: Final = 4.0
"""Factor of the threshold of an arm whose base can move: its accelerations act as external torques.

While the car of the cell drives off, brakes, and rolls off its ramp, they are up to 0.20 of a module's largest torque.
"""

SEEKING: Final = 4.0
"""Factor of the threshold of an arm with a connector that is switched on and holds nothing: it is to touch something.

A box that moves on the belt at 0.25 m/s pushes the connector that comes down on it with 0.16 of a module's torque.
"""

NEAR: Final = 0.04
"""Radians of all joints from their targets up to which an arm is to touch something, rather than meets it in its way:
it presses connectors onto each other with up to 0.3 of a module's torque."""

SUSPICION: Final = 0.7
"""Part of that threshold from which on a payload is no longer estimated: the contact would count as one."""

PAYLOAD_TIME: Final = 0.6
"""Seconds after a box was attached in which its mass is estimated, and is no contact."""


class ContactObserver:
    """Observes the external torques on the joints of one assembly."""

    def __init__(self, model: ArmModel, max_torques: Array, *, on_wheels: bool) -> None:
        self.external = np.zeros(len(max_torques))
        """External torques (N m), late by 17 ms; positive in the direction of the joint."""
        self._model = model
        self._thresholds = THRESHOLD_SHARE * max_torques * (ON_WHEELS if on_wheels else 1.0)
        self._integral: Array | None = None
        self._unsettled = PAYLOAD_TIME if model.has_load else 0.0

    def restart(self) -> None:
        """Begin anew with the next measurement, without an external torque."""
        self._integral = None
        self.external = np.zeros(len(self.external))

    def update(self, measured: JointMeasurements, dt: float) -> None:
        """Take measurements in, `dt` seconds after the last ones."""
        momentum, bias = self._model.momentum(measured.q, measured.v)
        if self._integral is None:
            self._integral = momentum
        self._integral = self._integral + dt * (measured.spring + bias + self.external)
        self.external = GAIN * (momentum - self._integral)
        self._unsettled = max(0.0, self._unsettled - dt)

    @property
    def suspects(self) -> bool:
        """True from most of the torque of a contact on, unless the mass of a new box is still unknown."""
        return not self._unsettled and bool((np.abs(self.external) > SUSPICION * self._thresholds).any())

    def touched(self, *, seeks: Callable[[], bool]) -> Sequence[int]:
        """The joints whose external torque is a contact, the one furthest beyond its threshold first.

        `seeks` tells whether the arm is to touch something; it is called only if there may be a contact.
        """
        if self._unsettled:
            return ()
        ratios = np.abs(self.external) / self._thresholds
        largest = float(ratios.max(initial=0.0))
        if largest <= 1.0 or (largest <= SEEKING and seeks()):
            return ()
        return [int(joint) for joint in np.argsort(-ratios) if ratios[joint] > 1.0]
