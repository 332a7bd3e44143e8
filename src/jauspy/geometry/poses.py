"""Poses, twists and rigid transforms, and the axes of REP-103 and JAUS."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.vectors import Rotation, Vector, X, Y, Z, add, rotated, rotation_about, scaled, transposed


@dataclass(frozen=True, slots=True)
class Pose:
    """Where the robot's base is in the world: metres, and fixed-axis roll, pitch, yaw in radians (-pi..pi)."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    pitch: float = 0.0
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class Twist:
    """How the base moves, in its own frame: m/s along x, y, z and rad/s about them."""

    vx: float = 0.0
    vy: float = 0.0
    vz: float = 0.0
    wx: float = 0.0
    wy: float = 0.0
    wz: float = 0.0


@dataclass(frozen=True, slots=True)
class Acceleration:
    """How the motion of the base changes, in its own frame, gravity left out: m/s^2 and rad/s^2."""

    ax: float = 0.0
    ay: float = 0.0
    az: float = 0.0
    wx: float = 0.0
    wy: float = 0.0
    wz: float = 0.0


@dataclass(frozen=True, slots=True)
class Transform:
    """Where a frame is in another one."""

    rotation: Rotation = (X, Y, Z)
    position: Vector = (0.0, 0.0, 0.0)

    def __matmul__(self, other: Transform) -> Transform:
        columns = transposed(other.rotation)
        rotation = transposed((self.turn(columns[0]), self.turn(columns[1]), self.turn(columns[2])))
        return Transform(rotation, self.apply(other.position))

    def turn(self, a: Vector) -> Vector:
        """A direction, given in the inner frame, as the outer one has it."""
        return rotated(self.rotation, a)

    def apply(self, a: Vector) -> Vector:
        """A point, given in the inner frame, as the outer one has it."""
        return add(self.position, rotated(self.rotation, a))

    def inverse(self) -> Transform:
        """Where the outer frame is in the inner one."""
        back = transposed(self.rotation)
        return Transform(back, scaled(rotated(back, self.position), -1.0))

    @classmethod
    def of(cls, pose: Pose) -> Transform:
        """The frame of a pose with fixed-axis roll, pitch, yaw."""
        turn = (
            Transform(rotation_about(Z, pose.yaw))
            @ Transform(rotation_about(Y, pose.pitch))
            @ Transform(rotation_about(X, pose.roll))
        )
        return cls(turn.rotation, (pose.x, pose.y, pose.z))

    def pose(self) -> Pose:
        """The same as position and fixed-axis roll, pitch, yaw; straight up or down the roll is zero."""
        (xx, _, _), (yx, yy, _), (zx, zy, zz) = self.rotation
        across = math.hypot(xx, yx)
        if across < 1e-9:
            roll, yaw = 0.0, math.atan2(-self.rotation[0][1], yy)
        else:
            roll, yaw = math.atan2(zy, zz), math.atan2(yx, xx)
        return Pose(*self.position, roll, math.atan2(-zx, across), yaw)


JAUS_FROM_REP_103: Final = Transform((X, scaled(Y, -1.0), scaled(Z, -1.0)))
"""A half turn about x; its own inverse. It takes the frame of a vehicle, and that of a sensor on it, to JAUS's."""


def jaus_frame(frame: Transform) -> Transform:
    """A frame in another one, when both are turned to JAUS's axes; its own inverse."""
    return JAUS_FROM_REP_103 @ frame @ JAUS_FROM_REP_103


def jaus_pose(pose: Pose) -> Pose:
    """A pose in the other frame; its own inverse."""
    return Pose(pose.x, -pose.y, -pose.z, wrap_angle(pose.roll), wrap_angle(-pose.pitch), wrap_angle(-pose.yaw))


def jaus_twist(twist: Twist) -> Twist:
    """A body twist in the other frame; its own inverse."""
    return Twist(twist.vx, -twist.vy, -twist.vz, twist.wx, -twist.wy, -twist.wz)


def jaus_acceleration(acceleration: Acceleration) -> Acceleration:
    """A body acceleration in the other frame; its own inverse."""
    a = acceleration
    return Acceleration(a.ax, -a.ay, -a.az, a.wx, -a.wy, -a.wz)


def wrap_angle(angle: float) -> float:
    """The same angle (rad) in -pi..pi."""
    return math.remainder(angle, math.tau)
