"""Which network address a JAUS id was last heard from; bounded, because peers fill it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from typing import Final, TypeAlias

Address: TypeAlias = tuple[str, int]
"""Host and port, as sockets give them."""

MAX_LEARNED: Final = 4096


class AddressBook:
    """Static entries, which never change, and learned ones, of which the least recently heard is forgotten first.

    Keys are ids as 32-bit numbers.
    """

    def __init__(self, static: Mapping[int, Address] | None = None, *, limit: int = MAX_LEARNED) -> None:
        self._static = dict(static or {})
        self._learned: OrderedDict[int, Address] = OrderedDict()
        self._limit = limit

    def __len__(self) -> int:
        return len(self._static) + len(self._learned)

    def find(self, id: int) -> Address | None:
        """Where to send what is for this id."""
        return self._static.get(id) or self._learned.get(id)

    def learn(self, id: int, address: Address) -> bool:
        """Remember the source address of a packet; True when that is news."""
        if id in self._static:
            return False
        news = self._learned.get(id) != address
        self._learned[id] = address
        self._learned.move_to_end(id)
        if len(self._learned) > self._limit:
            self._learned.popitem(last=False)
        return news
