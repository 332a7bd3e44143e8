"""Which bodies of the world the joint groups of a robot touch, in each sample of the physics."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from types import MappingProxyType

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.contacts import ContactCounts, Contacts


class SimulatedContacts(Contacts):
    """Counts contacts at each `step`; `groups` are the names of the joints of each group.

    A group is the links that its joints move, with all that is mounted on them.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str, groups: Mapping[str, Iterable[str]]
    ) -> None:
        self._model, self._data = model, data
        self._counts: dict[str, Counter[str]] = {}
        self._state: ContactCounts = MappingProxyType({})
        own = np.array([model.body(number).name.startswith(name_prefix) for number in range(model.nbody)])
        self._is_world = ~own[model.geom_bodyid]
        self._members = {name: _moved_geoms(model, name_prefix, joints) for name, joints in groups.items()}

    def step(self, now: float) -> None:  # noqa: ARG002 - as other sensors
        """Count the contacts after the last step of the physics."""
        pairs = self._data.contact.geom[self._data.contact.dist <= 0.0]  # without those within a margin
        world = self._is_world[pairs]
        mixed = pairs[world[:, 0] != world[:, 1]]
        if not len(mixed):
            return
        first_is_world = self._is_world[mixed[:, 0]]
        robot = np.where(first_is_world, mixed[:, 1], mixed[:, 0])
        touched = np.where(first_is_world, mixed[:, 0], mixed[:, 1])
        for name, members in self._members.items():
            bodies = set(self._model.geom_bodyid[touched[members[robot]]].tolist())
            if bodies:
                counts = self._counts.setdefault(name, Counter())
                counts.update(self._model.body(body).name for body in bodies)
                self._state = MappingProxyType({})

    def state(self) -> ContactCounts:
        """As `Contacts.state`."""
        if not self._state and self._counts:
            self._state = MappingProxyType({name: MappingProxyType(dict(row)) for name, row in self._counts.items()})
        return self._state


def _moved_geoms(model: mujoco.MjModel, name_prefix: str, joints: Iterable[str]) -> NDArray[np.bool_]:
    """Which geometries are of the links below these joints, as booleans."""
    moved = np.zeros(model.nbody, bool)
    for joint in joints:
        moved[model.joint(f"{name_prefix}{joint}").bodyid[0]] = True
    for body in range(1, model.nbody):  # parents come first
        moved[body] |= moved[model.body_parentid[body]]
    found: NDArray[np.bool_] = moved[model.geom_bodyid]
    return found
