"""The client of a cell: what it makes of the times of the robot's clock."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from jauspy.cell.client import RobotClock


def test_a_time_of_the_robot_is_compared_by_the_fastest_observation() -> None:
    clock = RobotClock()
    assert clock.here(3.0) == math.inf
    for observed, delay in ((1.0, 0.30), (1.1, 0.12), (1.2, 0.25)):
        clock.compare(observed, 100.0 + observed + delay)
    assert clock.here(2.0) == pytest.approx(102.12)


def test_a_late_observation_or_two_do_not_move_it() -> None:
    clock = RobotClock()
    for number in range(20):
        clock.compare(0.1 * number, 50.0 + 0.1 * number + (0.4 if number % 5 in (3, 4) else 0.05))
        assert clock.here(0.0) == pytest.approx(50.05)


def test_it_falls_behind_with_a_robot_whose_time_has_paused() -> None:
    clock = RobotClock()
    for number in range(5):
        clock.compare(0.1 * number, 10.0 + 0.1 * number)
    for number in range(5, 10):
        clock.compare(0.1 * number, 10.5 + 0.1 * number)
    assert clock.here(1.0) == pytest.approx(11.5)
    clock.compare(1.0, 11.2)
    assert clock.here(1.0) == pytest.approx(11.2), "what comes sooner was not behind by so much"
