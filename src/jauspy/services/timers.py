"""Named timers on a clock that is passed in."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Hashable
from itertools import count
from typing import Final, TypeAlias

Due: TypeAlias = tuple[float, int, Hashable]
"""A deadline, a serial number and the key."""

_MAX_STALE: Final = 64
"""Cancelled entries that the heap may have beyond the number of active timers."""


class Timers:
    """Each key has at most one deadline; setting it again moves it."""

    def __init__(self) -> None:
        self._active: dict[Hashable, tuple[int, Callable[[], None]]] = {}
        self._heap: list[Due] = []
        self._serial = count()

    def __len__(self) -> int:
        return len(self._active)

    def set(self, key: Hashable, at: float, call: Callable[[], None]) -> None:
        """Call `call` once, at time `at` (seconds)."""
        serial = next(self._serial)
        self._active[key] = (serial, call)
        heapq.heappush(self._heap, (at, serial, key))
        if len(self._heap) > 2 * len(self._active) + _MAX_STALE:
            self._compact()

    def cancel(self, key: Hashable) -> None:
        """Cancel the timer, if it is set."""
        self._active.pop(key, None)

    def next(self) -> float | None:
        """The earliest deadline, or None."""
        while self._heap and self._stale(self._heap[0]):
            heapq.heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def due(self, now: float, limit: int | None = None) -> list[Due]:
        """Timers that are due, earliest first. `take` each: an earlier one may cancel or move a later one."""
        found: list[Due] = []
        while self._heap and self._heap[0][0] <= now and (limit is None or len(found) < limit):
            entry = heapq.heappop(self._heap)
            if not self._stale(entry):
                found.append(entry)
        return found

    def take(self, due: Due) -> Callable[[], None] | None:
        """Remove a due timer and return its callback; None when it was cancelled or moved meanwhile."""
        return None if self._stale(due) else self._active.pop(due[2])[1]

    def _stale(self, entry: Due) -> bool:
        active = self._active.get(entry[2])
        return active is None or active[0] != entry[1]

    def _compact(self) -> None:
        self._heap = [entry for entry in self._heap if not self._stale(entry)]
        heapq.heapify(self._heap)
