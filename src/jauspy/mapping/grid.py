"""An occupancy grid: the probability, for each cell of the floor, that it is occupied."""

from __future__ import annotations

import math
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose

Points: TypeAlias = NDArray[np.float64]
"""Shape (n, 2): rows of x, y in metres."""

HIT_LOG_ODDS: Final = 0.9
MISS_LOG_ODDS: Final = -0.4
"""Added to the log odds of a cell in which a ray ends, or which it crosses; ends are rarer and more certain."""
HIT_MARGIN: Final = 1.5
"""Cells before the end of a ray that do not count as crossed, since distances have errors."""
MAX_LOG_ODDS: Final = 5.0
"""Log odds are limited to plus and minus this, so that a map can still change."""
OCCUPIED_THRESHOLD: Final = 0.65
FREE_THRESHOLD: Final = 0.196
"""Probabilities above and below which a cell is occupied or free: the thresholds of ROS's map_server."""
MAX_CELLS: Final = 4000
"""Cells along a side."""


class OccupancyGrid:
    """A square of `size` metres around the origin, in cells of `resolution` metres.

    Arrays have the shape (cells, cells): rows along y, columns along x, both ascending.
    """

    def __init__(self, size: float = 40.0, resolution: float = 0.05) -> None:
        cells = round(size / resolution)
        if not 2 <= cells <= MAX_CELLS:
            many = f"{size:g} m in cells of {resolution:g} m are {cells} cells along a side"
            raise ConfigError(f"{many}; a map has 2..{MAX_CELLS}, so choose other sizes")
        self.resolution = resolution
        self.cells = cells
        self.low = -cells * resolution / 2.0
        """x and y of the lower left corner, metres."""
        self.log_odds: NDArray[np.float64] = np.zeros((cells, cells))
        self.outside = 0
        """Number of echoes outside of the map, which were ignored."""

    def add(self, start: Points, ends: Points, echoes: NDArray[np.bool_]) -> None:
        """Add rays from a point, shape (2,), to `ends`, shape (n, 2); `echoes`, shape (n,), end at an obstacle."""
        hits = self._flat(ends[echoes])
        self.outside += int(np.count_nonzero(echoes)) - len(hits)
        shortened = _shortened(start, ends, echoes * np.float64(HIT_MARGIN * self.resolution))
        crossed = np.setdiff1d(self._flat(_sampled(start, shortened, self.resolution / 2.0)), hits)
        odds = self.log_odds.reshape(-1)
        odds[crossed] = np.maximum(-MAX_LOG_ODDS, odds[crossed] + MISS_LOG_ODDS)
        once = np.unique(hits)
        odds[once] = np.minimum(MAX_LOG_ODDS, odds[once] + HIT_LOG_ODDS)

    def probabilities(self) -> NDArray[np.float64]:
        """Shape (cells, cells); 0.5 where nothing is known."""
        found: NDArray[np.float64] = 1.0 / (1.0 + np.exp(-self.log_odds))
        return found

    def occupancy(self) -> NDArray[np.int8]:
        """Shape (cells, cells), as in ROS: 100 occupied, 0 free, -1 unknown."""
        found = np.full(self.log_odds.shape, -1, np.int8)
        probable = self.probabilities()
        found[probable > OCCUPIED_THRESHOLD] = 100
        found[probable < FREE_THRESHOLD] = 0
        return found

    def cell_coordinates(self, points: Points) -> NDArray[np.float64]:
        """Column and row of points, shape (n, 2), as fractions: whole numbers are centres of cells."""
        place: NDArray[np.float64] = (points - self.low) / self.resolution - 0.5
        return place

    def _flat(self, points: Points) -> NDArray[np.intp]:
        """Flat indices of the cells of points; points outside are dropped."""
        cells = np.floor((points - self.low) / self.resolution).astype(np.intp)
        inside = ((cells >= 0) & (cells < self.cells)).all(axis=1)
        found: NDArray[np.intp] = cells[inside, 1] * self.cells + cells[inside, 0]
        return found


def _shortened(start: Points, ends: Points, by: NDArray[np.float64]) -> Points:
    rays = ends - start
    lengths = np.hypot(rays[:, 0], rays[:, 1])
    left: Points = start + rays * np.maximum(0.0, 1.0 - by / np.maximum(lengths, 1e-9))[:, None]
    return left


def _sampled(start: Points, ends: Points, step: float) -> Points:
    """Points from the start to each end, at most `step` apart, without the ends."""
    rays = ends - start
    counts = np.maximum(1, np.ceil(np.hypot(rays[:, 0], rays[:, 1]) / step)).astype(np.intp)
    which = np.repeat(np.arange(len(rays)), counts)
    number = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
    sampled: Points = start + rays[which] * (number / counts[which])[:, None]
    return sampled


def transformed(pose: PlanarPose, points: Points) -> Points:
    """Points of the pose's frame in the outer one."""
    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    moved: Points = points @ np.array([[c, s], [-s, c]]) + (pose.x, pose.y)
    return moved
