"""Reading the network faster than it is routed, so that what is urgent overtakes a flood."""

from __future__ import annotations

import asyncio
import socket
from collections import deque
from collections.abc import Callable, Iterable
from typing import Any, Final

from jauspy.node import sieve
from jauspy.protocol import judp
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Priority

READ_BURST: Final = 384
"""Datagrams read from one socket per wake-up: three times what is routed, so that a flood piles up here, where the
urgent is found in it, and not in the kernel, which drops whatever comes last."""
ROUTE_BURST: Final = 128
"""Datagrams routed before the event loop gets its turn: a few milliseconds at most."""
SHARE: Final = 8
"""Of these, for the least urgent: while more urgent ones fill every turn, they are late, but not starved."""
MAX_WAITING: Final = 4096
"""Datagrams that wait in all; what comes beyond drops the oldest of the lowest priority."""
CROWDED: Final = 1024
"""With more than this waiting, the kernel is asked to drop what most of it is."""
CALM: Final = 256
"""With no more than this waiting, everything may come again."""
_BUFFER: Final = 65536
_PRIORITIES: Final = 4

Take = Callable[[bytes, UdpPort], None]
_Queue = deque[tuple[bytes, UdpPort]]


class Ingress:
    """`take(datagram, port)` gets the datagrams of all attached sockets, the most urgent of those that wait first.

    Within one priority they keep their order. In a flood the kernel drops what is no more urgent than most of it is;
    what is safety-critical is always read.
    """

    def __init__(self, take: Take, counters: Counters) -> None:
        self._loop = asyncio.get_running_loop()
        self._take = take
        self._counters = counters
        self._queues: tuple[_Queue, ...] = tuple(deque() for _ in range(_PRIORITIES))
        self._waiting = 0
        self._scheduled = False
        self._attached: list[socket.socket] = []
        self._held_back: list[socket.socket] = []

    def __len__(self) -> int:
        return self._waiting

    def attach(self, sock: socket.socket, network: str, failed: Callable[[OSError], None], *, skip: int = 0) -> None:
        """Read a non-blocking socket until `close`. `skip` bytes come before the packet's version byte.

        `failed` is told what became of sent datagrams that came back.
        """
        ports: dict[Any, UdpPort] = {}
        self._loop.add_reader(sock, self._wake, sock, network, skip, ports, failed)
        self._attached.append(sock)

    def close(self) -> None:
        """Read no more, and forget what waits; the sockets belong to the caller."""
        for sock in self._attached:
            self._loop.remove_reader(sock)
        self._attached.clear()
        self._held_back.clear()
        for queue in self._queues:
            queue.clear()
        self._counters["dropped.closed"] += self._waiting
        self._waiting = 0

    def _wake(
        self,
        sock: socket.socket,
        network: str,
        skip: int,
        ports: dict[Any, UdpPort],
        failed: Callable[[OSError], None],
    ) -> None:
        count = 0
        try:
            for count in range(READ_BURST):  # noqa: B007
                data, sender = sock.recvfrom(_BUFFER)
                port = ports.get(sender)
                if port is None:
                    if len(ports) > MAX_WAITING:
                        ports.clear()
                    port = ports[sender] = _port(sender, network)
                self._queues[judp.peek_priority(data, skip)].append((data, port))
            count = READ_BURST
        except (BlockingIOError, InterruptedError) as error:
            if not count:
                failed(error)
        except OSError as error:
            failed(error)
        self._waiting += count
        if self._waiting > CROWDED and count == READ_BURST and sock not in self._held_back:
            self._hold_back(sock, skip)
        if self._waiting > MAX_WAITING:
            self._drop(self._waiting - MAX_WAITING)
        if not self._scheduled:
            self._route()

    def _hold_back(self, sock: socket.socket, skip: int) -> None:
        below = 0
        for priority in (Priority.LOW, Priority.STANDARD, Priority.HIGH):
            below += len(self._queues[priority])
            if 2 * below > self._waiting and sieve.hold_back(sock, priority, skip):
                self._held_back.append(sock)
                self._counters["held_back"] += 1
                return

    def _let_through(self) -> None:
        for sock in self._held_back:
            sieve.let_through(sock)
        self._held_back.clear()

    def _drop(self, count: int) -> None:
        self._waiting -= count
        self._counters.drop("overload", "more arrives than can be routed")
        self._counters["dropped.overload"] += count - 1
        for queue in self._queues:
            for _ in range(min(count, len(queue))):
                queue.popleft()
                count -= 1

    def _route(self) -> None:
        self._scheduled = False
        left = self._route_from(reversed(self._queues), ROUTE_BURST - SHARE) + SHARE
        left = self._route_from(self._queues, left)
        self._waiting -= ROUTE_BURST - left
        if self._held_back and self._waiting <= CALM:
            self._let_through()
        if self._waiting:
            self._scheduled = True
            self._loop.call_soon(self._route)

    def _route_from(self, queues: Iterable[_Queue], left: int) -> int:
        """Route up to `left` datagrams; returns how many more it might have been."""
        take = self._take
        for queue in queues:
            count = min(left, len(queue))
            for _ in range(count):
                take(*queue.popleft())
            left -= count
        return left


def _port(sender: tuple[Any, ...], network: str) -> UdpPort:
    """A link-local IPv6 address means something only together with its interface."""
    host, port, *rest = sender
    return UdpPort(f"{host}%{rest[1]}" if len(rest) == 2 and rest[1] else host, port, network)
