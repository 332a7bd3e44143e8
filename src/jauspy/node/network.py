"""One network of a node manager: its UDP sockets for IPv4 and IPv6, and sending by them."""

from __future__ import annotations

import errno
import socket
import struct
import time
from collections.abc import Callable, Iterator
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError, TransportError
from jauspy.logs import get_logger
from jauspy.node.config import NetworkConfig
from jauspy.protocol import authentication
from jauspy.protocol.address_book import Address
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.authentication import Authenticator
from jauspy.protocol.counters import Counters
from jauspy.transport import multicast
from jauspy.transport.multicast import Memberships
from jauspy.transport.port_owner import udp_port_owner

_LOG = get_logger(__name__)
_ANY6: Final = "::"
_IP_RECVERR: Final = 11
_MSG_ERRQUEUE: Final = 0x2000
MAX_HOSTS: Final = 4096
"""Hosts whose bytes are counted; the oldest is forgotten first."""
_SEND_QUEUE: Final = 2
"""Place of the bytes that wait to be sent in what `SO_MEMINFO` returns."""
_SO_MEMINFO: Final = 55
"""Socket options of linux/in.h, linux/socket.h and asm-generic/socket.h; Python has no names for them."""
_MEMINFO: Final = struct.Struct("=9I")


class ReceiveBuffer(NamedTuple):
    """Bytes in the receive buffer of a socket, its size, and the number of datagrams that the kernel has dropped."""

    bytes: int
    limit: int
    dropped: int


class Network:
    """The sockets of one network; the constructor binds them and joins the group, or raises `TransportError`.

    On a wildcard address one socket does everything, and shares only the group. On a specific address, multicasts need
    a second socket, bound to the group and shared, so that node managers on several addresses of one host all receive
    them. `unreachable(port)` is called for ports where nobody listens any more.
    """

    def __init__(
        self,
        config: NetworkConfig,
        counters: Counters,
        receive_buffer: int,
        authenticator: Authenticator | None,
        unreachable: Callable[[UdpPort], None],
    ) -> None:
        self._unreachable = unreachable
        self.config = config
        self.authenticator = authenticator
        if authenticator is not None:
            authenticator.is_own = is_own_address
        self._counters = counters
        self._sent: dict[str, int] = {}
        """Bytes sent to hosts."""
        self._unicast = bind_udp(config.address, config.port, receive_buffer)
        self._port = int(self._unicast.getsockname()[1])
        self._group: socket.socket | None = None
        self._ipv6: _IPv6 | None = None
        self._memberships: Memberships | None = None
        self._selected: str | None = None
        """The interface by which multicasts are sent now; None when it has to be set again."""
        try:
            multicast.prepare_sender(self._unicast, multicast.ANY, config.multicast_ttl)
            self._unicast.setsockopt(socket.IPPROTO_IP, _IP_RECVERR, 1)
            self._memberships = self._join()
            if self._memberships is None or not self._memberships.joined:
                counters["multicast.not_joined"] += 1
            if config.address6 is not None:
                self._ipv6 = _IPv6(config, config.address6, self.port, receive_buffer, counters)
        except BaseException:
            self.close()
            raise

    @property
    def port(self) -> int:
        """The UDP port in use."""
        return self._port

    @property
    def skip(self) -> int:
        """The number of bytes before the version byte in received datagrams."""
        return 0 if self.authenticator is None else authentication.OVERHEAD

    @property
    def sockets(self) -> list[socket.socket]:
        """The sockets to read from."""
        ipv6 = () if self._ipv6 is None else self._ipv6.sockets
        return [self._unicast, *([self._group] if self._group else ()), *ipv6]

    @property
    def receive_buffer(self) -> ReceiveBuffer:
        """The state of the unicast socket's receive buffer; zeros where the system does not report it."""
        try:
            info = _MEMINFO.unpack(self._unicast.getsockopt(socket.SOL_SOCKET, _SO_MEMINFO, _MEMINFO.size))
        except (OSError, struct.error):
            return ReceiveBuffer(0, 0, 0)
        return ReceiveBuffer(info[0], info[1], info[8])

    @property
    def send_queue(self) -> int:
        """Bytes that the kernel has not yet given to the interface; 0 where the system does not report it."""
        try:
            info = _MEMINFO.unpack(self._unicast.getsockopt(socket.SOL_SOCKET, _SO_MEMINFO, _MEMINFO.size))
        except (OSError, struct.error):
            return 0
        return int(info[_SEND_QUEUE])

    def sent_bytes(self, host: str) -> int:
        """Bytes that were sent to a host, without headers of UDP and IP, since it was first sent to."""
        return self._sent.get(host, 0)

    def authenticate(self, data: bytes, source: UdpPort) -> bytes | None:
        """The datagram in received data; None, and counted, if authentication fails."""
        if self.authenticator is None:
            return data
        try:
            return self.authenticator.verify(data, time.time(), source[:2])
        except ProtocolError as error:
            if error.reason == "own":
                self._counters["echoes"] += 1
            else:
                self._counters.drop(f"auth.{error.reason}", error)
            return None
        finally:
            for (host, port), datagram in self.authenticator.poll_output():
                self._send(datagram, host, port)

    def send(self, datagram: bytes, host: str, port: int) -> None:
        """Send now; counted when dropped."""
        if self.authenticator is not None:
            datagram = self.authenticator.sign(datagram, time.time(), (host, port))
        self._send(datagram, host, port)

    def _send(self, datagram: bytes, host: str, port: int) -> None:
        sock = self._unicast
        if ":" in host:
            if self._ipv6 is None:
                self._counters.drop("no_ipv6", host)
                return
            sock = self._ipv6.unicast
        for attempt in range(2):
            try:
                sock.sendto(datagram, (host, port))
                self._count(host, len(datagram))
            except ConnectionRefusedError as error:
                # The error belongs to an earlier datagram, to any destination; this one was not sent yet.
                self.report_unreachable()
                if attempt:
                    self._counters.drop("udp_unreachable", error)
            except OSError as error:
                self._selected = None  # perhaps its interface has gone
                self._counters.drop("udp_unreachable", error)
                return
            else:
                return

    def sender_for(self, host: str, port: int) -> Callable[[bytes], None]:
        """A function that sends to one peer, without the steps of `send` that are rarely needed."""
        address = (host, port)
        sendto, sent = self._unicast.sendto, self._sent

        def slow_path(datagram: bytes) -> None:
            self.send(datagram, host, port)

        def fast_path(datagram: bytes) -> None:
            try:
                sendto(datagram, address)
            except OSError:
                slow_path(datagram)
                return
            try:
                sent[host] += len(datagram)
            except KeyError:
                self._count(host, len(datagram))

        return fast_path if self.authenticator is None and ":" not in host else slow_path

    def _count(self, host: str, size: int) -> None:
        sent = self._sent
        if host in sent:
            sent[host] += size
            return
        if len(sent) >= MAX_HOSTS:
            del sent[next(iter(sent))]
        sent[host] = size

    def report_unreachable(self) -> None:
        """Read the socket's error queue, where Linux reports datagrams to ports without a listener."""
        while True:
            try:
                _, _, _, destination = self._unicast.recvmsg(0, 0, _MSG_ERRQUEUE)
            except OSError:
                return
            if destination:
                host, port, *_ = destination
                self._unreachable(UdpPort(host, port, self.config.name))

    def refresh_memberships(self) -> None:
        """Join the group on interfaces that have appeared; to be called periodically."""
        self._selected = None
        if self._memberships is not None:
            self._memberships.refresh()
        if self._ipv6 is not None:
            self._ipv6.refresh_memberships()

    def multicast(self, datagram: bytes) -> None:
        """Send to the group on each interface."""
        if self.authenticator is not None:
            datagram = self.authenticator.sign(datagram, time.time(), None)
        group, port = self.config.multicast_group, self._port
        for interface in self._memberships.current if self._memberships else self.config.interfaces:
            if interface in (self._selected, multicast.ANY) or self._select_interface(interface):
                self._send(datagram, group, port)
        for group in self._ipv6.groups() if self._ipv6 else ():
            self._send(datagram, group, self.port)

    def close(self) -> None:
        """Close the sockets; a second call does nothing."""
        for sock in self.sockets:
            sock.close()

    def _select_interface(self, interface: str) -> bool:
        """Send multicasts by this interface; false while it does not exist."""
        try:
            self._unicast.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
        except OSError as error:
            self._selected = None
            self._counters.drop("udp_unreachable", error)
            return False
        self._selected = interface
        return True

    def _join(self) -> Memberships | None:
        config = self.config
        if config.address == multicast.ANY:
            multicast.share_group(self._unicast)
            multicast.receive_only_joined(self._unicast)
            return Memberships(self._unicast, config.multicast_group, config.interfaces)
        try:
            self._group = multicast.receiver((config.multicast_group, self.port))
        except OSError as error:
            _LOG.warning("no multicasts will be received: %s", error.strerror)
            return None
        return Memberships(self._group, config.multicast_group, config.interfaces)


class _IPv6:
    """The IPv6 sockets of a network, with the same roles as those for IPv4."""

    def __init__(self, config: NetworkConfig, address: str, port: int, receive_buffer: int, counters: Counters) -> None:
        self.unicast = bind_udp(address, port, receive_buffer)
        self._config = config
        self._counters = counters
        self._group: socket.socket | None = None
        self._memberships: Memberships | None = None
        try:
            multicast.prepare_ipv6(self.unicast, config.multicast_ttl)
            if config.multicast_group6 is not None:
                self._memberships = self._join(config.multicast_group6, address, port)
                if self._memberships is None or not self._memberships.joined:
                    counters["multicast.not_joined"] += 1
        except BaseException:
            for sock in self.sockets:
                sock.close()
            raise

    @property
    def sockets(self) -> list[socket.socket]:
        return [self.unicast, *([self._group] if self._group else ())]

    def refresh_memberships(self) -> None:
        if self._memberships is not None:
            self._memberships.refresh()

    def groups(self) -> Iterator[str]:
        """The group, once for each interface; multicasts are sent by that interface until the next iteration."""
        group = self._config.multicast_group6
        if group is None:
            return
        for name in self._memberships.current if self._memberships else ():
            try:
                self.unicast.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_IF, multicast.index(name))
            except OSError as error:
                self._counters.drop("udp_unreachable", error)
            else:
                yield group

    def _join(self, group: str, address: str, port: int) -> Memberships | None:
        sock = self.unicast
        if address != _ANY6:
            try:
                sock = self._group = multicast.receiver((group, port))
            except OSError as error:
                _LOG.warning("no IPv6 multicasts will be received: %s", error.strerror)
                return None
        return Memberships(sock, group, self._config.interfaces, multicast.IPV6)


def bind_udp(address: str, port: int, receive_buffer: int) -> socket.socket:
    """A non-blocking socket, IPv4 or IPv6; raises `TransportError` that names the process which has the port."""
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        if family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        sock.bind((address, port))
    except OSError as error:
        sock.close()
        if error.errno == errno.EADDRINUSE:
            raise TransportError(
                f"UDP port {port} is used by {udp_port_owner(port)}; stop it, or choose another port with --port"
            ) from None
        if error.errno == errno.EADDRNOTAVAIL:
            raise TransportError(
                f"{address} is not an address of this machine; choose another with --address"
            ) from None
        raise TransportError(f"cannot bind UDP {address}:{port}: {error.strerror}") from error
    return sock


def is_own_address(host: str, peer: Address) -> bool:
    """True for an IP address of this machine; a link-local one is on the interface by which `peer` is reached."""
    name = host.partition("%")[0]
    zone = peer[0].partition("%")[2]
    try:
        with socket.socket(socket.AF_INET6 if ":" in name else socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind((name, 0, 0, int(zone or 0)) if ":" in name else (name, 0))
    except (OSError, ValueError):
        return False
    return True
