"""Values of mobility messages that only some fields can hold: positions, altitudes and speeds (AS6009).

Most messages have a form with narrow fields and an `Ext` form with wide ones.
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.messages.mobility import Speed, ZPosition

MAX_XYZ: Final = 100_000.0
"""Metres along x, y and z in the narrow forms."""
MAX_XY_EXT: Final = 20_000_000.0
"""Metres along x and y in the wide forms."""
MAX_Z_EXT: Final = 50_000.0
"""Metres along z in the wide forms."""
MIN_ALTITUDE: Final = -10_000.0
MAX_ALTITUDE: Final = 35_000.0
"""Metres, in global poses and in vectors."""
MAX_RMS: Final = 100.0
"""Largest error in every message: metres, m/s, m/s^2."""
MAX_SPEED: Final = 327.67
"""m/s, in every message."""
_GROUND_SPEEDS: Final = (Speed.Choice.SPEED_OVER_GROUND, Speed.Choice.SPEED_RELATIVE_TO_MEDIUM)


def encodable(value: float, limit: float) -> float | None:
    """The value if it is within -limit..limit, else None, so that its optional field is left out."""
    return value if abs(value) <= limit else None


def encodable_rms(error: float | None, limit: float = MAX_RMS) -> float | None:
    """An error of a position, velocity or acceleration; the largest that its field holds for a larger one."""
    return None if error is None else min(error, limit)


def encodable_angle_rms(error: float | None) -> float | None:
    """Same as `encodable_rms`, for an attitude in radians, or a rate in the narrow form."""
    return encodable_rms(error, math.pi)


def encodable_altitude(value: float) -> float | None:
    """Same as `encodable`, rounded to micrometres: sums of floats miss a limit that a client has set."""
    rounded = round(value, 6)
    return rounded if MIN_ALTITUDE <= rounded <= MAX_ALTITUDE else None


def encodable_z(z: ZPosition | None) -> ZPosition | None:
    """Same as `encodable`, for the vertical position of the wide forms."""
    return None if z is None or encodable(z.value, MAX_Z_EXT) is None else z


def local_z(position: ZPosition | None, lowest: float = -MAX_XYZ, highest: float = MAX_XYZ) -> float | None:
    """The z of a narrow form; None for a height above a datum, and for what does not fit."""
    if position is None or position.choice != ZPosition.Choice.Z_LOCAL:
        return None
    return position.value if lowest <= position.value <= highest else None


def ground_speed(speed: float | Speed) -> float | None:
    """m/s over ground, negative backward; None for revolutions and indicated speeds.

    A speed relative to the medium is one over ground, since the ground does not flow.
    """
    if not isinstance(speed, Speed):
        return speed
    return speed.value if speed.choice in _GROUND_SPEEDS else None


def speed_over_ground(speed: float) -> Speed:
    """A speed as the wide forms have it."""
    return Speed(Speed.Choice.SPEED_OVER_GROUND, speed)


def unsigned_speed(speed: float) -> float:
    """A speed as the narrow forms have it: without direction, and limited to `MAX_SPEED`."""
    return min(abs(speed), MAX_SPEED)
