"""Slope, roughness and steps of a grid of heights."""

from __future__ import annotations

import math
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Heights: TypeAlias = NDArray[np.float32]
"""Metres, shape (rows, columns): rows along y, columns along x; NaN where unknown."""
Floats: TypeAlias = NDArray[np.float64]

MIN_KNOWN: Final = 6
"""Known cells in a square to which a plane is fitted, at least."""
MIN_SPREAD: Final = 0.1
"""Determinant of the scatter of the known cells as part of that of a whole square; cells along a line are less."""


def fitted_planes(heights: Heights, resolution: float, radius: float) -> tuple[Heights, Heights]:
    """Inclination (rad) of the plane around each cell, and the deviation (m, root mean square) of the cells from it.

    The plane is fitted to the known cells in a square that reaches `radius` metres to each side.
    """
    half = max(1, round(radius / resolution))
    known = np.isfinite(heights)
    z = np.where(known, heights, 0.0).astype(np.float64)
    z -= z[known].mean() if known.any() else 0.0
    z[~known] = 0.0
    one = known.astype(np.float64)
    y, x = (index * resolution for index in np.indices(heights.shape))
    n, sx, sy, sz, sxx, sxy, syy, sxz, syz, szz = (
        _box_sums(values * one, half) for values in (one, x, y, z, x * x, x * y, y * y, x * z, y * z, z * z)
    )
    n = np.maximum(n, 1.0)
    cxx, cxy, cyy = sxx - sx * sx / n, sxy - sx * sy / n, syy - sy * sy / n
    cxz, cyz, czz = sxz - sx * sz / n, syz - sy * sz / n, szz - sz * sz / n
    determinant = cxx * cyy - cxy * cxy
    side = (2 * half + 1) ** 2
    whole = (side * resolution**2 * half * (half + 1) / 3.0) ** 2
    enough = known & (n >= MIN_KNOWN) & (determinant > MIN_SPREAD * whole * (n / side) ** 2)
    safe = np.where(enough, determinant, 1.0)
    a, b = (cyy * cxz - cxy * cyz) / safe, (cxx * cyz - cxy * cxz) / safe
    left = np.maximum(0.0, czz - a * cxz - b * cyz) / n
    slope, deviation = np.arctan(np.hypot(a, b)), np.sqrt(left)
    return tuple(np.where(enough, found, np.nan).astype(np.float32) for found in (slope, deviation))  # type: ignore[return-value]


def largest_steps(heights: Heights) -> Heights:
    """The greatest difference of height between each cell and the eight around it, metres; NaN if none is known."""
    padded = np.pad(heights, 1, constant_values=math.nan)
    rows, columns = heights.shape
    found = np.full(heights.shape, np.nan, np.float32)
    for down in range(3):
        for right in range(3):
            if (down, right) != (1, 1):
                found = np.fmax(found, np.abs(padded[down : down + rows, right : right + columns] - heights))
    return found


def _box_sums(values: Floats, half: int) -> Floats:
    """The sum over the square that reaches `half` cells to each side, for each cell."""
    for axis in (0, 1):
        ends = [(0, 0), (0, 0)]
        ends[axis] = (half + 1, half)
        total = np.cumsum(np.pad(values, ends), axis=axis)
        length = total.shape[axis]
        upper = np.take(total, range(2 * half + 1, length), axis=axis)
        values = upper - np.take(total, range(length - 2 * half - 1), axis=axis)
    return values
