"""What an elevation grid tells of the ground: walls, steps, slopes, and what lies there; also what it told before.

Cells are those of the grid: rows along y, columns along x, both ascending. Metres; slopes are tangents.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from jauspy.planning.mobility import Mobility

Array: TypeAlias = NDArray[np.floating[Any]]
Cells: TypeAlias = NDArray[np.bool_]

HIDDEN: Final = 2.0
"""Metres of unknown ground between known ground of which the height is assumed."""
THING: Final = 0.02
THING_SIZE: Final = 0.7
"""Metres above the ground from which on something lies there, and its longest side; what is longer is ground."""
LEAST_KNOWN: Final = 0.3
"""Part of the cells around one whose heights must be known for a slope to be known."""
CHANGED: Final = 0.04
"""Metres by which a height must differ to replace what is remembered where more was known."""
AROUND: Final = 5
"""Cells along a side of the square around a cell of which the measured ones are counted: steps are sought in it."""
SIZE: Final = 48.0
"""Metres along a side of what is remembered."""


class Heights(Protocol):
    """An elevation grid (`mapping.elevation`)."""

    @property
    def origin(self) -> tuple[float, float]:
        """Corner of the first cell, x and y in metres."""
        ...

    @property
    def resolution(self) -> float:
        """Side of a cell, metres."""
        ...

    @property
    def heights(self) -> NDArray[np.float32]:
        """Metres, shape (rows along y, columns along x); NaN where unknown."""
        ...


@dataclass(frozen=True, slots=True)
class Ground:
    """The ground in cells of `resolution` metres from `origin`, the corner of the first one, x and y."""

    origin: tuple[float, float]
    resolution: float
    heights: Array
    """Metres, with those of hidden ground; NaN where unknown."""
    walls: Array
    """Metres of the highest step from each cell down to those beside it."""
    steps: Array
    """Metres of the highest step down or up that flippers climb; 0 where all are higher."""
    slope_x: Array
    slope_y: Array
    things: Array
    """1 where something lies on the ground, else 0."""
    hidden: Array
    """1 where nothing was ever seen though a sensor was near, else 0."""
    age: Array
    """Seconds since it was seen last; NaN where that is not known."""
    old: Array
    """1 where nothing is known now, and what was known before is told, else 0."""

    @classmethod
    def of(
        cls, elevation: Heights, mobility: Mobility, hidden: Cells | None = None, ages: Array | None = None
    ) -> Ground:
        """The ground for a robot.

        Ground is taken for low only in cells that are `hidden`, by default in all whose heights are unknown: the little
        that is seen from far away tells no edges, and what was forgotten is not low. `ages` are seconds since cells
        were seen, by default not known.
        """
        highest, side = mobility.flipper_step, elevation.resolution
        if hidden is None:
            hidden = np.isnan(elevation.heights)
        heights = _with_hidden(elevation, highest, hidden)
        walls, steps = _jumps(heights, highest)
        slope_x, slope_y = _gradients(heights, side, mobility.half_width, highest)
        nothing = np.zeros(heights.shape, np.float32)
        age = nothing + np.nan if ages is None else ages
        others = _things(heights, side), hidden.astype(np.float32), age, nothing
        return cls(elevation.origin, side, heights, walls, steps, slope_x, slope_y, *others)

    @classmethod
    def unknown(cls, origin: tuple[float, float], side: float, shape: tuple[int, ...]) -> Ground:
        """Ground of which nothing is known."""
        return cls(origin, side, *(np.full(shape, EMPTY.get(name, 0.0), np.float32) for name in LAYERS))

    def resampled(self, origin: tuple[float, float], side: float, shape: tuple[int, ...]) -> Ground:
        """The ground in cells of another grid, of `side` metres from `origin`; what is outside is unknown."""
        rows, columns = shape
        xs = origin[0] + (np.arange(columns) + 0.5) * side
        ys = origin[1] + (np.arange(rows) + 0.5) * side
        source_x = np.floor((xs - self.origin[0]) / self.resolution).astype(np.intp)
        source_y = np.floor((ys - self.origin[1]) / self.resolution).astype(np.intp)
        ok_x = (source_x >= 0) & (source_x < self.heights.shape[1])
        ok_y = (source_y >= 0) & (source_y < self.heights.shape[0])
        found = Ground.unknown(origin, side, shape)
        inside, source = np.ix_(ok_y, ok_x), np.ix_(source_y[ok_y], source_x[ok_x])
        for name in LAYERS:
            getattr(found, name)[inside] = getattr(self, name)[source]
        return found


REMEMBERED: Final = ("heights", "walls", "steps", "slope_x", "slope_y")
LAYERS: Final = (*REMEMBERED, "things", "hidden", "age", "old")
"""Names of the layers of a ground that are remembered, and of all, in their order."""
EMPTY: Final = {"heights": math.nan, "age": math.nan}
"""Values of layers where nothing is known, if not 0."""


class GroundMemory:
    """The ground in a square that follows the robot, as it was when most around each cell was measured.

    Elevation grids forget heights, since those of what is seen again would be a step beside old ones. A robot that
    forgets edges drives to and fro before them. So steps and slopes are remembered, and not computed anew from heights
    of different times. What has come since is new, even if it hides what was known around it; what is only taken for
    low ground is not.
    """

    def __init__(self) -> None:
        self._ground: Ground | None = None
        self._measured: Array = np.zeros((0, 0), np.float32)
        """Part of the cells around each one that was measured then; 0 where it was not."""

    def completed(self, ground: Ground) -> Ground:
        """Remember a ground; returns it with what was known before where less is known now.

        Things, ages, and what is hidden, are those of now. Cells of all grounds have one size, and borders at the same
        places.
        """
        memory = self._around(ground)
        here, source = _overlap(ground, memory)
        known, hidden = ~np.isnan(ground.heights[source]), ground.hidden[source] > 0.0
        around = ndimage.uniform_filter((~np.isnan(ground.heights) & (ground.hidden == 0.0)).astype(np.float32), AROUND)
        measured, before = known & ~hidden, self._measured[here]
        newer = around[source] >= before - 0.5 / AROUND**2
        newer |= np.abs(ground.heights[source] - memory.heights[here]) > CHANGED
        newer = (measured & newer) | (known & (before == 0.0))
        before[newer] = np.where(measured, around[source], 0.0)[newer]
        for name in REMEMBERED:
            getattr(memory, name)[here][newer] = getattr(ground, name)[source][newer]
        found = Ground.unknown(memory.origin, memory.resolution, memory.heights.shape)
        for name in REMEMBERED:
            getattr(found, name)[...] = getattr(memory, name)
        for name in ("things", "hidden", "age"):
            getattr(found, name)[here] = getattr(ground, name)[source]
        found.old[...] = ~np.isnan(memory.heights)
        found.old[here][known] = 0.0
        return found

    def _around(self, ground: Ground) -> Ground:
        """The memory, moved so that it has a ground in it."""
        memory, side = self._ground, ground.resolution
        cells = max(round(SIZE / side), *ground.heights.shape)
        rows, columns = ground.heights.shape
        if memory is not None:
            here, _ = _overlap(ground, memory)
            if memory.heights[here].shape == (rows, columns):
                return memory
        low = [
            (round(corner / side) - (cells - count) // 2) * side
            for corner, count in zip(ground.origin, (columns, rows), strict=True)
        ]
        moved, measured = Ground.unknown((low[0], low[1]), side, (cells, cells)), np.zeros((cells, cells), np.float32)
        if memory is not None:
            here, source = _overlap(memory, moved)
            measured[here] = self._measured[source]
            for name in REMEMBERED:
                getattr(moved, name)[here] = getattr(memory, name)[source]
        self._measured, self._ground = measured, moved
        return moved


Window: TypeAlias = tuple[slice, slice]


def _overlap(ground: Ground, other: Ground) -> tuple[Window, Window]:
    """Cells of the other ground that a ground covers, and those of the ground there: rows and columns."""
    windows = []
    for axis in (1, 0):
        first = round((ground.origin[axis] - other.origin[axis]) / other.resolution)
        count, all_cells = ground.heights.shape[1 - axis], other.heights.shape[1 - axis]
        begin, end = min(max(first, 0), all_cells), max(0, min(first + count, all_cells))
        end = max(begin, end)
        windows.append((slice(begin, end), slice(begin - first, end - first)))
    (rows, source_rows), (columns, source_columns) = windows
    return (rows, columns), (source_rows, source_columns)


def _with_hidden(elevation: Heights, highest: float, hidden: Cells) -> Array:
    """Heights, with those of ground between known cells that is hidden by what is nearer: as low as the lower end.

    Behind an edge, where a sensor on the ground does not see, ground may be as low as what is known beyond. The tops of
    walls, above steps of `highest` metres, tell nothing about ground beside them. Only in cells that are `hidden`.
    """
    resolution = elevation.resolution
    seen = elevation.heights.astype(np.float32)
    heights = np.where(_jumps(seen, highest)[0] > highest, np.nan, seen)
    found = heights.copy()
    longest = round(HIDDEN / resolution)
    for axis in (0, 1):
        lines = np.moveaxis(heights, axis, 0)
        known = ~np.isnan(lines)
        numbers = np.where(known, np.arange(len(lines))[:, None], -1)
        before = np.maximum.accumulate(numbers, axis=0)
        after = np.minimum.accumulate(np.where(known, numbers, len(lines))[::-1], axis=0)[::-1]
        rows, columns = np.nonzero(~known & (before >= 0) & (after < len(lines)) & (after - before <= longest + 1))
        lower = np.minimum(lines[before[rows, columns], columns], lines[after[rows, columns], columns])
        filled = np.moveaxis(found, axis, 0)
        filled[rows, columns] = np.fmin(filled[rows, columns], lower)
    return np.where(hidden & np.isnan(seen), found, seen)


def _things(heights: Array, resolution: float) -> Array:
    """1 in cells of what lies on the ground: all that is raised above it, and no longer than `THING_SIZE`; else 0."""
    known = ~np.isnan(heights)
    if not known.any():
        return np.zeros(heights.shape, np.float32)
    nearest = ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True)
    filled = heights[tuple(nearest)]
    longest = max(1, round(THING_SIZE / resolution))
    raised = filled - ndimage.grey_opening(filled, longest + 1) > THING  # what is seen of a pavement in dots is one
    labels, _ = ndimage.label(raised, np.ones((3, 3)))
    short = [False, *(max(s.stop - s.start for s in sides) <= longest for sides in ndimage.find_objects(labels))]
    return np.asarray(np.array(short)[labels] & known, np.float32)


def _jumps(heights: Array, highest: float) -> tuple[Array, Array]:
    """Height, metres, of the highest step from each cell down to those beside it; and down or up, if not too high.

    These are 0 where nothing is known, or where all steps are above `highest`.
    A step is a jump between two cells, or over the one between them, which it may share. A jump that goes on at both
    sides is a slope: of each the least one within two cells is subtracted; over two cells, that before or after it.
    """
    falls, found = np.zeros(heights.shape), np.zeros(heights.shape)
    for axis in (0, 1):
        for cells in (1, 2):
            jumps = _differences(heights, axis, cells)
            up, down = (np.maximum(some, 0.0) - _slope(some, axis, cells) for some in (jumps, -jumps))
            either = np.maximum(up, down)
            count = heights.shape[axis] - cells
            for first in range(cells + 1):
                side = tuple(slice(first, first + count) if a == axis else slice(None) for a in (0, 1))
                if first in (0, cells):
                    falls[side] = np.maximum(falls[side], up if first else down)
                found[side] = np.maximum(found[side], np.where(either <= highest, either, 0.0))
    return falls, found


def _differences(heights: Array, axis: int, cells: int) -> Array:
    """Differences between each cell and the one so many cells after it; 0 if unknown."""
    count = heights.shape[axis] - cells
    high = np.moveaxis(heights.astype(np.float64), axis, 0)
    found: Array = np.moveaxis(np.nan_to_num(high[cells:] - high[:count], nan=0.0), 0, axis)
    return found


def _slope(jumps: Array, axis: int, cells: int) -> Array:
    """The part of each jump upward that is a slope, metres."""
    if cells == 1:
        size = [1, 1]
        size[axis] = 5
        return np.asarray(np.maximum(ndimage.minimum_filter(jumps, size, mode="nearest"), 0.0), np.float64)
    beside = np.moveaxis(np.maximum(jumps, 0.0), axis, 0)
    found = np.zeros(beside.shape)
    found[cells:] = beside[:-cells]
    found[:-cells] = np.maximum(found[:-cells], beside[cells:])
    return np.asarray(np.moveaxis(np.minimum(found, beside), 0, axis), np.float64)


def _gradients(heights: Array, resolution: float, reach: float, highest: float) -> tuple[Array, Array]:
    """Slopes along x and y around each cell, as tangents: means of the differences between neighbouring cells.

    The means are those of a square of `reach` metres to each side. Steps above `highest`, in metres, such as walls, and
    what is not known do not count.
    """
    size = 2 * max(1, round(reach / resolution)) + 1
    slopes = []
    for axis in (1, 0):
        jumps = np.zeros(heights.shape)
        after = np.s_[:, 1:] if axis == 1 else np.s_[1:, :]
        jumps[after] = np.diff(heights.astype(np.float64), axis=axis)
        counted = np.isfinite(jumps) & (np.abs(jumps) <= highest)
        total = ndimage.uniform_filter(np.where(counted, jumps, 0.0), size, mode="constant")
        share = ndimage.uniform_filter(counted.astype(np.float64), size, mode="constant")
        slopes.append(np.where(share > LEAST_KNOWN, total / np.maximum(share, LEAST_KNOWN) / resolution, 0.0))
    return slopes[0], slopes[1]
