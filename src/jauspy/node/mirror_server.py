"""Copies all routed packets as pcapng to the readers of a Unix socket, while there are any.

Whoever may open the socket sees all messages that this node manager routes: it has the mode and group of the local one.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final

from jauspy.capture import writer
from jauspy.protocol.counters import Counters
from jauspy.transport import local
from jauspy.transport.listener import StreamServer

MAX_READERS: Final = 8
MAX_WAITING: Final = 8 << 20
"""Bytes that wait for a reader; what comes then is lost for it, and counted."""
FLUSH_INTERVAL: Final = 0.02
"""Seconds from the first packet to the write."""
MAX_BATCH: Final = 32768
"""Bytes that are written at once."""


class _Reader:
    """A connected reader, and the number of packets that it has lost."""

    def __init__(self, stream: asyncio.StreamWriter) -> None:
        self._stream = stream
        self._lost = self._told = 0
        stream.write(writer.preamble())

    def write(self, data: bytes, packets: int) -> int:
        """Write packets; returns how many are lost, because the reader is slow."""
        transport = self._stream.transport
        if transport.get_write_buffer_size() > MAX_WAITING:
            self._lost += packets
            return packets
        if self._lost > self._told:
            self._told = self._lost
            transport.write(writer.statistics(self._lost, time.time_ns()))
        transport.write(data)
        return 0


class MirrorServer:
    """Serves the copy; `changed` is called when the first reader comes, and when the last one has gone."""

    def __init__(
        self, path: Path, mode: int, group: str | None, counters: Counters, changed: Callable[[], None]
    ) -> None:
        self._path, self._mode, self._group = path, mode, group
        self._counters = counters
        self._changed = changed
        self._loop = asyncio.get_running_loop()
        self._server: StreamServer | None = None
        self._readers: set[_Reader] = set()
        self._blocks: list[bytes] = []
        self._size = 0
        self._timer: asyncio.TimerHandle | None = None

    @property
    def has_readers(self) -> bool:
        """True while packets are to be added."""
        return bool(self._readers)

    async def __aenter__(self) -> None:
        sock = local.listen(self._path, self._mode, self._group, setting="mirror_socket")
        self._server = StreamServer(sock, self._serve, self._counters)

    async def __aexit__(self, *error: object) -> None:
        self._flush()
        if self._server is not None:
            await self._server.close()
        self._path.unlink(missing_ok=True)

    def add(self, block: bytes) -> None:
        """Add the block of a routed packet."""
        self._blocks.append(block)
        self._size += len(block)
        if self._size >= MAX_BATCH:
            self._flush()
        elif self._timer is None:
            self._timer = self._loop.call_later(FLUSH_INTERVAL, self._flush)

    def _flush(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        data, packets = b"".join(self._blocks), len(self._blocks)
        self._blocks.clear()
        self._size = 0
        for reader in self._readers if packets else ():
            self._counters["mirror.lost"] += reader.write(data, packets)

    async def _serve(self, incoming: asyncio.StreamReader, outgoing: asyncio.StreamWriter) -> None:
        """Serve a reader until it closes the connection; what it sends is ignored."""
        if len(self._readers) >= MAX_READERS:
            self._counters.count("mirror.refused")
            outgoing.transport.abort()
            return
        reader = _Reader(outgoing)
        self._readers.add(reader)
        if len(self._readers) == 1:
            self._changed()
        try:
            with suppress(OSError):
                while await incoming.read(4096):
                    pass
        finally:
            self._readers.discard(reader)
            if not self._readers:
                self._changed()
            outgoing.transport.abort()
