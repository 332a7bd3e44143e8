"""Packets that arrive twice: duplicates at a component, and multicasts that come back to their node manager.

Sequence numbers alone do not identify a duplicate, because many components start at 1 each time. A packet is a
duplicate when its number and bytes are known and it arrives within the time in which its sender, or the network,
repeats packets. A known number with other bytes is a restart: all packets of that source are forgotten.
"""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MAX_SOURCES: Final = 256
MAX_NUMBERS_PER_SOURCE: Final = 1024
"""Packets remembered of one source."""
ECHO_WINDOW: Final = 0.05
"""Seconds in which the network may duplicate a packet: two interfaces, or a faulty node manager."""
MAX_ECHOES: Final = 1024
"""Multicasts remembered."""
ECHO_LIFETIME: Final = 2.0
"""Seconds; a copy comes back within a few turns of the event loop, and a peer may send the same bytes again later."""
REPLAY_WINDOW: Final = 64
"""Numbers by which an authenticated one may be overtaken."""


class Duplicates:
    """Remembers packets by source, number and hash of their bytes, those with resends for `resend_period` seconds."""

    def __init__(self, resend_period: float) -> None:
        self._resend_period = resend_period
        self._sources: OrderedDict[int, OrderedDict[int, tuple[int, float]]] = OrderedDict()

    def seen(self, source: int, sequence: int, content: int, now: float, *, resent: bool) -> bool:
        """True for a duplicate. `resent`: its sender resends it until it is acknowledged."""
        numbers = self._sources.get(source)
        known = numbers.get(sequence) if numbers is not None else None
        if known is None:
            return False
        old, seen_at = known
        if old == content:
            return now - seen_at <= (self._resend_period if resent else ECHO_WINDOW)
        del self._sources[source]
        return False

    def add(self, source: int, sequence: int, content: int, now: float) -> None:
        """Remember a packet that was accepted."""
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


class MulticastEchoes:
    """Remembers the newest `limit` multicasts by hash and network, to recognize them when the network returns them."""

    def __init__(self, limit: int = MAX_ECHOES) -> None:
        self._until: OrderedDict[tuple[int, str], float] = OrderedDict()
        self._limit = limit

    def seen(self, datagram: bytes, network: str, now: float) -> bool:
        """True for a multicast that this network has returned."""
        return bool(self._until) and self._until.get((hash(datagram), network), now) > now

    def add(self, datagram: bytes, network: str, now: float) -> None:
        """Remember a multicast; several copies may come back, one per interface."""
        key = (hash(datagram), network)
        self._until[key] = now + ECHO_LIFETIME
        self._until.move_to_end(key)
        if len(self._until) > self._limit:
            self._until.popitem(last=False)


class ReplayWindow:
    """The numbers that one sender has used, to recognise replays; a bit for each of the last `REPLAY_WINDOW`.

    Numbers up to `used` count as used.
    """

    __slots__ = ("_seen", "_top")

    def __init__(self, used: int = 0) -> None:
        self._top = used
        self._seen = (1 << REPLAY_WINDOW) - 1 if used else 0

    def is_new(self, number: int) -> bool:
        """False when the number is known or too old."""
        behind = self._top - number
        return behind < 0 or (behind < REPLAY_WINDOW and not self._seen >> behind & 1)

    def add(self, number: int) -> None:
        """Remember a number that is new."""
        if number > self._top:
            self._seen = (self._seen << min(number - self._top, REPLAY_WINDOW) | 1) & ((1 << REPLAY_WINDOW) - 1)
            self._top = number
        else:
            self._seen |= 1 << (self._top - number)
