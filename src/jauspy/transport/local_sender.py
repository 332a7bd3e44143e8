"""Sending to Unix datagram sockets whose queues are short: what does not fit waits here, and nobody waits for it."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Callable
from typing import Final

from jauspy.protocol.counters import Counters
from jauspy.transport.base import SendQueue

SEND_RETRY_INTERVAL: Final = 0.002
"""Seconds until a full queue is tried again; a datagram socket tells nobody when its queue has room."""
_NOT_LISTENING: Final = (errno.ECONNREFUSED, errno.ENOENT)


class LocalSender:
    """Sends on one socket to any path; per path a bounded queue. `gone(path)` is told when nobody listens there."""

    def __init__(self, sock: socket.socket, counters: Counters, gone: Callable[[str], None]) -> None:
        self._socket = sock
        self._counters = counters
        self._gone = gone
        self._outboxes: dict[str, SendQueue] = {}
        self._retry: asyncio.TimerHandle | None = None

    def send(self, path: str, datagram: bytes) -> None:
        """Send now, or as soon as there is room; never blocks, never raises, counts what it drops."""
        outbox = self._outboxes.get(path)
        if outbox is None:
            if self._try(path, datagram):
                return
            outbox = self._outboxes[path] = SendQueue()
        for _ in range(outbox.push(datagram)):
            self._counters.drop("queue_full", path)
        self._retry_later()

    def waiting(self, path: str) -> int:
        """Datagrams that there was no room for yet."""
        return len(self._outboxes.get(path, ()))

    def close(self) -> None:
        """Forget what waits; the socket belongs to the caller."""
        if self._retry is not None:
            self._retry.cancel()
            self._retry = None
        for path, outbox in self._outboxes.items():
            for _ in range(len(outbox)):
                self._counters.drop("closed", path)
        self._outboxes.clear()

    def _try(self, path: str, datagram: bytes) -> bool:
        try:
            self._socket.sendto(datagram, path)
        except BlockingIOError:
            return False
        except OSError as error:
            self._counters.drop("nobody_listens" if error.errno in _NOT_LISTENING else "not_sent", f"{path}: {error}")
            if error.errno in _NOT_LISTENING:
                self._gone(path)
        return True

    def _retry_later(self) -> None:
        if self._retry is None:
            self._retry = asyncio.get_running_loop().call_later(SEND_RETRY_INTERVAL, self._retry_all)

    def _retry_all(self) -> None:
        self._retry = None
        for path, outbox in list(self._outboxes.items()):
            while len(outbox) and self._try(path, outbox.peek()):
                outbox.pop()
            if not len(outbox):
                del self._outboxes[path]
        if self._outboxes:
            self._retry_later()
