"""Loads beyond what the joints of the simulated arm can carry: it stops, says so, and recovers."""

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))
SHOULDER = "arm_link_1_to_arm_link_2"
OUTSTRETCHED = (0.0, 0.6, -0.3, 0.0, 0.0)


def outstretched() -> SimulatedRobot:
    robot = SimulatedRobot.open(INC1, "empty")
    arm = robot.groups["arm"]
    for joint, position in zip(arm.joints, OUTSTRETCHED, strict=True):
        robot.data.joint(f"inc1/{joint.name}").qpos[0] = position
    arm.command([Target(ControlMode.VELOCITY, 0.0) for _ in OUTSTRETCHED])
    arm.command([Target(ControlMode.POSITION, value) for value in OUTSTRETCHED])
    robot.advance(1.0)
    return robot


def hang(robot: SimulatedRobot, mass: float) -> None:
    """Hang a weight on the hand: kg."""
    robot.data.xfrc_applied[robot.model.body("inc1/gripper_link").id][2] = -9.81 * mass


def fastest(robot: SimulatedRobot, seconds: float) -> float:
    """The greatest speed of the shoulder meanwhile, rad/s."""
    found = 0.0
    for _ in range(round(seconds / 0.01)):
        robot.advance(0.01)
        found = max(found, abs(robot.groups["arm"].state().velocities[1]))
    return found


@pytest.mark.slow
def test_too_heavy_a_load_is_held_and_reported() -> None:
    robot = outstretched()
    arm = robot.groups["arm"]
    before = arm.state().positions[1]
    hang(robot, 12.0)
    assert fastest(robot, 1.0) < 0.8, "it does not fall"
    state = arm.state()
    assert abs(state.positions[1] - before) < 0.1
    assert state.overloads[SHOULDER] > 110.0
    assert state.efforts[1] == pytest.approx(state.overloads[SHOULDER], abs=1.0)
    at = state.positions
    robot.advance(3.0)
    assert arm.state().positions == pytest.approx(at, abs=0.01), "it stays"


@pytest.mark.slow
def test_a_command_against_the_load_is_not_wound_up() -> None:
    robot = outstretched()
    arm = robot.groups["arm"]
    hang(robot, 12.0)
    robot.advance(1.0)
    at = arm.state().positions
    arm.command([None, Target(ControlMode.POSITION, 1.5), None, None, None])
    robot.advance(2.0)
    assert arm.state().positions == pytest.approx(at, abs=0.01)
    hang(robot, 0.0)
    assert fastest(robot, 1.0) < 0.1, "it does not jump when the load is gone"
    assert not arm.state().overloads
    arm.command([None, Target(ControlMode.POSITION, 0.8), None, None, None])
    robot.advance(2.0)
    assert arm.state().positions[1] == pytest.approx(0.8, abs=0.01)


@pytest.mark.slow
def test_the_load_can_be_lowered() -> None:
    robot = outstretched()
    arm = robot.groups["arm"]
    hang(robot, 12.0)
    robot.advance(1.0)
    before = arm.state().positions[1]
    speed = 0.0
    for _ in range(20):
        down = [Target(ControlMode.EFFORT, -30.0 if at == 1 else 0.0, compensated=True) for at in range(5)]
        arm.command(down)
        speed = max(speed, fastest(robot, 0.1))
    assert arm.state().positions[1] < before - 0.1
    assert speed < 0.8


@pytest.mark.slow
def test_a_load_that_it_can_carry_is_lifted() -> None:
    robot = outstretched()
    arm = robot.groups["arm"]
    hang(robot, 4.0)
    arm.command([None, Target(ControlMode.POSITION, 1.0), None, None, None])
    robot.advance(3.0)
    assert arm.state().positions[1] == pytest.approx(1.0, abs=0.02)
    assert not arm.state().overloads
    assert math.isfinite(arm.state().efforts[1])
