"""Putting large messages together from pieces that arrive in any order, within bounds of memory and time.

A piece that is not kept must not be acknowledged, so that its sender learns the truth. For the same reason what came
with a promise to resend is never thrown away to make room for something else; it only expires.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.counters import Counters
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.duplicates import ECHO_WINDOW
from jauspy.protocol.header import Ack, DataFlag, Packet

FRAGMENT_OVERHEAD: Final = 256
"""Bytes of memory that a piece is charged with beyond its payload."""


def fragment_count(size: int) -> int:
    """How many packets a payload of this size takes."""
    return max(1, -(-size // header.MAX_PAYLOAD))


def fragment_at(payload: bytes, index: int) -> tuple[bytes, DataFlag]:
    """One piece of a payload, and what it is among the others."""
    last = fragment_count(len(payload)) - 1
    part = payload[index * header.MAX_PAYLOAD : (index + 1) * header.MAX_PAYLOAD]
    if last == 0:
        return part, DataFlag.SINGLE
    if index == 0:
        return part, DataFlag.FIRST
    return part, DataFlag.LAST if index == last else DataFlag.MIDDLE


@dataclass(slots=True)
class FragmentRun:
    """Pieces with consecutive numbers from `first` to `last`; a whole message when it `begins` and `ends`."""

    first: int
    last: int
    begins: bool
    ends: bool
    pieces: deque[bytes]
    size: int
    touched: float
    head: Packet

    @classmethod
    def of(cls, packet: Packet, now: float) -> FragmentRun:
        """The run of one piece."""
        flag, payload = packet.data_flag, packet.payload
        begins, ends = flag is DataFlag.FIRST, flag is DataFlag.LAST
        return cls(packet.sequence, packet.sequence, begins, ends, deque((payload,)), len(payload), now, packet)

    def __len__(self) -> int:
        return len(self.pieces)

    @property
    def whole(self) -> bool:
        """True when nothing is missing."""
        return self.begins and self.ends

    @property
    def cost(self) -> int:
        """Bytes of memory."""
        return self.size + FRAGMENT_OVERHEAD * len(self.pieces)

    def numbers(self) -> Iterator[int]:
        """The sequence numbers of the pieces."""
        return ((self.first + step) & 0xFFFF for step in range(len(self.pieces)))

    def join(self, after: FragmentRun) -> FragmentRun:
        """One run of this and the one that follows it; the longer one takes up the shorter one's pieces."""
        if len(after) > len(self):
            after.pieces.extendleft(reversed(self.pieces))
            pieces = after.pieces
        else:
            self.pieces.extend(after.pieces)
            pieces = self.pieces
        size, touched = self.size + after.size, max(self.touched, after.touched)
        return FragmentRun(self.first, after.last, self.begins, after.ends, pieces, size, touched, self.head)


MAX_SOURCES: Final = 256
CHECKS_PER_TIMEOUT: Final = 4
"""Looks for what has waited too long, in the time a piece may wait."""


@dataclass(slots=True)
class _Source:
    """The pieces of one sender. `starts` is in the order of the last change; `present` has a hash of each piece."""

    starts: dict[int, FragmentRun] = field(default_factory=dict)
    ends: dict[int, FragmentRun] = field(default_factory=dict)
    present: dict[int, int] = field(default_factory=dict)
    cost: int = 0

    def neighbours(self, run: FragmentRun) -> tuple[FragmentRun | None, FragmentRun | None]:
        """The runs of the same message that `run` continues, and that continue it."""
        before = self.ends.get((run.first - 1) & 0xFFFF)
        after = self.starts.get((run.last + 1) & 0xFFFF)
        return (
            None if run.begins or before is None or before.ends else before,
            None if run.ends or after is None or after.begins else after,
        )

    def add(self, run: FragmentRun) -> None:
        self.starts[run.first] = self.ends[run.last] = run
        self.cost += run.cost

    def remove(self, run: FragmentRun) -> None:
        del self.starts[run.first], self.ends[run.last]
        self.cost -= run.cost


class Reassembly:
    """Sans-I/O. Keys are a sender and whom it sends to, as 32-bit numbers."""

    def __init__(self, settings: Delivery, counters: Counters) -> None:
        self._settings = settings
        self._counters = counters
        self._sources: dict[tuple[int, int], _Source] = {}
        self._cost = 0
        self._check_at: float | None = None

    @property
    def memory(self) -> int:
        """Bytes that incomplete messages take now."""
        return self._cost

    def add(self, packet: Packet, content: int, now: float) -> tuple[bool, Packet | None]:
        """Take one piece; `content` is its hash. Returns whether it was kept, and the message that it completes."""
        key = (int(packet.source), int(packet.destination))
        known = self._sources.get(key)
        if known is not None and packet.sequence in known.present:
            if not _starts_again(known, packet, content, now):
                return True, None
            self._drop_all(key)
        if not self._make_room(key, FRAGMENT_OVERHEAD + len(packet.payload)):
            self._counters.drop("large_message.no_memory", packet.source)
            return False, None
        source = self._sources.setdefault(key, _Source())
        run = self._grown(source, FragmentRun.of(packet, now))
        if run is None:
            if not source.starts:
                del self._sources[key]
            self._counters.drop("large_message.too_large", packet.source)
            return False, None
        source.present[packet.sequence] = content
        if self._check_at is None:
            self._check_at = now + self._settings.patience
        return True, self._finished(key, run) if run.whole else None

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called, or None."""
        return self._check_at

    def handle_timeout(self, now: float) -> None:
        """Give up messages whose missing pieces stay out."""
        if self._check_at is None or now < self._check_at:
            return
        patience = self._settings.patience
        for key, source in list(self._sources.items()):
            for run in [run for run in source.starts.values() if now - run.touched >= patience]:
                self._drop(key, run, "incomplete")
        self._check_at = now + patience / CHECKS_PER_TIMEOUT if self._sources else None

    def _grown(self, source: _Source, run: FragmentRun) -> FragmentRun | None:
        """The run that a piece now belongs to; None when the message becomes too large with it."""
        before, after = source.neighbours(run)
        if sum(each.size for each in (before, run, after) if each) > self._settings.max_message:
            return None
        self._cost -= source.cost
        if before is not None:
            source.remove(before)
            run = before.join(run)
        if after is not None:
            source.remove(after)
            run = run.join(after)
        source.add(run)
        self._cost += source.cost
        return run

    def _finished(self, key: tuple[int, int], run: FragmentRun) -> Packet:
        self._remove(key, run)
        return replace(run.head, payload=b"".join(run.pieces), data_flag=DataFlag.SINGLE)

    def _make_room(self, key: tuple[int, int], needed: int) -> bool:
        """Drop the oldest that nobody resends, of this source, then of the largest; false if that is not enough."""
        limits = self._settings
        while key in self._sources and self._sources[key].cost + needed > limits.source_memory:
            if not self._drop_oldest(key):
                return False
        while self._sources and (self._cost + needed > limits.total_memory or self._is_full_for(key)):
            if not self._drop_oldest(max(self._sources, key=lambda each: self._sources[each].cost)):
                return False
        return needed <= limits.total_memory

    def _is_full_for(self, key: tuple[int, int]) -> bool:
        return len(self._sources) >= MAX_SOURCES and key not in self._sources

    def _drop_oldest(self, key: tuple[int, int]) -> bool:
        run = next((run for run in self._sources[key].starts.values() if run.head.ack is not Ack.REQUIRED), None)
        if run is not None:
            self._drop(key, run, "no_memory")
        return run is not None

    def _drop_all(self, key: tuple[int, int]) -> None:
        for run in list(self._sources[key].starts.values()):
            self._drop(key, run, "restarted")

    def _drop(self, key: tuple[int, int], run: FragmentRun, reason: str) -> None:
        self._counters.drop(f"large_message.{reason}", f"{len(run)} pieces, {run.size} bytes from {run.head.source}")
        self._remove(key, run)

    def _remove(self, key: tuple[int, int], run: FragmentRun) -> None:
        source = self._sources[key]
        source.remove(run)
        self._cost -= run.cost
        for number in run.numbers():
            source.present.pop(number, None)
        if not source.starts:
            del self._sources[key]


def _starts_again(source: _Source, packet: Packet, content: int, now: float) -> bool:
    """A number that is there already: a resend, unless its bytes differ or its sender never resends."""
    if source.present[packet.sequence] != content:
        return True
    if packet.ack is Ack.REQUIRED or packet.data_flag is not DataFlag.FIRST:
        return False
    return now - source.starts[packet.sequence].touched > ECHO_WINDOW
