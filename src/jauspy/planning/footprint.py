"""Clearance of a robot's footprint: metres between it and the nearest blocked cell of a map, at any pose.

It has two shapes: few circles, which reach some decimetres before and behind the robot, and tiles, which hardly do. The
first one keeps a robot off walls when it turns some centimetres before or behind the corner of its way.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from jauspy.planning.mobility import Mobility

OUTSIDE: Final = -1e6
"""Distance outside of the map, metres."""
MAX_HEADINGS: Final = 256
"""Headings for which shapes are kept."""

_Cells = NDArray[np.float64]


class Footprint:
    """The footprint of a robot in a map of cells of `resolution` metres from the corner `origin`, rows along y.

    `distance` has the metres from the centre of each cell to the nearest blocked one.
    """

    def __init__(
        self, mobility: Mobility, distance: NDArray[np.float32], origin: tuple[float, float], resolution: float
    ) -> None:
        self._origin, self._resolution, self._shape = origin, resolution, distance.shape
        self._circles, self._radius = mobility.circles
        self.reach = max(abs(centre) for centre in self._circles) + self._radius
        """Metres from the robot's base to the farthest part of the circles."""
        centres = np.column_stack([self._circles, np.zeros(len(self._circles))])
        self._shapes = {False: (centres, np.array([self._radius])), True: mobility.tiles}
        """Centres, x and y, and radii of the circles, and of those around the tiles."""
        self._beside = math.ceil(self.reach / resolution) + 1
        """Cells around the map that are `OUTSIDE`, so that no tile of a robot in the map is out of the array."""
        padded = np.pad(np.pad(distance, 1, mode="edge"), self._beside - 1, constant_values=OUTSIDE)
        self._distance, self._width = padded.ravel(), padded.shape[1]
        self._turned: dict[tuple[float, bool], tuple[_Cells, _Cells]] = {}
        """Columns and rows of the centres by heading and shape, for a robot whose base is in the centre of cell 0."""

    def clearance(self, x: float, y: float, heading: float, enough: float, *, is_exact: bool) -> float:
        """The clearance at a pose; below 0 inside of blocked cells, -inf outside of the map.

        It is exact with tiles; from `enough` metres on it may be more.
        """
        column, row = self._place(x), self._place(y, 1)
        rows, columns = self._shape
        if not (-0.5 <= row < rows - 0.5 and -0.5 <= column < columns - 0.5):
            return -math.inf
        c, s = math.cos(heading) / self._resolution, math.sin(heading) / self._resolution
        least = min(
            self._distance.item(
                (round(row + circle * s) + self._beside) * self._width + round(column + circle * c) + self._beside
            )
            for circle in self._circles
        )
        if not is_exact or least - self._radius >= enough:
            return least - self._radius
        return float(self._of_circles(column, row, heading, is_exact=True).min())

    def clearances(
        self, xs: NDArray[np.float64], ys: NDArray[np.float64], heading: float, *, is_exact: bool
    ) -> NDArray[np.float64]:
        """Clearances at points, shape (n,), with one heading."""
        columns, rows = self._place(xs), self._place(ys, 1)
        (height, width), found = self._shape, np.full(len(xs), -np.inf)
        inside = (rows >= -0.5) & (rows < height - 0.5) & (columns >= -0.5) & (columns < width - 0.5)
        circles = self._of_circles(columns[inside, None], rows[inside, None], heading, is_exact=is_exact)
        found[inside] = circles.min(axis=-1)
        return found

    def _place(self, value: Any, axis: int = 0) -> Any:
        """Columns or rows, with parts, of coordinates along an axis; whole numbers are centres of cells."""
        return (value - self._origin[axis]) / self._resolution - 0.5

    def _of_circles(self, column: Any, row: Any, heading: float, *, is_exact: bool) -> NDArray[np.float64]:
        """Clearances of the circles of a shape of a robot whose base is there; distances are interpolated."""
        centres, radii = self._shapes[is_exact]
        turned = self._turned.get((heading, is_exact))
        if turned is None:
            if len(self._turned) >= MAX_HEADINGS:
                self._turned.clear()
            c, s = math.cos(heading), math.sin(heading)
            x, y = centres.T / self._resolution
            turned = c * x - s * y + self._beside, s * x + c * y + self._beside
            self._turned[heading, is_exact] = turned
        columns, rows = turned[0] + column, turned[1] + row
        left, low = columns.astype(np.intp), rows.astype(np.intp)
        columns -= left
        rows -= low
        low *= self._width
        low += left
        corners = [self._distance[low + step] for step in (0, 1, self._width, self._width + 1)]
        lower = corners[0] + columns * (corners[1] - corners[0])
        upper = corners[2] + columns * (corners[3] - corners[2])
        found: NDArray[np.float64] = lower + rows * (upper - lower) - radii
        return found
