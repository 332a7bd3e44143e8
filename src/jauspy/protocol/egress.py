"""Datagrams that a node manager sends: to components, to addresses on networks, and by multicast."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from jauspy.protocol.address_book import AddressBook, ComponentDirectory, ComponentPort
from jauspy.protocol.addressing import GroupPort, LocalPort, NetworkPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.compression import Compression
from jauspy.protocol.counters import Counters
from jauspy.protocol.duplicates import MulticastEchoes
from jauspy.protocol.legacy import PeerVersions
from jauspy.protocol.link_limits import LinkLimits, link_of

PORT_KINDS: Final = {LocalPort: "local", UdpPort: "udp", GroupPort: "udp", TcpPort: "tcp", SerialPort: "serial"}
ROUTED_COUNTERS: Final[dict[type, str]] = {port: f"routed.{kind}" for port, kind in PORT_KINDS.items()}


class EgressQueue:
    """Queues datagrams for ports, in the version and compression that the peers understand, and counts them."""

    def __init__(
        self, counters: Counters, components: ComponentDirectory, address_book: AddressBook, limits: LinkLimits
    ) -> None:
        self._counters = counters
        self._limits = limits
        self._components = components
        self._address_book = address_book
        self._queue: list[tuple[Port, bytes]] = []
        self.echoes = MulticastEchoes()
        self.peer_versions = PeerVersions()
        self.compression: Compression | None = None

    def drain(self) -> list[tuple[Port, bytes]]:
        """The datagrams to send now, in order; the queue is empty afterwards."""
        queue, self._queue = self._queue, []
        return queue

    def send(self, port: Port, datagram: bytes) -> None:
        """Queue a datagram unchanged and uncounted."""
        self._queue.append((port, datagram))

    def deliver(self, port: ComponentPort, datagram: bytes) -> None:
        """Queue a datagram for a component."""
        self._queue.append((port, datagram))
        self._counters["routed.local"] += 1

    def deliver_broadcast(self, destination: int, datagram: bytes, *, exclude: int | None = None) -> int:
        """Queue a datagram for all components that it addresses; returns their number.

        A complete id addresses the components whose id is not assigned yet.
        """
        ports = self._components.matching(destination, exclude=exclude)
        for port in ports:
            self.deliver(port, datagram)
        return len(ports)

    def forward(self, port: NetworkPort, destination: int, datagram: bytes, now: float) -> bool:
        """Queue a datagram for an address on a network; false if the limits of its link leave it out."""
        if not self._admits(link_of(port), datagram, now):
            return False
        if self.compression is not None and self.compression.is_used and type(port) is UdpPort:
            datagram = self.compression.compress(datagram, port, now)
        self._send_to(port, destination, datagram)
        return True

    def broadcast_to_static(self, destination: int, datagram: bytes, networks: Sequence[str]) -> None:
        """Queue a broadcast for the static addresses: not every network has multicast."""
        for port in self._address_book.static_matching(destination):
            if port.network in networks:
                self._send_to(port, destination, datagram)

    def multicast(self, datagram: bytes, networks: Sequence[str], now: float) -> Sequence[str]:
        """Queue a datagram for the groups of these networks; returns those whose limits do not leave it out."""
        sent = [network for network in networks if self._admits(network, datagram, now)]
        for network in sent:
            self.echoes.add(datagram, network, now)
            self._queue.append((GroupPort(network), datagram))
            self._counters["routed.multicast"] += 1
        return sent

    def _admits(self, link: str, datagram: bytes, now: float) -> bool:
        if self._limits.admits(link, datagram, now):
            return True
        self._counters.drop("link_limit", link)
        return False

    def _send_to(self, port: NetworkPort, destination: int, datagram: bytes) -> None:
        self._queue.append((port, self.peer_versions.convert(destination, datagram)))
        self._counters[ROUTED_COUNTERS[type(port)]] += 1
