"""Weighs and measures a robot: mass, centre of gravity and size, from its URDF, with its joints where they start."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, Inertial, collision_boxes, inertials
from jauspy.geometry.vectors import Vector
from jauspy.platform.description import RobotModel


@dataclass(frozen=True, slots=True)
class Measures:
    """In the frame of the root link; kilograms and metres."""

    mass: float
    centre_of_gravity: Vector
    low: Vector
    """The least x, y and z of what may collide."""
    high: Vector
    """The largest."""


def measure(robot: RobotModel) -> Measures:
    """Of the robot as it stands when it is opened. Meshes, whose size URDF does not tell, are left out."""
    frames = _frames(robot)
    urdf = robot.description.urdf
    masses = [
        (body, frames[body.link].apply((body.origin.x, body.origin.y, body.origin.z))) for body in inertials(urdf)
    ]
    mass = sum(body.mass for body, _ in masses)
    corners = list(_corners(frames, collision_boxes(urdf)))
    return Measures(mass, _middle(masses, mass), _least(corners), _most(corners))


def _frames(robot: RobotModel) -> dict[str, Transform]:
    """Every link's frame in the root's."""
    starts = {
        joint: start for group in robot.groups.values() for joint, start in zip(group.joints, group.start, strict=True)
    }
    return FrameTree(robot.description).poses(starts)


def _middle(masses: list[tuple[Inertial, Vector]], mass: float) -> Vector:
    x, y, z = (sum(body.mass * at[axis] for body, at in masses) / (mass or 1.0) for axis in range(3))
    return x, y, z


def _corners(frames: dict[str, Transform], found: list[CollisionBox]) -> Iterator[Vector]:
    for shape in found:
        frame = frames[shape.link] @ Transform.from_pose(shape.origin)
        for signs in itertools.product((-1.0, 1.0), repeat=3):
            x, y, z = (sign * size / 2.0 for sign, size in zip(signs, shape.size, strict=True))
            yield frame.apply((x, y, z))


def _least(corners: list[Vector]) -> Vector:
    x, y, z = (min((corner[axis] for corner in corners), default=0.0) for axis in range(3))
    return x, y, z


def _most(corners: list[Vector]) -> Vector:
    x, y, z = (max((corner[axis] for corner in corners), default=0.0) for axis in range(3))
    return x, y, z
