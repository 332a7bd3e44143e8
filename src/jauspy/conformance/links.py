"""A `Wire` through a node manager: each client is a component of it, by its local socket or by TCP."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Collection
from typing import Final

from jauspy.conformance.udp import UdpWire
from jauspy.conformance.wire import Arrival, Wire
from jauspy.ids import JausID
from jauspy.transport import Transport, connect as connecting

MAX_WAITING: Final = 4096
"""Datagrams that the tester has not read yet; more are dropped."""


async def open_wire(connect: str | None) -> Wire:
    """What `connect` says, as for other commands; multicast when it says nothing, also beside a node manager.

    A test is of the target, so its datagrams do not pass through a node manager of ours unless that is asked for.
    """
    if connect is None:
        return UdpWire()
    if connect.startswith("udp://"):
        return UdpWire(peer=await connecting.udp_address(connect))
    return LinkWire(connect)


class LinkWire:
    """Clients as components of a node manager; drives an event loop of its own while it waits."""

    features: Collection[str] = ()

    def __init__(self, connect: str) -> None:
        self._connect = connect
        self._loop = asyncio.new_event_loop()
        self._arrived: asyncio.Queue[Arrival] = asyncio.Queue(MAX_WAITING)
        self._transports: dict[JausID, Transport] = {}
        self.dropped = 0

    @property
    def notes(self) -> list[str]:
        """What did not work as it should, for the report."""
        dropped = f"{self.dropped} datagrams came faster than they were read, and were dropped"
        return [dropped] if self.dropped else []

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def join(self, id: JausID) -> None:
        """Attach a component; raises `TransportError` when there is no node manager."""
        self._loop.run_until_complete(self._attach(id))

    def send(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:
        """Send as the component `source`."""
        assert not strange_port, "a step that needs this wants PORTS"
        self._transports[source].send(datagram)

    def receive(self, until: float) -> Arrival | None:
        """What comes next to any of the clients."""
        waiting = self._loop.create_task(self._next(until - time.monotonic()))
        try:
            return self._loop.run_until_complete(waiting)
        finally:
            waiting.cancel()  # after Ctrl-C it would take what comes next

    def close(self) -> None:
        """Detach all components."""
        if not self._loop.is_closed():
            for transport in self._transports.values():
                self._loop.run_until_complete(transport.close())
            self._loop.close()

    async def _attach(self, id: JausID) -> None:
        transport = await connecting.transport_for(id, self._connect)
        transport.received = self._take
        await transport.open()
        self._transports[id] = transport

    def _take(self, datagram: bytes) -> None:
        try:
            self._arrived.put_nowait(Arrival(datagram))
        except asyncio.QueueFull:
            self.dropped += 1

    async def _next(self, seconds: float) -> Arrival | None:
        try:
            return await asyncio.wait_for(self._arrived.get(), max(0.0, seconds))
        except TimeoutError:
            return None
