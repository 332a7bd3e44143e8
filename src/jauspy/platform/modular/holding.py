"""Strength of connections between parts: suction cups and mechanical latches.

A load is the force and the moment that a connector exerts on what it holds, about the middle of its plate, in its
frame, whose z points out of it: a force along -z pulls the part towards the plate. Units: N, N m, m, Pa, s.

A load uses the fraction

    u = (pull + max(bending / radius, hypot(shear, torsion / radius) / friction)) / force

of a connection: what pulls is carried by the force with which the plates are clamped, a bending moment tips the part
about the rim, and shear and torsion are carried by friction there. Above 1 it comes apart. A force that presses the
plates together loads nothing.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from jauspy.platform.tables import Positive, Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

SAFETY: Final = 1.5
"""Strength over the largest load that is planned, as Schmalz recommends for airtight, smooth workpieces."""
FULL_VACUUM: Final = 90e3
"""Pascals below the ambient pressure: 0.9 bar, which ejectors reach on airtight parts."""


@dataclass(frozen=True, slots=True)
class Holding(Table):
    """Strength of one connection."""

    force: Positive
    """Newtons that clamp the plates."""
    radius: Positive
    """Metres from the axis to the rim about which a moment tips the part."""
    friction: Positive = 0.5

    @property
    def moment(self) -> float:
        """Newton metres of bending that peel it off."""
        return self.force * self.radius

    def utilisation(self, force: Sequence[float], moment: Sequence[float]) -> float:
        """Fraction of the strength that a load uses."""
        fx, fy, fz = force
        mx, my, mz = moment
        return self.combined(max(0.0, -fz), math.hypot(fx, fy), math.hypot(mx, my), abs(mz))

    def combined(self, pull: float, shear: float, bending: float, torsion: float) -> float:
        """Fraction of the strength that a load uses, of its components' magnitudes."""
        sliding = math.hypot(shear, torsion / self.radius) / self.friction
        return (pull + max(bending / self.radius, sliding)) / self.force

    def utilisations(self, forces: NDArray[Any], moments: NDArray[Any]) -> NDArray[Any]:
        """Same as `utilisation` for many loads; shapes (..., 3), result (...)."""
        import numpy as np  # noqa: PLC0415 - clients that read a cell's file do without

        pull = np.maximum(0.0, -forces[..., 2])
        shear = np.hypot(forces[..., 0], forces[..., 1])
        bending = np.hypot(moments[..., 0], moments[..., 1])
        sliding = np.hypot(shear, moments[..., 2] / self.radius) / self.friction
        result: NDArray[Any] = (pull + np.maximum(bending / self.radius, sliding)) / self.force
        return result


@dataclass(frozen=True, slots=True)
class Cup(Table):
    """A suction cup: its strength is pressure times area, its lever the radius of its lip."""

    radius: Positive
    """Metres."""
    pressure: Positive = FULL_VACUUM
    """Pascals below the ambient pressure when nothing leaks."""
    friction: Positive = 0.5
    """Schmalz: 0.5 for metal and glass, dry and clean."""

    @property
    def holding(self) -> Holding:
        """Strength at full vacuum; it is proportional to the vacuum."""
        return Holding(self.pressure * math.pi * self.radius**2, self.radius, self.friction)


CUP: Final = Cup(0.030).holding
"""A connector without its latch: 254 N, 7.6 N m."""
GRIPPER_CUP: Final = Cup(0.022).holding
"""The gripper of the UR10: 137 N, 3.0 N m."""
LATCH: Final = Holding(1100.0, 0.025)
"""A quick-change system SCHUNK SWS-011: its locking force, on its diameter of 50 mm; 27.5 N m follow."""
