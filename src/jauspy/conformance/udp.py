"""A `Wire` over UDP, as a judge's console speaks: one socket for all clients, multicast for wildcards."""

from __future__ import annotations

import selectors
import socket
import time
from collections import OrderedDict
from collections.abc import Collection
from typing import Final

from jauspy.conformance.wire import PORTS, RAW, Arrival
from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.transport import multicast
from jauspy.transport.memberships import Memberships

Address = tuple[str, int]

BUFFER: Final = 65536
MAX_KNOWN: Final = 1024
"""Ids whose address is remembered; the one heard least recently goes first."""


class UdpWire:
    """Clients of one host. Everything goes to `peer`, or without one to where an id was heard, and else to `group`.

    `group` is listened to as well; by default it is JAUS's, on the port of the peer. `port` is the port to speak from;
    when it is taken, any other is used, which `port` then says.
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
        self._peer = peer
        self._group = group or (judp.MULTICAST_GROUP, peer[1] if peer else judp.PORT)
        self._ids: set[int] = set()
        self._known: OrderedDict[int, Address] = OrderedDict()
        self._sockets: list[socket.socket] = []
        self._selector = selectors.DefaultSelector()
        self._usual = self._heard(_sender(port, interface))
        self._strange = self._heard(_sender(0, interface))
        self.notes: list[str] = []
        """What did not work as it should, for the report."""
        if self.port != port:
            self.notes.append(f"UDP port {port} is taken on this machine; port {self.port} was used instead")
        self._listen(interface)

    @property
    def port(self) -> int:
        """The UDP port that the clients speak from."""
        port: int = self._usual.getsockname()[1]
        return port

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def join(self, id: JausID) -> None:
        """Replies go to the address that a message came from, so nothing needs to be told to anybody."""
        self._ids.add(int(id))

    def send(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:  # noqa: ARG002 - one address for all
        """Send to the peer, to where the destination was heard, or to everybody; raises `TransportError`."""
        sock = self._strange if strange_port else self._usual
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
                    return Arrival(datagram, key.data is self._strange)
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
                f"no multicasts are heard: port {self._group[1]} is held by another user or program "
                f"({error.strerror}); a robot that looks for the tester is not noticed"
            )
            return
        self._heard(sock)
        if not Memberships(sock, self._group[0], (interface,)).joined:
            self.notes.append(f"the multicast group {self._group[0]} cannot be joined; is there a network?")

    def _read(self, sock: socket.socket) -> bytes | None:
        try:
            datagram, sender = sock.recvfrom(BUFFER)
        except OSError:  # an ICMP error of an earlier datagram; silence will say so
            return None
        packets, _ = judp.unpack_all(datagram)
        if any(int(each.source) in self._ids for each in packets):
            return None
        for each in packets:
            if not each.source.is_wildcard:
                self._learn(int(each.source), sender)
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
        multicast.hold_bursts(sock)
        multicast.prepare_sender(sock, interface, judp.MULTICAST_TTL)
        multicast.hear_only_joined(sock)
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
