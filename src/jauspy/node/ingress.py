"""Reads UDP datagrams faster than they are routed, and queues them by priority: urgent ones overtake a flood."""

from __future__ import annotations

import asyncio
import socket
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable
from typing import Any, Final, NamedTuple

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
"""Packets of the lowest priorities among these: they are late, not starved, while urgent ones fill every turn."""
MAX_QUEUED: Final = 4096
"""Queued datagrams; beyond that the oldest of the lowest priority is dropped."""
PRIORITY_SHARE: Final = 512
"""Packets of each priority among these: a flood of urgent packets does not displace all others."""
MAX_QUEUED_BYTES: Final = 16 << 20
"""Bytes of all queued datagrams; for datagrams of less than 4 kB on average, `MAX_QUEUED` is the tighter bound."""
FILTER_ABOVE: Final = 1024
"""Queued datagrams above which the kernel filter is attached for the priorities of most of them."""
UNFILTER_BELOW: Final = 256
"""Queued datagrams up to which the kernel filter is detached."""
SAMPLING_STEP: Final = 4
"""Factor by which the accepted share of safety-critical packets shrinks each time that most of a flood are such
packets."""
MIN_SAMPLING: Final = 1 / 64
_PRIORITIES: Final = 4
_PLAIN: Final = bytes((header.VERSION, 0))

Receive = Callable[[bytes, UdpPort], None]
_Queue = deque[tuple[bytes, UdpPort, float]]


class _Filter(NamedTuple):
    """The state of a socket's filter: it drops packets of these hosts, or of all hosts if empty."""

    share: float
    """The share of safety-critical packets that are accepted."""
    hosts: frozenset[str]


class Ingress:
    """Calls `receive(datagram, port)` for the datagrams of all attached sockets, by priority, in order within each.

    In a flood a kernel filter drops packets of the priorities that most of the flood has. If few hosts send most of it,
    only their packets are dropped. If most packets are safety-critical, the filter drops a random share of them.
    Packets above the rate limit of their source (`sources`) are not queued. A datagram that has waited for more than
    `max_age` seconds, in a socket or here, is dropped unless it is acknowledged.
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
        self._filtered: dict[socket.socket, _Filter] = {}

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
        if not self._queued and count <= ROUTE_BURST and size <= MAX_QUEUED_BYTES:
            self._route_all()
            return
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
        hosts, old = self._flooding_hosts(), self._filtered.get(sock)
        if old is not None:
            hosts = hosts | old.hosts if hosts and old.hosts else frozenset()
            hosts = hosts if len(hosts) <= kernel_filter.MAX_HOSTS else frozenset()
        if 2 * len(self._queues[Priority.SAFETY_CRITICAL]) > self._queued:
            share = max(MIN_SAMPLING, (1.0 if old is None else old.share) / SAMPLING_STEP)
            if old != (new := _Filter(share, hosts)):
                attached = kernel_filter.attach_sampling(sock, Priority.SAFETY_CRITICAL, share, skip, hosts)
                self._note_filter(sock, new, attached=attached)
            return
        if old is not None and old.hosts == hosts:
            return
        below = 0
        for priority in (Priority.LOW, Priority.STANDARD, Priority.HIGH):
            below += len(self._queues[priority])
            if 2 * below > self._queued:
                attached = kernel_filter.attach(sock, priority, skip, hosts)
                self._note_filter(sock, _Filter(1.0, hosts), attached=attached)
                return

    def _note_filter(self, sock: socket.socket, new: _Filter, *, attached: bool) -> None:
        if attached:
            self._filtered[sock] = new
            self._counters["kernel_filter.attached"] += 1

    def _flooding_hosts(self) -> frozenset[str]:
        """The smallest set of hosts that sent more than half of the queue; empty if they are too many for a filter."""
        counts = Counter(port.host for queue in self._queues for _, port, _ in queue)
        found, sum_ = [], 0
        for host, count in counts.most_common(kernel_filter.MAX_HOSTS):
            found.append(host)
            sum_ += count
            if 2 * sum_ > self._queued:
                return frozenset(found)
        return frozenset()

    def _detach_filters(self) -> None:
        for sock in self._filtered:
            kernel_filter.detach(sock)
        self._filtered.clear()

    def _drop_excess(self) -> None:
        for queue, share in [
            *((queue, PRIORITY_SHARE) for queue in self._queues),
            *((queue, 0) for queue in self._queues),
        ]:
            while len(queue) > share and (self._queued > MAX_QUEUED or self._bytes > MAX_QUEUED_BYTES):
                self._drop_oldest(queue, len(queue) - share)

    def _drop_oldest(self, queue: _Queue, most: int) -> None:
        """Drop up to `most` of the oldest datagrams of the host that has most in a queue."""
        host = Counter(port.host for _, port, _ in queue).most_common(1)[0][0]
        kept: _Queue = deque()
        while queue and most and (self._queued > MAX_QUEUED or self._bytes > MAX_QUEUED_BYTES):
            entry = queue.popleft()
            if entry[1].host == host:
                self._bytes -= len(entry[0])
                self._queued -= 1
                most -= 1
                self._counters.drop("overload", "more arrives than can be routed")
            else:
                kept.append(entry)
        queue.extendleft(reversed(kept))

    def _route_all(self) -> None:
        """Route the datagrams just read when nothing else is queued: the fast path of usual traffic."""
        receive = self._receive
        for queue in reversed(self._queues):
            while queue:
                data, port, _ = queue.popleft()
                receive(data, port)

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
