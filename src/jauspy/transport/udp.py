"""A component's transport by JUDP, for example of an OCU on a machine without a node manager."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable, Mapping

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import addressing, judp
from jauspy.protocol.address_book import Address, AddressBook, IdBounds
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import RawPacket
from jauspy.protocol.registrar import IdClashes
from jauspy.protocol.sources import SourceChecks
from jauspy.transport import base, multicast, multicast as memberships
from jauspy.transport.age import MAX_AGE, DatagramReader
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.multicast import Memberships

_LOG = get_logger(__name__)


class UdpTransport:
    """Sends to the learned address of a destination, or to `peer` and `group` while none is known.

    `peer` is the UDP address of a node manager, `group` a multicast address and port, which is joined as well; at least
    one of them is needed. Multicasts are sent and received by `interface`, an IPv4 address of this machine.
    `bounds` limits the addresses that are remembered.
    """

    def __init__(
        self,
        id: JausID,
        *,
        peer: Address | None = None,
        group: Address | None = None,
        bind: Address = (multicast.ANY, 0),
        interface: str = multicast.ANY,
        bounds: IdBounds = IdBounds(),  # noqa: B008 - immutable
    ) -> None:
        self.id = id
        self.received: Receiver = ignore
        self.max_age = MAX_AGE
        self._group = group
        self._peers = [address for address in (peer, group) if address is not None]
        self._peer_host = None if peer is None else peer[0]
        self._bind = bind
        self._interface = interface
        self._book = AddressBook(bounds=bounds)
        self._sources = SourceChecks(bounds=bounds)
        self._clashes = IdClashes()
        self._counters = Counters(_LOG)
        self._socket: socket.socket | None = None
        self._group_socket: socket.socket | None = None
        self._memberships: Memberships | None = None
        self._watch: asyncio.TimerHandle | None = None

    @property
    def connected(self) -> bool:
        """True between `open` and `close`; UDP has no other state."""
        return self._socket is not None

    @property
    def waiting(self) -> int:
        """Always 0: what the kernel does not accept is dropped."""
        return 0

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""
        return self._counters

    async def open(self) -> None:
        """Bind the socket; raises `TransportError` when the address cannot be used."""
        if not self._peers:
            raise TransportError("a UDP transport needs the address of a node manager or a multicast group")
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            sock.setblocking(False)
            multicast.set_receive_buffer(sock)
            multicast.prepare_sender(sock, self._interface, judp.MULTICAST_TTL)
            sock.bind(self._bind)
        except OSError as error:
            sock.close()
            host, port = self._bind
            raise TransportError(f"cannot use UDP {host}:{port}: {error.strerror}") from error
        self._socket = sock
        self._read(sock)
        if self._group is not None:
            self._listen_to(self._group)

    async def close(self) -> None:
        """Close the sockets."""
        if self._watch is not None:
            self._watch.cancel()
        sockets = (self._socket, self._group_socket)
        self._socket = self._group_socket = self._memberships = self._watch = None
        for sock in sockets:
            if sock is not None:
                base.stop_reading(asyncio.get_running_loop(), sock)

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; the socket is kept."""
        on_leave()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send to the learned address of the destination, or to `peer` and `group`."""
        if self._socket is None:
            self._counters.drop("closed")
            return
        try:
            destination = next(judp.headers(datagram)).destination
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        known = self._book.find(destination, asyncio.get_running_loop().time())
        for address in [(known.host, known.port)] if known else self._peers:
            self._send_to(self._socket, datagram, address)

    def _read(self, sock: socket.socket) -> None:
        reader = DatagramReader(sock, self._counters, self.max_age)
        base.start_reading(asyncio.get_running_loop(), reader, self._take, self._failed)

    def _listen_to(self, group: Address) -> None:
        """Join the group; if another program has the port for itself, only unicasts are received."""
        try:
            sock = multicast.receiver(group)
        except OSError as error:
            self._counters["multicast.not_joined"] += 1
            _LOG.info("no multicasts will be received: %s", error.strerror)
            return
        self._memberships = Memberships(sock, group[0], (self._interface,))
        self._counters["multicast.not_joined"] += not self._memberships.joined
        self._group_socket = sock
        self._read(sock)
        loop = asyncio.get_running_loop()
        self._watch = loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)

    def _watch_interfaces(self) -> None:
        """Join on interfaces that have appeared."""
        if self._memberships is not None:
            self._memberships.refresh()
            loop = asyncio.get_running_loop()
            self._watch = loop.call_later(memberships.WATCH_INTERVAL, self._watch_interfaces)

    def _send_to(self, sock: socket.socket, datagram: bytes, address: Address) -> None:
        try:
            sock.sendto(datagram, address)
        except OSError as error:
            self._counters.drop("unreachable", error)
        else:
            self._counters["sent"] += 1

    def _take(self, datagram: bytes, sender: Address) -> None:
        port, now = UdpPort(*sender[:2]), asyncio.get_running_loop().time()
        try:
            refused = [raw for raw, single, _ in judp.packets(datagram) if not self._accept(raw, single, port, now)]
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        if refused:
            return
        self._counters["received"] += 1
        self.received(datagram)

    def _accept(self, raw: RawPacket, datagram: bytes, port: UdpPort, now: float) -> bool:
        """Check and learn the address of a source like a node manager; false, and counted, when it is not accepted."""
        source = raw.source
        if source == int(self.id):
            self._note_own_id(port, now, is_notice=raw.destination == source)
            return False
        if addressing.is_incomplete(source) or self._sources.is_verified(source, port, now):
            return True
        sequence = judp.sequence_number(raw, datagram)
        if not self._sources.check_address(source, port, now, sequence):
            self._counters.drop("address_mismatch", f"{JausID.from_int(source)} from {port.host}:{port.port}")
            return False
        self._sources.heard(source, port, now, sequence)
        self._book.learn(source, port, now)
        return True

    def _note_own_id(self, port: UdpPort, now: float, *, is_notice: bool) -> None:
        """Note a packet with the own id: an echo of a multicast, or another program's.

        On a host that has no address but 127.0.0.1, echoes come from 0.0.0.0, which no other host sends from.
        """
        bound_port = self._socket.getsockname()[1] if self._socket is not None else 0
        if port.port == bound_port and (port.host == multicast.ANY or port.host in multicast.own_addresses()):
            self._counters["echoes"] += 1
            return
        self._counters.drop("duplicate_id", f"{self.id} from {port.host}:{port.port}")
        notice = self._clashes.note(int(self.id), port, now, is_notice=is_notice)
        if notice is not None and self._socket is not None:
            self._send_to(self._socket, notice, (port.host, port.port))

    def host_towards(self, id: JausID) -> str | None:
        """The host of a component as it was learned, else that of the peer."""
        known = self._book.find(int(id), asyncio.get_running_loop().time())
        return known.host if known else self._peer_host

    async def id_clash(self) -> str | None:
        """The address of another program that uses this id."""
        now = asyncio.get_running_loop().time()
        return next((f"{port.host}:{port.port}" for _, port, _ in self._clashes.recent(now)), None)

    def _failed(self, error: OSError) -> None:
        self._counters.drop("socket_error", error)
