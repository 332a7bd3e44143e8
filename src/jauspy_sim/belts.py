"""Belts of tracks in MuJoCo's contacts: at each contact, a belt moves along the surface of its shape."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import mujoco
import numpy as np

ALONG_THE_TRACK: Final = 0.002
"""Cosines of normals to the track, of all contacts together, below which MuJoCo's own Jacobian is right."""

FRICTION: Final = 3
"""Rows of the Jacobian for a contact with friction: along the normal and two tangents."""


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
        self._known: tuple[int, int] = (0, 0)
        self._places = self._rows = np.empty((0, FRICTION), np.int64)
        self._normals = np.empty(0, np.int64)
        self._missing = np.empty((0, FRICTION), np.bool_)

    def run_around(self) -> None:
        """Correct the Jacobian of the belts' contacts, and what `mj_step1` computed with it."""
        data = self._data
        contacts = data.ne + data.nf + data.nl, data.nefc
        if contacts[0] == contacts[1]:
            return
        if contacts != self._known or self._sparse or not self._uniform:
            self._find(*contacts)
        jacobian, places = data.efc_J, self._places
        if self._sparse:
            pushes = np.where(self._missing[:, 0, 3:], 0.0, jacobian[places[:, 0, 3:]]).ravel()
        else:
            pushes = jacobian[self._normals]
        if pushes.dot(pushes) < ALONG_THE_TRACK**2:
            return
        block = jacobian[places]  # contact; normal and tangents; x, y and z of the base, and belts
        if self._sparse:
            block[self._missing] = 0.0
        before = block[:, :, 3:]
        x, y, z = self._frame.dot(self._lateral).tolist()
        directions = block[:, :, :3]
        tangents = directions[:, 0].dot(np.array(((0.0, z, -y), (-z, 0.0, x), (y, -x, 0.0))))
        after = (directions @ tangents[:, :, None]) * before.any(axis=1)[:, None, :]
        if self._sparse:
            there = ~self._missing[:, :, 3:]
            jacobian[places[:, :, 3:][there]] = after[there]
        else:
            jacobian[places[:, :, 3:]] = after
        change = (after - before).dot(self._qvel[self._dofs])
        if self._uniform:
            data.efc_aref[contacts[0] :] -= data.efc_KBIP[contacts[0] :, 1] * change.ravel()
        else:
            data.efc_aref[self._rows] -= data.efc_KBIP[self._rows, 1] * change

    def _find(self, first: int, end: int) -> None:
        """Find the rows of contacts with friction, and where the Jacobian has their columns."""
        data = self._data
        if self._uniform:
            rows = np.arange(first, end).reshape(-1, FRICTION)
        else:
            contacts = data.contact
            starts = contacts.efc_address[(contacts.dim >= FRICTION) & (contacts.efc_address >= 0)]
            rows = starts[:, None] + np.arange(FRICTION)
        self._known, self._rows = (first, end), rows
        if not self._sparse:
            self._places = rows[:, :, None] * self._nv + self._columns
            self._normals = self._places[:, 0, 3:].ravel()
            return
        begin = data.efc_J_rowadr[first:end]
        wanted = self._column_of[data.efc_J_colind[begin[0] :]]
        found = np.flatnonzero(wanted >= 0)
        places = np.full((end - first, len(self._columns)), -1)
        places[np.searchsorted(begin, found + begin[0], side="right") - 1, wanted[found]] = found + begin[0]
        self._places = places[rows - first]
        self._missing = self._places < 0
