"""A copy of everything that is routed, as pcapng, for Wireshark. It may lose packets; routing never waits for it.

Components of this machine appear as 127.S.N.C, with the last byte of their subsystem, their node and component.
"""

from __future__ import annotations

import asyncio
import errno
import logging
import os
import queue
import socket
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final, Self

from jauspy.errors import TransportError
from jauspy.node import pcapng
from jauspy.protocol import judp
from jauspy.protocol.addressing import GroupPort, LocalPort, Port
from jauspy.protocol.counters import Counters

_LOGGER = logging.getLogger(__name__)

CHUNK: Final = 32768
"""Bytes that are handed over to be written at once; with `FLUSH` after the first of them, whichever is earlier."""
DATAGRAM: Final = 1400
MAX_CHUNKS: Final = 128
FLUSH: Final = 0.2
"""Seconds."""
PATIENCE: Final = 1.0
"""Seconds that a reader has at the end, for what it was too slow to take."""


class Mirror:
    """`group` gives the multicast address and port of a network. Writing is done by a thread of its own."""

    def __init__(self, target: str, limit: int, counters: Counters, group: Callable[[str], pcapng.Endpoint]) -> None:
        self._counters = counters
        self._group = group
        self._names: dict[Port, pcapng.Endpoint] = {}
        self._blocks: list[bytes] = []
        self._size = 0
        self._loop = asyncio.get_running_loop()
        self._timer: asyncio.TimerHandle | None = None
        self._chunks: queue.Queue[tuple[bytes, int] | None] = queue.Queue(MAX_CHUNKS)
        self._chunk = DATAGRAM if target.startswith("udp:") else CHUNK
        self._write, self._end = _to_udp(target[4:]) if target.startswith("udp:") else _to_file(Path(target), limit)
        self._thread = threading.Thread(target=self._work, name="mirror", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self.flush()
        with suppress(queue.Full):
            self._chunks.put(None, timeout=PATIENCE)
        self._thread.join(PATIENCE)
        if self._thread.is_alive():  # as when nobody reads a pipe; it ends with the process
            _LOGGER.warning("the mirror was not read to its end")
        else:
            self._end()

    def add(self, source: Port, destination: Port, datagram: bytes) -> None:
        """Note a routed packet."""
        block = pcapng.packet(self._name(source), self._name(destination), datagram, time.time_ns())
        if self._size + len(block) > self._chunk:
            self.flush()
        if self._timer is None:
            self._timer = self._loop.call_later(FLUSH, self.flush)
        self._blocks.append(block)
        self._size += len(block)

    def flush(self) -> None:
        """Hand over what is there; what the thread has no room for is lost and counted."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if not self._blocks:
            return
        try:
            self._chunks.put_nowait((b"".join(self._blocks), len(self._blocks)))
        except queue.Full:
            self._lost(len(self._blocks))
        self._blocks.clear()
        self._size = 0

    def _lost(self, packets: int) -> None:
        self._counters["mirror.lost"] += packets

    def _work(self) -> None:
        while (chunk := self._chunks.get()) is not None:
            data, packets = chunk
            try:
                self._write(data)
            except _NotSentError:
                with suppress(RuntimeError):  # the event loop is closed: nobody counts any more
                    self._loop.call_soon_threadsafe(self._lost, packets)
            except OSError as error:
                _LOGGER.warning("the mirror ends: %s", error)
                self._write = _nowhere

    def _name(self, port: Port) -> pcapng.Endpoint:
        name = self._names.get(port)
        if name is None:
            if len(self._names) > 4096:
                self._names.clear()
            name = self._names[port] = self._make_name(port)
        return name

    def _make_name(self, port: Port) -> pcapng.Endpoint:
        if isinstance(port, LocalPort):
            number = port.path.rpartition("/")[2]
            id = int(number) if number.isdecimal() else 1
            return f"127.{id >> 16 & 255}.{id >> 8 & 255}.{id & 255}", judp.PORT
        if isinstance(port, GroupPort):
            return self._group(port.network)
        try:
            socket.inet_aton(port.host)
        except OSError:
            return "0.0.0.0", port.port  # noqa: S104  # a serial line has no address
        return port.host, port.port


class _NotSentError(Exception):
    """A datagram is lost; the next may find its way."""


def _to_udp(target: str) -> tuple[Callable[[bytes], object], Callable[[], None]]:
    """Each datagram is a pcapng file of its own, and so is a row of them."""
    host, _, port = target.rpartition(":")
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    address = (host, int(port))

    def write(chunk: bytes) -> None:
        try:
            sock.sendto(pcapng.preamble() + chunk, address)
        except OSError as error:  # too long, or no way there just now
            raise _NotSentError from error

    return write, sock.close


def _to_file(path: Path, limit: int) -> tuple[Callable[[bytes], object], Callable[[], None]]:
    try:
        file = os.fdopen(_begun(path), "wb", buffering=0)
    except OSError as error:
        why = "it is a pipe that nobody reads yet" if error.errno == errno.ENXIO else error.strerror
        raise TransportError(f"cannot write the mirror {path}: {why}") from error
    left = limit - len(pcapng.preamble())

    def write(chunk: bytes) -> None:
        nonlocal left
        left -= len(chunk)
        if left < 0:
            raise OSError(f"{path} has reached mirror_limit")
        file.write(chunk)

    return write, file.close


def _begun(path: Path) -> int:
    """Opening a pipe would wait for its reader, and everything else with it; only the thread may wait."""
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_NONBLOCK, 0o666)
    try:
        os.set_blocking(descriptor, True)
        os.write(descriptor, pcapng.preamble())
    except OSError:
        os.close(descriptor)
        raise
    return descriptor


def _nowhere(_: bytes) -> None:
    """Where the rest goes."""
