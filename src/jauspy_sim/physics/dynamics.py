"""The dynamics that a robot's controllers know: those of its description, without anything of the world around it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy_sim.assembly import robot_spec, view
from jauspy_sim.models.look import without_visuals

BREAKAWAY: Final = 0.01
"""Rad/s or m/s at which dry friction is nearly all of what it is in motion; without it, it would switch at rest."""

UNIT_MASSES: Final = (1.0, 0.0, 0.0, 0.0)

LOAD: Final = "load"
"""The body of what the group's tip holds."""


class Dynamics:
    """Inverse dynamics of the robot as its URDF describes it, for the joints of one group.

    Positions are the measured ones, those of other groups and the tilt of the base included; velocities and
    accelerations are those of the setpoints. `carry` adds what the group's tip holds.
    """

    def __init__(
        self, world: mujoco.MjModel, data: mujoco.MjData, prefix: str, robot: RobotModel, group: GroupSetup
    ) -> None:
        plain = replace(robot, description=without_visuals(robot.description))
        spec = robot_spec(plain)
        spec.body(group.tip).add_body(name=LOAD)
        self._model = model = spec.compile()
        model.opt.gravity[:] = world.opt.gravity
        self._load = int(model.body(LOAD).id)
        model.body_sameframe[self._load] = int(mujoco.mjtSameFrame.mjSAMEFRAME_NONE)  # its centre of mass will move
        self._data = own = mujoco.MjData(model)
        self._qpos, self._world_qpos = own.qpos, data.qpos
        self._qvel, self._qacc = view(own.qvel), view(own.qacc)
        self._from, self._to = map(_block, _positions(world, model, prefix))
        joints = [robot.description.joint(name) for name in group.joints]
        followers = [
            (joint, joints.index(leader), joint.multiplier)
            for joint in robot.description.joints.values()
            for leader in joints
            if joint.mimics == leader.name
        ]
        self._followers = [
            (int(model.joint(joint.name).dofadr[0]), number, multiplier) for joint, number, multiplier in followers
        ]
        leaders = [int(model.joint(joint.name).dofadr[0]) for joint in joints]
        self._dofs = _block(leaders)
        moved = [*leaders, *(dof for dof, _, _ in self._followers)]
        self._moved = [
            (
                dof,
                int(world.joint(f"{prefix}{_name(model, dof)}").dofadr[0]),
                float(model.dof_armature[dof]),
                float(model.dof_frictionloss[dof]),
            )
            for dof in moved
        ]
        """Of the joints and their followers: degrees of freedom here and in the world, armature, and dry friction."""
        self.friction = model.dof_frictionloss[self._dofs].copy()
        """Dry friction of the group's joints, N m or N."""
        self._efforts = view(np.zeros(world.nv))
        self._found = np.zeros(model.nv)
        self._full = np.zeros((model.nv, model.nv))
        self._found_view = view(self._found)

    def carry(self, mass: float, center: Vector) -> None:
        """Hold a mass, in kilograms, at a point in the frame of the tip; from the next call of `efforts` on."""
        self._model.body_mass[self._load] = mass
        self._model.body_ipos[self._load] = center

    def load_rows(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Efforts of the joints for what the tip holds, in the state of the last call of `efforts`.

        Shape (joints, 4): for each kilogram, and for each kilogram metre of first moment along the tip's axes. Shape
        (joints,): that part of the efforts which the load that is carried had.
        """
        data, load = self._data, self._load
        carried = data.cinert[load].copy()
        arm = data.xpos[load] - data.subtree_com[self._model.body_rootid[load]]
        rows = np.empty((len(self.friction), 4))
        data.cinert[load] = 0.0
        without = self._inverse_dynamics()
        for column, (mass, moment) in enumerate(
            zip(UNIT_MASSES, (np.zeros(3), *data.xmat[load].reshape(3, 3).T), strict=True)
        ):
            data.cinert[load] = _about(arm, mass, moment)
            rows[:, column] = self._inverse_dynamics() - without
        data.cinert[load] = carried
        return rows, self._inverse_dynamics() - without

    def inertia(self) -> NDArray[np.float64]:
        """Inertia matrix of the joints in the state of the last call of `efforts`, with rotors; shape (joints, joints).

        Without joints that follow others.
        """
        mujoco.mj_crb(self._model, self._data)
        mujoco.mj_fullM(self._model, self._data, self._full)
        found: NDArray[np.float64] = self._full[self._dofs][:, self._dofs].copy()
        return found

    def _inverse_dynamics(self) -> NDArray[np.float64]:
        mujoco.mj_rne(self._model, self._data, 1, self._found)
        found: NDArray[np.float64] = self._found[self._dofs].copy()
        return found

    def efforts(self, setpoints: Sequence[tuple[float, float]]) -> memoryview[float]:
        """Efforts by degree of freedom of the world, N m or N, for velocities and accelerations of the joints.

        Without those against viscous damping, which the controllers of the joints add.
        """
        model, data, qvel, qacc = self._model, self._data, self._qvel, self._qacc
        self._qpos[self._to] = self._world_qpos[self._from]
        # single numbers, since arrays of six take longer
        rows = [*setpoints, *[(m * setpoints[n][0], m * setpoints[n][1]) for _, n, m in self._followers]]
        for (dof, _, _, _), (velocity, acceleration) in zip(self._moved, rows, strict=True):
            qvel[dof], qacc[dof] = velocity, acceleration
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_comVel(model, data)
        mujoco.mj_rne(model, data, 1, self._found)
        efforts, found = self._efforts, self._found_view
        for (dof, to, armature, friction), (velocity, acceleration) in zip(self._moved, rows, strict=True):
            dry = friction * math.tanh(2.0 / BREAKAWAY * velocity)
            efforts[to] = found[dof] + armature * acceleration + dry
        return efforts


def dynamics_of(
    world: mujoco.MjModel, data: mujoco.MjData, prefix: str, robot: RobotModel, group: GroupSetup
) -> Dynamics | None:
    """The dynamics for a group of joints with feed-forward; None for one without."""
    return Dynamics(world, data, prefix, robot, group) if group.feed_forward else None


def _block(indices: list[int]) -> slice | NDArray[np.int64]:
    """The indices as a slice if they are contiguous, which is several times as fast."""
    if indices == list(range(indices[0], indices[0] + len(indices))):
        return slice(indices[0], indices[0] + len(indices))
    return np.array(indices)


def _about(arm: NDArray[np.float64], mass: float, moment: NDArray[np.float64]) -> list[float]:
    """A row of MuJoCo's `cinert`, by mass and first moment of mass about a point that is `arm` from its reference."""
    inertia = mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    inertia += 2.0 * (arm @ moment) * np.eye(3) - np.outer(arm, moment) - np.outer(moment, arm)
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = inertia.tolist()
    return [xx, yy, zz, xy, xz, yz, *(mass * arm + moment).tolist(), mass]


def _name(model: mujoco.MjModel, dof: int) -> str:
    return str(model.joint(int(model.dof_jntid[dof])).name)


def _positions(world: mujoco.MjModel, model: mujoco.MjModel, prefix: str) -> tuple[list[int], list[int]]:
    """Addresses of the robot's positions in the world and in the model of the robot alone."""
    sizes = {int(mujoco.mjtJoint.mjJNT_FREE): 7, int(mujoco.mjtJoint.mjJNT_BALL): 4}
    there: list[int] = []
    here: list[int] = []
    for number in range(model.njnt):
        joint = model.joint(number)
        size = sizes.get(int(joint.type[0]), 1)
        start = int(world.joint(f"{prefix}{joint.name}").qposadr[0])
        there += range(start, start + size)
        here += range(int(joint.qposadr[0]), int(joint.qposadr[0]) + size)
    return there, here
