"""Things that stand on surfaces, in a cloud in the frame of the robot's base: clusters of points above planes.

Planes are found by RANSAC (Fischler and Bolles, 1981), clusters by the distance between points.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import label
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from jauspy.errors import ConfigError
from jauspy.planning.colours import HUES, is_coloured, main_colour

Array: TypeAlias = NDArray[np.float64]
Vector: TypeAlias = tuple[float, float, float]

TRIES: Final = 250
"""Planes that are tried for one surface."""
SAMPLE: Final = 3000
"""Points on which planes are tried."""
THICKNESS: Final = 0.008
"""Metres from a plane up to which a point is on it."""
MAX_TILT: Final = math.radians(10.0)
"""Tilt of a surface in the base's frame up to which a thing stands on it."""
MIN_SHARE: Final = 0.02
"""Share of the points that the smallest surface has."""
MIN_SIDE: Final = 0.15
"""Metres; a level surface that is narrower is the top of a thing."""
PIECE_CELL: Final = 0.02
"""Metres: points of a surface that are at most two cells of this side apart belong to one piece of it."""
PIECE_CELLS: Final = 250
"""Number of these cells on each side of the middle of a surface; what is farther away counts as at the edge."""
MAX_PLANES: Final = 8
"""Planes that are looked at."""
GAP: Final = 0.015
"""Metres between two points of one thing, at most."""
CELL: Final = 0.004
"""Edge of the cubes of which each keeps one point, metres."""
MAX_POINTS: Final = 60_000
"""Points that are used after that, evenly spread."""
MIN_POINTS: Final = 30
"""Points of a thing, at least, after that."""
MAX_SIZE: Final = 0.45
"""Metres; what is longer is no thing to be grasped."""
FLOATS: Final = 0.04
"""Metres between a surface and the lowest point seen of what stands on it, at most."""
SIZE_TOLERANCE: Final = 0.03
"""Metres by which a side may differ from that of a known thing; of what is far from the camera a part is hidden."""


@dataclass(frozen=True, slots=True)
class Plane:
    """A level surface: z = slope x (x, y) + height, in metres in the frame of the base."""

    slope: tuple[float, float]
    height: float

    def heights(self, points: Array) -> Array:
        """Metres of points, shape (n, 3), above the surface."""
        return self.rises(points) - self.height

    def rises(self, ways: Array) -> Array:
        """Metres by which ways, shape (n, 3), lead away from the surface."""
        found: Array = ways[:, 2] - ways[:, :2] @ np.array(self.slope)
        return found

    def at(self, x: float, y: float) -> float:
        """Height of the surface above the base's origin, metres."""
        return self.slope[0] * x + self.slope[1] * y + self.height


@dataclass(frozen=True, slots=True)
class SeenObject:
    """A thing that was seen, in the frame of the base."""

    points: Array
    """Metres, shape (n, 3)."""
    centre: Vector
    """The middle of the box around it, metres."""
    yaw: float
    """Direction of its longer level side, radians."""
    size: Vector
    """Longer level side, shorter one, height above its surface, metres."""
    support: Plane
    has_seen_support: bool
    """False if nothing was seen below: then `support` is at its lowest point."""
    colour: str
    """Its name; empty for what has no clear one."""

    def __str__(self) -> str:
        """Description in words."""
        x, y, _ = self.centre
        sides = " x ".join(f"{100.0 * side:.0f}" for side in self.size)
        return f"{self.colour or 'grey'}, {sides} cm, at {x:.2f}, {y:.2f}"


@dataclass(frozen=True, slots=True)
class KnownObject:
    """What a thing of a name looks like: colour, and level sides and height as it stands or lies, metres."""

    colour: str
    size: Vector


KNOWN: Final[Mapping[str, KnownObject]] = {
    "can": KnownObject("red", (0.05, 0.05, 0.12)),
    "box": KnownObject("green", (0.08, 0.06, 0.10)),
    "bottle": KnownObject("blue", (0.06, 0.06, 0.20)),
    "cup": KnownObject("yellow", (0.08, 0.07, 0.09)),
    "bar": KnownObject("orange", (0.22, 0.04, 0.04)),
    "ball": KnownObject("purple", (0.066, 0.066, 0.066)),
}
"""Things by name."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is to be found: a known thing, a colour, a place in the base's frame (metres), or several of them."""

    name: str = ""
    colour: str = ""
    near: Vector | None = None

    def __post_init__(self) -> None:
        if self.name and self.name not in KNOWN:
            raise ConfigError(f"{self.name!r} is no known thing; there are: {', '.join(KNOWN)}; or name a colour")
        if self.colour and self.colour not in HUES:
            raise ConfigError(f"{self.colour!r} is no known colour; there are: {', '.join(HUES)}")
        if not self.name and not self.colour and self.near is None:
            raise ConfigError("name what is to be grasped: a known thing, a colour, or a place")

    @property
    def hue(self) -> str:
        """The colour that is looked for; empty for any."""
        return self.colour or (KNOWN[self.name].colour if self.name else "")

    def __str__(self) -> str:
        """Description in words."""
        words = " ".join(filter(None, (self.colour, self.name or "thing")))
        return words if self.near is None else f"{words} near {', '.join(f'{value:g}' for value in self.near)}"


NEAR: Final = 0.12
"""Metres from a given place within which a thing is looked for."""


def find_objects(points: Array, colours: Array | None = None, hue: str = "", seed: int = 0) -> list[SeenObject]:
    """The things in a cloud, shape (n, 3), the nearest first; `colours` (n, 3) from 0 to 1. With `hue` only these.

    The same cloud and seed give the same things.
    """
    finite = np.isfinite(points).all(axis=1)
    points = points[finite].astype(np.float64)
    colours = np.zeros_like(points) if colours is None else colours[finite].astype(np.float64)
    if not len(points):
        return []
    kept = np.unique(np.floor(points / CELL).astype(np.int64), axis=0, return_index=True)[1]
    kept = kept[np.linspace(0, len(kept) - 1, min(len(kept), MAX_POINTS)).astype(np.intp)]
    points, colours = points[kept], colours[kept]
    planes, rest = _surfaces(points, np.random.default_rng(seed))
    chosen = rest & is_coloured(colours, hue) if hue else rest
    found = []
    for numbers in _clusters(points[chosen]):
        these = points[chosen][numbers]
        thing = _thing(these, colours[chosen][numbers], planes)
        if thing is not None:
            found.append(thing)
    return sorted(found, key=lambda thing: math.hypot(*thing.centre[:2]))


def choose(things: Sequence[SeenObject], wanted: Wanted) -> SeenObject | None:
    """The thing that fits best; None if none does."""
    rated = [(_misfit(thing, wanted), number) for number, thing in enumerate(things)]
    misfit, number = min(rated, default=(math.inf, 0))
    return things[number] if math.isfinite(misfit) else None


def _misfit(thing: SeenObject, wanted: Wanted) -> float:
    """How badly a thing fits, infinite if it does not."""
    if wanted.hue and thing.colour != wanted.hue:
        return math.inf
    misfit = 0.01 * math.hypot(*thing.centre[:2])  # the nearer of two that fit as well
    if wanted.name:
        sides, known = sorted(thing.size), sorted(KNOWN[wanted.name].size)
        worst = max(abs(one - other) for one, other in zip(sides, known, strict=True))
        if worst > SIZE_TOLERANCE:
            return math.inf
        misfit += worst
    if wanted.near is not None:
        off = math.dist(thing.centre[:2], wanted.near[:2])
        if off > NEAR:
            return math.inf
        misfit += off
    return misfit


def _surfaces(points: Array, rng: np.random.Generator) -> tuple[list[Plane], NDArray[np.bool_]]:
    """The level surfaces, and for each point whether it is on none of them."""
    rest, open_points = np.ones(len(points), np.bool_), np.ones(len(points), np.bool_)
    planes: list[Plane] = []
    for _ in range(MAX_PLANES):
        plane = _largest_plane(points[open_points], rng)
        if plane is None:
            break
        on = open_points & (np.abs(plane.heights(points)) <= THICKNESS)
        if on.sum() < max(MIN_POINTS, MIN_SHARE * len(points)):
            break
        if not _pieces(points, on)[0].any():  # the tops of things
            open_points &= ~on
            continue
        # by all points of the surface, twice, since the first plane goes through three noisy ones
        for _ in range(2):
            design = np.column_stack((points[on, :2], np.ones(int(on.sum()))))
            fitted = np.linalg.lstsq(design, points[on, 2], rcond=None)[0]
            plane = Plane((float(fitted[0]), float(fitted[1])), float(fitted[2]))
            on = rest & (np.abs(plane.heights(points)) <= THICKNESS)
        wide, narrow = _pieces(points, on)
        if wide.any() and math.hypot(*plane.slope) <= math.tan(MAX_TILT):
            above = np.any([lower.heights(points) > 2.0 * THICKNESS for lower in planes], axis=0)
            planes.append(plane)
            rest &= ~on | (narrow & above)
        open_points &= ~on
    return planes, rest


def _pieces(points: Array, on: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """The points on a plane in pieces of at least `MIN_SIDE`, and those in narrower ones, as tops of things.

    What is at the height of a surface elsewhere, such as a bar beside a pallet, is on the same plane.
    """
    wide, narrow = np.zeros(len(points), np.bool_), np.zeros(len(points), np.bool_)
    if not on.any():
        return wide, narrow
    around = (points[on, :2] - np.median(points[on, :2], axis=0)) / PIECE_CELL
    cells = (np.clip(around, -PIECE_CELLS, PIECE_CELLS) + PIECE_CELLS).astype(np.intp)
    picture = np.zeros((2 * PIECE_CELLS + 1,) * 2, np.bool_)
    picture[tuple(cells.T)] = True
    labels = label(picture, np.ones((3, 3)))[0][tuple(cells.T)]
    numbers = np.flatnonzero(on)
    for piece in range(1, int(labels.max()) + 1):
        these = numbers[labels == piece]
        if len(these) < MIN_POINTS:
            continue
        # the sides of a rectangle are the square root of 12 times the standard deviations along them
        spread = np.linalg.eigvalsh(np.cov(points[these, :2].T))[0]
        (wide if math.sqrt(12.0 * max(0.0, float(spread))) >= MIN_SIDE else narrow)[these] = True
    return wide, narrow


def _largest_plane(points: Array, rng: np.random.Generator) -> Plane | None:
    """The nearly level plane through three points that most others are on."""
    if len(points) < MIN_POINTS:
        return None
    sample = points[rng.permutation(len(points))[:SAMPLE]]
    corners = sample[rng.integers(0, len(sample), (TRIES, 3))]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    level = np.abs(normals[:, 2]) > math.cos(MAX_TILT) * np.maximum(lengths, 1e-12)
    if not level.any():
        return None
    normals, corners = normals[level], corners[level]
    slopes = -normals[:, :2] / normals[:, 2:]
    starts = corners[:, 0, 2] - (slopes * corners[:, 0, :2]).sum(axis=1)
    off = np.abs(sample[:, 2] - slopes @ sample[:, :2].T - starts[:, None])
    best = int((off <= THICKNESS).sum(axis=1).argmax())
    return Plane((float(slopes[best, 0]), float(slopes[best, 1])), float(starts[best]))


def _clusters(points: Array) -> list[NDArray[np.intp]]:
    """Numbers of the points of each cluster."""
    if len(points) < MIN_POINTS:
        return []
    pairs = cKDTree(points).query_pairs(GAP, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs), np.int8), (pairs[:, 0], pairs[:, 1])), shape=(len(points),) * 2)
    _, labels = connected_components(links, directed=False)
    order = np.argsort(labels, kind="stable")
    ends = np.concatenate(([0], np.flatnonzero(np.diff(labels[order])) + 1, [len(order)]))
    return [order[one:other] for one, other in pairwise(ends.tolist()) if other - one >= MIN_POINTS]


def _thing(points: Array, colours: Array, planes: Sequence[Plane]) -> SeenObject | None:
    """The thing that a cluster is; None for what is too large, or floats."""
    if (np.ptp(points, axis=0) > MAX_SIZE).any():
        return None
    low = points[points[:, 2].argmin()]
    below = [plane for plane in planes if -THICKNESS <= plane.heights(low[None])[0] <= FLOATS]
    support = max(below, key=lambda plane: plane.at(*map(float, low[:2])), default=Plane((0.0, 0.0), float(low[2])))
    yaw, (long, short), middle = _level_box(points[:, :2])
    height = float(support.heights(points).max())
    centre = float(middle[0]), float(middle[1]), support.at(*map(float, middle)) + height / 2.0
    return SeenObject(points, centre, yaw, (long, short, height), support, bool(below), main_colour(colours))


def _level_box(points: Array) -> tuple[float, tuple[float, float], Array]:
    """Direction of the longer side (rad), sides and middle of the smallest level box around points, shape (n, 2)."""
    angles = np.arange(0.0, math.pi / 2.0, math.radians(3.0))
    along = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    across = np.stack((-np.sin(angles), np.cos(angles)), axis=1)
    first, second = points @ along.T, points @ across.T
    sides = np.ptp(first, axis=0), np.ptp(second, axis=0)
    best = int((sides[0] * sides[1]).argmin())
    middle = (first[:, best].min() + first[:, best].max()) / 2.0 * along[best]
    middle = middle + (second[:, best].min() + second[:, best].max()) / 2.0 * across[best]
    one, other = float(sides[0][best]), float(sides[1][best])
    if one >= other:
        return float(angles[best]), (one, other), middle
    return float(angles[best]) + math.pi / 2.0, (other, one), middle
