"""Drops received commands that waited while this process did not run (ADR 84), and detects old data in streams."""

from __future__ import annotations

import asyncio
import socket
import struct
import time
from collections.abc import Callable
from typing import Any, Final, TypeAlias

from jauspy.protocol import judp
from jauspy.protocol.counters import Counters

MAX_AGE: Final = 0.5
"""Seconds for which a command may wait in a socket or queue, unless it requests an ACK."""
UNCHECKED_TIME: Final = 0.05
"""Seconds after a socket was empty in which ages are not checked, since its datagrams are no older than that."""
MAX_DATAGRAM: Final = 65536
_SO_TIMESTAMPNS: Final = 35
"""Socket option of asm-generic/socket.h, which Python does not name."""
_TIMESTAMP: Final = struct.Struct("@qq")
_CONTROL_SPACE: Final = 64
MAX_UNACKNOWLEDGED: Final = 2.0
"""Seconds without any acknowledgement of TCP after which what was sent is too old to be sent again."""
_TCP_INFO: Final = struct.Struct("@24xI28xI")
"""Two fields of struct tcp_info of linux/tcp.h: tcpi_unacked, in packets, and tcpi_last_ack_recv, in ms."""

Receive: TypeAlias = Callable[[int], tuple[bytes, Any]]


class DatagramReader:
    """Reads a non-blocking socket, UDP or Unix; commands older than `max_age` seconds are dropped and counted.

    Linux time-stamps each datagram on arrival, soon after a first socket has requested it. The stamp is read only if
    the socket was not empty for a while, so that usual reading costs nothing extra. On other systems nothing is
    dropped. `skip` bytes precede the version byte.
    """

    def __init__(self, sock: socket.socket, counters: Counters, max_age: float = MAX_AGE, *, skip: int = 0) -> None:
        self.socket = sock
        self.skip = skip
        self.receive: Receive = sock.recvfrom
        """Receives without a check of age."""
        self._counters = counters
        self._max_age = max_age
        self._empty_at = float("-inf")
        try:
            sock.setsockopt(socket.SOL_SOCKET, _SO_TIMESTAMPNS, 1)
        except OSError:
            self._max_age = float("inf")

    def receiver(self, now: float) -> Receive:
        """The function to receive with: the socket's `recvfrom`, or one that drops what is too old.

        Both raise `OSError` like `recvfrom`, as does this method. `now` is the time of a monotonic clock.
        """
        if now - self._empty_at < UNCHECKED_TIME or self._max_age == float("inf"):
            return self.receive
        _, control, *_ = self.socket.recvmsg(0, _CONTROL_SPACE, socket.MSG_PEEK)
        return self._receive_new if _age(control) > self._max_age else self.receive

    def was_empty(self, now: float) -> None:
        """Note that `recvfrom` has found nothing, with the time before that call."""
        self._empty_at = now

    def _receive_new(self, size: int) -> tuple[bytes, Any]:
        while True:
            data, control, _, sender = self.socket.recvmsg(size, _CONTROL_SPACE)
            if _age(control) <= self._max_age or judp.may_be_late(data, self.skip):
                return data, sender
            self._counters.drop("stale", sender)


class StallDetector:
    """Detects that the event loop was blocked for longer than `max_age` seconds.

    A stream has no time stamps: after a stall, all of its data in the kernel may be old.
    """

    def __init__(self, max_age: float) -> None:
        self._loop = asyncio.get_running_loop()
        self._interval = max_age / 2
        self._timer: asyncio.TimerHandle | None = None
        if max_age < float("inf"):
            self._tick()

    @property
    def has_stalled(self) -> bool:
        """True in the turn of the event loop that follows a stall."""
        return self._timer is not None and self._loop.time() - self._timer.when() > 2 * self._interval

    def close(self) -> None:
        """Stop; a second call does nothing."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _tick(self) -> None:
        self._timer = self._loop.call_later(self._interval, self._tick)


class AckWatch:
    """Detects that a TCP peer acknowledges nothing of what was sent to it for `limit` seconds, as while a link is cut.

    The kernel keeps such data, and sends it again for up to a quarter of an hour. To be asked twice a second or so. On
    other systems than Linux nothing is detected.
    """

    def __init__(self, sock: socket.socket, now: float, limit: float = MAX_UNACKNOWLEDGED) -> None:
        self._socket = sock
        self._limit = limit
        self._acknowledged_at = now

    def is_overdue(self, now: float) -> bool:
        """True when data has waited for so long; `now` is the time of a monotonic clock."""
        try:
            info = self._socket.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, _TCP_INFO.size)
        except (AttributeError, OSError):
            return False
        packets, last = _TCP_INFO.unpack(info) if len(info) == _TCP_INFO.size else (0, 0)
        if not packets:
            self._acknowledged_at = now
        return now - self._acknowledged_at > self._limit and last > 1000 * self._limit


def _age(control: list[tuple[int, int, bytes]]) -> float:
    """Seconds since a datagram arrived; 0 without a time stamp of the kernel."""
    for level, kind, data in control:
        if level == socket.SOL_SOCKET and kind == _SO_TIMESTAMPNS and len(data) == _TIMESTAMP.size:
            seconds: int
            nanoseconds: int
            seconds, nanoseconds = _TIMESTAMP.unpack(data)
            return time.time() - seconds - nanoseconds * 1e-9
    return 0.0
