"""Checks of sources: an id must keep its address, and may be limited in its rate."""

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
    """Allows `rate` events per second for each key, and `burst` at once; the least recently used keys are forgotten.

    A forgotten key starts with a full bucket, so this alone does not limit a flood of made-up keys.
    """

    def __init__(self, rate: float, burst: float, *, limit: int = MAX_TOKEN_BUCKETS) -> None:
        self._rate = rate
        self._burst = max(burst, 1.0)
        self._limit = limit
        self._buckets: OrderedDict[Hashable, tuple[float, float]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._buckets)

    def take(self, key: Hashable, now: float) -> bool:
        """Take one token of `key`; false when there is none."""
        tokens, last = self._buckets.get(key, (self._burst, now))
        tokens = min(self._burst, tokens + (now - last) * self._rate)
        granted = tokens >= 1.0
        self._buckets[key] = (tokens - granted, now)
        self._buckets.move_to_end(key)
        if len(self._buckets) > self._limit:
            self._buckets.popitem(last=False)
        return granted


MOVE_TIMEOUT: Final = 30.0
"""Seconds without a packet after which an id may have another host."""
VERIFIED_INTERVAL: Final = 1.0
"""Seconds for which a checked address needs no further check."""
_URGENT: Final = 1 << 32


@dataclass(frozen=True, slots=True)
class SourceLimits:
    """Limits of sources. `rate` is in messages per second and source, 0 for no limit; `burst` in messages."""

    check_address: bool = True
    rate: float = 0.0
    burst: float = 1000.0


class SourceChecks:
    """Checks packets by their source id, a 32-bit number."""

    def __init__(self, limits: SourceLimits | None = None) -> None:
        self._addresses = LearnedAddresses()
        self.set_limits(limits or SourceLimits())

    def set_limits(self, limits: SourceLimits) -> None:
        """Replace the limits; known addresses are kept."""
        self._limits = limits
        self._buckets = TokenBuckets(limits.rate, limits.burst)
        self.are_limited = limits.rate > 0

    def within_rate(self, id: int, priority: int, now: float) -> bool:
        """False when this source exceeds its rate; call only when `are_limited`.

        Safety-critical messages have a budget of their own.
        """
        return self._buckets.take(id | _URGENT if priority == Priority.SAFETY_CRITICAL else id, now)

    def is_verified(self, id: int, port: NetworkPort, now: float) -> bool:
        """True when this id had exactly this address a moment ago, so that there is nothing to check or learn."""
        known = self._addresses.get(id)
        return known is not None and known[0] == port and now - known[1] < VERIFIED_INTERVAL

    def forget(self, port: NetworkPort) -> None:
        """Remove the ids of an address, as when a connection was closed; they may have another from now on."""
        self._addresses.remove_port(port)

    def holder(self, id: int, now: float) -> NetworkPort | None:
        """The address that this id has until it is silent for `MOVE_TIMEOUT` seconds; None without address checks."""
        known = self._addresses.get(id) if self._limits.check_address else None
        return known[0] if known is not None and now - known[1] < MOVE_TIMEOUT else None

    def check_address(self, id: int, port: NetworkPort, now: float) -> bool:
        """False when this id was lately heard from another host or network; another port is accepted."""
        holder = self.holder(id, now)
        return holder is None or (holder.host == port.host and holder.network == port.network)

    def heard(self, id: int, port: NetworkPort, now: float) -> None:
        """Note a packet that was accepted."""
        self._addresses.set(id, port, now)
