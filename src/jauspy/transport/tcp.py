"""JTCP connections: an open one, one that is reconnected, and a component's transport."""

from __future__ import annotations

import asyncio
import math
import socket
import struct
from collections.abc import Callable, Mapping
from typing import Final, cast

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import header, jtcp, judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.counters import Counters
from jauspy.transport.age import MAX_AGE, AckWatch, StallDetector
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.send_queue import QueueMemory, SendQueue

_LOG = get_logger(__name__)

HIGH_WATER: Final = 8 * 1024
"""Bytes in asyncio's write buffer above which packets wait in a bounded queue, by priority."""
MAX_UNSENT: Final = 8 * 1024
"""Bytes that the kernel takes beyond those under way: it has neither priorities nor ages, so what waits there delays
a stop. Without it, Linux takes megabytes on a link of some delay."""
ACK_CHECK_INTERVAL: Final = 0.5
"""Seconds between two looks whether the peer acknowledges."""
READ_SIZE: Final = 2048
"""Bytes read per turn of the event loop: about a hundred of the smallest packets, so that a flood delays nobody."""
CONNECT_TIMEOUT: Final = 5.0
KEEP_ALIVE_IDLE: Final = 10
KEEP_ALIVE_INTERVAL: Final = 5
KEEP_ALIVE_PROBES: Final = 3
"""The kernel asks an idle peer after so many seconds, and closes the connection if it does not answer these."""
_DISCARD: Final = struct.pack("@ii", 1, 0)
"""Value of SO_LINGER with which closing resets the connection."""
MIN_RETRY_INTERVAL: Final = 0.1
MAX_RETRY_INTERVAL: Final = 2.0


class StreamLink(asyncio.BufferedProtocol):
    """An open connection. `received(link, datagram)` is called for each packet, `ended(link)` once when it is closed.

    A stream that has lost the packet boundaries is closed, because nothing restores them. A connection has one version:
    the client sends the version byte of AS5669A; the server, which has the callback `accepted`, sends the version that
    it has received. It is closed, too, when the event loop was blocked for more than `max_age` seconds: the packets
    under way are old, those that wait at the peer as well. It is closed, and what the kernel has is discarded, when the
    peer has acknowledged nothing for `age.MAX_UNACKNOWLEDGED` seconds.
    """

    def __init__(
        self,
        counters: Counters,
        received: Callable[[StreamLink, bytes], None],
        ended: Callable[[StreamLink], None],
        accepted: Callable[[StreamLink], None] | None = None,
        *,
        max_age: float = MAX_AGE,
        memory: QueueMemory | None = None,
    ) -> None:
        self.peer: Address = ("", 0)
        self.has_received = False
        """True when a complete packet has arrived."""
        self.active_at = 0.0
        """Loop time of the last complete packet, or of the connection."""
        self._counters = counters
        self._received = received
        self._ended = ended
        self._accepted = accepted
        self._decoder = jtcp.StreamDecoder()
        self._buffer = bytearray(READ_SIZE)
        self._sent_version: int | None = None
        self._transport: asyncio.Transport | None = None
        self._paused = False
        self._waiting = SendQueue(max_age=max_age, memory=memory)
        self._max_age = max_age
        self._stall = StallDetector(max_age)
        self._ack_timer: asyncio.TimerHandle | None = None

    @property
    def waiting(self) -> int:
        """The number of queued datagrams."""
        return len(self._waiting)

    def send(self, datagram: bytes) -> bool:
        """Send a checked datagram, or queue it; false when it cannot be sent on this connection."""
        if self._transport is None or self._transport.is_closing():
            self._counters.drop("tcp_closed", self.peer)
        elif datagram[0] != self._send_version(self._transport):
            self._counters.drop("tcp_version", f"version {datagram[0]} to {self.peer} with {self._sent_version}")
        elif not self._paused:
            self._transport.write(self._decoder.frame(datagram))
            return True
        else:
            for _ in self._waiting.push(datagram):
                self._counters.drop("queue_full", self.peer)
            return True
        return False

    def close(self) -> None:
        """Close immediately; queued datagrams are lost."""
        if self._transport is not None:
            self._transport.abort()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Send the version byte, or report an accepted connection to the owner."""
        self._transport = cast("asyncio.Transport", transport)
        self.peer = (transport.get_extra_info("peername") or self.peer)[:2]
        self._transport.set_write_buffer_limits(high=HIGH_WATER)
        self.active_at = asyncio.get_running_loop().time()
        sock = self._transport.get_extra_info("socket")
        _detect_dead_peer(sock)
        _limit_unsent(sock)
        if self._max_age < math.inf:
            self._check_acks(AckWatch(sock, self.active_at))
        if self._accepted is not None:
            self._accepted(self)
        else:
            self._send_version(self._transport)

    def get_buffer(self, _sizehint: int) -> bytearray:
        """The buffer for the next bytes."""
        return self._buffer

    def buffer_updated(self, nbytes: int) -> None:
        """Pass on complete packets."""
        if self._transport is None or self._transport.is_closing():
            return
        if self._stall.has_stalled:
            self._counters.drop("stale", self.peer)
            self.close()
            return
        datagrams, error = self._decoder.feed(bytes(self._buffer[:nbytes]))
        if datagrams:
            self.has_received, self.active_at = True, asyncio.get_running_loop().time()
        for datagram in datagrams:
            self._received(self, datagram)
        if error is not None:
            self._counters.drop(f"malformed.{error.reason}", f"{self.peer}: {error}")
            self.close()

    def _check_acks(self, watch: AckWatch) -> None:
        """Close the connection, and have the kernel discard what it would send again, if the peer is silent."""
        loop = asyncio.get_running_loop()
        if self._transport is None or self._transport.is_closing():
            return
        if not watch.is_overdue(loop.time()):
            self._ack_timer = loop.call_later(ACK_CHECK_INTERVAL, self._check_acks, watch)
            return
        self._counters["tcp.unacknowledged"] += 1
        _LOG.info("JTCP connection with %s closed: it acknowledges nothing", self.peer)
        self._transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _DISCARD)
        self.close()

    def _send_version(self, transport: asyncio.Transport) -> int:
        """Send the version byte once; returns the version."""
        if self._sent_version is None:
            self._sent_version = self._decoder.version or header.VERSION
            transport.write(bytes([self._sent_version]))
        return self._sent_version

    def pause_writing(self) -> None:
        """Queue packets, because the peer does not read."""
        self._paused = True

    def resume_writing(self) -> None:
        """Send queued packets, those of the highest priority first."""
        self._paused = False
        for _ in range(self._waiting.drop_stale()):
            self._counters.drop("stale", self.peer)
        while self._waiting and not self._paused and self._transport is not None:
            datagram = self._waiting.peek()
            self._waiting.pop()
            self._transport.write(self._decoder.frame(datagram))

    def connection_lost(self, _error: Exception | None) -> None:
        """Report the end to the owner, and count the queued packets as dropped."""
        for _ in range(self._waiting.clear()):
            self._counters.drop("tcp_closed", self.peer)
        self._transport = None
        self._stall.close()
        if self._ack_timer is not None:
            self._ack_timer.cancel()
        self._ended(self)


def _detect_dead_peer(sock: socket.socket) -> None:
    """Let the kernel close the connection when the peer's host does not answer."""
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPIDLE, KEEP_ALIVE_IDLE)
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPINTVL, KEEP_ALIVE_INTERVAL)
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_KEEPCNT, KEEP_ALIVE_PROBES)


def _limit_unsent(sock: socket.socket) -> None:
    """Have packets wait here, by priority and age, instead of in the kernel."""
    if hasattr(socket, "TCP_NOTSENT_LOWAT"):
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NOTSENT_LOWAT, MAX_UNSENT)


class Dialer:
    """Keeps a connection to one address, and reconnects after a growing pause.

    Packets are dropped while there is none: a command that arrives seconds late is worse than a lost one.
    """

    def __init__(
        self,
        address: Address,
        counters: Counters,
        received: Callable[[StreamLink, bytes], None],
        *,
        max_age: float = MAX_AGE,
        memory: QueueMemory | None = None,
    ) -> None:
        self.address = address
        self._max_age = max_age
        self._memory = memory
        self.link: StreamLink | None = None
        self.connected = asyncio.Event()
        self.problem = "it does not answer"
        """Reason why the last attempt failed."""
        self._counters = counters
        self._received = received
        self._lost = asyncio.Event()
        self._task = asyncio.get_running_loop().create_task(self._keep(), name=f"JTCP to {address[0]}:{address[1]}")

    def send(self, datagram: bytes) -> bool:
        """Send a checked datagram; false when it was dropped."""
        if self.link is None:
            self._counters.drop("tcp_unconnected", self.address)
            return False
        return self.link.send(datagram)

    async def close(self) -> None:
        """Close the connection, and do not reconnect."""
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)

    async def _keep(self) -> None:
        pause = MIN_RETRY_INTERVAL
        while True:
            try:
                await self._connect()
            except (OSError, TimeoutError) as error:
                self.problem = str(error) or "no answer in time"
                self._counters["tcp.connect_failed"] += 1
                _LOG.debug("no JTCP connection to %s: %s", self.address, self.problem)
            else:
                pause = MIN_RETRY_INTERVAL
                await self._until_lost()
            await asyncio.sleep(pause)
            pause = min(2 * pause, MAX_RETRY_INTERVAL)

    async def _connect(self) -> None:
        loop = asyncio.get_running_loop()
        self._lost.clear()
        async with asyncio.timeout(CONNECT_TIMEOUT):
            _, link = await loop.create_connection(
                lambda: StreamLink(
                    self._counters, self._received, self._ended, max_age=self._max_age, memory=self._memory
                ),
                *self.address,
            )
        self.link = link
        self.connected.set()
        self._counters["tcp.connected"] += 1
        _LOG.info("JTCP connection to %s", self.address)

    async def _until_lost(self) -> None:
        try:
            await self._lost.wait()
        finally:
            if self.link is not None:
                self.link.close()
            self.link = None
            self.connected.clear()

    def _ended(self, link: StreamLink) -> None:
        if link is self.link:
            self.link = None
            self.connected.clear()
        self._lost.set()
        self._counters["tcp.closed"] += 1


class TcpTransport:
    """A component's transport over a JTCP connection to a node manager at `peer`, reconnected when it is lost.

    `open` waits at most `timeout` seconds for the connection, or not at all with None.
    """

    def __init__(self, id: JausID, peer: Address, *, timeout: float | None = 5.0) -> None:
        self.id = id
        self.received: Receiver = ignore
        self.max_age = MAX_AGE
        self._peer = peer
        self._timeout = timeout
        self._counters = Counters(_LOG)
        self._dialer: Dialer | None = None

    @property
    def connected(self) -> bool:
        """True while the connection is open."""
        return self._dialer is not None and self._dialer.link is not None

    @property
    def waiting(self) -> int:
        """The number of queued datagrams."""
        return 0 if self._dialer is None or self._dialer.link is None else self._dialer.link.waiting

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""
        return self._counters

    def host_towards(self, id: JausID) -> str | None:  # noqa: ARG002 - the same for all ids
        """The host of the node manager, which routes to all components."""
        return self._peer[0]

    async def open(self) -> None:
        """Connect; raises `TransportError` if there is no connection in time."""
        dialer = self._dialer = Dialer(self._peer, self._counters, self._take, max_age=self.max_age)
        if self._timeout is None:
            return
        try:
            async with asyncio.timeout(self._timeout):
                await dialer.connected.wait()
        except BaseException as error:
            await self.close()
            if not isinstance(error, TimeoutError):
                raise
            host, port = self._peer
            raise TransportError(
                f"no JTCP connection to {host}:{port}: {dialer.problem}; start a node manager there, with `tcp = true`"
            ) from None

    async def close(self) -> None:
        """Close the connection."""
        dialer, self._dialer = self._dialer, None
        if dialer is not None:
            await dialer.close()

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; the connection is kept."""
        on_leave()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send a datagram; counted when dropped."""
        if self._dialer is None:
            self._counters.drop("closed")
            return
        try:
            for _ in judp.headers(datagram):
                pass
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        if self._dialer.send(datagram):
            self._counters["sent"] += 1

    def _take(self, _link: StreamLink, datagram: bytes) -> None:
        self._counters["received"] += 1
        self.received(datagram)
