"""The components and services that Discovery knows, in a bounded table with entries that expire."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Set as AbstractSet
from dataclasses import dataclass
from itertools import product
from typing import Final, NamedTuple, TypeAlias

from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, JausID

MAX_COMPONENTS: Final = 256
"""Other components that may be registered."""
MAX_SERVICES: Final = 64
"""Services of one component that are kept; a message can carry 255."""


AddressPattern: TypeAlias = tuple[int, int, int]
"""Subsystem, node and component; each may be a wildcard."""
SearchFilters: TypeAlias = AbstractSet[str]
"""Parts of URIs."""


class OfferedService(NamedTuple):
    """A service a component offers."""

    uri: str
    major: int
    minor: int

    @property
    def size(self) -> int:
        """Bytes in a message: the URI, its length, two version numbers."""
        return len(self.uri) + 3


@dataclass(slots=True)
class _Registration:
    offers: tuple[OfferedService, ...]
    until: float


class Directory:
    """Services by component, each until some time (s). The own component does not expire, and always has room."""

    def __init__(self) -> None:
        self._entries: dict[JausID, _Registration] = {}

    def register(self, id: JausID, offers: Iterable[OfferedService], until: float = math.inf) -> bool:
        """Register or replace the services of a component; False when the table is full."""
        if id not in self._entries and len(self._entries) > MAX_COMPONENTS:
            return False
        # A registration that is repeated keeps its place, see `matching`.
        self._entries[id] = _Registration(tuple(dict.fromkeys(offers))[:MAX_SERVICES], until)
        return True

    def renew(self, id: JausID, until: float) -> None:
        """Extend the time of a component, if it is registered."""
        entry = self._entries.get(id)
        if entry is not None:
            entry.until = max(entry.until, until)

    def expire(self, now: float) -> None:
        """Remove the components whose time is over."""
        self._entries = {id: entry for id, entry in self._entries.items() if entry.until > now}

    def is_permanent(self, id: JausID) -> bool:
        """True for a component that does not expire: of the same program."""
        entry = self._entries.get(id)
        return entry is not None and entry.until == math.inf

    def remove(self, id: JausID) -> None:
        """Remove a component, permanent or not."""
        self._entries.pop(id, None)

    def forget(self, id: JausID) -> None:
        """Remove a component, if it is registered and not permanent."""
        if not self.is_permanent(id):
            self._entries.pop(id, None)

    def matching(self, wanted: Mapping[AddressPattern, SearchFilters]) -> dict[JausID, tuple[OfferedService, ...]]:
        """The services of the components addressed, which may be wildcards; those registered first come first.

        A service is included when its URI contains one of the filters for its component; an empty filter matches all.
        Each component is looked up eight times, whatever the size of the query.
        """
        found: dict[JausID, tuple[OfferedService, ...]] = {}
        for id, entry in self._entries.items():
            filters = set().union(*(wanted.get(where, ()) for where in _addresses(id)))
            if filters:
                found[id] = tuple(offer for offer in entry.offers if any(each in offer.uri for each in filters))
        return found

    def all(self) -> Mapping[JausID, tuple[OfferedService, ...]]:
        """All components in the order of their ids."""
        return {id: entry.offers for id, entry in sorted(self._entries.items())}


def _addresses(id: JausID) -> Iterator[AddressPattern]:
    """The addresses that match a component, from its own id to all wildcards."""
    return product((id.subsystem, ANY_SUBSYSTEM), (id.node, ANY_NODE), (id.component, ANY_COMPONENT))


def within(offers: Iterable[OfferedService], size: int) -> tuple[OfferedService, ...]:
    """The first offers, as many as take up to `size` bytes together."""
    kept: list[OfferedService] = []
    for offer in offers:
        size -= offer.size
        if size < 0:
            break
        kept.append(offer)
    return tuple(kept)
