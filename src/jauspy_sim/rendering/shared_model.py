"""A compiled model in memory that processes share: the first one that needs it makes it, the others load it."""

from __future__ import annotations

import errno
import fcntl
import os
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Final

import mujoco
import numpy as np

_SEALS: Final = fcntl.F_SEAL_WRITE | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SHRINK
"""Seals of memory that contains a complete model: no process can change it."""
SEAL_TRIES: Final = 20
"""The kernel refuses to seal (EBUSY) while it uses a page itself, as when it moves one; each try waits 0.15 s."""


class ModelMemory:
    """Shared memory for one model; other processes inherit the descriptor."""

    def __init__(self) -> None:
        self._descriptor: int | None = os.memfd_create("jauspy-model", os.MFD_ALLOW_SEALING)
        self._finalizer = weakref.finalize(self, os.close, self._descriptor)  # of one that was not closed

    @property
    def descriptor(self) -> int:
        """File descriptor of the memory; -1 when closed."""
        return -1 if self._descriptor is None else self._descriptor

    def close(self) -> None:
        """Release the memory; other processes keep theirs. May be called twice."""
        if self._descriptor is not None:
            self._finalizer()
            self._descriptor = None


def shared_model(descriptor: int, make: Callable[[], mujoco.MjModel]) -> mujoco.MjModel:
    """The model in that memory; if there is none yet, it is made and left there.

    Other processes that call this meanwhile wait. If this process dies before it has finished, the next makes it.
    """
    with _locked(descriptor):
        if not fcntl.fcntl(descriptor, fcntl.F_GET_SEALS) & fcntl.F_SEAL_WRITE:
            model = make()
            _write(descriptor, model)
            return model
    return mujoco.MjModel.from_binary_path(f"/proc/self/fd/{descriptor}")


@contextmanager
def _locked(descriptor: int) -> Iterator[None]:
    # A lock of the process, not of the open file, which processes share that inherit its descriptor.
    fcntl.lockf(descriptor, fcntl.LOCK_EX)
    try:
        yield
    finally:
        fcntl.lockf(descriptor, fcntl.LOCK_UN)


def _write(descriptor: int, model: mujoco.MjModel) -> None:
    # Not by MuJoCo into the file: when it closes the file, the lock of this process ends.
    encoded = np.empty(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, encoded)
    os.ftruncate(descriptor, 0)
    rest = encoded.data
    while rest:
        rest = rest[os.pwrite(descriptor, rest, len(encoded) - len(rest)) :]
    for remaining in reversed(range(SEAL_TRIES)):
        try:
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, _SEALS)
        except OSError as error:
            if error.errno != errno.EBUSY or not remaining:
                raise
        else:
            return
