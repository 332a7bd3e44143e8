"""One network of a node manager: its UDP sockets, and what is sent by them."""

from __future__ import annotations

import logging
import socket
import struct
import time
from collections.abc import Callable
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError
from jauspy.node import udp_errors
from jauspy.node.binding import bind
from jauspy.node.config import NetworkConfig
from jauspy.node.network6 import Network6
from jauspy.protocol import authentication as seal_format
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.authentication import Authenticator
from jauspy.protocol.counters import Counters
from jauspy.transport import multicast
from jauspy.transport.memberships import Memberships

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

    On a wildcard address one socket does all, and shares nothing but the group. On a specific address, multicasts
    need a second socket, bound to the group and shared, so that node managers on several addresses of one host all
    get them.
    `lost` is told of ports where nobody listens any more.
    """

    def __init__(
        self,
        config: NetworkConfig,
        counters: Counters,
        receive_buffer: int,
        seal: Authenticator | None,
        lost: Callable[[UdpPort], None],
    ) -> None:
        self._lost = lost
        self.config = config
        self.seal = seal
        self._counters = counters
        self._unicast = bind(config.address, config.port, receive_buffer)
        self._group: socket.socket | None = None
        self._six: Network6 | None = None
        self._memberships: Memberships | None = None
        try:
            multicast.prepare_sender(self._unicast, multicast.ANY, config.multicast_ttl)
            udp_errors.watch(self._unicast)
            self._memberships = self._join()
            if self._memberships is None or not self._memberships.joined:
                counters["multicast.not_joined"] += 1
            if config.address6 is not None:
                self._six = Network6(config, config.address6, self.port, receive_buffer, counters)
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
        six = () if self._six is None else self._six.sockets
        return [self._unicast, *([self._group] if self._group else ()), *six]

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
            return self.seal.verify(data, time.time())
        except ProtocolError as error:
            if error.reason == "own":
                self._counters["echoes"] += 1
            else:
                self._counters.drop(f"auth.{error.reason}", error)
            return None

    def send(self, datagram: bytes, host: str, port: int) -> None:
        """Send now; what cannot be sent is dropped and counted."""
        if self.seal is not None:
            datagram = self.seal.sign(datagram, time.time())
        sock = self._unicast
        if ":" in host:
            if self._six is None:
                self._counters.drop("no_ipv6", host)
                return
            sock = self._six.unicast
        for attempt in range(2):
            try:
                sock.sendto(datagram, (host, port))
            except ConnectionRefusedError as error:
                # It is an earlier datagram that has come back, to whomever; this one was not even tried.
                self.take_back()
                if attempt:
                    self._counters.drop("udp_unreachable", error)
            except OSError as error:
                self._counters.drop("udp_unreachable", error)
                return
            else:
                return

    def way_to(self, host: str, port: int) -> Callable[[bytes], None]:
        """What sends to one peer: `send`, but for all that the usual case does not need."""
        address = (host, port)
        sendto = self._unicast.sendto

        def careful(datagram: bytes) -> None:
            self.send(datagram, host, port)

        def usual(datagram: bytes) -> None:
            try:
                sendto(datagram, address)
            except OSError:
                careful(datagram)

        return usual if self.seal is None and ":" not in host else careful

    def take_back(self) -> None:
        """Tell the owner where nobody listens, as datagrams say that came back since the last call."""
        for port in udp_errors.refused(self._unicast):
            self._lost(port._replace(network=self.config.name))

    def watch_interfaces(self) -> None:
        """Join the group on interfaces that have come; to be called now and then."""
        if self._memberships is not None:
            self._memberships.refresh()
        if self._six is not None:
            self._six.watch_interfaces()

    def multicast(self, datagram: bytes) -> None:
        """Send to the group on each interface."""
        for interface in self._memberships.current if self._memberships else self.config.interfaces:
            if self._leave_by(interface):
                self.send(datagram, self.config.multicast_group, self.port)
        for group in self._six.groups() if self._six else ():
            self.send(datagram, group, self.port)

    def _leave_by(self, interface: str) -> bool:
        """Let multicasts leave by this interface; false while it is not there."""
        try:
            if interface != multicast.ANY:
                self._unicast.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
        except OSError as error:
            self._counters.drop("udp_unreachable", error)
            return False
        return True

    def close(self) -> None:
        """Close the sockets; a second call does nothing."""
        for sock in self.sockets:
            sock.close()

    def _join(self) -> Memberships | None:
        config = self.config
        if config.address == multicast.ANY:
            multicast.share_group(self._unicast)
            multicast.hear_only_joined(self._unicast)
            return Memberships(self._unicast, config.multicast_group, config.interfaces)
        try:
            self._group = multicast.receiver((config.multicast_group, self.port))
        except OSError as error:
            _LOGGER.warning("no multicasts will be received: %s", error.strerror)
            return None
        return Memberships(self._group, config.multicast_group, config.interfaces)
