"""How far from the origin the messages about poses and waypoints reach (AS6009)."""

from __future__ import annotations

from typing import Final

from jauspy.messages.mobility import ZPosition

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
