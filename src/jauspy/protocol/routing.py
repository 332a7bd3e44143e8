"""Decides the destinations of packets that a node manager has received (sans I/O).

Packets are forwarded as the bytes they came in, with three exceptions: the ACK bit of a multicast for an unknown
destination is set, packets that shared a datagram are sent one by one, and legacy headers are converted (see
`judp.packets`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Literal, NamedTuple, TypeAlias

from jauspy.errors import ProtocolError
from jauspy.ids import JausID, message_id
from jauspy.logs import get_logger
from jauspy.protocol import addressing, judp, junior
from jauspy.protocol.address_book import (
    ADDRESS_LIFETIME,
    MAX_COMPONENTS,
    AddressBook,
    ComponentDirectory,
    ComponentPort,
    IdBounds,
)
from jauspy.protocol.addressing import DEFAULT_NETWORK, GroupPort, LocalPort, NetworkPort, Port, UdpPort
from jauspy.protocol.compression import Compression, is_compressed
from jauspy.protocol.counters import Counters
from jauspy.protocol.egress import PORT_KINDS, EgressQueue
from jauspy.protocol.gateway import Gateway
from jauspy.protocol.header import Ack, Broadcast, RawPacket
from jauspy.protocol.link_limits import LinkLimits
from jauspy.protocol.pending import PendingDestinations
from jauspy.protocol.registrar import DuplicateIdLog, IdClashes, Registrar
from jauspy.protocol.sources import SourceChecks, TokenBuckets

_LOG = get_logger(__name__)

VAGUE_RATE: Final = 100.0
"""Messages per second (and burst) that are multicast for ids with zeros: no address can be learned for them."""
RECEIVED_COUNTERS: Final[dict[type, str]] = {port: f"received.{kind}" for port, kind in PORT_KINDS.items()}

CompressionUse: TypeAlias = Literal["off", "accept", "propose"]


def _asks_for_id(raw: RawPacket, datagram: bytes) -> bool:
    """True for a broadcast request for an id, which is answered by broadcast: nothing is sent to its source."""
    is_request = (
        len(datagram) >= raw.payload_start + 2 and message_id(datagram, raw.payload_start) in addressing.ID_REQUESTS
    )
    return is_request and raw.ack == Ack.NONE and addressing.is_wildcard(raw.destination)


class BroadcastRoute(NamedTuple):
    """The components of this machine that a broadcast is for, and the networks by whose groups it is sent."""

    components: tuple[LocalPort, ...]
    networks: tuple[str, ...]


class Router:
    """Routes between the components of this machine (`LocalPort`) and the networks (all other ports).

    Args:
        local_root: The directory of the components' sockets.
        addresses: Static addresses, which never expire; learned ones expire after `address_lifetime` seconds.
        bounds: How many learned addresses are remembered.
        networks: The names of all networks. Packets cross from one to another only through a `gateway`.
        gateway, sources: Filters of received packets; both may be replaced at run time.
        local_udp: Whether components of this machine may connect by UDP.
        may_connect: True for a UDP port whose user may connect.
        is_abandoned: True for an address of this machine that nobody uses any more who could have connected.
        own_ids: Ids of this machine, which may have wildcards; they are not accepted from networks.
        limits: What networks and serial lines carry of each message.
        compression: The use of header compression on UDP.
        max_message_age: Seconds for which a message that is not acknowledged may wait for its destination.
        is_dead: True for the path of a socket where nobody listens any more.
        max_sockets: The number of local sockets that components may have.
        changed: Called with each id whose `cacheable_route` may have changed, or with None for all ids.
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
        bounds: IdBounds = IdBounds(),  # noqa: B008 - immutable
        local_udp: bool = True,
        may_connect: Callable[[UdpPort], bool] = lambda _: True,
        is_abandoned: Callable[[NetworkPort], bool] = lambda _: False,
        own_ids: Sequence[JausID] = (),
        limits: LinkLimits | None = None,
        compression: CompressionUse = "accept",
        max_message_age: float = math.inf,
        is_dead: Callable[[str], bool] = lambda _: False,
        max_sockets: int = MAX_COMPONENTS,
        changed: Callable[[int | None], None] = lambda _: None,
    ) -> None:
        self.counters = Counters(_LOG)
        self._changed = changed
        self.components = ComponentDirectory(changed, max_sockets=max_sockets)
        static = {int(id): ports for id, ports in (addresses or {}).items()}
        self.address_book = AddressBook(static, bounds=bounds, lifetime=address_lifetime)
        self.gateway = gateway
        self.sources = sources or SourceChecks()
        self._networks = tuple(networks)
        self._pending = PendingDestinations(self.counters, max_message_age)
        self.limits = limits or LinkLimits({})
        self._egress = EgressQueue(self.counters, self.components, self.address_book, self.limits)
        if compression != "off":
            self._egress.compression = Compression(self.counters, self._egress.send, probes=compression == "propose")
        self._duplicate_ids = DuplicateIdLog(_LOG)
        self.clashes = IdClashes()
        """Ids of components of this machine that other machines use."""
        self._vague = TokenBuckets(VAGUE_RATE, VAGUE_RATE)
        self._registrar = Registrar(
            local_root,
            self.components,
            self._egress,
            self._pending,
            self.counters,
            duplicate_ids=self._duplicate_ids,
            is_dead=is_dead,
            local_udp=local_udp,
            may_connect=may_connect,
            holder=self._holder,
        )
        self._is_abandoned = is_abandoned
        self._own_ids = tuple(map(int, own_ids))

    def receive(self, data: bytes, source: Port, now: float) -> None:
        """Route one datagram from a component or a network. Never raises; malformed input is counted."""
        self.counters[RECEIVED_COUNTERS[type(source)]] += 1
        control = junior.parse(data)
        try:
            if isinstance(source, LocalPort) or (
                isinstance(source, UdpPort) and self._registrar.is_local(source, control)
            ):
                if control is not None:
                    self._registrar.handle_control(control, source, now)
                else:
                    self._from_component(data, source, now)
            elif isinstance(source, GroupPort):
                return
            elif control is not None:
                self.counters.drop("connect_from_network", f"{source.host}:{source.port}")
            else:
                self._from_network(data, source, now)
        except ProtocolError as error:
            self.counters.drop(f"malformed.{error.reason}", error)

    def poll_output(self) -> list[tuple[Port, bytes]]:
        """The datagrams to send now, in order."""
        return self._egress.drain()

    def next_timeout(self) -> float | None:
        """Time at which `handle_timeout` is to be called, or None."""
        return self._pending.next_timeout()

    def handle_timeout(self, now: float) -> None:
        """Probe again for unknown destinations, and drop messages that waited too long."""
        for datagram in self._pending.handle_timeout(now):
            self._probe(datagram, self._probe_networks(judp.first_header(datagram), now), now)

    @property
    def pending_messages(self) -> int:
        """The number of messages that wait for unknown destinations."""
        return len(self._pending)

    def remove_dead(self, port: ComponentPort) -> None:
        """Remove the components and learned addresses of a port where nobody listens any more."""
        self._registrar.remove_dead(port)
        if isinstance(port, UdpPort):
            for id in self.address_book.forget(port):
                self._changed(id)

    def disconnected(self, port: NetworkPort) -> None:
        """Remove the addresses learned from a connection that has ended."""
        self.address_book.forget(port)
        self.sources.forget(port)

    def cacheable_route(self, source: int, destination: int, port: Port, now: float) -> LocalPort | UdpPort | None:
        """Route of every plain packet of these ids from `port`; None if each must pass through `receive`.

        The route holds until `changed` is called for one of the ids, and for a moment at most: rate limits, learned
        addresses and their checks need to see packets in `receive`.
        """
        if self.gateway is not None or self.sources.are_limited or addressing.is_wildcard(destination):
            return None
        component = self.components.port(destination)
        if isinstance(port, LocalPort):
            if self.components.port(source) != port:
                return None
            route = component or self.address_book.find(destination, now)
        elif self._is_verified_peer(source, port, now):
            route = component
        else:
            return None
        if isinstance(route, LocalPort):
            return route
        if not isinstance(route, UdpPort) or route is component or self.limits.apply_to(route.network):
            return None
        compression = self._egress.compression
        return None if compression is not None and compression.applies_to(route) else route

    def cacheable_broadcast(self, source: int, destination: int, broadcast: int, port: Port) -> BroadcastRoute | None:
        """Route of every plain broadcast of these ids from `port`; None if each must pass through `receive`.

        `broadcast` is the field of the header. The route holds until `changed` is called for any id, and for a moment
        at most.
        """
        if self.gateway is not None or self.sources.are_limited or addressing.is_wildcard(source):
            return None
        if not isinstance(port, LocalPort) or self.components.port(source) != port:
            return None
        components = self.components.matching(destination, exclude=source)
        if not components:
            return None
        if broadcast == Broadcast.LOCAL:
            networks: tuple[str, ...] = ()
        elif self.address_book.static_matching(destination) or any(map(self.limits.apply_to, self._networks)):
            return None
        else:
            networks = self._networks
        local = tuple(found for found in components if isinstance(found, LocalPort))
        return BroadcastRoute(local, networks) if len(local) == len(components) else None

    def note_multicast(self, datagram: bytes, network: str, now: float) -> None:
        """Count a multicast that is sent by a `BroadcastRoute`, and recognise it when the network returns it."""
        self._egress.echoes.add(datagram, network, now)
        self.counters["routed.multicast"] += 1

    def _is_verified_peer(self, id: int, port: Port, now: float) -> bool:
        """True for a peer on a network whose address was checked and learned a moment ago."""
        if isinstance(port, LocalPort | GroupPort) or id in self.components:
            return False
        if isinstance(port, UdpPort) and self.components.has_port(port):
            return False
        return self.sources.is_verified(id, port, now)

    # --- from components -----------------------------------------------------------------------------------------

    def _from_component(self, data: bytes, port: ComponentPort, now: float) -> None:
        for raw, datagram, _ in judp.packets(data):
            sender = self._registrar.reply_port(port, raw.source)
            if self._registrar.is_in_use(raw.source, elsewhere_than=sender):
                self.counters.drop("duplicate_id", f"{JausID.from_int(raw.source)} also sends from {sender}")
                self._duplicate_ids.warn_duplicate(raw.source, sender)
            elif self.sources.are_limited and not self.sources.within_rate(raw.source, raw.priority, now):
                self.counters.drop("rate", JausID.from_int(raw.source))
            elif raw.ack == Ack.REQUIRED and addressing.is_wildcard(raw.source):
                self.counters.drop("wildcard_source", f"{JausID.from_int(raw.source)}: an ACK would go to all")
            elif self._registrar.register(raw.source, sender, now):
                self._route_from_component(raw, datagram, now)

    def _route_from_component(self, raw: RawPacket, datagram: bytes, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._egress.deliver_broadcast(destination, datagram, exclude=raw.source)
            if raw.broadcast != Broadcast.LOCAL:
                carried = self._egress.multicast(datagram, self._networks, now)
                self._egress.broadcast_to_static(destination, datagram, carried)
        elif (component := self.components.port(destination)) is not None:
            self._egress.deliver(component, datagram)
        elif (address := self.address_book.find(destination, now)) is not None:
            self._egress.forward(address, destination, datagram, now)
            if raw.broadcast == Broadcast.GLOBAL:  # the sender does not trust the address: the id may have moved
                self._egress.multicast(datagram, self._networks, now)
        elif destination == 0:
            self.counters.drop("no_destination", JausID.from_int(raw.source))
        else:
            self._egress.deliver_broadcast(destination, datagram, exclude=raw.source)
            self._search(raw, datagram, self._probe_networks(raw, now), now)

    # --- from networks -------------------------------------------------------------------------------------------

    def _from_network(self, data: bytes, port: NetworkPort, now: float) -> None:
        if self._egress.echoes.seen(data, port.network, now):
            self.counters["echoes"] += 1
            return
        compression = self._egress.compression
        if compression is not None and type(port) is UdpPort and is_compressed(data):
            if not compression.applies_to(port):
                self._changed(None)
            data = compression.expand(data, port, now)
            if not data:
                return
        for raw, datagram, legacy_version in judp.packets(data):
            verified = self.sources.is_verified(raw.source, port, now)
            sequence = None if verified else judp.sequence_number(raw, datagram)
            if (why := self._refusal(raw, datagram, port, now, sequence, verified=verified)) is not None:
                self.counters.drop(why, f"{JausID.from_int(raw.source)} from {port.host}:{port.port} on {port.network}")
                continue
            if legacy_version is not None:
                self._egress.peer_versions.learn(raw.source, legacy_version)
            if not verified:
                self._learn(raw.source, port, now, sequence)
            self._route_from_network(raw, datagram, port.network, now)

    def _refusal(
        self, raw: RawPacket, datagram: bytes, port: NetworkPort, now: float, sequence: int | None, *, verified: bool
    ) -> str | None:
        """Reason to refuse a packet from this address, as a counter's name; None if it is accepted."""
        source = raw.source
        if not verified and addressing.is_wildcard(source) and not _asks_for_id(raw, datagram):
            return "wildcard_source"
        if (in_use := self._registrar.is_in_use(source)) or (not verified and self._is_own(source)):
            self._duplicate_ids.warn_duplicate(source, port)
            if in_use:
                notice = self.clashes.note(source, port, now, is_notice=raw.destination == source)
                if notice is not None:
                    self._egress.send(port, notice)
            return "hijack"
        is_checked = not verified and not addressing.is_incomplete(source)
        if is_checked and not self.sources.check_address(source, port, now, sequence):
            if self.sources.has_new_claim(source, now):
                self._changed(source)
            return "address_mismatch"
        if self.sources.are_limited and not self.sources.within_rate(source, raw.priority, now):
            return "rate"
        if self.gateway is not None and (why := self.gateway.refusal(raw, datagram, port.network, now)) is not None:
            return f"gateway.{why}"
        return None

    def _route_from_network(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        destination = raw.destination
        if addressing.is_wildcard(destination):
            self._egress.deliver_broadcast(destination, datagram)
            self._relay_broadcast(raw, datagram, network, now)
        elif (component := self.components.port(destination)) is not None:
            self._egress.deliver(component, datagram)
        elif self._egress.deliver_broadcast(destination, datagram):
            pass
        elif self.gateway is None or not (onward := self.gateway.onward(raw, network)):
            self.counters.drop("not_here", JausID.from_int(destination))
        elif (address := self.address_book.find(destination, now)) is None:
            self._search(raw, datagram, onward, now, relayed=True)
        elif address.network in onward:
            self.counters["relayed"] += self._egress.forward(address, destination, datagram, now)
        else:
            self.counters.drop("not_here", JausID.from_int(destination))

    def _relay_broadcast(self, raw: RawPacket, datagram: bytes, network: str, now: float) -> None:
        if self.gateway is not None and (onward := self.gateway.onward(raw, network)):
            for interface in self._networks:  # networks in a ring bring it back from any of them
                self._egress.echoes.add(datagram, interface, now)
            carried = self._egress.multicast(datagram, onward, now)
            self._egress.broadcast_to_static(raw.destination, datagram, carried)
            self.counters["relayed"] += bool(carried)

    def _is_own(self, id: int) -> bool:
        return not addressing.is_incomplete(id) and any(addressing.reaches(pattern, id) for pattern in self._own_ids)

    def _holder(self, id: int, now: float) -> NetworkPort | None:
        """The address on a network that an id belongs to, until it is silent."""
        port = self.sources.holder(id, now)
        return None if port is None or self._is_abandoned(port) else port

    # --- addresses -----------------------------------------------------------------------------------------------

    def _search(
        self, raw: RawPacket, datagram: bytes, networks: Sequence[str], now: float, *, relayed: bool = False
    ) -> None:
        """Handle a message for an unknown destination; one with zeros in its id can only be multicast."""
        if addressing.is_incomplete(raw.destination):
            if self._vague.take(None, now):
                self._probe(datagram, networks, now)
            else:
                self.counters.drop("unknown_destination", "too many messages for ids with zeros")
        elif (probe := self._pending.add(raw.destination, datagram, now, relayed=relayed)) is not None:
            self._probe(probe, networks, now)

    def _probe(self, datagram: bytes, networks: Sequence[str], now: float) -> None:
        self._egress.multicast(judp.with_ack_required(datagram), networks, now)

    def _probe_networks(self, raw: RawPacket, now: float) -> tuple[str, ...]:
        """The networks where an unknown destination may be; never the one of the source."""
        if self.gateway is None:
            return self._networks
        home = self.address_book.find(raw.source, now)
        if home is not None:
            return self.gateway.onward(raw, home.network)
        return self.gateway.reach(raw.source, raw.destination)

    def _learn(self, id: int, port: NetworkPort, now: float, sequence: int | None) -> None:
        if addressing.is_incomplete(id):
            return
        self.sources.heard(id, port, now, sequence)
        if self.address_book.learn(id, port, now):
            self._changed(id)
            for datagram in self._pending.pop(id, now):
                if port.network in self._probe_networks(judp.first_header(datagram), now):
                    self._egress.forward(port, id, datagram, now)
