"""The node manager as an asyncio service: it only moves bytes between sockets and the core."""

from __future__ import annotations

import asyncio
import logging
import socket
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Self

from jauspy.ids import JausID
from jauspy.node import udp_errors
from jauspy.node.config import NodeConfig
from jauspy.node.links import Links
from jauspy.node.mailbox import Mailbox
from jauspy.node.sockets import UdpSockets, open_udp
from jauspy.protocol import junior
from jauspy.protocol.node import NodeCore
from jauspy.protocol.ports import GroupPort, LocalPort, NetworkPort, UdpPort
from jauspy.transport import draining, local_socket
from jauspy.transport.memberships import WATCH_INTERVAL
from jauspy.transport.multicast import ANY

_LOGGER = logging.getLogger(__name__)


class NodeManager:
    """Owns UDP 3794, the multicast group, and the local socket `<local_root>/JuniorRTE`.

    Use it as a context manager, or `open` and `close` it. `TransportError` when another one is running.
    """

    _loop: asyncio.AbstractEventLoop

    def __init__(self, config: NodeConfig | None = None) -> None:
        self.config = config or NodeConfig()
        self._known = self.config.known_addresses()
        self._core = NodeCore(
            str(self.config.local_root),
            addresses=self._known,
            address_lifetime=self.config.address_lifetime,
            local_udp=self.config.local_udp,
        )
        self._links: Links | None = None
        self._udp: UdpSockets | None = None
        self._local: socket.socket | None = None
        self._mailboxes: dict[str, Mailbox] = {}
        self._timer: asyncio.TimerHandle | None = None
        self._watch: asyncio.TimerHandle | None = None
        self._closed = asyncio.Event()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    @property
    def path(self) -> Path:
        """The socket that components send to."""
        return self.config.local_root / junior.SOCKET_NAME

    @property
    def port(self) -> int:
        """The UDP port in use; also when the configuration said 0."""
        return self.config.port if self._udp is None else int(self._udp.unicast.getsockname()[1])

    @property
    def tcp_port(self) -> int | None:
        """The TCP port in use, if any."""
        return self._links.tcp_port if self._links else None

    @property
    def components(self) -> tuple[JausID, ...]:
        """The ids of the components that are registered here."""
        return tuple(sorted(JausID.from_int(id) for id, _ in self._core.components))

    @property
    def counters(self) -> Mapping[str, int]:
        """What was received, routed and dropped, by reason."""
        return self._core.counters

    async def open(self) -> None:
        """Bind everything, or nothing."""
        self._loop = asyncio.get_running_loop()
        self._local = local_socket.bind(self.path, owner="a node manager", mode=self.config.local_mode)
        try:
            self._udp = open_udp(self.config)
            self._links = Links(self._core.counters, self._from_link, self._link_closed)
            known = [port for ports in self._known.values() for port in ports]
            await self._links.open(self.config, self.port, known)
        except BaseException:
            for sock in (self._local, *(self._udp.all() if self._udp else ())):
                sock.close()
            self.path.unlink(missing_ok=True)
            self._local = self._udp = self._links = None
            raise
        self._closed.clear()
        if not self._udp.joined:
            self._core.counters["multicast.not_joined"] += 1
        self._watch = self._loop.call_later(WATCH_INTERVAL, self._watch_interfaces)
        draining.attach(self._loop, self._local, self._from_component, self._socket_error, done=self._flush)
        for sock in self._udp.all():
            draining.attach(self._loop, sock, self._from_network, self._udp_error, done=self._flush)

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""
        udp, local = self._udp, self._local
        self._udp = self._local = None
        if udp is None or local is None:
            return
        for timer in (self._timer, self._watch):
            if timer is not None:
                timer.cancel()
        self._timer = self._watch = None
        links, self._links = self._links, None
        if links is not None:
            await links.close()
        for mailbox in self._mailboxes.values():
            mailbox.close()
        self._mailboxes.clear()
        for sock in (local, *udp.all()):
            draining.detach(self._loop, sock)
        local_socket.clean_up(self.path)
        self._closed.set()

    async def run(self) -> None:
        """Wait until somebody closes it."""
        await self._closed.wait()

    # --- in ------------------------------------------------------------------------------------------------------

    def _from_component(self, datagram: bytes, sender: str | bytes | None) -> None:
        self._core.receive(datagram, LocalPort(_path(sender)), self._loop.time())

    def _from_network(self, datagram: bytes, sender: tuple[str, int]) -> None:
        self._core.receive(datagram, UdpPort(*sender[:2]), self._loop.time())

    def _from_link(self, datagram: bytes, port: NetworkPort) -> None:
        self._core.receive(datagram, port, self._loop.time())
        self._flush()

    def _link_closed(self, port: NetworkPort) -> None:
        self._core.disconnected(port)

    def _socket_error(self, error: OSError) -> None:
        self._core.counters.drop("socket_error", error)

    def _udp_error(self, error: OSError) -> None:
        self._core.counters.drop("udp_unreachable", error)
        for port in udp_errors.refused(self._udp.unicast) if self._udp else ():
            self._core.unreachable(port)

    # --- out -----------------------------------------------------------------------------------------------------

    def _flush(self) -> None:
        for port, datagram in self._core.poll_output():
            if isinstance(port, LocalPort):
                self._send_local(port.path, datagram)
            elif isinstance(port, UdpPort):
                self._send_udp(datagram, (port.host, port.port))
            elif isinstance(port, GroupPort):
                self._send_multicast(datagram)
            elif self._links is not None:
                self._links.send(port, datagram)
        self._arm()

    def _send_local(self, path: str, datagram: bytes) -> None:
        mailbox = self._mailboxes.get(path)
        if mailbox is None:
            self._forget_cancelled()
            mailbox = self._mailboxes[path] = Mailbox(path, self._core.counters, self._gone)
        elif datagram[0] == junior.VERSION:
            mailbox.refresh()
        mailbox.send(datagram)

    def _gone(self, path: str) -> None:
        self._mailboxes.pop(path, None)
        self._core.unreachable(LocalPort(path))

    def _forget_cancelled(self) -> None:
        alive = {port.path for _, port in self._core.components if isinstance(port, LocalPort)}
        for path in [path for path in self._mailboxes if path not in alive]:
            self._mailboxes.pop(path).close()

    def _send_udp(self, datagram: bytes, address: tuple[str, int]) -> None:
        sender = self._udp.sender(address[0]) if self._udp else None
        if sender is None:
            self._core.counters.drop("no_ipv6", address)
            return
        try:
            sender.sendto(datagram, address)
        except ConnectionRefusedError:
            self._udp_refused(sender, datagram, address)
        except OSError as error:
            self._core.counters.drop("udp_unreachable", error)

    def _udp_refused(self, sender: socket.socket, datagram: bytes, address: tuple[str, int]) -> None:
        """An earlier datagram came back, to whomever; this one was not even tried."""
        for port in udp_errors.refused(sender):
            self._core.unreachable(port)
        try:
            sender.sendto(datagram, address)
        except OSError as error:
            self._core.counters.drop("udp_unreachable", error)

    def _send_multicast(self, datagram: bytes) -> None:
        if self._udp is None or self._links is None:
            return
        memberships = self._udp.memberships
        for interface in memberships.current if memberships else self.config.interfaces:
            if interface != ANY:
                self._udp.unicast.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
            self._send_udp(datagram, (self.config.multicast_group, self.port))
        self._links.broadcast(datagram)

    def _watch_interfaces(self) -> None:
        if self._udp is not None and self._udp.memberships is not None:
            self._udp.memberships.refresh()
        self._watch = self._loop.call_later(WATCH_INTERVAL, self._watch_interfaces)

    # --- time ----------------------------------------------------------------------------------------------------

    def _arm(self) -> None:
        when = self._core.next_timeout()
        if when is None or self._udp is None:
            return
        if self._timer is None:
            self._timer = self._loop.call_at(when, self._timeout)

    def _timeout(self) -> None:
        self._timer = None
        self._core.handle_timeout(self._loop.time())
        self._flush()


def _path(sender: str | bytes | None) -> str:
    """A component's socket as the kernel names it; empty when it has no name in the file system to answer to."""
    return sender if isinstance(sender, str) and sender.startswith("/") else ""
