"""The contract of joint groups, as of arms, grippers and flippers, and the gains of their controllers."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Protocol

from jauspy.geometry.urdf import Joint
from jauspy.platform.tables import NotNegative, Table


class ControlMode(Enum):
    """The quantity that a joint's controller follows; a command selects it."""

    EFFORT = "effort"
    VELOCITY = "velocity"
    POSITION = "position"


@dataclass(frozen=True, slots=True)
class Target:
    """The target of one joint: newton metres or newtons; rad/s or m/s; radians or metres.

    A position is approached at most at `speed`, with at most `acceleration` and `deceleration`; the joint's own limits
    when not given. An effort never moves a joint faster than its limit.
    """

    mode: ControlMode
    value: float
    compensated: bool = False
    """True for an effort in addition to what gravity needs, at its share of the speed limit as of the greatest effort;
    zero holds the position."""
    speed: float | None = None
    acceleration: float | None = None
    deceleration: float | None = None


@dataclass(frozen=True, slots=True)
class Gains(Table):
    """A PID controller: effort per error, per integrated error, per change of error."""

    p: NotNegative
    i: NotNegative = 0.0
    d: NotNegative = 0.0
    i_limit: NotNegative = math.inf
    """Limit of the integral part of the effort."""


@dataclass(frozen=True, slots=True)
class JointGains:
    """The controllers of one joint. Position: effort per radian or metre; velocity: effort per rad/s or m/s."""

    position: Gains
    velocity: Gains


class ContactReaction(Enum):
    """What an arm does when something is in its way."""

    STOP = "stop"
    """It holds where it is, and lets the effort at the contact fall."""
    YIELD = "yield"
    """It moves out of the way of what pushes it, and holds there."""
    IGNORE = "ignore"
    """It pushes on."""


@dataclass(frozen=True, slots=True)
class JointContact:
    """Something in the way of a group of joints, which has therefore ended its motion."""

    number: int
    """1 for the first contact of the group, and one more for each further one."""
    efforts: Mapping[str, float]
    """External efforts of the joints that noticed it, by name, the most noticeable first; N m or N."""
    gives_way: bool = False
    """True if the joints give way; otherwise they hold."""


@dataclass(frozen=True, slots=True)
class JointState:
    """The joints of a group at one moment, as measured, base to tip. Efforts are those of the motors and brakes."""

    positions: tuple[float, ...]
    velocities: tuple[float, ...]
    efforts: tuple[float, ...]
    overloads: Mapping[str, float] = field(default_factory=dict)
    """Loads of joints whose brakes hold because their motors cannot, by name; N m or N."""
    contact: JointContact | None = None
    """The last contact with something in the way, for groups that watch for it."""


@dataclass(frozen=True, slots=True)
class EncoderSetup(Table):
    """Errors of an encoder, as standard deviations of each measurement where not said otherwise."""

    encoder_step: NotNegative = math.tau / 2**17
    """Radians of one count; 0 reads without steps."""
    encoder_noise: NotNegative = 0.5 * math.tau / 2**17
    """Radians, before the rounding to counts."""
    velocity_time: NotNegative = 0.004
    """Seconds over which differences of counts are averaged (first-order) to a velocity."""


@dataclass(frozen=True, slots=True)
class JointSensors(EncoderSetup):
    """Errors of the encoders of a group's joints, and of the efforts that their motor currents tell."""

    effort_noise: NotNegative = 0.0
    """Standard deviation of a measured effort, as a fraction of the joint's greatest effort."""


class JointGroup(Protocol):
    """Joints that are commanded together. At rest they hold their position."""

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        ...

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from the group's base link to its tip link, fixed ones included."""
        ...

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip, clamped to limits; None keeps a joint's target."""
        ...

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        ...

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        ...


def joint_positions(groups: Iterable[JointGroup]) -> dict[str, float]:
    """Return the present positions of all joints of the groups, by name (rad or m)."""
    found: dict[str, float] = {}
    for group in groups:
        found |= zip((joint.name for joint in group.joints), group.state().positions, strict=True)
    return found
