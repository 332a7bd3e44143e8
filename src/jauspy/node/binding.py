"""Binding the UDP port of a network, or saying in one sentence why not."""

from __future__ import annotations

import errno
import socket

from jauspy.errors import TransportError
from jauspy.node import owner


def bind_udp(address: str, port: int, receive_buffer: int) -> socket.socket:
    """A non-blocking socket, IPv4 or IPv6; raises `TransportError` that names who has the port."""
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
                f"UDP port {port} is used by {owner.udp_port_owner(port)}; stop it, or choose another port with --port"
            ) from None
        if error.errno == errno.EADDRNOTAVAIL:
            raise TransportError(f"{address} is no address of this machine; choose another with --address") from None
        raise TransportError(f"cannot bind UDP {address}:{port}: {error.strerror}") from error
    return sock
