"""Motions of the arm: straight in joint space where that is free, and detours by RRT-connect where it is not.

Kuffner and LaValle, "RRT-Connect: An efficient approach to single-query path planning", ICRA 2000.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, Protocol

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, offset_between
from jauspy.cell.held_load import MOST, HeldLoad
from jauspy.cell.kinematics import Posture
from jauspy.cell.scene import CLEAR, Clearance, PlanningScene
from jauspy.errors import RequestError

GENTLE: Final = 0.05
"""Fraction of the joints' acceleration in motions that speed up slowly."""
STEP: Final = 0.04
"""Radians of the fastest joint between two postures that are checked: at most 5 cm at the end of a UR10."""
REACH: Final = 0.35
"""Radians of one extension of a tree."""
LEAST_PROGRESS: Final = 0.02
"""Radians by which an extension must come closer to what it goes to."""
MAX_NODES: Final = 900
"""Nodes of both trees together."""
SHORTCUTS: Final = 60
"""Random shortcuts that are tried on a detour."""
MAX_LINE_ERROR: Final = 0.0015
"""Metres by which the tool may leave a straight line between two postures on it."""
CANDIDATES: Final = 4
"""Postures to which a detour is searched, before the pose counts as out of reach."""


class NoPath(RequestError):
    """There is no posture for a pose, or no free path to it; the message names the reason and the obstacle."""


@dataclass(frozen=True, slots=True)
class Path:
    """Postures (rad) that are joined by straight joint motions, and the smallest distance on the way."""

    points: tuple[Array, ...]
    clearance: Clearance = CLEAR

    @property
    def end(self) -> Array:
        """The last posture."""
        return self.points[-1]


@dataclass(frozen=True, slots=True)
class Profile:
    """One straight joint motion in which all joints start and arrive together: rad/s and rad/s^2 for each joint."""

    goal: Array
    speeds: Array
    accelerations: Array
    duration: float
    """Seconds."""


def profile(
    start: Array,
    goal: Array,
    speeds: Array,
    accelerations: Array,
    *,
    length: float = 0.0,
    tool_speed: float = math.inf,
) -> Profile:
    """The trapezoid that all joints share; limits in rad/s and rad/s^2.

    `length`: metres that the tool moves, at most at `tool_speed` in m/s.
    """
    way = np.abs(goal - start)
    moved = way > 1e-9
    if not np.any(moved):
        return Profile(goal, speeds, accelerations, 0.0)
    rate = float(np.min(speeds[moved] / way[moved]))
    if length > 0.0:
        rate = min(rate, tool_speed / length)
    change = float(np.min(accelerations[moved] / way[moved]))
    ramp = rate / change
    duration = 1.0 / rate + ramp if rate * ramp < 1.0 else 2.0 / math.sqrt(change)
    least = 1e-4  # a joint that does not move still needs limits above zero
    return Profile(goal, np.maximum(way * rate, least), np.maximum(way * change, least), duration)


class Movable(Protocol):
    """The arm that a planner moves; positions in radians."""

    lower: Array
    upper: Array

    def forward(self, positions: Array) -> pin.SE3:
        """The pose of the tool in the world."""
        ...

    def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
        """The posture near `start` that has the tool at `goal`; None without one."""
        ...


class MotionPlanner:
    """Plans motions in a scene; the same seed gives the same paths."""

    def __init__(
        self, scene: PlanningScene, kinematics: Movable, *, margin: float = 0.012, seed: int = 0, nodes: int = MAX_NODES
    ) -> None:
        self.scene = scene
        self.kinematics = kinematics
        self.margin = margin
        """Metres to keep from everything, except at the end of an approach."""
        self._nodes = nodes
        self._random = np.random.default_rng(seed)
        self.load: HeldLoad | None = None
        """What the tool holds. Motions to postures then use no more than `MOST` of what holds it, at rest."""
        self._hanging: Array = np.zeros(3)
        """Direction of the tool at the goal of a detour."""
        k = kinematics
        self._lower, self._upper = np.maximum(k.lower, -math.tau), np.minimum(k.upper, math.tau)

    # --- to a posture ---------------------------------------------------------------------------------------------

    def to_posture(self, start: Array, goal: Array, *, margin: float | None = None) -> Path:
        """A free path; raises `NoPath`, which names what is in the way."""
        margin = self._margin_at(start, self.margin if margin is None else margin)
        if not self.scene.is_free(goal, margin):
            raise NoPath(f"the posture is not free: {self._reason(goal)}")
        self._check_held(start, goal)
        straight = self.scene.along((start, goal), STEP)
        if straight.distance >= margin and self._is_held(start, goal):
            return Path((start, goal), straight)
        points = self._connect(start, goal, margin)
        if points is None and straight.distance >= margin:
            raise NoPath(f"no way was found on which the load stays below {MOST:.0%} of what holds it")
        if points is None:
            between = " and ".join(straight.between)
            raise NoPath(f"no way around {between} was found with {self._nodes} postures, {1000 * margin:.0f} mm off")
        points = self._shortened(points, margin)
        return Path(tuple(points), self.scene.along(points, STEP))

    def to_any(self, start: Array, goals: Sequence[Posture], *, margin: float | None = None) -> Path:
        """A free path to the posture that is reached soonest; raises `NoPath`."""
        least = self._margin_at(start, self.margin if margin is None else margin)
        free = [goal.positions for goal in goals if self.scene.is_free(goal.positions, least)]
        if not free:
            reason = (
                self._reason(goals[0].positions) if goals else "the pose is out of reach, or close to a singularity"
            )
            raise NoPath(f"no posture is free: {reason}")
        for goal in free:
            found = self.scene.along((start, goal), STEP, enough=least)
            if found.distance >= least and self._is_held(start, goal):
                return Path((start, goal), self.scene.along((start, goal), STEP))
        failures = []
        for goal in free[:CANDIDATES]:
            try:
                return self.to_posture(start, goal, margin=margin)
            except NoPath as error:
                failures.append(str(error))
        raise NoPath(failures[0])

    # --- in a straight line ---------------------------------------------------------------------------------------

    def line(self, start: Array, goal: pin.SE3, *, margin: float | None = None) -> Path:
        """A path on which the tool moves in a straight line to `goal`; raises `NoPath`."""
        points = self._subdivided(start, self.kinematics.forward(start), goal, 5)
        found = self.scene.along(points, STEP / 4.0)
        if margin is not None and found.distance < margin:
            raise NoPath(f"the straight approach is blocked: {_named(found)}")
        return Path(tuple(points), found)

    def _subdivided(self, start: Array, here: pin.SE3, goal: pin.SE3, depth: int) -> list[Array]:
        end = self.kinematics.solve_from(goal, start)
        if end is None or np.any(end > self.kinematics.upper) or np.any(end < self.kinematics.lower):
            raise NoPath("the straight line leaves the arm's reach")
        if float(np.max(np.abs(end - start))) > 1.5:
            raise NoPath("the straight line passes a singularity")
        middle = pin.SE3.Interpolate(here, goal, 0.5)
        off, _ = offset_between(self.kinematics.forward((start + end) / 2.0), middle)
        if off <= MAX_LINE_ERROR or depth == 0:
            return [start, end]
        first = self._subdivided(start, here, middle, depth - 1)
        return first[:-1] + self._subdivided(first[-1], middle, goal, depth - 1)

    # --- detours --------------------------------------------------------------------------------------------------

    def _margin_at(self, start: Array, margin: float) -> float:
        """The margin, or less when the motion starts closer than that to something."""
        here = self.scene.clearance(start, enough=margin).distance
        return margin if here >= margin else max(0.0005, here - 0.001)

    def _reason(self, posture: Array) -> str:
        return _named(self.scene.explain(posture))

    def _is_free(self, a: Array, b: Array, margin: float) -> bool:
        if not self._is_held(a, b):
            return False
        count = max(1, math.ceil(float(np.max(np.abs(b - a))) / STEP))
        return all(self.scene.is_free(a + (b - a) * (number / count), margin) for number in range(1, count + 1))

    def _used(self, posture: Array) -> float:
        return self.load.utilisation(self.kinematics.forward(posture)) if self.load is not None else 0.0

    def _is_held(self, a: Array, b: Array) -> bool:
        """True if the load hangs safely all along a straight joint motion."""
        if self.load is None or self.load.worst <= MOST:
            return True
        count = max(1, math.ceil(float(np.max(np.abs(b - a))) / STEP))
        return all(self._used(a + (b - a) * (number / count)) <= MOST for number in range(1, count + 1))

    def _check_held(self, start: Array, goal: Array) -> None:
        for name, posture in (("start", start), ("end", goal)):
            if (used := self._used(posture)) > MOST:
                raise NoPath(
                    f"at the {name} of the motion the load uses {used:.0%} of what holds it, at most {MOST:.0%} is safe"
                )

    def _as_held(self, posture: Array) -> Array | None:
        """The posture, or one near it in which the tool hangs as at the start, if the load would not be safe in it."""
        if self._used(posture) <= MOST:
            return posture
        tool = self.kinematics.forward(posture)
        z, wanted = tool.rotation[:, 2], self._hanging
        axis = np.cross(z, wanted)
        sine, cosine = float(np.linalg.norm(axis)), float(z @ wanted)
        if sine < 1e-9:
            return None
        turn = pin.exp3(axis / sine * math.atan2(sine, cosine))
        return self.kinematics.solve_from(pin.SE3(turn @ tool.rotation, tool.translation), posture)

    def _connect(self, start: Array, goal: Array, margin: float) -> list[Array] | None:
        trees = [_Tree(start), _Tree(goal)]
        self._hanging = self.kinematics.forward(goal).rotation[:, 2].copy()
        low = np.maximum(self._lower, np.minimum(start, goal) - 1.6)
        high = np.minimum(self._upper, np.maximum(start, goal) + 1.6)
        turn = 0
        while len(trees[0]) + len(trees[1]) < self._nodes:
            sample = self._random.uniform(low, high)
            grown = self._extend(trees[turn], sample, margin)
            if grown is not None:
                other = trees[1 - turn]
                while True:
                    met = self._extend(other, trees[turn].points[grown], margin)
                    if met is None:
                        break
                    if np.array_equal(other.points[met], trees[turn].points[grown]):
                        forward, backward = trees[turn].way(grown), other.way(met)
                        joined = forward + backward[::-1][1:]
                        return joined if turn == 0 else joined[::-1]
            else:
                trees[turn].failures += 1
                if trees[turn].failures > self._nodes:
                    return None
            turn = 1 - turn
        return None

    def _extend(self, tree: _Tree, target: Array, margin: float) -> int | None:
        near = tree.nearest(target)
        way = target - tree.points[near]
        far = float(np.max(np.abs(way)))
        if far < 1e-9:
            return near
        point = target if far <= REACH else tree.points[near] + way * (REACH / far)
        if self.load is not None and point is not target:
            held = self._as_held(point)
            if held is None or float(np.max(np.abs(held - tree.points[near]))) > 2.0 * REACH:
                return None
            if np.any(held < self._lower) or np.any(held > self._upper):
                return None
            point = held
            if float(np.max(np.abs(target - point))) > far - LEAST_PROGRESS:
                return None
        return tree.add(point, near) if self._is_free(tree.points[near], point, margin) else None

    def _shortened(self, points: list[Array], margin: float) -> list[Array]:
        for _ in range(SHORTCUTS):
            if len(points) <= 2:
                break
            i, j = sorted(self._random.choice(len(points), 2, replace=False).tolist())
            if j - i > 1 and self._is_free(points[i], points[j], margin):
                points = points[: i + 1] + points[j:]
        index = 0
        while index + 2 < len(points):
            if self._is_free(points[index], points[index + 2], margin):
                del points[index + 1]
            else:
                index += 1
        return points


class _Tree:
    """Postures, each with the one that it was reached from."""

    def __init__(self, root: Array) -> None:
        self.points = [root]
        self._parents = [-1]
        self._all = np.empty((256, len(root)))
        self._all[0] = root
        self.failures = 0

    def __len__(self) -> int:
        return len(self.points)

    def nearest(self, target: Array) -> int:
        return int(np.argmin(np.sum((self._all[: len(self.points)] - target) ** 2, axis=1)))

    def add(self, point: Array, parent: int) -> int:
        if len(self.points) == len(self._all):
            self._all = np.concatenate([self._all, np.empty_like(self._all)])
        self._all[len(self.points)] = point
        self.points.append(point)
        self._parents.append(parent)
        return len(self.points) - 1

    def way(self, index: int) -> list[Array]:
        found = []
        while index >= 0:
            found.append(self.points[index])
            index = self._parents[index]
        return found[::-1]


def duration(path: Path, speeds: Array, accelerations: Array) -> float:
    """Seconds of a path with a stop at each posture."""
    return sum(profile(a, b, speeds, accelerations).duration for a, b in pairwise(path.points))


def _named(found: Clearance) -> str:
    a, b = found.between
    return f"{a or 'the arm'} would be {1000 * found.distance:.0f} mm from {b or 'something'}"
