"""Transforms between jauspy's own types and those of pinocchio."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector

Array: TypeAlias = NDArray[np.float64]
"""Values of joints have the shape (n,), base to tip: radians, rad/s or rad/s^2. Points have the shape (3,), metres."""


def se3(frame: Transform) -> pin.SE3:
    """The same frame in pinocchio's terms."""
    return pin.SE3(np.array(frame.rotation), np.array(frame.position))


def transform(frame: pin.SE3) -> Transform:
    """The inverse of `se3`."""
    a, b, c = (tuple(map(float, row)) for row in frame.rotation)
    x, y, z = map(float, frame.translation)
    return Transform((_vector(a), _vector(b), _vector(c)), (x, y, z))


def _vector(row: tuple[float, ...]) -> Vector:
    x, y, z = row
    return x, y, z


def se3_of_pose(pose: Pose) -> pin.SE3:
    """The frame of a pose in the world."""
    return se3(Transform.from_pose(pose))


def shifted(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> pin.SE3:
    """A translation, in metres."""
    return pin.SE3(np.eye(3), np.array([x, y, z]))


def turned(axis: str, angle: float) -> pin.SE3:
    """A rotation about `x`, `y` or `z`, in radians."""
    return pin.SE3(pin.utils.rotate(axis, angle), np.zeros(3))


def offset_between(a: pin.SE3, b: pin.SE3) -> tuple[float, float]:
    """Distance (m) of the origins of two frames, and the angle (rad) between the frames."""
    distance = float(np.linalg.norm(a.translation - b.translation))
    return distance, float(np.linalg.norm(pin.log3(a.rotation.T @ b.rotation)))


def tilt_between(a: pin.SE3, b: pin.SE3) -> float:
    """The angle between the z axes of two frames, in radians."""
    return math.acos(min(1.0, max(-1.0, float(a.rotation[:, 2] @ b.rotation[:, 2]))))


def averaged(frames: list[pin.SE3]) -> pin.SE3:
    """The mean of frames that differ little, such as measurements of one pose."""
    first = frames[0]
    mean = np.mean([pin.log3(first.rotation.T @ frame.rotation) for frame in frames], axis=0)
    return pin.SE3(first.rotation @ pin.exp3(mean), np.mean([frame.translation for frame in frames], axis=0))
