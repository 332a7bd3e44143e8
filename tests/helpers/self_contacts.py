"""Contacts of a simulated robot's links with each other and with the world, by MuJoCo."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import mujoco

from jauspy_sim.assembly import prefix

if TYPE_CHECKING:
    from jauspy_sim.robot import SimulatedRobot

FINGERS = frozenset({"left_finger", "right_finger"})
"""Links that are made to touch each other."""


class ContactJudge:
    """Reads the contacts of a robot after each step."""

    def __init__(self, robot: SimulatedRobot, name: str) -> None:
        self._data = robot.data
        self._prefix = prefix(name)
        self._model = model = robot.model
        self._names = [model.body(body).name for body in model.geom_bodyid.tolist()]

    def _pairs(self) -> Iterable[tuple[str, str]]:
        contacts = self._data.contact
        for (one, other), gap in zip(contacts.geom.tolist(), contacts.dist.tolist(), strict=True):
            if gap <= 0.0:
                yield self._names[one], self._names[other]

    def within(self) -> set[frozenset[str]]:
        """The pairs of links that touch each other now."""
        length = len(self._prefix)
        own = [pair for pair in self._pairs() if all(name.startswith(self._prefix) for name in pair)]
        return {frozenset(name[length:] for name in pair) for pair in own} - {FINGERS}

    def distance(self, link: str, other: str) -> float:
        """Metres between two links, at most 1."""
        return self._gap(self.solids([link]), self.solids([other]))

    def clearance(self, body: str, links: Iterable[str] = ()) -> float:
        """Metres between the robot, or only some links of it, and a body of the world, at most 1."""
        return self._gap(self.solids(links), [geom for geom, name in enumerate(self._names) if name == body])

    def solids(self, links: Iterable[str] = ()) -> list[int]:
        """The geoms of some links, or of the whole robot, that things touch."""
        names = {self._prefix + link for link in links}
        return [
            geom
            for geom, name in enumerate(self._names)
            if (name in names if names else name.startswith(self._prefix))
            and (self._model.geom_contype[geom] or self._model.geom_conaffinity[geom])
        ]

    def _gap(self, geoms: Iterable[int], others: Iterable[int]) -> float:
        return min(mujoco.mj_geomDistance(self._model, self._data, a, b, 1.0, None) for a in geoms for b in others)

    def outside(self, ground: str = "world") -> set[str]:
        """The bodies of the world, except the ground, that the robot touches now."""
        return {name for pair in self._pairs() for name in pair if not name.startswith(self._prefix) and name != ground}
