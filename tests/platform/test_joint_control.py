"""The control of a joint: PID controller and setpoint."""

from itertools import pairwise

import pytest

from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.joint_control import Pid, SetpointGenerator
from jauspy.platform.joints import ControlMode, Gains, Target


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


JOINT = Joint("elbow", JointKind.REVOLUTE, "a", "b", lower=-2.0, upper=1.0, effort=10.0, velocity=0.5)
DT = 0.002


def run(motion: SetpointGenerator, seconds: float) -> list[tuple[float, float]]:
    path = []
    for _ in range(round(seconds / DT)):
        motion.advance(DT)
        path.append((motion.position, motion.velocity))
    return path


@pytest.mark.parametrize("goal", [0.9, -1.7, 0.001, 0.0])
def test_arrives_without_overshoot_within_speed_and_acceleration(goal: float) -> None:
    motion = SetpointGenerator(JOINT, 0.0)
    motion.target = Target(ControlMode.POSITION, goal, speed=0.4, acceleration=2.0, deceleration=2.0)
    path = run(motion, 6.0)
    assert path[-1] == (goal, 0.0)
    speeds = [0.0, *(velocity for _, velocity in path[:-2])]
    assert max(map(abs, speeds)) <= 0.4
    assert max(abs(b - a) for a, b in pairwise(speeds)) <= 2.0 * 2.0 * DT + 1e-9  # the last step may take two at once
    assert all(min(0.0, goal) <= position <= max(0.0, goal) for position, _ in path)


def test_goal_beyond_the_limit_is_limited() -> None:
    motion = SetpointGenerator(JOINT, 0.0)
    motion.target = Target(ControlMode.POSITION, 9.0)
    assert run(motion, 5.0)[-1] == (1.0, 0.0)


def test_velocity_ends_at_the_limit() -> None:
    motion = SetpointGenerator(JOINT, 0.0)
    motion.target = Target(ControlMode.VELOCITY, -0.3)
    assert run(motion, 1.0)[-1][1] == pytest.approx(-0.3)
    assert run(motion, 10.0)[-1] == (-2.0, 0.0)


def test_velocity_is_limited() -> None:
    motion = SetpointGenerator(JOINT, -2.0)
    motion.target = Target(ControlMode.VELOCITY, 7.0)
    assert max(velocity for _, velocity in run(motion, 2.0)) == pytest.approx(0.5)


def test_setpoint_reverses_when_the_goal_changes() -> None:
    motion = SetpointGenerator(JOINT, 0.0)
    motion.target = Target(ControlMode.POSITION, 1.0)
    run(motion, 1.0)
    motion.target = Target(ControlMode.POSITION, -1.0)
    assert run(motion, 6.0)[-1] == (-1.0, 0.0)


def test_setpoint_stands_in_effort_mode() -> None:
    motion = SetpointGenerator(JOINT, 0.3)
    motion.target = Target(ControlMode.EFFORT, 5.0)
    assert run(motion, 0.1)[-1] == (0.3, 0.0)


def test_deceleration_is_respected() -> None:
    motion = SetpointGenerator(JOINT, 0.0)
    motion.target = Target(ControlMode.POSITION, 0.9, acceleration=4.0, deceleration=0.25)
    path = run(motion, 9.0)
    assert path[-1] == (0.9, 0.0)
    fastest = max(range(len(path)), key=lambda step: path[step][1])
    assert fastest * DT < 0.2
    assert next(step for step, (position, _) in enumerate(path) if position == 0.9) * DT > 2.0
