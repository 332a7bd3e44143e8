"""The ways of plain packets that were found a moment ago: most packets go where the one before them went."""

from __future__ import annotations

import asyncio
import struct
from collections.abc import Callable
from typing import Final, TypeAlias

from jauspy.protocol import header
from jauspy.protocol.addressing import LocalPort, Port, UdpPort
from jauspy.protocol.egress import ROUTED_COUNTERS
from jauspy.protocol.routing import RECEIVED_COUNTERS, Router

LIFETIME: Final = 0.5
"""Seconds until all ways are looked for again, so that what the core learns from packets is only this much late."""
MAX_WAYS: Final = 1024

_IDS: Final = 0xFFFFFFFF
_plain: Final = struct.Struct("<IBQxx").unpack_from
"""Version, flags and data size as one number, the control byte, and destination and source as one number."""

Send: TypeAlias = Callable[[bytes], object]


class Shortcuts:
    """Sends what needs no decision past the core, and counts it there.

    `open_way` makes what sends to a port, or None when its datagrams are to go the whole way.
    """

    def __init__(self, core: Router, open_way: Callable[[LocalPort | UdpPort], Send | None]) -> None:
        self._core = core
        self._counters = core.counters
        self._open_way = open_way
        self._ways: dict[tuple[Port, int], tuple[Send, str, str]] = {}
        self._ids: set[int] = set()
        self._timer: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return len(self._ways)

    def take(self, datagram: bytes, port: Port) -> bool:
        """False when the core must look at this datagram."""
        try:
            start, _, ids = _plain(datagram)
        except struct.error:
            return False
        if start != (len(datagram) - 1) << 16 | header.VERSION:
            return False
        way = self._ways.get((port, ids)) or self._find(port, ids)
        if way is None:
            return False
        send, received, routed = way
        self._counters[received] += 1
        self._counters[routed] += 1
        send(datagram)
        return True

    def forget(self, id: int | None) -> None:
        """Something about this id has changed, or, when it is None, about any."""
        if id is None or id in self._ids:
            self.clear()

    def clear(self) -> None:
        """Look for all ways again."""
        self._ways.clear()
        self._ids.clear()
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _find(self, port: Port, ids: int) -> tuple[Send, str, str] | None:
        source, destination = ids >> 32, ids & _IDS
        loop = asyncio.get_running_loop()
        where = self._core.cacheable_route(source, destination, port, loop.time())
        send = None if where is None else self._open_way(where)
        if where is None or send is None:
            return None
        if len(self._ways) >= MAX_WAYS:
            self.clear()
        way = self._ways[port, ids] = (send, RECEIVED_COUNTERS[type(port)], ROUTED_COUNTERS[type(where)])
        self._ids.update((source, destination))
        if self._timer is None:
            self._timer = loop.call_later(LIFETIME, self.clear)
        return way
