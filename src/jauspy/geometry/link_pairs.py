"""Pairs of a robot's links that can touch each other: the one rule for all that measures their clearances."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, TypeAlias

from jauspy.geometry.urdf import Joint, JointKind, RobotDescription

GROUND: Final = "the ground"
"""Name of what is below the robot, in place of a link."""

Pair: TypeAlias = tuple[str, str]
"""Names of two links, or of a link and `GROUND`."""


class LinkPairs:
    """Pairs of links whose clearance changes when the joints `moved`, and those that mimic them, move.

    Left out are neighbours, which one joint connects and whose shapes meet there, and links that the same joint moves
    on one link: fingers are made to meet. Joints in `rigid` count as fixed: what they connect is one body, and has the
    same neighbours.
    """

    def __init__(self, description: RobotDescription, moved: Iterable[str], *, rigid: Iterable[str] = ()) -> None:
        self._moved = frozenset(moved)
        fixed, root = frozenset(rigid), description.root()
        self._carriers = {
            link: frozenset(
                joint.name
                for joint in description.chain(root, link)
                if joint.kind is not JointKind.FIXED and joint.name not in fixed
            )
            for link in description.links()
        }
        self._movers = {joint.name: mover(joint) for joint in description.joints.values()}

    def carriers(self, link: str) -> frozenset[str]:
        """The joints between the root link and a link, without fixed and rigid ones."""
        return self._carriers[link]

    def is_carried(self, link: str) -> bool:
        """True if a joint that moves changes the link's pose in the root link."""
        return any(self._movers[joint] in self._moved for joint in self._carriers[link])

    def movers(self, one: str, other: str) -> frozenset[str]:
        """The joints that change the clearance of two links; none of links that do not count as a pair."""
        between = self._carriers[one] ^ self._carriers[other]
        movers = frozenset(self._movers[joint] for joint in between)
        if len(between) < 2 or (len(between) == 2 and len(movers) == 1 and self._are_beside(one, other)):
            return frozenset()
        return movers & self._moved

    def _are_beside(self, one: str, other: str) -> bool:
        """True of links on different branches of the tree."""
        first, second = self._carriers[one], self._carriers[other]
        return not (first <= second or second <= first)


def mover(joint: Joint) -> str:
    """The independent joint whose position gives that of a joint."""
    return joint.mimics or joint.name
