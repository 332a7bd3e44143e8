"""The datagrams of a run that are kept for its report. Bounded, so nothing may be judged by it."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.trace import Entry

MAX_STEP: Final = 2000
"""Datagrams of one step; an honest one has some hundred."""
MAX_ENTRIES: Final = 200_000
"""Of a run, after which a step keeps less."""
MAX_LATE: Final = 100
"""Of a step then."""


class Record:
    """The first datagrams of each step; the others are counted."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self.left_out = 0
        self._first = 0
        self._left_out_before = 0

    def begin(self) -> None:
        """A new step."""
        self._first, self._left_out_before = len(self.entries), self.left_out

    def add(self, entry: Entry) -> None:
        """Keep it, if there is room."""
        room = MAX_STEP if len(self.entries) < MAX_ENTRIES else MAX_LATE
        if len(self.entries) - self._first < room:
            self.entries.append(entry)
        else:
            self.left_out += 1

    @property
    def of_step(self) -> tuple[Entry, ...]:
        """What is kept of this step."""
        return tuple(self.entries[self._first :])

    @property
    def left_out_of_step(self) -> int:
        """How many are not."""
        return self.left_out - self._left_out_before
