"""Poses as rotation and shift, to put the frames of a description together."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

from jauspy.platform.contract import Pose
from jauspy.platform.description import Joint, JointKind

Vector: TypeAlias = tuple[float, float, float]
Matrix: TypeAlias = tuple[Vector, Vector, Vector]


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame in another one: its axes as columns of a rotation matrix, and its origin in metres."""

    rotation: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    origin: Vector = (0.0, 0.0, 0.0)

    def of(self, point: Vector) -> Vector:
        """A point of this frame, in the other one."""
        x, y, z = (_dot(row, point) + shift for row, shift in zip(self.rotation, self.origin, strict=True))
        return x, y, z

    def then(self, inner: Frame) -> Frame:
        """A frame in this one, in the other one."""
        columns = list(zip(*inner.rotation, strict=True))
        a, b, c = ((_dot(row, columns[0]), _dot(row, columns[1]), _dot(row, columns[2])) for row in self.rotation)
        return Frame((a, b, c), self.of(inner.origin))


def frame_of(pose: Pose) -> Frame:
    """The frame at a pose: fixed-axis roll, pitch and yaw."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a), math.sin(a)) for a in (pose.roll, pose.pitch, pose.yaw))
    rotation = (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )
    return Frame(rotation, (pose.x, pose.y, pose.z))


def frame_at(joint: Joint, position: float) -> Frame:
    """The frame of a joint's child link in its parent link's, at a position (rad or m)."""
    x, y, z = joint.axis
    if joint.kind is JointKind.PRISMATIC:
        moved = Frame(origin=(x * position, y * position, z * position))
    else:
        moved = Frame(_about(joint.axis, position))
    return frame_of(joint.origin).then(moved)


def _about(axis: Vector, angle: float) -> Matrix:
    """The rotation by an angle about a unit vector (Rodrigues)."""
    (x, y, z), c, s = axis, math.cos(angle), math.sin(angle)
    t = 1.0 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def _dot(a: Vector, b: tuple[float, ...]) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
