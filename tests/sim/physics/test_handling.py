"""What the simulated inc1 does with its arm, gripper and flippers."""

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))
UPPER, FORE, HAND = 0.40, 0.34, 0.28
SHOULDER = (0.12, 0.28)


def reach(forward: float, height: float, turn: float = 0.0) -> list[Target]:
    """The arm's joints with the tool level, so far in front of the base and so high, in metres."""
    x, z = forward - SHOULDER[0] - HAND, height - SHOULDER[1]
    elbow = -math.acos((x * x + z * z - UPPER**2 - FORE**2) / (2.0 * UPPER * FORE))
    shoulder = math.atan2(z, x) + math.atan2(FORE * math.sin(-elbow), UPPER + FORE * math.cos(elbow))
    joints = (turn, shoulder, elbow, -shoulder - elbow, 0.0)
    return [Target(ControlMode.POSITION, value) for value in joints]


def put(robot: SimulatedRobot, x: float, y: float, yaw: float) -> None:
    """Stand the robot somewhere else on the floor."""
    address = robot._model.joint("inc1/base").qposadr[0]
    robot._data.qpos[address : address + 7] = (x, y, 0.0, math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))


@pytest.mark.slow
def test_grasps_a_can_of_a_kilogram_and_lifts_it() -> None:
    robot = SimulatedRobot.open(INC1, "yard")
    put(robot, 2.0, 0.0, math.pi / 2)
    arm, gripper, can = robot.groups["arm"], robot.groups["gripper"], robot._data.body("can")

    def on_the_hand() -> float:
        """What pulls the wrist down, N; the tool is level."""
        return -robot.force_torque["wrist"].wrench.force[2]

    gripper.command([Target(ControlMode.POSITION, 0.05)])
    for forward, height, seconds in ((0.6, 0.7, 5.0), (0.72, 0.5, 2.5), (0.78, 0.42, 2.0), (0.9, 0.41, 2.0)):
        arm.command(reach(forward, height))
        robot.advance(seconds)
    empty = on_the_hand()
    gripper.command([Target(ControlMode.POSITION, 0.0)])
    robot.advance(1.0)
    assert gripper.state().positions[0] == pytest.approx(0.025, abs=0.002)
    arm.command(reach(0.85, 0.53))
    robot.advance(3.0)
    lifted = can.xpos[2]
    assert lifted > 0.51
    robot.advance(5.0)
    assert can.xpos[2] == pytest.approx(lifted, abs=0.005)
    assert on_the_hand() - empty == pytest.approx(9.81, rel=0.05)


@pytest.mark.slow
def test_climbs_the_stairs_of_the_yard() -> None:
    robot = SimulatedRobot.open(INC1, "yard")
    put(robot, 0.2, -3.2, math.pi)
    robot.groups["flippers"].command([Target(ControlMode.POSITION, -0.15)])
    robot.advance(1.5)
    robot.drive.set_effort(0.35, 0.0)
    while (pose := robot.drive.pose()).x > -2.0:
        assert math.cos(pose.roll) * math.cos(pose.pitch) > math.cos(0.85)
        assert robot.time < 20.0
        robot.advance(0.1)
    assert pose.z == pytest.approx(0.72, abs=0.01)


@pytest.mark.slow
def test_the_same_commands_give_the_same_trajectory() -> None:
    ends = []
    for _ in range(2):
        robot = SimulatedRobot.open(INC1, "yard")
        robot.drive.set_effort(0.6, 0.1)
        robot.groups["arm"].command(reach(0.7, 0.5))
        robot.advance(2.0)
        ends.append((robot.drive.pose(), robot.groups["arm"].state()))
    assert ends[0] == ends[1]
