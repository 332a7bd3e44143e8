"""The boxes around the collision shapes of a robot's links, for many postures at once. Needs numpy."""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from jauspy.geometry.frames import FrameTree, joint_frame
from jauspy.geometry.link_pairs import mover
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription, collision_boxes

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[np.floating[Any]]


@dataclass(frozen=True, slots=True)
class Body:
    """Links that one joint moves together in those of their parent."""

    parent: int
    """The number of the parent; 0 is the body of the root link."""
    joint: Joint
    """The joint that moves it in its parent."""
    column: int
    """The joint's, or that of the one that it mimics, in arrays of positions."""
    origin: Transform
    """The joint's frame in the parent body's, at zero."""


@dataclass(frozen=True, slots=True)
class _Step:
    """The effect of a joint on a body's frame in its parent's, as arrays."""

    number: int
    parent: int
    column: int
    multiplier: float
    offset: float
    slides: bool
    way: Array
    turn: Array
    axis: Array
    """Axis of a joint that slides, in the parent's frame."""
    sine: Array
    cosine: Array
    """Matrices that the sine of an angle, and 1 less its cosine, multiply (Rodrigues)."""

    @classmethod
    def of(cls, number: int, body: Body) -> _Step:
        """The step of a body."""
        joint, turn = body.joint, np.array(body.origin.rotation)
        x, y, z = joint.axis
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        return cls(
            number,
            body.parent,
            body.column,
            joint.multiplier,
            joint.offset,
            joint.kind is JointKind.PRISMATIC,
            np.array(body.origin.position),
            turn,
            turn @ np.array(joint.axis),
            turn @ cross,
            turn @ cross @ cross,
        )


class LinkBoxes:
    """The boxes around the collision shapes of a robot's links in many postures; meshes have no size in URDF.

    A posture is a row of the positions of `joints`; all other joints than these and those that mimic them are at zero.
    """

    def __init__(self, description: RobotDescription, joints: Sequence[str]) -> None:
        self.description = description
        """The robot's description."""
        self.joints = tuple(joints)
        """The joints, in the order of arrays of positions."""
        self._links, self.bodies = _bodies(FrameTree(description), self.joints)
        shapes = collision_boxes(description.urdf)
        self.names = [shape.link for shape in shapes]
        """The link of each box."""
        self.owners = [self._links[shape.link][0] for shape in shapes]
        """The body of each box; 0 is that of the root link, and body n is `bodies[n - 1]`."""
        frames = [self._links[shape.link][1] @ Transform.from_pose(shape.origin) for shape in shapes]
        self._turns = np.array([frame.rotation for frame in frames]).reshape(-1, 3, 3)
        self._places = np.array([frame.position for frame in frames]).reshape(-1, 3)
        self.halves = np.array([shape.size for shape in shapes]).reshape(-1, 3) / 2.0
        """Half of the sides of each box, metres."""
        self._steps = [_Step.of(number, body) for number, body in enumerate(self.bodies, 1)]

    def body_of(self, link: str) -> int:
        """The body that a link belongs to."""
        return self._links[link][0]

    def frame(self, link: str, posture: Sequence[float]) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3) of a link in the root link's frame."""
        body, inner = self._links[link]
        turns, places = self._bodies_at(np.array([posture]))
        return turns[0, body] @ np.array(inner.rotation), places[0, body] + turns[0, body] @ np.array(inner.position)

    def poses(self, postures: Array) -> tuple[Array, Array]:
        """Rotations (n, boxes, 3, 3) and middles (n, boxes, 3) of all boxes in the root link's frame."""
        turns, places = self._bodies_at(postures)
        of = self.owners
        return turns[:, of] @ self._turns, places[:, of] + (turns[:, of] @ self._places[..., None])[..., 0]

    def contain(self, points: Array, posture: Sequence[float], margin: float) -> NDArray[np.bool_]:
        """For each point in the root link's frame, shape (n, 3): True if it is in a box that is larger by `margin`."""
        turns, places = self.poses(np.array([posture]))
        inside = np.einsum("sji,nsj->nsi", turns[0], points[:, None] - places[0])
        found: NDArray[np.bool_] = (np.abs(inside) <= self.halves + margin).all(axis=-1).any(axis=-1)
        return found

    def extent(self, posture: Sequence[float], bodies: Set[int]) -> tuple[Array, Array]:
        """The least and the greatest x, y and z of the boxes of these bodies, in the root link's frame."""
        turns, places = self.poses(np.array([posture]))
        chosen = [number for number, owner in enumerate(self.owners) if owner in bodies]
        reach = (np.abs(turns[0, chosen]) @ self.halves[chosen][..., None])[..., 0]
        return (places[0, chosen] - reach).min(axis=0), (places[0, chosen] + reach).max(axis=0)

    def _bodies_at(self, postures: Array) -> tuple[Array, Array]:
        count = len(postures)
        turns = np.empty((count, len(self.bodies) + 1, 3, 3))
        places = np.zeros((count, len(self.bodies) + 1, 3))
        turns[:, 0] = np.eye(3)
        for step in self._steps:
            parent, way = turns[:, step.parent], step.way
            positions = step.multiplier * postures[:, step.column] + step.offset
            if step.slides:
                turns[:, step.number] = parent @ step.turn
                way = way + positions[:, None] * step.axis
            else:
                sines, cosines = np.sin(positions)[:, None, None], np.cos(positions)[:, None, None]
                turns[:, step.number] = parent @ (step.turn + sines * step.sine + (1.0 - cosines) * step.cosine)
            places[:, step.number] = places[:, step.parent] + (parent @ way[..., None])[..., 0]
        return turns, places


def _bodies(tree: FrameTree, joints: Iterable[str]) -> tuple[dict[str, tuple[int, Transform]], list[Body]]:
    """The body of each link with the link's frame in it, and the bodies that move."""
    columns = {name: column for column, name in enumerate(joints)}
    links = {tree.root: (0, Transform())}
    bodies: list[Body] = []
    for joint in tree.joints:
        parent, frame = links[joint.parent]
        column = columns.get(mover(joint))
        if joint.kind is JointKind.FIXED or column is None:
            links[joint.child] = parent, frame @ joint_frame(joint, 0.0)
        else:
            bodies.append(Body(parent, joint, column, frame @ Transform.from_pose(joint.origin)))
            links[joint.child] = len(bodies), Transform()
    return links, bodies
