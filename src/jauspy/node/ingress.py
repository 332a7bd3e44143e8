"""Ingress: datagrams of networks are read faster than they are routed, so that urgent ones overtake a flood."""

from __future__ import annotations

import asyncio
import socket
import time
from collections import deque
from collections.abc import Callable, Iterable
from typing import Any, Final

from jauspy.node import kernel_filter
from jauspy.protocol import header, judp
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Priority
from jauspy.protocol.sources import SourceChecks
from jauspy.transport.age import MAX_AGE, MAX_DATAGRAM, DatagramReader

READ_BURST: Final = 384
"""Datagrams read from one socket per wake-up: three times as many as are routed, so that a flood is queued here by
priority, and not in the kernel, which drops whatever arrives last."""
ROUTE_BURST: Final = 128
"""Datagrams routed before the event loop gets its turn: a few milliseconds at most."""
LOW_PRIORITY_SHARE: Final = 8
"""Of these, for the lowest priorities, so that they are late, but not starved, while urgent ones fill every turn."""
MAX_QUEUED: Final = 4096
"""Queued datagrams; beyond that the oldest of the lowest priority is dropped."""
PRIORITY_SHARE: Final = 512
"""Of these, for each priority: a flood of urgent packets does not displace all others."""
MAX_QUEUED_BYTES: Final = 16 << 20
"""Their bytes; for datagrams of less than 4 kB on average, `MAX_QUEUED` is the tighter bound."""
FILTER_ABOVE: Final = 1024
"""With more queued datagrams, the kernel filter is attached for the priorities of most of them."""
UNFILTER_BELOW: Final = 256
"""With no more queued datagrams, the kernel filter is detached."""
SAMPLING_STEP: Final = 4
"""By how much fewer safety-critical packets are accepted each time when most of a flood are such packets."""
MIN_SAMPLING: Final = 1 / 64
_PRIORITIES: Final = 4
_PLAIN: Final = bytes((header.VERSION, 0))

Receive = Callable[[bytes, UdpPort], None]
_Queue = deque[tuple[bytes, UdpPort, float]]


class Ingress:
    """Calls `receive(datagram, port)` for the datagrams of all attached sockets, by priority, in order within each.

    In a flood the kernel drops the priorities that most of it has; of safety-critical packets it drops some at random
    when most are such packets. What exceeds the rate of its source by `sources` is not even queued. What has waited for
    more than `max_age` seconds, in a socket or here, is dropped unless it is acknowledged.
    """

    def __init__(
        self,
        receive: Receive,
        counters: Counters,
        max_age: float = MAX_AGE,
        *,
        sources: SourceChecks | None = None,
    ) -> None:
        self._sources = sources
        self._loop = asyncio.get_running_loop()
        self._max_age = max_age
        self._receive = receive
        self._counters = counters
        self._queues: tuple[_Queue, ...] = tuple(deque() for _ in range(_PRIORITIES))
        self._queued = 0
        self._bytes = 0
        self._scheduled = False
        self._attached: list[socket.socket] = []
        self._skips: dict[str, int] = {}
        self._filtered: dict[socket.socket, float] = {}
        """Sockets with a filter, and the share of safety-critical packets that it accepts."""

    def __len__(self) -> int:
        return self._queued

    def attach(self, sock: socket.socket, network: str, failed: Callable[[OSError], None], *, skip: int = 0) -> None:
        """Read a non-blocking socket until `close`. `skip` bytes precede the packet's version byte.

        `failed(error)` is called with the errors of earlier sent datagrams.
        """
        ports: dict[Any, UdpPort] = {}
        reader = DatagramReader(sock, self._counters, self._max_age, skip=skip)
        self._loop.add_reader(sock, self._wake, reader, network, ports, failed)
        self._attached.append(sock)
        self._skips[network] = skip

    def close(self) -> None:
        """Stop reading, and drop queued datagrams; the sockets belong to the caller."""
        for sock in self._attached:
            self._loop.remove_reader(sock)
        self._attached.clear()
        self._filtered.clear()
        for queue in self._queues:
            queue.clear()
        self._counters["dropped.closed"] += self._queued
        self._queued = self._bytes = 0

    def _wake(
        self,
        reader: DatagramReader,
        network: str,
        ports: dict[Any, UdpPort],
        failed: Callable[[OSError], None],
    ) -> None:
        sock, skip = reader.socket, reader.skip
        count, refused, size, now = 0, 0, 0, time.monotonic()
        is_limited = self._sources is not None and self._sources.are_limited
        try:
            receive = reader.receiver(now)
            for count in range(READ_BURST):  # noqa: B007
                data, sender = receive(MAX_DATAGRAM)
                port = ports.get(sender)
                if port is None:
                    if len(ports) > MAX_QUEUED:
                        ports.clear()
                    port = ports[sender] = _port(sender, network)
                if is_limited and self._exceeds_rate(data, skip, now):
                    refused += 1
                    continue
                self._queues[judp.peek_priority(data, skip)].append((data, port, now))
                size += len(data)
            count = READ_BURST
        except (BlockingIOError, InterruptedError) as error:
            reader.was_empty(now)
            if not count:
                failed(error)
        except OSError as error:
            failed(error)
        self._queued += count - refused
        self._bytes += size
        if self._queued > FILTER_ABOVE and count == READ_BURST:
            self._attach_filter(sock, skip)
        if self._queued > MAX_QUEUED or self._bytes > MAX_QUEUED_BYTES:
            self._drop_excess()
        if not self._scheduled:
            self._route(now)

    def _exceeds_rate(self, data: bytes, skip: int, now: float) -> bool:
        """True, and counted, for a plain packet of a source that has exceeded its rate."""
        if self._sources is None or data[skip : skip + 2] != _PLAIN or len(data) < skip + header.OVERHEAD:
            return False
        source = int.from_bytes(data[skip + 9 : skip + 13], "little")
        if not self._sources.is_over_rate(source, data[skip + 4] & 3, now):
            return False
        self._counters.drop("rate", source)
        return True

    def _attach_filter(self, sock: socket.socket, skip: int) -> None:
        share = self._filtered.get(sock, 1.0) / SAMPLING_STEP
        if 2 * len(self._queues[Priority.SAFETY_CRITICAL]) > self._queued:
            if share >= MIN_SAMPLING and kernel_filter.attach_sampling(sock, Priority.SAFETY_CRITICAL, share, skip):
                self._filtered[sock] = share
                self._counters["kernel_filter.attached"] += 1
            return
        if sock in self._filtered:
            return
        below = 0
        for priority in (Priority.LOW, Priority.STANDARD, Priority.HIGH):
            below += len(self._queues[priority])
            if 2 * below > self._queued and kernel_filter.attach(sock, priority, skip):
                self._filtered[sock] = 1.0
                self._counters["kernel_filter.attached"] += 1
                return

    def _detach_filters(self) -> None:
        for sock in self._filtered:
            kernel_filter.detach(sock)
        self._filtered.clear()

    def _drop_excess(self) -> None:
        for queue, share in [*((each, PRIORITY_SHARE) for each in self._queues), *((each, 0) for each in self._queues)]:
            while len(queue) > share and (self._queued > MAX_QUEUED or self._bytes > MAX_QUEUED_BYTES):
                self._bytes -= len(queue.popleft()[0])
                self._queued -= 1
                self._counters.drop("overload", "more arrives than can be routed")

    def _route(self, now: float | None = None) -> None:
        self._scheduled = False
        oldest = (time.monotonic() if now is None else now) - self._max_age
        left = self._route_from(reversed(self._queues), ROUTE_BURST - LOW_PRIORITY_SHARE, oldest) + LOW_PRIORITY_SHARE
        if self._queued > ROUTE_BURST - left:
            left = self._route_from(self._queues, left, oldest)
        self._queued -= ROUTE_BURST - left
        if self._filtered and self._queued <= UNFILTER_BELOW:
            self._detach_filters()
        if self._queued:
            self._scheduled = True
            self._loop.call_soon(self._route)

    def _route_from(self, queues: Iterable[_Queue], left: int, oldest: float) -> int:
        """Route up to `left` datagrams; returns how many of them were not needed."""
        receive, size = self._receive, 0
        for queue in queues:
            count = min(left, len(queue))
            for _ in range(count):
                data, port, since = queue.popleft()
                size += len(data)
                if since < oldest and not judp.may_be_late(data, self._skips.get(port.network, 0)):
                    self._counters.drop("stale", port)
                else:
                    receive(data, port)
            left -= count
        self._bytes -= size
        return left


def _port(sender: tuple[Any, ...], network: str) -> UdpPort:
    """The port of a sender; a link-local IPv6 address is only valid with its interface."""
    host, port, *rest = sender
    return UdpPort(f"{host}%{rest[1]}" if len(rest) == 2 and rest[1] else host, port, network)
