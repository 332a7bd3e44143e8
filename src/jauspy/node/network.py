"""One network of a node manager: its UDP sockets, and what is sent by them."""

from __future__ import annotations

import errno
import logging
import socket
import struct
import time
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError, TransportError
from jauspy.node import owner
from jauspy.node.config import NetworkConfig
from jauspy.protocol import seal as seal_format
from jauspy.protocol.counters import Counters
from jauspy.protocol.seal import Seal
from jauspy.transport import multicast

_LOGGER = logging.getLogger(__name__)
_SO_MEMINFO: Final = 55
"""From asm-generic/socket.h."""
_MEMINFO: Final = struct.Struct("=9I")


class Buffered(NamedTuple):
    """What the kernel holds and has dropped of a socket's input."""

    bytes: int
    limit: int
    dropped: int


class Network:
    """Binds and joins when it is made; raises `TransportError` that names who has the port.

    On a wildcard address one exclusive socket does all. On a specific address, multicasts need a second socket,
    bound to the group and shared, so that node managers on several addresses of one host all get them.
    """

    def __init__(self, config: NetworkConfig, counters: Counters, receive_buffer: int, seal: Seal | None) -> None:
        self.config = config
        self.seal = seal
        self._counters = counters
        self._unicast = _bind(config.address, config.port, receive_buffer)
        self._group: socket.socket | None = None
        try:
            multicast.prepare_sender(self._unicast, multicast.ANY, config.multicast_ttl)
            if not self._join():
                counters["multicast.not_joined"] += 1
        except BaseException:
            self.close()
            raise

    @property
    def port(self) -> int:
        """The UDP port in use."""
        return int(self._unicast.getsockname()[1])

    @property
    def skip(self) -> int:
        """Bytes before the packet in what is received."""
        return 0 if self.seal is None else seal_format.OVERHEAD

    @property
    def sockets(self) -> list[socket.socket]:
        """The sockets to read from."""
        return [self._unicast] if self._group is None else [self._unicast, self._group]

    @property
    def buffered(self) -> Buffered:
        """The state of the unicast socket's receive buffer."""
        try:
            info = _MEMINFO.unpack(self._unicast.getsockopt(socket.SOL_SOCKET, _SO_MEMINFO, _MEMINFO.size))
        except (OSError, struct.error):
            return Buffered(0, 0, 0)
        return Buffered(info[0], info[1], info[8])

    def open_seal(self, data: bytes) -> bytes | None:
        """What was received, without its seal; None, and counted, when it must not be used."""
        if self.seal is None:
            return data
        try:
            return self.seal.open(data, time.time())
        except ProtocolError as error:
            if error.reason == "own":
                self._counters["echoes"] += 1
            else:
                self._counters.drop(f"auth.{error.reason}", error)
            return None

    def send(self, datagram: bytes, host: str, port: int) -> None:
        """Send now; what cannot be sent is dropped and counted."""
        if self.seal is not None:
            datagram = self.seal.seal(datagram, time.time())
        try:
            self._unicast.sendto(datagram, (host, port))
        except OSError as error:
            self._counters.drop("udp_unreachable", error)

    def multicast(self, datagram: bytes) -> None:
        """Send to the group on each interface."""
        for interface in self.config.interfaces:
            if interface != multicast.ANY:
                self._unicast.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
            self.send(datagram, self.config.multicast_group, self.port)

    def close(self) -> None:
        """Close the sockets; a second call does nothing."""
        for sock in self.sockets:
            sock.close()

    def _join(self) -> int:
        config = self.config
        if config.address == multicast.ANY:
            return multicast.join(self._unicast, config.multicast_group, config.interfaces)
        try:
            self._group, joined = multicast.receiver((config.multicast_group, self.port), config.interfaces)
        except OSError as error:
            _LOGGER.warning("no multicasts will be received: %s", error.strerror)
            return 0
        return joined


def _bind(address: str, port: int, receive_buffer: int) -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        sock.bind((address, port))
    except OSError as error:
        sock.close()
        if error.errno == errno.EADDRINUSE:
            raise TransportError(
                f"UDP port {port} is used by {owner.of_udp_port(port)}; stop it, or choose another port with --port"
            ) from None
        if error.errno == errno.EADDRNOTAVAIL:
            raise TransportError(f"{address} is no address of this machine; choose another with --address") from None
        raise TransportError(f"cannot bind UDP {address}:{port}: {error.strerror}") from error
    return sock
