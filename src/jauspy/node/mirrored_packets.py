"""Routed packets as pcapng blocks, for the mirrors.

Components of this machine appear as 127.S.N.C: the low byte of their subsystem, their node and their component.
"""

from __future__ import annotations

import socket
import time
from collections.abc import Callable
from typing import Final

from jauspy.capture import writer
from jauspy.protocol import judp
from jauspy.protocol.addressing import GroupPort, LocalPort, Port

MAX_ENDPOINTS: Final = 4096


class MirroredPackets:
    """Makes the blocks. `group(network)` returns the multicast address and port of a network."""

    def __init__(self, group: Callable[[str], writer.Endpoint]) -> None:
        self._group = group
        self._endpoints: dict[Port, writer.Endpoint] = {}

    def block(self, source: Port, destination: Port, datagram: bytes) -> bytes:
        """The packet block of a datagram that is routed now."""
        return writer.packet(self._endpoint(source), self._endpoint(destination), datagram, time.time_ns())

    def _endpoint(self, port: Port) -> writer.Endpoint:
        name = self._endpoints.get(port)
        if name is None:
            if len(self._endpoints) > MAX_ENDPOINTS:
                self._endpoints.clear()
            name = self._endpoints[port] = self._make_endpoint(port)
        return name

    def _make_endpoint(self, port: Port) -> writer.Endpoint:
        if isinstance(port, LocalPort):
            number = port.path.rpartition("/")[2]
            id = int(number) if number.isdecimal() else 1
            return f"127.{id >> 16 & 255}.{id >> 8 & 255}.{id & 255}", judp.PORT
        if isinstance(port, GroupPort):
            return self._group(port.network)
        try:
            socket.inet_aton(port.host)
        except OSError:
            return "0.0.0.0", port.port  # noqa: S104 # nosec B104 # a serial line has no address
        return port.host, port.port
