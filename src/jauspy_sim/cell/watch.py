"""Distances, contacts and loads of bodies in a simulated cell, measured after each physics step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np

from jauspy_sim.cell.servos import SimulatedServo
from jauspy_sim.models.groups import COLLISION

FAR: Final = 0.5
"""Metres up to which distances are measured."""


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
        self._bodies = self._geoms(bodies)
        self._obstacles = self._geoms(obstacles)
        self._between = np.zeros(6)

    def step(self) -> None:
        """Measure the state after a step."""
        model, data, found = self._model, self._data, self.found
        centers, radii = data.geom_xpos, model.geom_rbound
        for obstacle in self._obstacles:
            apart = np.linalg.norm(centers[self._bodies] - centers[obstacle], axis=1)
            near = apart - radii[self._bodies] - radii[obstacle] < found.clearance
            for body in np.array(self._bodies)[near].tolist():
                distance = mujoco.mj_geomDistance(model, data, body, obstacle, found.clearance, self._between)
                if distance < found.clearance:
                    found.clearance, found.between = distance, (self._name(body), self._name(obstacle))
        watched, obstacles = set(self._bodies), set(self._obstacles)
        for contact in data.contact[: data.ncon]:
            pair = {int(geom) for geom in contact.geom}
            if pair & watched:
                found.penetration = max(found.penetration, -float(contact.dist))
                found.contacts += bool(pair & obstacles) and contact.dist <= 0.0
        for servo in self._servos.values():
            if servo.powered:
                found.speed = max(found.speed, abs(servo.true_velocity) / servo.setup.max_speed)
                found.torque = max(found.torque, abs(servo.true_torque) / servo.setup.max_torque)

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
