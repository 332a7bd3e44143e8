"""Joints that another thread moves."""

import pytest

from jauspy.backends.kinematic import KinematicBackend
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.realtime import RealTime
from jauspy.robot.robot_files import load, robot_model

LEFT, RIGHT = Target(ControlMode.VELOCITY, 0.4), Target(ControlMode.VELOCITY, -0.4)


class Thread:
    """A robot that moves when the test says so."""

    def __init__(self) -> None:
        self.robot = RealTime(KinematicBackend().open(robot_model(load("inc1")), "empty"), step=0.5)
        self.arm = self.robot.groups["arm"]

    def step(self) -> tuple[float, ...]:
        self.robot._make_step()
        return self.arm.state().velocities


@pytest.fixture
def thread() -> Thread:
    return Thread()


def test_commands_take_effect_with_the_next_step(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    assert thread.arm.state().velocities[0] == 0.0
    assert thread.step()[0] == pytest.approx(0.4)


def test_commands_for_different_joints_are_merged(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    thread.arm.command([None, None, RIGHT, None, None])
    thread.arm.command([None, None, None, RIGHT, None])
    assert thread.step() == pytest.approx((0.4, 0.0, -0.4, -0.4, 0.0))


def test_later_command_for_a_joint_replaces_the_earlier_one(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    thread.arm.command([RIGHT, *[None] * 4])
    assert thread.step()[0] == pytest.approx(-0.4)


def test_hold_cancels_earlier_commands_only(thread: Thread) -> None:
    thread.arm.command([LEFT, LEFT, *[None] * 3])
    thread.step()
    thread.arm.command([None, None, LEFT, None, None])
    thread.arm.hold()
    thread.arm.command([RIGHT, *[None] * 4])
    assert thread.step() == pytest.approx((-0.4, 0.0, 0.0, 0.0, 0.0))
