"""Reassembly of large messages from fragments that arrive in any order, with bounds of memory and time.

A fragment that is not kept must not be acknowledged, so that its sender notices the loss. For the same reason a
fragment whose sender resends it is never dropped to make room for another; it only expires.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from jauspy.protocol.counters import Counters
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.duplicates import ECHO_WINDOW
from jauspy.protocol.header import Ack, DataFlag, Packet

FRAGMENT_OVERHEAD: Final = 256
"""Bytes of memory charged for a fragment in addition to its payload."""
MAX_SOURCES: Final = 256
CHECKS_PER_TIMEOUT: Final = 4
"""Number of checks of incomplete messages within `fragment_timeout`."""


@dataclass(slots=True)
class FragmentRun:
    """Fragments with consecutive numbers from `first` to `last`; a complete message when it `begins` and `ends`."""

    first: int
    last: int
    begins: bool
    ends: bool
    fragments: deque[bytes]
    size: int
    touched: float
    head: Packet

    @classmethod
    def of(cls, packet: Packet, now: float) -> FragmentRun:
        """The run of one fragment."""
        flag, payload = packet.data_flag, packet.payload
        begins, ends = flag is DataFlag.FIRST, flag is DataFlag.LAST
        return cls(
            packet.sequence,
            packet.sequence,
            begins,
            ends,
            deque((payload,)),
            size=len(payload),
            touched=now,
            head=packet,
        )

    def __len__(self) -> int:
        return len(self.fragments)

    @property
    def complete(self) -> bool:
        """True when no fragment is missing."""
        return self.begins and self.ends

    @property
    def cost(self) -> int:
        """Bytes of memory, with overhead."""
        return self.size + FRAGMENT_OVERHEAD * len(self.fragments)

    def numbers(self) -> Iterator[int]:
        """The sequence numbers of the fragments."""
        return ((self.first + step) & 0xFFFF for step in range(len(self.fragments)))

    def join(self, after: FragmentRun) -> FragmentRun:
        """One run of this and the one that follows it; the fragments of the shorter are added to the longer."""
        if len(after) > len(self):
            after.fragments.extendleft(reversed(self.fragments))
            fragments = after.fragments
        else:
            self.fragments.extend(after.fragments)
            fragments = self.fragments
        size, touched = self.size + after.size, max(self.touched, after.touched)
        return FragmentRun(
            self.first, after.last, self.begins, after.ends, fragments, size=size, touched=touched, head=self.head
        )


@dataclass(slots=True)
class _Source:
    """Fragments of one sender; `starts` in the order of the last change, `present` with a hash of each fragment."""

    starts: dict[int, FragmentRun] = field(default_factory=dict)
    ends: dict[int, FragmentRun] = field(default_factory=dict)
    present: dict[int, int] = field(default_factory=dict)
    cost: int = 0

    def neighbours(self, run: FragmentRun) -> tuple[FragmentRun | None, FragmentRun | None]:
        """The runs of the same message directly before and after `run`."""
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
    """Sans-I/O. Keys are source and destination as 32-bit numbers.

    The fragments of a message have consecutive sequence numbers, from a FIRST to a LAST one (AS5669A). A new fragment
    is joined with the runs that end before and begin after it, which two dictionaries find; a run with both ends is a
    message. So each fragment costs the same, whatever the order of arrival.
    """

    def __init__(self, settings: Delivery, counters: Counters) -> None:
        self._settings = settings
        self._counters = counters
        self._sources: dict[tuple[int, int], _Source] = {}
        self._cost = 0
        self._check_at: float | None = None

    @property
    def memory(self) -> int:
        """Bytes that incomplete messages occupy."""
        return self._cost

    def add(self, packet: Packet, content: int, now: float) -> tuple[bool, Packet | None]:
        """Add one fragment; `content` is its hash. Returns whether it was kept, and the message that it completes."""
        key = (int(packet.source), int(packet.destination))
        known = self._sources.get(key)
        # a number that is present: the fragment was resent, or its sender has begun again
        if known is not None and packet.sequence in known.present:
            if not _is_restart(known, packet, content, now):
                return True, None
            self._drop_all(key)
        if not self._make_room(key, FRAGMENT_OVERHEAD + len(packet.payload)):
            self._counters.drop("large_message.no_memory", packet.source)
            return False, None
        # join it with its neighbours, unless the message would become too large
        source = self._sources.setdefault(key, _Source())
        run = self._extend(source, FragmentRun.of(packet, now))
        if run is None:
            if not source.starts:
                del self._sources[key]
            self._counters.drop("large_message.too_large", packet.source)
            return False, None
        source.present[packet.sequence] = content
        if self._check_at is None:
            self._check_at = now + self._settings.fragment_timeout
        return True, self._complete(key, run) if run.complete else None

    def next_timeout(self) -> float | None:
        """Time at which `handle_timeout` is to be called, or None."""
        return self._check_at

    def handle_timeout(self, now: float) -> None:
        """Drop messages whose missing fragments did not arrive in time."""
        if self._check_at is None or now < self._check_at:
            return
        timeout = self._settings.fragment_timeout
        for key, source in list(self._sources.items()):
            for run in [run for run in source.starts.values() if now - run.touched >= timeout]:
                self._drop(key, run, "incomplete")
        self._check_at = now + timeout / CHECKS_PER_TIMEOUT if self._sources else None

    def _extend(self, source: _Source, run: FragmentRun) -> FragmentRun | None:
        """The run that contains the new fragment; None if the message would be too large."""
        before, after = source.neighbours(run)
        if sum(part.size for part in (before, run, after) if part) > self._settings.max_message:
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

    def _complete(self, key: tuple[int, int], run: FragmentRun) -> Packet:
        self._remove(key, run)
        return replace(run.head, payload=b"".join(run.fragments), data_flag=DataFlag.SINGLE)

    def _make_room(self, key: tuple[int, int], needed: int) -> bool:
        """Drop the oldest runs that nobody resends, of this source, then of the largest; false if not enough."""
        limits = self._settings
        # within the share of the source first, so that it displaces itself only
        while key in self._sources and self._sources[key].cost + needed > limits.source_memory:
            if not self._drop_oldest(key):
                return False
        # then within the total, at the expense of whoever has most
        while self._sources and (self._cost + needed > limits.total_memory or self._has_too_many_sources(key)):
            if not self._drop_oldest(max(self._sources, key=lambda source: self._sources[source].cost)):
                return False
        return needed <= limits.total_memory

    def _has_too_many_sources(self, key: tuple[int, int]) -> bool:
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
        self._counters.drop(f"large_message.{reason}", f"{len(run)} fragments, {run.size} bytes from {run.head.source}")
        self._remove(key, run)

    def _remove(self, key: tuple[int, int], run: FragmentRun) -> None:
        source = self._sources[key]
        source.remove(run)
        self._cost -= run.cost
        for number in run.numbers():
            source.present.pop(number, None)
        if not source.starts:
            del self._sources[key]


def _is_restart(source: _Source, packet: Packet, content: int, now: float) -> bool:
    """True if a known sequence number belongs to a new message: its bytes differ, or its sender does not resend."""
    if source.present[packet.sequence] != content:
        return True
    if packet.ack is Ack.REQUIRED or packet.data_flag is not DataFlag.FIRST:
        return False
    run = source.starts.get(packet.sequence)
    return run is None or not run.begins or now - run.touched > ECHO_WINDOW
