"""The IPv6 side of a network: a socket beside that of IPv4, and multicasts when there is a group for them."""

from __future__ import annotations

import logging
import socket
from collections.abc import Iterator

from jauspy.node.binding import bind
from jauspy.node.config import NetworkConfig
from jauspy.protocol.counters import Counters
from jauspy.transport import multicast, multicast as memberships
from jauspy.transport.multicast import Memberships

_LOGGER = logging.getLogger(__name__)
_ANY = "::"


class Network6:
    """As with IPv4: on `::` one exclusive socket does all, on another address multicasts come by a second one."""

    def __init__(self, config: NetworkConfig, address: str, port: int, receive_buffer: int, counters: Counters) -> None:
        self.unicast = bind(address, port, receive_buffer)
        self._config = config
        self._counters = counters
        self._group: socket.socket | None = None
        self._memberships: Memberships | None = None
        try:
            multicast.prepare_ipv6(self.unicast, config.multicast_ttl)
            if config.multicast_group6 is not None:
                self._memberships = self._join(config.multicast_group6, address, port)
                if self._memberships is None or not self._memberships.joined:
                    counters["multicast.not_joined"] += 1
        except BaseException:
            for sock in self.sockets:
                sock.close()
            raise

    @property
    def sockets(self) -> list[socket.socket]:
        """The sockets to read from."""
        return [self.unicast, *([self._group] if self._group else ())]

    def watch_interfaces(self) -> None:
        """Join the group on interfaces that have come; to be called now and then."""
        if self._memberships is not None:
            self._memberships.refresh()

    def groups(self) -> Iterator[str]:
        """The group, once for each interface; multicasts leave by that one until the next is taken."""
        group = self._config.multicast_group6
        if group is None:
            return
        for name in self._memberships.current if self._memberships else ():
            try:
                self.unicast.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_IF, memberships.index(name))
            except OSError as error:
                self._counters.drop("udp_unreachable", error)
            else:
                yield group

    def _join(self, group: str, address: str, port: int) -> Memberships | None:
        sock = self.unicast
        if address != _ANY:
            try:
                sock = self._group = multicast.receiver((group, port))
            except OSError as error:
                _LOGGER.warning("no IPv6 multicasts will be received: %s", error.strerror)
                return None
        return Memberships(sock, group, self._config.interfaces, memberships.IPV6)
