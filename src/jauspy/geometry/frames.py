"""Every frame's pose as a tree: forward kinematics of a robot's description."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription, inertials
from jauspy.geometry.vectors import Vector, add, cross, rotated, rotation_about, scaled, transposed

ZERO_POSITIONS: Final[Mapping[str, float]] = {}
"""All joints at zero."""


def joint_frame(joint: Joint, position: float) -> Transform:
    """A joint's child link in its parent link, at a position (rad or m)."""
    if joint.kind is JointKind.PRISMATIC:
        moved = Transform(position=scaled(joint.axis, position))
    else:
        moved = Transform(rotation_about(joint.axis, position))
    return Transform.of(joint.origin) @ moved


class FrameTree:
    """The links of a robot, each fixed to or moving in its parent."""

    def __init__(self, description: RobotDescription) -> None:
        self.description = description
        self.root = description.root()
        self.joints = _parents_first(description)

    def poses(self, positions: Mapping[str, float] = ZERO_POSITIONS) -> dict[str, Transform]:
        """Every link's frame in the root link's. Joints without a position are at zero, or where they mimic."""
        found = {self.root: Transform()}
        for joint in self.joints:
            position = positions.get(joint.mimics or joint.name, 0.0)
            found[joint.child] = found[joint.parent] @ joint_frame(joint, position)
        return found

    def pose(self, link: str, positions: Mapping[str, float] = ZERO_POSITIONS) -> Transform:
        """One link's frame in the root link's; `ConfigError` lists the links."""
        if link not in self.description.links():
            known = ", ".join(sorted(self.description.links()))
            raise ConfigError(f"{self.description.name} has no link {link!r}; it has: {known}")
        frame = Transform()
        for joint in self.description.chain(self.root, link):
            frame = frame @ joint_frame(joint, positions.get(joint.mimics or joint.name, 0.0))
        return frame

    def frames(self, base: Transform, positions: Mapping[str, float], common: str) -> Frames:
        """All links and the frame `common`, in which the root link is at `base`."""
        poses = {common: Transform()} | {link: base @ pose for link, pose in self.poses(positions).items()}
        return Frames(poses, {self.root: common} | {joint.child: joint.parent for joint in self.joints})

    def between(self, link: str, other: str) -> list[Joint]:
        """The joints, fixed ones too, on the way from one link to another one."""
        ways = [self.description.chain(self.root, each) for each in (link, other)]
        return [joint for way, back in (ways, ways[::-1]) for joint in way if joint not in back]

    def is_fixed(self, link: str) -> bool:
        """True when no joint moves between the root link and this one."""
        return all(joint.kind is JointKind.FIXED for joint in self.description.chain(self.root, link))


@dataclass(frozen=True, slots=True)
class Frames:
    """All frames of a robot at one moment."""

    poses: Mapping[str, Transform]
    """Each in one that all have in common."""
    parents: Mapping[str, str]
    """The frame that each is fixed to or moves in; the common one has none."""

    def pose(self, frame: str, within: str) -> Transform:
        """One frame as another one has it; `ConfigError` lists the frames."""
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


GRAVITY: Final[Vector] = (0.0, 0.0, -9.81)
"""m/s^2, of a robot that stands level."""


def gravity_wrench(
    description: RobotDescription, link: str, positions: Callable[[], Mapping[str, float]]
) -> Callable[[], tuple[Vector, Vector]]:
    """Force and torque of what hangs on the joint above a link, in the link's frame, for joints as they are then.

    `positions`: of joints, by name.
    """
    tree = FrameTree(description)
    carried = _carried(tree, link)
    bodies = [body for body in inertials(description.urdf) if body.link in carried]

    def weigh() -> tuple[Vector, Vector]:
        frames = tree.poses(positions())
        here = frames[link]
        down = rotated(transposed(here.rotation), GRAVITY)
        force = torque = (0.0, 0.0, 0.0)
        for body in bodies:
            weight = scaled(down, body.mass)
            middle = here.inverse() @ frames[body.link] @ Transform.of(body.origin)
            force = add(force, weight)
            torque = add(torque, cross(middle.position, weight))
        return force, torque

    return weigh


def _carried(tree: FrameTree, link: str) -> set[str]:
    """A link and all that hang on it."""
    found = {link}
    for joint in tree.joints:
        if joint.parent in found:
            found.add(joint.child)
    return found
