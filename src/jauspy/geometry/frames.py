"""The frames of a robot: the links of its description, as a tree, for given positions of its joints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription, inertials
from jauspy.geometry.vectors import GRAVITY, Vector, add, cross, difference, dot, rotation_about, scaled

ZERO_POSITIONS: Final[Mapping[str, float]] = {}
"""All joints at zero."""


def joint_frame(joint: Joint, position: float) -> Transform:
    """The frame of a joint's child link in its parent link, at a position (rad or m)."""
    if joint.kind is JointKind.FIXED:
        return _origin_frame(joint.origin)
    if joint.kind is JointKind.PRISMATIC:
        moved = Transform(position=scaled(joint.axis, position))
    else:
        moved = Transform(rotation_about(joint.axis, position))
    return _origin_frame(joint.origin) @ moved


@lru_cache(maxsize=4096)
def _origin_frame(origin: Pose) -> Transform:
    return Transform.from_pose(origin)


class FrameTree:
    """The links of a robot, each fixed to or moving in its parent."""

    def __init__(self, description: RobotDescription) -> None:
        self.description = description
        self.root = description.root()
        self.joints = _parents_first(description)

    def poses(
        self, positions: Mapping[str, float] = ZERO_POSITIONS, joints: Iterable[Joint] | None = None
    ) -> dict[str, Transform]:
        """Every link's frame in the root link's. Joints without a position are at zero; mimic joints follow.

        With `joints`, parents first, only their child links' frames are computed.
        """
        found = {self.root: Transform()}
        for joint in self.joints if joints is None else joints:
            found[joint.child] = found[joint.parent] @ joint_frame(joint, joint.position(positions))
        return found

    def pose(self, link: str, positions: Mapping[str, float] = ZERO_POSITIONS) -> Transform:
        """One link's frame in the root link's. Raises `ConfigError`, which lists the links, for an unknown one."""
        if link not in self.description.links():
            known = ", ".join(sorted(self.description.links()))
            raise ConfigError(f"{self.description.name} has no link {link!r}; it has: {known}")
        frame = Transform()
        for joint in self.description.chain(self.root, link):
            frame = frame @ joint_frame(joint, joint.position(positions))
        return frame

    def frames(self, base: Transform, positions: Mapping[str, float], common: str) -> Frames:
        """The frames of all links, and the frame `common`, in which the root link has the pose `base`."""
        poses = {common: Transform()} | {link: base @ pose for link, pose in self.poses(positions).items()}
        return Frames(poses, {self.root: common} | {joint.child: joint.parent for joint in self.joints})

    def between(self, link: str, other: str) -> list[Joint]:
        """The joints, fixed ones included, that connect two links."""
        chains = [self.description.chain(self.root, end) for end in (link, other)]
        return [joint for one, two in (chains, chains[::-1]) for joint in one if joint not in two]

    def is_fixed(self, link: str) -> bool:
        """True if no joint between the root link and this one moves."""
        return all(joint.kind is JointKind.FIXED for joint in self.description.chain(self.root, link))


@dataclass(frozen=True, slots=True)
class Frames:
    """All frames of a robot at one moment."""

    poses: Mapping[str, Transform]
    """The pose of each frame in the common one."""
    parents: Mapping[str, str]
    """The parent of each frame but the common one."""

    def pose(self, frame: str, within: str) -> Transform:
        """The pose of one frame in another. Raises `ConfigError`, which lists the frames, for an unknown one."""
        for name in (frame, within):
            if name not in self.poses:
                raise ConfigError(f"there is no frame {name!r}; there are: {', '.join(sorted(self.poses))}")
        return self.poses[within].inverse() @ self.poses[frame]


def _parents_first(description: RobotDescription) -> tuple[Joint, ...]:
    reached, ordered = {description.root()}, list[Joint]()
    waiting = list(description.joints.values())
    while waiting:
        ready = [joint for joint in waiting if joint.parent in reached]
        ordered += ready
        reached |= {joint.child for joint in ready}
        waiting = [joint for joint in waiting if joint.child not in reached]
    return tuple(ordered)


_GRAVITY_VECTOR: Final[Vector] = (0.0, 0.0, -GRAVITY)
"""Acceleration of gravity in the frame of a root link that is level, m/s^2."""


def gravity_wrench(
    description: RobotDescription, link: str, positions: Callable[[], Mapping[str, float]]
) -> Callable[[], tuple[Vector, Vector]]:
    """A function of no arguments: force (N) and torque (Nm) of gravity on a link and all that it carries.

    Both are in the link's frame, for the joint positions, by name, that `positions` returns at the call. While these
    stay the same, nothing is computed.
    """
    tree = FrameTree(description)
    carried = _carried(tree, link)
    bodies = [body for body in inertials(description.urdf) if body.link in carried]
    carriers = {joint.child for joint in description.chain(tree.root, link)}
    joints = [joint for joint in tree.joints if joint.child in carriers | carried]

    def weigh(positions: Mapping[str, float]) -> tuple[Vector, Vector]:
        frames = tree.poses(positions, joints)
        back = frames[link].inverse()
        down = back.rotate(_GRAVITY_VECTOR)
        force = torque = (0.0, 0.0, 0.0)
        for body in bodies:
            weight = scaled(down, body.mass)
            middle = back.apply(frames[body.link].apply((body.origin.x, body.origin.y, body.origin.z)))
            force = add(force, weight)
            torque = add(torque, cross(middle, weight))
        return force, torque

    last_positions: dict[str, float] | None = None
    last = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)

    def weigh_if_moved() -> tuple[Vector, Vector]:
        nonlocal last_positions, last
        if (present := dict(positions())) != last_positions:
            last_positions, last = present, weigh(present)
        return last

    return weigh_if_moved


class HoldingEfforts:
    """The efforts with which the joints of a robot carry its links, without those that they need to move."""

    def __init__(self, description: RobotDescription) -> None:
        self._tree = FrameTree(description)
        self._bodies = [
            (body.link, body.mass, (body.origin.x, body.origin.y, body.origin.z))
            for body in inertials(description.urdf)
        ]

    def at(self, positions: Mapping[str, float]) -> dict[str, float]:
        """Efforts (N m or N) of independent joints and of those that mimic them, by name; the root link is level."""
        frames = self._tree.poses(positions)
        masses, moments = dict.fromkeys(frames, 0.0), dict.fromkeys(frames, (0.0, 0.0, 0.0))
        for link, mass, middle in self._bodies:
            masses[link] += mass
            moments[link] = add(moments[link], scaled(frames[link].apply(middle), mass))
        found: dict[str, float] = {}
        for joint in reversed(self._tree.joints):  # children first
            mass, moment, frame = masses[joint.child], moments[joint.child], frames[joint.child]
            masses[joint.parent] += mass
            moments[joint.parent] = add(moments[joint.parent], moment)
            if joint.kind is JointKind.FIXED:
                continue
            axis = frame.rotate(joint.axis)
            if joint.kind is JointKind.PRISMATIC:
                effort = -mass * dot(axis, _GRAVITY_VECTOR)
            else:
                effort = -dot(axis, cross(difference(moment, scaled(frame.position, mass)), _GRAVITY_VECTOR))
            mover, share = (joint.name, 1.0) if joint.mimics is None else (joint.mimics, joint.multiplier)
            found[mover] = found.get(mover, 0.0) + share * effort
        return found


def _carried(tree: FrameTree, link: str) -> set[str]:
    """A link and all links below it."""
    found = {link}
    for joint in tree.joints:
        if joint.parent in found:
            found.add(joint.child)
    return found
