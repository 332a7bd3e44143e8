"""The components and services that Discovery knows of, in a bounded table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Final, NamedTuple

from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, JausID

MAX_COMPONENTS: Final = 256
"""Other components that may be registered at once."""
MAX_SERVICES: Final = 64
"""Services of one component that are kept; the wire allows 255, which no component comes near."""


class Offer(NamedTuple):
    """A service a component offers."""

    uri: str
    major: int
    minor: int


class Directory:
    """Services by component. The component itself is in it, and is never pushed out."""

    def __init__(self) -> None:
        self._offers: dict[JausID, tuple[Offer, ...]] = {}

    def register(self, id: JausID, offers: Iterable[Offer]) -> bool:
        """Replace what is known of a component; False when the table is full."""
        if id not in self._offers and len(self._offers) > MAX_COMPONENTS:
            return False
        self._offers[id] = tuple(dict.fromkeys(offers))[:MAX_SERVICES]
        return True

    def forget(self, id: JausID) -> None:
        """Remove a component; fine when it is not there."""
        self._offers.pop(id, None)

    def matching(self, subsystem: int, node: int, component: int) -> Iterator[tuple[JausID, tuple[Offer, ...]]]:
        """The components that an id addresses, wildcards understood, in order of their ids."""
        wanted = JausID(subsystem, node, component)
        for each in sorted(self._offers):
            if wanted.matches(each):
                yield each, self._offers[each]

    def all(self) -> Mapping[JausID, tuple[Offer, ...]]:
        """Everything, in order of the ids."""
        return dict(self.matching(ANY_SUBSYSTEM, ANY_NODE, ANY_COMPONENT))
