"""The robot's newest state in memory that camera processes share; the robot never waits for a reader."""

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
"""Attempts of a reader that coincide with a write. A write takes microseconds, unless the writer is preempted."""

READ_RETRY_INTERVAL: Final = 0.001
"""Seconds between two attempts."""


class StateWriter:
    """Shared memory of `count` doubles. One process writes; others inherit the descriptor and read."""

    def __init__(self, count: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._length = count * _NUMBER
        self._descriptor: int | None = os.memfd_create("jauspy-state", 0)
        os.ftruncate(self._descriptor, _HEADER.size + self._length)
        self._memory = mmap.mmap(self._descriptor, _HEADER.size + self._length)
        # closes the file of a writer that was not closed
        self._finalizer = weakref.finalize(self, os.close, self._descriptor)
        self._version = 0

    @property
    def descriptor(self) -> int:
        """File descriptor of the memory; -1 when closed."""
        return -1 if self._descriptor is None else self._descriptor

    def write(self, numbers: bytes) -> None:
        """Write the state, as doubles; the version is odd while it is being written."""
        if len(numbers) != self._length:
            raise ValueError(f"{len(numbers)} bytes of state, and there is room for {self._length}")
        self._version += 1
        _HEADER.pack_into(self._memory, 0, self._version, self._clock())
        self._memory[_HEADER.size :] = numbers
        self._version += 1
        self._memory[:_NUMBER] = self._version.to_bytes(_NUMBER, "little")

    def close(self) -> None:
        """Release the memory; readers keep theirs. May be called twice."""
        if self._descriptor is not None:
            self._memory.close()
            self._finalizer()
            self._descriptor = None


class StateReader:
    """Reads the state of a `StateWriter` in a process that inherited its descriptor."""

    def __init__(self, descriptor: int) -> None:
        self._memory = mmap.mmap(descriptor, 0, prot=mmap.PROT_READ)

    def read(self) -> tuple[float, bytes]:
        """Return the time of the last write (monotonic seconds) and the state as doubles, never parts of two states."""
        for _ in range(MAX_READ_ATTEMPTS):
            data = self._memory[:]
            version, written = _HEADER.unpack_from(data)
            if version % 2 == 0 and self._memory[:_NUMBER] == data[:_NUMBER]:
                return written, data[_HEADER.size :]
            time.sleep(READ_RETRY_INTERVAL)
        raise RuntimeError("the robot's process has stopped in the middle of writing its state")

    def close(self) -> None:
        """Release the memory. May be called twice."""
        self._memory.close()
