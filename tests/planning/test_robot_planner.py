"""The planner of a running robot: its sensors, what was given by hand, and sensors that are silent."""

from __future__ import annotations

import asyncio

import pytest

pytest.importorskip("ompl", reason="OMPL is not installed")
pytest.importorskip("coal", reason="coal is not installed")
pytest.importorskip("pynng", reason="the extra 'cloud' is not installed")

from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import Transform
from jauspy.mapping.sensor_feed import SensorState
from jauspy.planning.execution import Aim
from jauspy.planning.motion import NoPlan, PoseGoal, Reason
from jauspy.planning.obstacles import Box
from jauspy.planning.robot_planner import Sight, Surroundings, planned_arm
from jauspy.planning.scene import Scene
from jauspy.robot import robot_files
from jauspy.testing import VirtualNetwork

MODEL = robot_files.robot_model(robot_files.load("inc1"))
POINT = Aim(goal=PoseGoal(Transform(position=(0.7, 0.0, 0.4)), attitude=False))
TABLE = Box(Transform(position=(0.9, 0.0, 0.3)), (0.6, 0.8, 0.6), "table")


@pytest.mark.slow
async def test_it_plans_around_what_was_given(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot("inc1"), virtual_network.ocu("42.1.1") as ocu:
        robot = await ocu.discover(101)
        hand = Surroundings(put=lambda scene: scene.put(TABLE), has_sensors=False)
        async with planned_arm(robot, robot.arm.info.id, MODEL, hand) as planned:
            with pytest.raises(NoPlan, match="table") as why:
                await planned.plan(POINT, 1.0)
        assert why.value.reason in (Reason.GOAL_COLLIDES, Reason.START_COLLIDES)


class Eyes:
    """What `Sight` asks of perception."""

    def __init__(self) -> None:
        self.sensors: dict[str, SensorState] = {}

    async def run(self) -> None:
        await asyncio.Event().wait()


async def test_a_silent_sensor_is_named() -> None:
    eyes, address = Eyes(), "tcp://127.0.0.1:5565"
    sight = Sight(Scene(), eyes, [address])  # type: ignore[arg-type]
    with pytest.raises(RequestError, match=f"no point cloud came from {address}"):
        sight.obstacles()
    eyes.sensors = {address: SensorState("chassis_camera_link", 1, 0.1, 0.05)}
    assert len(sight.obstacles().voxels) == 0
    eyes.sensors = {address: SensorState("chassis_camera_link", 1, 4.0, 0.05)}
    with pytest.raises(RequestError, match=f"nothing came from {address} for 4"):
        sight.obstacles()
    await sight.close()
    with pytest.raises(RequestError, match="perception has ended"):
        sight.obstacles()


async def test_a_description_without_these_joints_is_refused(virtual_network: VirtualNetwork) -> None:
    other = robot_files.robot_model(robot_files.load("rover"))
    async with virtual_network.robot("inc1"), virtual_network.ocu("42.1.1") as ocu:
        robot = await ocu.discover(101)
        with pytest.raises(ConfigError, match="is it the description of this robot"):
            async with planned_arm(robot, robot.arm.info.id, other, Surroundings(has_sensors=False)):
                pass
