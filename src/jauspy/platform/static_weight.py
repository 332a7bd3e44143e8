"""What a sensor of a robot that weighs nothing while it moves would tell: the weight of what the link carries."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.urdf import inertials
from jauspy.geometry.vectors import Transform, Vector, add, cross, scaled, transposed, turned
from jauspy.platform.description import Description

GRAVITY: Final[Vector] = (0.0, 0.0, -9.81)
"""m/s^2, of a robot that stands level."""


def static_weight(
    description: Description, link: str, positions: Callable[[], Mapping[str, float]]
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
        down = turned(transposed(here.rotation), GRAVITY)
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
