"""Straight legs of a way: whether they are free, what they cost, and few of them in place of many motions.

A robot that turns on the spot drives them one after the other, and turns at their corners. Frames and units are those
of the map: metres, radians.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from jauspy.planning.terrain_cost import COMFORTABLE, TerrainCost

CHECK: Final = 0.1
"""Metres between poses that are checked on a leg."""
TURN_CHECK: Final = math.tau / 16.0
"""Radians between headings that are checked where the robot turns."""
BACKWARD: Final = 2.0
"""Factor of the cost of driving backward."""
TIGHT_COST: Final = 1.0
"""Added to the cost of a metre with nothing beside the footprint."""
SMOOTHED: Final = 1.03
"""Factor by which a straight leg may be dearer than the motions that it replaces."""
CENTRING: Final = 0.05
"""Metres by which a corner is moved at a time to where it has more room."""
CENTRINGS: Final = 4
"""Times that each corner may be moved."""
WORTHWHILE: Final = 0.005
"""Cost, metres, that a move must save."""


class PathPoint(NamedTuple):
    """A point to which the robot drives, in metres, and whether it drives there backward."""

    x: float
    y: float
    backward: bool = False


@dataclass(frozen=True, slots=True)
class Motion:
    """The end of a motion: the heading there, radians, and the cost of the way up to it, metres."""

    end: PathPoint
    heading: float
    cost: float


def is_leg_free(terrain: TerrainCost, start: PathPoint, end: PathPoint) -> bool:
    """True if the robot can drive straight from one point to the next one."""
    parts = np.linspace(0.0, 1.0, max(1, math.ceil(math.dist(start[:2], end[:2]) / CHECK)) + 1)
    xs, ys = start.x + parts * (end.x - start.x), start.y + parts * (end.y - start.y)
    return terrain.all_free(xs, ys, heading_on(start, end), backward=end.backward)


def is_way_free(terrain: TerrainCost, points: Sequence[PathPoint]) -> bool:
    """True if the robot can drive along straight legs through points."""
    return all(is_leg_free(terrain, a, b) for a, b in itertools.pairwise(points))


def way_length(points: Sequence[PathPoint]) -> float:
    """Metres of straight legs through points."""
    return sum(math.dist(a[:2], b[:2]) for a, b in itertools.pairwise(points))


def way_cost(terrain: TerrainCost, points: Sequence[PathPoint]) -> float:
    """Cost of straight legs through points, metres, as that of a `Path`; whether they are free does not count."""
    return sum(_leg_cost(terrain, a, b) for a, b in itertools.pairwise(points))


def heading_on(start: PathPoint, end: PathPoint) -> float:
    """The heading of the robot on a leg."""
    return math.atan2(end.y - start.y, end.x - start.x) + (math.pi if end.backward else 0.0)


def few_legs(terrain: TerrainCost, motions: Sequence[Motion]) -> list[PathPoint]:
    """Few straight legs that replace many motions, where they are free and hardly dearer."""
    places = [motion.end for motion in motions]
    driven = [0.0, *itertools.accumulate(_leg_cost(terrain, a, b) for a, b in itertools.pairwise(places))]
    searched = [motion.cost for motion in motions]
    kept = [places[0]]
    begin = 0
    while begin < len(places) - 1:
        earlier = heading_on(*kept[-2:]) if len(kept) > 1 else motions[begin].heading
        end, stride = begin + 1, 1
        while stride:  # longer and longer legs, then shorter and shorter additions
            candidate = end + stride
            if candidate < len(places) and _is_good_leg(
                terrain,
                places[begin : candidate + 1],
                earlier,
                SMOOTHED * max(costs[candidate] - costs[begin] for costs in (driven, searched)),
            ):
                end, stride = candidate, 2 * stride
            else:
                stride //= 2
        if math.dist(places[begin][:2], places[end][:2]) > 1e-6:
            kept.append(places[end])
        begin = end
    return kept


def _is_good_leg(terrain: TerrainCost, places: Sequence[PathPoint], earlier: float, most: float) -> bool:
    """True if a leg from the first to the last place is as good as one over all of them.

    The robot has the heading `earlier`, and the leg may cost `most`.
    """
    start, end = places[0], places[-1]
    return (
        all(place.backward == end.backward for place in places[1:])
        and _leg_cost(terrain, start, end) <= most
        and is_leg_free(terrain, start, end)
        and _can_turn(terrain, start, earlier, heading_on(start, end))
    )


def with_more_room(terrain: TerrainCost, points: Sequence[PathPoint], heading: float) -> list[PathPoint]:
    """The way with corners moved to where it costs less, as to the middle of a door; it begins with a heading.

    The search knows few places and headings, so that it passes a door beside its middle.
    """
    found = list(points)
    for _ in range(CENTRINGS):
        before = list(found)
        for number in range(1, len(found) - 1):
            found[number] = _moved(terrain, found, number, heading)
        if found == before:
            break
    return found


def _moved(terrain: TerrainCost, points: Sequence[PathPoint], number: int, heading: float) -> PathPoint:
    """A corner, or a place beside it with which the two legs there cost less."""
    before, here, after = points[number - 1 : number + 2]
    best, least = here, way_cost(terrain, (before, here, after)) - WORTHWHILE
    if least <= way_length((before, here, after)):
        return here  # it costs no more than open ground
    for dx, dy in itertools.product((-CENTRING, 0.0, CENTRING), repeat=2):
        place = PathPoint(here.x + dx, here.y + dy, here.backward)
        if place == here or min(math.dist(before[:2], place[:2]), math.dist(place[:2], after[:2])) < CENTRING:
            continue
        cost = way_cost(terrain, (before, place, after))
        if cost < least and _is_free(terrain, [*points[:number], place, *points[number + 1 :]], number, heading):
            best, least = place, cost
    return best


def _is_free(terrain: TerrainCost, points: Sequence[PathPoint], number: int, heading: float) -> bool:
    """True if the legs to and from a corner are free, and the turns at their ends."""
    if not is_way_free(terrain, points[number - 1 : number + 2]):
        return False
    for corner in range(number - 1, min(number + 2, len(points) - 1)):
        earlier = heading_on(*points[corner - 1 : corner + 1]) if corner else heading
        if not _can_turn(terrain, points[corner], earlier, heading_on(*points[corner : corner + 2])):
            return False
    return True


def _can_turn(terrain: TerrainCost, place: PathPoint, earlier: float, heading: float) -> bool:
    """True if the robot can turn on the spot from one heading to another one."""
    turn = math.remainder(heading - earlier, math.tau)
    count = math.ceil(abs(turn) / TURN_CHECK)
    return all(
        terrain.is_free(place.x, place.y, earlier + turn * number / count, turns=True) for number in range(1, count)
    )


def _leg_cost(terrain: TerrainCost, start: PathPoint, end: PathPoint) -> float:
    length = math.dist(start[:2], end[:2])
    if not length:
        return 0.0
    count = max(1, math.ceil(length / CHECK))
    parts = (np.arange(count) + 0.5) / count
    xs, ys = start.x + parts * (end.x - start.x), start.y + parts * (end.y - start.y)
    tight = 1.0 - np.clip(terrain.clearances(xs, ys, heading_on(start, end)) / COMFORTABLE, 0.0, 1.0)
    driven = float(terrain.costs_at(xs, ys).mean()) * (BACKWARD if end.backward else 1.0)
    return length * (driven + TIGHT_COST * float(tight.mean()))
