"""Sends no more to a link than it can carry, the most urgent packets first."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final, TypeAlias

from jauspy.protocol import judp
from jauspy.protocol.addressing import Port
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Priority
from jauspy.protocol.link_limits import BitBudget, LeftOut, LeftOutCounts, TotalLimit, message_code
from jauspy.transport.send_queue import QueueMemory, SendQueue

QUEUE_SECONDS: Final = 0.5
"""Seconds of a link's rate that wait for it at most: reports that are older than that help nobody."""
MIN_QUEUE_BYTES: Final = 16 << 10
"""Two of the largest packets, and what Python needs for some small ones."""


Transmit: TypeAlias = Callable[[Port, bytes], None]


class _Addressed(bytes):
    """A datagram that waits, with where it is sent."""

    port: Port


class LinkShaper:
    """Calls `transmit(port, datagram)` at the rate of a link; what exceeds it waits by priority, in a bounded queue.

    Safety-critical packets never wait; others wait for the room that these take. `link` is its name in counts.
    """

    def __init__(
        self,
        link: str,
        limit: TotalLimit,
        transmit: Transmit,
        *,
        counters: Counters,
        left_out: LeftOutCounts,
        max_age: float,
        memory: QueueMemory | None = None,
    ) -> None:
        self._link, self._limit = link, limit
        self._transmit = transmit
        self._counters, self._left_out = counters, left_out
        self._loop = asyncio.get_running_loop()
        self._budget = BitBudget(limit.rate)
        self._max_bytes = max(MIN_QUEUE_BYTES, round(limit.rate / 8.0 * QUEUE_SECONDS))
        self._queue = SendQueue(max_age=max_age, memory=memory)
        self._timer: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return len(self._queue)

    @property
    def queued_bytes(self) -> int:
        """The bytes of the queued datagrams."""
        return self._queue.bytes

    def send(self, port: Port, datagram: bytes) -> None:
        """Send now, or when the link has room; what does not fit into the queue is left out and counted."""
        now = self._loop.time()
        if judp.peek_priority(datagram) == Priority.SAFETY_CRITICAL or (not self._queue and self._budget.has_room(now)):
            self._send(port, datagram, now)
            return
        waiting = _Addressed(datagram)
        waiting.port = port
        for dropped in self._queue.push(waiting):
            self._leave_out(dropped)
        while self._queue.bytes > self._max_bytes:
            self._leave_out(self._queue.drop_one())
        self._wait(now)

    def close(self) -> None:
        """Drop what waits; a second call does nothing."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        for _ in range(self._queue.clear()):
            self._counters.drop("closed", self._link)

    def _send(self, port: Port, datagram: bytes, now: float) -> None:
        self._budget.spend(len(datagram), now)
        self._transmit(port, datagram)

    def _leave_out(self, datagram: bytes) -> None:
        self._counters.drop("link_full", self._link)
        self._left_out.add(LeftOut(self._link, self._limit.text, message_code(datagram)))

    def _wait(self, now: float) -> None:
        if self._timer is None and self._queue:
            self._timer = self._loop.call_at(self._budget.room_at(now), self._drain)

    def _drain(self) -> None:
        self._timer = None
        now = self._loop.time()
        for _ in range(self._queue.drop_stale()):
            self._counters.drop("stale", self._link)
        while self._queue and self._budget.has_room(now):
            datagram = self._queue.peek()
            self._queue.pop()
            assert isinstance(datagram, _Addressed)
            self._send(datagram.port, datagram, now)
        self._wait(now)
