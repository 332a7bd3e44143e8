"""Which packets were seen before, without ever mistaking a restarted peer's first messages for old ones.

Sequence numbers alone do not tell: many components start at 1 each time. A packet is a duplicate when number and bytes
are the same and it comes within the time in which its sender, or the network, repeats packets. A known number with
other bytes is a restart: what was remembered of that source is forgotten.
"""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MAX_SOURCES: Final = 256
MAX_NUMBERS_PER_SOURCE: Final = 1024
"""Packets to remember of one source."""
ECHO_WINDOW: Final = 0.05
"""Seconds in which the network may double a packet that nobody resends: two interfaces, or a faulty node manager."""


class Duplicates:
    """Remembers packets by source, number and hash of their bytes. `memory` is in seconds, for packets with resends."""

    def __init__(self, memory: float) -> None:
        self._memory = memory
        self._sources: OrderedDict[int, OrderedDict[int, tuple[int, float]]] = OrderedDict()

    def seen(self, source: int, sequence: int, content: int, now: float, *, resent: bool) -> bool:
        """True when this packet was there before. `resent`: its sender repeats it until it is acknowledged."""
        numbers = self._sources.get(source)
        known = numbers.get(sequence) if numbers is not None else None
        if known is None:
            return False
        old, at = known
        if old == content:
            return now - at <= (self._memory if resent else ECHO_WINDOW)
        del self._sources[source]
        return False

    def add(self, source: int, sequence: int, content: int, now: float) -> None:
        """Remember a packet that was taken."""
        numbers = self._sources.get(source)
        if numbers is None:
            numbers = self._sources[source] = OrderedDict()
            if len(self._sources) > MAX_SOURCES:
                self._sources.popitem(last=False)
        self._sources.move_to_end(source)
        numbers[sequence] = (content, now)
        numbers.move_to_end(sequence)
        if len(numbers) > MAX_NUMBERS_PER_SOURCE:
            numbers.popitem(last=False)


MAX_ECHOES: Final = 1024
"""Datagrams to remember."""
ECHO_LIFETIME: Final = 2.0
"""Seconds; a copy comes back within a few turns of the event loop, and a peer may say the same again later."""


class MulticastEchoes:
    """Remembers datagrams by their hash and the network they are not to be taken from, the newest `limit` of them."""

    def __init__(self, limit: int = MAX_ECHOES) -> None:
        self._until: OrderedDict[tuple[int, str], float] = OrderedDict()
        self._limit = limit

    def heard(self, datagram: bytes, network: str, now: float) -> bool:
        """True when this network has brought back what was remembered for it."""
        return bool(self._until) and self._until.get((hash(datagram), network), now) > now

    def add(self, datagram: bytes, network: str, now: float) -> None:
        """Remember one; several copies may come back, one per interface."""
        key = (hash(datagram), network)
        self._until[key] = now + ECHO_LIFETIME
        self._until.move_to_end(key)
        if len(self._until) > self._limit:
            self._until.popitem(last=False)
