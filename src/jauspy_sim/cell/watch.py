"""Distances, contacts and loads of bodies in a simulated cell, measured after each physics step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.cell.servos import SimulatedServo
from jauspy_sim.models.groups import COLLISION

Numbers: TypeAlias = NDArray[np.int64]

FAR: Final = 0.5
"""Metres up to which distances are measured."""

SEEN: Final = 0.1
"""Metres beyond the smallest distance up to which others are measured: the watched bodies may come nearer by that much
before they are measured again."""

ROUNDING: Final = 1e-9
"""Metres that bounds of distances may be off."""


@dataclass(slots=True)
class Watched:
    """What was measured since the watch began."""

    clearance: float = FAR
    """Metres: the smallest distance of the watched bodies from the obstacles."""
    between: tuple[str, str] = ("", "")
    """The bodies at that distance."""
    contacts: int = 0
    """Steps in which they touched an obstacle."""
    penetration: float = 0.0
    """Metres of the deepest overlap of a watched body with anything."""
    speed: float = 0.0
    """Largest speed of a servo module as a fraction of its limit."""
    torque: float = 0.0
    """Largest torque of a servo module's spring as a fraction of its limit."""


class Watch:
    """Measures `bodies` against `obstacles` (geoms by body trees) and `servos`, each step."""

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        bodies: Sequence[str],
        obstacles: Sequence[str],
        servos: Mapping[str, SimulatedServo],
    ) -> None:
        self.found = Watched()
        self._model, self._data, self._servos = model, data, servos
        self._bodies = np.array(self._geoms(bodies), np.int64)
        self._obstacles = np.array(self._geoms(obstacles), np.int64)
        radii = model.geom_rbound
        self._reach = radii[self._obstacles][:, np.newaxis] + radii[self._bodies]
        """Sums of the radii of the spheres about an obstacle and a body; shape (obstacles, bodies)."""
        self._watched = np.concatenate([self._bodies, self._obstacles])
        self._radii = radii[self._watched]
        self._centers, self._rotations = np.zeros((len(self._watched), 3)), np.zeros((len(self._watched), 9))
        """Where the shapes were when their distances were measured."""
        self._spare = 0.0
        """Metres by which they may come nearer from there until one can be nearer than any has been."""
        self._is_watched, self._is_obstacle = np.zeros(model.ngeom, np.bool_), np.zeros(model.ngeom, np.bool_)
        self._is_watched[self._bodies] = self._is_obstacle[self._obstacles] = True
        self._between = np.zeros(6)

    def step(self) -> None:
        """Measure the state after a step."""
        found = self.found
        self._measure_distances()
        self._measure_contacts()
        for servo in self._servos.values():
            if servo.powered:
                found.speed = max(found.speed, abs(servo.true_velocity) / servo.setup.max_speed)
                found.torque = max(found.torque, abs(servo.true_torque) / servo.setup.max_torque)

    def _measure_distances(self) -> None:
        """Find a smaller clearance: exactly, where spheres and boxes about the shapes allow that there is one."""
        if self._approach() < self._spare:
            return
        model, data, found = self._model, self._data, self.found
        centers = data.geom_xpos
        self._centers, self._rotations = centers[self._watched], data.geom_xmat[self._watched]
        between = centers[self._obstacles][:, np.newaxis] - centers[self._bodies]
        gaps = np.sqrt(np.einsum("obi,obi->ob", between, between)) - self._reach
        nearest = found.clearance + SEEN
        rows, columns = np.nonzero(gaps < nearest)
        obstacles, bodies = self._obstacles[rows], self._bodies[columns]
        least = np.maximum(self._outside(obstacles, bodies), self._outside(bodies, obstacles)) - ROUNDING
        for obstacle, body, bound in zip(obstacles.tolist(), bodies.tolist(), least.tolist(), strict=True):
            if bound >= nearest:
                continue
            distance = mujoco.mj_geomDistance(model, data, body, obstacle, nearest, self._between)
            nearest = min(nearest, distance)
            if distance < found.clearance:
                found.clearance, found.between = distance, (self._name(body), self._name(obstacle))
        self._spare = nearest - found.clearance - ROUNDING

    def _approach(self) -> float:
        """Metres by which bodies and obstacles may have come nearer since they were measured: no point moved further.

        A point turns about the middle of its shape by at most its radius times the change of the rotation.
        """
        data = self._data
        moved = data.geom_xpos[self._watched] - self._centers
        turned = data.geom_xmat[self._watched] - self._rotations
        ways = np.linalg.norm(moved, axis=1) + self._radii * np.linalg.norm(turned, axis=1)
        bodies, obstacles = np.split(ways, [len(self._bodies)])
        return float(bodies.max(initial=0.0) + obstacles.max(initial=0.0))

    def _outside(self, boxes: Numbers, spheres: Numbers) -> NDArray[np.float64]:
        """Distances of the spheres about shapes from the boxes about others, row by row; negative if they overlap."""
        model, data = self._model, self._data
        way = data.geom_xpos[spheres] - data.geom_xpos[boxes]
        local = np.einsum("nij,ni->nj", data.geom_xmat[boxes].reshape(-1, 3, 3), way)
        box = model.geom_aabb[boxes]
        beyond = np.maximum(np.abs(local - box[:, :3]) - box[:, 3:], 0.0)
        distances: NDArray[np.float64] = np.sqrt(np.einsum("ni,ni->n", beyond, beyond)) - model.geom_rbound[spheres]
        return distances

    def _measure_contacts(self) -> None:
        found, contact = self.found, self._data.contact
        geoms = np.asarray(contact.geom).reshape(-1, 2)
        ours = self._is_watched[geoms].any(axis=1)
        if not ours.any():
            return
        depths = -np.asarray(contact.dist)[ours]
        found.penetration = max(found.penetration, float(depths.max()))
        found.contacts += int(np.count_nonzero(self._is_obstacle[geoms[ours]].any(axis=1) & (depths >= 0.0)))

    def _geoms(self, bodies: Sequence[str]) -> list[int]:
        model = self._model
        numbers = {int(model.body(name).id) for name in bodies}
        return [
            geom
            for geom in range(model.ngeom)
            if int(model.geom_bodyid[geom]) in numbers and model.geom_group[geom] == COLLISION
        ]

    def _name(self, geom: int) -> str:
        return str(self._model.body(self._model.geom_bodyid[geom]).name)
