"""Bounded queues for datagrams that cannot be sent yet: by priority, and each sender in turn."""

from __future__ import annotations

import time
from collections import OrderedDict, deque
from collections.abc import Callable, Collection, Sequence
from itertools import islice
from typing import Final, TypeAlias

from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.transport.age import MAX_AGE

MAX_QUEUED: Final = 512
MAX_QUEUED_BYTES: Final = 4 << 20
"""Messages of 64 kB would need too much memory at `MAX_QUEUED`."""
DATAGRAM_OVERHEAD: Final = 128
"""Bytes that Python needs for a queued datagram besides its own."""
PRIORITIES: Final = 4
PRIORITY_SHARE: Final = 1 / 8
"""Part of a queue that each priority has for itself: a flood of urgent packets does not displace all others."""
LOW_PRIORITY_TURN: Final = 16
"""Every 16th datagram is one of the lowest priority, so that these are late, but not starved."""
MAX_CANDIDATES: Final = 8
"""Senders, and destinations of a sender, that are compared with the one that had most lately, to find who loses a
datagram."""
_CONTROL_PRIORITY: Final = PRIORITIES - 1
_DESTINATION: Final = slice(5, 9)
_SOURCE: Final = slice(9, 13)
"""The ids of destination and source in a datagram with one packet."""

_Entry: TypeAlias = tuple[bytes, float]
_Send: TypeAlias = Callable[[bytes], object]


class QueueMemory:
    """Bounds the memory of several queues together to `limit` bytes.

    When there is too much, the largest queue loses a datagram (`SendQueue.drop_one`), which is counted.
    """

    def __init__(self, limit: int, counters: Counters) -> None:
        self.bytes = 0
        self._limit = limit
        self._counters = counters
        self._queues: set[SendQueue] = set()

    def resize(self, queue: SendQueue, by: int) -> None:
        """Note that a queue has grown or shrunk by so many bytes."""
        self.bytes += by
        if queue:
            self._queues.add(queue)
        else:
            self._queues.discard(queue)

    def trim(self, queue: SendQueue) -> None:
        """Drop the excess, after this queue has grown."""
        while self.bytes > self._limit:
            average = self.bytes / len(self._queues)
            largest = queue if queue.bytes >= average else max(self._queues, key=lambda queued: queued.bytes)
            largest.drop_one()
            self._counters.drop("queue_memory", "the queues of all destinations are too long")


class _Flow:
    """Datagrams of one sender, in order."""

    __slots__ = ("_counts", "_most", "entries")

    def __init__(self) -> None:
        self.entries: deque[_Entry] = deque()
        self._counts: dict[bytes, int] | None = None
        """The number for each destination, counted from the first excess datagram."""
        self._most = b""
        """The destination that has most, or had most recently."""

    def append(self, datagram: bytes, since: float) -> None:
        self.entries.append((datagram, since))
        if self._counts is not None:
            self._count(self._counts, datagram)

    def pop(self) -> bytes:
        datagram, _ = self.entries.popleft()
        if self._counts is not None:
            self._forget(self._counts, datagram)
        return datagram

    def pop_excess(self) -> bytes:
        """Remove the oldest datagram for a destination that has many: it does not displace answers to others."""
        counts = self._counts
        if counts is None:
            counts = self._counts = {}
            for datagram, _ in self.entries:
                self._count(counts, datagram)
        destination = max(_candidates(counts, self._most), key=counts.__getitem__)
        index, datagram = next(
            (n, entry) for n, (entry, _) in enumerate(self.entries) if entry[_DESTINATION] == destination
        )
        del self.entries[index]
        self._forget(counts, datagram)
        return datagram

    def _count(self, counts: dict[bytes, int], datagram: bytes) -> None:
        destination = datagram[_DESTINATION]
        counts[destination] = counts.get(destination, 0) + 1
        if counts[destination] > counts.get(self._most, 0):
            self._most = destination

    def _forget(self, counts: dict[bytes, int], datagram: bytes) -> None:
        destination = datagram[_DESTINATION]
        if counts[destination] == 1:
            del counts[destination]
        else:
            counts[destination] -= 1


class _Flows:
    """Datagrams of one priority: those of a sender in order, and of each sender one in turn."""

    def __init__(self) -> None:
        self.length = 0
        self._flows: OrderedDict[bytes, _Flow] = OrderedDict()
        self._longest = b""
        """The sender that has most, or had most recently."""

    def append(self, datagram: bytes, now: float) -> None:
        """Append a datagram, with the time."""
        source = datagram[_SOURCE]
        flow = self._flows.get(source)
        if flow is None:
            flow = self._flows[source] = _Flow()
        flow.append(datagram, now)
        self.length += 1
        if source != self._longest:
            longest = self._flows.get(self._longest)
            if longest is None or len(flow.entries) > len(longest.entries):
                self._longest = source

    def peek(self) -> bytes:
        """The datagram whose turn it is."""
        return next(iter(self._flows.values())).entries[0][0]

    def pop(self) -> bytes:
        """Remove the datagram whose turn it is."""
        source, flow = next(iter(self._flows.items()))
        if len(self._flows) > 1:
            self._flows.move_to_end(source)
        return self._removed(source, flow, flow.pop())

    def pop_excess(self) -> bytes:
        """Remove a datagram of a sender that has many."""
        source = max(_candidates(self._flows, self._longest), key=lambda source: len(self._flows[source].entries))
        flow = self._flows[source]
        return self._removed(source, flow, flow.pop_excess())

    def pop_stale(self, oldest: float) -> list[bytes]:
        """Remove datagrams from before `oldest`, except those that may be late."""
        found: list[bytes] = []
        for source, flow in [*self._flows.items()]:
            if flow.entries[0][1] >= oldest:
                continue
            kept = _Flow()
            for datagram, since in flow.entries:
                if since >= oldest or judp.may_be_late(datagram):
                    kept.append(datagram, since)
                else:
                    found.append(datagram)
            if kept.entries:
                self._flows[source] = kept
            else:
                del self._flows[source]
        self.length -= len(found)
        return found

    def _removed(self, source: bytes, flow: _Flow, datagram: bytes) -> bytes:
        if not flow.entries:
            del self._flows[source]
        self.length -= 1
        return datagram


def _candidates(known: Collection[bytes], most: bytes) -> list[bytes]:
    """Some of them, with the one that lately had most: comparing all would take too long in a flood."""
    return [*islice(known, MAX_CANDIDATES), *((most,) if most in known else ())]


class SendQueue:
    """A bounded queue of datagrams for one destination, by priority; within a priority, each sender has its turn.

    Datagrams of a sender with the same priority remain in order. `memory` bounds the queue together
    with others.
    """

    def __init__(self, limit: int = MAX_QUEUED, max_age: float = MAX_AGE, memory: QueueMemory | None = None) -> None:
        self._limit = limit
        self._max_age = max_age
        self._memory = memory
        self._priorities = tuple(_Flows() for _ in range(PRIORITIES))
        self._length = 0
        self.bytes = 0
        """The memory that the queue needs."""
        self._turn = 0

    def __len__(self) -> int:
        return self._length

    def push(self, datagram: bytes) -> Sequence[bytes]:
        """Append a datagram; returns those that were dropped for it, see `drop_one`."""
        self._priorities[_priority(datagram)].append(datagram, time.monotonic())
        self._resize(1, len(datagram))
        if self._memory is not None:
            self._memory.trim(self)
        if self._length <= self._limit and self.bytes <= MAX_QUEUED_BYTES:
            return ()
        dropped = []
        while self._length > self._limit or self.bytes > MAX_QUEUED_BYTES:
            dropped.append(self.drop_one())
        return dropped

    def drop_one(self) -> bytes:
        """Remove and return a datagram of the lowest priority that has more than its share, or of the lowest.

        It is one of the sender with most datagrams, the oldest one for that sender's busiest destination. A sender that
        floods the queue therefore loses its own datagrams, and a client that requests too many answers loses its own
        answers.
        """
        filled = (priority for priority in self._priorities if priority.length > PRIORITY_SHARE * self._limit)
        flows = next(filled, None) or next(priority for priority in self._priorities if priority.length)
        dropped = flows.pop_excess()
        self._resize(-1, -len(dropped))
        return dropped

    def clear(self) -> int:
        """Remove all datagrams; returns how many."""
        count = self._length
        self._priorities = tuple(_Flows() for _ in range(PRIORITIES))
        self._resize(-count, count * DATAGRAM_OVERHEAD - self.bytes)
        return count

    def drop_stale(self) -> int:
        """Remove commands that have waited too long without ACK; returns how many. To be called before sending."""
        oldest, dropped = time.monotonic() - self._max_age, 0
        for flows in self._priorities:
            stale = flows.pop_stale(oldest)
            dropped += len(stale)
            self._resize(-len(stale), -sum(map(len, stale)))
        return dropped

    def peek(self) -> bytes:
        """The datagram to send next; the queue must not be empty."""
        return self._next().peek()

    def pop(self) -> None:
        """Remove the datagram that `peek` returns."""
        self._resize(-1, -len(self._next().pop()))
        self._turn = (self._turn + 1) % LOW_PRIORITY_TURN

    def drain(self, send: _Send, count: int) -> None:
        """Send up to `count` datagrams; one for which `send` raises remains the next, and the exception propagates."""
        while self._length and count:
            flows = self._next()
            send(flows.peek())
            self._resize(-1, -len(flows.pop()))
            self._turn = (self._turn + 1) % LOW_PRIORITY_TURN
            count -= 1

    def _next(self) -> _Flows:
        order = self._priorities if self._turn == LOW_PRIORITY_TURN - 1 else reversed(self._priorities)
        for queue in order:
            if queue.length:
                return queue
        raise IndexError("the queue is empty")

    def _resize(self, count: int, size: int) -> None:
        excess = size + count * DATAGRAM_OVERHEAD
        self._length += count
        self.bytes += excess
        if self._memory is not None:
            self._memory.resize(self, excess)


def _priority(datagram: bytes) -> int:
    """The priority of a packet; control messages of the Junior protocol have the highest."""
    if junior.parse(datagram) is not None:
        return _CONTROL_PRIORITY
    return judp.peek_priority(datagram)
