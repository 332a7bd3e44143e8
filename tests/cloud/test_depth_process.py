"""Depth clouds from a process of their own, of a robot that looks at an endless floor."""

from __future__ import annotations

import asyncio
import dataclasses
import logging
import math
import os
import signal
from collections.abc import AsyncIterator, Iterator
from pathlib import Path

import pytest

pytest.importorskip("pynng", reason="the extra 'cloud' is not installed")
pytest.importorskip("numpy", reason="the extra 'cloud' is not installed")

import numpy as np

from jauspy.backends.kinematic import KinematicRobot
from jauspy.cloud.depth import DepthProcess, DepthSettings, DepthStream
from jauspy.cloud.stream import XYZ_RGB, Cloud, CloudPublisher, CloudSubscriber
from jauspy.errors import TransportError
from jauspy.platform.camera import CameraSetup
from jauspy.robot.robot_files import load, robot_model
from jauspy.testing import until

FRONT = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
SETTINGS = DepthSettings((80, 60), rate=20.0, range=(0.1, 5.0))
TIMEOUT = 100.0
"""Seconds; the process has what other work leaves of the processors, which may be little."""


@pytest.fixture
def robot() -> Iterator[KinematicRobot]:
    opened = KinematicRobot(dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT,)))
    yield opened
    opened.close()


@pytest.fixture
def stream(robot: KinematicRobot, tmp_path: Path) -> DepthStream:
    return DepthStream(robot.cameras["front"], SETTINGS, f"ipc://{tmp_path}/c")


@pytest.fixture
async def process(stream: DepthStream) -> AsyncIterator[DepthProcess]:
    async with DepthProcess(stream) as opened:
        yield opened


@pytest.fixture
def subscriber(stream: DepthStream) -> Iterator[CloudSubscriber]:
    with CloudSubscriber(stream.address) as opened:
        yield opened


async def next_cloud(subscriber: CloudSubscriber) -> Cloud:
    cloud = await asyncio.to_thread(subscriber.receive, TIMEOUT)
    assert cloud is not None
    return cloud


@pytest.mark.slow
async def test_floor_points_are_at_the_right_height(process: DepthProcess, subscriber: CloudSubscriber) -> None:
    cloud = await next_cloud(subscriber)
    assert (cloud.frame, cloud.values) == ("chassis_camera_link", XYZ_RGB)
    points = np.frombuffer(cloud.points, "<f4").reshape(-1, 6)
    assert len(points) > 500
    assert points[:, 2] == pytest.approx(np.full(len(points), -0.24), abs=1e-4), "so high is the camera"
    assert 0.2 < points[:, 0].min() < 0.5
    assert points[:, 0].max() <= 5.0
    assert points[:, 1].min() == pytest.approx(-points[:, 1].max(), rel=0.01)
    assert ((points[:, 3:] >= 0.0) & (points[:, 3:] <= 1.0)).all()
    assert points[:, 3].std() > 0.05, "the floor has light and dark squares"


@pytest.mark.slow
async def test_clouds_are_numbered_and_counted(process: DepthProcess, subscriber: CloudSubscriber) -> None:
    first, second = await next_cloud(subscriber), await next_cloud(subscriber)
    assert second.number == first.number + 1
    assert second.time == pytest.approx(first.time, abs=0.01), "of the same state: the robot stands"
    await until(lambda: process.counters.get("published", 0) >= 2, TIMEOUT)
    assert process.counters["points"] == process.counters["published"] * len(first)
    assert "floor" in process.description


@pytest.mark.slow
async def test_dead_worker_is_restarted(
    process: DepthProcess, subscriber: CloudSubscriber, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.WARNING)
    first = await next_cloud(subscriber)
    assert process.pid is not None
    os.kill(process.pid, signal.SIGKILL)
    async with asyncio.timeout(TIMEOUT):
        while (await next_cloud(subscriber)).stream == first.stream:
            pass
    assert process.counters["started"] == 2
    assert "depth camera front: its process ended (-9); it starts again in 0.5 s" in caplog.text


@pytest.mark.slow
async def test_worker_ends_on_close(stream: DepthStream, subscriber: CloudSubscriber) -> None:
    async with DepthProcess(stream) as process:
        await next_cloud(subscriber)
        pid = process.pid
    assert process.pid is None
    with pytest.raises(ProcessLookupError):
        os.kill(pid or 0, 0)


async def test_address_in_use_is_an_error_on_open(stream: DepthStream) -> None:
    with CloudPublisher(stream.address), pytest.raises(TransportError, match="cannot publish there"):
        await DepthProcess(stream).open()
