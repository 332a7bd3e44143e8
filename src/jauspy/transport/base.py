"""The contract of transports, and what they share: reading datagram sockets, and queues for what cannot be sent yet."""

from __future__ import annotations

import asyncio
import socket
import time
from collections import deque
from collections.abc import Callable, Mapping
from itertools import islice
from typing import Any, Final, Protocol, TypeAlias, runtime_checkable

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import Location
from jauspy.protocol.counters import Counters
from jauspy.transport.age import MAX_AGE, MAX_DATAGRAM, DatagramReader

Receiver: TypeAlias = Callable[[bytes], None]

DATAGRAMS_PER_WAKEUP: Final = 64
MAX_QUEUED: Final = 512
MAX_QUEUED_BYTES: Final = 4 << 20
"""Messages of 64 kB would need too much memory at `MAX_QUEUED`."""
DATAGRAM_OVERHEAD: Final = 128
"""Bytes that Python needs for a queued datagram besides its own."""
PRIORITIES: Final = 4
_CONTROL_PRIORITY: Final = PRIORITIES - 1
MAX_CANDIDATES: Final = 16
"""Oldest datagrams of which one is dropped when a queue is full."""
_SOURCE: Final = slice(9, 13)
"""The id of the source in a datagram with one packet."""
LOW_PRIORITY_TURN: Final = 16
"""Every 16th datagram is one of the lowest priority, so that these are late, but not starved."""


class Transport(Protocol):
    """Carries JUDP datagrams of one component, one packet each.

    The owner sets `received` before `open`; it is called in the event loop with each received datagram. Those that
    waited longer than `max_age` seconds, while nobody read, are dropped unless they are acknowledged.
    """

    id: JausID
    received: Receiver
    max_age: float

    async def open(self) -> None:
        """Open sockets or devices; raises `TransportError`."""

    async def close(self) -> None:
        """Close everything; a second call does nothing."""

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count; never blocks and never raises."""

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; raises `TransportError` when the new one is in use, and keeps the old one.

        `on_leave` is called before the old id is given up, unless the new one is in use.
        """

    @property
    def connected(self) -> bool:
        """True while sent datagrams can be expected to arrive."""

    @property
    def waiting(self) -> int:
        """The number of queued datagrams; while there are many, the endpoint holds back large messages."""

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""


@runtime_checkable
class LocatingTransport(Transport, Protocol):
    """A transport that knows where other components are."""

    def locate(self, id: JausID, found: Callable[[Location], None]) -> None:
        """Call `found`, now or later, with the machine of a component, which may be unknown."""


@runtime_checkable
class AddressedTransport(Transport, Protocol):
    """A transport that sends to addresses of hosts."""

    def host_towards(self, id: JausID) -> str | None:
        """The host to which datagrams for a component go; None if it is not known yet."""


@runtime_checkable
class ClashAwareTransport(Transport, Protocol):
    """A transport that knows whether another machine uses the id of its component."""

    async def id_clash(self) -> str | None:
        """The address of a machine or program that used this id in the last seconds; None if there is none."""


def ignore(datagram: bytes) -> None:
    """The receiver of a transport without an owner."""


def start_reading(
    loop: asyncio.AbstractEventLoop,
    reader: DatagramReader,
    take: Callable[[bytes, Any], None],
    failed: Callable[[OSError], None],
    *,
    take_is_fast: bool = False,
) -> None:
    """Call `take(datagram, sender)` for each datagram of a non-blocking socket until `stop_reading`.

    `failed` is called with the error of an earlier sent datagram; reading continues. What the reader finds too old is
    dropped; unless `take_is_fast`, this holds for what waits during `take`, too.
    """

    def drain() -> None:
        now, receive = 0.0, reader.receive
        for count in range(DATAGRAMS_PER_WAKEUP):
            try:
                if not (count and take_is_fast):
                    now = time.monotonic()
                    receive = reader.receiver(now)
                datagram, sender = receive(MAX_DATAGRAM)
            except (BlockingIOError, InterruptedError):
                reader.was_empty(now)
                return
            except OSError as error:
                failed(error)
                return
            take(datagram, sender)

    loop.add_reader(reader.socket, drain)


def stop_reading(loop: asyncio.AbstractEventLoop, sock: socket.socket) -> None:
    """Stop reading, and close the socket."""
    loop.remove_reader(sock)
    sock.close()


class QueueMemory:
    """Bounds the memory of several queues together to `limit` bytes.

    When there is too much, the largest queue loses the oldest of its lowest priority, which is counted.
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
        """Drop what is too much, after this queue has grown."""
        while self.bytes > self._limit:
            average = self.bytes / len(self._queues)
            largest = queue if queue.bytes >= average else max(self._queues, key=lambda each: each.bytes)
            largest.drop_one()
            self._counters.drop("queue_memory", "the queues of all destinations are too long")


class SendQueue:
    """A bounded queue of datagrams for one destination, by priority; in order within a priority.

    `memory` bounds it together with others.
    """

    def __init__(self, limit: int = MAX_QUEUED, max_age: float = MAX_AGE, memory: QueueMemory | None = None) -> None:
        self._limit = limit
        self._max_age = max_age
        self._memory = memory
        self._queues: tuple[deque[tuple[bytes, float]], ...] = tuple(deque() for _ in range(PRIORITIES))
        self._length = 0
        self.bytes = 0
        """The memory that the queue needs."""
        self._turn = 0

    def __len__(self) -> int:
        return self._length

    def push(self, datagram: bytes) -> int:
        """Append a datagram; returns how many were dropped for it, the oldest of the lowest priority first."""
        self._queues[_priority(datagram)].append((datagram, time.monotonic()))
        self._resize(1, len(datagram))
        if self._memory is not None:
            self._memory.trim(self)
        dropped = 0
        while self._length > self._limit or self.bytes > MAX_QUEUED_BYTES:
            self.drop_one()
            dropped += 1
        return dropped

    def drop_one(self) -> None:
        """Remove one of the oldest datagrams of the lowest priority: that of the source that has most of them.

        A source that floods the queue loses its own.
        """
        queue = next(queue for queue in self._queues if queue)
        sources = [datagram[_SOURCE] for datagram, _ in islice(queue, MAX_CANDIDATES)]
        self._take(queue, sources.index(max(sources, key=sources.count)))

    def clear(self) -> int:
        """Remove all datagrams; returns how many."""
        count = self._length
        for queue in self._queues:
            while queue:
                self._take(queue)
        return count

    def drop_stale(self) -> int:
        """Remove commands that have waited too long without ACK; returns how many. To be called before sending."""
        oldest, dropped = time.monotonic() - self._max_age, 0
        for queue in self._queues:
            if not queue or queue[0][1] >= oldest:
                continue
            for _ in range(len(queue)):
                datagram, since = queue.popleft()
                if since >= oldest or judp.may_be_late(datagram):
                    queue.append((datagram, since))
                else:
                    self._resize(-1, -len(datagram))
                    dropped += 1
        return dropped

    def peek(self) -> bytes:
        """The datagram to send next; the queue must not be empty."""
        return self._next()[0][0]

    def pop(self) -> None:
        """Remove the datagram that `peek` returns."""
        self._take(self._next())
        self._turn = (self._turn + 1) % LOW_PRIORITY_TURN

    def drain(self, send: Callable[[bytes], object], count: int) -> None:
        """Send up to `count` datagrams; one for which `send` raises remains the next, and the exception propagates."""
        while self._length and count:
            queue = self._next()
            for _ in range(min(count, len(queue), LOW_PRIORITY_TURN - 1 - self._turn or 1)):
                send(queue[0][0])
                self._take(queue)
                self._turn = (self._turn + 1) % LOW_PRIORITY_TURN
                count -= 1

    def _next(self) -> deque[tuple[bytes, float]]:
        low, standard, high, urgent = self._queues
        if self._turn == LOW_PRIORITY_TURN - 1:
            return low or standard or high or urgent
        return urgent or high or standard or low

    def _take(self, queue: deque[tuple[bytes, float]], place: int = 0) -> None:
        size = len(queue[place][0])
        del queue[place]
        self._resize(-1, -size)

    def _resize(self, count: int, size: int) -> None:
        by = size + count * DATAGRAM_OVERHEAD
        self._length += count
        self.bytes += by
        if self._memory is not None:
            self._memory.resize(self, by)


def _priority(datagram: bytes) -> int:
    """The priority of a packet; control messages of the Junior protocol have the highest."""
    if junior.parse(datagram) is not None:
        return _CONTROL_PRIORITY
    return judp.peek_priority(datagram)
