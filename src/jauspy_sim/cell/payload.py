"""The payload of the gripper, and the joint efforts that compensate its weight."""

from __future__ import annotations

from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.parts import CellSetup
from jauspy_sim.cell.assembly import GRIPPER
from jauspy_sim.cell.connectors import Attachments

GRAVITY: Final = 9.81


class Payload:
    """The parts that hang on the gripper, directly or through connectors.

    Their weight is compensated up to the force that the gripper measures, since a part that stands on something is not
    carried. Parts that are connected to a fixed base do not count.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, cell: CellSetup, link: str, attachments: Attachments
    ) -> None:
        self._model, self._data, self._attachments = model, data, attachments
        self._gripper = attachments.connectors[GRIPPER]
        self._link = int(model.body(link).id)
        self._fixed = {part.name for part in cell.parts if part.fixed}
        self._bodies: NDArray[np.int64] = np.zeros(0, np.int64)
        self._jacobian = np.zeros((3, model.nv))

    def update(self) -> None:
        """Find the parts that hang on the gripper, after an attachment has changed."""
        neighbours: dict[str, list[str]] = {}
        for connector, face in self._attachments.attached():
            if connector is not self._gripper:
                neighbours.setdefault(connector.part, []).append(face.part)
                neighbours.setdefault(face.part, []).append(connector.part)
        first = self._gripper.state().attached_to
        reached, waiting = {first}, [first]
        while waiting:
            for name in neighbours.get(waiting.pop(), ()):
                if name not in reached:
                    reached.add(name)
                    waiting.append(name)
        if not first or reached & self._fixed:
            self._bodies = np.zeros(0, np.int64)
            return
        trees = [int(self._model.body_treeid[self._model.body(name).id]) for name in reached]
        self._bodies = np.flatnonzero(np.isin(self._model.body_treeid, trees))

    def efforts(self, load: NDArray[np.float64]) -> None:
        """Write the efforts that carry the payload, by degree of freedom, N m or N."""
        bodies = self._bodies
        if not len(bodies):
            load[:] = 0.0
            return
        masses = self._model.body_mass[bodies]
        mass = float(masses.sum())
        center = masses @ self._data.xipos[bodies] / mass
        weight = min(mass * GRAVITY, self._gripper.state().force)
        mujoco.mj_jac(self._model, self._data, self._jacobian, None, center, self._link)
        np.multiply(self._jacobian[2], weight, out=load)
