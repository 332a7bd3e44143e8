"""Smooth motions along paths of straight pieces: splines that do not stop at corners, and are as free as the path."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Final

import numpy as np

from jauspy.cell.frames import Array
from jauspy.platform.modular.arm import TrajectoryPoint
from jauspy.platform.modular.splines import Knots, Spline
from jauspy.platform.modular.trajectory import Setpoint

DIVISIONS: Final = 4
"""Number of times that all pieces are halved until the spline is free."""
MAX_POINTS: Final = 60
SHORTEST: Final = 0.05
"""Seconds of the shortest piece."""
SAMPLE: Final = 0.04
"""Radians of the fastest joint between two postures of the spline that are checked."""


def smoothed(
    points: Sequence[Array], speeds: Array, accelerations: Array, is_free: Callable[[Sequence[Array]], bool]
) -> list[TrajectoryPoint] | None:
    """A trajectory from the first point to rest at the last one; None if no spline near the path is free.

    It keeps within these speeds (rad/s) and accelerations (rad/s^2). `is_free` judges postures along it, which are
    joined by straight pieces. The closer the points are, the closer a spline is to the path.
    """
    rows = list(points)
    for _ in range(DIVISIONS):
        if len(rows) > MAX_POINTS:
            break
        times = _times(rows, speeds, accelerations)
        if is_free(_postures(_spline(rows, times))):
            pairs = zip(times.tolist(), rows[1:], strict=True)
            return [TrajectoryPoint(time, tuple(map(float, row))) for time, row in pairs]
        rows = [rows[0], *(point for a, b in pairwise(rows) for point in ((a + b) / 2.0, b))]
    return None


def _spline(rows: Sequence[Array], times: Array) -> Spline:
    rest = np.zeros_like(rows[0])
    free = np.full((len(times), len(rest)), np.nan)
    return Spline(Setpoint(rows[0], rest, rest), Knots(times, np.array(rows[1:]), free, free.copy()))


def _times(rows: Sequence[Array], speeds: Array, accelerations: Array) -> Array:
    """Times of the points after the first: by the length of each piece, as short as the limits allow."""
    steps = [max(SHORTEST, float(np.max(np.abs(b - a) / speeds))) for a, b in pairwise(rows)]
    times = np.cumsum(steps)
    spline = _spline(rows, times)
    sampled = [spline.at_time(float(time)) for time in np.linspace(0.0, spline.duration, 20 * len(rows))]
    fast = max(float(np.max(np.abs(v) / speeds)) for _, v, _ in sampled)
    hard = max(float(np.max(np.abs(a) / accelerations)) for _, _, a in sampled)
    scaled: Array = times * max(fast, np.sqrt(hard))
    return scaled


def _postures(spline: Spline) -> list[Array]:
    """Postures along a spline, at most `SAMPLE` radians apart on average of each tenth of a second."""
    count = max(2, int(spline.duration / 0.1))
    marks = np.linspace(0.0, spline.duration, count + 1)
    found = [spline.at_time(0.0)[0]]
    for a, b in pairwise(marks.tolist()):
        way = float(np.max(np.abs(spline.at_time(b)[0] - spline.at_time(a)[0])))
        parts = max(1, int(np.ceil(way / SAMPLE)))
        found += [spline.at_time(a + (b - a) * part / parts)[0] for part in range(1, parts + 1)]
    return found
