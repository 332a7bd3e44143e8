"""Liveness checks: components that ended without Cancel are found and removed."""

from __future__ import annotations

import contextlib
import os
import re
import stat
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from jauspy.protocol.address_book import ComponentDirectory, ComponentPort
from jauspy.transport.local import SocketProbe

CHECK_INTERVAL: Final = 1.0
MAX_ID: Final = 0xFFFFFFFF
"""An id has 32 bits."""
MAX_CHECKS: Final = 32
"""Ports checked in one turn, so that a thousand components do not delay the routing."""


class LivenessCheck:
    """Checks the ports of all components in turn.

    `is_dead(port)` is true when the component has ended; `remove_dead(port)` is called for each dead port.
    """

    def __init__(
        self,
        components: ComponentDirectory,
        is_dead: Callable[[ComponentPort], bool],
        remove_dead: Callable[[ComponentPort], None],
    ) -> None:
        self._components = components
        self._is_dead = is_dead
        self._remove_dead = remove_dead
        self._unchecked: list[ComponentPort] = []

    def check_next(self) -> None:
        """Check the next ports, or all of them if there is no room for another component."""
        if not self._unchecked:
            self._unchecked = list({port for _, port in self._components})
        count = len(self._unchecked) if self._components.is_full else MAX_CHECKS
        ports, self._unchecked = self._unchecked[:count], self._unchecked[count:]
        for port in ports:
            if self._is_dead(port) and self._components.has_port(port):
                self._remove_dead(port)


class ComponentSockets:
    """The local sockets of components; finds dead ones, and removes their files from `root`."""

    def __init__(self, root: Path) -> None:
        self._root = root
        self._probe: SocketProbe | None = None

    def open(self) -> None:
        """Take the descriptor for probes, so that it is there when all others are in use."""
        self._probe = SocketProbe()

    def close(self) -> None:
        """Give up the descriptor; a second call does nothing."""
        if self._probe is not None:
            self._probe.close()
        self._probe = None

    def find_live(self, may_use: Callable[[int], bool]) -> Iterator[tuple[int, str]]:
        """Id and path of each socket in `root` on which a component listens whose user may use the local socket."""
        try:
            entries = [entry for entry in os.scandir(self._root) if re.fullmatch(r"[1-9][0-9]{0,9}", entry.name)]
        except OSError:
            return
        for entry in entries:
            path = Path(entry.path)
            with contextlib.suppress(OSError):  # it ended just now
                found = path.lstat()
                if int(entry.name) > MAX_ID or not stat.S_ISSOCK(found.st_mode) or not may_use(found.st_uid):
                    continue
                if self._probe is not None and self._probe.error(path) == 0:
                    yield int(entry.name), entry.path

    def is_dead(self, path: str) -> bool:
        """True when nobody listens on a local socket; a component's socket file is then removed."""
        if self._probe is None or not self._probe.is_dead(Path(path)):
            return False
        self.remove(path)
        return True

    def remove(self, path: str) -> None:
        """Remove the socket file of a dead component; other files are left alone."""
        socket_path = Path(path)
        if self._probe is not None and socket_path.parent == self._root and socket_path.name.isdecimal():
            self._probe.clean_up(socket_path)
