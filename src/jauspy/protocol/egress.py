"""What a node manager sends: to components, to addresses on networks, and by multicast."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from jauspy.protocol import wire
from jauspy.protocol.address_book import AddressBook
from jauspy.protocol.addressing import GroupPort, LocalPort, NetworkPort, Port, SerialPort, TcpPort, UdpPort
from jauspy.protocol.compression import Compression
from jauspy.protocol.counters import Counters
from jauspy.protocol.duplicates import MulticastEchoes
from jauspy.protocol.registrar import ComponentDirectory, ComponentPort

PORT_KINDS: Final = {LocalPort: "local", UdpPort: "udp", GroupPort: "udp", TcpPort: "tcp", SerialPort: "serial"}
ROUTED_COUNTERS: Final[dict[type, str]] = {port: f"routed.{kind}" for port, kind in PORT_KINDS.items()}


class EgressQueue:
    """Queues datagrams for ports, in the words that the peers understand, and counts them."""

    def __init__(self, counters: Counters, components: ComponentDirectory, address_book: AddressBook) -> None:
        self._counters = counters
        self._components = components
        self._address_book = address_book
        self._queue: list[tuple[Port, bytes]] = []
        self.echoes = MulticastEchoes()
        self.dialects = wire.PeerVersions()
        self.compression: Compression | None = None

    def drain(self) -> list[tuple[Port, bytes]]:
        """What is to be sent now, in order; empty afterwards."""
        queue, self._queue = self._queue, []
        return queue

    def send(self, port: Port, datagram: bytes) -> None:
        """These very bytes."""
        self._queue.append((port, datagram))

    def deliver(self, port: ComponentPort, datagram: bytes) -> None:
        """To a component."""
        self._queue.append((port, datagram))
        self._counters["routed.local"] += 1

    def deliver_broadcast(self, destination: int, datagram: bytes, *, besides: int | None = None) -> int:
        """To all components it reaches; for a complete id these are the ones that wait for an id. Returns how many."""
        reached = self._components.reached_by(destination, besides=besides)
        for port in reached:
            self.deliver(port, datagram)
        return len(reached)

    def forward(self, port: NetworkPort, destination: int, datagram: bytes, now: float) -> None:
        """To an address on a network."""
        if self.compression is not None and self.compression.is_used and type(port) is UdpPort:
            datagram = self.compression.shrink(datagram, port, now)
        self._send_to(port, destination, datagram)

    def copy_to_told(self, destination: int, datagram: bytes, networks: Sequence[str]) -> None:
        """A broadcast to the addresses that the configuration names: not every network has multicast."""
        for port in self._address_book.told_about(destination):
            if port.network in networks:
                self._send_to(port, destination, datagram)

    def multicast(self, datagram: bytes, networks: Sequence[str], now: float) -> None:
        """To all on these networks."""
        for network in networks:
            self.echoes.add(datagram, network, now)
            self._queue.append((GroupPort(network), datagram))
            self._counters["routed.multicast"] += 1

    def _send_to(self, port: NetworkPort, destination: int, datagram: bytes) -> None:
        self._queue.append((port, self.dialects.spoken_to(destination, datagram)))
        self._counters[ROUTED_COUNTERS[type(port)]] += 1
