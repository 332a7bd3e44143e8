"""Width between two fingers that slide, by the positions of their joints."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, Joint, JointKind, RobotDescription, collision_boxes
from jauspy.geometry.vectors import Vector, dot

OPPOSED: Final = -0.9
"""Greatest cosine between the directions in which two fingers open."""


@dataclass(frozen=True, slots=True)
class FingerWidth:
    """The metres between two fingers: a sum, since they slide."""

    at_zero: float
    """Width with all joints at zero, metres."""
    rates: Mapping[str, float] = field(default_factory=dict)
    """Metres by which a metre of each independent joint widens it, by name."""


def finger_width(description: RobotDescription, joints: Sequence[str]) -> FingerWidth | None:
    """The width between the fingers that a group of joints moves, which count from closed to open.

    It is measured between their collision shapes. If these are meshes, or if there is one finger, the fingers are taken
    to touch at their lower limits. None if a joint turns.
    """
    movers = {name: description.joint(name) for name in joints}
    if not movers or any(joint.kind is not JointKind.PRISMATIC for joint in movers.values()):
        return None
    frames = FrameTree(description).poses()
    fingers = [joint for joint in description.joints.values() if (joint.mimics or joint.name) in movers]
    first = movers[joints[0]]
    opens = _opening(first, frames)
    others = [joint for joint in fingers if dot(_opening(joint, frames), opens) < OPPOSED * abs(joint.multiplier)]
    rates = {first.name: 1.0}
    if not others:
        return FingerWidth(-first.lower, rates)
    other = others[0]
    driver = other.mimics or other.name
    rates[driver] = rates.get(driver, 0.0) - dot(_opening(other, frames), opens)
    gap = _gap(first.child, other.child, opens, frames, collision_boxes(description.urdf))
    closed = sum(rate * movers[name].lower for name, rate in rates.items())
    return FingerWidth(-closed if gap is None or gap + closed < 0.0 else gap, rates)


def _opening(joint: Joint, frames: Mapping[str, Transform]) -> Vector:
    """Direction of a finger as the position of its driven joint grows, in the root link's frame, per metre."""
    x, y, z = frames[joint.child].rotate(joint.axis)
    rate = joint.multiplier if joint.mimics else 1.0
    return rate * x, rate * y, rate * z


def _gap(
    link: str, other: str, opens: Vector, frames: Mapping[str, Transform], boxes: Sequence[CollisionBox]
) -> float | None:
    """Metres between the shapes of two links along a direction; None if one has no shapes."""

    def along(name: str) -> list[float]:
        return [
            dot((frames[name] @ Transform.from_pose(box.origin)).apply((x, y, z)), opens)
            for box in boxes
            if box.link == name
            for x, y, z in itertools.product(*((-size / 2.0, size / 2.0) for size in box.size))
        ]

    one, two = along(link), along(other)
    return min(one) - max(two) if one and two else None
