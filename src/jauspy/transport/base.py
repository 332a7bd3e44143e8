"""The contract of transports, and what they share: reading datagram sockets, and queues for what cannot be sent yet."""

from __future__ import annotations

import asyncio
import socket
from collections import deque
from collections.abc import Callable, Mapping
from typing import Any, Final, Protocol, TypeAlias, runtime_checkable

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import Location

Receiver: TypeAlias = Callable[[bytes], None]

DATAGRAMS_PER_WAKEUP: Final = 64
MAX_DATAGRAM: Final = 65536
MAX_QUEUED: Final = 512
MAX_QUEUED_BYTES: Final = 4 << 20
"""Messages of 64 kB would need too much memory at `MAX_QUEUED`."""
PRIORITIES: Final = 4
_CONTROL_PRIORITY: Final = PRIORITIES - 1
LOW_PRIORITY_TURN: Final = 16
"""Every 16th datagram is one of the lowest priority, so that these are late, but not starved."""


class Transport(Protocol):
    """Carries JUDP datagrams of one component, one packet each.

    The owner sets `received` before `open`; it is called in the event loop with each received datagram.
    """

    id: JausID
    received: Receiver

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


def ignore(datagram: bytes) -> None:
    """The receiver of a transport without an owner."""


def start_reading(
    loop: asyncio.AbstractEventLoop,
    sock: socket.socket,
    take: Callable[[bytes, Any], None],
    failed: Callable[[OSError], None],
) -> None:
    """Call `take(datagram, sender)` for each datagram of a non-blocking socket until `stop_reading`.

    `failed` is called with the error of an earlier sent datagram; reading continues.
    """

    def drain() -> None:
        for _ in range(DATAGRAMS_PER_WAKEUP):
            try:
                datagram, sender = sock.recvfrom(MAX_DATAGRAM)
            except (BlockingIOError, InterruptedError):
                return
            except OSError as error:
                failed(error)
                return
            take(datagram, sender)

    loop.add_reader(sock, drain)


def stop_reading(loop: asyncio.AbstractEventLoop, sock: socket.socket) -> None:
    """Stop reading, and close the socket."""
    loop.remove_reader(sock)
    sock.close()


class SendQueue:
    """A bounded queue of datagrams for one destination, by priority; in order within a priority."""

    def __init__(self, limit: int = MAX_QUEUED) -> None:
        self._limit = limit
        self._queues: tuple[deque[bytes], ...] = tuple(deque() for _ in range(PRIORITIES))
        self._length = 0
        self._bytes = 0
        self._turn = 0

    def __len__(self) -> int:
        return self._length

    def push(self, datagram: bytes) -> int:
        """Append a datagram; returns how many were dropped for it, the oldest of the lowest priority first."""
        self._queues[_priority(datagram)].append(datagram)
        self._length += 1
        self._bytes += len(datagram)
        dropped = 0
        while self._length > self._limit or self._bytes > MAX_QUEUED_BYTES:
            self._take(next(queue for queue in self._queues if queue))
            dropped += 1
        return dropped

    def peek(self) -> bytes:
        """The datagram to send next; the queue must not be empty."""
        return self._next()[0]

    def pop(self) -> None:
        """Remove the datagram that `peek` returns."""
        self._take(self._next())
        self._turn = (self._turn + 1) % LOW_PRIORITY_TURN

    def drain(self, send: Callable[[bytes], object], count: int) -> None:
        """Send up to `count` datagrams; one for which `send` raises remains the next, and the exception propagates."""
        while self._length and count:
            queue = self._next()
            for _ in range(min(count, len(queue), LOW_PRIORITY_TURN - 1 - self._turn or 1)):
                send(queue[0])
                self._take(queue)
                self._turn = (self._turn + 1) % LOW_PRIORITY_TURN
                count -= 1

    def _next(self) -> deque[bytes]:
        low, standard, high, urgent = self._queues
        if self._turn == LOW_PRIORITY_TURN - 1:
            return low or standard or high or urgent
        return urgent or high or standard or low

    def _take(self, queue: deque[bytes]) -> None:
        self._bytes -= len(queue.popleft())
        self._length -= 1


def _priority(datagram: bytes) -> int:
    """The priority of a packet; control messages of the Junior protocol have the highest."""
    if junior.parse(datagram) is not None:
        return _CONTROL_PRIORITY
    return judp.peek_priority(datagram)
