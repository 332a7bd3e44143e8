"""Messages for destinations whose address is unknown: probed by multicast at a limited rate, while messages wait.

The first message for an unknown id is sent to the multicast group with an ACK requested; the ACK reveals the address.
Later messages wait until then; once a second the oldest of them is multicast as the next probe.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, field
from typing import Final

from jauspy.protocol import judp
from jauspy.protocol.counters import Counters

PROBE_INTERVAL: Final = 1.0
"""Seconds between two multicasts for the same unknown destination."""
PENDING_TIMEOUT: Final = 3.0
"""Seconds that a message may wait for its destination."""
MAX_PENDING_DESTINATIONS: Final = 256
MAX_RELAYED_DESTINATIONS: Final = 128
"""Destinations among these for messages that a gateway relays, so that no host uses up the room of the components."""
MAX_PENDING_PER_DESTINATION: Final = 32
"""Messages that wait for one destination; the oldest is dropped first."""
MAX_PENDING_BYTES: Final = 1 << 20
"""Bytes of all waiting messages; a message beyond that is dropped."""


@dataclass(slots=True)
class _Pending:
    next_probe: float
    relayed: bool
    messages: deque[tuple[float, bytes]] = field(default_factory=deque)


class PendingDestinations:
    """Sans-I/O; ids are 32-bit numbers. Probes are returned for the caller to multicast.

    Messages that have waited for more than `max_age` seconds are dropped, unless they are acknowledged.
    """

    def __init__(self, counters: Counters, max_age: float = math.inf) -> None:
        self._counters = counters
        self._max_age = max_age
        self._pending: dict[int, _Pending] = {}
        self._bytes = 0

    def __len__(self) -> int:
        """The number of waiting messages."""
        return sum(len(pending.messages) for pending in self._pending.values())

    def add(self, destination: int, datagram: bytes, now: float, *, relayed: bool = False) -> bytes | None:
        """Take a message for an unknown destination; returned if it is to be multicast immediately as a probe.

        `relayed`: it came from a network.
        """
        pending = self._pending.get(destination)
        if pending is None:
            if self._is_full(relayed=relayed):
                self._counters.drop("too_many_unknown_destinations", destination)
                return None
            self._pending[destination] = _Pending(now + PROBE_INTERVAL, relayed)
            return datagram
        if not pending.messages and now >= pending.next_probe:
            pending.next_probe = now + PROBE_INTERVAL
            return datagram
        if self._bytes + len(datagram) > MAX_PENDING_BYTES:
            self._counters.drop("unknown_destination", "too many bytes wait")
            return None
        if len(pending.messages) >= MAX_PENDING_PER_DESTINATION:
            self._take(pending)
            self._counters.drop("unknown_destination", "too many messages wait")
        pending.messages.append((now, datagram))
        self._bytes += len(datagram)
        return None

    def _is_full(self, *, relayed: bool) -> bool:
        if len(self._pending) >= MAX_PENDING_DESTINATIONS:
            return True
        return relayed and sum(queue.relayed for queue in self._pending.values()) >= MAX_RELAYED_DESTINATIONS

    def pop(self, destination: int, now: float) -> list[bytes]:
        """Remove and return all messages for a destination whose address is now known."""
        pending = self._pending.pop(destination, None)
        if pending is None:
            return []
        self._drop_stale(pending, now)
        return [self._take(pending) for _ in range(len(pending.messages))]

    def next_timeout(self) -> float | None:
        """Time at which `handle_timeout` is to be called, or None."""
        return min((pending.next_probe for pending in self._pending.values()), default=None)

    def handle_timeout(self, now: float) -> list[bytes]:
        """Drop expired messages; returns the probes to multicast."""
        probes = []
        for destination, pending in list(self._pending.items()):
            if now < pending.next_probe:
                continue
            while pending.messages and now - pending.messages[0][0] >= PENDING_TIMEOUT:
                self._take(pending)
                self._counters.drop("unknown_destination", "nobody answered")
            self._drop_stale(pending, now)
            if pending.messages:
                probes.append(self._take(pending))
                pending.next_probe = now + PROBE_INTERVAL
            else:
                del self._pending[destination]
        return probes

    def _drop_stale(self, pending: _Pending, now: float) -> None:
        for _ in range(len(pending.messages)):
            since, datagram = pending.messages[0]
            self._take(pending)
            if now - since <= self._max_age or judp.may_be_late(datagram):
                pending.messages.append((since, datagram))
                self._bytes += len(datagram)
            else:
                self._counters.drop("stale", "its destination was unknown")

    def _take(self, pending: _Pending) -> bytes:
        _, datagram = pending.messages.popleft()
        self._bytes -= len(datagram)
        return datagram
