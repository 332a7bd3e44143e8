"""What a node manager asks of whoever sends: that an id keeps its address, and its rate."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import Final

from jauspy.protocol.buckets import TokenBuckets
from jauspy.protocol.header import Priority

SILENCE: Final = 30.0
"""Seconds after which an id that was not heard may come from elsewhere."""
MAX_SOURCES: Final = 4096
_URGENT: Final = 1 << 32


@dataclass(frozen=True, slots=True)
class SourceLimits:
    """What is asked of sources. `rate` is in messages per second and source, 0 for no limit."""

    check_address: bool = True
    rate: float = 0.0
    burst: float = 1000.0


class Sources:
    """Keys are ids as 32-bit numbers."""

    def __init__(self, limits: SourceLimits | None = None) -> None:
        self._places: OrderedDict[int, tuple[tuple[str, str], float]] = OrderedDict()
        self.limit(limits or SourceLimits())

    def limit(self, limits: SourceLimits) -> None:
        """Ask something else from now on; what was heard stays known."""
        self._limits = limits
        self._buckets = TokenBuckets(limits.rate, limits.burst)

    def within_rate(self, id: int, priority: int, now: float) -> bool:
        """False when this source has sent too much. Safety-critical messages have a budget of their own."""
        if not self._limits.rate:
            return True
        return self._buckets.take(id | _URGENT if priority == Priority.SAFETY_CRITICAL else id, now)

    def is_at_home(self, id: int, host: str, network: str, now: float) -> bool:
        """False when this id was heard from another host or network lately; another port is fine."""
        if not self._limits.check_address:
            return True
        here = (host, network)
        known, heard = self._places.get(id, (here, now))
        if known != here and now - heard < SILENCE:
            return False
        self._places[id] = (here, now)
        self._places.move_to_end(id)
        if len(self._places) > MAX_SOURCES:
            self._places.popitem(last=False)
        return True
