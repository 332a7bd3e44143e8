"""Two robots on two hosts, and one OCU that finds both by multicast and drives both."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Callable
from contextlib import AsyncExitStack
from functools import partial
from pathlib import Path

import pytest

from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetWrenchEffort
from jauspy.node import NodeConfig, NodeManager
from jauspy.ocu import OCU
from jauspy.ocu.service import ServiceClient
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LocalTransport

pytestmark = pytest.mark.alone

EFFORTS = {101: 60.0, 102: -60.0}
"""By subsystem, in percent; opposite ones, so that no robot can be taken for the other."""
DISTANCE = 0.1  # metres


async def drive_both(ocu: OCU) -> None:
    """Control both at once, and see each go its own way."""
    robots = [await ocu.discover(subsystem) for subsystem in EFFORTS]
    async with asyncio.timeout(20):
        while {each.id for each in await ocu.discover_all(timeout=0.5)} != set(EFFORTS):
            pass
    async with AsyncExitStack() as stack:
        for robot in robots:
            driver = robot.service("PrimitiveDriver")
            await stack.enter_async_context(driver.control(authority=200))
            await driver.resume()
        for robot in robots:
            effort = SetWrenchEffort(propulsive_linear_effort_x=EFFORTS[robot.id])
            await robot.service("PrimitiveDriver").send(effort)
        for robot in robots:
            direction = EFFORTS[robot.id] / 60.0
            sensor = robot.service("LocalPoseSensor")
            async with asyncio.timeout(20):
                while await x_of(sensor) * direction < DISTANCE:
                    await asyncio.sleep(0.05)


async def x_of(sensor: ServiceClient) -> float:
    report = await sensor.query(QueryLocalPose(presence_vector=1), expects=ReportLocalPose)
    assert report.x is not None
    return float(report.x)


@pytest.mark.slow
async def test_two_robots_on_loopback_addresses(root: Path, free_port: int) -> None:
    async with AsyncExitStack() as stack:
        for number, subsystem in enumerate(EFFORTS, 1):
            folder = root / str(subsystem)
            config = NodeConfig(address=f"127.0.0.{number}", port=free_port, local_root=folder)
            node = await stack.enter_async_context(NodeManager(config))
            if node.counters["multicast.not_joined"]:
                pytest.skip("this kernel does not multicast on its loopback interface")
            robot = load("inc1").model_copy(update={"subsystem": subsystem})
            runner = RobotRunner(robot, partial(LocalTransport, root=folder), backend="kinematic", world="empty")
            await stack.enter_async_context(runner)
        await drive_both(await stack.enter_async_context(OCU(connect=f"local:{root / '101'}")))


@pytest.mark.slow
async def test_two_robots_on_two_hosts(cable: tuple[str, str], root: Path, start: Callable[..., object]) -> None:
    """Each in a network namespace with `jauspy up`; the OCU is on the first, by its local socket."""
    for namespace, subsystem in zip(cable, EFFORTS, strict=True):
        robot = root / f"{subsystem}.toml"
        robot.write_text(f"extends = 'inc1'\nsubsystem = {subsystem}\n")
        options = ("--backend", "kinematic", "--local-root", str(root / str(subsystem)))
        start("up", str(robot), *options, ready="stop it", within=(str(shutil.which("ip")), "netns", "exec", namespace))
    async with OCU(connect=f"local:{root / '101'}") as ocu:
        await drive_both(ocu)
