"""How the joints move the tool: its pose for positions of the joints, and what each joint adds to its velocity."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Final

from jauspy.geometry.denavit_hartenberg import Link
from jauspy.geometry.vectors import (
    Rotation,
    Transform,
    Vector,
    Z,
    add,
    cross,
    difference,
    quaternion,
    scaled,
    transposed,
)

_STILL: Final[Vector] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Stance:
    """The tool for some positions of the joints, in the manipulator's coordinate system."""

    tool: Transform
    """The tool point, and the attitude of the last joint's frame."""
    turning: tuple[Vector, ...]
    """Angular velocity of the last link for a unit of velocity of each joint."""
    moving: tuple[Vector, ...]
    """Linear velocity of the tool point for a unit of velocity of each joint."""

    def velocity(self, rates: Sequence[float]) -> tuple[Vector, Vector]:
        """Angular and linear velocity of the tool for velocities of the joints."""
        return _sum(self.turning, rates), _sum(self.moving, rates)


def frames(links: Sequence[Link], positions: Sequence[float]) -> list[Transform]:
    """The joints' frames in the manipulator's coordinate system, base to tip; positions in the standard's terms."""
    rows = zip(links, positions, strict=True)
    return list(accumulate((link.frame(position) for link, position in rows), operator.matmul))


def stance(links: Sequence[Link], positions: Sequence[float], tool: Vector) -> Stance:
    """The tool for these positions; `tool` is the tool point in the last joint's frame, metres."""
    found = frames(links, positions)
    point = found[-1].apply(tool)
    axes = [frame.turn(Z) for frame in found]
    rows = list(zip(links, found, axes, strict=True))
    return Stance(
        Transform(found[-1].rotation, point),
        tuple(axis if link.is_revolute else _STILL for link, _, axis in rows),
        tuple(
            cross(axis, difference(point, frame.position)) if link.is_revolute else axis for link, frame, axis in rows
        ),
    )


def turn_between(start: Rotation, end: Rotation) -> Vector:
    """The axis about which one attitude is turned to get another, as long as the angle in radians."""
    d, *vector = quaternion((Transform(end) @ Transform(transposed(start))).rotation)
    sine = math.hypot(*vector)
    factor = 2.0 * math.atan2(sine, d) / sine if sine else 2.0
    a, b, c = vector
    return a * factor, b * factor, c * factor


def _sum(columns: Sequence[Vector], rates: Sequence[float]) -> Vector:
    total = _STILL
    for column, rate in zip(columns, rates, strict=True):
        total = add(total, scaled(column, rate))
    return total
