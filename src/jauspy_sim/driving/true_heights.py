"""The true heights of a world, without the robot in it, by rays from above and along the ground."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.physics.sensors import RAY_GROUPS

SIDE: Final = 22.0
"""Metres of the map, whose middle is the origin of the world."""
CELL: Final = 0.1
"""Metres."""
ABOVE: Final = 4.0
"""Height, metres, that thin things are taken to have."""
HEADROOM: Final = 0.5
"""Metres above the ground from which on what hangs is no obstacle."""
THIN: Final = 0.4
"""Metres of what level rays find: what stands between the rays from above, such as doors and fences, and walls below
walls, whose tops a ray from above does not meet."""
RISE: Final = 0.03
"""Metres above the highest step of the level rays."""


@dataclass(frozen=True)
class TrueHeights:
    """Heights in cells of `resolution` metres; `origin` is the corner of the first one, x and y in metres."""

    origin: tuple[float, float]
    resolution: float
    heights: NDArray[np.float32]
    """Metres, shape (rows along y, columns along x); NaN without ground."""
    outside: Callable[[float, float], float]
    """Measures the height at a point that is not in the map."""

    def highest_around(self, x: float, y: float) -> float:
        """The highest of the 16 cells around a point, in metres; NaN without ground."""
        column, row = (round((value - low) / self.resolution) for value, low in zip((x, y), self.origin, strict=True))
        rows, columns = self.heights.shape
        if 2 <= row <= rows - 2 and 2 <= column <= columns - 2:
            around = self.heights[row - 2 : row + 2, column - 2 : column + 2]
        else:
            beside = (np.arange(4) - 1.5) * self.resolution
            around = np.array([[self.outside(x + dx, y + dy) for dx in beside] for dy in beside], np.float32)
        known = around[~np.isnan(around)]
        return float(known.max()) if known.size else math.nan


def true_heights(model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str, step: float) -> TrueHeights:
    """The heights of a world without the robot of this prefix; thin things higher than `step` metres are as `ABOVE`."""
    rays = _Rays(model, data, name_prefix)
    count = round(SIDE / CELL)
    low = -SIDE / 2.0
    places = low + (np.arange(count) + 0.5) * CELL
    heights = np.full((count, count), np.nan, np.float32)
    for row, y in enumerate(places):
        for column, x in enumerate(places):
            heights[row, column] = rays.height(x, y)
    for number, place in enumerate(places):
        for axis, line in ((0, heights[number]), (1, heights[:, number])):
            for ends in rays.thin_things(axis, place, step + RISE):
                first, last = (min(count - 1, max(0, math.floor((end - low) / CELL))) for end in ends)
                passed = line[first : last + 1]
                passed[passed < step + RISE] = ABOVE
    return TrueHeights((low, low), CELL, heights, rays.height)


class _Rays:
    """Casts rays through a world; what they hit of the robot does not count."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str) -> None:
        self._model, self._data = model, data
        self._own = [model.body(body).name.startswith(name_prefix) for body in model.geom_bodyid.tolist()]
        self._found = np.zeros(1, np.int32)
        self._top = float((data.geom_xpos[:, 2] + model.geom_rbound).max()) + 1.0
        """Metres above everything: a ray that begins inside of a wall would take its foot for its top."""

    def height(self, x: float, y: float) -> float:
        """The height of the highest thing at a point that does not hang above the robot; NaN without any."""
        down, z, solid = np.array([0.0, 0.0, -1.0]), self._top, dict[int, float]()
        while (far := self._cast(np.array([x, y, z]), down)) >= 0.0:
            z -= far
            geom = int(self._found[0])
            if not self._own[geom]:
                if z <= HEADROOM:
                    return max([top for top in solid.values() if top > HEADROOM], default=z)
                if geom in solid:  # its lower side
                    del solid[geom]
                else:
                    solid[geom] = z
            z -= 1e-3
        return math.nan

    def thin_things(self, axis: int, place: float, height: float) -> list[tuple[float, float]]:
        """Where a level ray enters and leaves thin things: along x (0) or y (1), `place` is its other coordinate."""
        way = np.zeros(3)
        way[axis] = 1.0
        start = np.array([place, place, height])
        start[axis] = -SIDE / 2.0
        before: tuple[int, float] | None = None
        thin = []
        while (far := self._cast(start, way)) >= 0.0:
            start[axis] += far
            geom, coordinate = int(self._found[0]), float(start[axis])
            if not self._own[geom]:
                if before is not None and before[0] == geom and coordinate - before[1] < THIN:
                    thin.append((before[1], coordinate))
                before = geom, coordinate
            start[axis] += 1e-3
        return thin

    def _cast(self, start: NDArray[np.float64], way: NDArray[np.float64]) -> float:
        """Metres to what a ray hits, which `_found` names; negative without a hit."""
        return float(mujoco.mj_ray(self._model, self._data, start, way, RAY_GROUPS, 1, -1, self._found))
