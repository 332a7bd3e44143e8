"""Times at which robots do what they repeat."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, strategies as st

from jauspy.beats import next_beat


@given(st.floats(0.0, 1e7), st.floats(0.001, 100.0), st.integers(1, 0xFFFE))
def test_beats_of_a_subsystem_are_a_period_apart(now: float, period: float, subsystem: int) -> None:
    first = next_beat(now, period, subsystem)
    error = 1e-9 * max(1.0, now)
    assert now - error <= first <= now + period + error
    later = next_beat(now + 0.7 * period, period, subsystem)
    assert min(abs(later - first), abs(later - first - period)) <= error, "whenever they begin"


@pytest.mark.parametrize("period", [0.1, 0.2, 1.0, 5.0])
def test_beats_of_robots_are_spread_over_the_period(period: float) -> None:
    beats = sorted(next_beat(0.0, period, subsystem) for subsystem in range(101, 161))
    gaps = [after - before for before, after in pairwise([*beats, beats[0] + period])]
    assert max(gaps) < 2.5 / 60 * period


@given(st.floats(0.0, 1e6), st.integers(1, 0xFFFE), st.sampled_from([(0.1, 0.2), (0.1, 1.0), (0.2, 1.0), (1.0, 5.0)]))
def test_what_is_repeated_less_often_comes_with_what_is_repeated_more_often(
    now: float, subsystem: int, periods: tuple[float, float]
) -> None:
    short, long = periods
    rare = next_beat(now, long, subsystem)
    assert next_beat(rare - 0.5 * short, short, subsystem) == pytest.approx(rare, abs=1e-6)
