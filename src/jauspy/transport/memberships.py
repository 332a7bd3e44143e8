"""The multicast group on interfaces that come and go."""

from __future__ import annotations

import contextlib
import logging
import socket
from collections.abc import Sequence
from typing import Final

import psutil

from jauspy.transport import multicast

_LOGGER = logging.getLogger(__name__)

ALL: Final = "all"
"""Every interface of the machine that has an IPv4 address, but for the loopback interface."""
WATCH_INTERVAL: Final = 5.0
"""Seconds between two looks at the machine's interfaces."""


def addresses(chosen: Sequence[str]) -> tuple[str, ...]:
    """The IPv4 addresses, present now, of what was chosen by address, by name, or as `ALL`."""
    found: dict[str, None] = {}
    present = {
        name: [each.address for each in entries if each.family == socket.AF_INET]
        for name, entries in psutil.net_if_addrs().items()
    }
    for each in chosen:
        if each == ALL:
            own = [address for name in present for address in present[name] if not address.startswith("127.")]
        elif each in present:
            own = present[each]
        elif (
            each == multicast.ANY or each.startswith("127.") or any(each in addresses for addresses in present.values())
        ):
            own = [each]
        else:
            own = []
        found.update(dict.fromkeys(own))
    return tuple(found)


class Memberships:
    """Keeps a socket in the group on all chosen interfaces. `current` are their addresses, to send by."""

    def __init__(self, sock: socket.socket, group: str, chosen: Sequence[str]) -> None:
        self.current: tuple[str, ...] = ()
        self._socket = sock
        self._group = group
        self._chosen = tuple(chosen)
        self._joined: set[str] = set()
        self.refresh()

    @property
    def joined(self) -> int:
        """On how many interfaces multicasts arrive."""
        return len(self._joined)

    def refresh(self) -> None:
        """Join where an interface has come, leave where it has gone, try again where it did not work."""
        self.current = addresses(self._chosen)
        for gone in self._joined.difference(self.current):
            self._leave(gone)
        for new in [each for each in self.current if each not in self._joined]:
            if multicast.join(self._socket, self._group, [new]):
                self._joined.add(new)
                _LOGGER.debug("joined %s on %s", self._group, new)

    def _leave(self, interface: str) -> None:
        self._joined.discard(interface)
        membership = socket.inet_aton(self._group) + socket.inet_aton(interface)
        with contextlib.suppress(OSError):  # the kernel has left by itself with the interface
            self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_DROP_MEMBERSHIP, membership)
