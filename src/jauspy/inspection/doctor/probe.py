"""Queries by UDP from sockets of its own: what was answered, by whom, from where, and how far away."""

from __future__ import annotations

import errno
import secrets
import select
import socket
import struct
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple, Self

from jauspy.capture.dissect import Content, read_message
from jauspy.codec.message import Message
from jauspy.codec.registry import NO_HINTS
from jauspy.ids import EVERYONE, JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryIdentification
from jauspy.protocol import header, judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet
from jauspy.transport import multicast

REPEAT: Final = 0.3
"""Seconds after which a query is sent once more; a single datagram may be lost."""
MAX_DATAGRAM: Final = 1 << 16
MAX_REPLIES: Final = 4096
"""Replies that are kept; further ones are counted only."""
_IP_RECVTTL: Final = 12
_IP_RECVERR: Final = 11
_MSG_ERRQUEUE: Final = 0x2000
"""Socket options of linux/in.h and linux/socket.h; Python has no names for them."""


class Reply(NamedTuple):
    """A message that a query was answered with."""

    source: JausID
    address: Address
    """Where it came from."""
    ttl: int | None
    """Routers that the datagram could still have passed."""
    content: Content
    interface: str
    """The address of this machine at which it arrived."""


@dataclass(slots=True)
class Fragments:
    """Parts of one large message that has not become complete."""

    first: int = 0
    others: int = 0
    last: int = 0


class Probe:
    """Sockets of the doctor, one for each interface, each with an id of its own, so that answers tell the interface.

    `group_heard` are the senders of multicasts that arrived, with their TTL; `own_multicast` the interfaces whose own
    multicasts came back, so that nothing on this machine filters them.
    """

    def __init__(self, ids: Sequence[JausID], interfaces: Sequence[str], group: str, port: int) -> None:
        self.group = (group, port)
        self.replies: list[Reply] = []
        self.not_kept = 0
        self.errors: dict[str, str] = {}
        """Why sending failed, by address of the interface."""
        self.unreachable: dict[Address, int] = {}
        """Addresses that a machine on the way, or the peer's, has reported as unreachable, with the error number."""
        self.group_heard: dict[Address, int | None] = {}
        self.own_multicast: set[str] = set()
        self.group_problem = ""
        self.fragments: dict[JausID, Fragments] = {}
        self.malformed: dict[Address, str] = {}
        self._sockets: dict[socket.socket, str] = {}
        self._endpoints: dict[str, Endpoint] = {}
        self._group_socket: socket.socket | None = None
        for id, interface in zip(ids, interfaces, strict=False):
            self._open(id, interface)
        self._join(interfaces)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        for sock in [*self._sockets, *([self._group_socket] if self._group_socket else ())]:
            sock.close()

    @property
    def interfaces(self) -> list[str]:
        """The addresses of the interfaces that could be used."""
        return list(self._sockets.values())

    def id_at(self, interface: str) -> JausID:
        """The doctor's id on an interface."""
        return self._endpoints[interface].id

    def discover(self, seconds: float) -> None:
        """Ask everybody by multicast on all interfaces, twice, and listen."""
        query = QueryIdentification(QueryIdentification.QueryType.COMPONENT)
        half = min(REPEAT, seconds / 2.0)
        for wait in (half, seconds - half):
            for interface in self.interfaces:
                self.send(query, EVERYONE, self.group, interface)
            self.listen(wait)

    def ask(
        self,
        queries: Iterable[Message],
        to: JausID,
        address: Address,
        interface: str,
        seconds: float,
        *,
        padding: int = 0,
        enough: Callable[[list[Reply]], bool] = bool,
    ) -> list[Reply]:
        """Send queries to one address, a second time if need be, until the answers are `enough` or the time is over.

        `padding` bytes, in a second packet of the datagram that is addressed to the doctor itself, make it so large
        that IP fragments it.
        """
        known = len(self.replies)
        pending = list(queries)
        half = min(REPEAT, seconds / 2.0)
        for wait in (half, seconds - half):
            for query in pending:
                self.send(query, to, address, interface, padding=padding)
            self.listen(wait, until=lambda: enough(self.replies[known:]))
            if enough(self.replies[known:]):
                break
        return self.replies[known:]

    def send(self, query: Message, to: JausID, address: Address, interface: str, *, padding: int = 0) -> None:
        """Send a query, and note why it could not be sent."""
        endpoint = self._endpoints[interface]
        broadcast = Broadcast.GLOBAL if to.is_wildcard else Broadcast.NONE
        endpoint.send(to, query.encode(), now=time.monotonic(), broadcast=broadcast, ack=Ack.NONE)
        self._flush(interface, address, padding)

    def listen(self, seconds: float, until: Callable[[], bool] = lambda: False) -> None:
        """Receive for a time, or until a condition holds."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0 and not until():
            sockets = [*self._sockets, *([self._group_socket] if self._group_socket else ())]
            for sock in select.select(sockets, [], [], left)[0]:
                self._read(sock)

    def _open(self, id: JausID, interface: str) -> None:
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            sock.setblocking(False)
            multicast.prepare_sender(sock, interface, judp.MULTICAST_TTL)
            sock.setsockopt(socket.IPPROTO_IP, _IP_RECVTTL, 1)
            sock.setsockopt(socket.IPPROTO_IP, _IP_RECVERR, 1)
            sock.bind((interface, 0))
        except OSError as error:
            sock.close()
            self.errors[interface] = error.strerror or str(error)
            return
        self._sockets[sock] = interface
        self._endpoints[interface] = Endpoint(id, first_sequence=secrets.randbelow(1 << 16))

    def _join(self, interfaces: Sequence[str]) -> None:
        try:
            sock = multicast.receiver(self.group)
        except OSError as error:
            self.group_problem = error.strerror or str(error)
            return
        sock.setsockopt(socket.IPPROTO_IP, _IP_RECVTTL, 1)
        for interface in interfaces:
            try:
                membership = socket.inet_aton(self.group[0]) + socket.inet_aton(interface)
                sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
            except OSError as error:
                if error.errno != errno.EADDRINUSE:  # another address of the same interface
                    self.group_problem = error.strerror or str(error)
        self._group_socket = sock

    def _flush(self, interface: str, address: Address, padding: int = 0) -> None:
        sock = next(sock for sock, name in self._sockets.items() if name == interface)
        for datagram in self._endpoints[interface].poll_output():
            for last_attempt in (False, True):
                try:
                    sock.sendto(datagram + self._padding(interface, padding), address)
                except OSError as error:
                    # An error that was reported for an earlier datagram is returned instead of sending this one.
                    if self._read_errors(sock) and not last_attempt:
                        continue
                    self.errors[interface] = error.strerror or str(error)
                break

    def _padding(self, interface: str, size: int) -> bytes:
        own = self.id_at(interface)
        return header.pack(Packet(own, own, bytes(size))) if size else b""

    def _read(self, sock: socket.socket) -> None:
        try:
            datagram, ancillary, _, sender = sock.recvmsg(MAX_DATAGRAM, 64)
        except OSError:
            self._read_errors(sock)
            return
        address, ttl = (str(sender[0]), int(sender[1])), _ttl(ancillary)
        if sock is self._group_socket:
            self._note_multicast(datagram, address, ttl)
            return
        interface = self._sockets[sock]
        endpoint = self._endpoints[interface]
        self._note_fragments(datagram, address)
        now = time.monotonic()
        endpoint.receive(datagram, now)
        while (packet := endpoint.next_event()) is not None:
            if len(self.replies) >= MAX_REPLIES:
                self.not_kept += 1
                continue
            content = read_message(bytes(packet.payload), registry, NO_HINTS)
            self.replies.append(Reply(packet.source, address, ttl, content, interface))
        self._flush(interface, address)

    def _read_errors(self, sock: socket.socket) -> bool:
        """Read what the kernel has queued about earlier datagrams; true if there was anything."""
        found = False
        while True:
            try:
                _, ancillary, _, destination = sock.recvmsg(0, 256, _MSG_ERRQUEUE)
            except OSError:
                return found
            found = True
            for level, kind, data in ancillary:
                if level == socket.IPPROTO_IP and kind == _IP_RECVERR and destination and len(data) >= 4:
                    self.unreachable[str(destination[0]), int(destination[1])] = struct.unpack_from("=I", data)[0]

    def _note_multicast(self, datagram: bytes, address: Address, ttl: int | None) -> None:
        own = {(name, sock.getsockname()[1]): name for sock, name in self._sockets.items()}
        if address in own:
            self.own_multicast.add(own[address])
        elif len(self.group_heard) < MAX_REPLIES and judp.unpack_all(datagram)[0]:
            self.group_heard[address] = ttl

    def _note_fragments(self, datagram: bytes, address: Address) -> None:
        packets, errors = judp.unpack_all(datagram)
        for packet in packets:
            if packet.data_flag is DataFlag.SINGLE or len(self.fragments) >= MAX_REPLIES:
                continue
            seen = self.fragments.setdefault(packet.source, Fragments())
            seen.first += packet.data_flag is DataFlag.FIRST
            seen.others += packet.data_flag is DataFlag.MIDDLE
            seen.last += packet.data_flag is DataFlag.LAST
        if errors and len(self.malformed) < MAX_REPLIES:
            self.malformed[address] = str(errors[0])


def _ttl(ancillary: Iterable[tuple[int, int, bytes]]) -> int | None:
    """The TTL of a datagram, from what the kernel tells beside it."""
    for level, kind, data in ancillary:
        if level == socket.IPPROTO_IP and kind == socket.IP_TTL and len(data) >= 4:
            return int(struct.unpack_from("=i", data)[0])
    return None
