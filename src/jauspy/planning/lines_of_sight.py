"""What a sensor looked through in one measurement: the nearest distance in each direction, at several resolutions.

A voxel was seen through if all rays that could meet it went on beyond it. Its angular size decides at which resolution
it is compared: a near voxel spans many rays of a camera, and between those of a lidar lie voxels that none of them met.
On a surface at a grazing angle the rays beside the middle of a voxel matter, since that through its middle goes on.
"""

from __future__ import annotations

import math
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

FINEST: Final = math.radians(0.2)
"""Angle of the smallest directions that are told apart: a ray of a usual depth camera."""
LEVELS: Final = 6
"""Resolutions, each half as fine as the one before."""
_PAD: Final = 1 << LEVELS
_COLUMNS: Final = math.ceil(math.tau / FINEST / _PAD) * _PAD
_ROWS: Final = math.ceil(math.pi / FINEST / _PAD) * _PAD
_STEP: Final = math.tau / _COLUMNS
WINDOW: Final = 4
"""Directions across and up that a voxel is compared with. Each is a quarter to a half as wide as the voxel: wider
ones would reach beyond it, so that what stood on the ground would never vanish; narrower ones would leave out its
edges, so that ground seen at a grazing angle would."""


class LinesOfSight:
    """Rays of one measurement; points are in the sensor's frame, shape (n, 3), metres.

    `ends` are points that reflected rays, `empty` those up to which rays without an echo met nothing.
    """

    def __init__(self, ends: Array, empty: Array | None = None) -> None:
        rays = ends if empty is None else np.concatenate((ends, empty))
        distances, columns, rows = _directions(rays)
        # only the part of the sphere that has rays is stored: a camera sees a small one
        self._first = int(rows.min(initial=0)) >> LEVELS << LEVELS
        self._rows = ((int(rows.max(initial=0)) >> LEVELS) + 1 << LEVELS) - self._first
        nearest = np.full((self._rows, _COLUMNS), np.inf)
        np.minimum.at(nearest, (rows - self._first, columns), distances)
        self._levels = [nearest]
        for _ in range(LEVELS):
            pairs = np.minimum(self._levels[-1][::2], self._levels[-1][1::2])
            self._levels.append(np.minimum(pairs[:, ::2], pairs[:, 1::2]))

    def pass_through(self, points: Array, size: float) -> Flags:
        """For each cube of edge `size` around a point: True if rays in its direction went on beyond it."""
        distances = np.sqrt(np.einsum("ni,ni->n", points, points))
        near = np.maximum(distances, 1e-6)
        columns = (np.arctan2(points[:, 1], points[:, 0]) + math.pi) / _STEP
        rows = (np.arcsin(np.clip(points[:, 2] / near, -1.0, 1.0)) + math.pi / 2.0) / _STEP - self._first
        wide = np.ceil(np.log2(np.maximum(size / near / _STEP / WINDOW, 1.0))).astype(np.int64)
        nearest = np.full(len(points), np.inf)
        for level in np.unique(wide[wide <= LEVELS]).tolist():
            chosen = np.flatnonzero(wide == level)
            nearest[chosen] = _least(self._levels[level], rows[chosen] / (1 << level), columns[chosen] / (1 << level))
        found: Flags = np.isfinite(nearest) & (nearest > distances + size)
        return found


def _directions(points: Array) -> tuple[Array, NDArray[np.int64], NDArray[np.int64]]:
    distances = np.sqrt(np.einsum("ni,ni->n", points, points))
    columns = ((np.arctan2(points[:, 1], points[:, 0]) + math.pi) / _STEP).astype(np.int64) % _COLUMNS
    height = np.arcsin(np.clip(points[:, 2] / np.maximum(distances, 1e-6), -1.0, 1.0))
    return distances, columns, ((height + math.pi / 2.0) / _STEP).astype(np.int64)


def _least(image: Array, rows: Array, columns: Array) -> Array:
    """The least value of the pixels around positions; those outside of the rows have none."""
    least = np.full(len(rows), np.inf)
    first = (WINDOW - 1) / 2.0
    top, left = np.floor(rows - first).astype(np.int64), np.floor(columns - first).astype(np.int64)
    around = [(left + across) % image.shape[1] for across in range(WINDOW)]
    for down in range(WINDOW):
        row = top + down
        inside = (row >= 0) & (row < image.shape[0])
        start = np.where(inside, row, 0) * image.shape[1]
        nearest = np.full(len(rows), np.inf)
        for column in around:
            np.minimum(nearest, image.take(start + column), out=nearest)
        np.minimum(least, nearest, out=least, where=inside)
    return least
