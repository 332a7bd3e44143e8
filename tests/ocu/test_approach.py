from __future__ import annotations

import pytest

from jauspy.ocu.approach import FORWARD, Approach, Tuning

PLAIN = Tuning(gain=100, most=50, least=8, tolerance=0.1, standstill=0.01, look_ahead=0.5, nudge=5)


def test_effort_grows_with_the_error_up_to_a_limit():
    approach = Approach(PLAIN)
    assert approach.effort(0.3, 0.02) == pytest.approx(100 * (0.3 - 0.01))
    assert approach.effort(3, 1.0) == 50
    assert approach.effort(-3, 1.0) == -50


def test_the_last_bit_does_not_take_forever():
    assert Approach(PLAIN).effort(0.2, 0.3) == 8


def test_speed_is_braked_before_the_target():
    assert Approach(PLAIN).effort(0.2, 1.0) < 0


def test_friction_is_met_with_more_and_more_effort():
    approach = Approach(PLAIN)
    efforts = [approach.effort(-0.2, 0.0) for _ in range(3)]
    assert efforts == pytest.approx([-25, -30, -35])
    assert abs(approach.effort(-0.2, -0.1)) < 25


def test_it_has_arrived_when_it_is_there_and_stands():
    approach = Approach(PLAIN)
    assert approach.effort(0.05, 0.5) == 0
    assert not approach.arrived
    assert approach.effort(0.05, 0.0) == 0
    assert approach.arrived
    approach.effort(0.5, 0.0)
    assert not approach.arrived


def test_a_sluggish_chassis_gets_there():
    position, speed, approach = 0.0, 0.0, Approach(FORWARD)
    for _ in range(200):
        effort = approach.effort(2.0 - position, speed)
        for _ in range(20):  # 10 Hz reports, 5 ms steps, 15 % of friction, a time constant of 0.3 s
            pull = max(0.0, abs(effort) - 15) * (1 if effort > 0 else -1) * 0.015
            speed += (pull - speed) / 0.3 * 0.005
            position += speed * 0.005
        if approach.arrived:
            break
    assert approach.arrived
    assert position == pytest.approx(2.0, abs=0.03)
