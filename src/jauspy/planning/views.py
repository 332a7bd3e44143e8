"""Postures of an arm from which the camera that it carries looks at a point."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from jauspy.geometry.vectors import Vector
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.obstacles import Array
from jauspy.platform.description import RobotModel

SAMPLES: Final = 20_000
"""Postures that are tried."""
OFF: Final = math.radians(12.0)
"""Radians between the camera's axis and the point, at most."""
DISTANCES: Final = (0.4, 1.0)
"""Metres from the camera to the point."""
IDEAL_DISTANCE: Final = 0.6
DOWNWARD: Final = (math.radians(25.0), math.radians(75.0))
"""Radians by which it looks down: the top of a thing and the surface around it are seen."""
UPRIGHT: Final = 0.25
"""Sine of the greatest roll of the picture."""
MOST: Final = 8
"""Postures that are returned at most."""


class Views:
    """Searches postures for a camera; `link` looks along its x axis, and `group` of joints moves it."""

    def __init__(self, model: RobotModel, group: str, link: str) -> None:
        setup = replace(model.groups[group], tip=link)
        self._arm = ArmModel(replace(model, groups={**model.groups, group: setup}), group)

    def at(self, point: Vector, present: Sequence[float], seed: int = 0) -> list[tuple[float, ...]]:
        """Postures that look at a point of the base's frame, those first that are near to the present one.

        The same seed gives the same postures; a camera that cannot look there gives none.
        """
        arm, start = self._arm, np.array(present)
        q = np.random.default_rng(seed).uniform(arm.lower, arm.upper, (SAMPLES, len(start)))
        q[:, self._idle()] = start[self._idle()]
        frames = arm.tool(arm.frames(q))
        way = np.array(point) - frames[:, :3, 3]
        distance = np.linalg.norm(way, axis=1)
        off = np.arccos(np.clip((way * frames[:, :3, 0]).sum(axis=1) / np.maximum(distance, 1e-9), -1.0, 1.0))
        down = -np.arcsin(np.clip(frames[:, 2, 0], -1.0, 1.0))
        good = (off <= OFF) & (distance >= DISTANCES[0]) & (distance <= DISTANCES[1])
        good &= (down >= DOWNWARD[0]) & (down <= DOWNWARD[1])
        good &= (np.abs(frames[:, 2, 1]) <= UPRIGHT) & (frames[:, 2, 2] > 0.0)
        found = q[good]
        cost = np.abs(found - start).max(axis=1) + 3.0 * np.abs(distance[good] - IDEAL_DISTANCE) + 3.0 * off[good]
        return [tuple(map(float, posture)) for posture in found[np.argsort(cost)[:MOST]]]

    def _idle(self) -> Array:
        """The joints that do not move the camera, as columns."""
        middle = (self._arm.lower + self._arm.upper) / 2.0
        before = self._arm.tool(self._arm.frames(middle[None]))[0]
        moved = np.repeat(middle[None], len(middle), axis=0) + 0.1 * np.eye(len(middle))
        after = self._arm.tool(self._arm.frames(moved))
        found: Array = np.abs(after - before).max(axis=(1, 2)) < 1e-9
        return found
