"""The components of this machine: which id listens where."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final, TypeAlias

from jauspy.protocol import addressing
from jauspy.protocol.addressing import LocalPort, UdpPort

MAX_COMPONENTS: Final = 1024
MAX_UDP_COMPONENTS: Final = 256
"""Of these, by UDP: any user of this machine can send it, and must not fill the places of those with a socket."""

ComponentPort: TypeAlias = LocalPort | UdpPort
"""A component's Unix socket, or its UDP port on this machine, as ROS/IOP components have it."""


class ComponentDirectory:
    """Ids (32-bit numbers) and the ports they were last heard from. `changed` is told of an id that comes or goes."""

    def __init__(self, changed: Callable[[int], None] = lambda _: None) -> None:
        self._changed = changed
        self._ports: dict[int, ComponentPort] = {}
        self._ids: dict[ComponentPort, set[int]] = {}
        self._by_udp = 0

    def __len__(self) -> int:
        return len(self._ports)

    def __contains__(self, id: int) -> bool:
        return id in self._ports

    def __iter__(self) -> Iterator[tuple[int, ComponentPort]]:
        return iter(list(self._ports.items()))

    def port(self, id: int) -> ComponentPort | None:
        """Where exactly this id listens."""
        return self._ports.get(id)

    def has_port(self, port: ComponentPort) -> bool:
        """True when some component listens there."""
        return port in self._ids

    def register(self, id: int, port: ComponentPort) -> bool:
        """Note that `id` listens on `port`, the last one to say so wins; False when there is no room or no id."""
        known, by_udp = self._ports.get(id), isinstance(port, UdpPort)
        if id == 0 or (known is None and len(self._ports) >= MAX_COMPONENTS):
            return False
        if by_udp and not isinstance(known, UdpPort) and self._by_udp >= MAX_UDP_COMPONENTS:
            return False
        if known != port:
            self.remove(id)
            self._ports[id] = port
            self._by_udp += by_udp
            self._ids.setdefault(port, set()).add(id)
            self._changed(id)
        return True

    def remove(self, id: int) -> None:
        """Forget a component."""
        port = self._ports.pop(id, None)
        if port is not None:
            self._by_udp -= isinstance(port, UdpPort)
            self._ids[port].discard(id)
            if not self._ids[port]:
                del self._ids[port]
            self._changed(id)

    def remove_port(self, port: ComponentPort) -> list[int]:
        """Forget all that listen there; returns their ids."""
        gone = sorted(self._ids.get(port, ()))
        for id in gone:
            self.remove(id)
        return gone

    def reached_by(self, destination: int, *, besides: int | None = None) -> list[ComponentPort]:
        """The ports of all components that a broadcast addresses, except the one it comes from."""
        return [port for id, port in self._ports.items() if id != besides and addressing.reaches(destination, id)]
