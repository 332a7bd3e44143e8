"""Messages for destinations nobody has heard of yet: asked for by multicast, at a bounded rate, while others wait.

The first message for an unknown id goes to the multicast group with the ACK bit set; the answer tells the address.
Until then later messages wait; once a second the oldest of them asks again.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Final

from jauspy.protocol.counters import Counters

PROBE_INTERVAL: Final = 1.0
"""Seconds between two multicasts for the same unknown destination."""
PENDING_TIMEOUT: Final = 3.0
"""Seconds a message may wait for its destination."""
MAX_PENDING_DESTINATIONS: Final = 256
MAX_PENDING_PER_DESTINATION: Final = 32
"""Messages that wait for one destination; the oldest is dropped first."""
MAX_PENDING_BYTES: Final = 1 << 20
"""Bytes that wait in all; what does not fit is dropped."""


@dataclass(slots=True)
class _Search:
    next_probe: float
    messages: deque[tuple[float, bytes]] = field(default_factory=deque)


class PendingDestinations:
    """Sans-I/O; keys are ids as 32-bit numbers. What is to be multicast is returned, never sent."""

    def __init__(self, counters: Counters) -> None:
        self._counters = counters
        self._searches: dict[int, _Search] = {}
        self._bytes = 0

    def __len__(self) -> int:
        return sum(len(search.messages) for search in self._searches.values())

    def add(self, destination: int, datagram: bytes, now: float) -> bytes | None:
        """Take a message for an unknown destination; returns it when it is to be multicast at once."""
        search = self._searches.get(destination)
        if search is None:
            if len(self._searches) >= MAX_PENDING_DESTINATIONS:
                self._counters.drop("too_many_unknown_destinations", destination)
                return None
            self._searches[destination] = _Search(now + PROBE_INTERVAL)
            return datagram
        if not search.messages and now >= search.next_probe:
            search.next_probe = now + PROBE_INTERVAL
            return datagram
        if self._bytes + len(datagram) > MAX_PENDING_BYTES:
            self._counters.drop("unknown_destination", "too many bytes wait")
            return None
        if len(search.messages) >= MAX_PENDING_PER_DESTINATION:
            self._take(search)
            self._counters.drop("unknown_destination", "too many messages wait")
        search.messages.append((now, datagram))
        self._bytes += len(datagram)
        return None

    def found(self, destination: int) -> list[bytes]:
        """All that waits for a destination that has just been heard."""
        search = self._searches.pop(destination, None)
        return [self._take(search) for _ in range(len(search.messages))] if search else []

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called, or None."""
        return min((search.next_probe for search in self._searches.values()), default=None)

    def handle_timeout(self, now: float) -> list[bytes]:
        """Drop what waited too long; returns the messages that ask again by multicast."""
        probes = []
        for destination, search in list(self._searches.items()):
            if now < search.next_probe:
                continue
            while search.messages and now - search.messages[0][0] >= PENDING_TIMEOUT:
                self._take(search)
                self._counters.drop("unknown_destination", "nobody answered")
            if search.messages:
                probes.append(self._take(search))
                search.next_probe = now + PROBE_INTERVAL
            else:
                del self._searches[destination]
        return probes

    def _take(self, search: _Search) -> bytes:
        _, datagram = search.messages.popleft()
        self._bytes -= len(datagram)
        return datagram
