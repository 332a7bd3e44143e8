"""An elevation grid: the height of the ground around the robot, from clouds of depth cameras and lidars.

Each cell is a column of voxels, so that what hangs above the ground is told from it: the ground is the highest point
that is reached from the lowest one without a gap as high as the robot. Voxels forget what was measured earlier near a
new hit, and those that rays cross; so drift of the pose and things that moved away do not stay.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.mapping.surfaces import Heights, fitted_planes, largest_steps

Points: TypeAlias = NDArray[np.floating[Any]]
"""Shape (n, 3): rows of x, y, z in metres."""
Floats: TypeAlias = NDArray[np.float64]
Indices: TypeAlias = NDArray[np.intp]

MAX_CELLS: Final = 400
"""Cells along a side."""
LAYERS: Final = 64
LAYER: Final = 0.05
"""Number of voxels of a column, and the height of one, metres."""
BELOW: Final = 2.0
"""Metres of a column below the sensor; the rest, 1.2 m, is above it. What is outside, such as ceilings, is left out."""
MAX_POINTS: Final = 30_000
"""Points of a cloud that are used, evenly spread."""
MAX_RAYS: Final = 2048
MIN_RAY_STEP: Final = 0.1
"""Rays of a cloud that clear what they cross and tell its tilt, evenly spread, and metres between the points of one at
least."""
FORGET: Final = 0.8
FORGOTTEN_LAYERS: Final = 3
"""Factor of the weights of voxels with a new hit, and of so many above and below them."""
FADE: Final = 0.9
"""Factor of the weights of voxels above a new hit, as far as the clearance: the sensor looked through them."""
MAX_WEIGHT: Final = 8.0
"""Weight of a voxel at most, in hits, so that it can still be forgotten."""
MIN_RANGE: Final = 0.05
"""Metres from the sensor below which a point is none: cameras report zeros where they measured nothing."""
CLEAR: Final = 0.6
"""Factor of the weight of a voxel that rays of a cloud cross."""
MIN_WEIGHT: Final = 1.5
"""Weight, in hits, of an occupied voxel: one stray point is no ground."""
SAME_GROUND: Final = 0.04
"""Metres between what two layers above each other have seen, below which that is the same ground."""
GRAZING_HEIGHT: Final = 2.0 * LAYER
GRAZING_PART: Final = 0.3
"""The last part of a ray that is not higher than this above its end, metres, clears nothing: it grazes the ground."""
SAME_LEVEL: Final = 0.04
"""Metres between points and known ground within which they are of the same ground."""
TILT_POINTS: Final = 100
TILT_ROUNDS: Final = 6
"""Points of known ground that tell the tilt of a cloud at least, and how often it is computed from those that fit."""
LARGEST_RISE: Final = 0.3
RISE_PART: Final = 0.3
"""Metres by which the height of a pose is off after an edge at most, and the part of the points of known ground that
must agree about it."""
LARGEST_TILT: Final = 0.08
"""Radians of an error of the measured tilt at most."""
TILT_DOUBT: Final = 25.0
"""Square metres, of a sum over points, below which they tell less about a tilt than that it is small: those of a strip
in front of a door would raise the floor behind it."""
STEADY_TIME: Final = 3.0
"""Seconds in which a difference between the measured tilt and known ground becomes one of that ground."""
FORGET_INTERVAL: Final = 0.5
"""Metres of the way between two looks at what is to be forgotten."""
APPROACHED: Final = 3.0
"""Metres from a sensor within which cells count as approached: what is seen of edges from farther away is little."""
RECENTRE: Final = 0.125
"""The grid moves when the sensor is farther than this part of its side from the middle."""
CLIMB: Final = 0.5
"""Metres of the sensor up or down after which the columns move."""
MAX_POSITION: Final = 1e7
"""Metres from the origin of the frame, beyond which there is no robot."""
FIT_RADIUS: Final = 0.25
"""Half the side, metres, of the square in which planes are fitted for slope and roughness."""


@dataclass(frozen=True, slots=True)
class GroundHeights:
    """The heights of an elevation grid at one time, which other threads can read."""

    origin: tuple[float, float]
    """The corner of the first cell, x and y, metres."""
    resolution: float
    heights: Heights
    """Metres, rows along y, columns along x; NaN where unknown."""
    hidden: NDArray[np.bool_]
    """Cells, of the same shape, that were never seen, though a sensor has been within `APPROACHED` metres."""
    ages: NDArray[np.float64]
    """Seconds since something in each cell was seen, at the last cloud; NaN where nothing was."""


class ElevationGrid:
    """A square of `size` metres around the sensor, in cells of `resolution` metres, that moves with it by whole cells.

    `clearance` is the height, in metres, that the robot needs to drive below something. Ground that was not seen again
    for `kept_way` metres of the sensor's way is forgotten: heights of poses drift by some millimetres a metre, and what
    is seen again would be a step beside what was seen long before. Arrays of cells have the shape
    (cells, cells): rows along y, columns along x, both ascending. The frame is that of the poses given to `add`, z up.
    """

    def __init__(
        self, size: float = 12.0, resolution: float = 0.1, clearance: float = 0.6, *, kept_way: float = math.inf
    ) -> None:
        cells = round(size / resolution)
        if not 4 <= cells <= MAX_CELLS:
            many = f"{size:g} m in cells of {resolution:g} m are {cells} cells along a side"
            raise ConfigError(f"{many}; an elevation grid has 4..{MAX_CELLS}, so choose other sizes")
        self.resolution = resolution
        self.cells = cells
        self.clearance = clearance
        self._kept_way = kept_way
        self._gap = math.ceil(min(max(clearance, LAYER), LAYERS * LAYER) / LAYER)
        self.stamp = math.nan
        """Time of the latest cloud, in seconds of the clock of `add`; NaN before the first."""
        self.counters: Counter[str] = Counter()
        """`clouds` and `points` used; clouds dropped for `no pose`, and points that were `not finite`."""
        self._corner: tuple[int, int, int] | None = None
        """Column, row and layer of the first voxel, counted from the origin of the frame."""
        shape = (LAYERS, cells, cells)
        self._weights = np.zeros(shape, np.float32)
        self._sums = np.zeros(shape, np.float32)
        """Hits in each voxel, and the sum of their heights above its lower face, metres."""
        self._seen = np.full((cells, cells), np.nan)
        """When each cell was hit last."""
        self._way = 0.0
        """Metres that the sensor has moved."""
        self._seen_on_way = np.zeros((cells, cells))
        """The same, when each cell was hit last."""
        self._approached = np.zeros((cells, cells), np.bool_)
        self._ever_seen = np.zeros((cells, cells), np.bool_)
        """Cells to which the sensor has been near, and those whose height was known when the ground was asked for."""
        self._place: Floats | None = None
        """Where the sensor was when what is too old was forgotten last, x and y."""
        self._heights: Heights | None = None
        self._steady = np.zeros(2)
        """The part that stays of the slopes, along x and y, by which clouds are above known ground."""
        self._rise = 0.0
        """Metres by which poses are above known ground, since edges that tracks slipped on."""

    @property
    def origin(self) -> tuple[float, float]:
        """The corner of the first cell, x and y, metres."""
        column, row, _ = self._corner or (-self.cells // 2, -self.cells // 2, 0)
        return column * self.resolution, row * self.resolution

    @property
    def heights(self) -> Heights:
        """The height of the ground in each cell, metres, shape (cells, cells); NaN where it is unknown."""
        if self._heights is None:
            self._heights = self._surface()
        return self._heights

    @property
    def ground(self) -> GroundHeights:
        """The heights as they are now, which other threads can read."""
        self._ever_seen |= ~np.isnan(self.heights)
        hidden = self._approached & ~self._ever_seen
        return GroundHeights(self.origin, self.resolution, self.heights, hidden, self.ages(self.stamp))

    def ages(self, now: float) -> Floats:
        """Seconds since something in each cell was seen; NaN where nothing was."""
        return now - self._seen

    def slopes(self) -> Heights:
        """Inclination of the ground, rad: that of the plane around each cell; NaN where too little is known."""
        return fitted_planes(self.heights, self.resolution, FIT_RADIUS)[0]

    def roughness(self) -> Heights:
        """Standard deviation of the ground from the plane around each cell, metres; NaN where too little is known."""
        return fitted_planes(self.heights, self.resolution, FIT_RADIUS)[1]

    def steps(self) -> Heights:
        """The greatest difference of height between each cell and the eight around it, metres; NaN if none is known."""
        return largest_steps(self.heights)

    def height_at(self, x: float, y: float) -> float:
        """The height of the ground at a point, metres; NaN where it is unknown or outside."""
        left, low = self.origin
        if not (math.isfinite(x) and math.isfinite(y)):
            return math.nan
        column, row = math.floor((x - left) / self.resolution), math.floor((y - low) / self.resolution)
        inside = 0 <= column < self.cells and 0 <= row < self.cells
        return float(self.heights[row, column]) if inside else math.nan

    def add(
        self, points: Points, sensor: Transform, time: float, max_range: float = 10.0, *, has_tipped: bool = False
    ) -> int:
        """Add a cloud, shape (n, 3), in the frame of a sensor at `sensor`. Returns the number of points used.

        Of a robot that `has_tipped` since the last cloud, as over an edge, the height may be decimetres off: tracks
        that slip run on while it is tilted. It is that which fits known ground, also for clouds after this one.

        Points that are not finite or farther than `max_range` metres are left out, and the whole cloud if the pose or
        the time is not finite. The robot's own points must have been removed (`LinkBoxes.contain`).
        """
        turn, start = np.array(sensor.rotation), np.array(sensor.position)
        if not (np.isfinite(turn).all() and (np.abs(start) <= MAX_POSITION).all() and math.isfinite(time)):
            self.counters["no pose"] += 1
            return 0
        near = self._near(points, max_range)
        start[2] -= self._rise
        self._move_to(start)
        self._follow_way(start)
        ends = near @ turn.T + start
        some = slice(None, None, max(1, -(-len(ends) // MAX_RAYS)))
        if has_tipped:
            risen = self._rise_of(ends[some])
            self._rise += risen
            start[2] -= risen
            ends[:, 2] -= risen
        ends[:, 2] -= (ends[:, :2] - start[:2]) @ self._passing_tilt(start, ends[some], time)
        self._clear(start, ends[some])
        used = self._hit(ends, time)
        self.stamp = time
        self.counters["clouds"] += 1
        self.counters["points"] += used
        return used

    def add_footprint(self, base: Transform, size: tuple[float, float], ground: float, time: float) -> None:
        """Add the ground on which the robot stands: a rectangle of `size` metres around its base, `ground` m below it.

        Sensors do not see it; what they saw there stays.
        """
        x, y = (np.arange(-half, half + 1e-9, self.resolution / 2.0) for half in (size[0] / 2.0, size[1] / 2.0))
        flat = np.stack([*np.meshgrid(x, y), np.full((len(y), len(x)), -ground)], axis=-1).reshape(-1, 3)
        ends = flat @ np.array(base.rotation).T + np.array(base.position) - (0.0, 0.0, self._rise)
        if not (np.abs(ends) <= MAX_POSITION).all():
            self.counters["no pose"] += 1
            return
        if self._corner is None:
            self._move_to(np.array(base.position))
        voxels, inside = self._voxels(ends)
        unknown = np.isnan(self.heights).reshape(-1)[voxels % self.cells**2]
        self._hit(ends[inside][unknown], time)

    def _near(self, points: Points, max_range: float) -> Floats:
        every = max(1, -(-len(points) // MAX_POINTS))
        some = np.asarray(points, np.float64).reshape(-1, 3)[::every]
        finite: NDArray[np.bool_] = np.asarray(np.isfinite(some).all(axis=1))
        self.counters["not finite"] += int(len(some) - np.count_nonzero(finite))
        largest: Floats = np.abs(np.where(finite[:, None], some, np.inf)).max(axis=1, initial=0.0)
        near: Floats = some[(largest <= max_range) & (largest >= MIN_RANGE)]
        return near

    def _passing_tilt(self, start: Floats, ends: Floats, time: float) -> Floats:
        """Slopes along x and y by which a cloud is to be lowered, so that known ground is where it is known.

        A tilt that is measured 0.02 rad off, as after an edge, raises ground four metres ahead by 8 cm: a step. Such
        errors pass; a difference that stays for seconds is one of the known ground.
        """
        tilt = self._tilt_of(start, ends)
        kept = math.exp(-max(0.0, time - self.stamp) / STEADY_TIME) if math.isfinite(self.stamp) else 0.0
        self._steady = kept * self._steady + (1.0 - kept) * tilt
        return tilt - self._steady

    def _above_known(self, points: Floats) -> tuple[Floats, NDArray[np.bool_]]:
        """Metres by which the points inside are above the ground, NaN where it is unknown; and which are inside."""
        voxels, inside = self._voxels(points)
        return points[inside, 2] - self.heights.reshape(-1)[voxels % self.cells**2], inside

    def _rise_of(self, ends: Floats) -> float:
        """Metres by which most points of known ground are above it; 0 if no height fits enough of them."""
        off, _ = self._above_known(ends)
        off = off[np.abs(off) < LARGEST_RISE]
        if len(off) < TILT_POINTS:
            return 0.0
        ordered = np.sort(off)
        agreeing = np.searchsorted(ordered, ordered + SAME_LEVEL) - np.arange(len(ordered))
        first = int(agreeing.argmax())
        if agreeing[first] < RISE_PART * len(ordered):
            return 0.0
        return float(np.median(ordered[first : first + agreeing[first]]))

    def _tilt_of(self, start: Floats, ends: Floats) -> Floats:
        """Slopes along x and y by which points are above known ground with their distance; 0 if that is not known."""
        off, inside = self._above_known(ends)
        away = np.column_stack([ends[inside, :2] - start[:2], np.ones(len(off))])
        tilt = np.zeros(3)
        for _ in range(TILT_ROUNDS):  # from what agrees without a tilt, near the sensor, to what is farther away
            same = np.abs(off - away @ tilt) < SAME_LEVEL
            if np.count_nonzero(same) < TILT_POINTS:
                return np.zeros(2)
            a = away[same]
            tilt = np.linalg.solve(a.T @ a + np.diag([TILT_DOUBT, TILT_DOUBT, 0.0]), a.T @ off[same])
        if math.hypot(tilt[0], tilt[1]) > LARGEST_TILT:
            self.counters["tilted"] += 1
            return np.zeros(2)
        return np.asarray(tilt[:2])

    def _move_to(self, sensor: Floats) -> None:
        """Move the grid if the sensor is far from its middle; what it leaves is forgotten."""
        scale = np.array([self.resolution, self.resolution, LAYER])
        wanted = np.floor(sensor / scale).astype(np.int64)
        wanted -= (self.cells // 2, self.cells // 2, round(BELOW / LAYER))
        if self._corner is not None:
            off = np.abs(wanted - self._corner)
            if max(off[:2]) <= RECENTRE * self.cells and off[2] <= CLIMB / LAYER:
                return
            shift = (wanted - self._corner)[::-1]  # layers, rows, columns
            self._weights, self._sums = _shifted(self._weights, shift, 0.0), _shifted(self._sums, shift, 0.0)
            self._seen = _shifted(self._seen, shift[1:], np.nan)
            self._seen_on_way = _shifted(self._seen_on_way, shift[1:], 0.0)
            self._approached, self._ever_seen = (
                _shifted(cells, shift[1:], False) for cells in (self._approached, self._ever_seen)
            )
            self._heights = None
        column, row, layer = wanted.tolist()
        self._corner = column, row, layer

    def _follow_way(self, start: Floats) -> None:
        """Measure the way of the sensor, note what it approaches, and forget what was seen too long ago on it."""
        if self._place is not None:
            moved = math.dist(self._place, start[:2])
            if moved < FORGET_INTERVAL:
                return
            self._way += moved
        self._place = start[:2].copy()
        ys, xs = (np.indices((self.cells, self.cells)) + 0.5) * self.resolution
        left, low = self.origin
        self._approached |= np.hypot(xs + left - start[0], ys + low - start[1]) < APPROACHED
        old = self._way - self._seen_on_way > self._kept_way
        if old.any():
            self._weights[:, old] = self._sums[:, old] = 0.0
            self._heights = None

    def _voxels(self, points: Floats) -> tuple[Indices, NDArray[np.bool_]]:
        """Flat numbers of the voxels of the points that are inside, shape (n,), and which are inside."""
        assert self._corner is not None
        scale = np.array([self.resolution, self.resolution, LAYER])
        columns, rows, layers = np.floor(points / scale).astype(np.int64).T - np.array(self._corner)[:, None]
        cells = self.cells
        inside = (columns >= 0) & (columns < cells) & (rows >= 0) & (rows < cells) & (layers >= 0) & (layers < LAYERS)
        return ((layers * cells + rows) * cells + columns)[inside].astype(np.intp), inside

    def _clear(self, start: Floats, ends: Floats) -> None:
        """Reduce the weights of voxels between the sensor and the ends."""
        rays = ends - start
        lengths = np.linalg.norm(rays, axis=1)
        step = max(self.resolution, MIN_RAY_STEP)
        counts = np.maximum(0, np.floor(lengths / step - 1.5)).astype(np.intp)
        which = np.repeat(np.arange(len(rays)), counts)
        number = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
        part = (number + 0.5) * step / lengths[which]
        crossed = start + rays[which] * part[:, None]
        grazing = (part > 1.0 - GRAZING_PART) & (crossed[:, 2] - ends[which, 2] < GRAZING_HEIGHT)
        voxels, _ = self._voxels(crossed[~grazing])
        self._reduce(voxels, CLEAR)

    def _hit(self, ends: Floats, time: float) -> int:
        voxels, inside = self._voxels(ends)
        if not len(voxels):
            return 0
        self._reduce(voxels, FADE, range(self._gap + 1))
        self._reduce(voxels, FORGET, range(-FORGOTTEN_LAYERS, FORGOTTEN_LAYERS + 1))
        assert self._corner is not None
        layers, places = np.divmod(voxels, self.cells**2)
        above = ends[inside, 2] - (layers + self._corner[2]) * LAYER
        weights, sums = self._weights.reshape(-1), self._sums.reshape(-1)
        np.add.at(weights, voxels, np.float32(1.0))
        np.add.at(sums, voxels, above.astype(np.float32))
        excess = MAX_WEIGHT / np.maximum(weights[voxels], MAX_WEIGHT)
        sums[voxels] *= excess
        weights[voxels] *= excess
        self._seen.reshape(-1)[places] = time
        self._seen_on_way.reshape(-1)[places] = self._way
        self._heights = None
        return len(voxels)

    def _reduce(self, voxels: Indices, factor: float, offsets: range = range(1)) -> None:
        """Multiply the weights of the voxels that are so many layers above these by a factor, once."""
        layer, margin = self.cells**2, max(0, -offsets[0]) * self.cells**2
        chosen = np.zeros(self._weights.size + margin + max(0, offsets[-1]) * layer, np.bool_)
        for up in offsets:
            chosen[voxels + (up * layer + margin)] = True
        found = np.flatnonzero(chosen[margin : margin + self._weights.size])
        for values in (self._weights.reshape(-1), self._sums.reshape(-1)):
            values[found] *= np.float32(factor)
        self._heights = None

    def _surface(self) -> Heights:
        occupied = self._weights >= MIN_WEIGHT
        top = np.full((self.cells, self.cells), -1)
        for layer in np.flatnonzero(occupied.any(axis=(1, 2))).tolist():
            reached = occupied[layer] & ((top < 0) | (layer - top <= self._gap))
            top[reached] = layer
        known = top >= 0
        rows, columns = np.nonzero(known)
        upper = top[known]
        lower = np.maximum(upper - 1, 0)
        weights, sums = (values[upper, rows, columns].astype(np.float64) for values in (self._weights, self._sums))
        below, sums_below = (
            np.where(upper > lower, values[lower, rows, columns], 0.0) for values in (self._weights, self._sums)
        )
        # ground at the border of two layers hits both: their common mean is its height; at the edge of a step it is not
        apart = sums / weights - (sums_below / np.maximum(below, 1e-6) - LAYER)
        same = (below > 0.0) & (apart < SAME_GROUND)
        sums += np.where(same, sums_below - below * LAYER, 0.0)
        weights += np.where(same, below, 0.0)
        layer = 0 if self._corner is None else self._corner[2]
        found = np.full((self.cells, self.cells), np.nan, np.float32)
        found[known] = (upper + layer) * LAYER + sums / weights
        return found


def _shifted(array: NDArray[Any], shift: NDArray[np.int64], empty: float) -> NDArray[Any]:
    """The array seen from an origin that is moved by `shift` along each axis; what comes in is `empty`."""
    moved = np.full_like(array, empty)
    limits = np.array(array.shape)
    steps = np.clip(shift, -limits, limits)
    source = tuple(slice(max(0, s), n + min(0, s)) for s, n in zip(steps.tolist(), array.shape, strict=True))
    target = tuple(slice(max(0, -s), n - max(0, s)) for s, n in zip(steps.tolist(), array.shape, strict=True))
    moved[target] = array[source]
    return moved
