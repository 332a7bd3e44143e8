"""Belts of tracks in MuJoCo's contacts: at each contact, the belt moves along the surface of its shape."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

ALONG_THE_TRACK: Final = 1e-4
"""Normals whose cosine to the track is smaller are perpendicular to it: there, MuJoCo's own Jacobian is right."""


class Belts:
    """The sliding joints of belts. Between `mj_step1` and `mj_step2`, `run_around` corrects MuJoCo's contacts.

    MuJoCo moves all points of a belt's body along the joint's axis, which is right for the flat part only. The belt's
    velocity at a contact is that along the tangent of its shape: lateral axis times normal, for each m/s of the joint.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, joints: Sequence[str]) -> None:
        self._model, self._data = model, data
        self._nv = int(model.nv)
        self._sparse = bool(mujoco.mj_isSparse(model))
        self._joints = [int(model.joint(name).id) for name in joints]
        self._dofs = np.array([model.jnt_dofadr[joint] for joint in self._joints])
        self._qvel = data.qvel
        self._belt = np.full(model.ngeom, -1)
        for number, joint in enumerate(self._joints):
            body = model.jnt_bodyid[joint]
            first = model.body_geomadr[body]
            self._belt[first : first + model.body_geomnum[body]] = number
        self._bodies = model.jnt_bodyid[self._joints]
        self._lateral = np.stack([np.cross((0.0, 0.0, 1.0), model.jnt_axis[joint]) for joint in self._joints])

    def run_around(self) -> None:
        """Correct the Jacobian of the belts' contacts, and what `mj_step1` computed with it."""
        data = self._data
        first = data.ne + data.nf + data.nl
        if first == data.nefc:
            return
        contacts = data.contact
        belts = self._belt[contacts.geom]
        which, side = np.nonzero(belts >= 0)
        if not len(which):
            return
        rows = contacts.efc_address[which]
        keep = (rows >= 0) & (contacts.dim[which] >= 3)
        which, side, rows = which[keep], side[keep], rows[keep]
        if not len(which):
            return
        belt = belts[which, side]
        frames = contacts.frame[which].reshape(-1, 3, 3)
        axes = np.einsum("bij,bj->bi", data.xmat[self._bodies].reshape(-1, 3, 3), self._lateral)[belt]
        across = np.einsum("kij,kj->ki", frames, axes)
        dofs = self._dofs[belt]
        index = rows[:, None] + np.arange(3)
        places = self._places(index, dofs)
        new = np.stack((np.zeros(len(which)), across[:, 2], -across[:, 1]), axis=1)
        change = (new - data.efc_J.ravel()[places]) * self._qvel[dofs][:, None]
        data.efc_J.reshape(-1)[places] = new
        data.efc_vel[index] += change
        data.efc_aref[index] -= data.efc_KBIP[index, 1] * change

    def _places(self, rows: NDArray[np.int64], dofs: NDArray[np.int64]) -> NDArray[np.int64]:
        """Where the Jacobian has the entries of these rows (contacts x 3) and degrees of freedom (contacts)."""
        if not self._sparse:
            return rows * self._nv + dofs[:, None]
        data = self._data
        start, length = data.efc_J_rowadr[rows], data.efc_J_rownnz[rows]
        offsets = np.arange(length.max())
        columns = data.efc_J_colind[np.minimum(start[..., None] + offsets, len(data.efc_J_colind) - 1)]
        found = (columns == dofs[:, None, None]) & (offsets < length[..., None])
        return np.asarray(start + np.argmax(found, axis=-1))
