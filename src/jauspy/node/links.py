"""JTCP connections and serial lines of a node manager."""

from __future__ import annotations

import asyncio
import errno
import ipaddress
import os
import socket
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Final

from jauspy.errors import ConfigError, TransportError
from jauspy.logs import get_logger
from jauspy.node.config import NodeConfig
from jauspy.node.link_shaper import LinkShaper
from jauspy.protocol.address_book import ADDRESS_LIFETIME
from jauspy.protocol.addressing import NetworkPort, Port, SerialPort, TcpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.link_limits import LinkLimit, LinkLimits
from jauspy.transport.listener import Listener
from jauspy.transport.send_queue import QueueMemory
from jauspy.transport.serial import SerialLine, SerialLink
from jauspy.transport.tcp import Dialer, StreamLink

_LOG = get_logger(__name__)

MAX_CONNECTIONS: Final = 64
"""Accepted connections; see `TcpPeers` for what happens to further ones."""
MAX_CONNECTIONS_PER_HOST: Final = 16
"""Connections from one host among these; for IPv6 from one network of 64 bits, whose addresses a host may all have."""
BUSY_INTERVAL: Final = 5.0
"""Seconds after a packet in which a connection is not closed in favour of one from a host with as many."""
IDLE_LIMIT: Final = ADDRESS_LIFETIME
"""Seconds without a packet after which a connection is closed: the addresses learned from it have expired."""
IDLE_CHECK_INTERVAL: Final = 10.0


class TcpPeers:
    """JTCP connections: accepted ones, and those to peers of the address book.

    `received(datagram, port)` is called for each packet, `disconnected(port)` when a connection has ended.

    When there are too many accepted connections, the host with most of them loses the one that is idle for longest, if
    it has more than the host of the new one. Among hosts with equally many, only connections that never sent a packet,
    or are idle, make room; else the new one is closed.
    """

    def __init__(
        self,
        counters: Counters,
        network: str,
        received: Callable[[bytes, TcpPort], None],
        disconnected: Callable[[TcpPort], None],
        *,
        max_age: float,
        memory: QueueMemory,
    ) -> None:
        self._max_age = max_age
        self._memory = memory
        self._counters = counters
        self._network = network
        self._received = received
        self._disconnected = disconnected
        self._listeners: list[Listener] = []
        self._links: dict[TcpPort, StreamLink] = {}
        self._dialers: dict[TcpPort, Dialer] = {}
        self._idle_timer: asyncio.TimerHandle | None = None

    @property
    def port(self) -> int | None:
        """The TCP port in use; if the configuration says 0, that of the first address."""
        return self._listeners[0].port if self._listeners else None

    def open(self, hosts: Sequence[str], number: int, peers: Iterable[TcpPort]) -> None:
        """Listen on these addresses, and start connecting to `peers`; raises `TransportError`."""
        for host in hosts:
            family = socket.AF_INET6 if ":" in host else socket.AF_INET
            try:
                sock = socket.create_server((host, number), family=family)
            except OSError as error:
                if error.errno == errno.EADDRINUSE:
                    why = "another process uses it"
                else:
                    why = os.strerror(error.errno) if error.errno else str(error)
                raise TransportError(f"cannot listen on TCP {host}:{number}: {why}; choose another tcp_port") from error
            self._listeners.append(Listener(sock, self._make_link, self._counters))
        if hosts:
            self._close_idle()
        for port in peers:
            self._dialers[port] = Dialer(
                (port.host, port.port),
                self._counters,
                self._receiver_for(port),
                max_age=self._max_age,
                memory=self._memory,
            )

    async def close(self) -> None:
        """Close all connections; a second call does nothing."""
        listeners, self._listeners = self._listeners, []
        for listener in listeners:
            listener.close()
        if self._idle_timer is not None:
            self._idle_timer.cancel()
        for link in list(self._links.values()):
            link.close()
        dialers, self._dialers = list(self._dialers.values()), {}
        for dialer in dialers:
            await dialer.close()

    def send(self, port: TcpPort, datagram: bytes) -> None:
        """Send to one peer; counted when dropped."""
        link = self._links.get(port) or self._dialers.get(port)
        if link is None:
            self._counters.drop("tcp_unconnected", port)
        else:
            link.send(datagram)

    def broadcast(self, datagram: bytes) -> None:
        """Send on all connections, because JTCP has no multicast."""
        for link in list(self._links.values()):
            link.send(datagram)
        for dialer in self._dialers.values():
            if dialer.link is not None:
                dialer.link.send(datagram)

    def _make_link(self) -> StreamLink:
        return StreamLink(
            self._counters,
            lambda link, datagram: self._received(datagram, self._port(link)),
            self._ended,
            self._accepted,
            max_age=self._max_age,
            memory=self._memory,
        )

    def _accepted(self, link: StreamLink) -> None:
        while (refused := self._one_too_many(link)) is not None:
            self._counters["tcp.refused"] += 1
            _LOG.info("JTCP connection from %s closed: there are too many", refused.peer)
            refused.close()
            if refused is link:
                return
            self._forget(refused)
        self._links[self._port(link)] = link
        self._counters["tcp.accepted"] += 1

    def _one_too_many(self, new: StreamLink) -> StreamLink | None:
        """The connection to close for a new one, which may be the new one itself; None if there is room."""
        by_host: dict[str, list[StreamLink]] = {}
        for link in self._links.values():
            by_host.setdefault(_host(link), []).append(link)
        of_host = by_host.get(_host(new), [])
        if len(of_host) >= MAX_CONNECTIONS_PER_HOST:
            return _idlest(of_host) or new
        if len(self._links) < MAX_CONNECTIONS:
            return None
        most = max(by_host.values(), key=len)
        if len(most) > len(of_host) + 1:
            return _idlest(most) or min(most, key=_activity)
        return _idlest(self._links.values()) or new

    def _close_idle(self) -> None:
        self._idle_timer = asyncio.get_running_loop().call_later(IDLE_CHECK_INTERVAL, self._close_idle)
        oldest = asyncio.get_running_loop().time() - IDLE_LIMIT
        for link in [link for link in self._links.values() if link.active_at < oldest]:
            self._counters["tcp.idle"] += 1
            link.close()

    def _ended(self, link: StreamLink) -> None:
        if self._links.get(self._port(link)) is link:
            self._forget(link)

    def _forget(self, link: StreamLink) -> None:
        port = self._port(link)
        del self._links[port]
        self._counters["tcp.closed"] += 1
        self._disconnected(port)

    def _port(self, link: StreamLink) -> TcpPort:
        return TcpPort(*link.peer, self._network)

    def _receiver_for(self, port: TcpPort) -> Callable[[StreamLink, bytes], None]:
        return lambda _, datagram: self._received(datagram, port)


def _host(link: StreamLink) -> str:
    """The identity of a host for limits: an IPv4 address, or an IPv6 network of 64 bits."""
    host, _, _ = link.peer[0].partition("%")
    return str(ipaddress.IPv6Network((host, 64), strict=False)) if ":" in host else host


def _activity(link: StreamLink) -> tuple[bool, float]:
    return link.has_received, link.active_at


def _idlest(links: Iterable[StreamLink]) -> StreamLink | None:
    """The connection that is idle for longest, first of those that never sent a packet; None if all are busy."""
    busy = asyncio.get_running_loop().time() - BUSY_INTERVAL
    return min((link for link in links if not link.has_received or link.active_at < busy), key=_activity, default=None)


class Links:
    """JTCP connections and serial lines, as ports of `network`.

    `received(datagram, port)` is called for each packet, `disconnected(port)` when a connection has ended.
    """

    def __init__(
        self,
        counters: Counters,
        network: str,
        received: Callable[[bytes, NetworkPort], None],
        disconnected: Callable[[NetworkPort], None],
        *,
        limits: LinkLimits,
        max_age: float,
        memory: QueueMemory,
    ) -> None:
        self._max_age = max_age
        self._memory = memory
        self._limits = limits
        self._received = received
        self._counters = counters
        self._network = network
        self._shapers: dict[SerialPort, LinkShaper] = {}
        """Of the lines with a limit of all their traffic."""
        self._tcp = TcpPeers(counters, network, received, disconnected, max_age=max_age, memory=memory)
        self._serial: dict[SerialPort, SerialLink] = {}

    @property
    def tcp_port(self) -> int | None:
        """The TCP port in use, if any."""
        return self._tcp.port

    async def open(self, config: NodeConfig, udp_port: int, known: Iterable[NetworkPort]) -> None:
        """Open the configured lines and ports, and connect to the TCP peers of the address book; all or nothing.

        Raises `TransportError` when a port or device cannot be used, `ConfigError` when the network has a key.
        """
        peers = {port for port in known if isinstance(port, TcpPort)}
        if config.key_file is not None and (config.tcp or config.serial or peers):
            raise ConfigError("key_file: JTCP and serial lines cannot be authenticated; use either them or a key")
        hosts = (config.address, *([config.address6] if config.address6 else ())) if config.tcp else ()
        try:
            for serial in config.serial:
                self._open_line(serial.line)
            self.set_rates(config.link_limits)
            self._tcp.open(hosts, udp_port if config.tcp_port is None else config.tcp_port, peers)
        except BaseException:
            await self.close()
            raise

    async def close(self) -> None:
        """Close everything; a second call does nothing."""
        self.set_rates({})
        for line in self._serial.values():
            line.close()
        self._serial.clear()
        await self._tcp.close()

    def set_rates(self, limits: Mapping[str, LinkLimit]) -> None:
        """Replace the limits of all traffic of the lines, by device; what waits for the old ones is dropped."""
        for shaper in self._shapers.values():
            shaper.close()
        self._shapers = {
            port: LinkShaper(
                port.host,
                limit.total,
                self._transmit,
                counters=self._counters,
                left_out=self._limits.left_out,
                max_age=self._max_age,
                memory=self._memory,
            )
            for port in self._serial
            if (limit := limits.get(port.host)) is not None and limit.total is not None
        }

    def send(self, port: TcpPort | SerialPort, datagram: bytes) -> None:
        """Send to one peer; counted when dropped."""
        if isinstance(port, TcpPort):
            self._tcp.send(port, datagram)
        elif port in self._shapers:
            self._shapers[port].send(port, datagram)
        elif port in self._serial:
            self._serial[port].send(datagram)
        else:
            self._counters.drop("no_such_line", port.host)

    def broadcast(self, datagram: bytes) -> None:
        """Send on all connections and lines whose limits do not leave it out."""
        self._tcp.broadcast(datagram)
        now = asyncio.get_running_loop().time()
        for port in self._serial:
            if self._limits.admits(port.host, datagram, now):
                self.send(port, datagram)
            else:
                self._counters.drop("link_limit", port.host)

    def _transmit(self, port: Port, datagram: bytes) -> None:
        if isinstance(port, SerialPort) and port in self._serial:
            self._serial[port].send(datagram)

    def _open_line(self, line: SerialLine) -> None:
        port = SerialPort(line.device, network=self._network)
        link = SerialLink(
            line,
            self._counters,
            lambda datagram: self._received(datagram, port),
            max_age=self._max_age,
            memory=self._memory,
        )
        link.open()
        self._serial[port] = link
