"""An occupancy grid: how likely it is that something stands in each cell of the floor."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.mapping.pose import Points

HIT_LOG_ODDS: Final = 0.9
MISS_LOG_ODDS: Final = -0.4
"""Log odds that a ray which ends in a cell, or crosses it, adds: ends are rarer and surer."""
HIT_MARGIN: Final = 1.5
"""Cells before the end of a ray that do not count as crossed: distances have errors, and walls lie between cells."""
MAX_LOG_ODDS: Final = 5.0
"""Most log odds either way, so that a map can still change."""
OCCUPIED_THRESHOLD: Final = 0.65
FREE_THRESHOLD: Final = 0.196
"""Probabilities above and below which a cell is said to be so: map_server's own thresholds."""
MAX_CELLS: Final = 4000
"""Along a side."""


class OccupancyGrid:
    """A square of `size` metres around the origin, in cells of `resolution` metres; what is outside is left out.

    Rows are y and columns x, from the least on.
    """

    def __init__(self, size: float = 40.0, resolution: float = 0.05) -> None:
        cells = round(size / resolution)
        if not 2 <= cells <= MAX_CELLS:
            many = f"{size:g} m in cells of {resolution:g} m are {cells} cells along a side"
            raise ConfigError(f"{many}; a map has 2..{MOST_CELLS}, so choose other sizes")
        self.resolution = resolution
        self.cells = cells
        self.low = -cells * resolution / 2.0
        """The least x and y."""
        self.log_odds: NDArray[np.float64] = np.zeros((cells, cells))
        self.outside = 0
        """Ends of rays that were outside of the map."""

    def add(self, start: Points, ends: Points, echoes: NDArray[np.bool_]) -> None:
        """Rays from one point; those with an echo end at something."""
        hits = self._flat(ends[echoes])
        self.outside += int(np.count_nonzero(echoes)) - len(hits)
        way = _shortened(start, ends, echoes * np.float64(HIT_MARGIN * self.resolution))
        crossed = np.setdiff1d(self._flat(_along(start, way, self.resolution / 2.0)), hits)
        odds = self.log_odds.reshape(-1)
        odds[crossed] = np.maximum(-MAX_LOG_ODDS, odds[crossed] + MISS_LOG_ODDS)
        once = np.unique(hits)
        odds[once] = np.minimum(MAX_LOG_ODDS, odds[once] + HIT_LOG_ODDS)

    def probabilities(self) -> NDArray[np.float64]:
        """Of each cell that something is there; 0.5 where nothing is known."""
        found: NDArray[np.float64] = 1.0 / (1.0 + np.exp(-self.log_odds))
        return found

    def occupancy(self) -> NDArray[np.int8]:
        """ROS's terms: 100 for occupied, 0 for free, -1 for unknown."""
        found = np.full(self.log_odds.shape, -1, np.int8)
        probable = self.probabilities()
        found[probable > OCCUPIED_THRESHOLD] = 100
        found[probable < FREE_THRESHOLD] = 0
        return found

    def at(self, points: Points) -> NDArray[np.float64]:
        """Column and row of points, as fractions: whole numbers are middles of cells."""
        place: NDArray[np.float64] = (points - self.low) / self.resolution - 0.5
        return place

    def _flat(self, points: Points) -> NDArray[np.intp]:
        """Indices of the cells that points are in; points outside are left out."""
        cells = np.floor((points - self.low) / self.resolution).astype(np.intp)
        inside = ((cells >= 0) & (cells < self.cells)).all(axis=1)
        found: NDArray[np.intp] = cells[inside, 1] * self.cells + cells[inside, 0]
        return found


def _shortened(start: Points, ends: Points, by: NDArray[np.float64]) -> Points:
    rays = ends - start
    lengths = np.hypot(rays[:, 0], rays[:, 1])
    left: Points = start + rays * np.maximum(0.0, 1.0 - by / np.maximum(lengths, 1e-9))[:, None]
    return left


def _along(start: Points, ends: Points, step: float) -> Points:
    """Points on the way from the start to each end, at most `step` apart; the ends are not among them."""
    rays = ends - start
    counts = np.maximum(1, np.ceil(np.hypot(rays[:, 0], rays[:, 1]) / step)).astype(np.intp)
    which = np.repeat(np.arange(len(rays)), counts)
    number = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
    way: Points = start + rays[which] * (number / counts[which])[:, None]
    return way
