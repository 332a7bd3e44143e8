"""The sequence numbers of an event's reports: what is missing, and what is only late."""

from __future__ import annotations

from typing import Final

MAX_DELAY: Final = 2.0
"""Seconds after which no report is taken for one that others have overtaken, whatever its number."""
_HALF: Final = 0x80


class SequenceTracker:
    """Numbers go from 0 to 255 and begin anew, so of a gap any multiple of 256 is not seen."""

    def __init__(self) -> None:
        self._next: int | None = None
        self._at = 0.0

    def missing(self, number: int, rate: float, now: float) -> int | None:
        """How many are missing before this one; None when it is older than the one before: late, or double.

        At `rate` (Hz, 0 when it is not known) half of all numbers take a while; after such a silence they are lost.
        """
        gap = 0 if self._next is None else number - self._next & 0xFF
        if gap >= _HALF and now - self._at < (min(MAX_DELAY, _HALF / rate) if rate else MAX_DELAY):
            return None
        self._next, self._at = number + 1 & 0xFF, now
        return gap
