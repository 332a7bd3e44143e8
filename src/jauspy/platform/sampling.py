"""When something that happens so many times a second is due."""

from __future__ import annotations

from typing import Final

EARLY: Final = 1e-6
"""Seconds by which it may be early: sums of steps are not exact."""


class Sampling:
    """Due at once, and then `rate` times a second; after a pause it does not catch up."""

    def __init__(self, rate: float) -> None:
        self.rate = rate
        """Hertz, more than 0; counts from the next time on."""
        self._due = 0.0

    def restart(self, now: float) -> None:
        """Due at once."""
        self._due = now

    def is_due(self, now: float) -> bool:
        """True once for each time; `now` in seconds, never earlier than in the call before."""
        if now < self._due - EARLY:
            return False
        period = 1.0 / self.rate
        self._due = self._due + period if self._due + period > now else now + period
        return True
