"""Cameras beside a robot, which look at it from outside: fixed, behind it, or around it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector, cross, difference, dot, scaled

LAG: Final = 0.8
"""Seconds in which a chasing camera makes up for 63 % of a turn of the robot."""
MIN_HEIGHT: Final = 0.15
"""Metres above the world's zero, below which no camera goes."""
_UP: Final = (0.0, 0.0, 1.0)


class Viewpoint(Enum):
    """Where the camera is: at a place of the world, behind the robot, or on a circle around it."""

    FIXED = "fixed"
    CHASE = "chase"
    ORBIT = "orbit"


@dataclass(frozen=True, slots=True)
class OutsideSetup:
    """Metres, radians, seconds."""

    view: Viewpoint
    position: Vector = (-3.0, -3.0, 2.0)
    """In the world, of a fixed camera."""
    target: Vector | None = None
    """What a fixed camera looks at, in the world; None: the robot."""
    distance: float = 2.6
    """From the robot, over the ground, of a camera that moves with it."""
    height: float = 1.5
    """Above the robot's base, likewise."""
    aim: float = 0.35
    """Height above the robot's base at which the camera looks."""
    angle: float = 0.0
    """Direction from straight behind the robot, counterclockwise; at the start of an orbit."""
    period: float = 24.0
    """Of one turn around the robot."""


class OutsideView:
    """Follows a robot; the same poses at the same times give the same views."""

    def __init__(self, setup: OutsideSetup) -> None:
        self._setup = setup
        self._began = self._last = math.nan
        self._heading = 0.0

    @property
    def follows(self) -> bool:
        """True if the camera moves with the robot."""
        return self._setup.view is not Viewpoint.FIXED

    def ends(self, time: float, base: Transform) -> tuple[Vector, Vector]:
        """Where the camera is and what it looks at, in the world; `base` is the robot's, `time` in seconds."""
        setup, (x, y, z) = self._setup, base.position
        robot = (x, y, z + setup.aim)
        if setup.view is Viewpoint.FIXED:
            return setup.position, robot if setup.target is None else setup.target
        heading = math.atan2(base.rotation[1][0], base.rotation[0][0])
        if math.isnan(self._last):
            self._began, self._heading = time, heading
        elapsed = 0.0 if math.isnan(self._last) else max(time - self._last, 0.0)
        self._last = time
        turn = math.remainder(heading - self._heading, math.tau)
        self._heading += turn * -math.expm1(-elapsed / LAG)
        around = self._heading + setup.angle + math.pi
        if setup.view is Viewpoint.ORBIT:
            around = setup.angle + math.pi + math.tau * (time - self._began) / setup.period
        away = setup.distance
        return (x + away * math.cos(around), y + away * math.sin(around), max(z + setup.height, MIN_HEIGHT)), robot


def looking(position: Vector, target: Vector) -> Transform:
    """The frame of a camera (x ahead, y left, z up) that looks from one point at another."""
    ahead = _unit(difference(target, position))
    side = cross(_UP, ahead)
    left = _unit(side) if max(map(abs, side)) > 1e-6 else (0.0, 1.0, 0.0)
    up = cross(ahead, left)
    rows = tuple(zip(ahead, left, up, strict=True))
    return Transform((rows[0], rows[1], rows[2]), position)


def _unit(a: Vector) -> Vector:
    return scaled(a, 1.0 / math.sqrt(dot(a, a)))
