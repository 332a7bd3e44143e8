"""Finding out that nobody listens on a UDP port of this machine: Linux tells it in the socket's error queue."""

from __future__ import annotations

import socket
from typing import Final

from jauspy.protocol.addressing import UdpPort

_IP_RECVERR: Final = 11
_MSG_ERRQUEUE: Final = 0x2000
"""Both from linux/in.h and linux/socket.h; Python has no names for them."""


def watch(sock: socket.socket) -> None:
    """Have the kernel keep what comes back for datagrams that could not be delivered."""
    sock.setsockopt(socket.IPPROTO_IP, _IP_RECVERR, 1)


def refused(sock: socket.socket) -> list[UdpPort]:
    """Where datagrams came back from since the last call."""
    found: list[UdpPort] = []
    while True:
        try:
            _, _, _, destination = sock.recvmsg(0, 0, _MSG_ERRQUEUE)
        except OSError:
            return found
        if destination:
            found.append(UdpPort(*destination[:2]))
