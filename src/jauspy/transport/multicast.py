"""Socket options for JAUS's multicast group, in one place."""

from __future__ import annotations

import errno
import logging
import socket
from collections.abc import Sequence
from typing import Final

_LOGGER = logging.getLogger(__name__)

ANY: Final = "0.0.0.0"  # noqa: S104  # the standard's node managers listen on every interface

RECEIVE_BUFFER: Final = 4 * 1024 * 1024
"""Bytes asked of the kernel, so that a burst survives until it is read; the kernel may give less."""
_IP_MULTICAST_ALL: Final = 49
"""From linux/in.h; 0: only what this socket joined itself."""


def prepare_sender(sock: socket.socket, interface: str, ttl: int) -> None:
    """Multicasts leave by `interface` (an IPv4 address; `ANY` lets the kernel choose) and come back to this host."""
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 1)
    if interface != ANY:
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))


def join(sock: socket.socket, group: str, interfaces: Sequence[str]) -> int:
    """Join the group on each interface; returns on how many that worked. A machine without a network is no error."""
    sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)
    joined = 0
    for interface in interfaces:
        membership = socket.inet_aton(group) + socket.inet_aton(interface)
        try:
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            if error.errno == errno.EADDRINUSE:  # by another address of the same interface
                joined += 1
                continue
            _LOGGER.info("cannot join %s on %s: %s", group, interface, error.strerror)
        else:
            joined += 1
    return joined


def receiver(group: tuple[str, int], interfaces: Sequence[str]) -> tuple[socket.socket, int]:
    """A socket that receives nothing but the group, beside other such sockets, and on how many interfaces it does.

    Raises `OSError`, as when a node manager on all addresses of this machine has the port for itself.
    """
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.bind(group)
        return sock, join(sock, group[0], interfaces)
    except OSError:
        sock.close()
        raise
