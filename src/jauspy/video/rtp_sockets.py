"""The UDP sockets from which senders of RTP send: one for each family of addresses."""

from __future__ import annotations

import socket
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

from jauspy.errors import ConfigError, TransportError

SocketAddress: TypeAlias = tuple[object, ...]
"""The address of a socket, as `socket.getaddrinfo` returns it."""


@dataclass(slots=True)
class RtpSockets:
    """Sends datagrams, and counts `packets` sent, and `dropped` ones, which the system refused: no buffer, no route.

    `what` begins the texts of errors: video or sound. `buffer`: bytes of the send buffers; the system's size if None.
    """

    what: str
    counters: Counter[str]
    buffer: int | None = None
    _sockets: dict[int, socket.socket] = field(default_factory=dict)

    def __iter__(self) -> Iterator[socket.socket]:
        """The open sockets."""
        return iter(self._sockets.values())

    def open(self, family: int) -> None:
        """Open the socket of a family, unless it is open. Raises `TransportError`."""
        if family in self._sockets:
            return
        try:
            opened = socket.socket(family, socket.SOCK_DGRAM)
            opened.bind(("", 0))
        except OSError as error:
            raise TransportError(f"{self.what}: no socket to send from: {error}") from error
        opened.setblocking(False)
        if self.buffer is not None:
            opened.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, self.buffer)
        self._sockets[family] = opened

    def local_port(self, family: int) -> int:
        """The UDP port of the open socket of a family."""
        return int(self._sockets[family].getsockname()[1])

    def send(self, packet: bytes, address: SocketAddress) -> None:
        """Send a datagram to an address whose family is open."""
        family = socket.AF_INET6 if len(address) > 2 else socket.AF_INET
        try:
            self._sockets[family].sendto(packet, address)
        except OSError:
            self.counters["dropped"] += 1
        else:
            self.counters["packets"] += 1

    def close(self) -> None:
        """Close the sockets; without effect when closed."""
        for opened in self:
            opened.close()
        self._sockets.clear()


def numeric_address(host: str, port: int, what: str = "video") -> tuple[int, SocketAddress]:
    """The family and address of a socket; raises `ConfigError`, which begins with `what`, for anything else."""
    if not 1 <= port <= 65534:
        raise ConfigError(f"{what}: port {port} is not in 1..65534")
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM, flags=socket.AI_NUMERICHOST)
    except (OSError, UnicodeError) as error:
        raise ConfigError(
            f"{what}: {host!r} is not an IP address; host names are not resolved here: {error}"
        ) from error
    return found[0][0], found[0][4]
