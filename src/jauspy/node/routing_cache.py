"""Routing cache: plain packets between two ids are usually sent where the last one was, without asking the router."""

from __future__ import annotations

import asyncio
import struct
from collections.abc import Callable
from typing import Final, TypeAlias

from jauspy.protocol import header
from jauspy.protocol.addressing import LocalPort, Port, UdpPort
from jauspy.protocol.egress import ROUTED_COUNTERS
from jauspy.protocol.routing import RECEIVED_COUNTERS, Router

CACHE_LIFETIME: Final = 0.5
"""Seconds after which the cache is cleared, so that what the router learns from packets is at most this much late."""
MAX_ROUTES: Final = 1024

_BROADCAST: Final = 0x0C
"""The bits of the control byte with the broadcast flag."""
_GLOBAL: Final = header.Broadcast.GLOBAL << 2
_IDS: Final = 0xFFFFFFFF
_unpack_plain: Final = struct.Struct("<IBQxx").unpack_from
"""Version, flags and data size as one number, the control byte, and destination and source as one number."""

Send: TypeAlias = Callable[[bytes], object]


class RoutingCache:
    """Sends packets whose route is known, and counts them like the router.

    `sender_for(port)` returns a function that sends to the port, or None if its datagrams must pass the router.
    """

    def __init__(self, router: Router, sender_for: Callable[[LocalPort | UdpPort], Send | None]) -> None:
        self._router = router
        self._counters = router.counters
        self._sender_for = sender_for
        self._routes: dict[tuple[Port, int], tuple[Send, str, str]] = {}
        self._ids: set[int] = set()
        self._timer: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return len(self._routes)

    def forward(self, datagram: bytes, port: Port) -> bool:
        """Send a datagram from `port` by its cached route; false if the router must process it."""
        try:
            start, control, ids = _unpack_plain(datagram)
        except struct.error:
            return False
        if start != (len(datagram) - 1) << 16 | header.VERSION or control & _BROADCAST == _GLOBAL:
            return False
        route = self._routes.get((port, ids)) or self._find(port, ids)
        if route is None:
            return False
        send, received, routed = route
        self._counters[received] += 1
        self._counters[routed] += 1
        send(datagram)
        return True

    def invalidate(self, id: int | None) -> None:
        """Clear the cache if it has routes of this id; None stands for any id."""
        if id is None or id in self._ids:
            self.clear()

    def clear(self) -> None:
        """Remove all routes."""
        self._routes.clear()
        self._ids.clear()
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _find(self, port: Port, ids: int) -> tuple[Send, str, str] | None:
        source, destination = ids >> 32, ids & _IDS
        loop = asyncio.get_running_loop()
        to = self._router.cacheable_route(source, destination, port, loop.time())
        send = None if to is None else self._sender_for(to)
        if to is None or send is None:
            return None
        if len(self._routes) >= MAX_ROUTES:
            self.clear()
        route = self._routes[port, ids] = (send, RECEIVED_COUNTERS[type(port)], ROUTED_COUNTERS[type(to)])
        self._ids.update((source, destination))
        if self._timer is None:
            self._timer = loop.call_later(CACHE_LIFETIME, self.clear)
        return route
