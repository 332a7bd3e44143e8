"""A scene from a robot over JAUS, on virtual time: its lidar sees a wall, and clouds of its camera come in."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager, suppress

import numpy as np
import pytest
from tests.helpers.robot import described

from jauspy.backends import kinematic
from jauspy.backends.kinematic import KinematicRobot
from jauspy.cloud.stream import Cloud
from jauspy.errors import JausError
from jauspy.geometry.poses import Pose, Transform
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu import OCU, Robot
from jauspy.planning.perception import Perception
from jauspy.planning.scene import Scene
from jauspy.platform.ranging import Scanner
from jauspy.robot.runner import RobotRunner

WALL = 1.51
"""Metres to the left of where the robot starts; it goes on for ever."""
CAMERA = "chassis_camera_link"


@pytest.fixture
def walled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kinematic robots see a wall."""
    start = KinematicRobot.__init__

    def init(self: KinematicRobot, model: object) -> None:
        start(self, model)  # type: ignore[arg-type]

        def measure(angles: Sequence[float]) -> list[float]:
            pose = self.drive.pose()
            y = pose.y - 0.33 * math.sin(pose.yaw)  # the lidar is 0.33 m behind the middle
            return [(WALL - y) / s if (s := math.sin(angle + pose.yaw)) > 1e-9 else math.inf for angle in angles]

        self.lidars = {name: Scanner(lidar.setup, measure) for name, lidar in self.lidars.items()}
        self._measure()

    monkeypatch.setattr(kinematic.KinematicRobot, "__init__", init)


@asynccontextmanager
async def fed(robot: Robot, *, lidars: bool = True) -> AsyncIterator[Perception]:
    """A scene that a robot feeds within the context."""
    _, model = described("inc1")
    perception = Perception(robot, Scene(model.description), model, lidars=lidars, threaded=False)
    feeding = asyncio.create_task(perception.run())
    try:
        yield perception
    finally:
        feeding.cancel()
        with suppress(asyncio.CancelledError):
            await feeding


def cloud(perception: Perception, points: np.ndarray, frame: str = CAMERA, age: float = 0.1) -> Cloud:
    return Cloud(points.astype("<f4").tobytes(), frame, perception.now - age)


@pytest.mark.slow
async def test_a_wall_stays_where_it_is_while_the_robot_drives(walled: None, robot: RobotRunner, ocu: OCU) -> None:
    found = await ocu.discover(101)
    driver = found.service("mobility:PrimitiveDriver")
    async with fed(found) as perception, driver.control(authority=200):
        await driver.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=30.0, propulsive_rotational_effort_z=6.0))
        await asyncio.sleep(3.0)
        await driver.send(SetWrenchEffort())
        await asyncio.sleep(0.5)
        voxels = perception.scene.obstacles().voxels
        pose = await found.pose()
    base = Transform.from_pose(Pose(pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw))
    there = voxels @ np.array(base.rotation).T + np.array(base.position)
    assert math.hypot(pose.x, pose.y) > 0.5
    assert abs(pose.yaw) > 0.1
    assert len(there) > 50
    assert np.abs(there[:, 1] - WALL).max() < 0.1
    (sensor,) = perception.sensors.values()
    assert sensor.used > 20
    assert 0.0 <= sensor.latency < 0.5


@pytest.mark.slow
async def test_clouds_are_placed_by_the_joints_of_their_time(robot: RobotRunner, ocu: OCU) -> None:
    async with fed(await ocu.discover(101), lidars=False) as perception:
        async with asyncio.timeout(30.0):
            while not (perception.sensors and perception.sensors["camera"].used >= 5):
                perception.offer("camera", cloud(perception, np.array([[1.0, 0.1, 0.2], [1.2, 0.0, 0.2]])))
                await asyncio.sleep(0.2)
        assert perception.sensors["camera"].frame == CAMERA
        voxels = perception.scene.obstacles().voxels
    # the camera is 0.376 m ahead and 0.24 m up
    assert sorted(voxels[:, 0]) == pytest.approx([1.376, 1.576], abs=0.025)
    assert voxels[:, 2] == pytest.approx([0.44, 0.44], abs=0.025)


@pytest.mark.slow
async def test_clouds_that_cannot_be_placed_are_counted(robot: RobotRunner, ocu: OCU) -> None:
    async with fed(await ocu.discover(101), lidars=False) as perception:
        async with asyncio.timeout(30.0):
            while not (
                perception._poses.around(math.inf) and all(h.around(math.inf) for h in perception._joints.values())
            ):
                await asyncio.sleep(0.2)
        await asyncio.sleep(1.0)
        point = np.array([[1.0, 0.0, 0.0]])
        nothing = np.full((9, 3), np.nan)
        kinds = [(point, CAMERA, 10.0), (point, CAMERA, -10.0), (point, CAMERA, math.nan)]
        for points, frame, age in (*kinds, (point, "moon", 0.1), (nothing, CAMERA, 0.1)):
            perception.offer("camera", cloud(perception, points, frame, age))
            await asyncio.sleep(1.0)
        assert perception.counters["measured at another time"] == 3
        assert perception.counters["cloud in an unknown frame"] == 1
        assert perception.scene.counters["points that are no positions"] == 9
        assert not len(perception.scene.obstacles().voxels)
        for _ in range(50):
            perception.offer("camera", cloud(perception, point))
        assert len(perception._pending) == 1
        assert perception.counters["skipped, as a newer one came"] == 49


@pytest.mark.slow
async def test_a_robot_that_is_gone_ends_it(robot: RobotRunner, ocu: OCU) -> None:
    _, model = described("inc1")
    perception = Perception(await ocu.discover(101), Scene(model.description), model)
    feeding = asyncio.create_task(perception.run())
    await asyncio.sleep(1.0)
    await robot.close()
    with pytest.raises(JausError):
        await asyncio.wait_for(feeding, 200.0)
