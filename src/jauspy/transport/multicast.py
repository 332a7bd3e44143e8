"""Socket options for JAUS's multicast group, in one place."""

from __future__ import annotations

import socket
from typing import Final

ANY: Final = "0.0.0.0"  # noqa: S104  # the standard's node managers listen on every interface

RECEIVE_BUFFER: Final = 4 * 1024 * 1024
"""Bytes asked of the kernel, so that a burst survives until it is read; the kernel may give less."""
_IP_MULTICAST_ALL: Final = 49
_IPV6_MULTICAST_ALL: Final = 29
"""From linux/in.h and in6.h; 0: only what this socket joined itself."""


def prepare_sender(sock: socket.socket, interface: str, ttl: int) -> None:
    """Multicasts leave by `interface` (an IPv4 address; `ANY` lets the kernel choose) and come back to this host."""
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 1)
    if interface != ANY:
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))


def hold_bursts(sock: socket.socket) -> None:
    """What arrives while its reader is busy is kept, as far as the kernel allows."""
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)


def prepare_ipv6(sock: socket.socket, hops: int) -> None:
    """Multicasts come back to this host, and only groups that this socket joins arrive."""
    sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_HOPS, hops)
    sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_LOOP, 1)
    sock.setsockopt(socket.IPPROTO_IPV6, _IPV6_MULTICAST_ALL, 0)


def hear_only_joined(sock: socket.socket) -> None:
    """From now on it receives no group that another socket of this machine has joined."""
    sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)


def share_group(sock: socket.socket) -> None:
    """From now on `receiver`s of the same user may be bound beside it; its port on this machine stays its own.

    To be called after `bind`: a socket that has the option already would also share what is sent to it alone.
    """
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)


def receiver(group: tuple[str, int]) -> socket.socket:
    """A socket that can receive nothing but the group, as soon as it joins it, beside other such sockets.

    Raises `OSError`, as when a program that does not `share_group` has the port on all addresses of this machine.
    """
    family = socket.AF_INET6 if ":" in group[0] else socket.AF_INET
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        hold_bursts(sock)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        sock.bind(group)
        if family == socket.AF_INET:
            hear_only_joined(sock)
        else:
            sock.setsockopt(socket.IPPROTO_IPV6, _IPV6_MULTICAST_ALL, 0)
    except OSError:
        sock.close()
        raise
    return sock
