"""Routes of joints from where they are to a pose, on which the links keep a distance from each other.

A route consists of straight ways in the space of the joints, each from rest to rest. The search tries the direct way,
then some joints before the others, then ways by other poses, and takes the first route that is free: the same start
gives the same route. Radians and metres.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Final, TypeAlias

from jauspy.geometry.link_clearances import LinkClearances
from jauspy.geometry.link_pairs import Pair

MARGIN: Final = 0.008
"""Metres that links keep: what controllers and brakes leave of the errors of their joints, at an arm of a metre."""
STEP: Final = 0.02
"""Radians or metres that the joint with the longest way moves between two checks; a link moves about as many metres."""
COARSE_STEP: Final = 0.06
"""The same for checks of a route again, while it is carried out."""
ROUNDING: Final = 0.001
"""Metres by which links that begin nearer than `MARGIN` may seem to come nearer, by noise of encoders."""
MAX_CHECKS: Final = 4000
"""Positions that a search checks before it is given up."""

Positions: TypeAlias = tuple[float, ...]
Route: TypeAlias = tuple[Positions, ...]
"""The positions at which the joints rest on the way, the goal last."""


class ReachablePositions:
    """The positions of some joints that keep the distance, while all others stay where they are.

    Links that are nearer than `MARGIN` at the start may stay as near, but come no nearer.
    """

    def __init__(
        self, clearances: LinkClearances, joints: Sequence[str], start: Positions, others: Mapping[str, float]
    ) -> None:
        self._clearances, self._joints, self._others = clearances, joints, others
        near = clearances.at(self._all(start), MARGIN + ROUNDING)
        self._least = {pair: min(MARGIN, clearance - ROUNDING) for pair, clearance in near.items()}

    def obstacle(self, positions: Positions) -> Pair | None:
        """Two links that are too near to each other; None if the positions are free."""
        found = self._clearances.at(self._all(positions), MARGIN)
        return next((pair for pair, clearance in found.items() if clearance < self._least.get(pair, MARGIN)), None)

    def obstacle_on(self, start: Positions, route: Route, step: float = COARSE_STEP) -> Pair | None:
        """Two links that come too near on a route; None if it is free."""
        legs = itertools.pairwise((start, *route))
        checks = itertools.chain.from_iterable(positions_between(one, other, step) for one, other in legs)
        return next((pair for positions in checks if (pair := self.obstacle(positions)) is not None), None)

    def _all(self, positions: Positions) -> dict[str, float]:
        return {**self._others, **dict(zip(self._joints, positions, strict=True))}


def positions_between(start: Positions, end: Positions, step: float) -> Iterator[Positions]:
    """The positions on a straight way after its start, the end last."""
    ways = [b - a for a, b in zip(start, end, strict=True)]
    count = max(1, math.ceil(max(map(abs, ways)) / step))
    for number in range(1, count):
        yield tuple(a + way * number / count for a, way in zip(start, ways, strict=True))
    yield end


class RouteSearch:
    """A search that goes on in parts, so that the caller can do other work between them.

    `by`: further poses, which a route may lead through.
    """

    def __init__(
        self, reachable: ReachablePositions, start: Positions, goal: Positions, by: Sequence[Positions] = ()
    ) -> None:
        self.route: Route | None = None
        """The route, once one is found."""
        self.obstacle: Pair | None = None
        """Two links that come too near on the direct way."""
        self.is_finished = False
        """True when there is a route, or none was found."""
        self._reachable, self._start, self._goal, self._by = reachable, start, goal, by
        self._free_legs: dict[tuple[Positions, Positions], bool] = {}
        self._checks = 0
        self._search = self._run()

    def advance(self, checks: int) -> None:
        """Check up to so many positions."""
        for _ in range(checks):
            if self._checks >= MAX_CHECKS or next(self._search, True):
                self.is_finished = True
                return
            self._checks += 1

    def _run(self) -> Iterator[None]:
        for route in self._candidates():
            legs = list(itertools.pairwise((self._start, *route)))
            for leg in legs:
                if leg not in self._free_legs:
                    yield from self._check(leg)
                if not self._free_legs[leg]:
                    break
            else:
                self.route = route
                return

    def _check(self, leg: tuple[Positions, Positions]) -> Iterator[None]:
        self._free_legs[leg] = False
        for positions in positions_between(*leg, STEP):
            yield
            if (pair := self._reachable.obstacle(positions)) is not None:
                self.obstacle = self.obstacle or pair
                return
        self._free_legs[leg] = True

    def _candidates(self) -> Iterator[Route]:
        start, goal = self._start, self._goal
        yield (goal,)
        between = list(_some_joints_first(start, goal))
        yield from ((middle, goal) for middle in between)
        for pose in self._by:
            yield pose, goal
        for pose in self._by:
            yield from ((middle, pose, goal) for middle in _some_joints_first(start, pose))
            yield from ((pose, middle, goal) for middle in _some_joints_first(pose, goal))


def _some_joints_first(start: Positions, goal: Positions) -> Iterator[Positions]:
    """Positions at which some joints are at the goal already and the others still at the start; few joints first."""
    moving = [number for number, (a, b) in enumerate(zip(start, goal, strict=True)) if a != b]
    for count in range(1, len(moving)):
        for first in itertools.combinations(moving, count):
            yield tuple(b if number in first else a for number, (a, b) in enumerate(zip(start, goal, strict=True)))
