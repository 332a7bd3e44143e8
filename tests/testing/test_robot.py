"""The fixtures `robot` and `ocu` of our own plugin: in memory on virtual time, and on a node manager."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.messages.core import ReportStatus
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort

FULL = SetWrenchEffort(propulsive_linear_effort_x=60.0)


async def drive(robot, ocu, metres: float) -> None:
    async with asyncio.timeout(120):
        await _drive(robot, ocu, metres)


async def _drive(robot, ocu, metres: float) -> None:
    found = await ocu.discover(subsystem=101)
    driver = found.service("PrimitiveDriver")
    async with driver.control():
        await driver.resume()
        async with driver.streaming(rate=10.0) as command:
            await command.send(FULL)
            async for pose in found.service("LocalPoseSensor").subscribe(QueryLocalPose(0x1FF), rate=10.0):
                if pose.x >= metres:
                    break
    assert await driver.status() == ReportStatus.Status.STANDBY


@pytest.mark.slow
async def test_it_drives_on_virtual_time(virtual_network, robot, ocu):
    virtual_network.loss = 0.1
    await drive(robot, ocu, 10.0)
    assert robot.snapshot.pose.x == pytest.approx(10.0, abs=0.5)
    assert 10.0 < virtual_network.clock.elapsed < 30.0


@pytest.mark.slow
async def test_it_drives_on_a_node_manager(node_manager, robot, ocu):
    await drive(robot, ocu, 0.2)
    assert robot.snapshot.pose.x > 0.19
