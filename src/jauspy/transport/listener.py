"""Accepting stream connections."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable, Coroutine
from typing import Any, Final

from jauspy.protocol.counters import Counters

ACCEPT_BURST: Final = 8
"""Connections accepted for each wake-up."""
RETRY_INTERVAL: Final = 0.5
"""Seconds without accepting after the process or the system had no descriptor for a connection."""

StreamHandler = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Coroutine[Any, Any, None]]


class Listener:
    """Accepts connections on a listening socket, which it owns; `make_protocol()` is called for each.

    asyncio's own servers log each attempt that finds no free descriptor, and make more and more of them.
    """

    def __init__(
        self, sock: socket.socket, make_protocol: Callable[[], asyncio.BaseProtocol], counters: Counters
    ) -> None:
        sock.setblocking(False)
        self._loop = asyncio.get_running_loop()
        self._socket = sock
        self._make_protocol = make_protocol
        self._counters = counters
        self._tasks: set[asyncio.Task[None]] = set()
        self._retry: asyncio.TimerHandle | None = None
        self._listen()

    @property
    def port(self) -> int:
        """The TCP port."""
        return int(self._socket.getsockname()[1])

    def close(self) -> None:
        """Stop accepting; accepted connections stay open."""
        if self._retry is not None:
            self._retry.cancel()
        self._loop.remove_reader(self._socket)
        self._socket.close()

    def _listen(self) -> None:
        self._loop.add_reader(self._socket, self._accept)

    def _accept(self) -> None:
        for _ in range(ACCEPT_BURST):
            try:
                connection, _ = self._socket.accept()
            except (BlockingIOError, InterruptedError, ConnectionAbortedError):
                return
            except OSError as error:
                self._counters.count("accept_failed", error)
                self._loop.remove_reader(self._socket)
                self._retry = self._loop.call_later(RETRY_INTERVAL, self._listen)
                return
            connection.setblocking(False)
            task = self._loop.create_task(self._connect(connection))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

    async def _connect(self, connection: socket.socket) -> None:
        try:
            await self._loop.connect_accepted_socket(self._make_protocol, connection)
        except OSError as error:
            self._counters.count("accept_failed", error)
            connection.close()


class StreamServer:
    """Calls `handle(reader, writer)` in a task for each connection on a listening socket, which it owns.

    A handler closes its writer. `limit`: bytes that `reader` keeps.
    """

    def __init__(self, sock: socket.socket, handle: StreamHandler, counters: Counters, limit: int = 2**16) -> None:
        self._handle = handle
        self._writers: dict[asyncio.Task[None], asyncio.StreamWriter] = {}
        self._closed = False
        self._listener = Listener(
            sock,
            lambda: asyncio.StreamReaderProtocol(asyncio.StreamReader(limit=limit), self._connected),
            counters,
        )

    async def close(self) -> None:
        """Stop accepting, close all connections immediately, and wait until their handlers have ended."""
        self._closed = True
        self._listener.close()
        for task, writer in self._writers.items():
            task.cancel()
            writer.transport.abort()  # also for a handler that has not begun, which closes nothing
        if self._writers:
            await asyncio.wait(list(self._writers))

    def _connected(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if self._closed:
            writer.transport.abort()
            return
        task = asyncio.get_running_loop().create_task(self._handle(reader, writer), name="stream server: connection")
        self._writers[task] = writer
        task.add_done_callback(self._writers.pop)
