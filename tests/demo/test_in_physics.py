"""The demo's drive and grasp in MuJoCo on virtual time: the simulation's truth, and the same every time."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import AsyncExitStack
from pathlib import Path
from types import SimpleNamespace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("cv2", reason="OpenCV is not installed")
pytest.importorskip("canopen", reason="canopen is not installed")

import cv2

from jauspy.cli.options import on_bus
from jauspy.demo import plan
from jauspy.demo.grasp import ARM_CAMERA, Grasp
from jauspy.demo.judge import Place, touched, true_place
from jauspy.demo.report import Report, StageResult, View
from jauspy.demo.tour import Tour
from jauspy.geometry.poses import PlanarPose
from jauspy.ocu.frames import RobotFrames
from jauspy.platform.contacts import Contacts
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork
from jauspy_sim.robot import SimulatedRobot

pytestmark = pytest.mark.slow

SIZE = (640, 480)


class Camera:
    """The arm's camera, in this process."""

    def __init__(self, simulated: SimulatedRobot) -> None:
        self._eye = simulated.cameras[ARM_CAMERA].open()

    async def still(self, **_: object) -> SimpleNamespace:
        self.close = self._eye.close
        picture = cv2.cvtColor(self._eye.look(*SIZE).image, cv2.COLOR_RGB2BGR)
        return SimpleNamespace(content=cv2.imencode(".png", picture)[1].tobytes())


class GraspTour(Tour):
    """The tour as in the demo, without recordings."""

    simulated: SimulatedRobot
    folder: Path
    height: float
    """Metres of the thing's middle above the world's origin, while it is held."""

    async def run(self) -> None:
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            control, arm = await self._begin(stack, robot)
            self._add(await self._drive_there(robot, control))
            camera = Camera(self.simulated)
            grasp = Grasp(arm, RobotFrames(robot, self._model), self._model, camera, size=SIZE, goals=self._plan)
            stages: tuple[Callable[[], object], ...] = (grasp.reach, grasp.close, grasp.lift)
            self._add(await grasp.look(self.folder))
            for stage in stages:
                self._add(await stage())
            self.height = float(self.simulated.data.body(self._plan.thing.body).xpos[2])
            camera.close()


async def play(
    network: VirtualNetwork, world: str, folder: Path, backend: str = "sim"
) -> tuple[list[StageResult], GraspTour]:
    config = load("inc1").model_copy(update={"world": world})
    if backend == "can":  # simulated servo drives between the modules and the physics
        config = on_bus(config, "virtual:sim")
    runner = RobotRunner(config, network.transport, backend=backend, realtime=VirtualTime)
    async with runner, network.ocu("42.1.1") as ocu:
        assert runner._realtime is not None
        report = Report()
        tour = GraspTour(ocu, config, View(), report, folder, goals=plan.PLANS[world])
        opened = runner._realtime._robot.inner
        tour.simulated, tour.folder = opened.fleet.plant.robot if backend == "can" else opened, folder
        await tour.run()
        report.save(folder)
        return report.results, tour


@pytest.mark.parametrize(("world", "backend"), [("yard", "can"), ("street", "sim")])
async def test_goals_are_reached_in_the_simulation(
    world: str, backend: str, virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    goals = plan.PLANS[world]
    results, tour = await play(virtual_network, world, tmp_path, backend)
    simulated = tour.simulated
    assert {each.stage: each.reached for each in results} == dict.fromkeys(
        ("drive", "look", "reach", "grasp", "lift"), True
    ), [each.measured for each in results]
    pose = simulated.drive.pose()
    place = true_place(Place(PlanarPose(pose.x, pose.y, pose.yaw), pose.z), goals)
    assert place.reached, place.measured
    contacts = Contacts.of(simulated)
    assert contacts is not None
    kept_off = touched(contacts.state(), goals)
    assert kept_off.reached, kept_off.measured
    assert kept_off.figures["thing_contacts"] > 100
    reached = next(each.figures for each in results if each.stage == "reach")
    assert abs(reached["base_pitch"]) < math.radians(1.0)
    assert reached["target_z"] == pytest.approx(
        goals.thing.support + goals.thing.grip_height, abs=plan.MAX_SUPPORT_ERROR
    )
    lifted = tour.height - goals.thing.height - goals.ground
    assert lifted == pytest.approx(results[-1].figures["lifted"], abs=0.02)
    assert lifted > plan.MIN_LIFT


async def test_street_twice_is_the_same(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    ends = []
    for _ in range(2):
        results, tour = await play(virtual_network, "street", tmp_path)
        figures = [{**each.figures, "seconds": 0.0} for each in results]  # those are of the wall clock
        ends.append((tour.simulated.data.qpos.tolist(), figures))
    assert ends[0] == ends[1]
    assert not math.isnan(sum(ends[0][0]))
