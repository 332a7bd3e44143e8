"""Scores of kits by the rules of ARIAC 2023, from what truly lies on a tray.

NIST, ARIAC 2023 documentation, "Scoring" (usnistgov/ARIAC, branch ariac2023). Its parts have a type and a colour. Those
of this cell have a kind, such as a tube, in place of the type, and a type, such as `tube_long`, in place of the colour.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

QUADRANT_POINTS: Final = 3
"""Points of a part without a defect; also of the right tray."""
TRAY_POINTS: Final = 3


@dataclass(frozen=True, slots=True)
class Lying:
    """A part that lies on a tray, as the simulation has it."""

    part: str
    kind: str
    type: str
    quadrant: int
    flipped: bool = False
    faulty: bool = False


@dataclass(frozen=True, slots=True)
class Wanted:
    """A part that an order wants."""

    kind: str
    type: str


@dataclass(frozen=True, slots=True)
class KitScore:
    """The points of one kit."""

    tray: int = 0
    quadrants: Mapping[int, int] = field(default_factory=dict)
    """Points by quadrant that the order names."""
    bonus: int = 0
    penalty: int = 0
    most: int = 0
    """The points of a perfect kit of this order."""
    destination: bool = True

    @property
    def total(self) -> int:
        """The score of the task, never below zero."""
        points = self.tray + sum(self.quadrants.values()) + self.bonus - self.penalty
        return max(points, 0) if self.destination else 0


def most_points(count: int) -> int:
    """The points of a perfect kit of so many parts."""
    return TRAY_POINTS + (QUADRANT_POINTS + 1) * count


def quadrant_points(wanted: Wanted, lying: Lying | None) -> int:
    """The points of one quadrant: none for a wrong kind or a faulty part; a wrong type or side costs one."""
    if lying is None or lying.kind != wanted.kind or lying.faulty:
        return 0
    return QUADRANT_POINTS - (lying.type != wanted.type) - lying.flipped


def kit_score(
    wanted: Mapping[int, Wanted], lying: Sequence[Lying], *, right_tray: bool = True, right_destination: bool = True
) -> KitScore:
    """The score of a tray for an order, by quadrant; of several parts in one quadrant, the best one counts."""
    points = {
        quadrant: max((quadrant_points(part, found) for found in lying if found.quadrant == quadrant), default=0)
        for quadrant, part in wanted.items()
    }
    count = len(wanted)
    return KitScore(
        tray=TRAY_POINTS if right_tray else 0,
        quadrants=points,
        bonus=count if sum(points.values()) == QUADRANT_POINTS * count else 0,
        penalty=max(0, len(lying) - count),
        most=most_points(count),
        destination=right_destination,
    )


def efficiency(duration: float, durations: Iterable[float]) -> float:
    """The efficiency factor of an order: the mean duration of all runs by that of this one, with a weight of one."""
    found = list(durations)
    return sum(found) / len(found) / duration if found and duration > 0.0 else 0.0


def trial_score(orders: Iterable[tuple[float, float, float]], cost_factor: float = 1.0) -> float:
    """The score of a trial: of each order its weight of priority, efficiency factor and completion score."""
    return cost_factor * sum(weight * factor * completion for weight, factor, completion in orders)
