"""Checks of an arm's postures and motions for contact, with exact distances by coal through pinocchio.

Checks run in compiled code. Pairs of shapes are checked in groups by the joint that moves them, so that a motion is
divided only as finely as that joint's lever needs (docs/adr/0191-motions-of-arms.md).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any, Final

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from jauspy.planning.arm_model import ArmModel, geometry_of
from jauspy.planning.obstacles import Array, Obstacles, Primitive

FAR: Final = 0.3
"""Metres; what is farther off counts as this far."""
FINE: Final = 0.02
"""Metres that a point of the arm moves at most between two postures that are checked."""
THIRDS: Final = 3
"""Parts that a piece of a motion is divided into."""
WIDER: Final = (FINE * THIRDS**2 / 2.0, FINE * THIRDS / 2.0)
"""Metres beyond the margin that pieces of both sizes must be clear by."""
STAY: Final = 0.001
"""Metres by which things that are nearer than the margin at the start may come nearer still."""
SAME: Final = 0.0001
"""Metres below which distances count as the same in measurements of clearance."""
WORTHWHILE: Final = 0.4
"""Share of pieces that must be clear, so that pieces of their size are looked at before they are divided."""
NEWEST: Final = 0.05
"""Weight of the newest piece in that share."""
VOXELS: Final = "what sensors see"
"""Name of voxels in messages."""


@dataclass(frozen=True, slots=True)
class Distance:
    """A distance in metres, and the names of the two things that it is between."""

    metres: float
    between: tuple[str, str] = ("", "")


class Contacts:
    """An arm among obstacles."""

    def __init__(self, arm: ArmModel, obstacles: Obstacles, margin: float, payload: Primitive | None = None) -> None:
        """Prepare checks; `margin`: metres to keep from everything, but for what is nearer at the start."""
        self.arm, self.margin = arm, margin
        things, levers = list(zip(arm.links, arm.geometry.geometryObjects, strict=True)), arm.levers
        pairs, moving = list(arm.pairs), list(arm.moving)
        if payload is not None:
            held = pin.GeometryObject("held", arm.tool_body, arm.tool_frame * _pose(payload), geometry_of(payload))
            pairs += [(other, len(things)) for other in arm.apart_from_tool]
            moving.append(len(things))
            things.append((payload.name, held))
            levers = np.vstack([levers, arm.levers_of(held)])
        still = [(thing.name, _pose(thing), geometry_of(thing)) for thing in obstacles.primitives]
        if len(obstacles.voxels):
            still.append((VOXELS, *_octree(obstacles)))
        for name, frame, geometry in still:
            pairs += [(one, len(things)) for one in moving]
            things.append((name, pin.GeometryObject(f"still {len(things)}", 0, frame, geometry)))
        levers = np.vstack([levers, np.zeros((len(still), levers.shape[1]))])
        numbers = np.array(pairs, int).reshape(-1, 2)
        nearer = arm.relative_levers([shape for _, shape in things], levers, numbers)
        self._groups = [_Group(arm, things, numbers[chosen], nearer[chosen], margin) for chosen in _alike(nearer)]

    @property
    def checks(self) -> int:
        """Checks of postures, for each group of pairs, so far."""
        return sum(group.checks for group in self._groups)

    def is_free(self, posture: Array) -> bool:
        """True if a posture keeps the margin."""
        q = self.arm.configuration(posture)
        return all(group.keeps(q) for group in self._groups)

    def distance(self, posture: Array) -> Distance:
        """The smallest distance in a posture; 0 metres or less in contact."""
        q = self.arm.configuration(posture)
        return min((group.distance(q) for group in self._groups), key=lambda found: found.metres, default=Distance(FAR))

    def allow(self, posture: Array) -> Distance:
        """Let pairs that are nearer than the margin in a posture come as near again; the smallest distance there."""
        found = self.distance(posture)
        if found.metres < self.margin:
            for group in self._groups:
                group.allow()
        return found

    def is_motion_free(self, one: Array, other: Array, *, finely: bool = True) -> bool:
        """True if a straight motion in joint space keeps the margin, from after its start on.

        First at its end, where most motions of a search fail. Without `finely`, points of the arm may move 6 cm unseen
        between two postures in which the margin is kept.
        """
        if not self.is_free(other):
            return False
        way = other - one
        return all(group.is_motion_free(one, way, finely) for group in self._groups)

    def clearance(self, points: Sequence[Array]) -> Distance:
        """The smallest distance on straight motions through points, looked at in fine steps."""
        best = min(self.distance(points[0]), self.distance(points[-1]), key=lambda found: found.metres)
        for group in self._groups:
            best = group.least_distance(points, best)
        return best


class _Group:
    """Pairs of shapes whose distances are changed by the same joints, with the distances that they must keep."""

    def __init__(
        self, arm: ArmModel, things: Sequence[tuple[str, Any]], pairs: Array, levers: Array, margin: float
    ) -> None:
        """Prepare checks of `pairs` of numbers of named shapes; `levers`: metres for a unit of each joint, by pair."""
        self.checks = 0
        self._arm, self._margin = arm, margin
        self._kinematics = arm.kinematics.createData()
        self._shapes = pin.GeometryModel()
        used = np.unique(pairs)
        for number in used.tolist():
            self._shapes.addGeometryObject(things[number][1])
        self._names = [things[number][0] for number in used.tolist()]
        for one, other in np.searchsorted(used, pairs).tolist():
            self._shapes.addCollisionPair(pin.CollisionPair(one, other))
        self._levers: Array = levers.max(axis=0)
        # of the way that the farthest shape moves on a piece of a motion, the most that those of a pair come nearer
        moved = self._levers > 0.0
        self._shares: Array = (levers[:, moved] / self._levers[moved]).max(axis=1, initial=0.0)
        self._near = _Margins(arm, self._shapes, np.full(len(pairs), margin))
        self._wide = [_Margins(arm, self._shapes, margin + extra * self._shares) for extra in WIDER]
        self._kept = [1.0] * len(WIDER)
        """For the sizes of pieces, the share of those lately looked at that everything was clear by."""

    def keeps(self, q: Array) -> bool:
        """True if a configuration keeps the margin."""
        return self._keeps(self._near, q)

    def is_motion_free(self, one: Array, way: Array, finely: bool) -> bool:
        """True if the margin is kept between a posture and its end.

        In pieces that everything is clear by, where the arm may be anywhere on a piece; those that are too near to
        something are divided in three, twice. Pieces of a size of which few are clear are divided at once.
        """
        moved = float(np.abs(way) @ self._levers)
        size = FINE * THIRDS**2
        levels = list(range(len(WIDER)))
        while levels and self._kept[levels[0]] < WORTHWHILE:
            size /= THIRDS
            del levels[0]
        if not levels and not finely:
            size *= THIRDS
        count = max(1, math.ceil(moved / size))
        shares: Array = (_halving(count) + 0.5) / count
        width = 1.0 / count
        configuration, kept = self._arm.configuration, self._kept
        for level in levels:
            close = []
            for share, posture in zip(shares.tolist(), one + shares[:, None] * way, strict=True):
                q = configuration(posture)
                is_clear = self._keeps(self._wide[level], q)
                kept[level] += NEWEST * (is_clear - kept[level])
                if not is_clear:
                    if not self.keeps(q):
                        return False
                    close.append(share)
            if not close:
                return True
            width /= THIRDS
            shares = (np.array(close)[:, None] + np.array([0.0, -width, width])).ravel()
        if levels:
            if not finely:
                return True
            shares = (np.array(close)[:, None] + np.array([-width, width])).ravel()
        return all(self.keeps(configuration(posture)) for posture in one + shares[:, None] * way)

    def distance(self, q: Array) -> Distance:
        """The smallest distance of a configuration."""
        nearest = pin.computeDistances(self._arm.kinematics, self._kinematics, self._shapes, self._near.data, q)
        pair, result = self._shapes.collisionPairs[nearest], self._near.data.distanceResults[nearest]
        return Distance(min(result.min_distance, FAR), (self._names[pair.first], self._names[pair.second]))

    def allow(self) -> None:
        """Let pairs that were nearer than the margin when `distance` was called come as near again."""
        for number, result in enumerate(self._near.data.distanceResults):
            if result.min_distance < self._margin:
                least = max(0.0, result.min_distance - STAY)
                self._near.set(number, least)
                for margins, extra in zip(self._wide, WIDER, strict=True):
                    margins.set(number, least + extra * self._shares[number])

    def least_distance(self, points: Sequence[Array], best: Distance) -> Distance:
        """The smallest distance on straight motions through points, if it is smaller than `best`."""
        rows = [points[0][None]]
        for one, other in pairwise(points):
            count = max(1, math.ceil(float(np.abs(other - one) @ self._levers) / FINE))
            rows.append(one + (np.arange(1, count + 1) / count)[:, None] * (other - one))
        postures = np.concatenate(rows)
        within = _Margins(self._arm, self._shapes, self._slightly_less(best))
        for number in _halving(len(postures)).tolist():
            q = self._arm.configuration(postures[number])
            if not self._keeps(within, q):
                found = self.distance(q)
                if found.metres < best.metres:
                    best = found
                    within.set_all(self._slightly_less(best))
        return best

    def _slightly_less(self, found: Distance) -> Array:
        return np.full(len(self._shares), max(0.0, found.metres - SAME))

    def _keeps(self, margins: _Margins, q: Array) -> bool:
        self.checks += 1
        return not pin.computeCollisions(self._arm.kinematics, self._kinematics, margins.pairs, q, True)


class _Margins:
    """The distances that pairs of shapes must keep."""

    def __init__(self, arm: ArmModel, shapes: Any, metres: Array) -> None:
        self.data = shapes.createData()
        self.set_all(metres)
        for request in self.data.distanceRequests:
            request.enable_signed_distance = False  # depths of contacts take 30 times as long
        # of pinocchio's, it is the fastest with some dozens of shapes; DynamicAABBTreeArray misses contacts
        self.pairs = pin.BroadPhaseManager_NaiveCollisionManager(arm.kinematics, shapes, self.data)

    def set_all(self, metres: Array) -> None:
        """Set all distances, none of which may then be larger than at first."""
        for request, margin in zip(self.data.collisionRequests, metres.tolist(), strict=True):
            request.security_margin = margin

    def set(self, pair: int, metres: float) -> None:
        """Set one distance, which may not be larger than at first."""
        self.data.collisionRequests[pair].security_margin = metres


def _alike(levers: Array) -> list[Array]:
    """Masks of the pairs, shape (n, joints), that are checked in the same pieces of motions.

    Those that the first joint changes are one group: all obstacles. The others are divided by the first joint that
    changes them, where its lever is less than half of that of the joint before.
    """
    first = np.where(levers.any(axis=1), (levers > 0.0).argmax(axis=1), 0)
    groups, longest = [first == 0], 0.0
    for column in range(1, levers.shape[1]):
        chosen = first == column
        if not chosen.any():
            continue
        lever = float(levers[chosen, column].max())
        if lever < 0.5 * longest or len(groups) == 1:
            groups.append(chosen)
            longest = lever
        else:
            groups[-1] = groups[-1] | chosen
    return [chosen for chosen in groups if chosen.any()]


@lru_cache(maxsize=1024)
def _halving(count: int) -> NDArray[np.int64]:
    """The numbers below `count`, the middle first, then those of the halves, and so on."""
    found, spans = [], [(0, count)]
    for low, high in spans:
        if low < high:
            middle = (low + high) // 2
            found.append(middle)
            spans += [(low, middle), (middle + 1, high)]
    return np.array(found)


def _pose(primitive: Primitive) -> Any:
    return pin.SE3(np.array(primitive.pose.rotation), np.array(primitive.pose.position))


def _payload_reach(payload: Primitive) -> Array:
    """A vector at least as long as the way from the tool to the farthest point of a held thing."""
    geometry = geometry_of(payload)
    geometry.computeLocalAABB()
    return np.array([*payload.pose.position, float(geometry.aabb_radius)])


def _octree(obstacles: Obstacles) -> tuple[Any, Any]:
    """The frame and the octree of all voxels; its cells are on multiples of their size in the frame."""
    size = obstacles.voxel_size
    shift = obstacles.voxels[0] % size - size / 2.0
    return pin.SE3(np.eye(3), shift), coal.makeOctree(obstacles.voxels - shift, size)
