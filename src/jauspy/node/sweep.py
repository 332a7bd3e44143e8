"""Looking now and then whether the components are still there: one that died without a word is asked by nobody else."""

from __future__ import annotations

import errno
import socket
from collections.abc import Callable
from typing import Final

from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.directory import ComponentDirectory, ComponentPort

INTERVAL: Final = 1.0
PER_TURN: Final = 32
"""Ports looked at in one turn, so that a thousand components do not hold up the routing."""


class Sweep:
    """`is_dead(path)` says whether nobody listens on a local socket; `gone(port)` is told of each that is dead."""

    def __init__(
        self, components: ComponentDirectory, is_dead: Callable[[str], bool], gone: Callable[[ComponentPort], None]
    ) -> None:
        self._components = components
        self._is_dead = is_dead
        self._gone = gone
        self._left: list[ComponentPort] = []

    def turn(self) -> None:
        """Look at the next few."""
        if not self._left:
            self._left = list({port for _, port in self._components})
        now, self._left = self._left[:PER_TURN], self._left[PER_TURN:]
        for port in now:
            dead = self._is_dead(port.path) if isinstance(port, LocalPort) else nobody_has(port)
            if dead and self._components.has_port(port):
                self._gone(port)


def nobody_has(port: UdpPort) -> bool:
    """True when a UDP port of this machine could be bound: asking its owner would be one more packet to understand."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind((port.host, port.port))
    except OSError as error:
        return error.errno == errno.EADDRNOTAVAIL
    return True
