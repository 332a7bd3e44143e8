"""What every backend promises of joints."""

import pytest

from jauspy.platform.contract import Robot
from jauspy.platform.joints import ControlMode, JointGroup, Target

POSE = (0.4, 1.2, -0.9, 0.3, -0.5)


@pytest.fixture
def arm(robot: Robot) -> JointGroup:
    return robot.groups["arm"]


def test_joints_are_named_base_to_tip(arm: JointGroup) -> None:
    assert [joint.child for joint in arm.joints] == [f"arm_link_{number}" for number in range(1, 6)]
    assert [joint.child for joint in arm.chain][-2:] == ["gripper_link", "tool_link"]


def test_holds_its_position_at_first(robot: Robot, arm: JointGroup) -> None:
    before = arm.state().positions
    robot.advance(2.0)
    assert arm.state().positions == pytest.approx(before, abs=0.002)


def test_position_is_reached_and_held(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.POSITION, value) for value in POSE])
    robot.advance(6.0)
    assert arm.state().positions == pytest.approx(POSE, abs=0.002)
    assert arm.state().velocities == pytest.approx((0.0,) * 5, abs=0.01)


def test_speed_limit_of_a_target_is_respected(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.POSITION, 1.0, speed=0.2), *[None] * 4])
    robot.advance(2.0)
    assert arm.state().positions[0] == pytest.approx(0.4, abs=0.05)
    assert arm.state().velocities[0] == pytest.approx(0.2, abs=0.02)


def test_velocity_is_held(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.VELOCITY, -0.3), *[None] * 4])
    robot.advance(1.0)
    assert arm.state().velocities[0] == pytest.approx(-0.3, abs=0.01)
    robot.advance(2.0)
    assert arm.state().positions[0] == pytest.approx(-0.9, abs=0.06)


def test_hold_stops(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.VELOCITY, 0.5), *[None] * 4])
    robot.advance(1.0)
    arm.hold()
    robot.advance(0.5)
    before = arm.state().positions
    robot.advance(1.0)
    assert arm.state().positions == pytest.approx(before, abs=0.003)


def test_effort_moves_until_it_is_zero(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.EFFORT, 6.0), *[None] * 4])
    robot.advance(0.2)
    assert arm.state().efforts[0] == 6.0
    assert arm.state().velocities[0] > 0.05
    assert arm.state().positions[0] > 0.01


def test_effort_is_limited(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.EFFORT, 1e9), *[None] * 4])
    robot.advance(0.004)
    assert arm.state().efforts[0] == arm.joints[0].effort


def test_switching_from_effort_to_position_moves_to_the_target(robot: Robot, arm: JointGroup) -> None:
    arm.command([Target(ControlMode.EFFORT, -6.0), *[None] * 4])
    robot.advance(0.5)
    arm.command([Target(ControlMode.POSITION, 0.0), *[None] * 4])
    robot.advance(3.0)
    assert arm.state().positions[0] == pytest.approx(0.0, abs=0.003)


def test_the_gripper_opens_and_closes(robot: Robot) -> None:
    gripper = robot.groups["gripper"]
    for opening in (0.05, 0.0, 0.02):
        gripper.command([Target(ControlMode.POSITION, opening)])
        robot.advance(2.0)
        assert gripper.state().positions == pytest.approx((opening,), abs=0.001)
