"""The contract between a component and the way its datagrams travel."""

from __future__ import annotations

import asyncio
import socket
from collections import deque
from collections.abc import Callable, Mapping
from typing import Any, Final, Protocol, TypeAlias

from jauspy.ids import JausID
from jauspy.protocol import judp, junior

Receiver: TypeAlias = Callable[[bytes], None]


class Transport(Protocol):
    """Carries JUDP datagrams of one component, one packet each.

    The owner sets `received` before `open`; it is called in the event loop with each datagram that arrives.
    """

    id: JausID
    received: Receiver

    async def open(self) -> None:
        """Be ready to send and receive; raises `TransportError` when that is not possible."""

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count; never blocks and never raises."""

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Be the component of this id from now on; raises `TransportError` when it is taken, and then stays.

        `goodbye` is called before the old id is given up, and not at all when the new one is taken.
        """

    @property
    def connected(self) -> bool:
        """True while datagrams can be expected to arrive."""

    @property
    def waiting(self) -> int:
        """Datagrams that it was given and has not sent yet; of what can wait, large messages wait with their sender."""

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""


def ignore(datagram: bytes) -> None:
    """The receiver of a transport that nobody owns yet."""


DATAGRAMS_PER_WAKEUP: Final = 64
MAX_DATAGRAM: Final = 65536


def start_reading(
    loop: asyncio.AbstractEventLoop,
    sock: socket.socket,
    take: Callable[[bytes, Any], None],
    failed: Callable[[OSError], None],
) -> None:
    """Call `take(datagram, sender)` for each datagram of a non-blocking socket until it is detached.

    An error that a sent datagram left behind goes to `failed`, and reading goes on.
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
    """Stop reading and close the socket."""
    loop.remove_reader(sock)
    sock.close()


MAX_QUEUED: Final = 512
MAX_QUEUED_BYTES: Final = 4 << 20
"""In all; whole messages of 64 kB would be too much memory at `MAX_QUEUED`."""
PRIORITIES: Final = 4
URGENT: Final = PRIORITIES - 1
LOW_PRIORITY_TURN: Final = 16
"""Every so many datagrams it is the turn of the least urgent: they are late, but not starved."""


class SendQueue:
    """Datagrams for one destination, by their priority; within one priority in order."""

    def __init__(self, limit: int = MAX_QUEUED) -> None:
        self._limit = limit
        self._queues: tuple[deque[bytes], ...] = tuple(deque() for _ in range(PRIORITIES))
        self._length = 0
        self._bytes = 0
        self._turn = 0

    def __len__(self) -> int:
        return self._length

    def push(self, datagram: bytes) -> int:
        """Append; returns how many had to go for it, the oldest of the lowest priority first."""
        self._queues[_priority(datagram)].append(datagram)
        self._length += 1
        self._bytes += len(datagram)
        dropped = 0
        while self._length > self._limit or self._bytes > MAX_QUEUED_BYTES:
            self._take(next(queue for queue in self._queues if queue))
            dropped += 1
        return dropped

    def peek(self) -> bytes:
        """The datagram to send next; only when there is one."""
        return self._next()[0]

    def pop(self) -> None:
        """Remove what `peek` showed."""
        self._take(self._next())
        self._turn = (self._turn + 1) % LOW_PRIORITY_TURN

    def drain(self, send: Callable[[bytes], object], count: int) -> None:
        """Send the next `count`; one that raises stays the next, and its exception passes."""
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
    """The priority of a packet; control messages of the local protocol are urgent."""
    if junior.parse(datagram) is not None:
        return URGENT
    return judp.peek_priority(datagram)
