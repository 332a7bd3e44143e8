"""Copies all routed packets as pcapng, for Wireshark. The copy may lose packets; routing never waits for it."""

from __future__ import annotations

import asyncio
import errno
import os
import queue
import socket
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final, Self

from jauspy.capture import writer
from jauspy.errors import TransportError
from jauspy.logs import get_logger
from jauspy.protocol.counters import Counters

_LOG = get_logger(__name__)

MAX_CHUNK_SIZE: Final = 32768
"""Bytes that are written at once, at the latest `FLUSH_INTERVAL` seconds after the first packet."""
MAX_DATAGRAM_SIZE: Final = 1400
MAX_CHUNKS: Final = 128
FLUSH_INTERVAL: Final = 0.2
STOP_TIMEOUT: Final = 1.0
"""Seconds that a slow reader has at the end to read what is queued."""


class Mirror:
    """Writes in its own thread."""

    def __init__(self, target: str, limit: int, counters: Counters) -> None:
        self._counters = counters
        self._blocks: list[bytes] = []
        self._size = 0
        self._loop = asyncio.get_running_loop()
        self._timer: asyncio.TimerHandle | None = None
        self._chunks: queue.Queue[tuple[bytes, int] | None] = queue.Queue(MAX_CHUNKS)
        if target.startswith("udp:"):
            self._max_chunk = MAX_DATAGRAM_SIZE
            self._write, self._close = _open_udp(target[4:])
        else:
            self._max_chunk = MAX_CHUNK_SIZE
            self._write, self._close = _open_file(Path(target), limit)
        self._thread = threading.Thread(target=self._work, name="mirror", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self.flush()
        try:
            self._chunks.put(None, timeout=STOP_TIMEOUT)
        except queue.Full:  # the reader of a pipe is too slow: the thread ends with the chunk that it is writing
            with suppress(queue.Empty):
                while (chunk := self._chunks.get_nowait()) is not None:
                    self._count_lost(chunk[1])
            self._chunks.put_nowait(None)
        self._thread.join(STOP_TIMEOUT)
        if self._thread.is_alive():
            _LOG.warning("the mirror's reader was too slow: its last packets are lost")

    def add(self, block: bytes) -> None:
        """Add the block of a routed packet."""
        if self._size + len(block) > self._max_chunk:
            self.flush()
        if self._timer is None:
            self._timer = self._loop.call_later(FLUSH_INTERVAL, self.flush)
        self._blocks.append(block)
        self._size += len(block)

    def flush(self) -> None:
        """Queue the collected packets for the thread; they are lost and counted when the queue is full."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if not self._blocks:
            return
        try:
            self._chunks.put_nowait((b"".join(self._blocks), len(self._blocks)))
        except queue.Full:
            self._count_lost(len(self._blocks))
        self._blocks.clear()
        self._size = 0

    def _count_lost(self, packets: int) -> None:
        self._counters["mirror.lost"] += packets

    def _work(self) -> None:
        """Write until the end; the thread closes the file, because only it knows when the last write is over."""
        try:
            self._write_chunks()
        finally:
            self._close()

    def _write_chunks(self) -> None:
        while (chunk := self._chunks.get()) is not None:
            data, packets = chunk
            try:
                self._write(data)
            except _NotSentError:
                with suppress(RuntimeError):  # the event loop is closed
                    self._loop.call_soon_threadsafe(self._count_lost, packets)
            except OSError as error:
                _LOG.warning("the mirror ends: %s", error)
                self._write = _discard


class _NotSentError(Exception):
    """One datagram is lost; the next may be sent."""


def _open_udp(target: str) -> tuple[Callable[[bytes], object], Callable[[], None]]:
    """Each datagram is a complete pcapng file; so are several in a row."""
    host, _, port = target.rpartition(":")
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    address = (host, int(port))

    def write(chunk: bytes) -> None:
        try:
            sock.sendto(writer.preamble() + chunk, address)
        except OSError as error:  # too long, or unreachable for now
            raise _NotSentError from error

    return write, sock.close


def _open_file(path: Path, limit: int) -> tuple[Callable[[bytes], object], Callable[[], None]]:
    try:
        file = os.fdopen(_create(path), "wb", buffering=0)
    except OSError as error:
        why = "it is a pipe without a reader" if error.errno == errno.ENXIO else error.strerror
        raise TransportError(f"cannot write the mirror {path}: {why}") from error
    left = limit - len(writer.preamble())

    def write(chunk: bytes) -> None:
        nonlocal left
        left -= len(chunk)
        if left < 0:
            raise OSError(f"{path} has reached mirror_limit")
        file.write(chunk)

    return write, file.close


def _create(path: Path) -> int:
    """Open without blocking: opening a pipe would wait for its reader, but only the thread may wait."""
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_NONBLOCK, 0o666)
    try:
        os.set_blocking(descriptor, True)
        os.write(descriptor, writer.preamble())
    except OSError:
        os.close(descriptor)
        raise
    return descriptor


def _discard(_: bytes) -> None:
    """Ignore the chunks after an error."""
