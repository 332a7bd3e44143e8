"""The tracked chassis in MuJoCo: commands to motors, brakes and belts, and its state.

At each contact, a belt moves along the surface of its shape (`Belts`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.description import TrackSetup
from jauspy.platform.drives import SkidSteerDrive
from jauspy.platform.motors import MotorLoad
from jauspy_sim.assembly import view
from jauspy_sim.physics.joints import FloatingBase

ALONG_THE_TRACK: Final = 0.002
"""Cosines of normals to the track, of all contacts together, below which MuJoCo's own Jacobian is right."""

NORMAL: Final = 0.98
"""Cosine of the angle between the normal of a contact and that of a round shape there from which on it is right."""

FRICTION: Final = 3
"""Rows of the Jacobian for a contact with friction: along the normal and two tangents."""


class _Belt(NamedTuple):
    """Positions of a touching belt's entries in the rows of a contact; its three rows have the same columns."""

    dof: int
    """The degree of freedom of the belt's joint."""
    column: int
    """The column of that degree of freedom in each row."""
    length: int
    """The length of each row."""
    internal: bool
    """The robot touches itself, which its belts do not move along."""


class Belts:
    """The sliding joints of belts. Between `mj_step1` and `mj_step2`, `run_around` corrects their contacts.

    MuJoCo moves all points of a belt's body along the axis of its joint. That is right where the contact's normal is
    perpendicular to the track: on the flat part. On an idler a belt moves along the tangent instead, which is the
    lateral axis times the normal for each m/s of the joint (docs/adr/0110-tracks-that-climb.md).
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, joints: Sequence[str]) -> None:
        """`joints` are the names of those of the belts."""
        self._data, self._nv = data, int(model.nv)
        found = [model.joint(name) for name in joints]
        self._qvel = view(data.qvel)
        self._frame = data.xmat[int(model.jnt_bodyid[found[0].id])].reshape(3, 3)
        x, y, _ = found[0].axis.tolist()
        self._lateral = np.array((-y, x, 0.0))  # up times the axis of the joint
        self._sparse = bool(mujoco.mj_isSparse(model))
        dofs = {int(model.jnt_bodyid[joint.id]): int(joint.dofadr[0]) for joint in found}
        bodies = model.geom_bodyid.tolist()
        self._belts = {geom: dofs[body] for geom, body in enumerate(bodies) if body in dofs}
        round_shape = int(mujoco.mjtGeom.mjGEOM_CYLINDER)
        self._round = {geom for geom in self._belts if model.geom_type[geom] == round_shape}
        self._robots = model.body_rootid[model.geom_bodyid].tolist()
        self._known: dict[tuple[int, int], tuple[_Belt, ...]] = {}
        """Belts by pairs of geometries that touched."""

    def run_around(self, *, trusting: bool) -> bool:
        """Correct the Jacobian of the belts' contacts, and what `mj_step1` computed with it.

        Unless it is `trusting`, false with nothing changed if one of several contacts of a pair has a wrong normal.
        """
        data, known, nv = self._data, self._known, self._nv
        contacts = data.contact
        jacobian = view(data.efc_J)
        starts = view(data.efc_J_rowadr) if self._sparse else None
        found = []
        pushed = 0.0
        pairs = contacts.geom.tolist()
        for contact, (geoms, row) in enumerate(zip(pairs, contacts.efc_address.tolist(), strict=True)):
            if row < 0:
                continue
            pair = geoms[0], geoms[1]
            if (belts := known.get(pair)) is None:
                belts = known[pair] = self._learn(pair, row)
            for belt in belts:
                column = belt.column + (row * nv if starts is None else starts[row])
                push = jacobian[column]
                pushed += push * push
                found.append((contact, row, column, belt))
        if pushed < ALONG_THE_TRACK**2:
            return True
        if not (trusting or all(self._is_right(contact, pairs) for contact, *_ in found)):
            return False
        lateral = (contacts.frame.reshape(-1, 3, 3) @ (self._frame @ self._lateral)).tolist()
        reference, stiffness, qvel = view(data.efc_aref), view(data.efc_KBIP[:, 1]), self._qvel
        for contact, row, column, (dof, _, length, internal) in found:
            speed = qvel[dof]
            _, first, second = lateral[contact]
            # along a x n for an axis a and a normal n, of tangents t and n x t: t (a x n) = a (n x t)
            longitudinal = (0.0, 0.0, 0.0) if internal else (0.0, second, -first)
            for line, after in enumerate(longitudinal):
                target, place = row + line, column + line * length
                reference[target] -= stiffness[target] * (after - jacobian[place]) * speed
                jacobian[place] = after
        return True

    def _is_right(self, number: int, pairs: list[list[int]]) -> bool:
        """False for one of several contacts of a pair with a normal that its round shape has not there.

        That is neither the normal of the curved side nor that of an end. `pairs`: the geometries of all contacts.
        """
        shapes = self._round.intersection(pairs[number])
        if not shapes or pairs.count(pairs[number]) == 1:
            return True
        data = self._data
        nx, ny, nz = data.contact.frame[number, :3].tolist()
        x, y, z = data.contact.pos[number].tolist()
        for geom in shapes:
            (_, _, ax), (_, _, ay), (_, _, az) = data.geom_xmat[geom].reshape(3, 3).tolist()
            cx, cy, cz = data.geom_xpos[geom].tolist()
            along = (x - cx) * ax + (y - cy) * ay + (z - cz) * az
            rx, ry, rz = x - cx - along * ax, y - cy - along * ay, z - cz - along * az
            radial, axial = abs(nx * rx + ny * ry + nz * rz), abs(nx * ax + ny * ay + nz * az)
            if radial < NORMAL * math.hypot(rx, ry, rz) and axial < NORMAL:
                return False
        return True

    def _learn(self, geoms: tuple[int, int], row: int) -> tuple[_Belt, ...]:
        """The belts of a contact between these, whose row along the normal is `row`. It depends on their bodies."""
        contacts = self._data.contact
        dofs = [self._belts[geom] for geom in geoms if geom in self._belts]
        if contacts.dim[contacts.efc_address == row][0] < FRICTION:
            return ()
        one, other = geoms
        internal = self._robots[one] == self._robots[other]
        if not self._sparse:
            return tuple(_Belt(dof, dof, self._nv, internal) for dof in dofs)
        begin, length = int(self._data.efc_J_rowadr[row]), int(self._data.efc_J_rownnz[row])
        columns = self._data.efc_J_colind[begin : begin + length].tolist()
        return tuple(_Belt(dof, columns.index(dof), length, internal) for dof in dofs)


class SimulatedTracks(SkidSteerDrive):
    """A `DriveBase`: free joint `base`, joints and motors of the belts, their names after `prefix`."""

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, tracks: TrackSetup, first_side: int = 0
    ) -> None:
        """`first_side` is where in `userdata` the runs of its belts begin."""
        super().__init__()
        self._model = model
        self._data = data
        self._qpos, self._qvel = view(data.qpos), view(data.qvel)
        base = FloatingBase(model, data, prefix)
        self._pose, self._twist = base.pose, base.twist
        names = [f"{prefix}{name}" for name in tracks.left + tracks.right]
        self._belts = Belts(model, data, names)
        self._run = view(data.userdata)
        positions = [int(model.joint(name).qposadr[0]) for name in names]
        self._driven_positions = list(enumerate((positions[0], positions[len(tracks.left)]), first_side))
        self._belt_positions = positions
        driven = [f"{prefix}{side[0]}" for side in (tracks.left, tracks.right)]
        self._names = (tracks.left[0], tracks.right[0])
        self._forces = view(data.actuator_force)
        self._dofs = [int(model.joint(name).dofadr[0]) for name in driven]
        self._motors = [int(model.actuator(name).id) for name in driven]
        self._speeds = [float(model.actuator_ctrlrange[motor][1]) for motor in self._motors]
        self._brakes = [float(model.actuator_forcerange[motor][1]) for motor in self._motors]
        self._gear_friction = [float(model.dof_frictionloss[dof]) for dof in self._dofs]
        self.stop()

    def set_track_efforts(self, left: float, right: float) -> None:
        """Drive the belts with fractions of the motors' voltage, -1..1; zero for both brakes with their full force."""
        braking = not (left or right)
        rows = zip(self._motors, self._speeds, self._dofs, self._brakes, self._gear_friction, strict=True)
        for (motor, speed, dof, brake, friction), effort in zip(rows, (left, right), strict=True):
            self._data.ctrl[motor] = -speed * effort  # on the ground a belt runs backward when the robot drives forward
            self._model.dof_frictionloss[dof] = brake if braking else friction

    def run_belts_around(self, *, trusting: bool) -> bool:
        """Let the belts run around their shapes, between the two halves of a step of the physics.

        Unless it is `trusting`, false if MuJoCo's contacts are wrong: its first half is to be made anew.
        """
        return self._belts.run_around(trusting=trusting)

    def take_run(self) -> None:
        """Add what the belts have run in a step of the physics, after which their joints are at zero again."""
        for side, position in self._driven_positions:
            self._run[side] -= self._qpos[position]
        for position in self._belt_positions:
            self._qpos[position] = 0.0

    def pose(self) -> Pose:
        """Pose of `base_link` in the world."""
        return self._pose()

    def twist(self) -> Twist:
        """Velocity of `base_link` in its own frame."""
        return self._twist()

    def track_speeds(self) -> tuple[float, float]:
        """Same as `SkidSteerDrive.track_speeds`, of the first belt of each side."""
        left, right = self._dofs
        return -self._qvel[left], -self._qvel[right]

    def motor_loads(self) -> Iterator[MotorLoad]:
        """Forces of the motors and speeds of the belts that they drive; none while their brakes hold."""
        rows = zip(self._names, self._motors, self._dofs, self._data.ctrl[self._motors].tolist(), strict=True)
        for name, motor, dof, voltage in rows:
            yield MotorLoad(name, self._forces[motor] if voltage else 0.0, self._qvel[dof])
