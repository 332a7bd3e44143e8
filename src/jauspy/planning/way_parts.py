"""A way of straight legs in parts: those near steps that need flippers, those in tight places, and the others.

Points are in the map, in metres.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.planning.legs import PathPoint, way_length
from jauspy.planning.mobility import FLIPPER_ANGLE
from jauspy.planning.terrain_cost import TerrainCost

SPACING: Final = 0.05
"""Metres between the points of a way that are compared with steps."""
SHORT: Final = 0.35
"""Metres of a part that is left out before a step: the robot may be past its end before it has the list, and would turn
back for it."""
STEP_ROOM: Final = 0.7
"""Metres before and after a step between which flippers are set for it."""


@dataclass(frozen=True, slots=True)
class Part:
    """A piece of the way that is driven with one posture of the flippers; None for that at the start."""

    points: tuple[PathPoint, ...]
    flippers: float | None
    is_tight: bool = False
    """True where the robot has no room to turn but with its exact footprint: it must not drive past a corner."""


def nearest_on_leg(point: PathPoint, start: PathPoint, end: PathPoint) -> PathPoint:
    """The point of a leg that is nearest to a point."""
    dx, dy = end.x - start.x, end.y - start.y
    length = dx * dx + dy * dy
    part = ((point.x - start.x) * dx + (point.y - start.y) * dy) / length if length else 0.0
    part = min(1.0, max(0.0, part))
    return _at(end, start.x + part * dx, start.y + part * dy)


def first_metres(points: Sequence[PathPoint], metres: float) -> list[PathPoint]:
    """The points of a way up to this length."""
    found, left = list(points[:1]), metres
    for before, after in itertools.pairwise(points):
        length = math.dist(before[:2], after[:2])
        if length >= left:
            part = left / length
            found.append(_at(after, before.x + part * (after.x - before.x), before.y + part * (after.y - before.y)))
            break
        found.append(after)
        left -= length
    return found


def _at(point: PathPoint, x: float, y: float) -> PathPoint:
    """The point at another place."""
    return PathPoint(x, y, point.backward)


def parts(points: Sequence[PathPoint], terrain: TerrainCost, *, flippers: bool) -> list[Part]:
    """The way in parts: of a robot with flippers those near steps that need them; tight ones, and the others."""
    found = _by_steps(points, terrain) if flippers else [Part(tuple(points), None)]
    if not terrain.is_exact:
        return found
    return [piece for part in found for piece in _by_room(part, terrain)]


def _by_room(part: Part, terrain: TerrainCost) -> list[Part]:
    """A part in those with room to turn at their corners, and those without; one without a leg stays."""
    tight = [terrain.room(point.x, point.y) < 0.0 for point in part.points]
    legs = itertools.groupby(range(len(tight) - 1), key=lambda number: tight[number] or tight[number + 1])
    found = [(is_tight, list(numbers)) for is_tight, numbers in legs]
    return [
        replace(part, points=part.points[numbers[0] : numbers[-1] + 2], is_tight=is_tight)
        for is_tight, numbers in found
    ] or [part]


def _by_steps(points: Sequence[PathPoint], terrain: TerrainCost) -> list[Part]:
    close = _dense(points, SPACING)
    marked = [terrain.needs_flippers(point.x, point.y) for point in close]
    reach = round(STEP_ROOM / SPACING)
    steep = [any(marked[max(0, number - reach) : number + reach + 1]) for number in range(len(close))]
    if not any(steep):
        return [Part(tuple(points), None)]
    corners = {point[:2] for point in points}
    found: list[Part] = []
    for climbs, numbers in itertools.groupby(range(len(close)), key=lambda number: steep[number]):
        run = list(numbers)
        first = [close[run[0] - 1]] if run[0] else []
        inner = [close[number] for number in run if close[number][:2] in corners or number in (run[0], run[-1])]
        found.append(Part((*first, *inner), FLIPPER_ANGLE if climbs else None))
    return found


def without_short_start(found: Sequence[Part]) -> list[Part]:
    """Parts of which the first is not too short to be driven: then the next one begins where the robot is.

    In tight places no corner is left out.
    """
    first, *rest = found
    if not rest or first.is_tight or rest[0].is_tight or way_length(first.points) >= SHORT:
        return [first, *rest]
    return [replace(rest[0], points=(first.points[0], *rest[0].points[1:])), *rest[1:]]


def _dense(points: Sequence[PathPoint], step: float) -> list[PathPoint]:
    found = [points[0]]
    for before, after in itertools.pairwise(points):
        count = max(1, math.ceil(math.dist(before[:2], after[:2]) / step))
        found += [
            _at(after, before.x + n / count * (after.x - before.x), before.y + n / count * (after.y - before.y))
            for n in range(1, count)
        ]
        found.append(after)
    return found
