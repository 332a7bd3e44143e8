"""The addresses of JAUS ids: the components of this machine, and addresses on networks.

Addresses are static ones of the configuration, and those learned from received packets.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Final, NamedTuple, TypeAlias

from jauspy.protocol import addressing
from jauspy.protocol.addressing import LocalPort, NetworkPort, UdpPort

Address: TypeAlias = tuple[str, int]
"""Host and port, as sockets give them."""
StaticAddresses: TypeAlias = Mapping[int, Sequence[NetworkPort]]
"""Addresses by id, a 32-bit number which may have wildcards."""

ADDRESS_LIFETIME: Final = 600.0
"""Seconds without a packet after which a learned address expires."""
MAX_IDS: Final = 4096
MAX_IDS_PER_HOST: Final = 1024
"""Ids of one host, as many as a node manager has components; beyond that its own oldest are forgotten."""


class IdBounds(NamedTuple):
    """Ids on networks that are remembered: all, and those of one host."""

    total: int = MAX_IDS
    per_host: int = MAX_IDS_PER_HOST


class LearnedAddresses:
    """Port and time of each id, a 32-bit number; the one that was set longest ago is forgotten first."""

    def __init__(self, bounds: IdBounds = IdBounds()) -> None:  # noqa: B008 - immutable
        self._bounds = bounds
        self._learned_ports: OrderedDict[int, tuple[NetworkPort, float]] = OrderedDict()
        self._hosts: dict[str, OrderedDict[int, None]] = {}

    def __len__(self) -> int:
        return len(self._learned_ports)

    def __iter__(self) -> Iterator[tuple[int, NetworkPort, float]]:
        return iter([(id, *place) for id, place in self._learned_ports.items()])

    def get(self, id: int) -> tuple[NetworkPort, float] | None:
        """The port of an id and the time when it was set, or None."""
        return self._learned_ports.get(id)

    def set(self, id: int, port: NetworkPort, now: float) -> None:
        """Set the port of an id."""
        self.remove(id)
        self._learned_ports[id] = (port, now)
        ids = self._hosts.setdefault(port.host, OrderedDict())
        ids[id] = None
        if len(ids) > self._bounds.per_host:
            self.remove(next(iter(ids)))
        if len(self._learned_ports) > self._bounds.total:
            self.remove(next(iter(self._learned_ports)))

    def remove(self, id: int) -> None:
        """Remove an id; unknown ids are ignored."""
        if id not in self._learned_ports:
            return
        port, _ = self._learned_ports.pop(id)
        ids = self._hosts[port.host]
        del ids[id]
        if not ids:
            del self._hosts[port.host]

    def remove_older(self, than: float) -> None:
        """Remove the ids that were set before or at this time."""
        while self._learned_ports and next(iter(self._learned_ports.values()))[1] <= than:
            self.remove(next(iter(self._learned_ports)))

    def remove_port(self, port: NetworkPort) -> list[int]:
        """Remove the ids of a port; returns them."""
        ids = [id for id, (known, _) in self._learned_ports.items() if known == port]
        for id in ids:
            self.remove(id)
        return ids


class AddressBook:
    """Static addresses, and learned ones, which expire; the least recently heard is forgotten first.

    An exact static address takes precedence over a learned one, and that over a static one with wildcards.
    """

    def __init__(
        self,
        static: StaticAddresses | None = None,
        *,
        bounds: IdBounds = IdBounds(),  # noqa: B008 - immutable
        lifetime: float = ADDRESS_LIFETIME,
    ) -> None:
        self._learned = LearnedAddresses(bounds)
        self._lifetime = lifetime
        self.set_static(static or {})

    def set_static(self, static: StaticAddresses) -> None:
        """Replace the static addresses; the learned ones are kept."""
        self._static = tuple((id, tuple(ports)) for id, ports in static.items())
        self._exact = {id: ports[0] for id, ports in self._static if ports and not addressing.is_wildcard(id)}
        self._patterns = [(id, ports[0]) for id, ports in self._static if ports and addressing.is_wildcard(id)]

    def __len__(self) -> int:
        return len(self._static) + len(self._learned)

    def __iter__(self) -> Iterator[tuple[int, NetworkPort, float | None]]:
        """Id, address, and the time when it was last heard; None for static addresses."""
        yield from ((id, port, None) for id, ports in self._static for port in ports)
        yield from ((id, port, heard) for id, port, heard in self._learned)

    def find(self, id: int, now: float) -> NetworkPort | None:
        """The address of this id, or None."""
        static = self._exact.get(id)
        if static is not None:
            return static
        learned = self._learned.get(id)
        if learned is not None:
            if now - learned[1] < self._lifetime:
                return learned[0]
            self._learned.remove(id)
        return next((port for pattern, port in self._patterns if addressing.reaches(pattern, id)), None)

    def learn(self, id: int, port: NetworkPort, now: float) -> bool:
        """Set the address of the source of a packet; true when it is new or has changed."""
        if id in self._exact:
            return False
        known = self._learned.get(id)
        self._learned.remove_older(now - self._lifetime)
        self._learned.set(id, port, now)
        return known is None or known[0] != port or now - known[1] >= self._lifetime

    def forget(self, port: NetworkPort) -> list[int]:
        """Remove what was learned from this address, as when a connection was closed; returns the ids."""
        return self._learned.remove_port(port)

    def static_matching(self, destination: int) -> list[NetworkPort]:
        """The static addresses that a broadcast may be for, each once."""
        found = (port for id, ports in self._static if _intersects(destination, id) for port in ports)
        return list(dict.fromkeys(found))


def _intersects(one: int, other: int) -> bool:
    """True when both address some common id."""
    for shift, mask in ((16, 0xFFFF), (8, 0xFF), (0, 0xFF)):
        a, b = one >> shift & mask, other >> shift & mask
        if a != b and mask not in (a, b):
            return False
    return True


MAX_COMPONENTS: Final = 1024
MAX_UDP_COMPONENTS: Final = 256
"""Components by UDP among these: any user of this machine can send UDP, and must leave room for those with a socket."""

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

    def set_max_sockets(self, number: int) -> None:
        """Change the bound; components that are registered stay."""
        self._max_sockets = number

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
