"""What a skid-steered chassis is like: its size, its mass, and what it can do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.platform.description import RobotModel
from jauspy.platform.measures import measure

ATTAINED: Final = 0.95
"""Part of the speed that the tracks have without resistance which they keep on the ground."""


@dataclass(frozen=True, slots=True)
class Chassis:
    """Metres, kilograms, m/s, m/s^2, rad/s, rad/s^2; the defaults are those of a small tracked robot.

    Sizes are distances from the base's origin with the arm as it starts; the centre of gravity is in the base's frame
    (x forward, y left, z up).
    """

    max_speed: float = 1.5
    """Fastest forward and backward."""
    max_turn_rate: float = 1.2
    """Fastest turn that guidance asks for; a tracked robot could turn faster than is good for its load."""
    acceleration: float = 1.0
    deceleration: float = 1.5
    turn_acceleration: float = 3.0
    track_separation: float = 0.46
    """From the middle of one track to that of the other."""
    front: float = 0.345
    back: float = 0.345
    left: float = 0.28
    right: float = 0.28
    top: float = 0.29
    bottom: float = 0.0
    mass: float = 50.3
    centre_of_gravity: tuple[float, float, float] = (0.0, 0.0, 0.16)


def chassis_of(robot: RobotModel) -> Chassis:
    """Size, mass, distance and speed of the tracks are those of its description; the rest are `Chassis`'s defaults."""
    left, right = (robot.description.joint(name) for name in (robot.tracks.left[0], robot.tracks.right[0]))
    found = measure(robot)
    return Chassis(
        max_speed=ATTAINED * min(left.velocity, right.velocity),
        track_separation=abs(left.origin.y - right.origin.y),
        front=max(0.0, found.high[0]),
        back=max(0.0, -found.low[0]),
        left=max(0.0, found.high[1]),
        right=max(0.0, -found.low[1]),
        top=max(0.0, found.high[2]),
        bottom=max(0.0, -found.low[2]),
        mass=found.mass,
        centre_of_gravity=found.centre_of_gravity,
    )
