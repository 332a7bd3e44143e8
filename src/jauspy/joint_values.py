"""Lists of joint values in messages of AS6057, for clients and services: each value says whether its joint turns."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, Protocol

from jauspy.messages.manipulator import JointPositionRec, JointVelocityRec

REVOLUTE: Final = 1
PRISMATIC: Final = 2
"""The two kinds of value in a field."""


class TypedJoint(Protocol):
    """A joint, or a Denavit-Hartenberg link, that turns or slides."""

    @property
    def is_revolute(self) -> bool:
        """True if it turns."""
        ...


def kind_of(joint: TypedJoint) -> int:
    """`REVOLUTE` or `PRISMATIC`."""
    return REVOLUTE if joint.is_revolute else PRISMATIC


def position_records(positions: Iterable[float], joints: Iterable[TypedJoint]) -> list[JointPositionRec]:
    """A record for each joint, base to tip: radians or metres."""
    make, choice = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    rows = zip(positions, joints, strict=True)
    return [JointPositionRec(make(choice(kind_of(joint)), value)) for value, joint in rows]


def velocity_records(velocities: Iterable[float], joints: Iterable[TypedJoint]) -> list[JointVelocityRec]:
    """A record for each joint, base to tip: rad/s or m/s."""
    make, choice = JointVelocityRec.JointVelocity, JointVelocityRec.JointVelocityChoice
    rows = zip(velocities, joints, strict=True)
    return [JointVelocityRec(make(choice(kind_of(joint)), value)) for value, joint in rows]
