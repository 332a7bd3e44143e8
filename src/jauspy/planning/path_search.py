"""Paths for a robot over terrain: a hybrid search with heading and footprint, and straight legs out of what it finds.

First the cost to the goal of each cell is computed without headings (Dijkstra, scipy); it guides A* over poses, whose
motions are those that the robot's guidance can follow: straight ahead, curves, turns on the spot where the chassis can,
and backward. Frames and units are those of the map: metres, radians.
"""

from __future__ import annotations

import heapq
import itertools
import math
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from jauspy.errors import RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.planning.legs import (
    BACKWARD,
    TIGHT_COST,
    Motion,
    PathPoint,
    few_legs,
    heading_on,
    is_leg_free,
    is_way_free,
    way_cost,
    way_length,
    with_more_room,
)
from jauspy.planning.terrain_cost import COMFORTABLE, MARGIN, TerrainCost

HEADINGS: Final = 16
TURN: Final = math.tau / HEADINGS
"""Radians between two headings of the search."""
CELL: Final = 0.1
"""Side of the cells of the search, metres; those of the map may be smaller."""
STRIDE: Final = 0.2
"""Metres of a straight motion."""
TURN_COST: Final = 0.08
"""Cost of a turn on the spot by `TURN`, metres."""
TURN_SLOPE: Final = 0.12
"""Slope, as a tangent, on which tracks slip when they turn on the spot."""
SLIP_COST: Final = 1.0
"""Added to the cost of a turn on the spot by `TURN` there, metres."""
GREED: Final = 1.1
"""Factor of the estimated cost to the goal: the search finds a way that is at most so much dearer, sooner."""
UPWARD: Final = math.cos(math.radians(50.0))
"""Cosine of the greatest angle between an edge of the grid and the way up a step: headings are `STEP_HEADING` off it,
and edges 45 degrees apart."""
GOAL_TOLERANCE: Final = 0.25
"""Metres from the goal at which the search has arrived, or from the nearest place where the robot can stand, which is
as near to the goal."""
STANDING_REACH: Final = 1.0
"""Metres around a goal at an edge within which a place to stand is sought, so that the refusal can name it."""


class Room(NamedTuple):
    """Room that stays free on a way: metres beside the footprint, and whether that is the exact one."""

    margin: float
    is_exact: bool = False


ROOMS: Final = (Room(0.05), Room(MARGIN), Room(0.05, is_exact=True))
"""Room on a way, to the middles of occupied cells: the first with which there is one. With a margin of less, the
footprint would be inside of cells."""
SHARES: Final = (0.5, 0.75, 1.0)
"""Parts of the time that is left which these searches may take: one that looks for a way through a door that is a cell
too narrow looks everywhere else first."""
DETOUR: Final = 1.5
MORE: Final = 1.0
"""Factor, and metres, by which a way is longer than straight to the goal when one with less room is sought, too: where
the robot cannot turn with 5 cm on each side, it would first drive through half of a house."""
MUCH_SHORTER: Final = 0.7
"""Part of the cost of a way with more room, less `MORE`, below which one with less is taken. With nothing beside it,
three of 100 drives touched a wall or a chair."""


class NoPath(RequestError):
    """There is no way; the message says why."""


class NoStand(NoPath):
    """The robot cannot stand at the goal; `place_to_stand` finds where it can."""


@dataclass(frozen=True, slots=True)
class Path:
    """A way of straight legs: the first point is where the robot is."""

    points: tuple[PathPoint, ...]
    cost: float
    """Metres, more where ground is difficult."""
    expanded: int
    """Poses that the search looked at."""
    search_time: float
    """Seconds of processor time."""

    @property
    def length(self) -> float:
        """Metres."""
        return way_length(self.points)


class _Motion(NamedTuple):
    """A motion in the frame of the robot: where it leads, its cost in metres, and poses on its way (x, y, turn)."""

    x: float
    y: float
    turn: int
    cost: float
    on_way: tuple[tuple[float, float, float], ...]
    backward: bool = False

    @property
    def is_on_the_spot(self) -> bool:
        """True for a turn that leads nowhere else."""
        return not (self.x or self.y)


def find_path(
    terrain: TerrainCost, start: PlanarPose, goal: tuple[float, float], *, backward: bool = True, seconds: float = 1.0
) -> Path:
    """The way from a pose to a point; raises `NoPath`, after `seconds` of processor time at the latest."""
    began = time.thread_time()
    terrain.start_at(start)
    stand = _check_ends(terrain, start, goal)
    remaining = _Remaining(terrain, start, goal)
    nodes, expanded = _search(terrain, remaining, start, (goal, stand), backward=backward, end=began + seconds)
    motions = [Motion(PathPoint(node.x, node.y, node.backward), node.heading * TURN, node.cost) for node in nodes]
    turns = not terrain.mobility.min_turn_radius
    points = few_legs(terrain, motions) if turns else [motion.end for motion in motions]
    end = PathPoint(*goal, points[-1].backward)
    if (
        len(points) > 1
        and is_leg_free(terrain, points[-2], end)
        and not terrain.is_astride(*goal, heading_on(points[-2], end))
    ):
        points[-1] = end
    if turns:
        points = with_more_room(terrain, points, start.yaw)
    return Path(tuple(points), way_cost(terrain, points), expanded, time.thread_time() - began)


def find_path_with_margins(
    terrain: TerrainCost, start: PlanarPose, goal: tuple[float, float], *, backward: bool, end: float
) -> Path:
    """A way with the first of `ROOMS` that has one, or with less room if that is much shorter.

    What lies on the ground is driven around where that is not much longer, even if the robot could drive over it.

    Raises `NoPath`, that of the first of them, or at `end`, in processor time.
    """
    first: NoPath | None = None
    best: Path | None = None
    used = ROOMS[0]
    direct = math.dist(start[:2], goal)
    terrain.keep_off_things(False)
    for room, share in zip(ROOMS, SHARES, strict=True):
        if best is not None and best.length <= DETOUR * direct + MORE:
            break
        terrain.margin, terrain.is_exact = room
        try:
            found = find_path(terrain, start, goal, backward=backward, seconds=share * (end - time.thread_time()))
        except NoPath as reason:
            first = first or reason
        else:
            if best is None or found.cost < MUCH_SHORTER * best.cost - MORE:
                best, used = found, room
        if time.thread_time() > end:
            break
    terrain.margin, terrain.is_exact = used
    if best is None:
        assert first is not None
        raise first
    return _around_things(terrain, start, goal, best, backward=backward, end=end)


def _around_things(
    terrain: TerrainCost, start: PlanarPose, goal: tuple[float, float], way: Path, *, backward: bool, end: float
) -> Path:
    """The way, or one that keeps off what lies on the ground and is not much longer; the terrain is as for that one."""
    if not terrain.has_things:
        return way
    room = Room(terrain.margin, terrain.is_exact)
    terrain.keep_off_things(True)
    terrain.start_at(start)
    if is_way_free(terrain, way.points):
        return way
    with suppress(NoPath):
        terrain.margin, terrain.is_exact = ROOMS[0]
        around = find_path(terrain, start, goal, backward=backward, seconds=end - time.thread_time())
        if around.length <= DETOUR * way.length + MORE:
            return around
    terrain.margin, terrain.is_exact = room
    terrain.keep_off_things(False)
    terrain.start_at(start)
    return way


def _check_ends(terrain: TerrainCost, start: PlanarPose, goal: _Point) -> _Point:
    """The goal, or the place near it where the robot can stand; raises `NoPath`."""
    if terrain.cell(*goal) is None:
        raise NoPath(f"({goal[0]:.2f}, {goal[1]:.2f}) is outside of the map; choose a nearer goal, or a larger map")
    if terrain.cell(start.x, start.y) is None:
        raise NoPath(f"the robot is at ({start.x:.2f}, {start.y:.2f}), outside of the map; use a larger map")
    if all(not terrain.is_free(*goal, number * TURN) for number in range(HEADINGS)):
        far = terrain.distance[terrain.cell(*goal)]
        needed = terrain.mobility.half_width + terrain.margin
        why = f"{far:.2f} m from an obstacle" if far < needed else "where the robot cannot stand with any heading"
        raise NoStand(f"({goal[0]:.2f}, {goal[1]:.2f}) is {why}; choose a goal {needed:.2f} m from obstacles")
    if _can_stand(terrain, *goal):
        return goal
    place = place_to_stand(terrain, goal)
    if place is not None and math.dist(place, goal) <= GOAL_TOLERANCE:
        return place
    advice = (
        "choose a goal farther from the edge"
        if place is None
        else f"({place[0]:.2f}, {place[1]:.2f}) is the nearest place where it can stand"
    )
    raise NoStand(f"({goal[0]:.2f}, {goal[1]:.2f}) is at the edge of a step, astride of which no robot stops; {advice}")


def place_to_stand(terrain: TerrainCost, goal: tuple[float, float]) -> tuple[float, float] | None:
    """The place nearest to a goal where the robot can stand; None if there is none within `STANDING_REACH`."""
    side = terrain.resolution
    reach = math.floor(STANDING_REACH / side)
    steps = sorted(itertools.product(range(-reach, reach + 1), repeat=2), key=lambda step: math.hypot(*step))
    places = ((goal[0] + side * right, goal[1] + side * up) for right, up in steps)
    return next((place for place in places if _can_stand(terrain, *place)), None)


def _can_stand(terrain: TerrainCost, x: float, y: float) -> bool:
    """True if the robot fits at a point with one heading at least, and is not astride of a step."""
    headings = (number * TURN for number in range(HEADINGS))
    return any(not terrain.is_astride(x, y, heading) and terrain.is_free(x, y, heading) for heading in headings)


class _Remaining:
    """Estimated cost from each cell of `CELL` metres to the goal, without headings; inf where there is no way."""

    def __init__(self, terrain: TerrainCost, start: PlanarPose, goal: tuple[float, float]) -> None:
        factor = max(1, round(CELL / terrain.resolution))
        self._origin, self._side = terrain.origin, factor * terrain.resolution
        far, cost = _reduced(terrain.distance, factor, np.max), _reduced(terrain.cost, factor, np.min)
        free = far >= terrain.mobility.half_width + terrain.margin - terrain.resolution
        self._shape = free.shape
        for point in ((start.x, start.y), goal):
            free[self._cell(*point)] = True
        numbers = np.full(free.shape, -1, np.int64)
        numbers[free] = np.arange(np.count_nonzero(free))
        ways_up = terrain.ways_up()
        up = None if ways_up is None else tuple(_sampled(way, factor) for way in ways_up)
        graph = _graph(numbers, cost, self._side, up)
        costs = csgraph.dijkstra(graph.T, indices=int(numbers[self._cell(*goal)]))  # against the way
        found = np.full(free.shape, np.inf)
        found[free] = costs
        self._costs: list[list[float]] = found.tolist()

    def _cell(self, x: float, y: float) -> tuple[int, int]:
        row = math.floor((y - self._origin[1]) / self._side)
        column = math.floor((x - self._origin[0]) / self._side)
        return min(max(row, 0), self._shape[0] - 1), min(max(column, 0), self._shape[1] - 1)

    def at(self, x: float, y: float) -> float:
        """Cost from a point, metres."""
        row, column = self._cell(x, y)
        return self._costs[row][column]


def _reduced(values: NDArray[np.floating], factor: int, take: Callable[..., Any]) -> NDArray[np.floating]:
    rows, columns = (-(-side // factor) * factor for side in values.shape)
    padded = np.pad(values, ((0, rows - values.shape[0]), (0, columns - values.shape[1])), mode="edge")
    blocks = padded.reshape(rows // factor, factor, columns // factor, factor)
    reduced: NDArray[np.floating] = take(blocks, axis=(1, 3))
    return reduced


def _sampled(values: NDArray[np.floating], factor: int) -> NDArray[np.floating]:
    """The middle one of each block of values."""
    rows, columns = (np.minimum(np.arange(0, side, factor) + factor // 2, side - 1) for side in values.shape)
    return values[np.ix_(rows, columns)]


def _graph(
    numbers: NDArray[np.int64],
    cost: NDArray[np.floating],
    side: float,
    up: tuple[NDArray[np.floating], ...] | None,
) -> sparse.csr_matrix:
    """Edges from free cells to those that they touch: their length, times the mean cost of both.

    Where `up` has a direction, x and y, of a step that only flippers climb, edges lead up it.
    """
    rows, columns = numbers.shape
    begins, ends, weights = [], [], []
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = np.s_[: rows - down, max(0, -right) : columns - max(0, right)]
        b = np.s_[down:, max(0, right) : columns + min(0, right)]
        both = (numbers[a] >= 0) & (numbers[b] >= 0)
        length = math.hypot(down, right)
        for first, last, sign in ((a, b, 1.0), (b, a, -1.0)):
            ok = both
            if up is not None:
                climbs = [sign * (right * up[0][cells] + down * up[1][cells]) / length for cells in (a, b)]
                ok = both & ~(climbs[0] < UPWARD) & ~(climbs[1] < UPWARD)  # also where there is no step: NaN
            begins.append(numbers[first][ok])
            ends.append(numbers[last][ok])
            weights.append(0.5 * side * length * (cost[a][ok] + cost[b][ok]))
    count = int(numbers.max()) + 1
    entries = (np.concatenate(weights), (np.concatenate(begins), np.concatenate(ends)))
    return sparse.csr_matrix(entries, shape=(count, count))


def _motions(turn_radius: float, *, backward: bool) -> tuple[_Motion, ...]:
    """Motions from a pose. A curve changes the heading by `TURN`; its radius is the least of the robot."""
    found = [_arc(STRIDE, 0, backward=False)]
    curve = turn_radius * TURN
    if turn_radius:
        found += [_arc(curve, turn, backward=False) for turn in (-1, 1)]
    else:
        found += [_bend(turn) for turn in (-1, 1)]
        found += [_Motion(0.0, 0.0, turn, TURN_COST, ((0.0, 0.0, turn * TURN / 2.0),)) for turn in (-1, 1)]
    if backward:
        found += [_arc(STRIDE, 0, backward=True)]
        found += [_arc(curve, turn, backward=True) for turn in ((-1, 1) if turn_radius else ())]
    return tuple(found)


def _arc(length: float, turn: int, *, backward: bool) -> _Motion:
    angle, sign = turn * TURN, -1.0 if backward else 1.0
    radius = length / abs(angle) if angle else 0.0

    def place(part: float) -> tuple[float, float, float]:
        if not angle:
            return sign * part * length, 0.0, 0.0
        turned = part * abs(angle)
        return sign * radius * math.sin(turned), math.copysign(radius * (1.0 - math.cos(turned)), angle), part * angle

    x, y, _ = place(1.0)
    if backward and angle:  # backward, a turn to the left leads the rear to the right
        y = -y
    cost = length * (BACKWARD if backward else 1.0) + 0.02 * abs(turn)
    return _Motion(x, y, turn, cost, (place(0.5),), backward)


def _bend(turn: int) -> _Motion:
    """A curve of a robot that turns on the spot: straight legs replace it, at whose corners it turns."""
    curve = _arc(STRIDE, turn, backward=False)
    half = turn * TURN / 2.0
    return curve._replace(on_way=tuple((part * curve.x, part * curve.y, half) for part in (0.0, 0.5, 1.0)))


_Key = tuple[int, int, int]
_Point = tuple[float, float]


@dataclass(slots=True)
class _Node:
    x: float
    y: float
    heading: int
    cost: float
    parent: _Node | None
    backward: bool = False


def _search(
    terrain: TerrainCost,
    remaining: _Remaining,
    start: PlanarPose,
    ends: tuple[_Point, _Point],
    *,
    backward: bool,
    end: float,
) -> tuple[list[_Node], int]:
    """Nodes from the start to the goal, and how many were expanded.

    `ends` are the goal, and the place to stand there.
    """
    goal, stand = ends
    motions = _motions(terrain.mobility.min_turn_radius, backward=backward)
    angles = [number * TURN for number in range(HEADINGS)]
    turned = [(math.cos(angle), math.sin(angle)) for angle in angles]
    first = _Node(start.x, start.y, round(start.yaw / TURN) % HEADINGS, 0.0, None)
    if math.isinf(left := remaining.at(first.x, first.y)):
        raise NoPath(
            f"there is no way to ({goal[0]:.2f}, {goal[1]:.2f}): obstacles lie all around it, or the robot; choose "
            "another goal, or clear the way"
        )
    order = itertools.count()
    queue = [(GREED * left, next(order), first)]
    best: dict[_Key, float] = {_key(first): 0.0}
    closed: set[_Key] = set()
    while queue:
        _, _, node = heapq.heappop(queue)
        key = _key(node)
        if key in closed:
            continue
        closed.add(key)
        if math.hypot(node.x - stand[0], node.y - stand[1]) <= GOAL_TOLERANCE and not terrain.is_astride(
            node.x, node.y, angles[node.heading]
        ):
            return _ancestors(node), len(closed)
        if not len(closed) % 256 and time.thread_time() > end:
            raise NoPath(
                f"no way to ({goal[0]:.2f}, {goal[1]:.2f}) was found in time: {len(closed)} poses were tried; choose a "
                "goal with more room, or one on the way"
            )
        c, s = turned[node.heading]
        for motion in motions:
            x, y = node.x + c * motion.x - s * motion.y, node.y + s * motion.x + c * motion.y
            heading = (node.heading + motion.turn) % HEADINGS
            new_key = (math.floor(x / CELL), math.floor(y / CELL), heading)
            if new_key in closed:
                continue
            cost = node.cost + motion.cost * terrain.cost_at(x, y)
            if motion.is_on_the_spot and math.hypot(*terrain.slope_at(x, y)) > TURN_SLOPE:
                cost += SLIP_COST
            if cost >= best.get(new_key, math.inf) or math.isinf(left := remaining.at(x, y)):
                continue
            reverse = motion.backward
            turns = motion.turn != 0
            clearance = terrain.free_clearance(x, y, angles[heading], backward=reverse, turns=turns)
            if math.isinf(clearance):
                continue
            if clearance < COMFORTABLE:
                cost += TIGHT_COST * STRIDE * (1.0 - max(0.0, clearance) / COMFORTABLE)
            if cost >= best.get(new_key, math.inf) or not all(
                terrain.is_free(
                    *(node.x + c * dx - s * dy, node.y + s * dx + c * dy, angles[node.heading] + turn),
                    backward=reverse,
                    turns=turns,
                )
                for dx, dy, turn in motion.on_way
            ):
                continue
            best[new_key] = cost
            new = _Node(x, y, heading, cost, node, motion.backward)
            heapq.heappush(queue, (cost + GREED * left, next(order), new))
    raise NoPath(
        f"there is no way to ({goal[0]:.2f}, {goal[1]:.2f}) that is wide enough for the robot to drive and turn; "
        "choose another goal, or clear the way"
    )


def _key(node: _Node) -> _Key:
    return math.floor(node.x / CELL), math.floor(node.y / CELL), node.heading


def _ancestors(node: _Node) -> list[_Node]:
    found = [node]
    while (parent := found[-1].parent) is not None:
        found.append(parent)
    return found[::-1]
