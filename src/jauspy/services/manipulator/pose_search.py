"""Inverse kinematics: positions of the joints that bring the tool to a pose, looked for a bit at a time.

From a start, by damped Gauss-Newton steps (Levenberg, Marquardt) within the joints' limits; when that ends beside the
pose, from other starts, which are the same for every search. An arm of fewer than six joints cannot have every
attitude: the tool point counts first, and of what is left the attitude that is nearest.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.denavit_hartenberg import Link
from jauspy.geometry.kinematics import Stance, stance, turn_between
from jauspy.geometry.least_squares import bounded
from jauspy.geometry.vectors import Transform, Vector, difference, scaled
from jauspy.services.manipulator.spread import spread

NEAR: Final = 5e-4
"""Metres from the pose at which the tool point is there."""
TURNED: Final = 2e-3
"""Radians from the pose at which the attitude is there."""
STARTS: Final = 20
"""Places from which a search sets out before it gives up."""
PLACES: Final = 8
"""Places of which the best is the next start."""
STEPS: Final = 40
"""Steps from one start."""
LONGEST: Final = 0.5
"""Radians or metres that a joint goes in one step."""
POSE: Final = (0.2, 0.01, 0.0)
"""Metres that a radian of attitude counts as: first the pose is looked for in full, and then ever more the point."""
POINT: Final = (0.0, 0.01, 0.0)
"""The same when that has led away from the point."""
SLOW: Final = 0.02
"""Part of what is left that a step must gain, or the descent has ended."""
NOTHING: Final = 1e-14
"""What is left, in square metres, when nothing is."""


@dataclass(frozen=True, slots=True)
class Found:
    """Positions of the joints, in the standard's terms, and how far from the pose they leave the tool."""

    positions: tuple[float, ...]
    distance: float
    """Metres."""
    turn: float
    """Radians."""

    @property
    def is_there(self) -> bool:
        """The tool point is at the pose."""
        return self.distance <= NEAR

    @property
    def is_exact(self) -> bool:
        """So is the attitude."""
        return self.is_there and self.turn <= TURNED

    def better(self, other: Found) -> Found:
        """Of two the one that is there, or nearer; of two that are there the one whose attitude is nearer."""
        if self.is_there and other.is_there:
            return self if self.turn < other.turn else other
        return self if self.distance < other.distance else other


class PoseSearch:
    """Looks for positions of the joints that bring the tool point, and the last joint's frame, to `goal`.

    `tool` is the tool point in the last joint's frame. `start` and `limits`, the least and greatest of each joint, are
    positions in the standard's terms. The same arguments give the same positions.
    """

    def __init__(
        self,
        links: Sequence[Link],
        tool: Vector,
        goal: Transform,
        start: Sequence[float],
        limits: Sequence[tuple[float, float]],
        *,
        starts: int = STARTS,
        weights: Sequence[Sequence[float]] = (POSE, POINT),
    ) -> None:
        self._links, self._tool, self._goal = links, tool, goal
        self._limits, self._starts, self._weights = limits, starts, weights
        begin = self._limited(start)
        self.best = Found(begin, math.inf, math.inf)
        """What was found so far."""
        self._steps = self._search(begin)

    def work(self, steps: int) -> Found | None:
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

    def _descend(self, begin: tuple[float, ...], weight: float) -> Generator[None, None, Found]:
        """Downhill from a start, as far as it goes."""
        spot, damping, ended = self._spot(begin, weight), 1e-2, False
        for _ in range(STEPS):
            yield
            after = self._step(spot, weight, damping)
            if after.cost < spot.cost:
                ended = after.cost > (1.0 - SLOW) * spot.cost or after.cost < NOTHING
                spot, damping = after, max(1e-6, 0.1 * damping)
            else:
                damping *= 10.0
                ended = damping > 1e3
            if ended:
                break
        return spot.found

    def _step(self, spot: _Spot, weight: float, damping: float) -> _Spot:
        rows = [list(row) for row in zip(*spot.stance.moving, strict=True)]
        rows += [[weight * value for value in row] for row in zip(*spot.stance.turning, strict=True)]
        limits = list(zip(spot.positions, self._limits, strict=True))
        back = [max(-LONGEST, low - position) for position, (low, _) in limits]
        ahead = [min(LONGEST, high - position) for position, (_, high) in limits]
        change = bounded(rows, spot.error, back, ahead, [damping] * len(limits))
        positions = self._limited([p + c for p, c in zip(spot.positions, change, strict=True)])
        return self._spot(positions, weight)

    def _spot(self, positions: tuple[float, ...], weight: float) -> _Spot:
        return _Spot(stance(self._links, positions, self._tool), positions, self._goal, weight)

    def _limited(self, positions: Sequence[float]) -> tuple[float, ...]:
        return tuple(min(high, max(low, p)) for p, (low, high) in zip(positions, self._limits, strict=True))

    def _place(self, number: int, weight: float) -> Generator[None, None, tuple[float, ...]]:
        """Another start: the best of some places."""
        spots = []
        for place in range((number - 1) * PLACES + 1, number * PLACES + 1):
            yield
            spots.append(self._spot(spread(place, self._limits), weight))
        return min(spots, key=lambda spot: spot.cost).positions


class _Spot:
    """Positions, and how far they are from the goal."""

    def __init__(self, stance: Stance, positions: tuple[float, ...], goal: Transform, weight: float) -> None:
        self.stance, self.positions = stance, positions
        offset = difference(goal.position, stance.tool.position)
        turn = turn_between(stance.tool.rotation, goal.rotation)
        self.error = (*offset, *scaled(turn, weight))
        self.cost = sum(value * value for value in self.error)
        self.found = Found(positions, math.hypot(*offset), math.hypot(*turn))
