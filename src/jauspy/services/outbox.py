"""What a component wants to send, in a bounded queue."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable
from typing import NamedTuple

from jauspy.ids import JausID
from jauspy.protocol.header import Broadcast, Priority


class Outgoing(NamedTuple):
    """One encoded message on its way out."""

    destination: JausID
    payload: bytes
    priority: Priority = Priority.STANDARD
    broadcast: Broadcast = Broadcast.NONE
    told: Callable[[bool], None] | None = None
    """With it, the message is sent again until it is acknowledged, or given up: this is told which."""


class OutputQueue:
    """First in, first out; when full, the oldest of the lowest priority is dropped and counted."""

    def __init__(self, limit: int, counters: Counter[str]) -> None:
        self._limit = limit
        self._counters = counters
        self._queue: deque[Outgoing] = deque()

    def put(self, outgoing: Outgoing) -> None:
        """Queue one more."""
        self._queue.append(outgoing)
        if len(self._queue) > self._limit:
            self._queue.remove(min(self._queue, key=lambda each: each.priority))
            self._counters["output_dropped"] += 1

    def drain(self) -> list[Outgoing]:
        """Everything that waits, oldest first; the queue is empty afterwards."""
        taken = list(self._queue)
        self._queue.clear()
        return taken
