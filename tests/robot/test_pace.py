"""Steps in time with a clock, without a clock."""

import pytest

from jauspy.robot.realtime import StepTimer


@pytest.fixture
def timer() -> StepTimer:
    return StepTimer(0.01, 0.1, start=100.0)


def test_first_step_is_due_after_one_period(timer):
    assert timer.wait(100.0) == pytest.approx(0.01)
    assert timer.wait(100.004) == pytest.approx(0.006)


def test_steps_do_not_drift_when_each_starts_a_little_late(timer):
    for n in range(1, 101):
        assert timer.wait(99.995 + n * 0.01) == pytest.approx(0.005)
        timer.begin(100.003 + n * 0.01)
    assert timer.counters == {"steps": 100, "late": 0, "slow": 0, "skipped": 0, "abandoned": 0, "faults": 0}


def test_catches_up_after_a_short_delay(timer):
    made = 0
    while timer.wait(100.06) == 0.0:
        timer.begin(100.06)
        made += 1
    assert made in (5, 6)
    assert timer.counters["late"] >= 4
    assert timer.counters["skipped"] == 0


def test_long_delays_skip_steps(timer):
    timer.begin(105.0)
    assert timer.counters["skipped"] in (498, 499)
    timer.begin(105.0)
    assert timer.wait(105.0) > 0.0
    assert timer.counters["steps"] + timer.counters["skipped"] in (500, 501)


def test_a_clock_that_is_set_back_does_not_stop_the_steps(timer):
    timer.begin(100.01)
    assert timer.wait(40.0) == pytest.approx(0.01)
    timer.begin(40.01)
    assert timer.wait(40.01) == pytest.approx(0.01)
    assert timer.counters["skipped"] == timer.counters["late"] == 0
