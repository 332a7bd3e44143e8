"""The geometry of a manipulator in the standard's terms (AS6057): link lengths and twists, joint offsets and angles.

The z axis of frame i lies along joint i; its x axis along the common normal of joints i and i + 1. From frame i to
frame i + 1: along x by the link's length and about x by its twist, then along z by the joint's offset and about z by
its angle. A revolute joint's angle and a prismatic joint's offset are variable; they are counted from these axes,
so they differ by a constant from a URDF's positions: `DHLink.zero_position`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.geometry.frames import joint_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import (
    Rotation,
    Vector,
    X,
    Y,
    Z,
    add,
    cross,
    difference,
    dot,
    rotation_about,
    scaled,
    transposed,
)

PARALLEL_TOLERANCE: Final = 1e-9
"""Sine of the angle between two axes below which they count as parallel."""


@dataclass(frozen=True, slots=True)
class DHLink:
    """A joint, and the link that leads to it from the joint before; metres and radians."""

    joint: Joint
    length: float
    twist: float
    offset: float
    """Metres; for a prismatic joint, the offset at position zero."""
    angle: float
    """Radians; for a revolute joint, the angle at position zero."""

    @property
    def is_revolute(self) -> bool:
        """True when the angle moves, False when the offset does."""
        return self.joint.turns

    @property
    def zero_position(self) -> float:
        """The position in the standard's terms where the URDF's position is zero."""
        return self.angle if self.is_revolute else self.offset

    def frame(self, position: float) -> Transform:
        """The joint's frame in that of the joint before; `position` in the standard's terms."""
        angle, offset = (position, self.offset) if self.is_revolute else (self.angle, position)
        link = Transform(rotation_about(X, self.twist), (self.length, 0.0, 0.0))
        return link @ Transform(rotation_about(Z, angle), (0.0, 0.0, offset))


@dataclass(frozen=True, slots=True)
class ManipulatorGeometry:
    """A manipulator in the standard's terms."""

    base: Transform
    """The manipulator's coordinate system in the frame of the link that it stands on."""
    links: tuple[DHLink, ...]
    """The first has neither length nor twist."""
    tool: Vector
    """The tool point in the last joint's frame."""

    def forward(self, positions: Sequence[float]) -> Transform:
        """The last joint's frame in the base link's, for positions in the standard's terms."""
        frame = self.base
        for link, position in zip(self.links, positions, strict=True):
            frame = frame @ link.frame(position)
        return frame

    def from_urdf(self, positions: Sequence[float]) -> tuple[float, ...]:
        """Convert positions (rad or m) of the URDF to the standard's."""
        return tuple(position + link.zero_position for position, link in zip(positions, self.links, strict=True))

    def to_urdf(self, positions: Sequence[float]) -> tuple[float, ...]:
        """Convert positions (rad or m) of the standard to the URDF's."""
        return tuple(position - link.zero_position for position, link in zip(positions, self.links, strict=True))


@dataclass(frozen=True, slots=True)
class _Axis:
    point: Vector
    direction: Vector


def manipulator_geometry(chain: Sequence[Joint]) -> ManipulatorGeometry:
    """The geometry of a chain of joints from the base link to the tool link, fixed ones included."""
    axes, moving, tool = _axes(chain)
    normals = _normals(axes)
    base = frame = _frame(axes[0], axes[0].point, normals[0][0])
    links = []
    for axis, joint, (normal, foot) in zip(axes, moving, normals, strict=True):
        links.append(_link(joint, frame, axis, _frame(axis, foot, normal)))
        frame = _frame(axis, foot, normal)
    return ManipulatorGeometry(base, tuple(links), frame.inverse().apply(tool.position))


def _axes(chain: Sequence[Joint]) -> tuple[list[_Axis], list[Joint], Transform]:
    """The joints' axes at zero, in the base link's frame; the joints that move; and the tool's frame."""
    axes, moving, frame = [], [], Transform()
    for joint in chain:
        frame = frame @ Transform.from_pose(joint.origin)
        if joint.kind is not JointKind.FIXED:
            axes.append(_Axis(frame.position, frame.rotate(joint.axis)))
            moving.append(joint)
    return axes, moving, frame


def _normals(axes: Sequence[_Axis]) -> list[tuple[Vector, Vector]]:
    """Directions of the common normals of each axis with the next one, and where they start on the axis."""
    found: list[tuple[Vector, Vector]] = []
    for number, axis in enumerate(axes):
        if number + 1 < len(axes):
            found.append(_normal(axis, axes[number + 1], found[-1][0] if found else None))
        else:
            found.append((found[-1][0] if found else _any_normal(axis.direction), axis.point))
    return found


def _normal(axis: _Axis, following: _Axis, before: Vector | None) -> tuple[Vector, Vector]:
    between = difference(following.point, axis.point)
    normal = cross(axis.direction, following.direction)
    sine = math.sqrt(dot(normal, normal))
    if sine > PARALLEL_TOLERANCE:
        # the distance along this axis at which the two lines come closest to each other
        shift = dot(cross(between, following.direction), normal) / (sine * sine)
        return scaled(normal, 1.0 / sine), add(axis.point, scaled(axis.direction, shift))
    perpendicular = difference(between, scaled(axis.direction, dot(between, axis.direction)))
    distance = math.sqrt(dot(perpendicular, perpendicular))
    if distance > PARALLEL_TOLERANCE:
        return scaled(perpendicular, 1.0 / distance), axis.point
    if before is not None and abs(dot(before, axis.direction)) < PARALLEL_TOLERANCE:
        return before, axis.point
    return _any_normal(axis.direction), axis.point


def _any_normal(direction: Vector) -> Vector:
    """A direction perpendicular to another: forward or left if possible."""
    start = X if abs(direction[0]) < 0.9 else Y
    perpendicular = difference(start, scaled(direction, dot(start, direction)))
    return scaled(perpendicular, 1.0 / math.sqrt(dot(perpendicular, perpendicular)))


def _frame(axis: _Axis, origin: Vector, normal: Vector) -> Transform:
    columns: Rotation = (normal, cross(axis.direction, normal), axis.direction)
    return Transform(transposed(columns), origin)


def _link(joint: Joint, before: Transform, axis: _Axis, frame: Transform) -> DHLink:
    """Parameters that lead from the frame of the joint before to that of this joint."""
    x_axis, _, previous = transposed(before.rotation)
    length = dot(difference(axis.point, before.position), x_axis)
    arrival = add(before.position, scaled(x_axis, length))
    offset = dot(difference(frame.position, arrival), axis.direction)
    twist = _angle(previous, axis.direction, x_axis)
    angle = _angle(x_axis, transposed(frame.rotation)[0], axis.direction)
    return DHLink(joint, length, twist, offset, angle)


def _angle(start: Vector, end: Vector, axis: Vector) -> float:
    """The angle, in radians, about an axis from one direction to another."""
    return math.atan2(dot(cross(start, end), axis), dot(start, end))


def pan_tilt_frame(chain: Sequence[Joint]) -> Transform:
    """A pan-tilt unit's coordinate system in its base link: z along pan, y along tilt, x ahead.

    At zero, the frames of both joints are the same.
    """
    reverse = iter(reversed_axes(chain))
    joints = [joint if joint.kind is JointKind.FIXED or not next(reverse) else reversed_joint(joint) for joint in chain]
    found = manipulator_geometry(joints)
    pan = found.base @ found.links[0].frame(0.0)
    y, z = (pan @ found.links[1].frame(0.0)).rotate(Z), pan.rotate(Z)
    return Transform(transposed((cross(y, z), y, z)), pan.position)


def reversed_axes(chain: Sequence[Joint]) -> tuple[bool, bool]:
    """Test for pan and tilt whether the joint's axis is opposite to JAUS's, which are down and right."""
    frame, axes = Transform(), list[Vector]()
    for joint in chain:
        if joint.kind is not JointKind.FIXED:
            axes.append((frame @ Transform.from_pose(joint.origin)).rotate(joint.axis))
        frame = frame @ joint_frame(joint, 0.0)
    pan, tilt = axes
    return dot(pan, frame.rotate(Z)) > 0.0, dot(tilt, frame.rotate(Y)) > 0.0


def reversed_joint(joint: Joint) -> Joint:
    """The same joint with its axis, and so its limits, reversed."""
    return replace(joint, axis=scaled(joint.axis, -1.0), lower=-joint.upper, upper=-joint.lower)
