"""Mapping a robot over JAUS, on virtual time; a lidar of its own kind sees a wall."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Sequence

import numpy as np
import pytest

from jauspy.backends import kinematic
from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError, JausError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping import live as live_module
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.live import LiveMapping, _StampedPose, interpolated
from jauspy.mapping.mapper import Mapper
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.platform.ranging import Scanner
from jauspy.robot.runner import RobotRunner

WALL = 3.025
"""Metres to the left of where the robot starts; it goes on for ever."""


@pytest.fixture
def walled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kinematic robots see a wall."""
    look = KinematicRobot.__init__

    def init(self: KinematicRobot, model: object) -> None:
        look(self, model)  # type: ignore[arg-type]

        def measure(angles: Sequence[float]) -> list[float]:
            pose = self.drive.pose()
            y = pose.y - 0.2 * math.sin(pose.yaw)  # the lidar sits 0.2 m behind the middle
            return [(WALL - y) / s if (s := math.sin(angle + pose.yaw)) > 1e-9 else math.inf for angle in angles]

        self.lidars = {name: Scanner(lidar.setup, measure) for name, lidar in self.lidars.items()}
        self._measure()

    monkeypatch.setattr(kinematic.KinematicRobot, "__init__", init)


@pytest.mark.slow
async def test_wall_is_mapped_at_its_position(walled: None, robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    live = LiveMapping(found, Mapper(OccupancyGrid(20.0)))
    mapping = asyncio.create_task(live.run())
    driver = found.service("mobility:PrimitiveDriver")
    async with driver.control(authority=200):
        await driver.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=30.0, propulsive_rotational_effort_z=8.0))
        await asyncio.sleep(4.0)
    assert not mapping.done()
    mapping.cancel()
    with pytest.raises(asyncio.CancelledError):
        await mapping
    assert live.counters["scans"] > 30
    assert set(live.counters) == {"scans"}
    grid = live.mapper.grid
    rows, columns = np.nonzero(grid.occupancy() == 100)
    assert len(rows) > 50
    walls = grid.low + (rows + 0.5) * grid.resolution
    assert walls == pytest.approx(np.full(len(walls), WALL), abs=2.5 * grid.resolution)
    seen = robot.snapshot
    assert seen is not None
    assert abs(seen.pose.yaw) > 0.2, "it turned while it drove, and the scans fit nevertheless"
    assert math.dist(live.mapper.path[-1][:2], (seen.pose.x, seen.pose.y)) < 0.3
    assert columns.max() - columns.min() > 60


@pytest.mark.slow
async def test_missing_sensor_is_an_error(robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    with pytest.raises(ConfigError, match=r"101\.1\.108: sensor 7 is not there, or not fixed"):
        await LiveMapping(found, Mapper(), sensor=7).run()


@pytest.mark.slow
async def test_a_robot_without_reports_raises_one_error(robot: RobotRunner, ocu: OCU) -> None:
    live = LiveMapping(await ocu.discover(101), Mapper())
    mapping = asyncio.create_task(live.run())
    await asyncio.sleep(1.0)
    await robot.close()
    with pytest.raises(JausError):
        await asyncio.wait_for(mapping, 200.0)


@pytest.mark.slow
async def test_poses_without_a_time_are_counted(robot: RobotRunner, ocu: OCU, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(live_module, "QueryLocalPose", lambda _: QueryLocalPose(0xFF))
    live = LiveMapping(await ocu.discover(101), Mapper())
    mapping = asyncio.create_task(live.run())
    await asyncio.sleep(3.0)
    assert not mapping.done()
    mapping.cancel()
    with pytest.raises(asyncio.CancelledError):
        await mapping
    assert live.counters["pose without time"] > 30
    assert set(live.counters) == {"pose without time", "no pose in time"}


def test_poses_are_interpolated_across_midnight() -> None:
    before = _StampedPose(86399.9, PlanarPose(1.0, 0.0, math.pi - 0.1), is_level=True)
    later = _StampedPose(0.1, PlanarPose(2.0, 0.0, -math.pi + 0.1), is_level=True)
    middle = interpolated(before, later, 0.0)
    assert middle.pose == pytest.approx((1.5, 0.0, math.pi), abs=1e-9)
    assert middle.is_level
