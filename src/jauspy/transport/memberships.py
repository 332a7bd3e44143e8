"""The multicast group on interfaces that come and go."""

from __future__ import annotations

import errno
import logging
import socket
from collections.abc import Sequence
from typing import Final

_LOGGER = logging.getLogger(__name__)

WATCH_INTERVAL: Final = 5.0
"""Seconds between two attempts to join; a robot may be up before its network is."""


class Memberships:
    """Keeps a socket in the group on all interfaces that were chosen by their IPv4 addresses."""

    def __init__(self, sock: socket.socket, group: str, chosen: Sequence[str]) -> None:
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
        for interface in self._chosen:
            error = self._join(interface)
            if error is None:
                self._succeeded(interface)
            else:
                self._failed(interface, error)

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

    def _failed(self, interface: str, error: OSError) -> None:
        self._joined.discard(interface)
        if interface not in self._told:
            self._told.add(interface)
            _LOGGER.warning(
                "no multicasts on interface %s: %s; is its network up? Trying again every %g s",
                interface,
                error.strerror,
                WATCH_INTERVAL,
            )
