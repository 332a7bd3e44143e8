"""The rigid parts of a robot: links without a joint that moves between them, with their masses and bodies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from jauspy.geometry.frames import ZERO_POSITIONS, FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, Inertial, JointKind, RobotDescription, collision_boxes, inertials
from jauspy.geometry.vectors import Rotation, Vector, add, difference, dot, product, scaled, transposed


@dataclass(frozen=True, slots=True)
class Body:
    """A box, cylinder (along z) or sphere, and its pose in the root link's frame."""

    shape: CollisionBox
    pose: Transform


@dataclass(frozen=True, slots=True)
class RigidPart:
    """Links that move together, in the frame of the root link (REP-103): metres, kg, kg m^2."""

    link: str
    """The one that the others are fixed to."""
    mass: float
    centre: Vector
    """Centre of mass."""
    tensor: Rotation
    """Moments and products of inertia about the centre of mass, along the axes of the root link."""
    bodies: tuple[Body, ...]


class RigidParts:
    """Computes the parts of a robot for positions of its joints."""

    def __init__(self, description: RobotDescription) -> None:
        self._tree = FrameTree(description)
        self._first = {self._tree.root: self._tree.root}
        for joint in self._tree.joints:
            is_fixed = joint.kind is JointKind.FIXED
            self._first[joint.child] = self._first[joint.parent] if is_fixed else joint.child
        self._inertials = inertials(description.urdf)
        self._boxes = collision_boxes(description.urdf)

    def at(self, positions: Mapping[str, float] = ZERO_POSITIONS) -> list[RigidPart]:
        """The parts that have a mass or a body, root first. Joints without a position are at zero."""
        poses = self._tree.poses(positions)
        parts = []
        for link in dict.fromkeys(self._first.values()):
            masses = [inertial for inertial in self._inertials if self._first[inertial.link] == link]
            bodies = tuple(
                Body(box, poses[box.link] @ Transform.from_pose(box.origin))
                for box in self._boxes
                if self._first[box.link] == link
            )
            mass, centre, tensor = _combined(masses, poses)
            if mass > 0.0 or bodies:
                parts.append(RigidPart(link, mass, centre if mass > 0.0 else poses[link].position, tensor, bodies))
        return parts


def _combined(masses: list[Inertial], poses: Mapping[str, Transform]) -> tuple[float, Vector, Rotation]:
    """Mass, centre and inertia of several masses (parallel axis theorem)."""
    total, moment = 0.0, (0.0, 0.0, 0.0)
    frames = [poses[one.link] @ Transform.from_pose(one.origin) for one in masses]
    for one, frame in zip(masses, frames, strict=True):
        total += one.mass
        moment = add(moment, scaled(frame.position, one.mass))
    centre = scaled(moment, 1.0 / total) if total > 0.0 else moment
    tensor: Rotation = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    for one, frame in zip(masses, frames, strict=True):
        turned = product(product(frame.rotation, one.tensor), transposed(frame.rotation))
        tensor = _sum(_sum(tensor, turned), _of_point(one.mass, difference(frame.position, centre)))
    return total, centre, tensor


def _of_point(mass: float, at: Vector) -> Rotation:
    """The inertia of a point about the origin."""
    square = dot(at, at)
    x, y, z = (
        tuple(mass * ((square if row == column else 0.0) - at[row] * at[column]) for column in range(3))
        for row in range(3)
    )
    return (_vector(x), _vector(y), _vector(z))


def _sum(one: Rotation, other: Rotation) -> Rotation:
    return (add(one[0], other[0]), add(one[1], other[1]), add(one[2], other[2]))


def _vector(values: tuple[float, ...]) -> Vector:
    x, y, z = values
    return x, y, z
