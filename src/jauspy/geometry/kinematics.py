"""Forward and inverse kinematics of a manipulator. Positions of joints are as AS6057 counts them (`DHLink`)."""

from __future__ import annotations

import math
import operator
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, cycle
from typing import Final

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.least_squares import bounded_least_squares
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import Vector, Z, add, cross, difference, scaled

POSITION_TOLERANCE: Final = 5e-4
"""Distance of the tool point from its goal, in metres, up to which a solution reaches it."""
ATTITUDE_TOLERANCE: Final = 2e-3
"""Angle between the tool's attitude and its goal, in radians, up to which a solution reaches it."""
MAX_STARTS: Final = 20
"""Start configurations that are tried."""
SAMPLES_PER_START: Final = 8
"""Configurations that are sampled for each further start; the best is taken."""
MAX_STEPS_PER_START: Final = 40
MAX_STEP: Final = 0.5
"""Radians or metres by which one step changes a joint at most."""
POSE_WEIGHTS: Final = (0.2, 0.01, 0.0)
"""Metres that a radian of attitude error counts as, descent by descent: the full pose first, the point alone last."""
POINT_WEIGHTS: Final = (0.0, 0.01, 0.0)
"""Weights as in `POSE_WEIGHTS`, for the second try from a start: the point first."""
MIN_RELATIVE_GAIN: Final = 0.02
"""A descent ends when a step lowers the cost by less than this part."""
NEAR: Final = 0.5
"""Seconds up to which a motion to the whole pose is taken without looking for a shorter one."""
STARTS_FOR_NEARER: Final = 5
"""Further starts that are tried for a shorter motion, once the whole pose has been found."""
TRAVEL_WEIGHT: Final = 0.05
"""Radians of attitude that a second of motion counts as, if the whole pose is out of reach."""
MIN_COST: Final = 1e-14
"""A descent ends below this cost, square metres."""
HALTON_BASES: Final = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
_ZERO: Final[Vector] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class KinematicState:
    """Pose and Jacobian of the tool for some positions of the joints, in the manipulator's coordinate system."""

    tool: Transform
    """The tool point, and the attitude of the last joint's frame."""
    angular_jacobian: tuple[Vector, ...]
    """One column a joint: angular velocity of the last link for a unit of velocity of that joint."""
    linear_jacobian: tuple[Vector, ...]
    """One column a joint: linear velocity of the tool point for a unit of velocity of that joint."""

    def velocity(self, rates: Sequence[float]) -> tuple[Vector, Vector]:
        """Angular (rad/s) and linear (m/s) velocity of the tool for velocities of the joints."""
        return _weighted_sum(self.angular_jacobian, rates), _weighted_sum(self.linear_jacobian, rates)


def joint_frames(links: Sequence[DHLink], positions: Sequence[float]) -> list[Transform]:
    """The joints' frames in the manipulator's coordinate system, base to tip."""
    rows = zip(links, positions, strict=True)
    return list(accumulate((link.frame(position) for link, position in rows), operator.matmul))


def forward_kinematics(links: Sequence[DHLink], positions: Sequence[float], tool: Vector) -> KinematicState:
    """Pose and Jacobian of the tool; `tool` is the tool point in the last joint's frame, metres."""
    frames = joint_frames(links, positions)
    point = frames[-1].apply(tool)
    axes = [frame.rotate(Z) for frame in frames]
    rows = list(zip(links, frames, axes, strict=True))
    return KinematicState(
        Transform(frames[-1].rotation, point),
        tuple(axis if link.is_revolute else _ZERO for link, _, axis in rows),
        tuple(
            cross(axis, difference(point, frame.position)) if link.is_revolute else axis for link, frame, axis in rows
        ),
    )


def _weighted_sum(columns: Sequence[Vector], rates: Sequence[float]) -> Vector:
    total = _ZERO
    for column, rate in zip(columns, rates, strict=True):
        total = add(total, scaled(column, rate))
    return total


@dataclass(frozen=True, slots=True)
class Solution:
    """Positions of the joints, and the errors that remain."""

    positions: tuple[float, ...]
    distance: float
    """Metres from the goal's point to the tool point."""
    angle: float
    """Radians between the goal's attitude and the tool's."""
    travel: float = 0.0
    """Seconds that the joints need from the start of the search, each at its greatest speed."""

    @property
    def reaches_point(self) -> bool:
        """True if the tool point is at the goal, whatever the attitude."""
        return self.distance <= POSITION_TOLERANCE

    @property
    def reaches_pose(self) -> bool:
        """True if point and attitude are at the goal."""
        return self.reaches_point and self.angle <= ATTITUDE_TOLERANCE

    def better(self, other: Solution) -> Solution:
        """The solution that is to be preferred.

        Of two that reach the whole pose, the one with less travel; of two that reach the point, the one that is nearer
        to the attitude, where travel counts a little; else the one nearer to the point.
        """
        return self if self._rank() < other._rank() else other

    def _rank(self) -> tuple[int, float]:
        if self.reaches_pose:
            return 0, self.travel
        if self.reaches_point:
            return 1, self.angle + TRAVEL_WEIGHT * self.travel
        return 2, self.distance


class InverseKinematics:
    """Searches positions of the joints that bring the tool point, and the last joint's frame, to `goal`.

    Damped Gauss-Newton steps (Levenberg, Marquardt) within the joints' limits; if they end beside the goal, they are
    repeated from other start configurations. An arm of fewer than six joints cannot take every attitude: the tool point
    has priority, and the nearest attitude is taken. Most goals have several solutions, such as the elbow up or down: of
    those that are about as good, the one with the least motion from the start is taken, since a turn of the whole arm
    leads through the robot or the ground. The search is deterministic, and is done in parts, by `advance`, so that it
    does not block a component.

    `tool` is the tool point in the last joint's frame, metres; `limits` holds the lower and upper limit of each joint.
    """

    def __init__(
        self,
        links: Sequence[DHLink],
        tool: Vector,
        goal: Transform,
        start: Sequence[float],
        limits: Sequence[tuple[float, float]],
        *,
        starts: int = MAX_STARTS,
        weights: Sequence[Sequence[float]] = (POSE_WEIGHTS, POINT_WEIGHTS),
    ) -> None:
        self._links, self._tool, self._goal = links, tool, goal
        self._limits, self._starts, self._weights = limits, starts, weights
        self._speeds = [link.joint.velocity or 1.0 for link in links]
        self._first = first = self._limited(start)
        self.best = Solution(first, math.inf, math.inf)
        """The best solution so far."""
        self._steps = self._search(first)

    def advance(self, steps: int) -> Solution | None:
        """Do a number of steps. Returns the best solution when the search has ended; None until then."""
        for _ in range(steps):
            if next(self._steps, self) is self:
                return self.best
        return None

    def _search(self, first: tuple[float, ...]) -> Iterator[None]:
        last = self._starts
        for number in range(self._starts):
            if number > last:
                return
            for weights in self._weights:
                start = (yield from self._sample(number, weights[0])) if number else first
                yield from self._try(start, weights)
                if self.best.reaches_point:
                    break
            if self.best.reaches_pose:
                if self.best.travel <= NEAR:
                    return
                last = min(last, number + STARTS_FOR_NEARER)
                self._limits = self._nearer(self.best.travel)

    def _try(self, positions: tuple[float, ...], weights: Sequence[float]) -> Iterator[None]:
        """One descent for each weight of the attitude."""
        for weight in weights:
            found = yield from self._descend(positions, weight)
            positions = found.positions
            self.best = replace(found, travel=self._travel(positions)).better(self.best)
            if found.reaches_pose:
                return

    def _nearer(self, travel: float) -> list[tuple[float, float]]:
        """The limits within which each joint arrives sooner."""
        ways = [travel * speed for speed in self._speeds]
        rows = zip(self._first, self._limits, ways, strict=True)
        return [(max(low, start - way), min(high, start + way)) for start, (low, high), way in rows]

    def _travel(self, positions: Sequence[float]) -> float:
        rows = zip(positions, self._first, self._speeds, strict=True)
        return max(abs(position - start) / speed for position, start, speed in rows)

    def _descend(self, start: tuple[float, ...], weight: float) -> Generator[None, None, Solution]:
        current, damping, ended = self._candidate(start, weight), 1e-2, False
        for _ in range(MAX_STEPS_PER_START):
            yield
            after = self._step(current, weight, damping)
            if after.cost < current.cost:
                ended = after.cost > (1.0 - MIN_RELATIVE_GAIN) * current.cost or after.cost < MIN_COST
                current, damping = after, max(1e-6, 0.1 * damping)
            else:
                damping *= 10.0
                ended = damping > 1e3
            if ended:
                break
        return current.solution

    def _step(self, current: _Candidate, weight: float, damping: float) -> _Candidate:
        rows = [list(row) for row in zip(*current.state.linear_jacobian, strict=True)]
        rows += [[weight * value for value in row] for row in zip(*current.state.angular_jacobian, strict=True)]
        limits = list(zip(current.positions, self._limits, strict=True))
        lower = [max(-MAX_STEP, low - position) for position, (low, _) in limits]
        upper = [min(MAX_STEP, high - position) for position, (_, high) in limits]
        change = bounded_least_squares(rows, current.error, lower, upper, [damping] * len(limits))
        return self._candidate(self._limited([p + c for p, c in zip(current.positions, change, strict=True)]), weight)

    def _sample(self, number: int, weight: float) -> Generator[None, None, tuple[float, ...]]:
        """A further start: the best of some configurations, which are the same for every search."""
        candidates = []
        for index in range((number - 1) * SAMPLES_PER_START + 1, number * SAMPLES_PER_START + 1):
            yield
            candidates.append(self._candidate(halton_point(index, self._limits), weight))
        return min(candidates, key=lambda candidate: candidate.cost).positions

    def _candidate(self, positions: tuple[float, ...], weight: float) -> _Candidate:
        return _Candidate(forward_kinematics(self._links, positions, self._tool), positions, self._goal, weight)

    def _limited(self, positions: Sequence[float]) -> tuple[float, ...]:
        return tuple(min(high, max(low, p)) for p, (low, high) in zip(positions, self._limits, strict=True))


class _Candidate:
    """Positions, and the remaining errors of the tool."""

    def __init__(self, state: KinematicState, positions: tuple[float, ...], goal: Transform, weight: float) -> None:
        self.state, self.positions = state, positions
        offset = difference(goal.position, state.tool.position)
        turn = rotation_vector(state.tool.rotation, goal.rotation)
        self.error = (*offset, *scaled(turn, weight))
        self.cost = sum(value * value for value in self.error)
        self.solution = Solution(positions, math.hypot(*offset), math.hypot(*turn))


def halton_point(index: int, limits: Sequence[tuple[float, float]]) -> tuple[float, ...]:
    """A point of the Halton sequence, which fills the space between limits evenly; `index` counts from 1.

    For a joint without limits, it covers one turn.
    """
    rows = zip((_one_turn(*limit) for limit in limits), cycle(HALTON_BASES), strict=False)
    return tuple(low + (high - low) * _radical_inverse(index, base) for (low, high), base in rows)


def _one_turn(low: float, high: float) -> tuple[float, float]:
    return (low, high) if math.isfinite(high - low) else (-math.pi, math.pi)


def _radical_inverse(number: int, base: int) -> float:
    """The digits of a number, mirrored at the point: 0.321 for 123."""
    value, scale = 0.0, 1.0
    while number:
        scale /= base
        number, digit = divmod(number, base)
        value += digit * scale
    return value
