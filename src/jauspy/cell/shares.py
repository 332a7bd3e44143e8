"""Which products of an order the second arm does: those with which a schedule is estimated to end sooner."""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.cell.schedule import Timeline

MARGIN: Final = 1.0
"""Seconds that a second arm must save by the estimate to be used."""
MAX_SHARED: Final = 8
"""Products of which all subsets are tried."""


@dataclass(frozen=True, slots=True)
class Planned:
    """An action of a schedule with the seconds that it is expected to take."""

    name: str
    duration: float
    after: tuple[str, ...] = ()
    uses: frozenset[str] = frozenset()


def estimated(actions: Sequence[Planned]) -> float:
    """Seconds until a `Schedule` with these actions would end: it starts those that were added first before others."""
    waiting, done, busy = list(actions), set[str](), set[str]()
    running: list[tuple[float, int, Planned]] = []
    now, number = 0.0, 0
    while waiting or running:
        for action in list(waiting):
            if done.issuperset(action.after) and not busy & action.uses:
                waiting.remove(action)
                busy |= action.uses
                running.append((now + action.duration, number, action))
                number += 1
        now = min(running)[0]
        for entry in [entry for entry in running if entry[0] <= now]:
            running.remove(entry)
            busy -= entry[2].uses
            done.add(entry[2].name)
    return now


class StepTimes:
    """Expected seconds of steps by kind: given ones at first, then the means of what was measured."""

    def __init__(self, given: Mapping[str, float]) -> None:
        self._given = dict(given)
        self._sums: defaultdict[str, float] = defaultdict(float)
        self._counts: Counter[str] = Counter()

    def __getitem__(self, kind: str) -> float:
        count = self._counts[kind]
        return self._sums[kind] / count if count else self._given[kind]

    def learn(self, timeline: Timeline, kinds: Mapping[str, str]) -> None:
        """Take over what the actions of a schedule took; `kinds` has the kind of each by name."""
        for entry in timeline.entries:
            self._sums[kinds[entry.action]] += entry.end - entry.start
            self._counts[kinds[entry.action]] += 1


@dataclass(frozen=True, slots=True)
class Share:
    """The products that the second arm does, and the estimates."""

    by_arm: frozenset[int]
    alone: float
    """Seconds that the first arm alone is expected to take."""
    expected: float
    """Seconds with this share."""


ALONE: Final = Share(frozenset(), 0.0, 0.0)


def best_share(
    possible: Iterable[int], plan: Callable[[frozenset[int]], Sequence[Planned]], *, margin: float = MARGIN
) -> Share:
    """The share with the shortest schedule; none for the second arm unless that saves `margin` seconds at least.

    `possible` are the numbers of the products that the second arm can do; `plan` makes a schedule of a share.
    """
    numbers = sorted(possible)[:MAX_SHARED]
    subsets = [
        frozenset(chosen) for size in range(len(numbers) + 1) for chosen in itertools.combinations(numbers, size)
    ]
    times = {subset: estimated(plan(subset)) for subset in subsets}
    alone = times[frozenset()]
    best = min(subsets, key=lambda subset: (times[subset], len(subset)))
    if alone - times[best] < margin:
        best = frozenset()
    return Share(best, alone, times[best])
