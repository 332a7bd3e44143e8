"""Scans of a lidar as plain numbers; the robot stands in front of a wall, on virtual time."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Sequence
from itertools import islice

import pytest

from jauspy import sync
from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    ConfirmSensorConfiguration,
    SetRangeSensorConfiguration,
)
from jauspy.ocu import OCU, Robot
from jauspy.platform.ranging import Scanner
from jauspy.services.core import Events
from jauspy.testing import LocalNode

WALL = 2.0
"""Metres from the lidar to the left."""


@pytest.fixture(autouse=True)
def wall(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kinematic robots see a wall."""
    init = KinematicRobot.__init__

    def walled(self: KinematicRobot, model: object) -> None:
        init(self, model)  # type: ignore[arg-type]  # whatever the robot is made of

        def measure(angles: Sequence[float]) -> list[float]:
            return [WALL / math.sin(angle) if math.sin(angle) > 0.1 else math.inf for angle in angles]

        self.lidars = {name: Scanner(lidar.setup, measure) for name, lidar in self.lidars.items()}
        self._measure()

    monkeypatch.setattr(KinematicRobot, "__init__", walled)


@pytest.fixture
async def inc1(robot, ocu: OCU) -> Robot:
    return await ocu.robot(101)


def events_of(robot) -> int:
    """How many events the component with the lidar has."""
    (component,) = (each for each in robot.components if str(each.id) == "101.1.108")
    return len(list(component.host.service(Events).subscriptions.queries(JausID(42, 1, 1))))


@pytest.mark.slow
async def test_scans_have_angles_to_the_left_and_no_echo_is_infinite(inc1: Robot) -> None:
    scan = await anext(inc1.lidar().scans())
    assert len(scan.angles) == len(scan.ranges) == 360
    assert scan.time is not None
    left = min(range(360), key=lambda index: abs(scan.angles[index] - math.pi / 2))
    assert scan.ranges[left] == pytest.approx(WALL, abs=0.05)
    assert scan.ranges[min(range(360), key=lambda index: abs(scan.angles[index] + math.pi / 2))] == math.inf
    assert all(y == pytest.approx(WALL, abs=0.1) for _, y, _ in scan.points())
    assert 100 < len(scan.points()) < 180


@pytest.mark.slow
async def test_scans_come_as_they_are_measured_and_a_slow_reader_loses_the_oldest(inc1: Robot) -> None:
    clock = asyncio.get_running_loop().time
    begun, arrivals = clock(), []
    async for _ in inc1.lidar("lidar").scans(buffer=2):
        arrivals.append(clock())
        if len(arrivals) == 5:
            assert arrivals[-1] - begun < 1.2
            await asyncio.sleep(2.0)
        if len(arrivals) == 8:
            break
    assert arrivals[6] - arrivals[4] == pytest.approx(2.0, abs=0.001), "two scans waited"
    assert arrivals[7] > arrivals[6], "and the others were dropped"


@pytest.mark.slow
async def test_leaving_the_loop_ends_the_event(inc1: Robot, robot) -> None:
    scans = inc1.lidar().scans()
    await anext(scans)
    assert events_of(robot) == 1
    await scans.aclose()
    assert events_of(robot) == 0


@pytest.mark.slow
async def test_a_lidar_that_is_off_says_so(inc1: Robot) -> None:
    lidar = inc1.component("101.1.108")
    kind = SetRangeSensorConfiguration
    off = kind.RangeSensorConfigurationRec(sensor_id=1, sensor_state=kind.SensorState.STANDBY)
    client = lidar.service("RangeSensor")
    async with client.control():
        await client.resume()
        await client.query(kind(kind.RequestIdRec(1), [off]), expects=ConfirmSensorConfiguration)
        for rate in (None, 5.0):
            with pytest.raises(RequestError, match="does not measure: the sensor is in standby, off, or has just been"):
                async for _ in inc1.lidar().scans(rate=rate, silence=1.0):
                    pass


@pytest.mark.slow
async def test_the_place_of_the_lidar_is_that_of_its_link(inc1: Robot) -> None:
    pose = await inc1.lidar().pose()
    assert (pose.x, pose.y) == pytest.approx((-0.33, 0.0), abs=0.001)
    assert pose.z == pytest.approx(0.44, abs=0.001)
    assert (pose.roll, pose.pitch, pose.yaw) == pytest.approx((0.0, 0.0, 0.0), abs=0.001)


@pytest.mark.slow
async def test_unknown_lidar_lists_those_that_exist(inc1: Robot) -> None:
    with pytest.raises(
        ConfigError, match=r"there is no lidar 'top'\? This robot has 'lidar', as in robot.lidar\('lidar'"
    ):
        await anext(inc1.lidar("top").scans())


@pytest.mark.slow
def test_scans_without_await(robot, node_manager: LocalNode) -> None:
    with sync.OCU("42.1.1", node_manager.local) as ocu:
        scans = list(islice(ocu.robot(101).lidar().scans(), 2))
    assert len(scans[1].ranges) == 360
