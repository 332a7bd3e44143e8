"""What hangs on a suction cup or a latch: the fraction of its strength that a posture or a motion uses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.dynamics import solid_inertia
from jauspy.platform.modular.holding import SAFETY, Holding
from jauspy.platform.modular.parts import PartType

MOST: Final = 1.0 / SAFETY
"""Fraction of a strength that planned motions use at most."""
UP: Final = np.array([0.0, 0.0, GRAVITY])


@dataclass(frozen=True, slots=True)
class HeldLoad:
    """A rigid load on a connector or on the gripper."""

    inertia: pin.Inertia
    """In the connector's frame."""
    strength: Holding

    @property
    def worst(self) -> float:
        """Bound of the fraction used at rest in any attitude."""
        weight = self.inertia.mass * GRAVITY
        lever = float(np.linalg.norm(self.inertia.lever))
        return self.strength.combined(weight, weight, weight * lever, weight * lever)

    def utilisation(self, tool: pin.SE3, acceleration: Array | None = None) -> float:
        """Fraction of the strength used when the connector is at `tool`; its acceleration in the world in m/s^2."""
        felt = UP if acceleration is None else UP + acceleration
        force = self.inertia.mass * (tool.rotation.T @ felt)
        return self.strength.utilisation(force.tolist(), np.cross(self.inertia.lever, force).tolist())


def inertia_of(parts: Sequence[tuple[PartType, pin.SE3]]) -> pin.Inertia:
    """Inertia of parts together, with their frames in a common one; joints of servo modules are at zero."""
    found = pin.Inertia.Zero()
    for kind, frame in parts:
        for solid in kind.solids:
            found += frame.act(solid_inertia(solid))
        if kind.servo is not None:
            for solid in kind.servo.output:
                found += (frame * se3(kind.servo.joint)).act(solid_inertia(solid))
    return found
