"""JTCP of a node manager: who connects to it, and whom the address book says to connect to."""

from __future__ import annotations

import asyncio
import errno
import logging
import os
from collections.abc import Callable, Iterable, Sequence
from typing import Final

from jauspy.errors import TransportError
from jauspy.protocol.addressing import TcpPort
from jauspy.protocol.counters import Counters
from jauspy.transport.stream import Dialer, StreamLink

_LOGGER = logging.getLogger(__name__)

MAX_CONNECTIONS: Final = 64
"""Connections from outside; one more takes the place of the oldest that never sent a packet, or is closed at once."""


class TcpPeers:
    """`took(datagram, port)` gets every packet, `gone(port)` is told when a connection has ended."""

    def __init__(
        self,
        counters: Counters,
        network: str,
        took: Callable[[bytes, TcpPort], None],
        gone: Callable[[TcpPort], None],
    ) -> None:
        self._counters = counters
        self._network = network
        self._took = took
        self._gone = gone
        self._server: asyncio.Server | None = None
        self._links: dict[TcpPort, StreamLink] = {}
        self._dialers: dict[TcpPort, Dialer] = {}

    @property
    def port(self) -> int | None:
        """The TCP port in use; with 0 in the configuration, that of the first address."""
        return self._server.sockets[0].getsockname()[1] if self._server and self._server.sockets else None

    async def open(self, hosts: Sequence[str], number: int, peers: Iterable[TcpPort]) -> None:
        """Listen on these addresses, and begin to connect; raises `TransportError` when the port is taken."""
        if hosts:
            try:
                self._server = await asyncio.get_running_loop().create_server(self._accept, hosts, number)
            except OSError as error:
                if error.errno == errno.EADDRINUSE:
                    why = "it is used by another process"
                else:
                    why = os.strerror(error.errno) if error.errno else str(error)
                raise TransportError(
                    f"cannot listen on TCP {hosts[0]}:{number}: {why}; choose another tcp_port"
                ) from error
        for port in peers:
            self._dialers[port] = Dialer((port.host, port.port), self._counters, self._receive_from(port))

    async def close(self) -> None:
        """Close all connections; a second call does nothing."""
        server, self._server = self._server, None
        if server is not None:
            server.close()
        for link in list(self._links.values()):
            link.close()
        dialers, self._dialers = list(self._dialers.values()), {}
        for dialer in dialers:
            await dialer.close()

    def send(self, port: TcpPort, datagram: bytes) -> None:
        """Send to one peer, or drop and count."""
        way = self._links.get(port) or self._dialers.get(port)
        if way is None:
            self._counters.drop("tcp_unconnected", port)
        else:
            way.send(datagram)

    def broadcast(self, datagram: bytes) -> None:
        """Send to all that are connected: JTCP has no groups."""
        for link in list(self._links.values()):
            link.send(datagram)
        for dialer in self._dialers.values():
            if dialer.link is not None:
                dialer.link.send(datagram)

    def _accept(self) -> StreamLink:
        return StreamLink(
            self._counters,
            lambda link, datagram: self._took(datagram, self._port(link)),
            self._ended,
            self._began,
        )

    def _began(self, link: StreamLink) -> None:
        if len(self._links) >= MAX_CONNECTIONS:
            refused = next((each for each in self._links.values() if not each.has_spoken), link)
            self._counters["tcp.refused"] += 1
            _LOGGER.info("JTCP connection from %s closed: there are %d already", refused.peer, MAX_CONNECTIONS)
            refused.close()
            if refused is link:
                return
            self._forget(refused)
        self._links[self._port(link)] = link
        self._counters["tcp.accepted"] += 1

    def _ended(self, link: StreamLink) -> None:
        if self._links.get(self._port(link)) is link:
            self._forget(link)

    def _forget(self, link: StreamLink) -> None:
        port = self._port(link)
        del self._links[port]
        self._counters["tcp.closed"] += 1
        self._gone(port)

    def _port(self, link: StreamLink) -> TcpPort:
        return TcpPort(*link.peer, self._network)

    def _receive_from(self, port: TcpPort) -> Callable[[StreamLink, bytes], None]:
        return lambda _, datagram: self._took(datagram, port)
