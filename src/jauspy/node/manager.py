"""The node manager as an asyncio service: it only moves bytes between sockets and the core."""

from __future__ import annotations

import asyncio
import errno
import logging
import socket
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Final, Self

from jauspy.ids import JausID
from jauspy.node.config import NodeConfig
from jauspy.node.outbox import Outbox
from jauspy.node.sockets import UdpSockets, open_udp
from jauspy.protocol import junior
from jauspy.protocol.node import NodeCore
from jauspy.protocol.ports import LocalPort, Port, UdpPort
from jauspy.transport import draining, local_socket
from jauspy.transport.multicast import ANY

_LOGGER = logging.getLogger(__name__)

RETRY_INTERVAL: Final = 0.002
"""Seconds until a component whose queue was full is tried again; there is no event to wait for."""


class NodeManager:
    """Owns UDP 3794, the multicast group, and the local socket `<local_root>/JuniorRTE`.

    Use it as a context manager, or `open` and `close` it. `TransportError` when another one is running.
    """

    def __init__(self, config: NodeConfig | None = None) -> None:
        self.config = config or NodeConfig()
        self._core = NodeCore(str(self.config.local_root))
        self._udp: UdpSockets | None = None
        self._local: socket.socket | None = None
        self._outboxes: dict[str, Outbox] = {}
        self._retry: asyncio.TimerHandle | None = None
        self._timer: asyncio.TimerHandle | None = None
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
        loop = asyncio.get_running_loop()
        draining.attach(loop, self._local, self._from_component, self._socket_error)
        for sock in self._udp.all():
            draining.attach(loop, sock, self._from_network, self._socket_error)

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""
        udp, local = self._udp, self._local
        self._udp = self._local = None
        if udp is None or local is None:
            return
        for handle in (self._retry, self._timer):
            if handle is not None:
                handle.cancel()
        self._retry = self._timer = None
        loop = asyncio.get_running_loop()
        for sock in (local, *udp.all()):
            draining.detach(loop, sock)
        self.path.unlink(missing_ok=True)
        self._closed.set()

    async def run(self) -> None:
        """Wait until somebody closes it."""
        await self._closed.wait()

    # --- in ------------------------------------------------------------------------------------------------------

    def _from_component(self, datagram: bytes, sender: str | None) -> None:
        self._receive(datagram, LocalPort(sender or ""))

    def _from_network(self, datagram: bytes, sender: tuple[str, int]) -> None:
        self._receive(datagram, UdpPort(*sender))

    def _receive(self, datagram: bytes, source: Port) -> None:
        self._core.receive(datagram, source, asyncio.get_running_loop().time())
        self._flush()

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
        outbox = self._outboxes.get(path)
        if outbox is None and self._try_local(path, datagram):
            return
        if outbox is None:
            outbox = self._outboxes[path] = Outbox()
        if not outbox.push(datagram):
            self._core.counters.drop("queue_full", path)
        if self._retry is None:
            self._retry = asyncio.get_running_loop().call_later(RETRY_INTERVAL, self._retry_local)

    def _try_local(self, path: str, datagram: bytes) -> bool:
        """Send to a component; False when its queue is full. A component that is gone is forgotten."""
        if self._local is None:
            return True
        try:
            self._local.sendto(datagram, path)
        except BlockingIOError:
            return False
        except OSError as error:
            self._core.counters.drop("component_gone", error)
            if error.errno in (errno.ECONNREFUSED, errno.ENOENT):
                self._core.unreachable(path)
        return True

    def _retry_local(self) -> None:
        self._retry = None
        for path, outbox in list(self._outboxes.items()):
            while len(outbox) and self._try_local(path, outbox.peek()):
                outbox.pop()
            if not len(outbox):
                del self._outboxes[path]
        if self._outboxes:
            self._retry = asyncio.get_running_loop().call_later(RETRY_INTERVAL, self._retry_local)

    def _send_udp(self, datagram: bytes, address: tuple[str, int]) -> None:
        if self._udp is None:
            return
        try:
            self._udp.unicast.sendto(datagram, address)
        except OSError as error:
            self._core.counters.drop("udp_unreachable", error)

    def _send_multicast(self, datagram: bytes) -> None:
        for interface in self.config.interfaces:
            if interface != ANY and self._udp is not None:
                self._udp.unicast.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
            self._send_udp(datagram, (self.config.multicast_group, self.port))

    # --- time ----------------------------------------------------------------------------------------------------

    def _arm(self) -> None:
        when = self._core.next_timeout()
        if when is None or self._udp is None:
            return
        if self._timer is None:
            self._timer = asyncio.get_running_loop().call_at(when, self._timeout)

    def _timeout(self) -> None:
        self._timer = None
        self._core.handle_timeout(asyncio.get_running_loop().time())
        self._flush()
