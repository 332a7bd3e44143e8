"""The tracked chassis: efforts to belts, the state of the free joint to pose and twist."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.chassis import SkidSteerDrive
from jauspy.platform.description import TrackSetup
from jauspy_sim.assembly import view


def roll_pitch_yaw(w: float, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Fixed-axis angles (REP-103) of a unit quaternion, radians."""
    roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    pitch = math.asin(min(1.0, max(-1.0, 2.0 * (w * y - z * x))))
    yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    return roll, pitch, yaw


class TrackedDrive(SkidSteerDrive):
    """A `DriveBase`: free joint `base`, joints and motors of the belts, their names after `prefix`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, tracks: TrackSetup) -> None:
        super().__init__()
        self._model = model
        self._data = data
        self._qpos = view(data.qpos)
        base = model.joint(f"{prefix}base")
        self._base_position = slice(base.qposadr[0], base.qposadr[0] + 7)
        self._base_velocity = slice(base.dofadr[0], base.dofadr[0] + 6)
        names = [f"{prefix}{name}" for name in tracks.left + tracks.right]
        self._lefts, self._rights = len(tracks.left), len(tracks.right)
        belts = [model.joint(name) for name in names]
        self._belt_positions = [int(belt.qposadr[0]) for belt in belts]
        self._belt_dofs = [int(belt.dofadr[0]) for belt in belts]
        self._motors = [int(model.actuator(name).id) for name in names]
        self._forces = [float(model.actuator_ctrlrange[motor][1]) for motor in self._motors]
        self._gear_friction = [float(model.dof_frictionloss[dof]) for dof in self._belt_dofs]
        self.stop()

    def set_track_efforts(self, left: float, right: float) -> None:
        """Drive the belts with fractions of the motors' full force, -1..1; zero for both brakes, with all of it."""
        braking = not (left or right)
        efforts = (left,) * self._lefts + (right,) * self._rights
        rows = zip(self._motors, self._forces, self._belt_dofs, self._gear_friction, efforts, strict=True)
        for motor, force, dof, friction, effort in rows:
            self._data.ctrl[motor] = -force * effort  # on the ground a belt runs backward when the robot drives forward
            self._model.dof_frictionloss[dof] = force if braking else friction

    def pose(self) -> Pose:
        """Pose of `base_link` in the world."""
        x, y, z, *quaternion = self._data.qpos[self._base_position].tolist()
        return Pose(x, y, z, *roll_pitch_yaw(*quaternion))

    def twist(self) -> Twist:
        """Velocity of `base_link` in its own frame."""
        velocity = self._data.qvel[self._base_velocity]
        rotation = np.empty(9)
        mujoco.mju_quat2Mat(rotation, self._data.qpos[self._base_position][3:])
        linear = velocity[:3] @ rotation.reshape(3, 3)  # a free joint's linear velocity is in the world's frame
        return Twist(*linear.tolist(), *velocity[3:].tolist())

    def rewind_belts(self) -> None:
        """Put the belts back to position zero: only their surface speed shall act."""
        for position in self._belt_positions:
            self._qpos[position] = 0.0
