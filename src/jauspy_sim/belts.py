"""Belts of tracks in MuJoCo's contacts: at each contact, a belt moves along the surface of its shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

ALONG_THE_TRACK: Final = 0.002
"""Cosines of normals to the track, of all contacts together, below which MuJoCo's own Jacobian is right."""

FRICTION: Final = 3
"""Rows of the Jacobian for a contact with friction: along the normal and two tangents."""

MAX_KNOWN: Final = 128
"""Sets of contacts that are remembered; a robot on its belts has few, between which it changes all the time."""


@dataclass(frozen=True, slots=True)
class _Rows:
    """Where the Jacobian has what the belts' contacts need. Indices of columns: x, y and z of the base, and belts."""

    rows: NDArray[np.int64]
    """Contact; normal and tangents."""
    places: NDArray[np.int64]
    """Contact; normal and tangents; column."""
    missing: NDArray[np.bool_] | None
    """Where a sparse Jacobian has no such column; None for a dense one."""
    belts: NDArray[np.int64]
    """Places of the columns of belts that there are."""
    pushes: NDArray[np.int64]
    """Those of normals."""

    @classmethod
    def of(cls, rows: NDArray[np.int64], places: NDArray[np.int64], missing: NDArray[np.bool_] | None) -> _Rows:
        """All of them."""
        if missing is None:
            return cls(rows, places, None, places[:, :, 3:].ravel(), places[:, 0, 3:].ravel())
        there = ~missing[:, :, 3:]
        return cls(rows, places, missing, places[:, :, 3:][there], places[:, 0, 3:][there[:, 0]])


class Belts:
    """The sliding joints of belts. Between `mj_step1` and `mj_step2`, `run_around` corrects their contacts.

    MuJoCo moves all points of a belt's body along the axis of its joint. That is right where the contact's normal is
    perpendicular to the track: on the flat part. On an idler a belt moves along the tangent instead, which is the
    lateral axis times the normal for each m/s of the joint (docs/adr/0110-tracks-that-climb.md).
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, base: int, joints: Sequence[str]) -> None:
        """`base` is the first degree of freedom of the free joint; `joints` are the names of those of the belts."""
        self._data, self._nv = data, int(model.nv)
        found = [model.joint(name) for name in joints]
        dofs = [int(joint.dofadr[0]) for joint in found]
        self._columns = np.array([base, base + 1, base + 2, *dofs])
        self._column_of = np.full(self._nv, -1)
        self._column_of[self._columns] = np.arange(len(self._columns))
        self._dofs, self._qvel = np.array(dofs), data.qvel
        self._frame = data.xmat[int(model.jnt_bodyid[found[0].id])].reshape(3, 3)
        x, y, _ = found[0].axis.tolist()
        self._lateral = np.array((-y, x, 0.0))  # up times the axis of the joint
        self._sparse = bool(mujoco.mj_isSparse(model))
        self._uniform = bool((model.geom_condim == FRICTION).all() and (model.pair_dim == FRICTION).all())
        self._known: dict[object, _Rows] = {}

    def run_around(self) -> None:
        """Correct the Jacobian of the belts' contacts, and what `mj_step1` computed with it."""
        data = self._data
        first, end = data.ne + data.nf + data.nl, data.nefc
        if first == end:
            return
        found = self._find(first, end)
        jacobian = data.efc_J
        pushes = jacobian[found.pushes]
        if pushes.dot(pushes) < ALONG_THE_TRACK**2:
            return
        block = jacobian[found.places]
        if found.missing is not None:
            block[found.missing] = 0.0
        before = block[:, :, 3:]
        x, y, z = self._frame.dot(self._lateral).tolist()
        directions = block[:, :, :3]
        tangents = directions[:, 0].dot(np.array(((0.0, z, -y), (-z, 0.0, x), (y, -x, 0.0))))
        after = (directions @ tangents[:, :, None]) * before.any(axis=1)[:, None, :]
        jacobian[found.belts] = after.ravel() if found.missing is None else after[~found.missing[:, :, 3:]]
        change = (after - before).dot(self._qvel[self._dofs])
        data.efc_aref[found.rows] -= data.efc_KBIP[found.rows, 1] * change

    def _find(self, first: int, end: int) -> _Rows:
        """The rows of the contacts, from `first` on, as they were found when the Jacobian last had this structure."""
        data = self._data
        key: object = (first, end)
        if self._sparse:
            begin = data.efc_J_rowadr[first:end]
            columns = data.efc_J_colind[begin[0] : data.nJ]
            key = (first, begin.tobytes(), columns.tobytes(), data.efc_id[first:end].tobytes())
        elif not self._uniform:
            key = (first, data.efc_id[first:end].tobytes())
        if (known := self._known.get(key)) is not None:
            return known
        if len(self._known) >= MAX_KNOWN:
            self._known.clear()
        found = self._known[key] = self._search(first, end)
        return found

    def _search(self, first: int, end: int) -> _Rows:
        """Search the rows of contacts with friction, and where the Jacobian has their columns."""
        data = self._data
        _, starts, lengths = np.unique(data.efc_id[first:end], return_index=True, return_counts=True)
        rows = first + starts[lengths >= FRICTION, None] + np.arange(FRICTION)
        if not self._sparse:
            return _Rows.of(rows, rows[:, :, None] * self._nv + self._columns, None)
        begin = data.efc_J_rowadr[first:end]
        wanted = self._column_of[data.efc_J_colind[begin[0] : data.nJ]]
        found = np.flatnonzero(wanted >= 0)
        places = np.full((end - first, len(self._columns)), -1)
        places[np.searchsorted(begin, found + begin[0], side="right") - 1, wanted[found]] = found + begin[0]
        rows = rows[(places[rows - first][:, 0, 3:] >= 0).any(axis=1)]  # those of belts
        places = places[rows - first]
        return _Rows.of(rows, places, places < 0)
