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
from jauspy.protocol.address_book import ADDRESS_LIFETIME, AddressBook
from jauspy.protocol.addressing import DEFAULT_NETWORK, GroupPort, LocalPort, NetworkPort, Port, UdpPort
from jauspy.protocol.compression import Compression, applies_to
from jauspy.protocol.counters import Counters
from jauspy.protocol.egress import PORT_KINDS, EgressQueue
from jauspy.protocol.gateway import Gateway
from jauspy.protocol.header import Broadcast, RawPacket
from jauspy.protocol.pending import PendingDestinations
from jauspy.protocol.registrar import ComponentDirectory, ComponentPort, DuplicateIdLog, Registrar
from jauspy.protocol.sources import SourceChecks

_LOGGER = logging.getLogger(__name__)

RECEIVED_COUNTERS: Final[dict[type, str]] = {port: f"received.{kind}" for port, kind in PORT_KINDS.items()}

CompressionUse: TypeAlias = Literal["off", "accept", "propose"]


class Router:
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
        networks: Sequence[str] = (DEFAULT_NETWORK,),
        gateway: Gateway | None = None,
        sources: SourceChecks | None = None,
        address_lifetime: float = ADDRESS_LIFETIME,
        local_udp: bool = True,
        compression: CompressionUse = "accept",
        is_dead: Callable[[str], bool] = lambda _: False,
        changed: Callable[[int | None], None] = lambda _: None,
    ) -> None:
        self.counters = Counters(_LOGGER)
        self._changed = changed
        self.components = ComponentDirectory(changed)
        static = {int(id): ports for id, ports in (addresses or {}).items()}
        self.address_book = AddressBook(static, lifetime=address_lifetime)
        self.gateway = gateway
        self.sources = sources or SourceChecks()
        self._networks = tuple(networks)
        self._waiting = PendingDestinations(self.counters)
        self._out = EgressQueue(self.counters, self.components, self.address_book)
        if compression != "off":
            self._out.compression = Compression(self.counters, self._out.send, probes=compression == "propose")
        self._reports = DuplicateIdLog(_LOGGER)
        self._registrar = Registrar(
            local_root,
            self.components,
            self._out,
            self._waiting,
            self.counters,
            reports=self._reports,
            is_dead=is_dead,
            local_udp=local_udp,
        )

    # --- upward contract -----------------------------------------------------------------------------------------

    def receive(self, data: bytes, source: Port, now: float) -> None:
        """Take one datagram from a component or from the network. Never raises; what is wrong is counted."""
        self.counters[RECEIVED_COUNTERS[type(source)]] += 1
        try:
            if isinstance(source, LocalPort) or (
                isinstance(source, UdpPort) and self._registrar.is_local(data, source)
            ):
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
            and not (self._out.compression and self._out.compression.knows(where))
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
        return self._out.drain()

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called, or None."""
        return self._waiting.next_timeout()

    def handle_timeout(self, now: float) -> None:
        """Ask again for unknown destinations, drop what waited too long."""
        for datagram in self._waiting.handle_timeout(now):
            self._out.multicast(
                wire.with_ack_required(datagram), self._where_to_ask(wire.header_of(datagram), now), now
            )

    @property
    def waiting_messages(self) -> int:
        """Messages that wait for unknown destinations."""
        return len(self._waiting)

    def unreachable(self, port: ComponentPort) -> None:
        """Nobody listens there any more: its components are gone, and who was heard there is asked for again."""
        self._registrar.unreachable(port)
        if isinstance(port, UdpPort):
            self.address_book.forget(port)

    def disconnected(self, port: NetworkPort) -> None:
        """A connection has ended: what was learned through it is asked for again."""
        self.address_book.forget(port)
        self.sources.forget(port)

    # --- from components -----------------------------------------------------------------------------------------

    def _from_component(self, data: bytes, port: ComponentPort, now: float) -> None:
        control = junior.parse(data)
        if control is not None:
            self._registrar.control(control, port, now)
            return
        for raw, datagram, _ in wire.packets(data):
            own = self._registrar.named(port, raw.source)
            if self._registrar.is_taken(raw.source, besides=own):
                self.counters.drop("duplicate_id", f"{JausID.from_int(raw.source)} also speaks on {own}")
                self._reports.twice(raw.source, own, now)
            elif self.sources.are_limited and not self.sources.within_rate(raw.source, raw.priority, now):
                self.counters.drop("rate", JausID.from_int(raw.source))
            elif self._registrar.register(raw.source, own):
                self._route_from_component(raw, datagram, now)

    def _route_from_component(self, raw: RawPacket, datagram: bytes, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._out.deliver_broadcast(destination, datagram, besides=raw.source)
            if raw.broadcast != Broadcast.LOCAL:
                self._out.multicast(datagram, self._networks, now)
                self._out.copy_to_told(destination, datagram, self._networks)
        elif (own := self.components.port(destination)) is not None:
            self._out.deliver(own, datagram)
        elif (address := self.address_book.find(destination, now)) is not None:
            self._out.forward(address, destination, datagram, now)
        elif destination == 0:
            self.counters.drop("no_destination", JausID.from_int(raw.source))
        else:
            self._out.deliver_broadcast(destination, datagram, besides=raw.source)
            if (probe := self._waiting.add(destination, datagram, now)) is not None:
                self._out.multicast(wire.with_ack_required(probe), self._where_to_ask(raw, now), now)

    # --- from the network ----------------------------------------------------------------------------------------

    def _from_network(self, data: bytes, port: NetworkPort, now: float) -> None:
        if self._out.echoes.heard(data, port.network, now):
            self.counters["echoes"] += 1
            return
        if data[:1] == b"\x01" and junior.parse(data) is not None:
            self.counters.drop("connect_from_network", f"{port.host}:{port.port}")
            return
        if self._out.compression is not None and type(port) is UdpPort and applies_to(data):
            if not self._out.compression.knows(port):
                self._changed(None)
            data = self._out.compression.expand(data, port, now)
            if not data:
                return
        for raw, datagram, dialect in wire.packets(data):
            settled = self.sources.is_settled(raw.source, port, now)
            if (why := self._refusal(raw, datagram, port, now, settled=settled)) is not None:
                self.counters.drop(why, f"{JausID.from_int(raw.source)} from {port.host}:{port.port} on {port.network}")
                continue
            if dialect is not None:
                self._out.dialects.learn(raw.source, dialect)
            if not settled:
                self._learn(raw.source, port, now)
            self._route_from_network(raw, datagram, port.network, now)

    def _refusal(self, raw: RawPacket, datagram: bytes, port: NetworkPort, now: float, *, settled: bool) -> str | None:
        """Why a packet is not taken from this network address."""
        source = raw.source
        if self._registrar.is_taken(source):
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
            self._out.deliver_broadcast(destination, datagram)
            self._relay_broadcast(raw, datagram, network, now)
        elif (own := self.components.port(destination)) is not None:
            self._out.deliver(own, datagram)
        elif self._out.deliver_broadcast(destination, datagram):
            pass
        elif self.gateway is None or not (onward := self.gateway.onward(raw, network)):
            self.counters.drop("not_here", JausID.from_int(destination))
        elif (address := self.address_book.find(destination, now)) is None:
            if (probe := self._waiting.add(destination, datagram, now)) is not None:
                self._out.multicast(wire.with_ack_required(probe), onward, now)
        elif address.network in onward:
            self._out.forward(address, destination, datagram, now)
            self.counters["relayed"] += 1
        else:
            self.counters.drop("not_here", JausID.from_int(destination))

    def _relay_broadcast(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        if self.gateway is not None and (onward := self.gateway.onward(raw, network)):
            for each in self._networks:  # in a ring it comes back from any of them
                self._out.echoes.add(datagram, each, now)
            self._out.multicast(datagram, onward, now)
            self._out.copy_to_told(raw.destination, datagram, onward)
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
                    self._out.forward(port, id, datagram, now)
