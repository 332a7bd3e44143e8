"""Times at which a robot does what it repeats: all of it at once, so that its program wakes once for all of it.

What other robots on the machine repeat comes at other times.
"""

from __future__ import annotations

import math
from typing import Final

SPREAD: Final = 30.0
"""Seconds over which the times of robots are spread: of 5 to 70 s, those with which 20 and 60 robots lie apart most
evenly, for periods from 0.1 to 5 s."""
_GOLDEN: Final = 0.618034
"""Part of them by which the times of robots with successive subsystem ids are apart."""


def next_beat(now: float, period: float, subsystem: int) -> float:
    """The first of the times of a subsystem, one `period` (s) apart, that is after `now`.

    Those of a period are among those of each shorter one that divides it.
    """
    phase = SPREAD * (subsystem * _GOLDEN % 1.0)
    return phase + period * (math.floor((now - phase) / period) + 1)
