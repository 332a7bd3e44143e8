"""Velocities of several joints within their motion profiles, in proportion, so that the tool keeps its direction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.services.manipulator.arm import MotionProfile


def scaled_to_speed(rates: Sequence[float], profiles: Sequence[MotionProfile]) -> list[float]:
    """All as much slower as the one that is too fast needs to be."""
    rows = zip(rates, profiles, strict=True)
    share = min((1.0, *(profile.speed / abs(rate) for rate, profile in rows if abs(rate) > profile.speed)))
    return [rate * share for rate in rates]


def limited_change(
    before: Sequence[float], after: Sequence[float], profiles: Sequence[MotionProfile], dt: float
) -> list[float]:
    """From velocities toward others, as far as each joint may change its own in `dt` seconds."""
    share = 1.0
    for old, new, profile in zip(before, after, profiles, strict=True):
        most = (profile.deceleration if abs(new) < abs(old) else profile.acceleration) * dt
        if abs(new - old) > most:
            share = min(share, most / abs(new - old))
    return [old + share * (new - old) for old, new in zip(before, after, strict=True)]


def braking_speed(left: float, profile: MotionProfile, dt: float) -> float:
    """The speed from which a joint can stop within what is left of its way, told every `dt` seconds."""
    change = profile.deceleration * dt
    return math.sqrt(change * change / 4.0 + 2.0 * profile.deceleration * max(0.0, left)) - change / 2.0
