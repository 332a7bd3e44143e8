"""Clearances between the links of a robot, by the boxes around their collision shapes, for one posture at a time.

Pure Python, so that robots without numpy check their named poses and the ways to them; `posture_clearances` is for
those that look at many postures many times a second. The clearance of two boxes is their greatest separation along the
15 axes of the separating-axis theorem (Gottschalk et al., OBBTree, 1996): positive exactly if they do not touch,
negative by the depth if they do, and never more than their distance. A box around a cylinder or sphere is larger than
the shape. Shapes that are meshes are not known here. Metres and radians.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.link_pairs import GROUND, LinkPairs, Pair
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, Joint, RobotDescription, collision_boxes
from jauspy.geometry.vectors import Vector, cross, difference, dot, scaled, transposed

PARALLEL: Final = 1e-4
"""Sine of the angle of two edges below which their cross product is no axis: the faces' axes suffice then."""


@dataclass(frozen=True, slots=True)
class _Box:
    link: str
    frame: Transform
    """Middle and attitude in the link."""
    half: Vector
    radius: float
    """Half of its diagonal."""


@dataclass(frozen=True, slots=True)
class _PlacedBox:
    middle: Vector
    axes: tuple[Vector, Vector, Vector]
    half: Vector
    radius: float


class LinkClearances:
    """The clearances that change when the joints `moved` move: between links that they carry, and to all others.

    Belts count as joints here, so that a link on the chassis is no neighbour of the tracks beside it, and pairs that
    touch are not left out: a pose in which links are in each other is to be found. With `has_ground` the links
    also keep a distance from the plane on which the robot stands: that of its lowest box that no joint but those in
    `belts` moves.
    """

    def __init__(
        self,
        description: RobotDescription,
        moved: Iterable[str],
        *,
        has_ground: bool = False,
        belts: Iterable[str] = (),
    ) -> None:
        self._tree = FrameTree(description)
        self._joints: Sequence[Joint] = self._tree.joints
        pairs = LinkPairs(description, moved)
        boxes = [_box(box) for box in collision_boxes(description.urdf)]
        self._pairs = [
            (one, other) for one, other in itertools.combinations(boxes, 2) if pairs.movers(one.link, other.link)
        ]
        self._above_ground: list[_Box] = []
        self._ground = -math.inf
        if has_ground:
            belts = set(belts)
            standing = [box for box in boxes if pairs.carriers(box.link) <= belts]
            placed = self._placed({}, standing)
            self._ground = min((_lowest(box) for box in placed.values()), default=-math.inf)
            self._above_ground = [
                box for box in boxes if pairs.is_carried(box.link) and not pairs.carriers(box.link) & belts
            ]
        used = [box for pair in self._pairs for box in pair] + self._above_ground
        self._boxes = list({id(box): box for box in used}.values())
        links = {box.link for box in self._boxes}
        needed = {joint.name for link in links for joint in description.chain(self._tree.root, link)}
        self._joints = [joint for joint in self._tree.joints if joint.name in needed]

    def at(self, positions: Mapping[str, float], below: float) -> dict[Pair, float]:
        """The clearances that are less than `below`, metres; of two links that of their nearest boxes.

        `positions`: radians or metres of independent joints, by name; others are at zero.
        """
        placed = self._placed(positions, self._boxes)
        found: dict[Pair, float] = {}
        for one, other in self._pairs:
            clearance = _separation(placed[id(one)], placed[id(other)], below)
            if clearance < below:
                pair = one.link, other.link
                found[pair] = min(clearance, found.get(pair, math.inf))
        for box in self._above_ground:
            clearance = _lowest(placed[id(box)]) - self._ground
            if clearance < below:
                pair = box.link, GROUND
                found[pair] = min(clearance, found.get(pair, math.inf))
        return found

    def _placed(self, positions: Mapping[str, float], boxes: Iterable[_Box]) -> dict[int, _PlacedBox]:
        frames = self._tree.poses(positions, self._joints)
        return {id(box): _place(box, frames[box.link]) for box in boxes}


def _box(box: CollisionBox) -> _Box:
    half = scaled(box.size, 0.5)
    return _Box(box.link, Transform.from_pose(box.origin), half, math.hypot(*half))


def _place(box: _Box, link: Transform) -> _PlacedBox:
    frame = link @ box.frame
    return _PlacedBox(frame.position, transposed(frame.rotation), box.half, box.radius)


def _lowest(box: _PlacedBox) -> float:
    return box.middle[2] - sum(abs(axis[2]) * half for axis, half in zip(box.axes, box.half, strict=True))


def _separation(one: _PlacedBox, other: _PlacedBox, below: float) -> float:
    """The greatest separation of two boxes along an axis, or any value of at least `below`."""
    way = difference(other.middle, one.middle)
    reach = one.radius + other.radius
    length = math.hypot(*way)
    if length - reach >= below:
        return length - reach
    best = -math.inf
    for axis in _axes(one, other):
        separation = abs(dot(way, axis)) - _half_width(one, axis) - _half_width(other, axis)
        if separation > best:
            best = separation
            if best >= below:
                break
    return best


def _axes(one: _PlacedBox, other: _PlacedBox) -> Iterator[Vector]:
    yield from one.axes
    yield from other.axes
    for a in one.axes:
        for b in other.axes:
            normal = cross(a, b)
            length = math.hypot(*normal)
            if length > PARALLEL:
                yield scaled(normal, 1.0 / length)


def _half_width(box: _PlacedBox, axis: Vector) -> float:
    (a, b, c), (x, y, z) = box.axes, box.half
    return abs(dot(a, axis)) * x + abs(dot(b, axis)) * y + abs(dot(c, axis)) * z
