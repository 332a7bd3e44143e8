"""What a node manager asks of whoever sends: that an id keeps its address, and its rate."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable
from dataclasses import dataclass
from typing import Final

from jauspy.protocol.address_book import LearnedAddresses
from jauspy.protocol.addressing import NetworkPort
from jauspy.protocol.header import Priority

MAX_TOKEN_BUCKETS: Final = 4096


class TokenBuckets:
    """`rate` per second for each key, and `burst` at once; the keys that were quiet longest are forgotten first.

    A forgotten key begins again with a full bucket, so a flood of made-up keys is not limited by this alone.
    """

    def __init__(self, rate: float, burst: float, *, limit: int = MAX_TOKEN_BUCKETS) -> None:
        self._rate = rate
        self._burst = max(burst, 1.0)
        self._limit = limit
        self._buckets: OrderedDict[Hashable, tuple[float, float]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._buckets)

    def take(self, key: Hashable, now: float) -> bool:
        """True when `key` may have one more now."""
        tokens, last = self._buckets.get(key, (self._burst, now))
        tokens = min(self._burst, tokens + (now - last) * self._rate)
        granted = tokens >= 1.0
        self._buckets[key] = (tokens - granted, now)
        self._buckets.move_to_end(key)
        if len(self._buckets) > self._limit:
            self._buckets.popitem(last=False)
        return granted


MOVE_TIMEOUT: Final = 30.0
"""Seconds after which an id that was not heard may come from elsewhere."""
VERIFIED_INTERVAL: Final = 1.0
"""Seconds between two notes of the same id at the same place."""
_URGENT: Final = 1 << 32


@dataclass(frozen=True, slots=True)
class SourceLimits:
    """What is asked of sources. `rate` is in messages per second and source, 0 for no limit."""

    check_address: bool = True
    rate: float = 0.0
    burst: float = 1000.0


class SourceChecks:
    """Keys are ids as 32-bit numbers."""

    def __init__(self, limits: SourceLimits | None = None) -> None:
        self._places = LearnedAddresses()
        self.limit(limits or SourceLimits())

    def limit(self, limits: SourceLimits) -> None:
        """Ask something else from now on; what was heard stays known."""
        self._limits = limits
        self._buckets = TokenBuckets(limits.rate, limits.burst)
        self.are_limited = limits.rate > 0

    def within_rate(self, id: int, priority: int, now: float) -> bool:
        """False when this source has sent too much; ask only when `are_limited`.

        Safety-critical messages have a budget of their own.
        """
        return self._buckets.take(id | _URGENT if priority == Priority.SAFETY_CRITICAL else id, now)

    def is_settled(self, id: int, port: NetworkPort, now: float) -> bool:
        """True when this id came from exactly there a moment ago: there is nothing new to check or to learn."""
        known = self._places.get(id)
        return known is not None and known[0] == port and now - known[1] < VERIFIED_INTERVAL

    def forget(self, port: NetworkPort) -> None:
        """What came from there may come from anywhere now, as when a connection was closed."""
        self._places.drop_at(port)

    def is_at_home(self, id: int, port: NetworkPort, now: float) -> bool:
        """False when this id was heard from another host or network lately; another port is fine."""
        known, heard = self._places.get(id) or (port, now)
        moved = known.host != port.host or known.network != port.network
        if moved and self._limits.check_address and now - heard < MOVE_TIMEOUT:
            return False
        self._places.note(id, port, now)
        return True
