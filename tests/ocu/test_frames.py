"""The frames of a running robot, read over JAUS."""

from __future__ import annotations

import math
from contextlib import AsyncExitStack

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.messages.manipulator import (
    JointPositionRec,
    JointVelocityRec,
    SetEndEffectorEffort,
    SetJointPositions,
    SetJointVelocity,
    SetPanTiltJointPositions,
)
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu import OCU, Robot
from jauspy.ocu.frames import RobotFrames
from jauspy.robot.robot_files import load, robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.testing import until

CONFIG = load("inc1")
MODEL = robot_model(CONFIG)
RATE = JointVelocityRec.JointVelocity(JointVelocityRec.JointVelocityChoice(1), 0.2)
GOAL = JointPositionRec.JointPosition(JointPositionRec.JointPositionChoice(1), 1.5)
LEAST = 0.01
"""Radians or metres that each joint has to move, so that a frame that did not follow shows."""


def moved(robot: RobotRunner) -> bool:
    """The chassis has turned, and every joint is somewhere else than at the start."""
    seen = robot.snapshot
    if seen is None or abs(seen.pose.yaw) < 0.2:
        return False
    rows = [zip(seen.joints[name].positions, group.start, strict=True) for name, group in MODEL.groups.items()]
    return all(abs(now - start) > LEAST for row in rows for now, start in row)


def stands(robot: RobotRunner) -> bool:
    """Neither the chassis nor a joint moves any more."""
    seen = robot.snapshot
    return seen is not None and not any(
        map(abs, (seen.twist.vx, seen.twist.wz, *(v for group in seen.joints.values() for v in group.velocities)))
    )


async def move_everything(robot: RobotRunner, found: Robot) -> None:
    """Turn on the spot, and move all joints; then everything stands still."""
    driver = found.service("mobility:PrimitiveDriver")
    arm = found.service("ManipulatorJointVelocityDriver")
    gripper = found.service("PrimitiveEndEffector")
    flippers = found.component(103).service("ManipulatorJointPositionDriver")
    camera = found.service("PanTiltJointPositionDriver")
    async with AsyncExitStack() as stack:
        for each in (driver, arm, gripper, flippers, camera):
            await stack.enter_async_context(each.control(authority=200))
            await each.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=30.0, propulsive_rotational_effort_z=40.0))
        await arm.send(SetJointVelocity([JointVelocityRec(joint_velocity=RATE)] * 5))
        await gripper.send(SetEndEffectorEffort(-20.0))
        await flippers.send(SetJointPositions([JointPositionRec(joint_position=GOAL)]))
        await camera.send(SetPanTiltJointPositions(0.9, 0.4))
        await until(lambda: moved(robot))
    await until(lambda: stands(robot))


async def test_frames_match_the_simulated_robot(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    await move_everything(robot, found)
    reader = RobotFrames(found, MODEL, CONFIG.movers)
    frames = await reader.read()
    assert reader.assumed == []
    seen = robot.snapshot
    assert seen is not None
    positions: dict[str, float] = {}
    for name, group in MODEL.groups.items():
        positions |= zip(group.joints, seen.joints[name].positions, strict=True)
    for link, pose in FrameTree(MODEL.description).poses(positions).items():
        expected = Transform.from_pose(seen.pose) @ pose
        # as exact as fields of pose and positions are on the wire
        assert math.dist(frames.pose(link, "local").position, expected.position) < 1e-3, link
        for row, wanted in zip(frames.pose(link, "local").rotation, expected.rotation, strict=True):
            assert row == pytest.approx(wanted, abs=2e-3), link


async def test_unreported_joints_are_assumed_at_their_start(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    nameless = RobotFrames(found, MODEL)
    frames = await nameless.read()
    pan, tilt = MODEL.groups["pan_tilt"].joints
    assert set(nameless.assumed) == {"gripper_link_to_left_finger", pan, tilt}, "only their component could tell"
    assert nameless.assumed_between("chassis_camera_link", "local") == [pan, tilt]
    assert nameless.assumed_between("chassis_camera_link", "tilt_link") == []
    assert nameless.assumed_between("right_finger", "gripper_link") == ["gripper_link_to_left_finger"]
    assert nameless.assumed_between("tool_link", "flippers") == [], "arm and flippers name their joints"
    left, right = (frames.pose(f"{side}_finger", "gripper_link").position[1] for side in ("left", "right"))
    assert (left, right) == pytest.approx((0.03, -0.03))


async def test_robot_that_differs_from_its_description_is_an_error(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    with pytest.raises(
        ConfigError, match=r"101\.1\.105 reports 1 joints, and the description has 2 there: base_link_to_pan"
    ):
        await RobotFrames(found, MODEL, {105: "pan_tilt"}).read()


async def test_robot_without_pose_sensor_is_an_error(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    (without,) = [each for each in found.components if each.id.component == 104]
    node = type(found.nodes[0])(1, "", 0, (without,))
    blind = Robot(found._connection, type(found.info)(101, "blind", 0, (node,)))
    with pytest.raises(ConfigError, match="does not offer mobility:LocalPoseSensor"):
        await RobotFrames(blind, MODEL).read()
