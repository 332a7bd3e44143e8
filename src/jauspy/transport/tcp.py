"""A component that reaches a node manager by JTCP."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Mapping
from typing import Final, cast

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import header, jtcp, judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.counters import Counters
from jauspy.transport.base import Receiver, SendQueue, ignore


HIGH_WATER: Final = 64 * 1024
"""Bytes handed to the kernel and not taken yet, from which on packets wait here, by priority and in bounds."""
READ_SIZE: Final = 2048
"""Bytes read per turn of the event loop: a hundred of the smallest packets, so that a flood delays nobody else."""
CONNECT_TIMEOUT: Final = 5.0
FIRST_RETRY: Final = 0.1
LAST_RETRY: Final = 10.0


class StreamLink(asyncio.BufferedProtocol):
    """An open connection. `took(link, datagram)` gets each packet, `ended(link)` is called once when it is closed.

    A stream that lost its boundaries is closed: nothing else brings them back. A link is bound to one version: who
    opens it greets with that of AS5669A; who was called (`began`) greets with what it has heard, before it sends.
    """

    def __init__(
        self,
        counters: Counters,
        took: Callable[[StreamLink, bytes], None],
        ended: Callable[[StreamLink], None],
        began: Callable[[StreamLink], None] | None = None,
    ) -> None:
        self.peer: Address = ("", 0)
        self.has_spoken = False
        """True when a whole packet has come."""
        self._counters = counters
        self._took = took
        self._ended = ended
        self._began = began
        self._decoder = jtcp.StreamDecoder()
        self._buffer = bytearray(READ_SIZE)
        self._greeted: int | None = None
        self._transport: asyncio.Transport | None = None
        self._paused = False
        self._waiting = SendQueue()

    @property
    def waiting(self) -> int:
        """Datagrams that wait for room."""
        return len(self._waiting)

    def send(self, datagram: bytes) -> bool:
        """Send a checked datagram, or have it wait for room; false when it cannot go this way."""
        if self._transport is None or self._transport.is_closing():
            self._counters.drop("tcp_closed", self.peer)
        elif datagram[0] != self._greet(self._transport):
            self._counters.drop("tcp_version", f"version {datagram[0]} to {self.peer}, which speaks {self._greeted}")
        elif not self._paused:
            self._transport.write(self._decoder.frame(datagram))
            return True
        else:
            for _ in range(self._waiting.push(datagram)):
                self._counters.drop("queue_full", self.peer)
            return True
        return False

    def close(self) -> None:
        """Close at once; what waits is lost."""
        if self._transport is not None:
            self._transport.abort()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Greet, or tell the owner that somebody has called."""
        self._transport = cast("asyncio.Transport", transport)
        self.peer = (transport.get_extra_info("peername") or self.peer)[:2]
        self._transport.set_write_buffer_limits(high=HIGH_WATER)
        if self._began is not None:
            self._began(self)
        else:
            self._greet(self._transport)

    def get_buffer(self, _sizehint: int) -> bytearray:
        """Where the next bytes are read to."""
        return self._buffer

    def buffer_updated(self, nbytes: int) -> None:
        """Hand up whole packets."""
        if self._transport is None or self._transport.is_closing():
            return
        datagrams, error = self._decoder.feed(bytes(self._buffer[:nbytes]))
        self.has_spoken = self.has_spoken or bool(datagrams)
        for datagram in datagrams:
            self._took(self, datagram)
        if error is not None:
            self._counters.drop(f"malformed.{error.reason}", f"{self.peer}: {error}")
            self.close()

    def _greet(self, transport: asyncio.Transport) -> int:
        """Say once which version is spoken here; returns it."""
        if self._greeted is None:
            self._greeted = self._decoder.version or header.VERSION
            transport.write(bytes([self._greeted]))
        return self._greeted

    def pause_writing(self) -> None:
        """The peer does not read: packets wait."""
        self._paused = True

    def resume_writing(self) -> None:
        """Send what waits, the most urgent first."""
        self._paused = False
        while self._waiting and not self._paused and self._transport is not None:
            datagram = self._waiting.peek()
            self._waiting.pop()
            self._transport.write(self._decoder.frame(datagram))

    def connection_lost(self, _error: Exception | None) -> None:
        """Tell the owner, and count what waited."""
        for _ in range(len(self._waiting)):
            self._counters.drop("tcp_closed", self.peer)
        self._transport, self._waiting = None, SendQueue()
        self._ended(self)


class Dialer:
    """Keeps a connection to one address: tries again after a growing pause. While there is none, packets are dropped.

    They do not wait for it: a command that comes seconds late is worse than one that does not come.
    """

    def __init__(self, address: Address, counters: Counters, took: Callable[[StreamLink, bytes], None]) -> None:
        self.address = address
        self.link: StreamLink | None = None
        self.connected = asyncio.Event()
        self.problem = "it does not answer"
        self._counters = counters
        self._took = took
        self._lost = asyncio.Event()
        self._task = asyncio.get_running_loop().create_task(self._keep(), name=f"JTCP to {address[0]}:{address[1]}")

    def send(self, datagram: bytes) -> bool:
        """Send a checked datagram; false when it was dropped."""
        if self.link is None:
            self._counters.drop("tcp_unconnected", self.address)
            return False
        return self.link.send(datagram)

    async def close(self) -> None:
        """Give up and close."""
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)

    async def _keep(self) -> None:
        pause = FIRST_RETRY
        while True:
            try:
                await self._connect()
            except (OSError, TimeoutError) as error:
                self.problem = str(error) or "no answer in time"
                self._counters["tcp.connect_failed"] += 1
                _LOGGER.debug("no JTCP connection to %s: %s", self.address, self.problem)
            else:
                pause = FIRST_RETRY
                await self._until_lost()
            await asyncio.sleep(pause)
            pause = min(2 * pause, LAST_RETRY)

    async def _connect(self) -> None:
        loop = asyncio.get_running_loop()
        self._lost.clear()
        async with asyncio.timeout(CONNECT_TIMEOUT):
            _, link = await loop.create_connection(
                lambda: StreamLink(self._counters, self._took, self._ended), *self.address
            )
        self.link = link
        self.connected.set()
        self._counters["tcp.connected"] += 1
        _LOGGER.info("JTCP connection to %s", self.address)

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


_LOGGER = logging.getLogger(__name__)


class TcpTransport:
    """One connection to `peer`, opened again when it is lost. `open` waits at most `patience` seconds for it."""

    def __init__(self, id: JausID, peer: Address, *, patience: float | None = 5.0) -> None:
        self.id = id
        self.received: Receiver = ignore
        self._peer = peer
        self._patience = patience
        self._counters = Counters(_LOGGER)
        self._dialer: Dialer | None = None

    @property
    def connected(self) -> bool:
        """True while the connection is open."""
        return self._dialer is not None and self._dialer.link is not None

    @property
    def waiting(self) -> int:
        """Datagrams that the connection has not taken yet."""
        return 0 if self._dialer is None or self._dialer.link is None else self._dialer.link.waiting

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""
        return self._counters

    async def open(self) -> None:
        """Connect; raises `TransportError` when nobody answers. With `patience=None` it does not wait."""
        dialer = self._dialer = Dialer(self._peer, self._counters, self._take)
        if self._patience is None:
            return
        try:
            await asyncio.wait_for(dialer.connected.wait(), self._patience)
        except BaseException as error:
            await self.close()
            if not isinstance(error, TimeoutError):
                raise
            host, port = self._peer
            raise TransportError(
                f"no JTCP connection to {host}:{port}: {dialer.problem}; "
                "start a node manager there, with TCP switched on"
            ) from None

    async def close(self) -> None:
        """Close the connection."""
        dialer, self._dialer = self._dialer, None
        if dialer is not None:
            await dialer.close()

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Be another component; the way to it stays the same."""
        goodbye()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count."""
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
