"""Holding a heading at a speed; a skid-steered chassis turns on the spot first when it looks elsewhere."""

from __future__ import annotations

import math

from jauspy.services.mobility.guidance.motion import PlanarVelocity
from jauspy.services.mobility.guidance.velocity_control import clamp

TURN_GAIN = 1.8
"""Turn rate per heading error, 1/s."""
MAX_DRIVING_ERROR = 0.8
"""Heading error, rad, from which on the robot only turns."""


def steer_to_heading(error: float, speed: float, max_turn_rate: float) -> PlanarVelocity:
    """The motion that takes the heading error (rad, positive when the heading lies to the right) to zero.

    The speed, negative for backward, fades as the error grows: a curve that is driven slowly is a narrow one.
    """
    fade = max(0.0, 1.0 - (error / MAX_DRIVING_ERROR) ** 2)
    return PlanarVelocity(speed * fade, clamp(TURN_GAIN * error, max_turn_rate))


def heading_error(heading: float, wanted: float) -> float:
    """The shorter way round from one heading to another, -pi..pi, positive to the right."""
    return math.remainder(wanted - heading, math.tau)
