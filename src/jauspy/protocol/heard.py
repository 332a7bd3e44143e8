"""Where and when ids were heard last, in bounds that no single host can fill."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator
from typing import Final

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
