"""`TesterLink`, the contract between a run and the network, and its implementations: UDP, and a node manager."""

from __future__ import annotations

import asyncio
import random
import selectors
import socket
import time
from collections import OrderedDict
from collections.abc import Collection
from typing import Final, NamedTuple, Protocol

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.transport import Transport, connect as connecting, multicast
from jauspy.transport.multicast import Memberships

RAW: Final = "raw"
"""Datagrams reach the target unchanged, including several packets in one datagram and garbage."""
PORTS: Final = "ports"
"""A client can send from a second UDP port."""


MAX_FIRST_SEQUENCE: Final = 0x7000
"""Numbers of packets that steps make themselves begin at 8000h above that of the clients, and must not meet theirs."""


def random_sequence() -> int:
    """A random start, because peers drop numbers that they have seen in the last seconds: those of an earlier run."""
    return random.SystemRandom().randrange(MAX_FIRST_SEQUENCE)


class Arrival(NamedTuple):
    """A datagram, and whether it arrived on the second UDP port."""

    data: bytes
    other_port: bool = False


class TesterLink(Protocol):
    """Carries the datagrams of all clients of a tester. Time is in seconds, real or virtual."""

    @property
    def features(self) -> Collection[str]:
        """Optional features: `RAW`, `PORTS`."""

    @property
    def first_sequence(self) -> int:
        """The first sequence number of clients, below `MAX_FIRST_SEQUENCE`."""

    def now(self) -> float:
        """Seconds of the wire's clock."""

    def join(self, id: JausID) -> None:
        """Become reachable as `id`. Raises `TransportError` if that is not possible."""

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:
        """Send as `source`; with `other_port` from a second UDP port, which is received on as well."""

    def receive(self, until: float) -> Arrival | None:
        """The next datagram; `None` if none arrives before the time is `until`."""

    def close(self) -> None:
        """Release all resources; may be called twice."""


Address = tuple[str, int]

BUFFER: Final = 65536
MAX_KNOWN: Final = 1024
"""Ids whose addresses are kept; the least recently received one is dropped first."""


class UdpLink:
    """Clients of one host. Datagrams go to `peer` if given, else to the last address of an id, else to `group`.

    `group` is listened to as well; by default it is JAUS's, on the port of the peer. `port` is the port to send from;
    if it is in use, any other is used, which the property `port` returns.
    """

    features: Collection[str] = (RAW, PORTS)

    def __init__(
        self,
        *,
        peer: Address | None = None,
        group: Address | None = None,
        port: int = judp.PORT,
        interface: str = multicast.ANY,
    ) -> None:
        self.first_sequence = random_sequence()
        self._peer = peer
        self._group = group or (judp.MULTICAST_GROUP, peer[1] if peer else judp.PORT)
        self._ids: set[int] = set()
        self._known: OrderedDict[int, Address] = OrderedDict()
        self._sockets: list[socket.socket] = []
        self._selector = selectors.DefaultSelector()
        self._usual_socket = self._heard(_sender(port, interface))
        self._other_port_socket = self._heard(_sender(0, interface))
        self.notes: list[str] = []
        """Notes for the report, such as a port that is in use."""
        if self.port != port:
            self.notes.append(f"UDP port {port} is taken on this machine; port {self.port} was used instead")
        self._listen(interface)

    @property
    def port(self) -> int:
        """The UDP port that the clients send from."""
        port: int = self._usual_socket.getsockname()[1]
        return port

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def join(self, id: JausID) -> None:
        """Replies go to the address that a message came from, so nothing needs to be announced."""
        self._ids.add(int(id))

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:  # noqa: ARG002 - one address for all
        """Send to the peer, to the last address of the destination, or to the group. Raises `TransportError`."""
        sock = self._other_port_socket if other_port else self._usual_socket
        address = self._peer or self._known.get(_destination(datagram), self._group)
        try:
            sock.sendto(datagram, address)
        except OSError as error:
            raise TransportError(f"cannot send to UDP {address[0]}:{address[1]}: {error.strerror}") from error

    def receive(self, until: float) -> Arrival | None:
        """The next datagram that is not one of the tester's own."""
        while True:
            left = max(0.0, until - time.monotonic())
            ready = self._selector.select(left)
            for key, _ in ready:
                if (datagram := self._read(key.data)) is not None:
                    return Arrival(datagram, key.data is self._other_port_socket)
            if not ready:
                return None

    def close(self) -> None:
        """Close the sockets."""
        self._selector.close()
        while self._sockets:
            self._sockets.pop().close()

    def _heard(self, sock: socket.socket) -> socket.socket:
        self._sockets.append(sock)
        self._selector.register(sock, selectors.EVENT_READ, sock)
        return sock

    def _listen(self, interface: str) -> None:
        try:
            sock = multicast.receiver(self._group)
        except OSError as error:
            self.notes.append(
                f"no multicasts are received: port {self._group[1]} is held by another user or program "
                f"({error.strerror}); the queries of a robot that searches for the tester are not received"
            )
            return
        self._heard(sock)
        if not Memberships(sock, self._group[0], (interface,)).joined:
            self.notes.append(f"the multicast group {self._group[0]} cannot be joined; is there a network?")

    def _read(self, sock: socket.socket) -> bytes | None:
        try:
            datagram, sender = sock.recvfrom(BUFFER)
        except OSError:  # an ICMP error of an earlier datagram; a missing answer is reported elsewhere
            return None
        packets, _ = judp.unpack_all(datagram)
        if any(int(packet.source) in self._ids for packet in packets):
            return None
        for packet in packets:
            if not packet.source.is_wildcard:
                self._learn(int(packet.source), sender)
        return datagram

    def _learn(self, id: int, address: Address) -> None:
        self._known[id] = address
        self._known.move_to_end(id)
        if len(self._known) > MAX_KNOWN:
            self._known.popitem(last=False)


def _sender(port: int, interface: str) -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        multicast.set_receive_buffer(sock)
        multicast.prepare_sender(sock, interface, judp.MULTICAST_TTL)
        multicast.receive_only_joined(sock)
        try:
            sock.bind((multicast.ANY, port))
        except OSError:
            sock.bind((multicast.ANY, 0))
        multicast.share_group(sock)
    except OSError as error:
        sock.close()
        raise TransportError(f"cannot use UDP on {interface}: {error.strerror}") from error
    return sock


def _destination(datagram: bytes) -> int:
    try:
        return next(judp.headers(datagram)).destination
    except (ProtocolError, StopIteration):
        return 0


MAX_WAITING: Final = 4096
"""Datagrams that the tester has not read yet; more are dropped."""


async def open_link(connect: str | None) -> TesterLink:
    """Open the wire for `connect`, as for other commands; None means multicast, even if a node manager runs.

    Datagrams of a test go directly to the target, not through a node manager, unless that is requested.
    """
    if connect is None:
        return UdpLink()
    if connect.startswith("udp://"):
        return UdpLink(peer=await connecting.udp_address(connect))
    return NodeManagerLink(connect)


class NodeManagerLink:
    """Clients as components of a node manager; runs a separate event loop while it waits."""

    features: Collection[str] = ()

    def __init__(self, connect: str) -> None:
        self.first_sequence = random_sequence()
        self._connect = connect
        self._loop = asyncio.new_event_loop()
        self._arrived: asyncio.Queue[Arrival] = asyncio.Queue(MAX_WAITING)
        self._transports: dict[JausID, Transport] = {}
        self.dropped = 0

    @property
    def notes(self) -> list[str]:
        """Notes for the report on problems of the connection."""
        dropped = f"{self.dropped} datagrams came faster than they were read, and were dropped"
        return [dropped] if self.dropped else []

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def join(self, id: JausID) -> None:
        """Attach a component; raises `TransportError` when there is no node manager."""
        self._loop.run_until_complete(self._attach(id))

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:
        """Send as the component `source`."""
        assert not other_port, "a step that needs this wants PORTS"
        self._loop.run_until_complete(self._send(datagram, source))

    def receive(self, until: float) -> Arrival | None:
        """The next datagram to any of the clients."""
        waiting = self._loop.create_task(self._next(until - time.monotonic()))
        try:
            return self._loop.run_until_complete(waiting)
        finally:
            waiting.cancel()  # after Ctrl-C it would receive the next datagram

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

    async def _send(self, datagram: bytes, source: JausID) -> None:
        self._transports[source].send(
            datagram
        )  # one that cannot send at once starts a timer, for which the loop must run

    def _take(self, datagram: bytes) -> None:
        try:
            self._arrived.put_nowait(Arrival(datagram))
        except asyncio.QueueFull:
            self.dropped += 1

    async def _next(self, seconds: float) -> Arrival | None:
        try:
            async with asyncio.timeout(max(0.0, seconds)):
                return await self._arrived.get()
        except TimeoutError:
            return None
