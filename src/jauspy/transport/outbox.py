"""What waits for one component that does not read: bounded; the most urgent goes first, the least urgent is dropped."""

from __future__ import annotations

from collections import deque
from typing import Final

from jauspy.protocol import header

MAX_WAITING: Final = 512
PRIORITIES: Final = 4
URGENT: Final = PRIORITIES - 1


class Outbox:
    """Datagrams for one destination, by their priority; within one priority in order."""

    def __init__(self, limit: int = MAX_WAITING) -> None:
        self._limit = limit
        self._queues: tuple[deque[bytes], ...] = tuple(deque() for _ in range(PRIORITIES))
        self._length = 0

    def __len__(self) -> int:
        return self._length

    def push(self, datagram: bytes) -> bool:
        """Append; False when the oldest datagram of the lowest priority had to go for it."""
        self._queues[_priority(datagram)].append(datagram)
        self._length += 1
        if self._length <= self._limit:
            return True
        next(queue for queue in self._queues if queue).popleft()
        self._length -= 1
        return False

    def peek(self) -> bytes:
        """The datagram to send next; only when there is one."""
        return next(queue for queue in reversed(self._queues) if queue)[0]

    def pop(self) -> None:
        """Remove what `peek` showed."""
        next(queue for queue in reversed(self._queues) if queue).popleft()
        self._length -= 1


def _priority(datagram: bytes) -> int:
    """The priority of a packet that the core has checked; control messages of the local protocol are urgent."""
    if datagram[0] != 2:
        return URGENT
    return datagram[header.control_offset(datagram)] & 3
