"""One event for each robot found or lost: sums up what `watch` learns of components one by one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.ocu.subsystems import INTRODUCTION_TIME, SubsystemInfo

QUIET_TIME: Final = 0.3
"""Seconds without a new fact after which a robot that is complete is told of."""
MAX_INTRODUCTION: Final = 2.0 * INTRODUCTION_TIME
"""Seconds after which a robot is told of that is not complete."""


@dataclass(frozen=True, slots=True)
class Difference:
    """A robot before and now; None when it was not, or is not, there."""

    before: SubsystemInfo | None
    now: SubsystemInfo | None


@dataclass(slots=True)
class _Pending:
    """A difference that is not told yet: how the robot is now, since when, and when it can be told."""

    now: SubsystemInfo | None
    first: float
    """When the robot began to differ."""
    since: float
    due: float


class RobotNews:
    """Compares what is known of robots with what was told. Times are seconds of a monotonic clock.

    The components of a robot that is switched off fall silent one after the other, up to `patience` seconds apart, so
    that a robot with fewer components is told of when nothing more is lost for as long.
    """

    def __init__(self, patience: float) -> None:
        self._patience = patience
        self._told: dict[int, SubsystemInfo] = {}
        self._pending: dict[int, _Pending] = {}

    def update(
        self, robots: tuple[SubsystemInfo, ...], is_complete: Callable[[int], bool], now: float
    ) -> Iterator[Difference]:
        """What can be told now."""
        current = {each.id: each for each in robots}
        for id in sorted(self._told.keys() | current.keys()):
            before, found = self._told.get(id), current.get(id)
            if found == before:
                self._pending.pop(id, None)
            elif self._is_settled(id, found, is_complete(id), now):
                del self._pending[id]
                if found is None:
                    del self._told[id]
                else:
                    self._told[id] = found
                yield Difference(before, found)

    def next_at(self) -> float | None:
        """When to call `update` again; None when nothing is pending."""
        return min((each.due for each in self._pending.values()), default=None)

    def _is_settled(self, id: int, found: SubsystemInfo | None, complete: bool, now: float) -> bool:
        pending = self._pending.setdefault(id, _Pending(found, now, now, now))
        if pending.now != found:
            pending.now, pending.since = found, now
        if not complete and found is not None and id not in self._told:
            pending.due = pending.first + MAX_INTRODUCTION
        else:
            pending.due = pending.since + self._wait(id, found)
        return now >= pending.due

    def _wait(self, id: int, found: SubsystemInfo | None) -> float:
        """Seconds that a difference must last."""
        before = self._told.get(id)
        if found is None:
            return 0.0
        if before is None or {each.id for each in before.components} <= {each.id for each in found.components}:
            return QUIET_TIME
        return self._patience
