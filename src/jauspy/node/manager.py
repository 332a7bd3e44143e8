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
from jauspy.node.config import NodeConfig
from jauspy.node.mailbox import Mailbox
from jauspy.node.sockets import UdpSockets, open_udp
from jauspy.protocol import junior
from jauspy.protocol.node import NodeCore
from jauspy.protocol.ports import LocalPort, UdpPort
from jauspy.transport import draining, local_socket, memberships
from jauspy.transport.multicast import ANY

_LOGGER = logging.getLogger(__name__)


class NodeManager:
    """Owns UDP 3794, the multicast group, and the local socket `<local_root>/JuniorRTE`.

    Use it as a context manager, or `open` and `close` it. `TransportError` when another one is running.
    """

    _loop: asyncio.AbstractEventLoop

    def __init__(self, config: NodeConfig | None = None) -> None:
        self.config = config or NodeConfig()
        self._core = NodeCore(str(self.config.local_root), is_dead=self._is_dead)
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
    def components(self) -> tuple[JausID, ...]:
        """The ids of the components that are registered here."""
        return tuple(sorted(JausID.from_int(id) for id, _ in self._core.components))

    @property
    def counters(self) -> Mapping[str, int]:
        """What was received, routed and dropped, by reason."""
        return self._core.counters

    async def open(self) -> None:
        """Bind everything, or nothing."""
        self._local = local_socket.bind(self.path, owner="a node manager", mode=self.config.local_mode)
        try:
            self._udp = open_udp(self.config)
        except BaseException:
            self._local.close()
            self.path.unlink(missing_ok=True)
            self._local = None
            raise
        self._closed.clear()
        if not self._udp.joined:
            self._core.counters["multicast.not_joined"] += 1
        self._loop = asyncio.get_running_loop()
        self._watch = self._loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)
        draining.attach(self._loop, self._local, self._from_component, self._socket_error, done=self._flush)
        for sock in self._udp.all():
            draining.attach(self._loop, sock, self._from_network, self._socket_error, done=self._flush)

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
        self._core.receive(datagram, UdpPort(*sender), self._loop.time())

    def _socket_error(self, error: OSError) -> None:
        self._core.counters.drop("socket_error", error)

    # --- out -----------------------------------------------------------------------------------------------------

    def _flush(self) -> None:
        for port, datagram in self._core.poll_output():
            if isinstance(port, LocalPort):
                self._send_local(port.path, datagram)
            elif isinstance(port, UdpPort):
                self._send_udp(datagram, port)
            else:
                self._send_multicast(datagram)
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
        self._core.unreachable(path)
        self._bury(path)

    def _is_dead(self, path: str) -> bool:
        if not local_socket.is_dead(Path(path)):
            return False
        self._bury(path)
        return True

    def _bury(self, path: str) -> None:
        """Remove the socket that a component has left behind, when its name says that it is one's."""
        socket_path = Path(path)
        if socket_path.parent == self.config.local_root and socket_path.name.isdecimal():
            local_socket.clean_up(socket_path)

    def _forget_cancelled(self) -> None:
        alive = {path for _, path in self._core.components}
        for path in [path for path in self._mailboxes if path not in alive]:
            self._mailboxes.pop(path).close()

    def _send_udp(self, datagram: bytes, address: tuple[str, int]) -> None:
        if self._udp is None:
            return
        try:
            self._udp.unicast.sendto(datagram, address)
        except OSError as error:
            self._core.counters.drop("udp_unreachable", error)

    def _send_multicast(self, datagram: bytes) -> None:
        for interface in self.config.interfaces:
            if self._udp is None or not self._leave_by(interface, self._udp.unicast):
                continue
            self._send_udp(datagram, (self.config.multicast_group, self.port))

    def _leave_by(self, interface: str, sender: socket.socket) -> bool:
        """Let multicasts leave by this interface; false while it is not there."""
        try:
            if interface != ANY:
                sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
        except OSError as error:
            self._core.counters.drop("udp_unreachable", error)
            return False
        return True

    def _watch_interfaces(self) -> None:
        if self._udp is not None and self._udp.memberships is not None:
            self._udp.memberships.refresh()
        self._watch = self._loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)

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
