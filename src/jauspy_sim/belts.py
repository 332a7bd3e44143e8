"""Belts of tracks in MuJoCo's contacts: at each contact, a belt moves along the surface of its shape."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

import mujoco

from jauspy_sim.assembly import view

ALONG_THE_TRACK: Final = 0.002
"""Cosines of normals to the track, of all contacts together, below which MuJoCo's own Jacobian is right."""

FRICTION: Final = 3
"""Rows of the Jacobian for a contact with friction: along the normal and two tangents."""


class _Belt(NamedTuple):
    """Where the rows of a contact have what a belt that touches needs; its three rows have the same columns."""

    dof: int
    """The degree of freedom of the belt's joint."""
    column: int
    """Its place in each row."""
    base: int
    """That of x of the base; y and z follow."""
    length: int
    """Of each row."""
    internal: bool = False
    """The robot touches itself, and the rows of a sparse Jacobian have no columns of the base."""


class Belts:
    """The sliding joints of belts. Between `mj_step1` and `mj_step2`, `run_around` corrects their contacts.

    MuJoCo moves all points of a belt's body along the axis of its joint. That is right where the contact's normal is
    perpendicular to the track: on the flat part. On an idler a belt moves along the tangent instead, which is the
    lateral axis times the normal for each m/s of the joint (docs/adr/0110-tracks-that-climb.md).
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, base: int, joints: Sequence[str]) -> None:
        """`base` is the first degree of freedom of the free joint; `joints` are the names of those of the belts."""
        self._data, self._nv, self._base = data, int(model.nv), base
        found = [model.joint(name) for name in joints]
        self._qvel = view(data.qvel)
        self._frame = data.xmat[int(model.jnt_bodyid[found[0].id])].reshape(3, 3)
        x, y, _ = found[0].axis.tolist()
        self._lateral = (-y, x, 0.0)  # up times the axis of the joint
        self._sparse = bool(mujoco.mj_isSparse(model))
        dofs = {int(model.jnt_bodyid[joint.id]): int(joint.dofadr[0]) for joint in found}
        bodies = model.geom_bodyid.tolist()
        self._belts = {geom: dofs[body] for geom, body in enumerate(bodies) if body in dofs}
        self._known: dict[tuple[int, int], tuple[_Belt, ...]] = {}
        """By pairs of geometries that touched."""

    def run_around(self) -> None:
        """Correct the Jacobian of the belts' contacts, and what `mj_step1` computed with it."""
        data, known, sparse, nv = self._data, self._known, self._sparse, self._nv
        contacts = data.contact
        jacobian = view(data.efc_J)
        starts = view(data.efc_J_rowadr) if sparse else None
        found = []
        pushed = 0.0
        for (one, other), row in zip(contacts.geom.tolist(), contacts.efc_address.tolist(), strict=True):
            if row < 0:
                continue
            if (belts := known.get((one, other))) is None:
                belts = known[one, other] = self._learn((one, other), row)
            for belt in belts:
                start = row * nv if starts is None else starts[row]
                push = jacobian[start + belt.column]
                pushed += push * push
                found.append((row, start, belt))
        if pushed < ALONG_THE_TRACK**2:
            return
        x, y, z = (self._frame @ self._lateral).tolist()
        reference, stiffness = view(data.efc_aref), data.efc_KBIP[:, 1].tolist()
        for row, start, belt in found:
            speed, own, base = self._qvel[belt.dof], start + belt.column, start + belt.base
            nx, ny, nz = jacobian[base], jacobian[base + 1], jacobian[base + 2]
            tx, ty, tz = y * nz - z * ny, z * nx - x * nz, x * ny - y * nx
            for line in range(row, row + FRICTION):
                before = jacobian[own]
                along = jacobian[base] * tx + jacobian[base + 1] * ty + jacobian[base + 2] * tz
                after = 0.0 if belt.internal else along
                jacobian[own] = after
                reference[line] -= stiffness[line] * (after - before) * speed
                own, base = own + belt.length, base + belt.length

    def _learn(self, geoms: tuple[int, int], row: int) -> tuple[_Belt, ...]:
        """The belts of a contact between these, whose row along the normal is `row`. It depends on their bodies."""
        contacts = self._data.contact
        dofs = [self._belts[geom] for geom in geoms if geom in self._belts]
        if contacts.dim[contacts.efc_address == row][0] < FRICTION:
            return ()
        if not self._sparse:
            return tuple(_Belt(dof, dof, self._base, self._nv) for dof in dofs)
        begin, length = int(self._data.efc_J_rowadr[row]), int(self._data.efc_J_rownnz[row])
        columns = self._data.efc_J_colind[begin : begin + length].tolist()
        internal = self._base not in columns
        base = 0 if internal else columns.index(self._base)
        return tuple(_Belt(dof, columns.index(dof), base, length, internal) for dof in dofs)
