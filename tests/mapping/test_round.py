"""A round of 60 m through the corridors of a building, with the odometry of a robot: which maps close.

The way out is not seen from the way back: errors that grow over the round show where it ends.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
from tests.helpers.robot import described
from tests.mapping.test_tour import near

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import PlanarPose, Pose
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.map_files import save_map
from jauspy.mapping.mapper import Mapper
from jauspy.platform.localization import Localization
from jauspy.platform.localizer import Localizer
from jauspy_sim import assembly
from jauspy_sim.robot import SimulatedRobot

pytestmark = pytest.mark.slow

LEFT, LOW, WIDTH, HEIGHT = -2.02, -1.03, 18.0, 14.01
"""Corner and sides of the building, metres; the robot starts in its lower corridor."""
CORRIDOR, WALL = 2.0, 0.2
RIGHT, TOP = LEFT + WIDTH, LOW + HEIGHT
ROUND = [
    (RIGHT - 1.0, LOW + 1.0),
    (RIGHT - 1.0, TOP - 1.0),
    (LEFT + 1.0, TOP - 1.0),
    (LEFT + 1.0, LOW + 1.0),
    (4.0, LOW + 1.0),
]
BOXES = [
    (LEFT - WALL, LOW - WALL, RIGHT + WALL, LOW),
    (LEFT - WALL, TOP, RIGHT + WALL, TOP + WALL),
    (LEFT - WALL, LOW, LEFT, TOP),
    (RIGHT, LOW, RIGHT + WALL, TOP),
    (LEFT + CORRIDOR, LOW + CORRIDOR, RIGHT - CORRIDOR, TOP - CORRIDOR),
    *((x, LOW, x + 0.7, LOW + 0.3) for x in (3.0, 6.5, 9.0, 12.5)),
    *((RIGHT - 0.3, y, RIGHT, y + 0.6) for y in (2.0, 5.0, 8.5)),
    *((x, TOP - 0.3, x + 0.6, TOP) for x in (1.0, 4.0, 8.0, 11.0)),
    *((LEFT, y, LEFT + 0.3, y + 0.6) for y in (3.0, 6.0, 8.0)),
]
"""Walls, the block in the middle, and cupboards: left, low, right and top."""


def building() -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(40.0, 40.0, 0.1))
    for left, low, right, top in BOXES:
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            pos=((left + right) / 2.0, (low + top) / 2.0, 0.75),
            size=((right - left) / 2.0, (top - low) / 2.0, 0.75),
        )
    return spec


def floor_plan(grid: OccupancyGrid) -> NDArray[np.bool_]:
    """Cells that a box touches."""
    plan = np.zeros((grid.cells, grid.cells), bool)
    for left, low, right, top in BOXES:
        x0, y0, x1, y1 = (math.floor((edge - grid.low) / grid.resolution) for edge in (left, low, right, top))
        plan[y0 : y1 + 1, x0 : x1 + 1] = True
    return plan


def planar(pose: Pose) -> PlanarPose:
    return PlanarPose(pose.x, pose.y, pose.yaw)


@dataclass
class Result:
    mapper: Mapper
    errors: list[float]
    """Metres, of each pose."""

    def wrong(self) -> float:
        """Of the observed cells those that are wrong."""
        cells = self.mapper.grid.occupancy()
        return float(((cells == 100) != floor_plan(self.mapper.grid))[cells != -1].mean())

    def at_something(self) -> float:
        """Of the marked cells those at a wall."""
        return float(near(floor_plan(self.mapper.grid))[self.mapper.grid.occupancy() == 100].mean())


def rounds(robot: SimulatedRobot, goals: Sequence[tuple[float, float]] = ROUND) -> Iterator[None]:
    """Ten times a second, steered by the truth."""
    for goal in goals:
        while math.dist(goal, (here := planar(robot.drive.pose()))[:2]) > 0.3:
            error = math.remainder(math.atan2(goal[1] - here.y, goal[0] - here.x) - here.yaw, math.tau)
            robot.drive.set_effort(0.4 * max(0.0, math.cos(error)) ** 3, max(-0.5, min(0.5, 1.5 * error)))
            yield
            assert robot.time < 300.0, "the round can be driven"


@pytest.fixture(scope="module")
def driven() -> dict[str, Result]:
    model = replace(described("inc1")[1], cameras=(), force_torque=())
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(assembly, "world_spec", lambda *_: building())
        robot = SimulatedRobot.open(model, "empty")
    known = Localization.of(robot)
    assert known is not None
    wheels = Localizer(replace(model.localization, imu=None, gnss=None), robot.drive)
    found = {
        "wheels": Result(Mapper(OccupancyGrid(44.0), matching=False), []),
        "dead reckoning": Result(Mapper(OccupancyGrid(44.0), matching=False), []),
        "matched": Result(Mapper(OccupancyGrid(44.0)), []),
    }
    mounted = FrameTree(model.description).pose(model.lidars[0].link).position
    lidar = PlanarPose(mounted[0], mounted[1])
    way, last = 0.0, robot.drive.pose()
    for _ in rounds(robot):
        for _ in range(5):
            robot.advance(0.02)
            wheels.step(robot.time)
        true, scan = robot.drive.pose(), robot.lidars["lidar"].scan
        assert scan is not None
        way, last = way + math.dist((true.x, true.y), (last.x, last.y)), true
        for name, result in found.items():
            odometry = planar((wheels if name == "wheels" else known).state().local.pose)
            pose = result.mapper.add(odometry, lidar, scan.angles, scan.ranges)
            result.errors.append(math.dist(pose[:2], (true.x, true.y)))
    assert 58.0 < way < 64.0
    return found


def test_matched_map_closes(driven: dict[str, Result], tmp_path: Path) -> None:
    matched = driven["matched"]
    assert max(matched.errors) < 0.08
    assert matched.errors[-1] < 0.05
    assert matched.wrong() < 0.01
    assert matched.at_something() > 0.98
    save_map(matched.mapper.grid, tmp_path / "round")


def test_dead_reckoning_is_worse_and_wheels_alone_are_useless(driven: dict[str, Result]) -> None:
    matched, reckoned, wheels = driven["matched"], driven["dead reckoning"], driven["wheels"]
    assert max(reckoned.errors) > 2.0 * max(matched.errors)
    assert reckoned.wrong() > 4.0 * matched.wrong()
    assert max(wheels.errors) > 1.0, "tracks skid in each corner"
    assert wheels.at_something() < 0.7
