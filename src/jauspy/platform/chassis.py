"""What a skid-steered chassis is like: its size, its mass, and what it can do."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Chassis:
    """Metres, kilograms, m/s, m/s^2, rad/s, rad/s^2; the defaults are inc1's.

    Sizes are distances from the base's origin, the centre of gravity is in the base's frame (x forward, y left, z up).
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
    wheel_radius: float = 0.085
    wheel_base: float = 0.52
    front: float = 0.345
    back: float = 0.345
    left: float = 0.28
    right: float = 0.28
    top: float = 0.29
    bottom: float = 0.0
    mass: float = 50.3
    centre_of_gravity: tuple[float, float, float] = (0.0, 0.0, 0.16)
