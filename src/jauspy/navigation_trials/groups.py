"""A group of goals: a robot that begins anew, on virtual time, and drives to them one after the other."""

from __future__ import annotations

import asyncio
import os
from collections.abc import AsyncIterator, Iterator, Sequence
from contextlib import AsyncExitStack, asynccontextmanager
from copy import deepcopy
from functools import partial
from typing import Final

import numpy as np

from jauspy.campaigns import run_parts
from jauspy.cloud.stream import Cloud
from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose, Pose
from jauspy.mapping.grid import OccupancyGrid
from jauspy.navigation_trials.drives import Place, drive_to
from jauspy.navigation_trials.goals import Goal, TrueMap
from jauspy.navigation_trials.judge import DepthCamera, DrivingTruth, PlacingBackend
from jauspy.navigation_trials.results import Drive, GoalGroup, TrialPlan
from jauspy.planning.driving_map import DrivingMap, heights_of_clouds
from jauspy.planning.mobility import Mobility, mobility_of
from jauspy.planning.navigator import Navigator
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.robot.several import with_other_errors
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

ROBOT: Final = "inc1"
STARTS: Final = {"house": Pose(x=2.7)}
"""Where the robot starts in a world, if not at its origin."""
CAMERA: Final = "chassis_camera_link"
"""The link of its depth camera."""
ADDRESS: Final = "trials:depth"
"""The name of that camera's clouds."""
LOOK_INTERVAL: Final = 0.25
"""Seconds between two of them."""
WITHOUT: Final = ("CM-VIS", "CM-AUD")
"""Types of modules that are left out: they need a process each."""


def run_trials(
    plan: TrialPlan, groups: Sequence[GoalGroup], *, jobs: int | None = None, cluster: str | None = None
) -> Iterator[list[Drive]]:
    """Yield the drives of each group as they come, in any order; `jobs` and `cluster` are as in `run_parts`."""
    yield from run_parts(partial(drive_group, plan), groups, jobs=jobs, cluster=cluster)


def drive_group(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
    """Drive to all goals of a group in the calling process. After a drive that failed the robot begins anew.

    Raises `ConfigError` when the world cannot be opened, or when no goal in it can be reached.
    """
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    drives: list[Drive] = []
    maps: list[OccupancyGrid] = []
    while len(drives) < group.goals:
        maps.append(asyncio.run(_drive_from_start(plan, group, drives, None)))
    largest = max(maps, key=lambda grid: int(np.count_nonzero(grid.log_odds)))
    while len(drives) < plan.drives(group):
        asyncio.run(_drive_from_start(plan, group, drives, deepcopy(largest)))
    return drives


async def _drive_from_start(
    plan: TrialPlan, group: GoalGroup, drives: list[Drive], known: OccupancyGrid | None
) -> OccupancyGrid:
    """Add drives of a robot that begins anew, until one has failed or there are enough; returns its map.

    With a `known` map, these are to the goals of the group once more.
    """
    rng = np.random.default_rng((plan.seed, group.number, len(drives)))
    config = with_other_errors(robot_without_media(), int(rng.integers(1 << 30)))
    model, first = robot_model(config), len(drives)
    mobility = mobility_of(model)
    backend = PlacingBackend(STARTS.get(group.world, Pose()))
    async with AsyncExitStack() as stack:
        network = await stack.enter_async_context(VirtualNetwork(seed=plan.seed))
        runner = RobotRunner(
            config,
            network.transport,
            backend=backend,
            world=group.world,
            realtime=VirtualTime,
            utc_now=network.utc_now,
        )
        await stack.enter_async_context(runner)
        ocu = await stack.enter_async_context(network.ocu())
        robot = await ocu.robot(config.subsystem)
        truth = backend.truth(mobility.flipper_step)
        measured = await robot.pose()
        to_local = PlanarPose(measured.x, measured.y, measured.yaw) @ _planar(truth.pose()).inverse()
        true_map = TrueMap(truth.heights, mobility)
        clouds = None if plan.blind else heights_of_clouds(robot, config, model, [], threaded=False)
        surroundings = DrivingMap(robot, threaded=False, heights=clouds, known=known)
        await stack.enter_async_context(_looking(truth.depth_camera(CAMERA, plan.seed), surroundings))
        await stack.enter_async_context(robot.control())
        await stack.enter_async_context(surroundings)
        while len(drives) < (group.goals if known is None else plan.drives(group)):
            here = _planar(truth.pose())
            if known is None:
                goal = true_map.draw_goal(here, rng)
            else:
                goal = true_map.goal_at(here, *drives[len(drives) - group.goals].goal)
            if goal is None and len(drives) == first:
                raise ConfigError(f"the world {group.world} has no goal that {ROBOT} can reach from its start")
            if goal is None:
                break
            place = Place(group.world, group.number, len(drives), known=known is not None)
            navigator = Navigator(robot, model, surroundings)
            has_way = partial(_has_way, truth, mobility, goal) if plan.moved else None
            drive = await drive_to(navigator, truth, goal, to_local, place, has_way=has_way)
            drives.append(drive)
            if not drive.reached:
                break
            if drive.thing or drive.contacts:
                true_map = _measured(truth, mobility)
    return surroundings.grid


def _has_way(truth: DrivingTruth, mobility: Mobility, goal: Goal) -> bool:
    """True if the true map, measured anew, has a way from where the robot is to the goal."""
    return _measured(truth, mobility).goal_at(_planar(truth.pose()), goal.x, goal.y) is not None


def _measured(truth: DrivingTruth, mobility: Mobility) -> TrueMap:
    """The true map, measured anew."""
    truth.measure_heights()
    return TrueMap(truth.heights, mobility)


def robot_without_media() -> RobotConfig:
    """The robot without cameras and sound."""
    config = robot_files.load(ROBOT)
    modules = tuple(module for module in config.modules if module.type not in WITHOUT)
    return config.model_copy(update={"modules": modules, "cameras": (), "microphones": (), "loudspeakers": ()})


@asynccontextmanager
async def _looking(camera: DepthCamera, surroundings: DrivingMap) -> AsyncIterator[None]:
    """Look with the camera, if the map has heights."""
    task = asyncio.create_task(_look(camera, surroundings), name="depth camera")
    try:
        yield
    finally:
        task.cancel()
        await asyncio.wait({task})
    if not task.cancelled():
        task.result()


async def _look(camera: DepthCamera, surroundings: DrivingMap) -> None:
    while (heights := surroundings.heights) is not None:
        heights.offer(ADDRESS, Cloud(camera.look().astype("<f4").tobytes(), CAMERA, heights.now))
        await asyncio.sleep(LOOK_INTERVAL)


def _planar(pose: Pose) -> PlanarPose:
    return PlanarPose(pose.x, pose.y, pose.yaw)
