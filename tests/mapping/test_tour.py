"""A drive around the yard with odometry that drifts: the map against the world's true floor plan."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from numpy.typing import NDArray

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
from tests.helpers.robot import described

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.map_files import save_map
from jauspy.mapping.mapper import Mapper
from jauspy_sim.models.groups import COLLISION, VISUAL
from jauspy_sim.robot import SimulatedRobot

pytestmark = pytest.mark.slow

TOUR = (  # m
    (2.2, 0.0),
    (2.4, -2.2),
    (0.0, -2.0),
    (-2.0, -1.8),
    (-2.0, 1.8),
    (0.0, 2.5),
    (2.2, 2.5),
    (0.9, 2.0),
    (0.8, 1.0),
    (0.0, 0.0),
)
MODEL = described("inc1")[1]
MOUNTED = FrameTree(MODEL.description).pose(MODEL.lidars[0].link).position
LIDAR = PlanarPose(MOUNTED[0], MOUNTED[1])
HEIGHT = 0.44
"""Metres above the ground of the lidar."""
LEVEL = 0.03
"""Radians."""
ABOVE = 5.0


def planar(robot: SimulatedRobot) -> PlanarPose:
    pose = robot.drive.pose()
    return PlanarPose(pose.x, pose.y, pose.yaw)


def drive(robot: SimulatedRobot) -> Iterator[PlanarPose]:
    """The true pose every tenth of a second of the tour."""
    for x, y in TOUR:
        while math.dist((x, y), (here := planar(robot))[:2]) > 0.15:
            error = math.remainder(math.atan2(y - here.y, x - here.x) - here.yaw, math.tau)
            turn = max(-0.5, min(0.5, 1.5 * error))
            robot.drive.set_effort(0.4 * max(0.0, math.cos(error)) ** 3, turn)
            robot.advance(0.1)
            assert robot.time < 100.0, "the tour leads around everything"
            yield planar(robot)


class Odometry:
    """Wheels that slip: 3 % too far, 2 % and a degree a metre too much to the left, and noise on all of it."""

    def __init__(self, seed: int) -> None:
        self._random = np.random.default_rng(seed)
        self._before = PlanarPose()
        self.pose = PlanarPose()

    def move(self, now: PlanarPose) -> PlanarPose:
        step, self._before = now.relative_to(self._before), now
        way, noise = math.hypot(step.x, step.y), self._random.normal(0.0, 0.02, 4).tolist()
        yaw = step.yaw * (1.02 + noise[2]) + way * (math.radians(1.0) + noise[3])
        self.pose = self.pose @ PlanarPose(step.x * (1.03 + noise[0]), step.y + way * noise[1], yaw)
        return self.pose


def floor_plan(robot: SimulatedRobot, grid: OccupancyGrid) -> NDArray[np.bool_]:
    """Cells in which something is as high as the lidar, by rays from above through their corners."""
    groups = np.array([n not in (VISUAL, COLLISION) for n in range(mujoco.mjNGROUP)], np.uint8)
    down, found = np.array([0.0, 0.0, -1.0]), np.zeros(1, np.int32)
    mujoco.mj_kinematics(robot.model, robot.data)
    inset = 0.02 * grid.resolution
    edges = np.array(
        [grid.low + n * grid.resolution + d for n in range(grid.cells) for d in (inset, grid.resolution - inset)]
    )
    high = [
        [ABOVE - mujoco.mj_ray(robot.model, robot.data, np.array([x, y, ABOVE]), down, groups, 1, -1, found) > HEIGHT
         for x in edges] for y in edges
    ]  # fmt: skip
    corners = np.array(high).reshape(grid.cells, 2, grid.cells, 2)
    plan: NDArray[np.bool_] = corners.any(axis=(1, 3))
    return plan


def near(cells: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """These cells and those beside them."""
    padded, (rows, columns) = np.pad(cells, 1), cells.shape
    views = [padded[a : a + rows, b : b + columns] for a in range(3) for b in range(3)]
    return np.logical_or.reduce(views)


@pytest.fixture(scope="module")
def tour() -> tuple[SimulatedRobot, dict[bool, Mapper], list[float], float]:
    """The robot after the tour, maps with and without matching, errors of the matched poses, and that of odometry."""
    robot = SimulatedRobot.open(MODEL, "yard")
    odometry, errors = Odometry(seed=1), []
    mappers = {matching: Mapper(OccupancyGrid(16.0), matching=matching) for matching in (True, False)}
    for true in drive(robot):
        believed = odometry.move(true)
        tilt, scan = robot.drive.pose(), robot.lidars["lidar"].scan
        assert scan is not None
        assert scan.time == pytest.approx(robot.time)
        if max(abs(tilt.roll), abs(tilt.pitch)) < LEVEL:
            found = [mapper.add(believed, LIDAR, scan.angles, scan.ranges) for mapper in mappers.values()]
            errors.append(math.dist(found[0][:2], true[:2]))
    drift = math.dist(odometry.pose[:2], planar(robot)[:2]) + abs(odometry.pose.yaw - planar(robot).yaw)
    return robot, mappers, errors, drift


def shares(robot: SimulatedRobot, mapper: Mapper) -> tuple[float, float, float]:
    """Of the observed cells those that are right; of those marked those at something; of the seen those marked."""
    cells, true = mapper.grid.occupancy(), floor_plan(robot, mapper.grid)
    observed, marked = cells != -1, cells == 100
    right = (marked == true)[observed]
    return float(right.mean()), float(near(true)[marked].mean()), float(marked[true & observed].mean())


def test_map_matches_the_floor_plan(tour: tuple[SimulatedRobot, dict[bool, Mapper], list[float], float]) -> None:
    robot, mappers, errors, drift = tour
    assert drift > 0.2, "odometry was to be wrong"
    assert max(errors) < 0.08
    right, at_something, seen = shares(robot, mappers[True])
    assert right > 0.99
    assert at_something > 0.9
    assert seen > 0.9


def test_map_files_match_the_floor_plan(
    tour: tuple[SimulatedRobot, dict[bool, Mapper], list[float], float], tmp_path: Path
) -> None:
    """As map_server reads them: the first row is the top, the origin is the lower left corner."""
    robot, mappers, _, _ = tour
    grid = mappers[True].grid
    save_map(grid, tmp_path / "yard")
    notes = yaml.safe_load((tmp_path / "yard.yaml").read_text())
    picture = cv2.imread(str(tmp_path / notes["image"]), cv2.IMREAD_GRAYSCALE)[::-1]
    occupied = (255 - picture) / 255 > notes["occupied_thresh"]
    free = (255 - picture) / 255 < notes["free_thresh"]
    left, low = (round((edge - grid.low) / notes["resolution"]) for edge in notes["origin"][:2])
    true = floor_plan(robot, grid)[low : low + picture.shape[0], left : left + picture.shape[1]]
    observed = occupied | free
    assert observed.sum() > 10_000
    assert (occupied == true)[observed].mean() > 0.9
    assert near(true)[occupied].mean() > 0.9
    assert occupied[true & observed].mean() > 0.9


def test_map_without_scan_matching_differs_from_the_floor_plan(
    tour: tuple[SimulatedRobot, dict[bool, Mapper], list[float], float],
) -> None:
    robot, mappers, _, _ = tour
    _, at_something, seen = shares(robot, mappers[False])
    assert at_something < 0.7
    assert seen < 0.7
