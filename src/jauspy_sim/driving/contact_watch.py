"""Contacts of a driving robot with what it should not touch, and its way, measured after steps of the physics."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Pose
from jauspy_sim.driving.true_heights import TrueHeights

MOVED: Final = 0.05
"""Metres of the robot that count as a part of its way; less is what it sways."""
UPRIGHT: Final = 0.7
"""Vertical part of the normal of a contact from which on it is one with ground."""


class ContactWatch:
    """Counts contacts by what was touched: all with movable things, and those with walls.

    A wall is where the normal of a contact is not vertical, unless it is the face of a step that the robot climbs,
    up to `step` metres high.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        name_prefix: str,
        pose: Callable[[], Pose],
        *,
        ground: TrueHeights,
        step: float,
    ) -> None:
        self.contacts: Counter[str] = Counter()
        """Samples of the physics with a contact, by the name of the body; `wall` for what does not move."""
        self.way = 0.0
        """Metres."""
        self.ground = ground
        """The heights of the world."""
        self._data, self._pose, self._step = data, pose, step
        names = [model.body(number).name for number in range(model.nbody)]
        self._names = [(names[body] if body else "") or "wall" for body in model.geom_bodyid.tolist()]
        own = np.array([name.startswith(name_prefix) for name in names])
        self._own = own[model.geom_bodyid]
        moves = model.body_dofnum[model.body_rootid] > 0
        self._moves = moves[model.geom_bodyid]
        self._before: Pose | None = None

    def begin(self) -> None:
        """Begin anew, where the robot is."""
        self.contacts.clear()
        self.way, self._before = 0.0, self._pose()

    def step(self, now: float) -> None:  # noqa: ARG002 - as sensors
        """Measure the state after a step."""
        if self._before is None:
            return
        self._measure_way(self._before)
        contact = self._data.contact
        geoms = np.asarray(contact.geom).reshape(-1, 2)
        own = self._own[geoms]
        theirs = np.where(own[:, 0], geoms[:, 1], geoms[:, 0])
        level = np.abs(np.asarray(contact.frame).reshape(-1, 9)[:, 2]) < UPRIGHT
        counts = (own[:, 0] != own[:, 1]) & (np.asarray(contact.dist) <= 0.0) & (self._moves[theirs] | level)
        touched = set()
        for row in np.flatnonzero(counts).tolist():
            other = int(theirs[row])
            if self._moves[other] or self._is_wall(contact.pos[row]):
                touched.add(self._names[other])
        self.contacts.update(touched)

    def _measure_way(self, before: Pose) -> None:
        pose = self._pose()
        if (moved := math.dist((before.x, before.y), (pose.x, pose.y))) > MOVED:
            self.way += moved
            self._before = pose

    def _is_wall(self, place: NDArray[np.float64]) -> bool:
        """False for the face of a step that the robot climbs from where it is."""
        highest = self.ground.highest_around(float(place[0]), float(place[1]))
        return math.isnan(highest) or highest > self._pose().z + self._step
