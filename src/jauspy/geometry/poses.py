"""Poses, twists and rigid transforms, and the axes of REP-103 and JAUS."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, NamedTuple

from jauspy.geometry.vectors import (
    Rotation,
    Vector,
    X,
    Y,
    Z,
    add,
    product,
    quaternion,
    rotated,
    rotation_about,
    scaled,
    transposed,
)


@dataclass(frozen=True, slots=True)
class Pose:
    """Position in metres, and fixed-axis roll, pitch, yaw in radians (-pi..pi)."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    pitch: float = 0.0
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class Twist:
    """Velocity of a body in its own frame: m/s along x, y, z and rad/s about them."""

    vx: float = 0.0
    vy: float = 0.0
    vz: float = 0.0
    wx: float = 0.0
    wy: float = 0.0
    wz: float = 0.0


@dataclass(frozen=True, slots=True)
class Acceleration:
    """Acceleration of a body in its own frame, without gravity: m/s^2 along x, y, z and rad/s^2 about them."""

    ax: float = 0.0
    ay: float = 0.0
    az: float = 0.0
    wx: float = 0.0
    wy: float = 0.0
    wz: float = 0.0


@dataclass(frozen=True, slots=True)
class Transform:
    """A rigid transform: the pose of an inner frame in an outer one, metres."""

    rotation: Rotation = (X, Y, Z)
    position: Vector = (0.0, 0.0, 0.0)

    def __matmul__(self, other: Transform) -> Transform:
        return Transform(product(self.rotation, other.rotation), self.apply(other.position))

    def rotate(self, a: Vector) -> Vector:
        """A direction of the inner frame, expressed in the outer frame."""
        return rotated(self.rotation, a)

    def apply(self, a: Vector) -> Vector:
        """A point of the inner frame, expressed in the outer frame."""
        return add(self.position, rotated(self.rotation, a))

    def inverse(self) -> Transform:
        """The outer frame in the inner one."""
        back = transposed(self.rotation)
        return Transform(back, scaled(rotated(back, self.position), -1.0))

    @classmethod
    def from_pose(cls, pose: Pose) -> Transform:
        """The frame of a pose."""
        yaw, pitch, roll = rotation_about(Z, pose.yaw), rotation_about(Y, pose.pitch), rotation_about(X, pose.roll)
        return cls(product(product(yaw, pitch), roll), (pose.x, pose.y, pose.z))

    def to_pose(self) -> Pose:
        """The inverse of `from_pose`; where x points straight up or down, the roll is zero."""
        (xx, _, _), (yx, yy, _), (zx, zy, zz) = self.rotation
        cos_pitch = math.hypot(xx, yx)
        if cos_pitch < 1e-9:
            roll, yaw = 0.0, math.atan2(-self.rotation[0][1], yy)
        else:
            roll, yaw = math.atan2(zy, zz), math.atan2(yx, xx)
        return Pose(*self.position, roll, math.atan2(-zx, cos_pitch), yaw)


@dataclass(frozen=True, slots=True)
class PlanarPoint:
    """A point on the ground, metres."""

    x: float
    y: float

    def to(self, other: PlanarPoint) -> tuple[float, float]:
        """Distance (m) and direction (rad, from x towards y) of another point."""
        return math.hypot(other.x - self.x, other.y - self.y), math.atan2(other.y - self.y, other.x - self.x)


class PlanarPose(NamedTuple):
    """A pose on a plane: metres, and radians counterclockwise from x."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0

    def __matmul__(self, inner: PlanarPose) -> PlanarPose:
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        yaw = math.remainder(self.yaw + inner.yaw, math.tau)
        return PlanarPose(self.x + c * inner.x - s * inner.y, self.y + s * inner.x + c * inner.y, yaw)

    def inverse(self) -> PlanarPose:
        """The outer frame in this one."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(-c * self.x - s * self.y, s * self.x - c * self.y, -self.yaw)

    def relative_to(self, other: PlanarPose) -> PlanarPose:
        """The same pose in the frame of another."""
        return other.inverse() @ self


def rotation_vector(start: Rotation, end: Rotation) -> Vector:
    """The rotation from one attitude to another: its axis, as long as its angle in radians."""
    d, *vector = quaternion((Transform(end) @ Transform(transposed(start))).rotation)
    sine = math.hypot(*vector)
    factor = 2.0 * math.atan2(sine, d) / sine if sine else 2.0
    a, b, c = vector
    return a * factor, b * factor, c * factor


JAUS_FROM_REP_103: Final = Transform((X, scaled(Y, -1.0), scaled(Z, -1.0)))
"""REP-103 (x forward, y left, z up) to JAUS (x forward, y right, z down): a half turn about x, its own inverse."""


def jaus_frame(frame: Transform) -> Transform:
    """The pose of one frame in another, when both change from REP-103's axes to JAUS's; its own inverse."""
    return JAUS_FROM_REP_103 @ frame @ JAUS_FROM_REP_103


def jaus_pose(pose: Pose) -> Pose:
    """A pose changed from REP-103's axes to JAUS's; its own inverse."""
    return Pose(
        x=pose.x,
        y=-pose.y,
        z=-pose.z,
        roll=wrap_angle(pose.roll),
        pitch=wrap_angle(-pose.pitch),
        yaw=wrap_angle(-pose.yaw),
    )


def jaus_twist(twist: Twist) -> Twist:
    """A body twist changed from REP-103's axes to JAUS's; its own inverse."""
    return Twist(vx=twist.vx, vy=-twist.vy, vz=-twist.vz, wx=twist.wx, wy=-twist.wy, wz=-twist.wz)


def jaus_acceleration(acceleration: Acceleration) -> Acceleration:
    """A body acceleration changed from REP-103's axes to JAUS's; its own inverse."""
    a = acceleration
    return Acceleration(ax=a.ax, ay=-a.ay, az=-a.az, wx=a.wx, wy=-a.wy, wz=-a.wz)


def wrap_angle(angle: float) -> float:
    """The same angle in -pi..pi, radians."""
    return math.remainder(angle, math.tau)


IDENTITY: Final = Transform()
ORIGIN: Final = Pose()
AT_REST: Final = Twist()
UNACCELERATED: Final = Acceleration()
