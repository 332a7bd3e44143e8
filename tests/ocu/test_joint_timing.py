"""Times of a joint's way with ramps."""

from __future__ import annotations

import math

import pytest

from jauspy.ocu.joints import MotionLimits

LIMITS = MotionLimits(1.0, 2.0, 4.0)


def test_a_long_way_is_at_full_speed_between_the_ramps() -> None:
    assert LIMITS.least_duration(-3.0) == pytest.approx(3.0 + 0.25 + 0.125)


def test_a_short_way_has_ramps_only() -> None:
    way = 0.1
    top = math.sqrt(way / 0.375)
    assert LIMITS.least_duration(way) == pytest.approx(top / 2.0 + top / 4.0)
    assert LIMITS.least_duration(0.0) == 0.0


@pytest.mark.parametrize("duration", [3.375, 4.0, 30.0])
def test_the_speed_for_a_duration_takes_it(duration: float) -> None:
    speed = LIMITS.speed_for(3.0, duration)
    assert speed is not None
    assert MotionLimits(speed, 2.0, 4.0).least_duration(3.0) == pytest.approx(duration)


def test_no_speed_is_fast_enough() -> None:
    assert LIMITS.speed_for(3.0, 3.3) is None
    assert LIMITS.speed_for(3.0, 0.0) is None


def test_without_limits_any_way_takes_any_time() -> None:
    assert MotionLimits().least_duration(5.0) == 0.0
    assert MotionLimits().speed_for(5.0, 2.0) == 2.5
