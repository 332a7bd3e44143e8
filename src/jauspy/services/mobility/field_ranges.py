"""How far from the origin the messages about poses and waypoints reach (AS6009)."""

from __future__ import annotations

from typing import Final

from jauspy.messages.mobility import Speed, ZPosition

MAX_XYZ: Final = 100_000.0
"""Metres along x, y and z that fit the narrower forms; clients may set more by the wider ones."""
MAX_XY_EXT: Final = 20_000_000.0
"""Metres along x and y that fit the wider forms."""
MAX_Z_EXT: Final = 50_000.0
"""Metres along z that fit the wider forms."""
MIN_ALTITUDE: Final = -10_000.0
MAX_ALTITUDE: Final = 35_000.0
"""Altitudes that fit poses on the globe and vectors, metres."""


def encodable_altitude(value: float) -> float | None:
    """As `within`, for an altitude: to the micrometre, since sums of floats miss a limit that a client has set."""
    rounded = round(value, 6)
    return rounded if MIN_ALTITUDE <= rounded <= MAX_ALTITUDE else None


def local_z(position: ZPosition | None, lowest: float = -MAX_XYZ, highest: float = MAX_XYZ) -> float | None:
    """The z of a narrower form: a height above some datum is none, and what does not fit is left out."""
    if position is None or position.choice != ZPosition.Choice.Z_LOCAL:
        return None
    return position.value if lowest <= position.value <= highest else None


def encodable_z(z: ZPosition | None) -> ZPosition | None:
    """As `within`, for the vertical position of the wider forms."""
    return None if z is None or encodable(z.value, MAX_Z_EXT) is None else z


def encodable(value: float, most: float) -> float | None:
    """The value, or None, which leaves the field out, when the message cannot say it."""
    return value if abs(value) <= most else None


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
