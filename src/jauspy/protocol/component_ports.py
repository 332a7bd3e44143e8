"""Directory of the components of this machine: the port that each id is reached at."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final, TypeAlias

from jauspy.protocol import addressing
from jauspy.protocol.addressing import LocalPort, UdpPort

MAX_COMPONENTS: Final = 1024
MAX_UDP_COMPONENTS: Final = 256
"""Of these, by UDP: any user of this machine can send UDP, and must not use up the room of those with a socket."""

ComponentPort: TypeAlias = LocalPort | UdpPort
"""A component's Unix socket, or its UDP port on this machine, as ROS/IOP components have it."""


class ComponentDirectory:
    """Ids (32-bit numbers) and their ports; `changed(id)` is called when one is added or removed.

    `max_sockets` bounds the local sockets, each of which needs a file descriptor.
    """

    def __init__(self, changed: Callable[[int], None] = lambda _: None, *, max_sockets: int = MAX_COMPONENTS) -> None:
        self._changed = changed
        self._max_sockets = max_sockets
        self._ports: dict[int, ComponentPort] = {}
        self._ids: dict[ComponentPort, set[int]] = {}
        self._udp_count = 0
        self._socket_count = 0

    def __len__(self) -> int:
        return len(self._ports)

    def __contains__(self, id: int) -> bool:
        return id in self._ports

    def __iter__(self) -> Iterator[tuple[int, ComponentPort]]:
        return iter(list(self._ports.items()))

    @property
    def is_full(self) -> bool:
        """True when there is no room for another component, or another local socket."""
        return len(self._ports) >= MAX_COMPONENTS or self._socket_count >= self._max_sockets

    def port(self, id: int) -> ComponentPort | None:
        """The port of this id; wildcards are not expanded."""
        return self._ports.get(id)

    def has_port(self, port: ComponentPort) -> bool:
        """True when a component is registered at this port."""
        return port in self._ids

    def register(self, id: int, port: ComponentPort) -> bool:
        """Set the port of `id`, in place of an earlier one; false for id 0 and when the directory is full."""
        known, by_udp = self._ports.get(id), isinstance(port, UdpPort)
        if id == 0 or (known is None and len(self._ports) >= MAX_COMPONENTS):
            return False
        if by_udp and not isinstance(known, UdpPort) and self._udp_count >= MAX_UDP_COMPONENTS:
            return False
        if known == port:
            return True
        if not by_udp and port not in self._ids and self._socket_count >= self._max_sockets:
            return False
        self.remove(id)
        self._ports[id] = port
        self._udp_count += by_udp
        if port not in self._ids:
            self._ids[port] = set()
            self._socket_count += not by_udp
        self._ids[port].add(id)
        self._changed(id)
        return True

    def remove(self, id: int) -> None:
        """Remove a component; unknown ids are ignored."""
        port = self._ports.pop(id, None)
        if port is not None:
            self._udp_count -= isinstance(port, UdpPort)
            self._ids[port].discard(id)
            if not self._ids[port]:
                del self._ids[port]
                self._socket_count -= isinstance(port, LocalPort)
            self._changed(id)

    def remove_port(self, port: ComponentPort) -> list[int]:
        """Remove all components at a port; returns their ids."""
        removed = sorted(self._ids.get(port, ()))
        for id in removed:
            self.remove(id)
        return removed

    def matching(self, destination: int, *, exclude: int | None = None) -> list[ComponentPort]:
        """The ports of all components that a broadcast addresses, except that of its source."""
        return [port for id, port in self._ports.items() if id != exclude and addressing.reaches(destination, id)]
