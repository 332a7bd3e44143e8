"""What a node manager speaks beside UDP and local sockets: JTCP connections and serial lines."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from jauspy.errors import ConfigError
from jauspy.node.config import NodeConfig
from jauspy.node.tcp import TcpPeers
from jauspy.protocol.addressing import NetworkPort, SerialPort, TcpPort
from jauspy.protocol.counters import Counters
from jauspy.transport.serial_link import SerialLine, SerialLink


class Links:
    """They belong to `network`. `took(datagram, port)` gets every packet, `gone(port)` is told of ended connections."""

    def __init__(
        self,
        counters: Counters,
        network: str,
        took: Callable[[bytes, NetworkPort], None],
        gone: Callable[[NetworkPort], None],
    ) -> None:
        self._took = took
        self._counters = counters
        self._network = network
        self._tcp = TcpPeers(counters, network, took, gone)
        self._serial: dict[SerialPort, SerialLink] = {}

    @property
    def tcp_port(self) -> int | None:
        """The TCP port in use, if any."""
        return self._tcp.port

    async def open(self, config: NodeConfig, udp_port: int, known: Iterable[NetworkPort]) -> None:
        """Open what the configuration says, and connect to the TCP peers of the address book; all or nothing.

        Raises `TransportError` when a port or a device cannot be used, `ConfigError` when they would go round a key.
        """
        peers = {port for port in known if isinstance(port, TcpPort)}
        if config.key_file is not None and (config.tcp or config.serial or peers):
            raise ConfigError("key_file: JTCP and serial lines cannot be authenticated; use either them or a key")
        hosts = (config.address, *([config.address6] if config.address6 else ())) if config.tcp else ()
        try:
            for serial in config.serial:
                self._open_line(serial.line)
            await self._tcp.open(hosts, udp_port if config.tcp_port is None else config.tcp_port, peers)
        except BaseException:
            await self.close()
            raise

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""
        for line in self._serial.values():
            line.close()
        self._serial.clear()
        await self._tcp.close()

    def send(self, port: TcpPort | SerialPort, datagram: bytes) -> None:
        """Send to one peer, or drop and count."""
        if isinstance(port, TcpPort):
            self._tcp.send(port, datagram)
        elif port in self._serial:
            self._serial[port].send(datagram)
        else:
            self._counters.drop("no_such_line", port.host)

    def broadcast(self, datagram: bytes) -> None:
        """Send on all connections and lines."""
        self._tcp.broadcast(datagram)
        for line in self._serial.values():
            line.send(datagram)

    def _open_line(self, line: SerialLine) -> None:
        port = SerialPort(line.device, network=self._network)
        link = SerialLink(line, self._counters, lambda datagram: self._took(datagram, port))
        link.open()
        self._serial[port] = link
