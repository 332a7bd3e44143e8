"""The way from the node manager to one component, which cannot delay the way to any other."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Callable
from typing import Final

from jauspy.protocol.counters import Counters
from jauspy.transport.outbox import Outbox

BURST: Final = 64
"""Datagrams sent from the queue before others get their turn."""

_GONE: Final = (errno.ECONNREFUSED, errno.ENOENT, errno.ENOTCONN)


class Mailbox:
    """A connected socket of its own, and a queue for what the component is too slow to take.

    A datagram that a component has not read yet fills its receive queue and its sender's send buffer. With one sender
    for all, a component that stops reading would silence the others as soon as that buffer is full.
    `gone` is called when nobody listens on `path` any more.
    """

    def __init__(self, path: str, counters: Counters, gone: Callable[[str], None]) -> None:
        self._path = path
        self._counters = counters
        self._gone = gone
        self._loop = asyncio.get_running_loop()
        self._socket: socket.socket | None = None
        self._waiting = Outbox()

    def __len__(self) -> int:
        return len(self._waiting)

    def send(self, datagram: bytes) -> None:
        """Send now, or as soon as the component reads; what does not fit the queue is dropped and counted."""
        if not self._waiting and (self._sent(datagram) or self._try(datagram)):
            return
        if not self._waiting and self._socket is not None:
            self._loop.add_writer(self._socket, self._drain)
        for _ in range(self._waiting.push(datagram)):
            self._counters.drop("queue_full", self._path)

    def refresh(self) -> None:
        """The component has introduced itself: it may be a new one, on a new socket under the old name."""
        self._disconnect()
        if self._waiting:
            self._drain()
        if self._waiting and self._socket is not None:
            self._loop.add_writer(self._socket, self._drain)

    def close(self) -> None:
        """Forget the component, and count what waited for it; a second call does nothing."""
        self._disconnect()
        for _ in range(len(self._waiting)):
            self._counters.drop("component_gone", self._path)
        self._waiting = Outbox()

    def _drain(self) -> None:
        for _ in range(BURST):
            if not self._waiting:
                break
            if not self._try(self._waiting.peek()):
                return
            if self._waiting:
                self._waiting.pop()
        if not self._waiting and self._socket is not None:
            self._loop.remove_writer(self._socket)

    def _sent(self, datagram: bytes) -> bool:
        """The usual case; false sends it the careful way."""
        if self._socket is None:
            return False
        try:
            self._socket.send(datagram)
        except OSError:
            return False
        return True

    def _try(self, datagram: bytes) -> bool:
        """False when it must wait; true when it was sent, or is lost because the component is gone."""
        try:
            self._attempt(datagram)
        except BlockingIOError:
            return False
        except OSError as error:
            self._lost(error)
        return True

    def _attempt(self, datagram: bytes) -> None:
        if self._socket is not None:
            try:
                self._socket.send(datagram)
            except OSError as error:
                if error.errno not in _GONE:
                    raise
                self._disconnect()
            else:
                return
        self._connect().send(datagram)

    def _lost(self, error: OSError) -> None:
        self._counters.drop("component_gone" if error.errno in _GONE else "local_send", error)
        if error.errno in _GONE:
            if self._waiting:
                self._waiting.pop()  # the one that was counted just now
            self.close()
            self._gone(self._path)

    def _connect(self) -> socket.socket:
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        try:
            sock.setblocking(False)
            sock.connect(self._path)
        except OSError:
            sock.close()
            raise
        self._socket = sock
        return sock

    def _disconnect(self) -> None:
        sock, self._socket = self._socket, None
        if sock is not None:
            self._loop.remove_writer(sock)
            sock.close()
