"""The kinds of speed that a client may give."""

from __future__ import annotations

from typing import Final

from jauspy.messages.mobility import Speed

MAX_SPEED: Final = 327.67
"""m/s, in every message."""
_ON_THE_GROUND: Final = (Speed.Choice.SPEED_OVER_GROUND, Speed.Choice.SPEED_RELATIVE_TO_MEDIUM)


def ground_speed(speed: float | Speed) -> float | None:
    """m/s over the ground, negative backward; None for revolutions and indicated speeds. The ground does not flow."""
    if not isinstance(speed, Speed):
        return speed
    return speed.value if speed.choice in _ON_THE_GROUND else None


def speed_over_ground(speed: float) -> Speed:
    """A speed as the wider messages have it."""
    return Speed(Speed.Choice.SPEED_OVER_GROUND, speed)


def unsigned_speed(speed: float) -> float:
    """A speed as the narrower messages have it: without its direction, and 1 cm/s less at most than backward."""
    return min(abs(speed), MAX_SPEED)
