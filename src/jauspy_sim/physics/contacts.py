"""Contacts of the joint groups of a robot with bodies of the world, in each sample of the physics."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from types import MappingProxyType

import mujoco
import numpy as np

from jauspy.platform.contacts import ContactCounts, Contacts


class SimulatedContacts(Contacts):
    """Counts contacts at each `step`; `groups` are the names of the joints of each group.

    A group is the links that its joints move, with all that is mounted on them.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str, groups: Mapping[str, Iterable[str]]
    ) -> None:
        self._data = data
        self._counts: dict[str, Counter[str]] = {}
        self._state: ContactCounts = MappingProxyType({})
        names = [model.body(number).name for number in range(model.nbody)]
        bodies = [names[body] for body in model.geom_bodyid.tolist()]
        self._world = {geom: body for geom, body in enumerate(bodies) if not body.startswith(name_prefix)}
        """The bodies of the world's geometries."""
        self._groups: dict[int, list[str]] = {}
        """The groups of the robot's geometries."""
        for name, joints in groups.items():
            for geom in _moved_geoms(model, name_prefix, joints):
                self._groups.setdefault(geom, []).append(name)

    def step(self, now: float) -> None:  # noqa: ARG002 - as other sensors
        """Count the contacts after the last step of the physics."""
        contacts = self._data.contact
        found: set[tuple[str, str]] = set()
        for (one, other), gap in zip(contacts.geom.tolist(), contacts.dist.tolist(), strict=True):
            if gap > 0.0:  # within a margin
                continue
            for mine, theirs in ((one, other), (other, one)):
                if mine in self._groups and theirs in self._world:
                    found.update((group, self._world[theirs]) for group in self._groups[mine])
        for group, body in found:
            self._counts.setdefault(group, Counter())[body] += 1
            self._state = MappingProxyType({})

    def state(self) -> ContactCounts:
        """Same as `Contacts.state`."""
        if not self._state and self._counts:
            self._state = MappingProxyType({name: MappingProxyType(dict(row)) for name, row in self._counts.items()})
        return self._state


def _moved_geoms(model: mujoco.MjModel, name_prefix: str, joints: Iterable[str]) -> list[int]:
    """The geometries of the links below these joints."""
    moved = np.zeros(model.nbody, bool)
    for joint in joints:
        moved[model.joint(f"{name_prefix}{joint}").bodyid[0]] = True
    for body in range(1, model.nbody):  # parents come first
        moved[body] |= moved[model.body_parentid[body]]
    geoms: list[int] = np.flatnonzero(moved[model.geom_bodyid]).tolist()
    return geoms
