"""Chains of modules as designs: kinematics, torques and connector loads at rest, and clearance."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from jauspy.cell.design.tasks import Obstacle
from jauspy.cell.frames import Array
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY, Vector, Z, add, cross, difference, dot, rotation_about, scaled
from jauspy.platform.modular.parts import PartType, ServoData, body_inertia, mass_of, output_inertia

RADIUS: Final = 0.045
"""Metres around the middle line: half the diagonal of the largest housing, 68 mm x 56 mm."""
SPACING: Final = 0.03
"""Metres between the points of a middle line."""
LOAD_SIDE: Final = 0.07
"""Metres: side of a load's square base, so that a plate of 30 mm radius lies on it."""
LOAD_DENSITY: Final = 2700.0
"""kg/m^3 of a load: aluminium."""


def load_height(mass: float) -> float:
    """Metres by which a load of this mass, in kilograms, stands out of the tip."""
    return mass / LOAD_DENSITY / LOAD_SIDE**2


@dataclass(frozen=True, slots=True)
class Element:
    """A part of a design, turned about the normal of the connector that carries it."""

    type: str
    turn: float = 0.0
    """Radians."""


@dataclass(frozen=True, slots=True)
class ChainPosture:
    """A chain with its joints at some positions, in the world."""

    tip: Transform
    axes: tuple[tuple[Vector, Vector], ...]
    """Middle and direction of each joint."""
    masses: tuple[tuple[Vector, float, int], ...]
    """Centre of mass, mass, and the number of joints before it."""
    connectors: tuple[tuple[Transform, int], ...]
    """Frame of the connector that carries each part, and the index of its first mass."""
    points: tuple[tuple[Vector, int], ...]
    """Points of the middle lines, and the index of their part."""

    def torques(self) -> list[float]:
        """Torque of gravity about each joint, newton metres."""
        found = []
        for joint, (origin, axis) in enumerate(self.axes):
            moment: Vector = (0.0, 0.0, 0.0)
            for center, mass, joints in self.masses:
                if joints > joint:
                    moment = add(moment, cross(difference(center, origin), (0.0, 0.0, -mass * GRAVITY)))
            found.append(dot(moment, axis))
        return found

    def loads(self) -> list[tuple[Vector, Vector]]:
        """Force and moment that each connector exerts, in its frame, base to tip; the last one is the tip's."""
        found = []
        for frame, first in self.connectors:
            force: Vector = (0.0, 0.0, 0.0)
            moment: Vector = (0.0, 0.0, 0.0)
            for center, mass, _ in self.masses[first:]:
                carried = (0.0, 0.0, mass * GRAVITY)
                force = add(force, carried)
                moment = add(moment, cross(difference(center, frame.position), carried))
            inverse = frame.inverse()
            found.append((inverse.rotate(force), inverse.rotate(moment)))
        return found

    def clearance(self, obstacles: Sequence[Obstacle], floor: float = 0.0) -> float:
        """Smallest distance from boxes and the floor, and of parts that are not neighbours; below zero is a touch."""
        best = math.inf
        for point, part in self.points:
            if part:
                best = min(best, point[2] - floor)
            for box in obstacles:
                inner = box.pose.inverse().apply(point)
                outside = [abs(value) - size / 2.0 for value, size in zip(inner, box.size, strict=True)]
                best = min(best, math.hypot(*(max(value, 0.0) for value in outside)) + min(max(outside), 0.0))
        for point, part in self.points:
            for other, second in self.points:
                if second > part + 2:
                    best = min(best, math.dist(point, other) - RADIUS)
        return best - RADIUS

    def clearance_from(self, middle_lines: Array) -> float:
        """Smallest distance from other chains, of which points of the middle lines are given; shape (points, 3)."""
        if not len(middle_lines):
            return math.inf
        own = np.array([point for point, _ in self.points])
        apart = np.linalg.norm(own[:, None, :] - middle_lines[None, :, :], axis=2)
        return float(apart.min()) - 2.0 * RADIUS


def servos(elements: Sequence[Element], types: Mapping[str, PartType]) -> list[ServoData]:
    """The servo modules of a chain, base to tip."""
    found = (types[element.type].servo for element in elements)
    return [servo for servo in found if servo is not None]


def placed(elements: Iterable[Element], types: Mapping[str, PartType]) -> list[tuple[Transform, PartType]]:
    """The parts of a chain, each with its frame in that of the connector that carries it."""
    return [(Transform(rotation_about(Z, element.turn)), types[element.type]) for element in elements]


def total_mass(elements: Sequence[Element], types: Mapping[str, PartType]) -> float:
    """Kilograms of all parts."""
    return sum(mass_of(types[e.type]) for e in elements)


def posture(
    mount: Transform,
    elements: Sequence[Element],
    types: Mapping[str, PartType],
    positions: Sequence[float],
    load: float = 0.0,
) -> ChainPosture:
    """The chain on a connector at `mount`; `load` is a mass in the middle of the tip's connector.

    Its points go on through the load, which stands out of the tip.
    """
    frame, joint = mount, 0
    axes: list[tuple[Vector, Vector]] = []
    masses: list[tuple[Vector, float, int]] = []
    connectors: list[tuple[Transform, int]] = []
    points: list[tuple[Vector, int]] = []
    for index, element in enumerate(elements):
        part = types[element.type]
        connectors.append((frame, len(masses)))
        start = frame.position
        frame = frame @ Transform(rotation_about(Z, element.turn))
        body = body_inertia(part)
        masses.append((frame.apply(body.center), body.mass, joint))
        if part.servo is not None:
            frame = frame @ part.servo.joint
            points += _line(start, frame.position, index)
            start = frame.position
            axes.append((frame.position, frame.rotate(part.servo.axis)))
            frame = frame @ Transform(rotation_about(part.servo.axis, positions[joint]))
            joint += 1
            output = output_inertia(part)
            masses.append((frame.apply(output.center), output.mass, joint))
        frame = frame @ next(iter(part.connectors.values()))
        points += _line(start, frame.position, index)
    connectors.append((frame, len(masses)))
    if load:
        masses.append((frame.position, load, joint))
        points += _line(frame.position, frame.apply((0.0, 0.0, load_height(load))), len(elements))
    return ChainPosture(frame, tuple(axes), tuple(masses), tuple(connectors), tuple(points))


def _line(start: Vector, end: Vector, part: int) -> list[tuple[Vector, int]]:
    count = max(1, math.ceil(math.dist(start, end) / SPACING))
    return [(add(start, scaled(difference(end, start), step / count)), part) for step in range(count + 1)]
