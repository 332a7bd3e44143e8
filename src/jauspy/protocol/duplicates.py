"""Which packets were seen before, without ever mistaking a restarted peer's first messages for old ones.

Sequence numbers alone do not tell: many components start at 1 each time. A packet is a duplicate when number and bytes
are the same and it comes within the time in which its sender, or the network, repeats packets. A number far behind the
newest one, or an old number with other bytes, is a restart: what was remembered of that source is forgotten.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, field
from typing import Final

MAX_SOURCES: Final = 256
MAX_NUMBERS: Final = 1024
"""Packets to remember of one source."""
LATE: Final = 256
"""How far behind the newest number a packet may be and still be a late one: more than any sender has under way."""
ECHO: Final = 0.05
"""Seconds in which the network may double a packet that nobody resends: two interfaces, or a faulty node manager."""


@dataclass(slots=True)
class _History:
    newest: int
    seen: OrderedDict[int, tuple[int, float]] = field(default_factory=OrderedDict)


class Duplicates:
    """Remembers packets by source, number and hash of their bytes. `memory` is in seconds, for packets with resends."""

    def __init__(self, memory: float) -> None:
        self._memory = memory
        self._sources: OrderedDict[int, _History] = OrderedDict()
        self.restarts = 0

    def seen(self, source: int, sequence: int, content: int, now: float, *, resent: bool) -> bool:
        """True when this packet was there before. `resent`: its sender repeats it until it is acknowledged."""
        history = self._sources.get(source)
        if history is None:
            return False
        known = history.seen.get(sequence)
        if known is not None:
            old, at = known
            if old == content:
                return now - at <= (self._memory if resent else ECHO)
            if now - at <= self._memory:
                self._forget(source)
        elif (history.newest - sequence) & 0xFFFF in range(LATE, 0x8000):
            self._forget(source)
        return False

    def add(self, source: int, sequence: int, content: int, now: float) -> None:
        """Remember a packet that was taken."""
        history = self._sources.get(source)
        if history is None:
            history = self._sources[source] = _History(sequence)
            if len(self._sources) > MAX_SOURCES:
                self._sources.popitem(last=False)
        elif (sequence - history.newest) & 0xFFFF < 0x8000:
            history.newest = sequence
        self._sources.move_to_end(source)
        history.seen[sequence] = (content, now)
        history.seen.move_to_end(sequence)
        if len(history.seen) > MAX_NUMBERS:
            history.seen.popitem(last=False)

    def _forget(self, source: int) -> None:
        del self._sources[source]
        self.restarts += 1
