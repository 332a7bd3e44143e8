"""Parts that are killed and come back, or whose work others take over, while the rest goes on."""

from __future__ import annotations

import asyncio
import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from jauspy.messages.core import QueryStatus
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.ocu.subscription import Subscription
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LocalTransport

pytestmark = pytest.mark.alone


async def silence(poses: Subscription[Any]) -> None:
    """Until what was under way has arrived and no more comes."""
    received = -1
    while poses.received > received:
        received = poses.received
        await asyncio.sleep(0.3)  # six periods


@pytest.mark.parametrize("connect", ["local:{root}", "udp://127.0.0.1:{port}"], ids=["local", "udp"])
@pytest.mark.slow
async def test_subscription_survives_a_killed_node_manager(
    root: Path, free_port: int, start: Callable[..., subprocess.Popen[str]], connect: str
) -> None:
    node = ("node-manager", "--address", "127.0.0.1", "--port", str(free_port), "--local-root", str(root))
    first = await asyncio.to_thread(start, *node, ready="ready")
    robot = RobotRunner(load("inc1"), lambda own: LocalTransport(own, root), backend="kinematic", world="empty")
    async with robot, OCU(connect=connect.format(root=root, port=free_port)) as ocu:
        sensor = (await ocu.discover(101)).service("LocalPoseSensor")
        query = QueryLocalPose(presence_vector=1)
        async with sensor.subscribe(query, expects=ReportLocalPose, rate=20.0, silence=60.0) as poses:
            await poses.get()
            first.send_signal(signal.SIGKILL)
            await asyncio.to_thread(first.wait)
            await silence(poses)
            await asyncio.to_thread(start, *node, ready="ready")
            before = poses.received
            async with asyncio.timeout(60):
                while poses.received < before + 10:
                    await poses.get()
        await sensor.query(QueryStatus())


@pytest.mark.slow
async def test_robot_survives_the_owner_of_the_node_manager(
    root: Path, free_port: int, start: Callable[..., subprocess.Popen[str]]
) -> None:
    second_robot = root / "second.toml"
    second_robot.write_text("extends = 'inc1'\nsubsystem = 102\n")
    options = ("--backend", "kinematic", "--port", str(free_port), "--local-root", str(root))
    first = await asyncio.to_thread(start, "up", "inc1", *options, ready="stop it")
    await asyncio.to_thread(start, "up", str(second_robot), *options, ready="was running")

    first.send_signal(signal.SIGTERM)
    await asyncio.to_thread(first.wait)

    async with asyncio.timeout(60), OCU(connect=f"udp://127.0.0.1:{free_port}") as ocu:
        assert (await ocu.discover(102, timeout=50)).id == 102
