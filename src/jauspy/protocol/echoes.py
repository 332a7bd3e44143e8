"""What a node manager has multicast lately, to know it when the network brings it back."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MEMORY: Final = 1024
"""Datagrams to remember; a copy comes back within one turn of the event loop or two."""


class Echoes:
    """Remembers datagrams by their hash, the newest `limit` of them."""

    def __init__(self, limit: int = MEMORY) -> None:
        self._hashes: OrderedDict[int, None] = OrderedDict()
        self._limit = limit

    def __contains__(self, datagram: bytes) -> bool:
        return bool(self._hashes) and hash(datagram) in self._hashes

    def add(self, datagram: bytes) -> None:
        """Remember one; several copies may come back, one per interface."""
        key = hash(datagram)
        self._hashes[key] = None
        self._hashes.move_to_end(key)
        if len(self._hashes) > self._limit:
            self._hashes.popitem(last=False)
