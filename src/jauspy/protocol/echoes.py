"""What a node manager has multicast lately, to know it when a network brings it back."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MAX_ECHOES: Final = 1024
"""Datagrams to remember."""
ECHO_LIFETIME: Final = 2.0
"""Seconds; a copy comes back within a few turns of the event loop, and a peer may say the same again later."""


class MulticastEchoes:
    """Remembers datagrams by their hash and the network they are not to be taken from, the newest `limit` of them."""

    def __init__(self, limit: int = MAX_ECHOES) -> None:
        self._until: OrderedDict[tuple[int, str], float] = OrderedDict()
        self._limit = limit

    def heard(self, datagram: bytes, network: str, now: float) -> bool:
        """True when this network has brought back what was remembered for it."""
        return bool(self._until) and self._until.get((hash(datagram), network), now) > now

    def add(self, datagram: bytes, network: str, now: float) -> None:
        """Remember one; several copies may come back, one per interface."""
        key = (hash(datagram), network)
        self._until[key] = now + ECHO_LIFETIME
        self._until.move_to_end(key)
        if len(self._until) > self._limit:
            self._until.popitem(last=False)
