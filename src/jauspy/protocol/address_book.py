"""Which network address a JAUS id has: told by the configuration, or learned from where it was last heard."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Mapping, Sequence
from typing import Final, TypeAlias

from jauspy.protocol import addressing
from jauspy.protocol.addressing import NetworkPort

MAX_IDS: Final = 4096
MAX_IDS_PER_HOST: Final = 1024
"""Ids of one host, as many as a node manager has components. With more, its own are forgotten, not those of others."""


class LearnedAddresses:
    """Ids as 32-bit numbers; the one that was noted longest ago is forgotten first."""

    def __init__(self, limit: int = MAX_IDS, of_host: int = MAX_IDS_PER_HOST) -> None:
        self._limit = limit
        self._of_host = of_host
        self._places: OrderedDict[int, tuple[NetworkPort, float]] = OrderedDict()
        self._hosts: dict[str, OrderedDict[int, None]] = {}

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[tuple[int, NetworkPort, float]]:
        return iter([(id, *place) for id, place in self._places.items()])

    def get(self, id: int) -> tuple[NetworkPort, float] | None:
        """Where and when, if it is known."""
        return self._places.get(id)

    def note(self, id: int, port: NetworkPort, now: float) -> None:
        """It was heard there now."""
        self.drop(id)
        self._places[id] = (port, now)
        ids = self._hosts.setdefault(port.host, OrderedDict())
        ids[id] = None
        if len(ids) > self._of_host:
            self.drop(next(iter(ids)))
        if len(self._places) > self._limit:
            self.drop(next(iter(self._places)))

    def drop(self, id: int) -> None:
        """Forget it, if it is known."""
        if id not in self._places:
            return
        port, _ = self._places.pop(id)
        ids = self._hosts[port.host]
        del ids[id]
        if not ids:
            del self._hosts[port.host]

    def drop_older(self, than: float) -> None:
        """Forget what was not noted since."""
        while self._places and next(iter(self._places.values()))[1] <= than:
            self.drop(next(iter(self._places)))

    def drop_at(self, port: NetworkPort) -> None:
        """Forget all that was heard from there."""
        for id in [id for id, (known, _) in self._places.items() if known == port]:
            self.drop(id)


Address: TypeAlias = tuple[str, int]
"""Host and port, as sockets give them."""
StaticAddresses: TypeAlias = Mapping[int, Sequence[NetworkPort]]
"""Addresses by id, a 32-bit number which may have wildcards."""

ADDRESS_LIFETIME: Final = 600.0
"""Seconds without a word after which a learned address is forgotten, and asked for again."""


class AddressBook:
    """Static entries, which never change, and learned ones, which expire; the least recently heard is forgotten first.

    An exact static entry goes before a learned one, and that before a static one with wildcards.
    """

    def __init__(
        self, static: StaticAddresses | None = None, *, limit: int = MAX_IDS, lifetime: float = ADDRESS_LIFETIME
    ) -> None:
        self._learned = LearnedAddresses(limit)
        self._lifetime = lifetime
        self.tell(static or {})

    def tell(self, static: StaticAddresses) -> None:
        """Use these static entries from now on; what was learned stays."""
        self._static = tuple((id, tuple(ports)) for id, ports in static.items())
        self._exact = {id: ports[0] for id, ports in self._static if ports and not addressing.is_wildcard(id)}
        self._patterns = [(id, ports[0]) for id, ports in self._static if ports and addressing.is_wildcard(id)]

    def __len__(self) -> int:
        return len(self._static) + len(self._learned)

    def __iter__(self) -> Iterator[tuple[int, NetworkPort, float | None]]:
        """Id, address, and when it was heard last; None for what the configuration told."""
        yield from ((id, port, None) for id, ports in self._static for port in ports)
        yield from ((id, port, heard) for id, port, heard in self._learned)

    def find(self, id: int, now: float) -> NetworkPort | None:
        """Where to send what is for this id."""
        static = self._exact.get(id)
        if static is not None:
            return static
        learned = self._learned.get(id)
        if learned is not None:
            if now - learned[1] < self._lifetime:
                return learned[0]
            self._learned.drop(id)
        return next((port for pattern, port in self._patterns if addressing.reaches(pattern, id)), None)

    def learn(self, id: int, port: NetworkPort, now: float) -> bool:
        """Remember the source address of a packet; True when that is news."""
        if id in self._exact:
            return False
        known = self._learned.get(id)
        self._learned.drop_older(now - self._lifetime)
        self._learned.note(id, port, now)
        return known is None or known[0] != port or now - known[1] >= self._lifetime

    def forget(self, port: NetworkPort) -> None:
        """Nothing is reached there any more, as when a connection was closed."""
        self._learned.drop_at(port)

    def told_about(self, destination: int) -> list[NetworkPort]:
        """The static addresses of all that a broadcast may be for, each once: not every network has multicast."""
        found = (port for id, ports in self._static if _overlap(destination, id) for port in ports)
        return list(dict.fromkeys(found))


def _overlap(one: int, other: int) -> bool:
    """True when some id is addressed by both."""
    for shift, mask in ((16, 0xFFFF), (8, 0xFF), (0, 0xFF)):
        a, b = one >> shift & mask, other >> shift & mask
        if a != b and mask not in (a, b):
            return False
    return True
