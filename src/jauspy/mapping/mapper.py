"""Makes a map out of scans and odometry, and says where the robot is on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.pose import PlanarPose, Points

Array: TypeAlias = NDArray[np.float64]

ATTRACTION_WIDTHS: Final = (6, 2)
"""Cells within which a mark on the map attracts the ends of rays, coarse first."""
MAX_ITERATIONS: Final = 12
MIN_POINTS: Final = 30
"""Ends of rays without which a scan is not matched."""
POINT_WEIGHT: Final = 4.0
"""Of the end of a ray: one that meets nothing counts as much as a guess that is two deviations off."""
MAX_STEP: Final = 0.05
"""Metres and radians of one step."""
MIN_STRAIGHTNESS: Final = 0.9
"""Cosine of the angle between ways from end to end above which they are on one wall."""
MIN_STEP: Final = 1e-5
"""Metres and radians of a step after which nothing changes any more."""


def match(grid: OccupancyGrid, points: Points, guess: PlanarPose, trust: tuple[float, float]) -> PlanarPose:
    """The pose near `guess` at which the ends of a scan, given in its frame, fit the map best.

    `trust`: how far the guess may be off, in metres and radians (standard deviations).
    """
    if len(points) < MIN_POINTS:
        return guess
    across = _normal_projections(points)
    occupied = grid.log_odds > 0.0
    prior = 1.0 / np.array([trust[0], trust[0], trust[1]]) ** 2
    pose = expected = np.array(guess)
    for cells in ATTRACTION_WIDTHS:
        near = _attraction(occupied, cells)
        for _ in range(MAX_ITERATIONS):
            step = _step(*_slopes(grid, near, (points, across), pose), prior, expected - pose)
            pose = pose + np.clip(step, -MAX_STEP, MAX_STEP)
            if np.abs(step).max() < MIN_STEP:
                break
    return PlanarPose(*pose.tolist())


def _step(missing: Array, slopes: Array, prior: Array, home: Array) -> Array:
    """What lessens the squares of what is missing at each end, and of the way home to the guess, most."""
    hessian = POINT_WEIGHT * slopes.T @ slopes + np.diag(prior)
    return np.asarray(np.linalg.solve(hessian, POINT_WEIGHT * slopes.T @ missing + prior * home), np.float64)


def _slopes(grid: OccupancyGrid, near: Array, scan: tuple[Points, Array], pose: Array) -> tuple[Array, Array]:
    """How much nearness each end lacks, and what it gains per metre of x and y and per radian of yaw."""
    points, across = scan
    there = PlanarPose(*pose.tolist()).apply(points)
    value, slope = _sample(grid, near, there)
    c, s = np.cos(pose[2]), np.sin(pose[2])
    turn = np.array([[c, -s], [s, c]])
    slope = np.einsum("nij,nj->ni", turn @ across @ turn.T, slope)
    around = there - pose[:2]
    return 1.0 - value, np.column_stack([slope, slope[:, 1] * around[:, 0] - slope[:, 0] * around[:, 1]])


def _normal_projections(points: Points) -> Array:
    """For each end the projection (2 x 2) on the direction in which it pulls: at right angles to the wall it is on.

    Along a wall it would pull to where the map knows the wall so far. Ends that are not in line with those beside them,
    corners and the rims of walls, pull nothing.
    """
    before, after = (np.roll(points, shift, axis=0) for shift in (1, -1))
    to, on = points - before, after - points
    lengths = np.maximum(np.hypot(*to.T) * np.hypot(*on.T), 1e-9)
    straight = (to * on).sum(axis=1) / lengths > MIN_STRAIGHTNESS
    along = after - before
    normal = np.column_stack([-along[:, 1], along[:, 0]]) / np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    projections: Array = normal[:, :, None] * normal[:, None, :] * straight[:, None, None]
    return projections


def _sample(grid: OccupancyGrid, near: Array, points: Points) -> tuple[Array, Array]:
    """Value and slope (per metre) between the middles of cells; outside of the map, what its rim has."""
    place = np.clip(grid.at(points), 0.0, grid.cells - 1.000001)
    column, row = np.floor(place).astype(np.intp).T
    u, v = (place - np.floor(place)).T
    a, b = near[row, column], near[row, column + 1]
    c, d = near[row + 1, column], near[row + 1, column + 1]
    value = (1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * c + u * d)
    slope = np.column_stack([(1.0 - v) * (b - a) + v * (d - c), (1.0 - u) * (c - a) + u * (d - b)])
    return value, slope / grid.resolution


_NEIGHBOURS: Final = (
    (np.s_[1:, :], np.s_[:-1, :]),
    (np.s_[:-1, :], np.s_[1:, :]),
    (np.s_[:, 1:], np.s_[:, :-1]),
    (np.s_[:, :-1], np.s_[:, 1:]),
)


def _attraction(occupied: NDArray[np.bool_], cells: int) -> Array:
    """1 where something is, less with the distance from it, 0 from `cells` cells on.

    The same all along a wall, however often it was hit: otherwise a scan would slide to where it was hit most.
    """
    near = np.zeros(occupied.shape)
    rows, columns = np.flatnonzero(occupied.any(axis=1)), np.flatnonzero(occupied.any(axis=0))
    if not len(rows):
        return near
    window = np.s_[_around(rows, cells), _around(columns, cells)]
    part = occupied[window].astype(np.float64)
    for _ in range(cells):
        before = part - 1.0 / cells
        for there, here in _NEIGHBOURS:
            np.maximum(part[there], before[here], out=part[there])
    near[window] = part
    return near


def _around(used: NDArray[np.intp], margin: int) -> slice:
    return slice(max(0, int(used[0]) - margin), int(used[-1]) + margin + 1)


MAX_RANGE: Final = 15.0
"""Metres that are mapped of a ray; farther away a small tilt of the robot counts for too much."""
MIN_DISTANCE: Final = 0.1
MIN_TURN: Final = math.radians(5.0)
"""Metres and radians of driving after which a scan goes into the map."""
ODOMETRY_DEVIATION: Final = (0.05, math.radians(2.0))
"""How far odometry may be off from one of those scans to the next, in metres and radians (standard deviations)."""


class Mapper:
    """Feed it scans; `grid` is the map, in the frame of the first odometry's origin."""

    def __init__(self, grid: OccupancyGrid | None = None, *, matching: bool = True, reach: float = MAX_RANGE) -> None:
        self.grid = grid or OccupancyGrid()
        self.path: list[PlanarPose] = []
        """Where the robot was when scans went into the map."""
        self._matching = matching
        self._reach = reach
        self._correction = PlanarPose()

    def add(
        self, odometry: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> PlanarPose:
        """A scan of a lidar that sits at `lidar` on the robot: radians and metres; inf is no echo, -inf too close.

        Returns where the robot is on the map. `odometry`: where it thinks it is, which may drift.
        """
        guess = self._correction.then(odometry)
        if self.path and not _moved(guess.since(self.path[-1])):
            return guess
        ends, echoes = self._ends(lidar, angles, ranges)
        pose = match(self.grid, ends[echoes], guess, ODOMETRY_DEVIATION) if self.path and self._matching else guess
        self.grid.add(np.array(pose.then(lidar)[:2]), pose.apply(ends), echoes)
        self.path.append(pose)
        self._correction = pose.then(odometry.inverse())
        return pose

    def _ends(
        self, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> tuple[Points, NDArray[np.bool_]]:
        """Where rays end, in the robot's frame, and which of them at something."""
        at, far = np.asarray(angles), np.asarray(ranges)
        used = far > 0.0
        at, far = at[used], far[used]
        echoes = far <= self._reach
        far = np.minimum(far, self._reach)
        return lidar.apply(np.column_stack([far * np.cos(at), far * np.sin(at)])), echoes


def _moved(step: PlanarPose) -> bool:
    return math.hypot(step.x, step.y) >= MIN_DISTANCE or abs(step.yaw) >= MIN_TURN
