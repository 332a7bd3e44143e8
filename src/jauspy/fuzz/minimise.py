"""Fewer and plainer bytes that still show the same problem (delta debugging)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

MOST_TRIES: Final = 1500
KEPT: Final = 2
"""The message id stays."""

Shows = Callable[[bytes], bool]


def minimise(data: bytes, shows: Shows, tries: int = MOST_TRIES) -> bytes:
    """The smallest bytes that were found within so many tries; `shows` says whether bytes show the problem."""
    budget = _Budget(shows, tries)
    before = b""
    while data != before and budget.left:
        before = data
        data = _plainer(_shorter(data, budget), budget)
    return data


class _Budget:
    def __init__(self, shows: Shows, tries: int) -> None:
        self._shows = shows
        self.left = tries

    def shows(self, data: bytes) -> bool:
        """False without a try when there is none left."""
        if not self.left:
            return False
        self.left -= 1
        return self._shows(data)


def _shorter(data: bytes, budget: _Budget) -> bytes:
    """Leave out blocks, halves first, then smaller and smaller ones; the last bytes first."""
    size = max(len(data) - KEPT, 0)
    while size:
        end = len(data)
        while end > KEPT:
            start = max(end - size, KEPT)
            candidate = data[:start] + data[end:]
            if budget.shows(candidate):
                data = candidate
            end = start
        size //= 2
    return data


def _plainer(data: bytes, budget: _Budget) -> bytes:
    """Zeros, where they do as well."""
    for at in range(KEPT, len(data)):
        if data[at]:
            candidate = data[:at] + b"\0" + data[at + 1 :]
            if budget.shows(candidate):
                data = candidate
    return data
