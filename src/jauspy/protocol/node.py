"""What a node manager decides, without I/O: who gets a packet.

Packets are forwarded as the bytes they came in; only the ACK bit of a multicast for an unknown destination is set,
packets that shared a datagram are sent one by one, and older headers are adapted (see `wire`).
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Literal, TypeAlias

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import addressing, junior, wire
from jauspy.protocol.address_book import LIFETIME, AddressBook
from jauspy.protocol.compression import Compression, applies_to
from jauspy.protocol.counters import Counters
from jauspy.protocol.directory import ComponentPort, Directory
from jauspy.protocol.echoes import Echoes
from jauspy.protocol.gateway import Gateway
from jauspy.protocol.header import Broadcast, RawPacket
from jauspy.protocol.ports import LAN, GroupPort, LocalPort, NetworkPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.reports import Reports
from jauspy.protocol.sources import Sources
from jauspy.protocol.waiting import WaitingRoom

_LOGGER = logging.getLogger(__name__)

_KINDS: Final = {LocalPort: "local", UdpPort: "udp", GroupPort: "udp", TcpPort: "tcp", SerialPort: "serial"}
RECEIVED: Final[dict[type, str]] = {port: f"received.{kind}" for port, kind in _KINDS.items()}
ROUTED: Final[dict[type, str]] = {port: f"routed.{kind}" for port, kind in _KINDS.items()}


CompressionUse: TypeAlias = Literal["off", "accept", "propose"]


class NodeCore:
    """Routing between the components of this machine (`LocalPort`) and the networks (all other ports).

    `local_root` is the folder of the components' sockets. `addresses` are entries that are never forgotten; others are,
    `address_lifetime` seconds after they were heard. With `local_udp`, components of this machine may connect by UDP.
    `compression` is what is done with compressed headers on UDP.
    Packets cross from one of the `networks` to another only by a `gateway`; it and `sources` may change at run time.
    `is_dead` says whether nobody listens on a socket any more; it is asked when somebody else speaks as its component.
    `changed` is told of each id whose `shortcut` may be another now, or None for all of them.
    """

    def __init__(
        self,
        local_root: str,
        *,
        addresses: Mapping[JausID, Sequence[NetworkPort]] | None = None,
        networks: Sequence[str] = (LAN,),
        gateway: Gateway | None = None,
        sources: Sources | None = None,
        address_lifetime: float = LIFETIME,
        local_udp: bool = True,
        compression: CompressionUse = "accept",
        is_dead: Callable[[str], bool] = lambda _: False,
        changed: Callable[[int | None], None] = lambda _: None,
    ) -> None:
        self.counters = Counters(_LOGGER)
        self._changed = changed
        self.components = Directory(changed)
        static = {int(id): ports for id, ports in (addresses or {}).items()}
        self.address_book = AddressBook(static, lifetime=address_lifetime)
        self.gateway = gateway
        self.sources = sources or Sources()
        self._networks = tuple(networks)
        self._is_dead = is_dead
        self._root = local_root.rstrip("/")
        self._waiting = WaitingRoom(self.counters)
        self._output: list[tuple[Port, bytes]] = []
        self._echoes = Echoes()
        self._local_udp = local_udp
        self._dialects = wire.Dialects()
        self._compression = (
            None if compression == "off" else Compression(self.counters, self._send, probes=compression == "propose")
        )
        self._reports = Reports(_LOGGER)

    # --- upward contract -----------------------------------------------------------------------------------------

    def receive(self, data: bytes, source: Port, now: float) -> None:
        """Take one datagram from a component or from the network. Never raises; what is wrong is counted."""
        self.counters[RECEIVED[type(source)]] += 1
        try:
            if isinstance(source, LocalPort) or (isinstance(source, UdpPort) and self._is_local(data, source)):
                self._from_component(data, source, now)
            elif not isinstance(source, GroupPort):
                self._from_network(data, source, now)
        except ProtocolError as error:
            self.counters.drop(f"malformed.{error.reason}", error)

    def shortcut(self, source: int, destination: int, port: Port, now: float) -> LocalPort | UdpPort | None:
        """Where `receive` sends every plain packet between two ids that comes from `port`, whatever else is in it.

        None when it would look at more than the ids, or do more than send. Good until an id changes or for a moment,
        because limits of rates, learned addresses and their checks live on what `receive` sees.
        """
        if self.gateway is not None or self.sources.are_limited or addressing.is_wildcard(destination):
            return None
        to = self.components.port(destination)
        if isinstance(port, LocalPort) and self.components.port(source) == port:
            where = to or self.address_book.find(destination, now)
        elif self._is_settled(source, port, now):
            where = to
        else:
            return None
        if isinstance(where, LocalPort):
            return where
        if (
            isinstance(where, UdpPort)
            and where is not to
            and not (self._compression and self._compression.knows(where))
        ):
            return where
        return None

    def _is_settled(self, id: int, port: Port, now: float) -> bool:
        """True for a peer on the network that was checked and learned a moment ago."""
        if isinstance(port, LocalPort | GroupPort) or id in self.components:
            return False
        return self.sources.is_settled(id, port, now) and not (
            isinstance(port, UdpPort) and self.components.has_port(port)
        )

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
            self._multicast(wire.asking(datagram), self._where_to_ask(wire.header_of(datagram), now), now)

    @property
    def waiting_messages(self) -> int:
        """Messages that wait for unknown destinations."""
        return len(self._waiting)

    def unreachable(self, port: ComponentPort) -> None:
        """Nobody listens there any more: its components are gone until they are heard again."""
        for id in self.components.remove_port(port):
            self.counters["components.lost"] += 1
            _LOGGER.info("component %s is gone", JausID.from_int(id))

    def disconnected(self, port: NetworkPort) -> None:
        """A connection has ended: what was learned through it is asked for again."""
        self.address_book.forget(port)
        self.sources.forget(port)

    def _is_taken(self, id: int, *, besides: ComponentPort | None = None) -> bool:
        """True when a component with this id lives elsewhere; one that died without goodbye gives its id up."""
        port = self.components.port(id)
        if port is None or port == besides:
            return False
        if isinstance(port, LocalPort) and self._is_dead(port.path):
            self.unreachable(port)
            return False
        return True

    # --- from components -----------------------------------------------------------------------------------------

    def _is_local(self, data: bytes, port: UdpPort) -> bool:
        """True for a component of this machine that speaks UDP with its node manager, or begins to."""
        if self.components.has_port(port):
            return True
        return (
            self._local_udp and data[:1] == b"\x01" and port.host.startswith("127.") and junior.parse(data) is not None
        )

    def _from_component(self, data: bytes, port: ComponentPort, now: float) -> None:
        control = junior.parse(data)
        if control is not None:
            self._control(control, port, now)
            return
        for raw, datagram, _ in wire.packets(data):
            own = self._named(port, raw.source)
            if self._is_taken(raw.source, besides=own):
                self.counters.drop("duplicate_id", f"{JausID.from_int(raw.source)} also speaks on {own}")
                self._reports.twice(raw.source, own, now)
            elif self.sources.are_limited and not self.sources.within_rate(raw.source, raw.priority, now):
                self.counters.drop("rate", JausID.from_int(raw.source))
            elif self._register(raw.source, own):
                self._route_from_component(raw, datagram, now)

    def _named(self, port: ComponentPort, id: int) -> ComponentPort:
        """A component without a socket of its own name is answered at its usual path."""
        return port if port[0] else LocalPort(f"{self._root}/{id}")

    def _register(self, id: int, port: ComponentPort, *greeting: bytes) -> bool:
        news = id not in self.components
        if not self.components.register(id, port):
            self.counters.drop("component_refused", JausID.from_int(id))
            return False
        for datagram in greeting:
            self._send(port, datagram)
        if news:
            for datagram in self._waiting.found(id):
                self._deliver(port, datagram)
        return True

    def _control(self, control: junior.Control, port: ComponentPort, now: float) -> None:
        id = int(control.id)
        own = self._named(port, id)
        if control.kind is junior.ControlKind.CONNECT:
            known = self.components.port(id)
            if (
                isinstance(own, UdpPort) and isinstance(known, LocalPort) and self._is_taken(id)
            ):  # any user may send UDP, not any use a socket
                self.counters.drop("duplicate_id", f"{control.id} from {own}")
                self._reports.twice(id, own, now)
                return
            if known not in (None, own):
                self._reports.moved(id, own, now)
            if self._register(id, own, junior.accept(control.id)):
                self.counters["connects"] += 1
        elif control.kind is junior.ControlKind.CANCEL and self.components.port(id) == own:
            self.components.remove(id)
            self.counters["cancels"] += 1

    def _route_from_component(self, raw: RawPacket, datagram: bytes, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._deliver_broadcast(destination, datagram, besides=raw.source)
            if raw.broadcast != Broadcast.LOCAL:
                self._multicast(datagram, self._networks, now)
                self._copy_to_told(destination, datagram, self._networks)
        elif (own := self.components.port(destination)) is not None:
            self._deliver(own, datagram)
        elif (address := self.address_book.find(destination, now)) is not None:
            self._forward(address, destination, datagram, now)
        elif destination == 0:
            self.counters.drop("no_destination", JausID.from_int(raw.source))
        else:
            self._deliver_broadcast(destination, datagram, besides=raw.source)
            if (probe := self._waiting.add(destination, datagram, now)) is not None:
                self._multicast(wire.asking(probe), self._where_to_ask(raw, now), now)

    # --- from the network ----------------------------------------------------------------------------------------

    def _from_network(self, data: bytes, port: NetworkPort, now: float) -> None:
        if self._echoes.heard(data, port.network, now):
            self.counters["echoes"] += 1
            return
        if data[:1] == b"\x01" and junior.parse(data) is not None:
            self.counters.drop("connect_from_network", f"{port.host}:{port.port}")
            return
        if self._compression is not None and type(port) is UdpPort and applies_to(data):
            if not self._compression.knows(port):
                self._changed(None)
            data = self._compression.expand(data, port, now)
            if not data:
                return
        for raw, datagram, dialect in wire.packets(data):
            settled = self.sources.is_settled(raw.source, port, now)
            if (why := self._refusal(raw, datagram, port, now, settled=settled)) is not None:
                self.counters.drop(why, f"{JausID.from_int(raw.source)} from {port.host}:{port.port} on {port.network}")
                continue
            if dialect is not None:
                self._dialects.learn(raw.source, dialect)
            if not settled:
                self._learn(raw.source, port, now)
            self._route_from_network(raw, datagram, port.network, now)

    def _refusal(self, raw: RawPacket, datagram: bytes, port: NetworkPort, now: float, *, settled: bool) -> str | None:
        """Why a packet is not taken from this network address."""
        source = raw.source
        if self._is_taken(source):
            self._reports.twice(source, port, now)
            return "hijack"
        if not settled and not addressing.is_vague(source) and not self.sources.is_at_home(source, port, now):
            return "address_mismatch"
        if self.sources.are_limited and not self.sources.within_rate(source, raw.priority, now):
            return "rate"
        if self.gateway is not None and (why := self.gateway.refusal(raw, datagram, port.network, now)) is not None:
            return f"gateway.{why}"
        return None

    def _route_from_network(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._deliver_broadcast(destination, datagram)
            self._relay_broadcast(raw, datagram, network, now)
        elif (own := self.components.port(destination)) is not None:
            self._deliver(own, datagram)
        elif self._deliver_broadcast(destination, datagram):
            pass
        elif self.gateway is None or not (onward := self.gateway.onward(raw, network)):
            self.counters.drop("not_here", JausID.from_int(destination))
        elif (address := self.address_book.find(destination, now)) is None:
            if (probe := self._waiting.add(destination, datagram, now)) is not None:
                self._multicast(wire.asking(probe), onward, now)
        elif address.network in onward:
            self._forward(address, destination, datagram, now)
            self.counters["relayed"] += 1
        else:
            self.counters.drop("not_here", JausID.from_int(destination))

    def _relay_broadcast(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        if self.gateway is not None and (onward := self.gateway.onward(raw, network)):
            for each in self._networks:  # in a ring it comes back from any of them
                self._echoes.add(datagram, each, now)
            self._multicast(datagram, onward, now)
            self._copy_to_told(raw.destination, datagram, onward)
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
            self._changed(id)
            for datagram in self._waiting.found(id):
                if port.network in self._where_to_ask(wire.header_of(datagram), now):
                    self._forward(port, id, datagram, now)

    # --- out -----------------------------------------------------------------------------------------------------

    def _deliver(self, port: ComponentPort, datagram: bytes) -> None:
        self._send(port, datagram)
        self.counters["routed.local"] += 1

    def _deliver_broadcast(self, destination: int, datagram: bytes, *, besides: int | None = None) -> int:
        """To all components it reaches; for a complete id these are the ones that wait for an id. Returns how many."""
        reached = self.components.reached_by(destination, besides=besides)
        for port in reached:
            self._deliver(port, datagram)
        return len(reached)

    def _forward(self, port: NetworkPort, destination: int, datagram: bytes, now: float) -> None:
        if self._compression is not None and self._compression.is_used and type(port) is UdpPort:
            datagram = self._compression.shrink(datagram, port, now)
        self._send_to(port, destination, datagram)

    def _copy_to_told(self, destination: int, datagram: bytes, networks: Sequence[str]) -> None:
        """A broadcast to the addresses that the configuration names: not every network has multicast."""
        for port in self.address_book.told_about(destination):
            if port.network in networks:
                self._send_to(port, destination, datagram)

    def _send_to(self, port: NetworkPort, destination: int, datagram: bytes) -> None:
        self._send(port, self._dialects.spoken_to(destination, datagram))
        self.counters[ROUTED[type(port)]] += 1

    def _multicast(self, datagram: bytes, networks: Sequence[str], now: float) -> None:
        for network in networks:
            self._echoes.add(datagram, network, now)
            self._send(GroupPort(network), datagram)
            self.counters["routed.multicast"] += 1

    def _send(self, port: Port, datagram: bytes) -> None:
        self._output.append((port, datagram))
