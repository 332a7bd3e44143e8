"""Makes a map from scans and odometry, and corrects the odometry by scan matching.

Matching is a Gauss-Newton search for the pose at which the ends of the rays fit the map, coarse to fine, similar to
Hector SLAM (Kohlbrecher et al., A flexible and scalable SLAM system with full 3D motion estimation, 2011). Where the
map does not constrain the pose, as along a corridor, odometry does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, Points, transformed

Array: TypeAlias = NDArray[np.float64]

MAX_RANGE: Final = 15.0
"""Metres of a ray that are mapped; beyond, a small tilt of the robot has too much effect."""
MAX_RAYS: Final = 4096
"""Rays of a scan that are used, evenly spread; at `MAX_RANGE` their ends are closer than the cells of a usual map."""
MIN_DISTANCE: Final = 0.1
MIN_TURN: Final = math.radians(5.0)
"""Metres and radians of motion after which a scan is added."""
ODOMETRY_DEVIATION: Final = (0.05, math.radians(2.0))
"""Standard deviations of odometry between two such scans, metres and radians."""
GAP: Final = 0.3
"""Metres between two such scans from which on some were left out, as of a tilted robot: its tracks may have slipped."""
SLIP: Final = 1.0
"""Standard deviation of the distance over such a gap, as a part of it."""
ASIDE: Final = 0.3
"""Standard deviation to the side, metres."""
MAX_GAP: Final = 5.0
"""Metres of a gap, back from the guess, that are searched."""
MAX_REACH: Final = 1.0
"""Metres around the guess that are searched in a map that was made before."""
SEARCH_STEP: Final = 0.1
SEARCHED_POINTS: Final = 150
"""Echoes of a scan, evenly spread, by which places are compared."""
START_DEVIATION: Final = 0.5
START_TURN: Final = math.radians(20.0)
START_STEP: Final = math.radians(2.0)
"""Errors of a guess of where the robot is in a map that was made before: metres; radians that are searched; their
steps."""
MIN_FIT: Final = 0.6
"""Fraction of the echoes that must be at the walls of such a map."""
FIT_WEIGHT: Final = 40.0
"""Weight of their mean: a fifth of them far from any obstacle is as much as a distance of 2.8 deviations."""
ATTRACTION_WIDTHS: Final = (6, 2)
"""Cells around an occupied cell that attract the ends of rays; coarse first."""
MAX_ITERATIONS: Final = 12
MIN_POINTS: Final = 30
"""Echoes below which a scan is not matched."""
POINT_WEIGHT: Final = 4.0
"""Weight of an echo: one far from any obstacle counts as much as a guess that is two deviations off."""
MAX_STEP: Final = 0.05
"""Metres and radians of one iteration at most."""
MIN_STRAIGHTNESS: Final = 0.9
"""Cosine of the angle between neighbouring segments above which their ends lie on one wall."""
MIN_STEP: Final = 1e-5
"""Metres and radians of an iteration below which the search has converged."""


class Mapper:
    """Adds scans to `grid`, whose frame is the odometry's when the first scan is added.

    A grid that was made before has a frame of its own. There the place of the first scan is searched around `start`,
    the pose of the robot in it, or around the odometry's if that is None; then `is_known` is True.
    """

    def __init__(
        self,
        grid: OccupancyGrid | None = None,
        *,
        is_known: bool = False,
        start: PlanarPose | None = None,
        matching: bool = True,
        max_range: float = MAX_RANGE,
    ) -> None:
        self.grid = grid or OccupancyGrid()
        self.path: list[PlanarPose] = []
        """The corrected pose of each scan in the map."""
        self.is_known = is_known
        """True for a map that was made before."""
        self._start = start
        self._matching = matching
        self.max_range = max_range
        """Metres of a ray that are mapped."""
        self._correction = PlanarPose()

    @property
    def correction(self) -> PlanarPose:
        """The pose of the odometry's frame in the map, which differs from zero by the drift so far."""
        return self._correction

    def add(
        self, odometry: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> PlanarPose:
        """Add a scan of a lidar at the pose `lidar` on the robot; `odometry` is the robot's pose, which may drift.

        `angles` in radians and `ranges` in metres, inf for no echo, -inf for one too close. Returns the corrected pose.
        Raises `ConfigError` if the first scan does not fit a map that was made before.
        """
        guess = self._correction @ odometry
        if self.path and not _moved(guess.relative_to(self.path[-1])):
            return guess
        ends, echoes = self._ends(lidar, angles, ranges)
        pose = guess
        if not self.path and self.is_known:
            pose = locate(self.grid, ends[echoes], guess if self._start is None else self._start)
        elif self.path and self._matching:
            pose = self._matched(ends[echoes], guess)
        self.grid.add(np.array((pose @ lidar)[:2]), transformed(pose, ends), echoes)
        self.path.append(pose)
        self._correction = pose @ odometry.inverse()
        return pose

    def _matched(self, points: Points, guess: PlanarPose) -> PlanarPose:
        """The pose at which a scan fits the map; after a gap, it may be farther from the guess."""
        step = guess.relative_to(self.path[-1])
        way = math.hypot(step.x, step.y)
        if way < GAP:
            return match(self.grid, points, guess, ODOMETRY_DEVIATION)
        found = search(self.grid, points, guess, self.path[-1])
        return match(self.grid, points, found, (SLIP * way, ODOMETRY_DEVIATION[1]))

    def _ends(
        self, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> tuple[Points, NDArray[np.bool_]]:
        """Ends of the rays in the robot's frame, shape (n, 2), and which are echoes, shape (n,)."""
        bearings, distances = np.asarray(angles), np.asarray(ranges)
        used = np.flatnonzero((distances > 0.0) & np.isfinite(bearings))
        if len(used) > MAX_RAYS:
            used = used[np.linspace(0, len(used) - 1, MAX_RAYS).astype(np.intp)]
        bearings, distances = bearings[used], distances[used]
        echoes = distances <= self.max_range
        distances = np.minimum(distances, self.max_range)
        return transformed(lidar, np.column_stack([distances * np.cos(bearings), distances * np.sin(bearings)])), echoes


def _moved(step: PlanarPose) -> bool:
    return math.hypot(step.x, step.y) >= MIN_DISTANCE or abs(step.yaw) >= MIN_TURN


def search(grid: OccupancyGrid, points: Points, guess: PlanarPose, before: PlanarPose) -> PlanarPose:
    """The place between the last one and `guess` where the echoes of a scan, shape (n, 2), fit the map best.

    A robot whose tracks slip, as at a kerb, is on its way, and not as far as odometry tells. The heading stays.
    """
    if len(points) < MIN_POINTS:
        return guess
    back_x, back_y = before.x - guess.x, before.y - guess.y
    way = math.hypot(back_x, back_y)
    along = np.arange(-2.0 * ASIDE, min(way, MAX_GAP) + SEARCH_STEP, SEARCH_STEP)
    aside = np.arange(-2.0 * ASIDE, 2.0 * ASIDE + SEARCH_STEP / 2.0, SEARCH_STEP)
    offsets = np.stack(np.meshgrid(along, aside), axis=-1).reshape(-1, 2)
    turned = offsets @ np.array([[back_x, back_y], [-back_y, back_x]]) / way
    doubts = (offsets[:, 0] / (SLIP * way)) ** 2 + (offsets[:, 1] / ASIDE) ** 2
    return _Comparison(grid, points).best(guess, turned, doubts)[0]


def locate(grid: OccupancyGrid, points: Points, guess: PlanarPose) -> PlanarPose:
    """The pose in a map that was made before at which the echoes of a scan fit it, searched around a rough guess.

    Raises `ConfigError` when they fit nowhere there.
    """
    x, y, degrees = (round(value, 1) + 0.0 for value in (guess.x, guess.y, math.degrees(guess.yaw)))
    where = f"({x:g}, {y:g}) and {degrees:g} degrees"
    if len(points) < MIN_POINTS:
        raise ConfigError(f"the lidar sees too little to find the robot in the map near {where}")
    comparison = _Comparison(grid, points)
    turns = np.arange(-START_TURN, START_TURN + START_STEP / 2.0, START_STEP).tolist()
    guesses = [PlanarPose(guess.x, guess.y, guess.yaw + turn) for turn in turns]
    along = np.arange(-MAX_REACH, MAX_REACH + SEARCH_STEP / 2.0, SEARCH_STEP)
    offsets = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2)
    doubts = (offsets * offsets).sum(axis=1) / START_DEVIATION**2
    found, _ = min((comparison.best(turned, offsets, doubts) for turned in guesses), key=lambda pair: pair[1])
    pose = match(grid, points, found, (SEARCH_STEP, START_STEP))
    if (fit := comparison.fit(pose)) < MIN_FIT:
        raise ConfigError(
            f"what the lidar sees does not fit the map near {where}: {fit:.0%} of the echoes are at its walls; tell "
            "where the robot is in the map"
        )
    return pose


class _Comparison:
    """Compares the echoes of a scan, shape (n, 2) in the robot's frame, with the walls of a map at many places."""

    def __init__(self, grid: OccupancyGrid, points: Points) -> None:
        self._grid = grid
        self._points = points[np.linspace(0, len(points) - 1, min(len(points), SEARCHED_POINTS)).astype(np.intp)]
        self._near = _attraction(grid.log_odds > 0.0, ATTRACTION_WIDTHS[-1])
        # ends where nothing is known yet say nothing: otherwise a scan would slide to the part that the map already has
        self._known = (grid.log_odds != 0.0) | (self._near > 0.0)

    def best(self, guess: PlanarPose, offsets: Points, doubts: Array) -> tuple[PlanarPose, float]:
        """The best place at one of the offsets, shape (m, 2), from a guess, with its heading; and its cost.

        `doubts`, shape (m,), are the squares of the offsets in standard deviations.
        """
        rows, columns = self._cells(transformed(guess, self._points) + offsets[:, np.newaxis])
        counted = self._known[rows, columns]
        lacking = ((1.0 - self._near[rows, columns]) ** 2 * counted).sum(axis=1) / np.maximum(counted.sum(axis=1), 1)
        costs = FIT_WEIGHT * lacking + doubts
        chosen = int(costs.argmin())
        x, y = offsets[chosen].tolist()
        return PlanarPose(guess.x + x, guess.y + y, guess.yaw), float(costs[chosen])

    def fit(self, pose: PlanarPose) -> float:
        """Fraction of the echoes that are at walls of the map."""
        rows, columns = self._cells(transformed(pose, self._points))
        return float(np.mean(self._near[rows, columns] > 0.0))

    def _cells(self, points: Points) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Rows and columns of the cells of points; those outside are at the edge."""
        grid = self._grid
        cells = np.rint(np.clip(grid.cell_coordinates(points), 0.0, grid.cells - 1.0)).astype(np.intp)
        return cells[..., 1], cells[..., 0]


def match(grid: OccupancyGrid, points: Points, guess: PlanarPose, deviation: tuple[float, float]) -> PlanarPose:
    """The pose near `guess` at which the echoes of a scan, shape (n, 2) in the robot's frame, fit the map best.

    `deviation`: standard deviations of the guess, metres and radians.
    """
    if len(points) < MIN_POINTS:
        return guess
    normals = _normal_projections(points)
    # least squares over the echoes and the guess: sum of w (1 - attraction)^2 + (guess - pose)' P^-1 (guess - pose)
    occupied = grid.log_odds > 0.0
    prior = 1.0 / np.array([deviation[0], deviation[0], deviation[1]]) ** 2
    pose = expected = np.array(guess)
    # wide attraction first, which finds the wall from afar, then narrow, which finds its place
    for cells in ATTRACTION_WIDTHS:
        near = _attraction(occupied, cells)
        for _ in range(MAX_ITERATIONS):
            step = _step(*_slopes(grid, near, (points, normals), pose), prior, expected - pose)
            pose = pose + np.clip(step, -MAX_STEP, MAX_STEP)
            if np.abs(step).max() < MIN_STEP:
                break
    return PlanarPose(*pose.tolist())


def _step(residuals: Array, slopes: Array, prior: Array, offset: Array) -> Array:
    """The Gauss-Newton step, shape (3,), for residuals (n,), their slopes (n, 3), and the offset (3,) to the guess.

    It solves (w J'J + P^-1) step = w J'r + P^-1 offset, with the weight w of an echo and the covariance P of the guess.
    """
    hessian = POINT_WEIGHT * slopes.T @ slopes + np.diag(prior)
    return np.asarray(np.linalg.solve(hessian, POINT_WEIGHT * slopes.T @ residuals + prior * offset), np.float64)


def _slopes(grid: OccupancyGrid, near: Array, scan: tuple[Points, Array], pose: Array) -> tuple[Array, Array]:
    """Residuals (n,): the attraction that each end lacks; and its slopes (n, 3) along x, y (1/m) and yaw (1/rad)."""
    points, normals = scan
    placed = transformed(PlanarPose(*pose.tolist()), points)
    value, slope = _sample(grid, near, placed)
    # project each slope on the normal of its wall, in the map: R N R'
    c, s = np.cos(pose[2]), np.sin(pose[2])
    turn = np.array([[c, -s], [s, c]])
    slope = np.einsum("nij,nj->ni", turn @ normals @ turn.T, slope)
    # a turn moves an end at (x, y) from the robot by (-y, x)
    around = placed - pose[:2]
    return 1.0 - value, np.column_stack([slope, slope[:, 1] * around[:, 0] - slope[:, 0] * around[:, 1]])


def _normal_projections(points: Points) -> Array:
    """Shape (n, 2, 2): for each end the projection on the normal of its wall; zero at corners and edges of walls.

    Without it, ends would be attracted along the wall to the part that the map already has.
    """
    before, after = (np.roll(points, shift, axis=0) for shift in (1, -1))
    to_before, to_after = points - before, after - points
    lengths = np.maximum(np.hypot(*to_before.T) * np.hypot(*to_after.T), 1e-9)
    straight = (to_before * to_after).sum(axis=1) / lengths > MIN_STRAIGHTNESS
    tangent = after - before
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    projections: Array = normal[:, :, None] * normal[:, None, :] * straight[:, None, None]
    return projections


def _sample(grid: OccupancyGrid, near: Array, points: Points) -> tuple[Array, Array]:
    """Value (n,) and slope (n, 2), 1/m, interpolated between centres of cells; beyond the map, those of its edge."""
    place = np.clip(grid.cell_coordinates(points), 0.0, grid.cells - 1.000001)
    column, row = np.floor(place).astype(np.intp).T
    u, v = (place - np.floor(place)).T
    a, b = near[row, column], near[row, column + 1]
    c, d = near[row + 1, column], near[row + 1, column + 1]
    # bilinear, with the derivative of the same polynomial
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
    """Shape (cells, cells): 1 at occupied cells, falling linearly to 0 at a distance of `cells` cells.

    It does not depend on the number of hits: otherwise a scan would slide along a wall to where it was hit most.
    """
    near = np.zeros(occupied.shape)
    rows, columns = np.flatnonzero(occupied.any(axis=1)), np.flatnonzero(occupied.any(axis=0))
    if not len(rows):
        return near
    window = np.s_[_around(rows, cells), _around(columns, cells)]
    part = occupied[window].astype(np.float64)
    # each round lets a cell have what its largest neighbour has, less one step: a distance along rows and columns
    for _ in range(cells):
        before = part - 1.0 / cells
        for target, source in _NEIGHBOURS:
            np.maximum(part[target], before[source], out=part[target])
    near[window] = part
    return near


def _around(used: NDArray[np.intp], margin: int) -> slice:
    return slice(max(0, int(used[0]) - margin), int(used[-1]) + margin + 1)
