"""Emergencies during motions that a robot carries out by itself: it stops, and stays where it has stopped."""

from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.errors import JausError
from jauspy.messages.core import ClearEmergency, SetEmergency
from jauspy.ocu import Robot
from jauspy.testing import VirtualNetwork

ARM, CHASSIS = "101.1.104", "101.1.102"
STANDSTILL = 1e-3
"""Radians or metres that a joint or the chassis may settle in the time that it is watched."""
WATCHED = 3.0
"""Seconds."""


async def joints(robot: Robot) -> list[float]:
    return list((await robot.manipulator(ARM).joints()).positions.values())


async def place(robot: Robot) -> list[float]:
    pose = await robot.pose()
    return [pose.x, pose.y, pose.yaw]


async def moved(robot: Robot, read) -> float:
    """How far it moves while it is watched."""
    before = await read(robot)
    await asyncio.sleep(WATCHED)
    return max(abs(now - then) for now, then in zip(await read(robot), before, strict=True))


@pytest.mark.slow
async def test_emergency_during_a_pose_stops_the_arm_for_good(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.robot(101)
        async with robot.control():
            begin = await joints(robot)
            motion = asyncio.create_task(robot.manipulator(ARM).move_to("reach_low"))
            await asyncio.sleep(1.0)
            under_way = await joints(robot)
            assert math.dist(begin, under_way) > 0.02, "it had begun"
            await ocu.send(ARM, SetEmergency(1), ack=True)
            with pytest.raises(JausError):
                await motion
            await asyncio.sleep(0.3)
            assert await moved(robot, joints) < STANDSTILL
            assert await robot.manipulator(ARM).pose() != "reach_low"
            await ocu.send(ARM, ClearEmergency(1), ack=True)
            assert await moved(robot, joints) < STANDSTILL, "the end of the emergency resumes nothing"


@pytest.mark.slow
async def test_emergency_during_guarded_teleoperation_stops_the_chassis_for_good(
    virtual_network: VirtualNetwork,
) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.robot(101)
        await robot.guards.switch(obstacle=True)
        async with robot.control("drive"):
            before = await place(robot)
            await robot.drive(linear=0.5)
            await asyncio.sleep(1.5)
            assert math.dist(before, await place(robot)) > 0.2, "it drove"
            await ocu.send(CHASSIS, SetEmergency(1), ack=True)
            await asyncio.sleep(0.5)
            assert await moved(robot, place) < STANDSTILL
            await ocu.send(CHASSIS, ClearEmergency(1), ack=True)
            assert await moved(robot, place) < STANDSTILL, "the end of the emergency resumes nothing"
        (guard,) = [guard for guard in await robot.guards.observe() if guard.name == "obstacle"]
        assert guard.enabled
