"""The elevation grid of a running robot, on virtual time; its clouds come from the test."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from types import SimpleNamespace

import numpy as np
import pytest
from tests.helpers.robot import described

from jauspy.cloud.stream import Cloud
from jauspy.errors import JausError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import PlanarPose, Pose, Transform
from jauspy.mapping import sensor_feed
from jauspy.mapping.elevation import ElevationGrid
from jauspy.mapping.live_elevation import LiveElevation, footprint
from jauspy.mapping.sensor_feed import Measurement
from jauspy.ocu import OCU
from jauspy.robot.runner import RobotRunner

CONFIG, MODEL = described("inc1")
SENSOR = FrameTree(MODEL.description).pose("lidar_link")
HERE = PlanarPose()
JOINTS = [joint.name for joint in MODEL.description.joints.values() if joint.is_independent]


def test_the_footprint_is_that_of_the_tracks() -> None:
    (length, width), ground = footprint(LinkBoxes(MODEL.description, JOINTS), {})
    assert 0.4 < length < 1.6
    assert 0.3 < width < 0.8
    assert ground == pytest.approx(0.0, abs=0.03)


@pytest.fixture(autouse=True)
def no_sockets(monkeypatch: pytest.MonkeyPatch) -> None:
    """Feeds that wait for clouds until the test offers some."""

    async def receive(self: LiveElevation, address: str) -> None:
        await asyncio.Event().wait()

    monkeypatch.setattr(sensor_feed.SensorFeed, "_receive", receive)


@asynccontextmanager
async def mapping(ocu: OCU, local: PlanarPose = HERE) -> AsyncIterator[tuple[LiveElevation, asyncio.Task[None]]]:
    grid, robot = ElevationGrid(8.0, 0.1), await ocu.discover(101)
    live = LiveElevation(robot, CONFIG, MODEL, grid, ["ipc:///none"], local=lambda: local, threaded=False)
    task = asyncio.create_task(live.run())
    await asyncio.sleep(2.0)
    yield live, task
    task.cancel()
    with pytest.raises((asyncio.CancelledError, JausError)):
        await task


def cloud(live: LiveElevation, points: np.ndarray) -> Cloud:
    """A cloud of points in the frame of the base."""
    placed = (points - SENSOR.position) @ np.array(SENSOR.rotation)
    return Cloud(placed.astype("<f4").tobytes(), "lidar_link", live.now - 0.1)


async def test_clouds_of_a_robot_that_tips_are_left_out_until_it_has_settled() -> None:
    live = LiveElevation(
        SimpleNamespace(),
        CONFIG,
        MODEL,
        ElevationGrid(8.0, 0.1),
        ["ipc:///none"],
        threaded=False,
    )
    ground = np.column_stack(
        [np.repeat(np.arange(1.0, 2.0, 0.05), 20), np.tile(np.arange(0.0, 1.0, 0.05), 20), np.zeros(400)]
    )

    def add(time: float, pitch: float) -> bool:
        base = Transform.from_pose(Pose(0.0, 0.0, pitch=pitch))
        return live.use(Measurement("a", "base_link", ground, None, Transform(), base, time, [{}]))

    level, ramp = 0.0, -0.3
    assert add(0.0, level)
    assert [add(1.0 + 0.25 * step, ramp * min(1.0, step / 12.0)) for step in range(13)] == [True] * 13, "onto a ramp"
    assert not add(5.0, level), "down from an edge at once"
    assert not add(5.9, level)
    assert add(6.1, level)
    assert live.counters["clouds of a robot that tips"] == 2


@pytest.mark.slow
async def test_silence_of_the_clouds_is_one_error(robot: RobotRunner, ocu: OCU) -> None:
    async with mapping(ocu) as (_, task):
        await asyncio.wait([task], timeout=60.0)
        assert "is the robot started with --cloud ipc:///none?" in str(task.exception())


@pytest.mark.slow
async def test_a_cloud_becomes_heights_in_the_frame_that_is_asked_for(robot: RobotRunner, ocu: OCU) -> None:
    x, y = np.meshgrid(np.arange(1.5, 3.0, 0.02), np.arange(-1.0, 1.0, 0.02))
    ground = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, 0.1)])
    own = np.tile([0.0, 0.0, 0.15], (100, 1))
    async with mapping(ocu, PlanarPose(1.0, 0.0, math.pi / 2.0)) as (live, task):
        before = live.latest
        live.offer("ipc:///none", cloud(live, np.concatenate([ground, own, [[math.nan, 0.0, 0.0]]])))
        async with asyncio.timeout(20.0):
            while live.counters["clouds"] == 0:
                await asyncio.sleep(0.1)
        assert not task.done()
        assert before is None
        assert live.counters["own points"] >= 30
        assert live.counters["points that are no positions"] == 1
        assert live.grid.height_at(1.05, 2.0) == pytest.approx(0.1, abs=0.01)
        assert live.grid.height_at(1.0, 0.0) == pytest.approx(0.0, abs=0.03), "it stands there"
        assert math.isnan(live.grid.height_at(1.0, 3.6))
        assert live.latest is not None
        assert live.latest.heights is live.grid.heights
