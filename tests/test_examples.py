"""The programs in examples/ run, each in a process of its own; most need a node manager and a robot."""

from __future__ import annotations

import asyncio
import math
import re
import signal
import sys
from pathlib import Path

import pytest

from jauspy.geometry.poses import Pose
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.messages.ugv import QueryPlatformSpecifications
from jauspy.robot.runner import RobotRunner
from jauspy.testing import LocalNode, until

EXAMPLES = Path(__file__).parents[1] / "examples"


async def run(*arguments: str) -> str:
    """What Python prints, run with these arguments in examples/; it must exit with status 0 and an empty stderr."""
    process = await asyncio.create_subprocess_exec(
        sys.executable, *arguments, cwd=EXAMPLES, stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE
    )
    async with asyncio.timeout(100):
        output, errors = await process.communicate()
    assert (process.returncode, errors.decode()) == (0, "")
    return output.decode()


async def start(name: str, *arguments: str) -> asyncio.subprocess.Process:
    """A component's program, which runs until it is interrupted."""
    return await asyncio.create_subprocess_exec(sys.executable, EXAMPLES / name, *arguments)


async def stop(process: asyncio.subprocess.Process) -> None:
    process.send_signal(signal.SIGINT)
    async with asyncio.timeout(60):  # a busy machine may stand for longer than 20 s
        assert await process.wait() == 0


def numbers(text: str) -> list[float]:
    return [float(each) for each in re.findall(r"-?\d+(?:\.\d+)?", text)]


async def turned(node_manager: LocalNode, robot: RobotRunner, seconds: float = 2.5) -> Pose:
    """Where a robot stands that was turned for some seconds, by default to the back."""
    async with node_manager.ocu("42.1.9") as ocu:
        found = await ocu.robot(101)
        async with found.control("drive"):
            await found.drive(angular=1.0, seconds=seconds)
    assert robot.snapshot is not None
    assert abs(robot.snapshot.pose.yaw) > 0.72 * seconds
    return robot.snapshot.pose


@pytest.mark.slow
async def test_ocu(node_manager: LocalNode) -> None:
    async with node_manager.robot() as robot:
        start = await turned(node_manager, robot, 1.2)
        output = await run("ocu.py", node_manager.local)
        assert numbers(output.splitlines()[-1])[0] >= 2.0
        assert robot.snapshot is not None
        end = robot.snapshot.pose
        assert 2.0 <= math.dist((end.x, end.y), (start.x, start.y)) < 2.6


@pytest.mark.slow
async def test_verbs(node_manager: LocalNode) -> None:
    async with node_manager.robot() as robot:
        output = await run("verbs.py", node_manager.local)
        assert robot.snapshot is not None
        assert robot.snapshot.pose.y > 0.3
    assert "elbow -1.2" in output


@pytest.mark.slow
async def test_scans(node_manager: LocalNode) -> None:
    async with node_manager.robot():
        lines = (await run("scans.py", node_manager.local)).splitlines()
    assert len(lines) == 10
    assert all("nothing, 0 of 360 rays with an echo" in line for line in lines), "the kinematic robot sees nothing"


@pytest.mark.slow
async def test_sync_ocu(node_manager: LocalNode) -> None:
    async with node_manager.robot():
        output = await run("sync_ocu.py", node_manager.local)
    assert numbers(output.splitlines()[-1])[0] >= 90.0


@pytest.mark.slow
async def test_waypoints(node_manager: LocalNode) -> None:
    async with node_manager.robot() as robot:
        start = await turned(node_manager, robot)
        output = await run("waypoints.py", node_manager.local)
        assert robot.snapshot is not None
        assert math.dist((robot.snapshot.pose.x, robot.snapshot.pose.y), (start.x, start.y)) < 0.6
    first, second, back = (numbers(line)[1:] for line in output.splitlines()[:3])
    ahead = (start.x + 2.0 * math.cos(start.yaw), -start.y - 2.0 * math.sin(start.yaw))  # y is right in JAUS
    assert first == pytest.approx(ahead, abs=0.3)
    assert math.dist(second, first) == pytest.approx(1.0, abs=0.1)
    assert back == pytest.approx((start.x, -start.y), abs=0.3)
    assert output.splitlines()[-1] == "arrived"
    assert "heading for waypoint 2" in output


@pytest.mark.slow
async def test_two_robots(node_manager: LocalNode) -> None:
    async with node_manager.robot(), node_manager.robot("inc1_pprm"):
        lines = (await run("two_robots.py", node_manager.local)).splitlines()
    assert len(lines) == 2
    assert all(numbers(line)[1] > 0.5 for line in lines)


@pytest.mark.slow
async def test_video_opencv(node_manager: LocalNode) -> None:
    pytest.importorskip("cv2", reason="needs the extra 'video'")
    async with node_manager.robot():
        lines = (await run("video_opencv.py", node_manager.local)).splitlines()
    assert len(lines) >= 30


@pytest.mark.slow
async def test_component(node_manager: LocalNode) -> None:
    component = await start("component.py", node_manager.local)
    async with node_manager.ocu("42.1.1") as ocu:
        report = await ocu.query("101.1.121", QueryPlatformSpecifications(), retries=40)
    assert report.platform_spec.vehicle_weight == pytest.approx(38.0, abs=0.1)
    await stop(component)


@pytest.mark.slow
async def test_backend(node_manager: LocalNode) -> None:
    program = await start("backend.py", node_manager.local)
    await until(lambda: node_manager.components, within=60.0)
    async with node_manager.ocu("42.1.1") as ocu:
        robot = await ocu.discover(subsystem=101)
        driver, sensor = robot.service("mobility:PrimitiveDriver"), robot.service("mobility:LocalPoseSensor")
        async with driver.control(authority=200), asyncio.timeout(60):
            await driver.resume()
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))
            async for pose in sensor.subscribe(QueryLocalPose(0x1FF), rate=20.0):
                if pose.x >= 1.0:
                    break
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=0.0))
            await asyncio.sleep(1.0)
            stopped = await sensor.query(QueryLocalPose(0x1FF))
            await asyncio.sleep(0.5)
            later = await sensor.query(QueryLocalPose(0x1FF))
    assert (stopped.y, stopped.yaw) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert later.x == pytest.approx(stopped.x, abs=1e-3)
    assert later.x >= 1.0
    await stop(program)


TELLS_THE_END = """
import asyncio, backend, sys

class Robot(backend.TrackedRobot):
    def close(self):
        super().close()
        print("closed with efforts", self.drive.motors.efforts)

backend.TrackedRobot = Robot
asyncio.run(backend.main(sys.argv[1]))
"""


@pytest.mark.slow
async def test_a_backend_that_systemd_ends_stops_its_motors(node_manager: LocalNode) -> None:
    program = await asyncio.create_subprocess_exec(
        sys.executable, "-c", TELLS_THE_END, node_manager.local, cwd=EXAMPLES, stdout=asyncio.subprocess.PIPE
    )
    await until(lambda: node_manager.components, within=60.0)
    async with node_manager.ocu("42.1.1") as ocu:
        driver = (await ocu.discover(subsystem=101)).service("mobility:PrimitiveDriver")
        async with driver.control(authority=200):
            await driver.resume()
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))
            program.send_signal(signal.SIGTERM)
            output, _ = await program.communicate()
    assert (program.returncode, output.decode()) == (0, "closed with efforts (0.0, 0.0)\n")


@pytest.mark.slow
async def test_conformance_profile(node_manager: LocalNode) -> None:
    async with node_manager.robot():
        profile = ("conformance_profile:PROFILE", "--target", "101.1.102", "--connect", node_manager.local)
        output = await run("-m", "jauspy.cli.main", "conformance", *profile)
    assert "stands still" in output


@pytest.mark.slow
async def test_replay() -> None:
    assert "1 passed" in await run("-m", "pytest", "-p", "no:cacheprovider", "test_replay.py")


@pytest.mark.slow
async def test_own_service(node_manager: LocalNode) -> None:
    component = await start("own_service.py", node_manager.local)
    output = await run("own_service.py", "client", node_manager.local)
    assert numbers(output.splitlines()[-1])[0] >= 0.1
    await stop(component)
