"""A network in memory: node managers whose datagrams arrive after a delay, and transports of their components."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Mapping
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.protocol import junior
from jauspy.protocol.address_book import IdBounds
from jauspy.protocol.addressing import HERE, GroupPort, LocalPort, Location, Port, UdpPort
from jauspy.protocol.routing import Router
from jauspy.transport.base import Receiver, ignore

DELAY: Final = 0.002
"""Seconds of a datagram through the network."""
PORT: Final = 3794


class Network:
    """Node managers by their address; datagrams arrive after `DELAY`."""

    def __init__(self) -> None:
        self.nodes: dict[str, Node] = {}
        self.datagrams = 0

    def send(self, datagram: bytes, source: UdpPort, destination: UdpPort | GroupPort) -> None:
        """Send to one node manager, or to all others."""
        loop = asyncio.get_running_loop()
        receivers: Iterable[Node | None] = (
            (self.nodes.get(destination.host),)
            if isinstance(destination, UdpPort)
            else (node for node in self.nodes.values() if node.port != source)
        )
        for node in receivers:
            if node is not None:
                self.datagrams += 1
                loop.call_later(DELAY, node.receive, datagram, source)


class Node:
    """The router of a node manager, with what `jauspy.node` does for it."""

    def __init__(self, network: Network, number: int, bounds: IdBounds) -> None:
        host = f"10.0.{number >> 8}.{number & 0xFF}"
        self.port = UdpPort(host, PORT)
        self.router = Router(f"/{host}", bounds=bounds)
        self.members: dict[str, NodeTransport] = {}
        self._network = network
        self._timer: asyncio.TimerHandle | None = None
        network.nodes[host] = self

    def transport(self, id: JausID) -> NodeTransport:
        """A transport for the component of this id."""
        return NodeTransport(id, self)

    def receive(self, datagram: bytes, source: Port) -> None:
        """Route a datagram of a component or another node manager."""
        loop = asyncio.get_running_loop()
        self.router.receive(datagram, source, loop.time())
        self._flush()

    def close(self) -> None:
        """Stop the timer."""
        if self._timer is not None:
            self._timer.cancel()

    def _flush(self) -> None:
        loop = asyncio.get_running_loop()
        for port, datagram in self.router.poll_output():
            if isinstance(port, LocalPort):
                member = self.members.get(port.path)
                if member is not None:
                    loop.call_soon(member.arrive, datagram)
            elif isinstance(port, UdpPort | GroupPort):
                self._network.send(datagram, self.port, port)
        if self._timer is None and (when := self.router.next_timeout()) is not None:
            self._timer = loop.call_at(when, self._timeout)

    def _timeout(self) -> None:
        self._timer = None
        self.router.handle_timeout(asyncio.get_running_loop().time())
        self._flush()


class NodeTransport:
    """A component's local socket."""

    def __init__(self, id: JausID, node: Node) -> None:
        self.id = id
        self.received: Receiver = ignore
        self.max_age = 0.0
        self._node = node
        self._port = LocalPort(f"/{node.port.host}/{int(id)}")

    connected = True
    waiting = 0
    counters: Mapping[str, int] = {}

    async def open(self) -> None:
        """Register."""
        self._node.members[self._port.path] = self
        self._node.receive(junior.connect(self.id), self._port)

    async def close(self) -> None:
        """Leave."""
        if self._node.members.pop(self._port.path, None) is not None:
            self._node.receive(junior.cancel(self.id), self._port)

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:  # noqa: ARG002 - never called
        """Ids do not change here."""
        raise ConfigError(f"{self.id} cannot become {id} in this benchmark")

    def send(self, datagram: bytes) -> None:
        """Send to the node manager."""
        self._node.receive(datagram, self._port)

    def locate(self, id: JausID, found: Callable[[Location], None]) -> None:  # noqa: ARG002 - the same for all
        """Everything is in this process."""
        found(HERE)

    def arrive(self, datagram: bytes) -> None:
        """Called by the node manager."""
        if junior.parse(datagram) is None:
            self.received(datagram)
