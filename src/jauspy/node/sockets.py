"""The UDP sockets of a node manager."""

from __future__ import annotations

import errno
import logging
import socket
from typing import NamedTuple

from jauspy.errors import TransportError
from jauspy.node import owner
from jauspy.node.config import NodeConfig
from jauspy.transport import multicast
from jauspy.transport.memberships import Memberships

_LOGGER = logging.getLogger(__name__)


class UdpSockets(NamedTuple):
    """`unicast` sends everything; `group` only receives multicasts, and is None when `unicast` does that too."""

    unicast: socket.socket
    group: socket.socket | None
    memberships: Memberships | None

    @property
    def joined(self) -> int:
        """On how many interfaces multicasts arrive."""
        return self.memberships.joined if self.memberships else 0

    def all(self) -> list[socket.socket]:
        """The sockets to read from."""
        return [self.unicast] if self.group is None else [self.unicast, self.group]


def open_udp(config: NodeConfig) -> UdpSockets:
    """Bind and join; raises `TransportError` that names who has the port.

    On a wildcard address one exclusive socket does all. On a specific address, multicasts need a second socket,
    bound to the group and shared, so that node managers on several addresses of one host all get them.
    """
    unicast = _bind(config.address, config.port)
    multicast.prepare_sender(unicast, multicast.ANY, config.multicast_ttl)
    if config.address == multicast.ANY:
        multicast.join(unicast, config.multicast_group, ())  # from now on it hears only what it joins itself
        return UdpSockets(unicast, None, Memberships(unicast, config.multicast_group, config.interfaces))
    try:
        group, _ = multicast.receiver((config.multicast_group, unicast.getsockname()[1]), ())
    except OSError as error:
        _LOGGER.warning("no multicasts will be received: %s", error.strerror)
        return UdpSockets(unicast, None, None)
    return UdpSockets(unicast, group, Memberships(group, config.multicast_group, config.interfaces))


def _bind(address: str, port: int) -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
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
