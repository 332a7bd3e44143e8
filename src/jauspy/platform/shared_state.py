"""The robot's newest state in memory that cameras' processes share; the robot never waits for them."""

from __future__ import annotations

import mmap
import os
import struct
import time
import weakref
from collections.abc import Callable
from typing import Final

_HEADER: Final = struct.Struct("=Qd")
_NUMBER: Final = 8

MAX_READ_ATTEMPTS: Final = 1000
"""Attempts of a reader, each disturbed by a write. A write takes microseconds, but for a writer that has to wait for
the processor in the middle of one."""

READ_RETRY_INTERVAL: Final = 0.001
"""Seconds between two attempts."""


class StateWriter:
    """Holds `count` numbers. Only one process writes; it has the descriptor, which others inherit."""

    def __init__(self, count: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._length = count * _NUMBER
        self._descriptor: int | None = os.memfd_create("jauspy-state", 0)
        os.ftruncate(self._descriptor, _HEADER.size + self._length)
        self._memory = mmap.mmap(self._descriptor, _HEADER.size + self._length)
        self._forgotten = weakref.finalize(self, os.close, self._descriptor)  # who is not closed leaks no file
        self._version = 0

    @property
    def descriptor(self) -> int:
        """The memory as a file; -1 once it is closed."""
        return -1 if self._descriptor is None else self._descriptor

    def write(self, numbers: bytes) -> None:
        """The new state, as doubles; an odd version tells readers that it is being written."""
        if len(numbers) != self._length:
            raise ValueError(f"{len(numbers)} bytes of state, and there is room for {self._length}")
        self._version += 1
        _HEADER.pack_into(self._memory, 0, self._version, self._clock())
        self._memory[_HEADER.size :] = numbers
        self._version += 1
        self._memory[:_NUMBER] = self._version.to_bytes(_NUMBER, "little")

    def close(self) -> None:
        """Give the memory back; readers keep theirs. Twice is fine."""
        if self._descriptor is not None:
            self._memory.close()
            self._forgotten()
            self._descriptor = None


class StateReader:
    """Reads what a `StateWriter` wrote, in a process that inherited its descriptor."""

    def __init__(self, descriptor: int) -> None:
        self._memory = mmap.mmap(descriptor, 0, prot=mmap.PROT_READ)

    def read(self) -> tuple[float, bytes]:
        """When it was written (monotonic seconds), and the state as doubles: one state, never parts of two."""
        for _ in range(MAX_READ_ATTEMPTS):
            data = self._memory[:]
            version, written = _HEADER.unpack_from(data)
            if version % 2 == 0 and self._memory[:_NUMBER] == data[:_NUMBER]:
                return written, data[_HEADER.size :]
            time.sleep(READ_RETRY_INTERVAL)
        raise RuntimeError("the robot's process has stopped in the middle of writing its state")

    def close(self) -> None:
        """Give the memory back; twice is fine."""
        self._memory.close()
