"""What a node manager decides, without I/O: who gets a packet.

Packets are forwarded as the bytes they came in; only the ACK bit of a multicast for an unknown destination is set,
and packets that shared a datagram are sent one by one.
"""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import addressing, header, judp, junior
from jauspy.protocol.address_book import AddressBook
from jauspy.protocol.counters import Counters
from jauspy.protocol.directory import Directory
from jauspy.protocol.echoes import Echoes
from jauspy.protocol.gateway import Gateway
from jauspy.protocol.header import Ack, Broadcast, RawPacket
from jauspy.protocol.ports import LAN, GroupPort, LocalPort, NetworkPort, Port, UdpPort
from jauspy.protocol.sources import Sources
from jauspy.protocol.waiting import WaitingRoom

_LOGGER = logging.getLogger(__name__)

_VERSION_BYTE: Final = bytes([header.VERSION])
_ACK_REQUIRED: Final = Ack.REQUIRED << 4
_ACK_MASK: Final = 3 << 4


class NodeCore:
    """Routing between the components of this machine (`LocalPort`) and the networks (`UdpPort`, `GroupPort`).

    `local_root` is the folder of the components' sockets; `addresses` are entries that are never forgotten. Packets
    cross from one of the `networks` to another only by a `gateway`; it and `sources` may be replaced at run time.
    """

    def __init__(
        self,
        local_root: str,
        *,
        addresses: Mapping[JausID, Sequence[NetworkPort]] | None = None,
        networks: Sequence[str] = (LAN,),
        gateway: Gateway | None = None,
        sources: Sources | None = None,
    ) -> None:
        self.counters = Counters(_LOGGER)
        self.components = Directory()
        self.address_book = AddressBook({int(id): ports for id, ports in (addresses or {}).items()})
        self.gateway = gateway
        self.sources = sources or Sources()
        self._networks = tuple(networks)
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
                self._from_network(data, source, now)
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
            raw = header.parse_header(datagram, 1)
            self._multicast(_asking(datagram), self._where_to_ask(raw, now), now)

    @property
    def waiting_messages(self) -> int:
        """Messages that wait for unknown destinations."""
        return len(self._waiting)

    def unreachable(self, path: str) -> None:
        """Nobody listens on this socket any more: its components are gone until they are heard again."""
        for id in self.components.remove_path(path):
            self.counters["components.lost"] += 1
            _LOGGER.info("component %s is gone", JausID.from_int(id))

    # --- from components -----------------------------------------------------------------------------------------

    def _from_component(self, data: bytes, port: LocalPort, now: float) -> None:
        control = junior.parse(data)
        if control is not None:
            self._control(control, port)
            return
        for raw in judp.headers(data):
            path = port.path or f"{self._root}/{raw.source}"
            if self.components.path(raw.source) not in (None, path):
                self.counters.drop("duplicate_id", f"{JausID.from_int(raw.source)} also speaks on {path}")
            elif self.sources.are_limited and not self.sources.within_rate(raw.source, raw.priority, now):
                self.counters.drop("rate", JausID.from_int(raw.source))
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
                self._multicast(datagram, self._networks, now)
        elif (path := self.components.path(destination)) is not None:
            self._deliver(path, datagram)
        elif (address := self.address_book.find(destination, now)) is not None:
            self._send(address, datagram)
            self.counters["routed.udp"] += 1
        elif destination == 0:
            self.counters.drop("no_destination", JausID.from_int(raw.source))
        elif (probe := self._waiting.add(destination, datagram, now)) is not None:
            self._multicast(_asking(probe), self._where_to_ask(raw, now), now)

    # --- from the network ----------------------------------------------------------------------------------------

    def _from_network(self, data: bytes, port: UdpPort, now: float) -> None:
        if self._echoes.heard(data, port.network, now):
            self.counters["echoes"] += 1
            return
        for raw in judp.headers(data):
            settled = self.sources.is_settled(raw.source, port, now)
            if (why := self._refusal(raw, data, port, now, settled=settled)) is not None:
                self.counters.drop(why, f"{JausID.from_int(raw.source)} from {port.host}:{port.port} on {port.network}")
                continue
            if not settled:
                self._learn(raw.source, port, now)
            self._route_from_network(raw, _single(data, raw), port.network, now)

    def _refusal(self, raw: RawPacket, data: bytes, port: NetworkPort, now: float, *, settled: bool) -> str | None:
        """Why a packet is not taken from this network address."""
        source = raw.source
        if source in self.components:
            return "hijack"
        if not settled and not addressing.is_vague(source) and not self.sources.is_at_home(source, port, now):
            return "address_mismatch"
        if self.sources.are_limited and not self.sources.within_rate(source, raw.priority, now):
            return "rate"
        if self.gateway is not None and (why := self.gateway.refusal(raw, data, port.network, now)) is not None:
            return f"gateway.{why}"
        return None

    def _route_from_network(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._deliver_broadcast(destination, datagram)
            self._relay_broadcast(raw, datagram, network, now)
        elif (path := self.components.path(destination)) is not None:
            self._deliver(path, datagram)
        elif self.gateway is None or not (onward := self.gateway.onward(raw, network)):
            self.counters.drop("not_here", JausID.from_int(destination))
        elif (address := self.address_book.find(destination, now)) is None:
            if (probe := self._waiting.add(destination, datagram, now)) is not None:
                self._multicast(_asking(probe), onward, now)
        elif address.network in onward:
            self._relay(address, datagram)
        else:
            self.counters.drop("not_here", JausID.from_int(destination))

    def _relay_broadcast(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        if self.gateway is not None and (onward := self.gateway.onward(raw, network)):
            for each in self._networks:  # in a ring it comes back from any of them
                self._echoes.add(datagram, each, now)
            self._multicast(datagram, onward, now)
            self.counters["relayed"] += 1

    def _relay(self, address: NetworkPort, datagram: bytes) -> None:
        self._send(address, datagram)
        self.counters["routed.udp"] += 1
        self.counters["relayed"] += 1

    def _where_to_ask(self, raw: RawPacket, now: float) -> tuple[str, ...]:
        """The networks where an unknown destination may be; never the one that the source is on."""
        if self.gateway is None:
            return self._networks
        home = self.address_book.find(raw.source, now)
        if home is not None:
            return self.gateway.onward(raw, home.network)
        return self.gateway.reach(raw.source, raw.destination)

    def _learn(self, id: int, port: NetworkPort, now: float) -> None:
        if addressing.is_vague(id):
            return
        if self.address_book.learn(id, port, now):
            for datagram in self._waiting.found(id):
                if port.network in self._where_to_ask(header.parse_header(datagram, 1), now):
                    self._send(port, datagram)
                    self.counters["routed.udp"] += 1

    # --- out -----------------------------------------------------------------------------------------------------

    def _deliver(self, path: str, datagram: bytes) -> None:
        self._send(LocalPort(path), datagram)
        self.counters["routed.local"] += 1

    def _deliver_broadcast(self, destination: int, datagram: bytes, *, besides: int | None = None) -> None:
        for path in self.components.reached_by(destination, besides=besides):
            self._deliver(path, datagram)

    def _multicast(self, datagram: bytes, networks: Sequence[str], now: float) -> None:
        for network in networks:
            self._echoes.add(datagram, network, now)
            self._send(GroupPort(network), datagram)
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
