"""Goals that a robot can reach by the true map of its world, and the shortest ways to them."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from jauspy.geometry.poses import PlanarPose
from jauspy.planning.ground import Ground, Heights
from jauspy.planning.mobility import Mobility
from jauspy.planning.path_search import NoPath, find_path
from jauspy.planning.terrain_cost import TerrainCost

NEAR, FAR = 2.0, 12.0
"""Lengths of the shortest ways to goals, metres."""
ROOM: Final = 0.6
"""Metres from a goal to obstacles."""
BESIDE: Final = 0.06
"""Metres that are free beside the footprint on the way to a goal. A blocked cell of the true map is up to half a cell,
5 cm, inside of its wall, and a robot is some centimetres off its way: through less it passes only with luck."""
TRIES: Final = 20
"""Goals that are tried for one that the robot can reach."""
SEARCH_TIME: Final = 3.0
"""Seconds of processor time of a try."""


@dataclass(frozen=True)
class Goal:
    """A point of the world, and ways to it, in metres."""

    x: float
    y: float
    shortest: float
    """The shortest way of a grid search."""
    planned: float | None = None
    """The way of the navigator's search on the true map, which turns the robot from its heading; None without one."""


class TrueMap:
    """The true map of a world as the navigator would have it that sees everything."""

    def __init__(self, heights: Heights, mobility: Mobility) -> None:
        known = ~np.isnan(heights.heights)
        self._heights = heights.heights
        ground = Ground.of(heights, mobility)
        self.terrain = TerrainCost(
            mobility, ~known, known, heights.origin, heights.resolution, ground=ground, allow_unknown=False
        )
        """The cost of driving there."""
        self.terrain.margin = BESIDE

    def draw_goal(self, here: PlanarPose, rng: np.random.Generator) -> Goal | None:
        """A random goal that the robot can reach from a pose; None if `TRIES` cannot be reached."""
        terrain = self.terrain
        terrain.start_at(here)
        ways = self.shortest(here)
        rows, columns = np.nonzero(np.isfinite(ways) & (ways > NEAR) & (ways < FAR) & (terrain.distance > ROOM))
        for number in rng.permutation(len(rows))[:TRIES].tolist():
            place = (np.array([columns[number], rows[number]]) + 0.5) * terrain.resolution + terrain.origin
            goal = float(place[0]), float(place[1])
            planned = self._planned(here, goal)
            if planned is not None:
                return Goal(*goal, float(ways[rows[number], columns[number]]), planned)
        return None

    def goal_at(self, here: PlanarPose, x: float, y: float) -> Goal | None:
        """The goal at a point, with the shortest way to it from a pose; None without a way."""
        cell = self.terrain.cell(x, y)
        length = math.inf if cell is None else float(self.shortest(here)[cell])
        return Goal(x, y, length, self._planned(here, (x, y))) if math.isfinite(length) else None

    def _planned(self, here: PlanarPose, goal: tuple[float, float]) -> float | None:
        """Metres of the way of the navigator's search; None without one."""
        with suppress(NoPath):
            return find_path(self.terrain, here, goal, seconds=SEARCH_TIME).length
        return None

    def shortest(self, start: PlanarPose) -> NDArray[np.float64]:
        """Metres of the shortest way from a place to each cell, inf without one.

        It goes to 8 neighbours, half the robot's width and `BESIDE` from obstacles, and over no step that the robot
        does not climb.
        """
        terrain, mobility = self.terrain, self.terrain.mobility
        begin = terrain.cell(start.x, start.y)
        if begin is None:  # the robot has left the map
            return np.full(terrain.shape, np.inf)
        free = terrain.distance >= mobility.half_width + terrain.margin
        free[begin] = True
        count = free.size
        cells = np.arange(count).reshape(free.shape)
        starts, ends, lengths = [], [], []
        for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
            left = slice(max(0, -right), free.shape[1] - max(0, right))
            beside = slice(max(0, right), free.shape[1] + min(0, right))
            one, other = np.s_[: free.shape[0] - down, left], np.s_[down:, beside]
            up = self._heights[other] - self._heights[one]
            both = free[one] & free[other]
            for first, last, climb in ((one, other, up), (other, one, -up)):
                passable = both & (climb >= -mobility.step) & (climb <= mobility.flipper_step)
                starts.append(cells[first][passable])
                ends.append(cells[last][passable])
                lengths.append(np.full(np.count_nonzero(passable), terrain.resolution * math.hypot(down, right)))
        edges = np.concatenate(starts), np.concatenate(ends)
        graph = sparse.csr_matrix((np.concatenate(lengths), edges), shape=(count, count))
        found = csgraph.dijkstra(graph, indices=int(cells[begin]))
        return np.asarray(found, np.float64).reshape(free.shape)
