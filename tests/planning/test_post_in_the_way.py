"""inc1 in MuJoCo swings its arm past a post that it has only seen; a straight motion would hit it."""

from __future__ import annotations

import asyncio
import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("ompl", reason="OMPL is not installed")
pytest.importorskip("coal", reason="coal is not installed")

import mujoco
import numpy as np
from tests.helpers.self_contacts import ContactJudge
from tests.helpers.simulated import Simulation, simulated

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.execution import Aim, MotionFailed, MotionState, PlannedArm
from jauspy.planning.obstacles import Obstacles
from jauspy.planning.scene import Scene, Sweep
from jauspy.robot import robot_files
from jauspy.testing import VirtualNetwork
from jauspy_sim.assembly import prefix
from jauspy_sim.robot import SimulatedRobot

WORLD = """<mujoco><worldbody>
  <geom name="ground" type="plane" size="20 20 0.1"/>
  <body name="post"><geom type="box" size="0.04 0.04 0.275" pos="0.8 0 0.275"/></body>
</worldbody></mujoco>"""
MODEL = robot_files.robot_model(robot_files.load("inc1"))
TURN, LOW = "base_link_to_arm_link_1", (0.3, -0.5, 0.2, 0.0)
"""The joint that turns the arm, and positions of the others with which the tool is in front of the robot, 0.3 m up."""
CAMERA = "chassis_camera_link"


def look(robot: SimulatedRobot, scene: Scene, time: float) -> None:
    """What a depth camera on the chassis measures: 80 degrees wide and high, by rays in the simulation."""
    mount = FrameTree(MODEL.description).pose(CAMERA)
    body = robot.data.body(prefix("inc1") + "base_link")
    base = Transform(tuple(map(tuple, body.xmat.reshape(3, 3))), tuple(body.xpos))
    camera = base @ mount
    angles = np.radians(np.linspace(-40.0, 40.0, 61))
    points, found = [], np.zeros(1, np.int32)
    for across in np.tan(angles):
        for up in np.tan(angles):
            way = np.array((1.0, across, up)) / math.sqrt(1.0 + across * across + up * up)
            start, ray = np.array(camera.position), np.array(camera.rotate(tuple(way)))
            far = mujoco.mj_ray(robot.model, robot.data, start, ray, None, 1, -1, found)
            if far > 0.05:
                points.append(way * far)
    assert scene.add(Sweep("chassis", np.array(points), mount, Transform(), time))


async def swing(
    network: VirtualNetwork, folder: Path, sees: Callable[[SimulatedRobot, Scene], Obstacles]
) -> tuple[set[str], float, str]:
    """Swing the arm past the post: what it touched, its least distance from the post in metres, and why it stopped."""
    world = folder / "post.xml"
    world.write_text(WORLD)
    simulation, told, problem = Simulation(), list[MotionState](), ""
    async with simulated(network, simulation, "inc1", world=str(world)), network.ocu("42.1.1") as ocu:
        robot = await ocu.robot(101)
        judge, arm, scene = ContactJudge(simulation.robot, "inc1"), robot.arm, Scene(MODEL.description)
        names = [joint.name for joint in (await arm.description()).joints]
        async with robot.control("arm"):
            await arm.move({TURN: -0.7})
            await arm.move(dict(zip(names[1:], LOW, strict=True)))
        obstacles = sees(simulation.robot, scene)
        touched, nearest = set[str](), math.inf

        async def watch() -> None:
            nonlocal nearest
            while True:
                touched.update(judge.outside())
                nearest = min(nearest, judge.clearance("post"))
                await asyncio.sleep(0.02)

        watching = asyncio.create_task(watch())
        planner = ArmPlanner(MODEL, "arm")
        planned = PlannedArm(
            robot, arm, MODEL, planner, lambda: obstacles, obstruction=planner.obstruction, in_thread=False
        )
        aim = Aim(joints={TURN: 0.7})
        try:
            plan = await planned.plan(aim, 10.0)
            await planned.execute(plan, aim, tell=told.append)
            assert (await arm.joints()).positions[TURN] == pytest.approx(0.7, abs=0.03)
            assert told[-1].replans == 0
        except MotionFailed as error:
            problem = str(error)
        finally:
            watching.cancel()
        return touched, nearest, problem


@pytest.mark.slow
async def test_the_arm_passes_a_post_that_it_has_seen(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    def see(robot: SimulatedRobot, scene: Scene) -> Obstacles:
        look(robot, scene, 0.0)
        return scene.obstacles()

    touched, nearest, problem = await swing(virtual_network, tmp_path, see)
    assert (touched, problem) == (set(), "")
    assert 0.0 < nearest < 0.3


@pytest.mark.slow
async def test_an_arm_that_sees_nothing_hits_the_post(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    touched, nearest, problem = await swing(virtual_network, tmp_path, lambda robot, scene: Obstacles())
    assert touched == {"post"}
    assert nearest < 0.001
    assert re.search("stands still|Blocked", problem)
