"""The UDP sockets of a node manager."""

from __future__ import annotations

import errno
import logging
import socket
from typing import NamedTuple

from jauspy.errors import TransportError
from jauspy.node import owner, udp_errors
from jauspy.node.config import NodeConfig
from jauspy.transport import multicast
from jauspy.transport.memberships import Memberships

_LOGGER = logging.getLogger(__name__)


class UdpSockets(NamedTuple):
    """`unicast` sends all but IPv6; `group` only receives multicasts, and is None when `unicast` does that too."""

    unicast: socket.socket
    group: socket.socket | None
    memberships: Memberships | None
    unicast6: socket.socket | None = None

    @property
    def joined(self) -> int:
        """On how many interfaces multicasts arrive."""
        return self.memberships.joined if self.memberships else 0

    def all(self) -> list[socket.socket]:
        """The sockets to read from."""
        return [sock for sock in (self.unicast, self.group, self.unicast6) if sock is not None]

    def sender(self, host: str) -> socket.socket | None:
        """The socket for datagrams to this address."""
        return self.unicast6 if ":" in host else self.unicast


def open_udp(config: NodeConfig) -> UdpSockets:
    """Bind and join; raises `TransportError` that names who has the port.

    On a wildcard address one exclusive socket does all. On a specific address, multicasts need a second socket,
    bound to the group and shared, so that node managers on several addresses of one host all get them.
    """
    unicast = _bind(config.address, config.port)
    try:
        return _complete(config, unicast)
    except BaseException:
        unicast.close()
        raise


def _complete(config: NodeConfig, unicast: socket.socket) -> UdpSockets:
    multicast.prepare_sender(unicast, multicast.ANY, config.multicast_ttl)
    udp_errors.watch(unicast)
    port = unicast.getsockname()[1]
    unicast6 = _bind(config.address6, port) if config.address6 else None
    if config.address == multicast.ANY:
        joined = Memberships(unicast, config.multicast_group, config.interfaces)
        return UdpSockets(unicast, None, joined, unicast6)
    try:
        group, _ = multicast.receiver((config.multicast_group, port), ())
    except OSError as error:
        _LOGGER.warning("no multicasts will be received: %s", error.strerror)
        return UdpSockets(unicast, None, None, unicast6)
    return UdpSockets(unicast, group, Memberships(group, config.multicast_group, config.interfaces), unicast6)


def _bind(address: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        if family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, multicast.RECEIVE_BUFFER)
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
