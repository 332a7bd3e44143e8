"""Between REP-103 (x forward, y left, z up) and JAUS (x forward, y right, z down), for frames and points."""

from __future__ import annotations

from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import X, Y, Z, scaled

JAUS_FROM_REP_103: Final = Transform((X, scaled(Y, -1.0), scaled(Z, -1.0)))
"""A half turn about x; its own inverse. It takes the frame of a vehicle, and that of a sensor on it, to JAUS's."""


def jaus_frame(frame: Transform) -> Transform:
    """A frame in another one, when both are turned to JAUS's axes; its own inverse."""
    return JAUS_FROM_REP_103 @ frame @ JAUS_FROM_REP_103
