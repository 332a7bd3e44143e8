"""What a fixed camera of the cell has in its picture."""

from __future__ import annotations

import math
from collections.abc import Iterable

from jauspy.geometry.vectors import Vector, cross, difference, dot, scaled
from jauspy.platform.camera import CameraSetup
from jauspy.platform.description import RobotModel


def camera_of(model: RobotModel, name: str) -> CameraSetup:
    return next(camera for camera in model.cameras if camera.name == name)


def place(camera: CameraSetup, point: Iterable[float]) -> tuple[float, float]:
    """Where a point is in the picture: from -1 at the left and at the bottom to 1."""
    outside = camera.outside
    assert outside is not None
    assert outside.target is not None
    ahead = unit(difference(outside.target, outside.position))
    right = unit(cross(ahead, (0.0, 0.0, 1.0)))
    x, y, z = point
    way = difference((x, y, z), outside.position)
    wide = dot(way, ahead) * math.tan(camera.fov / 2.0)
    return dot(way, right) / wide, dot(way, cross(right, ahead)) / (wide * 9.0 / 16.0)


def unit(vector: Vector) -> Vector:
    return scaled(vector, 1.0 / math.hypot(*vector))


def is_shown(camera: CameraSetup, point: Iterable[float]) -> bool:
    return max(map(abs, place(camera, point))) <= 1.0
