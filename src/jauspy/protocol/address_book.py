"""Addresses of JAUS ids on networks: static ones of the configuration, and those learned from received packets."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Mapping, Sequence
from typing import Final, TypeAlias

from jauspy.protocol import addressing
from jauspy.protocol.addressing import NetworkPort

Address: TypeAlias = tuple[str, int]
"""Host and port, as sockets give them."""
StaticAddresses: TypeAlias = Mapping[int, Sequence[NetworkPort]]
"""Addresses by id, a 32-bit number which may have wildcards."""

ADDRESS_LIFETIME: Final = 600.0
"""Seconds without a packet after which a learned address expires."""
MAX_IDS: Final = 4096
MAX_IDS_PER_HOST: Final = 1024
"""Ids of one host, as many as a node manager has components; beyond that its own oldest are forgotten."""


class LearnedAddresses:
    """Port and time of each id, a 32-bit number; the one that was set longest ago is forgotten first."""

    def __init__(self, limit: int = MAX_IDS, per_host: int = MAX_IDS_PER_HOST) -> None:
        self._limit = limit
        self._per_host = per_host
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
        if len(ids) > self._per_host:
            self.remove(next(iter(ids)))
        if len(self._learned_ports) > self._limit:
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
        self, static: StaticAddresses | None = None, *, limit: int = MAX_IDS, lifetime: float = ADDRESS_LIFETIME
    ) -> None:
        self._learned = LearnedAddresses(limit)
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
