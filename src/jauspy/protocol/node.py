"""What a node manager decides, without I/O: who gets a packet.

Packets are forwarded as the bytes they came in; only the ACK bit of a multicast for an unknown destination is set,
and packets that shared a datagram are sent one by one.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import addressing, header, judp, junior
from jauspy.protocol.address_book import Address, AddressBook
from jauspy.protocol.counters import Counters
from jauspy.protocol.directory import Directory
from jauspy.protocol.echoes import Echoes
from jauspy.protocol.header import Ack, Broadcast, RawPacket
from jauspy.protocol.ports import GROUP, LocalPort, Port, UdpPort
from jauspy.protocol.waiting import WaitingRoom

_LOGGER = logging.getLogger(__name__)

_VERSION_BYTE: Final = bytes([header.VERSION])
_ACK_REQUIRED: Final = Ack.REQUIRED << 4
_ACK_MASK: Final = 3 << 4


class NodeCore:
    """Routing between the components of this machine (`LocalPort`) and the network (`UdpPort`, `GROUP`).

    `local_root` is the folder of the components' sockets; `addresses` are entries that are never forgotten. `is_dead`
    says whether nobody listens on a socket any more; it is asked when somebody else speaks as its component.
    """

    def __init__(
        self,
        local_root: str,
        *,
        addresses: Mapping[JausID, Address] | None = None,
        is_dead: Callable[[str], bool] = lambda _: False,
    ) -> None:
        self.counters = Counters(_LOGGER)
        self.components = Directory()
        self.address_book = AddressBook({int(id): address for id, address in (addresses or {}).items()})
        self._is_dead = is_dead
        self._root = local_root.rstrip("/")
        self._waiting = WaitingRoom(self.counters)
        self._output: list[tuple[Port, bytes]] = []
        self._echoes = Echoes()

    # --- upward contract -----------------------------------------------------------------------------------------

    def receive(self, data: bytes, source: Port, now: float) -> None:
        """Take one datagram from a component or from the network. Never raises; what is wrong is counted."""
        self.counters["received.local" if isinstance(source, LocalPort) else "received.udp"] += 1
        try:
            if isinstance(source, LocalPort):
                self._from_component(data, source, now)
            elif isinstance(source, UdpPort):
                self._from_network(data, source)
        except ProtocolError as error:
            self.counters.drop(f"malformed.{error.reason}", error)

    def poll_output(self) -> list[tuple[Port, bytes]]:
        """What is to be sent now, in order."""
        out, self._output = self._output, []
        return out

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called, or None."""
        return self._waiting.next_timeout()

    def handle_timeout(self, now: float) -> None:
        """Ask again for unknown destinations, drop what waited too long."""
        for datagram in self._waiting.handle_timeout(now):
            self._multicast(_asking(datagram))

    def unreachable(self, path: str) -> None:
        """Nobody listens on this socket any more: its components are gone until they are heard again."""
        for id in self.components.remove_path(path):
            self.counters["components.lost"] += 1
            _LOGGER.info("component %s is gone", JausID.from_int(id))

    def _is_taken(self, id: int, *, besides: str | None = None) -> bool:
        """True when a component with this id lives on another socket; one that died without goodbye gives its id up."""
        path = self.components.path(id)
        if path is None or path == besides:
            return False
        if self._is_dead(path):
            self.unreachable(path)
            return False
        return True

    # --- from components -----------------------------------------------------------------------------------------

    def _from_component(self, data: bytes, port: LocalPort, now: float) -> None:
        control = junior.parse(data)
        if control is not None:
            self._control(control, port)
            return
        for raw in judp.headers(data):
            path = port.path or f"{self._root}/{raw.source}"
            if self._is_taken(raw.source, besides=path):
                self.counters.drop("duplicate_id", f"{JausID.from_int(raw.source)} also speaks on {path}")
            elif self._register(raw.source, path):
                self._route_from_component(raw, _single(data, raw), now)

    def _register(self, id: int, path: str, *greeting: bytes) -> bool:
        news = id not in self.components
        if not self.components.register(id, path):
            self.counters.drop("component_refused", JausID.from_int(id))
            return False
        for datagram in greeting:
            self._send(LocalPort(path), datagram)
        if news:
            for datagram in self._waiting.found(id):
                self._deliver(path, datagram)
        return True

    def _control(self, control: junior.Control, port: LocalPort) -> None:
        id = int(control.id)
        path = port.path or f"{self._root}/{id}"
        if control.kind is junior.ControlKind.CONNECT:
            if self._register(id, path, junior.accept(control.id)):
                self.counters["connects"] += 1
        elif control.kind is junior.ControlKind.CANCEL and self.components.path(id) == path:
            self.components.remove(id)
            self.counters["cancels"] += 1

    def _route_from_component(self, raw: RawPacket, datagram: bytes, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._deliver_broadcast(destination, datagram, besides=raw.source)
            if raw.broadcast != Broadcast.LOCAL:
                self._multicast(datagram)
        elif (path := self.components.path(destination)) is not None:
            self._deliver(path, datagram)
        elif (address := self.address_book.find(destination)) is not None:
            self._send(UdpPort(*address), datagram)
            self.counters["routed.udp"] += 1
        elif destination == 0:
            self.counters.drop("no_destination", JausID.from_int(raw.source))
        elif (probe := self._waiting.add(destination, datagram, now)) is not None:
            self._multicast(_asking(probe))

    # --- from the network ----------------------------------------------------------------------------------------

    def _from_network(self, data: bytes, port: UdpPort) -> None:
        if data in self._echoes:
            self.counters["echoes"] += 1
            return
        for raw in judp.headers(data):
            if self._is_taken(raw.source):
                self.counters.drop("hijack", f"{JausID.from_int(raw.source)} from {port.host}:{port.port}")
                continue
            self._learn(raw.source, port)
            self._route_from_network(raw.destination, _single(data, raw))

    def _route_from_network(self, destination: int, datagram: bytes) -> None:
        if addressing.is_wildcard(destination):
            self._deliver_broadcast(destination, datagram)
        elif (path := self.components.path(destination)) is not None:
            self._deliver(path, datagram)
        else:
            self.counters.drop("not_here", JausID.from_int(destination))

    def _learn(self, id: int, port: UdpPort) -> None:
        if addressing.is_wildcard(id) or addressing.is_unassigned(id):
            return
        if self.address_book.learn(id, (port.host, port.port)):
            for datagram in self._waiting.found(id):
                self._send(port, datagram)
                self.counters["routed.udp"] += 1

    # --- out -----------------------------------------------------------------------------------------------------

    def _deliver(self, path: str, datagram: bytes) -> None:
        self._send(LocalPort(path), datagram)
        self.counters["routed.local"] += 1

    def _deliver_broadcast(self, destination: int, datagram: bytes, *, besides: int | None = None) -> None:
        for path in self.components.reached_by(destination, besides=besides):
            self._deliver(path, datagram)

    def _multicast(self, datagram: bytes) -> None:
        self._echoes.add(datagram)
        self._send(GROUP, datagram)
        self.counters["routed.multicast"] += 1

    def _send(self, port: Port, datagram: bytes) -> None:
        self._output.append((port, datagram))


def _single(data: bytes, raw: RawPacket) -> bytes:
    """The datagram of one packet: the original bytes when it came alone."""
    if raw.start == 1 and raw.end == len(data):
        return data
    return _VERSION_BYTE + data[raw.start : raw.end]


def _asking(datagram: bytes) -> bytes:
    """The same packet, asking for an ACK, by which its destination makes itself known."""
    at = header.control_offset(datagram)
    if datagram[at] & _ACK_MASK:
        return datagram
    return datagram[:at] + bytes([datagram[at] | _ACK_REQUIRED]) + datagram[at + 1 :]
