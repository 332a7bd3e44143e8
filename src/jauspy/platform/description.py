"""What a robot is made of: links and joints out of its URDF, and what its backend needs to know to move them.

Frames and units are URDF's (REP-103): metres, radians, kilograms; a joint's frame is given in its parent link's.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.platform.camera import CameraSetup
from jauspy.platform.force_torque import ForceTorqueSetup
from jauspy.platform.pid import Gains
from jauspy.platform.ranging import LidarSetup

HERE: Final = Pose()
"""No displacement."""


class JointKind(Enum):
    """How a joint moves."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    FIXED = "fixed"


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of a robot. Limits: radians or metres; rad/s or m/s; newton metres or newtons."""

    name: str
    kind: JointKind
    parent: str
    child: str
    origin: Pose = HERE
    """Where the joint's frame is in the parent link's, at position zero."""
    axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
    """Along or about which it moves, of unit length, in the joint's frame."""
    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0
    damping: float = 0.0
    """Effort per velocity that the joint resists with."""
    friction: float = 0.0
    """Effort that the joint resists with at any velocity."""
    mimics: str | None = None
    """A joint whose position this one has, too."""


@dataclass(frozen=True, slots=True)
class Description:
    """A robot's tree of links and joints, as its URDF gives it."""

    name: str
    urdf: str
    joints: Mapping[str, Joint]
    friction: Mapping[str, float] = field(default_factory=dict)
    """Coefficients of the links that have one of their own."""

    def joint(self, name: str) -> Joint:
        """The joint of that name; `ConfigError` lists those that move."""
        if name not in self.joints:
            moving = [joint.name for joint in self.joints.values() if joint.kind is not JointKind.FIXED]
            raise ConfigError(f"{self.name} has no joint {name!r}; those that move are: {', '.join(moving)}")
        return self.joints[name]

    def links(self) -> set[str]:
        """The names of all links."""
        return {link for joint in self.joints.values() for link in (joint.parent, joint.child)}

    def root(self) -> str:
        """The link that is nobody's child."""
        (root,) = self.links() - {joint.child for joint in self.joints.values()}
        return root

    def chain(self, base: str, tip: str) -> tuple[Joint, ...]:
        """The joints that lead from one link to another, base to tip; `ConfigError` when none do."""
        above = {joint.child: joint for joint in self.joints.values()}
        found: list[Joint] = []
        link = tip
        while link != base:
            if link not in above:
                raise ConfigError(f"{self.name}: no joints lead from link {base!r} to link {tip!r}")
            found.append(above[link])
            link = above[link].parent
        return tuple(reversed(found))


@dataclass(frozen=True, slots=True)
class JointGains:
    """The controllers of one joint. Position: effort per radian or metre; velocity: effort per rad/s or m/s."""

    position: Gains
    velocity: Gains


@dataclass(frozen=True, slots=True)
class GroupSetup:
    """Joints that are commanded together, base to tip, and how."""

    joints: tuple[str, ...]
    gains: Mapping[str, JointGains]
    base: str
    """The link that the group stands on."""
    tip: str
    """The link at its end: a tool, a finger."""
    rate: float
    """How often the controllers act, in hertz."""
    start: tuple[float, ...]
    """Where the joints are when the robot is opened."""


@dataclass(frozen=True, slots=True)
class TrackSetup:
    """Two tracks: the joints of the belts of each side, and the inertia of rotors and sprockets at a belt, in kg."""

    left: tuple[str, ...]
    right: tuple[str, ...]
    inertia: float


@dataclass(frozen=True, slots=True)
class RobotModel:
    """All that a backend needs to make a robot."""

    description: Description
    tracks: TrackSetup
    groups: Mapping[str, GroupSetup] = field(default_factory=dict)
    lidars: tuple[LidarSetup, ...] = ()
    cameras: tuple[CameraSetup, ...] = ()
    force_torque: tuple[ForceTorqueSetup, ...] = ()
