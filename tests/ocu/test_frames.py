"""The frames of a running robot, read over JAUS."""

from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.errors import ConfigError
from jauspy.messages.manipulator import JointVelocityRec, SetJointVelocity
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.modules.description import robot_model
from jauspy.modules.robot import RobotRunner
from jauspy.modules.robots import load
from jauspy.ocu import OCU, Robot
from jauspy.ocu.frames import RobotFrames
from jauspy.platform.transforms import FrameTree
from jauspy.platform.vectors import Transform

MODEL = robot_model(load("inc1"))
RATE = JointVelocityRec.JointVelocity(JointVelocityRec.JointVelocityChoice(1), 0.2)


def has_moved(robot: RobotRunner) -> bool:
    """So far that a frame that did not follow shows."""
    seen = robot.snapshot
    return seen is not None and abs(seen.pose.yaw) > 0.2 and abs(seen.joints["arm"].positions[0]) > 0.1


def stands(robot: RobotRunner) -> bool:
    """Neither the chassis nor a joint moves any more."""
    seen = robot.snapshot
    return seen is not None and not any(
        map(abs, (seen.twist.vx, seen.twist.wz, *(v for group in seen.joints.values() for v in group.velocities)))
    )


async def drive_and_reach(robot: RobotRunner, found: Robot) -> None:
    """Turn on the spot, and move all joints of the arm."""
    driver = found.service("mobility:PrimitiveDriver")
    arm = found.service("ManipulatorJointVelocityDriver")
    async with driver.control(authority=200), arm.control(authority=200):
        await driver.resume()
        await arm.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=30.0, propulsive_rotational_effort_z=40.0))
        await arm.send(SetJointVelocity([JointVelocityRec(joint_velocity=RATE)] * 5))
        async with asyncio.timeout(20.0):
            while not has_moved(robot):
                await asyncio.sleep(0.02)
    async with asyncio.timeout(20.0):
        while not stands(robot):
            await asyncio.sleep(0.02)


async def test_all_frames_are_where_they_really_are(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    await drive_and_reach(robot, found)
    reader = RobotFrames(found, MODEL)
    frames = await reader.look()
    seen = robot.snapshot
    assert seen is not None
    positions: dict[str, float] = {}
    for name, group in MODEL.groups.items():
        positions |= zip(group.joints, seen.joints[name].positions, strict=True)
    for link, pose in FrameTree(MODEL.description).poses(positions).items():
        expected = Transform.of(seen.pose) @ pose
        # as exact as fields of pose and positions are on the wire
        assert math.dist(frames.pose(link, "local").position, expected.position) < 1e-3, link
        assert frames.pose(link, "local").rotation[0] == pytest.approx(expected.rotation[0], abs=2e-3), link
    assert set(reader.assumed) & {"base_link_to_arm_link_1", "arm_link_4_to_arm_link_5"} == set()


async def test_a_robot_that_tells_no_pose(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    (without,) = [each for each in found.components if each.id.component == 104]
    node = type(found.nodes[0])(1, "", 0, (without,))
    blind = Robot(found._link, type(found.info)(101, "blind", 0, (node,)))
    with pytest.raises(ConfigError, match="does not offer mobility:LocalPoseSensor"):
        await RobotFrames(blind, MODEL).look()
