"""Liveness checks: components that ended without Cancel are found and removed."""

from __future__ import annotations

import errno
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Final

from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.component_ports import ComponentDirectory, ComponentPort
from jauspy.transport import local

CHECK_INTERVAL: Final = 1.0
MAX_CHECKS: Final = 32
"""Ports checked in one turn, so that a thousand components do not delay the routing."""


class LivenessCheck:
    """Checks the ports of all components in turn.

    `is_dead(path)` is true when nobody listens on a local socket; `remove_dead(port)` is called for each dead port.
    """

    def __init__(
        self,
        components: ComponentDirectory,
        is_dead: Callable[[str], bool],
        remove_dead: Callable[[ComponentPort], None],
    ) -> None:
        self._components = components
        self._is_dead = is_dead
        self._remove_dead = remove_dead
        self._unchecked: list[ComponentPort] = []

    def check_next(self) -> None:
        """Check the next ports."""
        if not self._unchecked:
            self._unchecked = list({port for _, port in self._components})
        ports, self._unchecked = self._unchecked[:MAX_CHECKS], self._unchecked[MAX_CHECKS:]
        for port in ports:
            dead = self._is_dead(port.path) if isinstance(port, LocalPort) else is_unbound(port)
            if dead and self._components.has_port(port):
                self._remove_dead(port)


def is_unbound(port: UdpPort) -> bool:
    """True when a UDP port of this machine could be bound; the component itself is not asked."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind((port.host, port.port))
    except OSError as error:
        return error.errno == errno.EADDRNOTAVAIL
    return True


def is_dead(root: Path, path: str) -> bool:
    """True when nobody listens on a local socket; a component's socket file is then removed."""
    if not local.is_dead(Path(path)):
        return False
    remove_socket(root, path)
    return True


def remove_socket(root: Path, path: str) -> None:
    """Remove the socket file of a dead component; other files are left alone."""
    socket_path = Path(path)
    if socket_path.parent == root and socket_path.name.isdecimal():
        local.clean_up(socket_path)
