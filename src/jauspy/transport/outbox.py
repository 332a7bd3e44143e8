"""What waits for one component that does not read: bounded; the most urgent goes first, the least urgent is dropped."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Final

from jauspy.protocol import judp, junior

MAX_WAITING: Final = 512
MAX_BYTES: Final = 4 << 20
"""In all; whole messages of 64 kB would be too much memory at `MAX_WAITING`."""
PRIORITIES: Final = 4
URGENT: Final = PRIORITIES - 1
SHARE: Final = 16
"""Every so many datagrams it is the turn of the least urgent: they are late, but not starved."""


class Outbox:
    """Datagrams for one destination, by their priority; within one priority in order."""

    def __init__(self, limit: int = MAX_WAITING) -> None:
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
        while self._length > self._limit or self._bytes > MAX_BYTES:
            self._take(next(queue for queue in self._queues if queue))
            dropped += 1
        return dropped

    def peek(self) -> bytes:
        """The datagram to send next; only when there is one."""
        return self._next()[0]

    def pop(self) -> None:
        """Remove what `peek` showed."""
        self._take(self._next())
        self._turn = (self._turn + 1) % SHARE

    def drain(self, send: Callable[[bytes], object], count: int) -> None:
        """Send the next `count`; one that raises stays the next, and its exception passes."""
        while self._length and count:
            queue = self._next()
            for _ in range(min(count, len(queue), SHARE - 1 - self._turn or 1)):
                send(queue[0])
                self._take(queue)
                self._turn = (self._turn + 1) % SHARE
                count -= 1

    def _next(self) -> deque[bytes]:
        low, standard, high, urgent = self._queues
        if self._turn == SHARE - 1:
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
