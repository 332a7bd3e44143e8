"""Joints that another thread moves."""

import pytest

from jauspy.modules.description import robot_model
from jauspy.modules.robots import load
from jauspy.modules.shared import Order, SharedJoints
from jauspy.modules.snapshot import look
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.kinematic import KinematicBackend, KinematicRobot

LEFT, RIGHT = Target(ControlMode.VELOCITY, 0.4), Target(ControlMode.VELOCITY, -0.4)


class Thread:
    """Does in its own time what was ordered."""

    def __init__(self) -> None:
        self.robot: KinematicRobot = KinematicBackend().open(robot_model(load("inc1")), "empty")
        self.orders: dict[str, Order] = {}
        self.arm = SharedJoints("arm", self.robot.groups["arm"], self.orders.__setitem__, lambda: look(self.robot))

    def step(self, seconds: float = 0.5) -> tuple[float, ...]:
        for order in self.orders.values():
            order(self.robot)
        self.orders.clear()
        self.robot.advance(seconds)
        return self.arm.state().velocities


@pytest.fixture
def thread() -> Thread:
    return Thread()


def test_commands_act_with_the_next_step(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    assert thread.arm.state().velocities[0] == 0.0
    assert thread.step()[0] == pytest.approx(0.4)


def test_commands_for_different_joints_all_count(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    thread.arm.command([None, None, RIGHT, None, None])
    thread.arm.command([None, None, None, RIGHT, None])
    assert thread.step() == pytest.approx((0.4, 0.0, -0.4, -0.4, 0.0))


def test_the_later_command_for_a_joint_counts(thread: Thread) -> None:
    thread.arm.command([LEFT, *[None] * 4])
    thread.arm.command([RIGHT, *[None] * 4])
    assert thread.step()[0] == pytest.approx(-0.4)


def test_hold_stops_what_was_commanded_before_it_and_nothing_after(thread: Thread) -> None:
    thread.arm.command([LEFT, LEFT, *[None] * 3])
    thread.step()
    thread.arm.command([None, None, LEFT, None, None])
    thread.arm.hold()
    thread.arm.command([RIGHT, *[None] * 4])
    assert thread.step() == pytest.approx((-0.4, 0.0, 0.0, 0.0, 0.0))
