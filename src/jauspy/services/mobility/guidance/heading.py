"""Holding a heading at a speed; a skid-steered chassis turns on the spot first when it looks elsewhere."""

from __future__ import annotations

import math

from jauspy.services.mobility.guidance.motion import Motion
from jauspy.services.mobility.guidance.velocity_control import limit

TURN_GAIN = 1.8
"""Turn rate per heading error, 1/s."""
TURN_ON_THE_SPOT = 0.8
"""Heading error, rad, from which on the robot only turns."""


def head_for(error: float, speed: float, max_turn_rate: float) -> Motion:
    """The motion that takes the heading error (rad, positive when the heading lies to the right) to zero.

    The speed, negative for backward, fades as the error grows: a curve that is driven slowly is a narrow one.
    """
    fade = max(0.0, 1.0 - (error / TURN_ON_THE_SPOT) ** 2)
    return Motion(speed * fade, limit(TURN_GAIN * error, max_turn_rate))


def turn_of(heading: float, wanted: float) -> float:
    """The shorter way round from one heading to another, -pi..pi, positive to the right."""
    return math.remainder(wanted - heading, math.tau)
