"""Strength of connections between parts: suction cups and mechanical latches.

A load is the force and the moment that a connector exerts on what it holds, about the middle of its plate, in its
frame, whose z points out of it: a force along -z pulls the part towards the plate. Units: N, N m, m, Pa, s.

A load uses the fraction

    u = (pull + max(bending / radius, hypot(shear, torsion / radius) / friction)) / (force + press)

of a connection: what pulls is carried by the force with which the plates are clamped, a bending moment tips the part
about the rim, and shear and torsion are carried by friction there. Above 1 it comes apart. A force that presses the
plates together is no pull: it adds to the force that clamps them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final

from annotated_types import Interval

from jauspy.platform.tables import NotNegative, Positive, Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

SAFETY: Final = 1.5
"""Strength over the largest load that is planned, as Schmalz recommends for airtight, smooth workpieces."""
FULL_VACUUM: Final = 90e3
"""Pascals below the ambient pressure: 0.9 bar, which ejectors reach on airtight parts."""
HOLDS: Final = 0.6
"""Fraction of the full vacuum from which on a part counts as attached: the vacuum at which Schmalz states forces."""
AIR: Final = 1.2
"""Kilograms of a cubic metre of air."""
DISCHARGE: Final = 0.6
"""Discharge coefficient of a sharp-edged opening."""


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
        return self.combined(-fz, math.hypot(fx, fy), math.hypot(mx, my), abs(mz))

    def combined(self, pull: float, shear: float, bending: float, torsion: float) -> float:
        """Fraction of the strength that a load uses, of its components' magnitudes; a pull below zero presses."""
        sliding = math.hypot(shear, torsion / self.radius) / self.friction
        return (max(0.0, pull) + max(bending / self.radius, sliding)) / (self.force + max(0.0, -pull))

    def utilisations(self, forces: NDArray[Any], moments: NDArray[Any]) -> NDArray[Any]:
        """Same as `utilisation` for many loads; shapes (..., 3), result (...)."""
        import numpy as np  # noqa: PLC0415 - clients that read a cell's file do without

        pull = np.maximum(0.0, -forces[..., 2])
        shear = np.hypot(forces[..., 0], forces[..., 1])
        bending = np.hypot(moments[..., 0], moments[..., 1])
        sliding = np.hypot(shear, moments[..., 2] / self.radius) / self.friction
        clamping = self.force + np.maximum(0.0, forces[..., 2])
        result: NDArray[Any] = (pull + np.maximum(bending / self.radius, sliding)) / clamping
        return result


@dataclass(frozen=True, slots=True)
class Cup(Table):
    """A suction cup with its pump. Its strength is pressure times area, its lever the radius of its lip."""

    radius: Positive
    """Metres."""
    pressure: Positive = FULL_VACUUM
    """Pascals below the ambient pressure when nothing leaks."""
    friction: Positive = 0.5
    """Schmalz: 0.5 on metal, glass, stone and wood."""
    stroke: Positive = 0.002
    """Metres between plate and face that the lip seals; assumption."""
    volume: Positive = 30e-6
    """Cubic metres of cup and hose; assumption."""
    suction: Positive = 1.2e-3
    """Cubic metres of air a second that the pump takes in at ambient pressure, and less the higher the vacuum is;
    assumption for a small ejector."""

    @property
    def holding(self) -> Holding:
        """Strength at full vacuum; it is proportional to the vacuum."""
        return Holding(self.pressure * math.pi * self.radius**2, self.radius, self.friction)

    def leak(self, gap: float, tilt: float) -> float:
        """Square metres between lip and face that stay open: `gap` in metres at the middle, `tilt` in radians."""
        least, swing = gap - self.stroke, self.radius * math.sin(tilt)
        if least + swing <= 0.0:
            return 0.0
        # the mean of max(0, least + swing cos(angle)) along the rim
        if least >= swing:
            return math.tau * self.radius * least
        edge = math.acos(-least / swing)
        return 2.0 * self.radius * (least * edge + swing * math.sin(edge))

    def settled(self, leak: float) -> float:
        """Fraction of the full vacuum at which the pump keeps up with a leak, in square metres."""
        ratio = self._flow(leak) / self.suction
        root = (math.sqrt(ratio * ratio + 4.0) - ratio) / 2.0
        return root * root

    def evacuated(self, vacuum: float, leak: float, dt: float) -> float:
        """Fraction of the full vacuum `dt` seconds later, exact without a leak."""
        rate = (self.suction * (1.0 - vacuum) - self._flow(leak) * math.sqrt(vacuum)) / self.volume
        settled = self.settled(leak)
        if abs(settled - vacuum) < 1e-6:
            return settled
        return settled + (vacuum - settled) * math.exp(-rate * dt / (settled - vacuum))

    def _flow(self, leak: float) -> float:
        """Cubic metres of air a second through a leak at full vacuum."""
        return DISCHARGE * leak * math.sqrt(2.0 * self.pressure / AIR)


@dataclass(frozen=True, slots=True)
class Latch(Holding):
    """A mechanical latch that locks what the cup beside it has pulled into contact."""

    max_distance: Positive = 0.001
    """Metres between the axes at which it locks."""
    max_angle: Annotated[float, Interval(gt=0.0, le=math.pi)] = math.radians(2.0)
    """Radians between the axes at which it locks."""
    time: NotNegative = 0.2
    """Seconds that it takes to lock; assumption."""


PLATE: Final = Cup(0.030)
"""The cup of a connector."""
GRIPPER_PLATE: Final = Cup(0.022)
"""The cup of the UR10's gripper."""
CUP: Final = PLATE.holding
"""A connector without its latch: 254 N, 7.6 N m."""
GRIPPER_CUP: Final = GRIPPER_PLATE.holding
"""137 N, 3.0 N m."""
LATCH: Final = Latch(1100.0, 0.025)
"""A quick-change system SCHUNK SWS-011: its locking force, on its diameter of 50 mm; 27.5 N m follow."""
