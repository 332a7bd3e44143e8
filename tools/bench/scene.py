"""What it costs to take clouds of a depth camera into the voxels of a scene, in processor time of one thread.

python tools/bench/scene.py [--points 64000] [--clouds 30] [--seed 1]

A camera 0.5 m above the ground turns in a hall with twenty boxes (rays, with noise of 5 mm), while the arm of inc1
moves. A line for each of: a scene without a robot, one that leaves out the robot's own body, and one that forbids
unknown space. `add` is the cost of a cloud, `obstacles` that of what a planner asks for after it. The ratio is to `add`
without a robot in the same run.
"""

from __future__ import annotations

import argparse
import math
import statistics
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.scene import Scene, SceneSetup, Sweep, Unknown
from jauspy.robot.robot_files import load, robot_model

RANGE = 6.0
"""Metres up to which the camera measures."""
FIELD = math.radians(80.0)
"""Its field of view across."""
HEIGHT = 0.5
"""Metres of the camera above the ground."""
NOISE = 0.005
"""Metres, one standard deviation."""
RATE = 10.0
"""Clouds a second."""
TURN = 0.05
"""Radians that the camera turns between two clouds."""
HALL = 5.0
"""Metres from the middle to the walls."""

Array = NDArray[np.float64]


def boxes(rng: np.random.Generator) -> tuple[Array, Array]:
    """Lower and upper corners of the boxes and of the slabs that are ground and walls, in metres."""
    middles = rng.uniform((-4.0, -4.0, 0.0), (4.0, 4.0, 0.5), (20, 3))
    middles = middles[np.hypot(middles[:, 0], middles[:, 1]) > 1.0]
    halves = rng.uniform(0.05, 0.3, middles.shape)
    ground = [(-9.0, -9.0, -0.2)], [(9.0, 9.0, 0.0)]
    walls = [(HALL, -9.0, 0.0), (-9.0, HALL, 0.0)], [(9.0, 9.0, 3.0), (9.0, 9.0, 3.0)]
    low = np.concatenate([middles - halves, *map(np.array, (ground[0], walls[0]))])
    high = np.concatenate([middles + halves, *map(np.array, (ground[1], walls[1]))])
    return low, high


def look(world: tuple[Array, Array], camera: Transform, count: int, rng: np.random.Generator) -> Array:
    """What the camera measures, in its own frame, x ahead: shape (n, 3)."""
    across = round(math.sqrt(count * 4.0 / 3.0))
    down = count // across
    y, z = np.meshgrid(*(math.tan(FIELD / 2.0) * np.linspace(-1.0, 1.0, side) for side in (across, down)))
    rays = np.stack([np.ones_like(y), y, 0.75 * z], axis=-1).reshape(-1, 3)
    rays /= np.linalg.norm(rays, axis=1)[:, None]
    turned, origin = rays @ np.array(camera.rotation).T, np.array(camera.position)
    nearest = np.full(len(rays), np.inf)
    with np.errstate(divide="ignore"):
        inverse = 1.0 / turned
    for low, high in zip(*world, strict=True):
        one, other = (low - origin) * inverse, (high - origin) * inverse
        begin, end = np.minimum(one, other).max(axis=1), np.maximum(one, other).min(axis=1)
        hit = (begin <= end) & (begin > 0.0)
        nearest[hit] = np.minimum(nearest[hit], begin[hit])
    seen = nearest < RANGE
    return rays[seen] * (nearest[seen] + rng.normal(0.0, NOISE, int(seen.sum())))[:, None]


def sweeps(points: int, clouds: int, seed: int, joint: str) -> list[Sweep]:
    """Clouds of a camera that turns, while a joint moves."""
    rng = np.random.default_rng(seed)
    world, found = boxes(rng), list[Sweep]()
    for number in range(clouds):
        camera = Transform.from_pose(Pose(0.3, 0.0, HEIGHT, 0.0, 0.3, TURN * number))
        posture = {joint: 0.02 * number}
        seen = look(world, camera, points, rng)
        found.append(Sweep("depth", seen, camera, Transform(), number / RATE, (posture,)))
    return found


def timed(call: Callable[[], Any]) -> float:
    """Seconds of processor time of a call."""
    begin = time.thread_time()
    call()
    return time.thread_time() - begin


def main() -> None:
    """A line for each kind of scene."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=64_000)
    parser.add_argument("--clouds", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    model = robot_model(load("inc1"))
    seen = sweeps(options.points, options.clouds, options.seed, model.groups["arm"].joints[0])
    kinds = (
        ("without robot", Scene()),
        ("own body", Scene(model.description)),
        ("unknown forbidden", Scene(model.description, SceneSetup(unknown=Unknown.FORBIDDEN))),
    )
    least = 0.0
    heads = "points  add ms   p95  points/s  ratio  obstacles ms   p95  voxels     MB  dropped"
    print(f"{'scene':<18} {heads}")
    for name, scene in kinds:
        adding, asking = list[float](), list[float]()
        for sweep in seen:
            adding.append(timed(partial(scene.add, sweep)))
            asking.append(timed(scene.obstacles))
        count = statistics.median(len(sweep.points) for sweep in seen)
        middle, ask = statistics.median(adding), statistics.median(asking)
        least = least or middle
        high, ask_high = (float(np.percentile(times, 95.0)) for times in (adding, asking))
        summary = scene.summary()
        voxels = len(scene.obstacles().voxels)
        print(
            f"{name:<18} {count:6.0f} {1e3 * middle:7.1f} {1e3 * high:5.1f} {count / middle:9.0f} "
            f"{middle / least:6.2f} {1e3 * ask:13.1f} {1e3 * ask_high:5.1f} {voxels:7} {summary.memory / 1e6:6.1f} "
            f"{sum(summary.dropped.values()):8}"
        )


if __name__ == "__main__":
    main()
