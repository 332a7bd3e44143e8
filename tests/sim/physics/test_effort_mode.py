"""Efforts of the simulated joints: gravity is compensated, speed is bounded, and ends are approached softly."""

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))
OUTSTRETCHED = {"arm": (0.0, 0.15, -0.1, 0.0, 0.0), "flippers": (0.8,), "gripper": (0.025,)}
JOINTS = [(group, number) for group, start in OUTSTRETCHED.items() for number in range(len(start))]
CASES = [
    pytest.param(group, number, share, marks=[] if (group, number, share) == ("arm", 1, -0.1) else [pytest.mark.slow])
    for group, number in JOINTS
    for share in (0.1, -0.1, 0.5, -0.5, 1.0, -1.0)
]


def outstretched(group: str) -> SimulatedRobot:
    robot = SimulatedRobot.open(INC1, "empty")
    data = robot.data
    for joint, position in zip(robot.groups[group].joints, OUTSTRETCHED[group], strict=True):
        for name in (joint.name, joint.name.replace("left_finger", "right_finger")):
            data.joint(f"inc1/{name}").qpos[0] = position
    robot.groups[group].command([Target(ControlMode.VELOCITY, 0.0) for _ in OUTSTRETCHED[group]])
    robot.groups[group].command([Target(ControlMode.POSITION, value) for value in OUTSTRETCHED[group]])
    robot.advance(1.5)
    return robot


def push(robot: SimulatedRobot, group: str, number: int, share: float) -> None:
    joints = robot.groups[group].joints
    robot.groups[group].command(
        [
            Target(ControlMode.EFFORT, share * joint.effort if at == number else 0.0, compensated=True)
            for at, joint in enumerate(joints)
        ]
    )


@pytest.mark.parametrize(("group", "number", "share"), CASES)
def test_an_effort_moves_in_its_direction_with_its_share_of_the_speed(group: str, number: int, share: float) -> None:
    robot = outstretched(group)
    joints, joint = robot.groups[group], robot.groups[group].joints[number]
    before, fastest = joints.state().positions, 0.0
    push(robot, group, number, share)
    for _ in range(150):
        robot.advance(0.01)
        state = joints.state()
        velocity = math.copysign(1.0, share) * state.velocities[number]
        fastest = max(fastest, velocity)
        assert velocity > -0.15 * joint.velocity, "it never falls back"
        assert joint.lower - 0.005 <= state.positions[number] <= joint.upper + 0.005
    limit = abs(share) * joint.velocity
    assert 0.8 * limit < fastest < 1.2 * limit
    assert math.copysign(1.0, share) * (state.positions[number] - before[number]) > 0.005


@pytest.mark.parametrize(
    "group", ["arm", *(pytest.param(each, marks=pytest.mark.slow) for each in ("flippers", "gripper"))]
)
def test_zero_efforts_hold_however_often_they_are_repeated(group: str) -> None:
    robot = outstretched(group)
    before = robot.groups[group].state().positions
    for _ in range(20):
        push(robot, group, 0, 0.0)
        robot.advance(0.1)
    assert robot.groups[group].state().positions == pytest.approx(before, abs=0.002)


@pytest.mark.slow
def test_zero_effort_ends_a_motion() -> None:
    robot = outstretched("arm")
    push(robot, "arm", 1, 1.0)
    robot.advance(0.8)
    push(robot, "arm", 1, 0.0)
    robot.advance(0.2)
    before = robot.groups["arm"].state().positions
    robot.advance(1.0)
    assert robot.groups["arm"].state().positions == pytest.approx(before, abs=0.006)


@pytest.mark.slow
def test_efforts_without_compensation_keep_to_the_speed_limits() -> None:
    robot = outstretched("arm")
    joints = robot.groups["arm"].joints
    robot.groups["arm"].command(
        [Target(ControlMode.EFFORT, joint.effort if not at else 0.0) for at, joint in enumerate(joints)]
    )
    for _ in range(150):
        robot.advance(0.01)
        for joint, velocity in zip(joints, robot.groups["arm"].state().velocities, strict=True):
            assert abs(velocity) < 1.3 * joint.velocity, joint.name


@pytest.mark.slow
@pytest.mark.parametrize(
    "share", [-0.2, pytest.param(-0.5, marks=pytest.mark.slow), pytest.param(-1.0, marks=pytest.mark.slow)]
)
def test_the_gripper_holds_a_block_with_the_commanded_force(share: float) -> None:
    robot = outstretched("gripper")
    group = robot.groups["gripper"]
    (joint,) = group.joints
    between = [robot.model.joint(f"inc1/gripper_link_to_{side}_finger").id for side in ("left", "right")]
    for each in between:  # as if there were a block of 30 mm between the fingers
        robot.model.jnt_range[each][0] = 0.015
    push(robot, "gripper", 0, share)
    robot.advance(1.5)
    for _ in range(10):
        robot.advance(0.1)
        state = group.state()
        assert state.positions[0] == pytest.approx(0.015, abs=0.001)
        assert state.efforts[0] == pytest.approx(share * joint.effort, rel=0.03)
