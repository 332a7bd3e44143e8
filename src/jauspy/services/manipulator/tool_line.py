"""What a tool follows that is moved at a velocity: a pose that goes ahead on a straight line and turns evenly."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from jauspy.geometry.kinematics import KinematicState
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import Rotation, Vector, add, difference, dot, rotation_about, scaled

ARM_LENGTH: Final = 0.3
"""Metres that a radian per second counts as, when the speed of a motion is measured."""
LEASH: Final = 0.02
"""Metres or radians that the tool may fall behind before the pose waits for it."""


class ToolLine:
    """From `start` at `turning` rad/s and `moving` m/s, in the manipulator's coordinate system."""

    def __init__(self, start: Transform, turning: Vector, moving: Vector) -> None:
        self.turning, self.moving = turning, moving
        self._pose = start

    @property
    def speed(self) -> float:
        """Of moving and turning together, m/s."""
        return math.hypot(*self.moving) + ARM_LENGTH * math.hypot(*self.turning)

    def further(self, distance: float) -> Transform:
        """The pose when it will have moved on by so many metres."""
        way = scaled(self.moving, distance / math.hypot(*self.moving))
        return Transform(self._pose.rotation, add(self._pose.position, way))

    def deviation(self, tool: Transform) -> tuple[Vector, Vector]:
        """Radians that the tool has to turn, and metres that it has to move, to have the pose."""
        return rotation_vector(tool.rotation, self._pose.rotation), difference(self._pose.position, tool.position)

    def advance(self, now: KinematicState, rates: Sequence[float], dt: float) -> None:
        """Go ahead as far as the tool does in `dt` seconds with these velocities of the joints, on a leash."""
        turning, moving = now.velocity(rates)
        time = dt * (_part(moving, self.moving) if any(self.moving) else _part(turning, self.turning))
        position = add(self._pose.position, scaled(self.moving, time))
        self._pose = Transform(_turned(self._pose.rotation, scaled(self.turning, time)), position)
        turn, way = self.deviation(now.tool)
        tool = now.tool
        self._pose = Transform(_turned(tool.rotation, _leashed(turn)), add(tool.position, _leashed(way)))


def _part(found: Vector, wanted: Vector) -> float:
    square = dot(wanted, wanted)
    return min(1.0, max(0.0, dot(found, wanted) / square)) if square else 0.0


def _turned(rotation: Rotation, turn: Vector) -> Rotation:
    angle = math.hypot(*turn)
    return (
        (Transform(rotation_about(scaled(turn, 1.0 / angle), angle)) @ Transform(rotation)).rotation
        if angle
        else rotation
    )


def _leashed(offset: Vector) -> Vector:
    length = math.hypot(*offset)
    return scaled(offset, LEASH / length) if length > LEASH else offset
