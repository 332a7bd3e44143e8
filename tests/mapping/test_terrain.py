"""Elevation grids of the worlds yard and street, against rays from above, with noise of sensors and pose."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.helpers.robot import described
from tests.mapping.test_tour import near

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.mapping.elevation import ElevationGrid
from jauspy.mapping.surfaces import largest_steps
from jauspy_sim.physics.sensors import cast_rays
from jauspy_sim.robot import SimulatedRobot

pytestmark = pytest.mark.slow

Floats = NDArray[np.float64]
Cells = NDArray[np.bool_]

INC1 = described("inc1")[1]
LAYERED = replace(INC1.lidars[0], layers=16, vertical=(math.radians(-15.0), math.radians(15.0)))
MODEL = replace(INC1, cameras=(), force_torque=(), lidars=(LAYERED,))
TREE = FrameTree(MODEL.description)
LIDAR, CAMERA = TREE.pose("lidar_link"), TREE.pose("chassis_camera_link")
TOURS = {
    "street": ((1.2, 0.0), (1.0, -3.5), (3.2, -4.0), (4.0, -1.0)),
    "yard": ((2.3, 0.0), (2.3, -1.5), (0.0, -1.8), (-1.5, -1.2)),
}
WIDTH, HEIGHT, FOV = 100, 64, math.radians(80.0)
REACH = 5.0
"""Metres along the camera's axis."""
HIGH = 0.9
"""Metres above the ground: what is higher is a wall or hangs above the robot."""


def directions() -> Floats:
    """Rays of the camera, of length 1 along its axis."""
    pixel = 2.0 * math.tan(FOV / 2.0) / WIDTH
    u, v = np.meshgrid(((WIDTH - 1) / 2 - np.arange(WIDTH)) * pixel, ((HEIGHT - 1) / 2 - np.arange(HEIGHT)) * pixel)
    return np.stack([np.ones_like(u), u, v], axis=-1).reshape(-1, 3)


@dataclass
class Seen:
    grid: ElevationGrid
    robot: SimulatedRobot
    mounting: Transform
    """Of the lidar, as the grid believes it."""
    random: np.random.Generator
    poses: dict[float, Transform]

    def step(self) -> None:
        """A tenth of a second."""
        self.robot.advance(0.1)
        base = Transform.from_pose(self.robot.drive.pose())
        self.poses[round(self.robot.time, 3)] = base
        self._camera(base)
        scan = self.robot.lidars["lidar"].scan
        assert scan is not None
        taken = self.poses.pop(round(scan.time, 3), None)
        if taken is not None:
            image = scan.image().astype(float)
            up, bearing = np.meshgrid(scan.inclinations, scan.angles, indexing="ij")
            rays = np.stack([np.cos(up) * np.cos(bearing), np.cos(up) * np.sin(bearing), np.sin(up)], axis=-1)
            echoes = np.isfinite(image)
            self.grid.add(rays[echoes] * image[echoes][:, None], self._noisy(taken) @ self.mounting, scan.time)

    def _camera(self, base: Transform) -> None:
        rays, pose = directions(), base @ CAMERA
        lengths = np.linalg.norm(rays, axis=1)
        turned = np.ascontiguousarray(rays / lengths[:, None] @ np.array(pose.rotation).T)
        depth = cast_rays(self.robot.model, self.robot.data, np.array(pose.position), turned) / lengths
        used = depth < REACH
        depth = depth[used] + self.random.normal(size=int(used.sum())) * (0.005 + 0.003 * depth[used] ** 2)
        self.grid.add(rays[used] * depth[:, None], self._noisy(base) @ CAMERA, self.robot.time)

    def _noisy(self, base: Transform) -> Transform:
        """Errors of 1 cm, 5 mm of height, and 0.3 degrees about each axis."""
        p, (x, y, z) = base.to_pose(), self.random.normal(0.0, (0.01, 0.01, 0.005)).tolist()
        a, b, c = self.random.normal(0.0, math.radians(0.3), 3).tolist()
        return Transform.from_pose(Pose(p.x + x, p.y + y, p.z + z, p.roll + a, p.pitch + b, p.yaw + c))


def driven(world: str, mounting: Transform = LIDAR) -> Seen:
    seen = Seen(ElevationGrid(), SimulatedRobot.open(MODEL, world), mounting, np.random.default_rng(3), {})
    for goal in TOURS[world]:
        while math.dist(goal, ((pose := seen.robot.drive.pose()).x, pose.y)) > 0.2:
            error = math.remainder(math.atan2(goal[1] - pose.y, goal[0] - pose.x) - pose.yaw, math.tau)
            seen.robot.drive.set_effort(0.35 * max(0.0, math.cos(error)) ** 3, max(-0.5, min(0.5, 1.5 * error)))
            seen.step()
            assert seen.robot.time < 60.0, "the tour can be driven"
    return seen


def from_above(seen: Seen) -> Floats:
    """What vertical rays meet: four in each cell, shape (cells, cells, 4)."""
    grid, height = seen.grid, 12.0
    inner = np.arange(2 * grid.cells) / 2.0 + 0.25
    x, y = (edge + inner * grid.resolution for edge in grid.origin)
    down = np.array([[0.0, 0.0, -1.0]])
    found = np.array(
        [
            [height - cast_rays(seen.robot.model, seen.robot.data, np.array([a, b, height]), down)[0] for a in x]
            for b in y
        ]
    )
    return found.reshape(grid.cells, 2, grid.cells, 2).transpose(0, 2, 1, 3).reshape(grid.cells, grid.cells, 4)


@dataclass(frozen=True)
class Measured:
    median: float
    worst_of_20: float
    """The 95th percentile: metres, of the cells of even ground."""
    edges_found: float
    known: int


def around(cells: Cells, times: int) -> Cells:
    for _ in range(times):
        cells = near(cells)
    return cells


def measured(seen: Seen) -> Measured:
    heights, true = seen.grid.heights, from_above(seen)
    tall = true.max(axis=2) > HIGH
    middle, spread = true.mean(axis=2), np.ptp(true, axis=2)
    steps, low = largest_steps(middle.astype(np.float32)), true.max(axis=2) < 0.6
    known = np.isfinite(heights) & low
    even = known & (spread < 0.03) & ~near(steps > 0.05) & ~around(tall, 3)
    off = np.abs(heights - middle)[even]
    edges = known & (steps >= 0.08) & ~tall
    found = near(np.nan_to_num(seen.grid.steps()) > 0.05)[edges]
    median, late = np.percentile(off, (50.0, 95.0)).tolist()
    return Measured(median, late, float(found.mean()), int(even.sum()))


@pytest.fixture(params=sorted(TOURS))
def tour(request: pytest.FixtureRequest) -> Measured:
    return measured(driven(request.param))


def test_heights_and_edges_are_those_of_the_world(tour: Measured) -> None:
    assert tour.known > 3000
    assert tour.median < 0.01
    assert tour.worst_of_20 < 0.04
    assert tour.edges_found > 0.9


@pytest.mark.parametrize("off", [Pose(0.0, 0.0, 0.15), Pose(pitch=math.radians(3.0))], ids=["15 cm up", "3 degrees"])
def test_a_lidar_mounted_elsewhere_is_seen_in_the_errors(off: Pose) -> None:
    assert measured(driven("street", Transform.from_pose(off) @ LIDAR)).worst_of_20 > 0.04
