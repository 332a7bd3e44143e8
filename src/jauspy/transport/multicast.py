"""Socket options for JAUS's multicast group, in one place."""

from __future__ import annotations

import logging
import socket
from collections.abc import Sequence

_LOGGER = logging.getLogger(__name__)

ANY = "0.0.0.0"  # noqa: S104  # the standard's node managers listen on every interface


def prepare_sender(sock: socket.socket, interface: str, ttl: int) -> None:
    """Multicasts leave by `interface` (an IPv4 address; `ANY` lets the kernel choose) and come back to this host."""
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 1)
    if interface != ANY:
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))


def join(sock: socket.socket, group: str, interfaces: Sequence[str]) -> int:
    """Join the group on each interface; returns on how many that worked. A machine without a network is no error."""
    joined = 0
    for interface in interfaces:
        membership = socket.inet_aton(group) + socket.inet_aton(interface)
        try:
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            _LOGGER.info("cannot join %s on %s: %s", group, interface, error.strerror)
        else:
            joined += 1
    return joined
