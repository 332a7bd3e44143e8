"""Steps in time with a clock, without a clock."""

import pytest

from jauspy.modules.pace import Pace


@pytest.fixture
def pace() -> Pace:
    return Pace(0.01, 0.1, start=100.0)


def test_first_step_is_due_after_one_step(pace):
    assert pace.wait(100.0) == pytest.approx(0.01)
    assert pace.wait(100.004) == pytest.approx(0.006)


def test_steps_do_not_drift_when_each_starts_a_little_late(pace):
    for n in range(1, 101):
        assert pace.wait(99.995 + n * 0.01) == pytest.approx(0.005)
        pace.begin(100.003 + n * 0.01)
    assert pace.counters == {"steps": 100, "late": 0, "skipped": 0, "abandoned": 0}


def test_catches_up_after_a_short_delay(pace):
    made = 0
    while pace.wait(100.06) == 0.0:
        pace.begin(100.06)
        made += 1
    assert made in (5, 6)
    assert pace.counters["late"] >= 4
    assert pace.counters["skipped"] == 0


def test_gives_up_what_is_too_late(pace):
    pace.begin(105.0)
    assert pace.counters["skipped"] in (498, 499)
    pace.begin(105.0)
    assert pace.wait(105.0) > 0.0
    assert pace.counters["steps"] + pace.counters["skipped"] in (500, 501)
