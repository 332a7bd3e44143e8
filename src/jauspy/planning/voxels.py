"""A window of voxels that moves with a robot, in a frame that does not: a fixed amount of memory, whatever is seen.

Each voxel has the time until which it counts as occupied. A hit moves this time into the future, up to a limit, and a
ray that passes through moves it back: evidence is counted in seconds, and fades by itself.
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Indices: TypeAlias = NDArray[np.int64]
Flags: TypeAlias = NDArray[np.bool_]

MAX_VOXELS: Final = 16_000_000
"""Voxels of a window, 17 bytes each."""
NEVER: Final = -np.inf


class VoxelWindow:
    """Voxels of `size` metres around a centre that moves; `shape` is their number along x, y and z.

    A voxel is where its coordinates, modulo the shape, say: when the centre moves, those that come in are cleared, and
    all others stay where they are. Times are in seconds.
    """

    def __init__(self, shape: tuple[int, int, int], size: float) -> None:
        if min(shape) < 1 or int(np.prod(np.array(shape, dtype=object))) > MAX_VOXELS:
            raise ValueError(f"a scene of {shape} voxels; there may be {MAX_VOXELS:,} at most: take larger ones")
        self.size = size
        """Edge of a voxel, metres."""
        self._shape = np.array(shape, np.int64)
        self._low = np.zeros(3, np.int64)
        self._until: Array = np.full(self._shape, NEVER)
        self._hit: Array = np.full(self._shape, NEVER)
        self._known: Flags = np.zeros(self._shape, np.bool_)

    @property
    def bytes(self) -> int:
        """Bytes of memory of the voxels."""
        return self._until.nbytes + self._hit.nbytes + self._known.nbytes

    def clear(self) -> None:
        """Forget everything."""
        self._until[:], self._hit[:], self._known[:] = NEVER, NEVER, False

    def centre_on(self, point: Array) -> None:
        """Move the window so that this point, metres, is in its middle."""
        low = np.floor(point / self.size).astype(np.int64) - self._shape // 2
        shift = low - self._low
        self._low = low
        if (np.abs(shift) >= self._shape).any():
            self.clear()
            return
        for axis, cells in enumerate(shift.tolist()):
            if cells:
                first = int(low[axis] + self._shape[axis] - cells) if cells > 0 else int(low[axis])
                entering = np.arange(first, first + abs(cells)) % self._shape[axis]
                part = (*(slice(None),) * axis, entering)
                self._until[part], self._hit[part], self._known[part] = NEVER, NEVER, False

    def cells(self, points: Array) -> Indices:
        """The different voxels, shape (m, 3), in which points are, shape (n, 3); those outside are left out."""
        found = np.floor(points / self.size).astype(np.int64)
        found = found[self._has(found)]
        shape = tuple(self._shape.tolist())
        flat = np.unique(np.ravel_multi_index(tuple((found - self._low).T), shape))
        return self._low + np.stack(np.unravel_index(flat, shape), axis=-1)

    def centres(self, cells: Indices) -> Array:
        """The middles of voxels, metres, shape (n, 3)."""
        return (cells.astype(np.float64) + 0.5) * self.size

    def hit(self, cells: Indices, time: float, gain: float, keep: float) -> None:
        """Add `gain` seconds of evidence, at most `keep` seconds from `time` on."""
        at = self._at(cells)
        self._until[at] = np.minimum(np.maximum(self._until[at], time) + gain, time + keep)
        self._hit[at], self._known[at] = time, True

    def pass_through(self, cells: Indices, loss: float) -> None:
        """Take `loss` seconds of evidence from voxels through which something beyond was seen."""
        at = self._at(cells)
        self._until[at] -= loss
        self._known[at] = True

    def occupied(self, time: float) -> Indices:
        """The voxels that are occupied at a time, shape (n, 3)."""
        return self._absolute(self._until > time)

    def ages(self, cells: Indices, time: float) -> Array:
        """Seconds since the last hit of voxels, shape (n,)."""
        return time - self._hit[self._at(cells)]

    def mark_known(self, cells: Indices) -> None:
        """Set voxels to known, and leave what is in them."""
        self._known[self._at(cells)] = True

    def unknown(self, point: Array, reach: float) -> Indices:
        """The voxels at most `reach` metres from a point along each axis of which nothing is known, shape (m, 3)."""
        low, known = self._known_around(point, reach)
        return low + np.argwhere(~known)

    def frontier(self, point: Array, reach: float) -> Indices:
        """Those of `unknown` with a neighbour, along an axis, that is known: the surface of the unknown space."""
        low, known = self._known_around(point, reach)
        beside = np.zeros(known.shape, np.bool_)
        for axis in range(3):
            to, of = np.moveaxis(beside, axis, 0), np.moveaxis(known, axis, 0)
            np.logical_or(to[1:], of[:-1], out=to[1:])
            np.logical_or(to[:-1], of[1:], out=to[:-1])
        return low + np.argwhere(beside > known)

    def _known_around(self, point: Array, reach: float) -> tuple[Indices, Flags]:
        """The first voxel of a box, and which of its voxels are known."""
        low = np.maximum(np.ceil((point - reach) / self.size - 0.5).astype(np.int64), self._low)
        high = np.minimum(np.floor((point + reach) / self.size + 0.5).astype(np.int64), self._low + self._shape)
        axes = [np.arange(a, max(a, b)) % n for a, b, n in zip(low, high, self._shape, strict=True)]
        return low, self._known[np.ix_(*axes)]

    def _has(self, cells: Indices) -> Flags:
        return np.asarray(((cells >= self._low) & (cells < self._low + self._shape)).all(axis=-1), np.bool_)

    def _at(self, cells: Indices) -> tuple[Indices, Indices, Indices]:
        x, y, z = (cells % self._shape).T
        return x, y, z

    def _absolute(self, flags: Flags) -> Indices:
        places = np.stack(np.unravel_index(np.flatnonzero(flags), flags.shape), axis=-1)
        return self._low + (places - self._low) % self._shape
