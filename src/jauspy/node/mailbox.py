"""The way from the node manager to one component, which cannot delay the way to any other."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Callable
from typing import Final

from jauspy.protocol.counters import Counters
from jauspy.transport.base import SendQueue

BURST: Final = 64
"""Datagrams sent from the queue before others get their turn."""
ATTEMPT_EVERY: Final = 8
"""Datagrams that have to wait until sending is tried again, without being told that there is room. In a flood that
takes too long: ten datagrams that a component can hold are read long before the event loop gets its turn."""

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
        self._direct: Callable[[bytes], object] | None = None
        """Sends at once; only while there is a socket and nothing waits."""
        self._waiting = SendQueue()
        self._watched = False
        self._untried = 0

    def __len__(self) -> int:
        return len(self._waiting)

    def send(self, datagram: bytes) -> None:
        """Send now, or as soon as the component reads; what does not fit the queue is dropped and counted."""
        if self._direct is not None:
            try:
                self._direct(datagram)
            except OSError:
                self._send_carefully(datagram)
        else:
            self._send_carefully(datagram)

    def _send_carefully(self, datagram: bytes) -> None:
        if not self._waiting:
            if self._try(datagram):
                return
            self._wait_for_room()
        for _ in range(self._waiting.push(datagram)):
            self._counters.drop("queue_full", self._path)
        self._untried += 1
        if self._untried == ATTEMPT_EVERY:
            self._drain()

    def refresh(self) -> None:
        """The component has introduced itself: it may be a new one, on a new socket under the old name."""
        self._disconnect()
        if self._waiting:
            self._drain()

    def close(self) -> None:
        """Forget the component, and count what waited for it; a second call does nothing."""
        self._disconnect()
        for _ in range(len(self._waiting)):
            self._counters.drop("component_gone", self._path)
        self._waiting = SendQueue()

    def _drain(self) -> None:
        self._untried = 0
        try:
            if self._socket is not None:
                self._waiting.drain(self._socket.send, BURST)
        except BlockingIOError:
            return
        except OSError:
            self._disconnect()
        if self._waiting and self._socket is None and self._try(self._waiting.peek()) and self._waiting:
            self._waiting.pop()
        if self._waiting:
            self._wait_for_room()
        elif self._socket is not None:
            self._stop_waiting(self._socket)
            self._direct = self._socket.send

    def _wait_for_room(self) -> None:
        self._direct, self._untried = None, 0
        if self._socket is not None and not self._watched:
            self._loop.add_writer(self._socket.fileno(), self._drain)
            self._watched = True

    def _stop_waiting(self, sock: socket.socket) -> None:
        if self._watched:
            self._loop.remove_writer(sock.fileno())
            self._watched = False

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
        if not self._waiting:
            self._direct = sock.send
        return sock

    def _disconnect(self) -> None:
        sock, self._socket, self._direct = self._socket, None, None
        if sock is not None:
            self._stop_waiting(sock)
            sock.close()
