"""The included worlds: everything rests at the start, and what a robot would push, lift or open moves."""

import dataclasses

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build
from jauspy_sim.robot import SimulatedRobot

BLIND = dataclasses.replace(robot_model(load("inc1")), lidars=(), cameras=())
MADE = ("house", "rubble", "street", "yard")


@pytest.fixture
def opened(request: pytest.FixtureRequest) -> SimulatedRobot:
    return SimulatedRobot.open(BLIND, request.param)


def push(robot: SimulatedRobot, body: str, force: tuple[float, float, float], seconds: float) -> None:
    """Apply a force at the middle of a body."""
    number = robot.model.body(body).id
    robot.data.xfrc_applied[number, :3] = force
    robot.advance(seconds)
    robot.data.xfrc_applied[number] = 0.0


@pytest.mark.slow
@pytest.mark.parametrize("opened", MADE, indirect=True)
def test_everything_rests_where_it_was_put(opened: SimulatedRobot) -> None:
    model, data = opened.model, opened.data
    free = [int(joint) for joint in np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)]
    starts = np.array([model.qpos0[model.jnt_qposadr[joint] :][:3] for joint in free])
    opened.advance(2.0)
    ends = np.array([data.qpos[model.jnt_qposadr[joint] :][:3] for joint in free])
    assert len(free) > 4
    assert np.abs(ends - starts).max() < 0.05, "nothing flies or sinks"
    assert np.abs(data.qvel).max() < 0.05
    pose = opened.drive.pose()
    assert max(abs(pose.roll), abs(pose.pitch)) < 0.01


@pytest.mark.slow
@pytest.mark.parametrize("world", MADE)
def test_the_same_commands_give_the_same_world(world: str) -> None:
    ends = []
    for _ in range(2):
        robot = SimulatedRobot.open(BLIND, world)
        robot.drive.set_effort(0.5, 0.1)
        robot.advance(2.0)
        ends.append(robot.data.qpos.copy())
    assert (ends[0] == ends[1]).all()


@pytest.mark.slow
@pytest.mark.parametrize("opened", ["street"], indirect=True)
def test_things_of_the_street_can_be_lifted_opened_and_tipped(opened: SimulatedRobot) -> None:
    data = opened.data
    push(opened, "rucksack_strap", (0.0, 0.0, 28.0), 0.4)
    assert data.body("rucksack").xpos[2] > 0.15, "by its strap"
    push(opened, "pipe_device", (0.0, 0.0, 15.0), 0.4)
    assert data.body("pipe_device").xpos[2] > 0.2
    door = data.joint("car_door")
    before = float(door.qpos[0])
    push(opened, "car_door", (60.0, 0.0, 0.0), 1.0)
    assert abs(door.qpos[0] - before) > 0.2
    lid = opened.model.body("bin_lid").id  # at the upper edge, as a gripper would push it
    data.xfrc_applied[lid, :3] = (0.0, -80.0, 0.0)
    opened.advance(0.7)
    data.xfrc_applied[lid] = 0.0
    opened.advance(1.0)
    assert abs(data.body("bin").xmat[8]) < 0.5, "it lies"


@pytest.mark.slow
def test_the_joints_of_the_kerb_are_filled() -> None:
    """Through open ones, cameras see the sky below the ground."""
    model = build(BLIND, "street")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    shown, hit = np.array([0, 1, 0, 0, 0, 0], np.uint8), np.zeros(1, np.int32)
    for y in (-9.0, -1.0, 1.0, 6.0):
        for x in (2.075, -5.075):
            far = mujoco.mj_ray(model, data, [x, y, 1.0], [0.0, 0.0, -1.0], shown, True, -1, hit)
            assert 0.9 <= far < 0.93


@pytest.mark.slow
@pytest.mark.parametrize("opened", ["street"], indirect=True)
def test_drives_over_the_kerb(opened: SimulatedRobot) -> None:
    opened.groups["flippers"].command([Target(ControlMode.POSITION, 0.35)])
    opened.advance(1.0)
    opened.drive.set_effort(0.5, 0.0)
    for _ in range(80):
        opened.advance(0.1)
        if opened.drive.pose().x > 2.75:
            break
    opened.drive.stop()
    opened.advance(1.0)
    pose = opened.drive.pose()
    assert pose.z == pytest.approx(0.1, abs=0.01)
    assert max(abs(pose.roll), abs(pose.pitch)) < 0.03


@pytest.mark.slow
@pytest.mark.parametrize("opened", ["house"], indirect=True)
def test_the_door_of_the_house_opens_by_its_handle_only_and_closes_itself(opened: SimulatedRobot) -> None:
    data, model = opened.data, opened.model
    door, handle = data.joint("door"), data.joint("door_handle")
    turn, press = model.joint("door").dofadr[0], model.joint("door_handle").dofadr[0]
    data.qfrc_applied[turn] = 150.0
    opened.advance(1.0)
    assert door.qpos[0] < 0.01, "200 N at its edge do not open it"
    data.qfrc_applied[turn] = 0.0
    opened.advance(0.3)
    data.qfrc_applied[press] = 1.8  # 15 N at the end of the lever
    opened.advance(0.4)
    assert handle.qpos[0] > 0.5
    data.qfrc_applied[turn] = 25.0
    opened.advance(1.0)
    assert door.qpos[0] > 0.6
    data.qfrc_applied[[turn, press]] = 0.0
    opened.advance(3.0)
    assert door.qpos[0] == pytest.approx(0.0, abs=0.01), "its spring closes it"
    data.qfrc_applied[turn] = 150.0
    opened.advance(0.7)
    assert door.qpos[0] < 0.01, "the bolt has caught"
