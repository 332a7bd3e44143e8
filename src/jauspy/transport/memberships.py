"""The multicast group on interfaces that come and go."""

from __future__ import annotations

import contextlib
import errno
import logging
import os
import socket
from collections.abc import Sequence
from typing import Final

import psutil

from jauspy.transport import multicast

_LOGGER = logging.getLogger(__name__)

ALL: Final = "all"
"""Every interface of the machine that has an IPv4 address, but for the loopback interface."""
WATCH_INTERVAL: Final = 5.0
"""Seconds between two looks at the machine's interfaces; a robot may be up before its network is."""


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
        self._told: set[str] = set()
        self.refresh()

    @property
    def joined(self) -> int:
        """On how many interfaces multicasts arrive."""
        return len(self._joined)

    def refresh(self) -> None:
        """Join everywhere, again: an interface that went and came back is a new one to the kernel."""
        found = {each: addresses([each]) for each in self._chosen}
        self.current = tuple(dict.fromkeys(address for own in found.values() for address in own))
        for gone in self._joined.difference(self.current):
            self._leave(gone)
        for each, own in found.items():
            if not own:
                self._failed(each, os.strerror(errno.ENODEV))
        for interface in self.current:
            error = self._join(interface)
            if error is None:
                self._succeeded(interface)
            else:
                self._failed(interface, error.strerror)

    def _join(self, interface: str) -> OSError | None:
        membership = socket.inet_aton(self._group) + socket.inet_aton(interface)
        try:
            self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            return None if error.errno == errno.EADDRINUSE else error  # in use: joined before
        return None

    def _succeeded(self, interface: str) -> None:
        if interface not in self._joined:
            level = logging.WARNING if interface in self._told else logging.DEBUG
            _LOGGER.log(level, "joined %s on %s", self._group, interface)
        self._joined.add(interface)
        self._told.discard(interface)

    def _failed(self, interface: str, reason: str | None) -> None:
        self._joined.discard(interface)
        if interface not in self._told:
            self._told.add(interface)
            _LOGGER.warning(
                "no multicasts on interface %s: %s; is its network up? Trying again every %g s",
                interface,
                reason,
                WATCH_INTERVAL,
            )

    def _leave(self, interface: str) -> None:
        self._joined.discard(interface)
        membership = socket.inet_aton(self._group) + socket.inet_aton(interface)
        with contextlib.suppress(OSError):  # the kernel has left by itself with the interface
            self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_DROP_MEMBERSHIP, membership)
