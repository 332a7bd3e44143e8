"""Robot and OCU on two hosts: the link is cut when the robot has driven around a corner of the house `house`.

The robot drives back through the corridor by the position that it estimates; where it is, the simulation says.
"""

from __future__ import annotations

import json
import logging
import math
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.alone

ROBOT = """
import asyncio, json, sys
from pathlib import Path
from jauspy.node import NodeConfig, NodeManager
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.services.iop import Retrotraverse
from jauspy.transport import LocalTransport

async def main(root, world):
    config = robot_files.load("inc1").model_copy(update={"cameras": (), "lidars": (), "modules": ()})
    modules = tuple(module for module in robot_files.load("inc1").modules if module.component in (102, 103))
    config = config.model_copy(update={"modules": modules})
    async with NodeManager(NodeConfig.make(local_root=root)):
        async with RobotRunner(config, lambda id: LocalTransport(id, Path(root)), backend="sim", world=world) as robot:
            driving = next(component.host for component in robot.components if component.id.component == 102)
            pilot = driving.service(Retrotraverse).vehicle.pilot
            while True:
                await asyncio.sleep(0.05)
                pose, twist = robot.snapshot.pose, robot.snapshot.twist
                found = {"x": pose.x, "y": pose.y, "yaw": pose.yaw, "speed": abs(twist.vx) + abs(twist.wz)}
                found["driver"] = type(pilot.driver).__name__
                print(json.dumps(found), flush=True)

asyncio.run(main(*sys.argv[1:]))
"""

OPERATOR = """
import asyncio, sys
from pathlib import Path
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.core import QueryHeartbeatPulse
from jauspy.node import NodeConfig, NodeManager
from jauspy.ocu import OCU
from jauspy.transport import LocalTransport

WAY = [(3.2, 0.0), (7.55, 0.0), (7.55, 2.6)]

async def main(root):
    async with NodeManager(NodeConfig.make(local_root=root)):
        async with OCU("42.1.1", transport=LocalTransport(JausID.parse("42.1.1"), Path(root))) as ocu:
            robot = await ocu.robot(101)
            try:
                async with robot.control("drive", 103):
                    await robot.comms_lost.set("retrotraverse", timeout=8, distance=50.0)
                    print("driving", flush=True)
                    for point in WAY:
                        await robot.go_to(*point, speed=0.45, accept=0.4)
            except JausError as error:
                print("lost:", " ".join(str(error).split()), flush=True)
            while True:
                try:
                    await ocu.query("101.1.102", QueryHeartbeatPulse(), timeout=0.3, retries=0)
                    break
                except JausError:
                    continue
            print("back", flush=True)
            await asyncio.to_thread(sys.stdin.read)

asyncio.run(main(sys.argv[1]))
"""

CORNER_Y = 1.2
"""Metres; beyond it, in the room at the end of the corridor, the link is cut."""


@contextmanager
def program(namespace: str, source: str, *arguments: str) -> Iterator[subprocess.Popen[str]]:
    command = ("ip", "netns", "exec", namespace, sys.executable, "-c", source, *arguments)
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def poses(process: subprocess.Popen[str]) -> Iterator[dict[str, Any]]:
    """The true poses of the robot, twenty times a second."""
    assert process.stdout is not None
    for line in process.stdout:
        yield json.loads(line)


def with_open_door(folder: Path) -> Path:
    """The world `house` with its door left open."""
    source = Path(str(files("jauspy_sim.worlds") / "house.xml"))
    text = source.read_text()
    text, doors = re.subn(r'<body name="door" pos="([^"]*)">', r'<body name="door" pos="\1" euler="0 0 -95">', text)
    text, joints = re.subn(r'(<joint name="door" [^>]*)range="0 100"', r'\1range="0 0.5"', text)
    assert (doors, joints) == (1, 1)
    shutil.copytree(source.parent / "assets", folder / "assets")
    target = folder / "house_with_open_door.xml"
    target.write_text(text)
    return target


@pytest.mark.slow
@pytest.mark.timeout(400)
def test_robot_comes_back_around_the_corner(cable: tuple[str, str], root: Path, tmp_path: Path) -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    roots = [root / letter for letter in "ab"]
    for folder in roots:
        folder.mkdir()
    end = f"jv{os.getpid()}b"
    with ExitStack() as stack:
        robot = stack.enter_context(program(cable[0], ROBOT, str(roots[0]), str(with_open_door(tmp_path))))
        where = poses(robot)
        next(where)
        operator = stack.enter_context(program(cable[1], OPERATOR, str(roots[1])))
        out: list[tuple[float, float]] = []
        for pose in where:
            out.append((pose["x"], pose["y"]))
            if pose["y"] > CORNER_Y:
                break
            assert robot.poll() is None
            assert operator.poll() is None
        subprocess.run(["ip", "-n", cable[1], "link", "set", end, "down"], check=True, timeout=20)
        cut_at, farthest, deviation, stood, speeds = pose, pose["y"], 0.0, 0, []
        began = time.monotonic()
        for pose in where:
            farthest = max(farthest, pose["y"])
            if pose["driver"] != "Retrotraverse":
                out.append((pose["x"], pose["y"]))
                stood += pose["speed"] < 0.03
            else:
                deviation = max(deviation, min(math.dist((pose["x"], pose["y"]), passed) for passed in out))
                speeds.append(pose["speed"])
                if pose["x"] < 6.0:  # half way through the corridor, where the link is good
                    break
            assert time.monotonic() - began < 120
        for words in (("link", "set", end, "up"), ("route", "replace", "default", "dev", end)):
            subprocess.run(["ip", "-n", cable[1], *words], check=True, timeout=20)
        good_at = pose
        still = 0
        for pose in where:
            still = still + 1 if pose["speed"] < 0.03 else 0
            if still > 40:
                break
            assert time.monotonic() - began < 180
        for _, later in zip(range(100), where, strict=False):
            assert math.dist((later["x"], later["y"]), (pose["x"], pose["y"])) < 0.05
        assert operator.stdout is not None
        lines = [operator.stdout.readline().strip() for _ in range(3)]
    overrun = math.dist((good_at["x"], good_at["y"]), (pose["x"], pose["y"]))
    measured = (
        f"link cut at ({cut_at['x']:.2f}, {cut_at['y']:.2f}), stopped at y = {farthest:.2f}; at most {deviation:.3f} m "
        f"from the way out; link good at ({good_at['x']:.2f}, {good_at['y']:.2f}), stopped {overrun:.2f} m farther"
    )
    logging.getLogger("test").info("%s", measured)
    assert lines[0] == "driving"
    assert lines[1].startswith("lost:")
    assert lines[2] == "back"
    assert stood > 10  # the dead-man's stop came first
    assert deviation < 0.13  # the corridor leaves 15 cm on each side
    assert overrun < 1.5
    assert abs(pose["y"]) < 0.2
