"""The PID controller."""

import pytest

from jauspy.platform.description import Gains
from jauspy.platform.joint_control import Pid


def settle(pid: Pid, load: float, seconds: float, dt: float = 0.002) -> tuple[float, float]:
    """Position and speed of 1 kg under a constant force, controlled towards 1."""
    position = velocity = 0.0
    for _ in range(round(seconds / dt)):
        velocity += (pid.update(1.0 - position, -velocity, dt) + load) * dt
        position += velocity * dt
    return position, velocity


def test_integral_removes_the_error_under_load() -> None:
    without, _ = settle(Pid(Gains(p=100.0, d=20.0), 200.0), -10.0, 5.0)
    position, velocity = settle(Pid(Gains(p=100.0, i=100.0, d=20.0), 200.0), -10.0, 10.0)
    assert without == pytest.approx(0.9, abs=0.001)
    assert (position, velocity) == (pytest.approx(1.0, abs=1e-4), pytest.approx(0.0, abs=1e-4))


def test_output_is_limited() -> None:
    pid = Pid(Gains(p=100.0), 5.0)
    assert (pid.update(1.0, 0.0, 0.1), pid.update(-1.0, 0.0, 0.1)) == (5.0, -5.0)


def test_integral_does_not_wind_up() -> None:
    pid = Pid(Gains(p=1.0, i=10.0), 5.0)
    for _ in range(1000):
        pid.update(100.0, 0.0, 0.01)
    assert pid.update(-1.0, 0.0, 0.01) < 0.0


def test_integral_is_limited() -> None:
    pid = Pid(Gains(p=0.0, i=10.0, i_limit=2.0), 5.0)
    for _ in range(1000):
        pid.update(1.0, 0.0, 0.01)
    assert pid.update(0.0, 0.0, 0.01) == 2.0


def test_reset_clears_the_integral() -> None:
    pid = Pid(Gains(p=1.0, i=10.0), 5.0)
    pid.update(1.0, 0.0, 0.1)
    pid.reset()
    assert pid.update(1.0, 0.0, 0.1) == 1.0


def test_feed_forward_is_limited_with_the_output() -> None:
    pid = Pid(Gains(p=1.0), 5.0)
    assert (pid.update(1.0, 0.0, 0.1, feed_forward=2.0), pid.update(1.0, 0.0, 0.1, feed_forward=9.0)) == (3.0, 5.0)
