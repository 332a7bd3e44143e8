"""Belts of tracks in MuJoCo's contacts: at each contact, the belt moves along the surface of its shape."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import mujoco
import numpy as np

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
        belt = belts[which, side]
        frames = contacts.frame[which].reshape(-1, 3, 3)
        axes = np.einsum("bij,bj->bi", data.xmat[self._bodies].reshape(-1, 3, 3), self._lateral)[belt]
        across = np.einsum("kij,kj->ki", frames, axes)
        dofs = self._dofs[belt]
        jacobian = data.efc_J.reshape(-1, self._nv)
        index = rows[:, None] + np.arange(3)
        new = np.stack((np.zeros(len(which)), across[:, 2], -across[:, 1]), axis=1)
        change = (new - jacobian[index, dofs[:, None]]) * self._qvel[dofs][:, None]
        jacobian[index, dofs[:, None]] = new
        data.efc_vel[index] += change
        data.efc_aref[index] -= data.efc_KBIP[index, 1] * change
