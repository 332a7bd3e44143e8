"""How the joints move the tool: its pose for positions of the joints, and what each joint adds to its velocity."""

from __future__ import annotations

import math
import operator
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate, cycle
from typing import Final

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.least_squares import bounded_least_squares
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Rotation, Vector, Z, add, cross, difference, quaternion, scaled, transposed

_ZERO: Final[Vector] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class KinematicState:
    """The tool for some positions of the joints, in the manipulator's coordinate system."""

    tool: Transform
    """The tool point, and the attitude of the last joint's frame."""
    turning: tuple[Vector, ...]
    """Angular velocity of the last link for a unit of velocity of each joint."""
    moving: tuple[Vector, ...]
    """Linear velocity of the tool point for a unit of velocity of each joint."""

    def velocity(self, rates: Sequence[float]) -> tuple[Vector, Vector]:
        """Angular and linear velocity of the tool for velocities of the joints."""
        return _weighted_sum(self.turning, rates), _weighted_sum(self.moving, rates)


def joint_frames(links: Sequence[DHLink], positions: Sequence[float]) -> list[Transform]:
    """The joints' frames in the manipulator's coordinate system, base to tip; positions in the standard's terms."""
    rows = zip(links, positions, strict=True)
    return list(accumulate((link.frame(position) for link, position in rows), operator.matmul))


def forward_kinematics(links: Sequence[DHLink], positions: Sequence[float], tool: Vector) -> KinematicState:
    """The tool for these positions; `tool` is the tool point in the last joint's frame, metres."""
    found = joint_frames(links, positions)
    point = found[-1].apply(tool)
    axes = [frame.turn(Z) for frame in found]
    rows = list(zip(links, found, axes, strict=True))
    return KinematicState(
        Transform(found[-1].rotation, point),
        tuple(axis if link.is_revolute else _ZERO for link, _, axis in rows),
        tuple(
            cross(axis, difference(point, frame.position)) if link.is_revolute else axis for link, frame, axis in rows
        ),
    )


def rotation_vector(start: Rotation, end: Rotation) -> Vector:
    """The axis about which one attitude is turned to get another, as long as the angle in radians."""
    d, *vector = quaternion((Transform(end) @ Transform(transposed(start))).rotation)
    sine = math.hypot(*vector)
    factor = 2.0 * math.atan2(sine, d) / sine if sine else 2.0
    a, b, c = vector
    return a * factor, b * factor, c * factor


def _weighted_sum(columns: Sequence[Vector], rates: Sequence[float]) -> Vector:
    total = _ZERO
    for column, rate in zip(columns, rates, strict=True):
        total = add(total, scaled(column, rate))
    return total


HALTON_BASES: Final = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
"""The base of each joint's numbers."""


def halton_point(number: int, limits: Sequence[tuple[float, float]]) -> tuple[float, ...]:
    """The place of this number, from 1 on."""
    rows = zip(limits, cycle(HALTON_BASES), strict=False)
    return tuple(low + (high - low) * _radical_inverse(number, prime) for (low, high), prime in rows)


def _radical_inverse(number: int, base: int) -> float:
    """The digits of a number behind the point, in reverse."""
    value, scale = 0.0, 1.0
    while number:
        scale /= base
        number, digit = divmod(number, base)
        value += digit * scale
    return value


POSITION_TOLERANCE: Final = 5e-4
"""Metres from the pose at which the tool point is there."""
ATTITUDE_TOLERANCE: Final = 2e-3
"""Radians from the pose at which the attitude is there."""
MAX_STARTS: Final = 20
"""Places from which a search sets out before it gives up."""
SAMPLES_PER_START: Final = 8
"""Places of which the best is the next start."""
MAX_STEPS_PER_START: Final = 40
"""Steps from one start."""
MAX_STEP: Final = 0.5
"""Radians or metres that a joint goes in one step."""
POSE_WEIGHTS: Final = (0.2, 0.01, 0.0)
"""Metres that a radian of attitude counts as: first the pose is looked for in full, and then ever more the point."""
POINT_WEIGHTS: Final = (0.0, 0.01, 0.0)
"""The same when that has led away from the point."""
MIN_RELATIVE_GAIN: Final = 0.02
"""Part of what is left that a step must gain, or the descent has ended."""
MIN_COST: Final = 1e-14
"""What is left, in square metres, when nothing is."""


@dataclass(frozen=True, slots=True)
class Solution:
    """Positions of the joints, in the standard's terms, and how far from the pose they leave the tool."""

    positions: tuple[float, ...]
    distance: float
    """Metres."""
    turn: float
    """Radians."""

    @property
    def is_there(self) -> bool:
        """The tool point is at the pose."""
        return self.distance <= POSITION_TOLERANCE

    @property
    def is_exact(self) -> bool:
        """So is the attitude."""
        return self.is_there and self.turn <= ATTITUDE_TOLERANCE

    def better(self, other: Solution) -> Solution:
        """Of two the one that is there, or nearer; of two that are there the one whose attitude is nearer."""
        if self.is_there and other.is_there:
            return self if self.turn < other.turn else other
        return self if self.distance < other.distance else other


class InverseKinematics:
    """Looks for positions of the joints that bring the tool point, and the last joint's frame, to `goal`.

    `tool` is the tool point in the last joint's frame. `start` and `limits`, the least and greatest of each joint, are
    positions in the standard's terms. The same arguments give the same positions.
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
        begin = self._limited(start)
        self.best = Solution(begin, math.inf, math.inf)
        """What was found so far."""
        self._steps = self._search(begin)

    def work(self, steps: int) -> Solution | None:
        """Go on for so many steps; what was found when the search has ended, which may not be there."""
        for _ in range(steps):
            if next(self._steps, self) is self:
                return self.best
        return None

    def _search(self, start: tuple[float, ...]) -> Iterator[None]:
        for number in range(self._starts):
            for weights in self._weights:
                begin = (yield from self._place(number, weights[0])) if number else start
                yield from self._try(begin, weights)
                if self.best.is_exact:
                    return
                if self.best.is_there:
                    break

    def _try(self, positions: tuple[float, ...], weights: Sequence[float]) -> Iterator[None]:
        """From a start, with one weight of the attitude after the other."""
        for weight in weights:
            found = yield from self._descend(positions, weight)
            self.best, positions = found.better(self.best), found.positions
            if found.is_exact:
                return

    def _descend(self, begin: tuple[float, ...], weight: float) -> Generator[None, None, Solution]:
        """Downhill from a start, as far as it goes."""
        spot, damping, ended = self._spot(begin, weight), 1e-2, False
        for _ in range(MAX_STEPS_PER_START):
            yield
            after = self._step(spot, weight, damping)
            if after.cost < spot.cost:
                ended = after.cost > (1.0 - MIN_RELATIVE_GAIN) * spot.cost or after.cost < MIN_COST
                spot, damping = after, max(1e-6, 0.1 * damping)
            else:
                damping *= 10.0
                ended = damping > 1e3
            if ended:
                break
        return spot.found

    def _step(self, spot: _Candidate, weight: float, damping: float) -> _Candidate:
        rows = [list(row) for row in zip(*spot.stance.moving, strict=True)]
        rows += [[weight * value for value in row] for row in zip(*spot.stance.turning, strict=True)]
        limits = list(zip(spot.positions, self._limits, strict=True))
        back = [max(-MAX_STEP, low - position) for position, (low, _) in limits]
        ahead = [min(MAX_STEP, high - position) for position, (_, high) in limits]
        change = bounded_least_squares(rows, spot.error, back, ahead, [damping] * len(limits))
        positions = self._limited([p + c for p, c in zip(spot.positions, change, strict=True)])
        return self._spot(positions, weight)

    def _spot(self, positions: tuple[float, ...], weight: float) -> _Candidate:
        return _Candidate(forward_kinematics(self._links, positions, self._tool), positions, self._goal, weight)

    def _limited(self, positions: Sequence[float]) -> tuple[float, ...]:
        return tuple(min(high, max(low, p)) for p, (low, high) in zip(positions, self._limits, strict=True))

    def _place(self, number: int, weight: float) -> Generator[None, None, tuple[float, ...]]:
        """Another start: the best of some places."""
        spots = []
        for place in range((number - 1) * SAMPLES_PER_START + 1, number * SAMPLES_PER_START + 1):
            yield
            spots.append(self._spot(halton_point(place, self._limits), weight))
        return min(spots, key=lambda spot: spot.cost).positions


class _Candidate:
    """Positions, and how far they are from the goal."""

    def __init__(
        self, forward_kinematics: KinematicState, positions: tuple[float, ...], goal: Transform, weight: float
    ) -> None:
        self.stance, self.positions = forward_kinematics, positions
        offset = difference(goal.position, forward_kinematics.tool.position)
        turn = rotation_vector(forward_kinematics.tool.rotation, goal.rotation)
        self.error = (*offset, *scaled(turn, weight))
        self.cost = sum(value * value for value in self.error)
        self.found = Solution(positions, math.hypot(*offset), math.hypot(*turn))
