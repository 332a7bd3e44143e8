"""Loads of a cell's connectors, by the constraint forces of their welds, and what they use of the strength."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.platform.modular.holding import Holding

Array = NDArray[np.float64]

ROWS: Final = 6
"""Constraint rows of a weld: a force in the world's frame at the middle of the plate, and twice a moment in the frame
of the second body, since the rotation's error is that of half the angle."""

HALF_ANGLE: Final = np.array((1.0, 0.5))
"""Factors from the rows of a weld to force and moment."""


class Connection(Protocol):
    """A connector that holds something."""

    weld: int
    body: int
    frame: Transform

    def strength(self) -> tuple[Holding, float]:
        """Strength when it is full, and the fraction of it that there is."""


@dataclass(frozen=True, slots=True)
class Load:
    """Magnitudes of a load, newtons and newton metres, and the fraction of the strength that it uses."""

    pull: float
    """Zero when the plates are pressed together."""
    shear: float
    bending: float
    torsion: float
    utilisation: float

    def __str__(self) -> str:
        parts = [f"{force:.0f} N {name}" for name, force in (("pull", self.pull), ("shear", self.shear))]
        parts += [f"{moment:.1f} N m {name}" for name, moment in (("bending", self.bending), ("torsion", self.torsion))]
        return ", ".join(parts)


class ConnectorLoads:
    """Loads of the connectors that hold something, after each step. Force and moment: see `holding`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        self._model, self._data = model, data
        self._rotations = np.asarray(data.xmat).reshape(-1, 3, 3)
        self.follow(())

    def follow(self, connections: Iterable[tuple[Connection, int]]) -> None:
        """Measure these connections from now on; with each the body that it holds."""
        found = sorted(connections, key=lambda pair: pair[0].weld)
        self.connections: Sequence[Connection] = [connection for connection, _ in found]
        self._bodies = np.array([connection.body for connection in self.connections], np.int64)
        self._frames = np.array([connection.frame.rotation for connection in self.connections]).reshape(-1, 3, 3)
        held = np.array([body for _, body in found], np.int64)
        axes = self._rotations[self._bodies] @ self._frames
        self._turns = np.swapaxes(axes, 1, 2) @ self._rotations[held]
        """From the frame of the held body into that of the connector, in which it does not move."""
        self.weigh()

    def weigh(self) -> None:
        """Take over the strengths, after one of them has changed."""
        rows = [(strength, share) for strength, share in (connection.strength() for connection in self.connections)]
        self._force = np.array([strength.force * share for strength, share in rows])
        self._radius = np.array([strength.radius for strength, _ in rows])
        self._friction = np.array([strength.friction for strength, _ in rows])
        # by Cauchy-Schwarz u <= hypot(1, 1 / least) / force * hypot(|force|, |moment| / radius), as u adds to the pull
        # either the bending or, over the friction, the sliding, which are orthogonal to it
        squares = (1.0 + np.maximum(1.0, 1.0 / self._friction) ** 2) / self._force**2
        self._bounds = np.zeros((ROWS * len(rows), len(rows)))
        """The squares of bounds of u are the squares of the rows times this matrix."""
        for number, (square, radius) in enumerate(zip(squares.tolist(), self._radius.tolist(), strict=True)):
            start = ROWS * number
            self._bounds[start : start + 3, number] = square
            self._bounds[start + 3 : start + ROWS, number] = square * (0.5 / radius) ** 2

    def overloaded(self) -> list[tuple[Connection, Load]]:
        """The connections that broke in the last step. Cheap as long as all loads are far from that."""
        if not self.connections:
            return []
        forces = self._rows()
        if not len(forces):
            return []
        if max(((forces * forces) @ self._bounds).tolist()) < 1.0:
            return []
        wrenches = self.wrenches()
        over = np.flatnonzero(self.utilisations(wrenches) > 1.0)
        return [(self.connections[number], self.load(number, wrenches)) for number in over.tolist()]

    def wrenches(self) -> Array:
        """Force and moment that each connector exerted in the last step, in its frame; shape (connections, 6)."""
        forces = self._rows().reshape(-1, 2, 3)
        if not len(forces):
            return np.zeros((len(self.connections), ROWS))
        axes = self._rotations[self._bodies] @ self._frames
        force = np.einsum("nji,nj->ni", axes, forces[:, 0])
        moment = 0.5 * np.einsum("nij,nj->ni", self._turns, forces[:, 1])
        return -np.hstack([force, moment])

    def magnitudes(self) -> Array:
        """Magnitudes of force and moment in the last step; shape (connections, 2)."""
        forces = self._rows().reshape(-1, 2, 3)
        if not len(forces):
            return np.zeros((len(self.connections), 2))
        found: Array = np.sqrt(np.einsum("nij,nij->ni", forces, forces)) * HALF_ANGLE
        return found

    def utilisations(self, wrenches: Array) -> Array:
        """Fractions of the strengths that loads of all connections use."""
        pull = np.maximum(0.0, -wrenches[:, 2])
        shear, bending = np.hypot(wrenches[:, 0], wrenches[:, 1]), np.hypot(wrenches[:, 3], wrenches[:, 4])
        sliding = np.hypot(shear, wrenches[:, 5] / self._radius) / self._friction
        clamping = self._force + np.maximum(0.0, wrenches[:, 2])
        found: Array = (pull + np.maximum(bending / self._radius, sliding)) / clamping
        return found

    def load(self, number: int, wrenches: Array) -> Load:
        """The load of one connection, of those of all."""
        fx, fy, fz, mx, my, mz = wrenches[number].tolist()
        share = float(self.utilisations(wrenches)[number])
        return Load(max(0.0, -fz), float(np.hypot(fx, fy)), float(np.hypot(mx, my)), abs(mz), share)

    def _rows(self) -> Array:
        """Forces of the welds in the last step; empty when that was before the last attachment."""
        count = ROWS * len(self.connections)
        data = self._data
        return data.efc_force[:count] if data.ne == count else np.zeros(0)
