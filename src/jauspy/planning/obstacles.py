"""Obstacles of a plan: voxels that sensors saw, and primitives that were given by hand. Frame: the robot's base, m."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform

Array: TypeAlias = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Box:
    """A box with its centre and axes at `pose`; `size` along x, y and z in metres."""

    pose: Transform
    size: tuple[float, float, float]
    name: str = "box"


@dataclass(frozen=True, slots=True)
class Sphere:
    """A sphere with its centre at `pose`; `radius` in metres."""

    pose: Transform
    radius: float
    name: str = "sphere"


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A cylinder around the z axis of `pose`, which is its centre; `radius` and `length` in metres."""

    pose: Transform
    radius: float
    length: float
    name: str = "cylinder"


Primitive: TypeAlias = Box | Sphere | Cylinder


def _no_voxels() -> Array:
    return np.empty((0, 3))


@dataclass(frozen=True, slots=True)
class Obstacles:
    """What a motion must not touch, at one time, in the frame of the robot's base."""

    primitives: Sequence[Primitive] = ()
    voxels: Array = field(default_factory=_no_voxels)
    """Centres of occupied cubes, shape (n, 3), metres."""
    voxel_size: float = 0.02
    """Edge of a cube in metres."""
