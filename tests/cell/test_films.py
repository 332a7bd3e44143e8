"""What the cameras of films have in their picture: all that moves in a task, from its beginning to its end."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="needs the extra 'sim'")

from jauspy.cell.session import simulated
from jauspy.cell.tasks import FILMED_BY, TASKS
from jauspy.geometry.vectors import Vector, cross, difference, dot, scaled
from jauspy.platform.camera import CameraSetup
from jauspy.platform.description import RobotModel

SEED = 7
PERIOD = 0.2
"""Seconds between two looks at what moves."""
MOVED = 0.05
"""Metres from where something was at the start; less is no motion that a film shows."""
NEEDED = ("assemble", "lift", "step", "car")
STANDING = 1.15
"""Metres above a platform that an arm with five joints stands."""


def camera_of(model: RobotModel, name: str) -> CameraSetup:
    return next(camera for camera in model.cameras if camera.name == name)


def place(camera: CameraSetup, point: Iterable[float]) -> tuple[float, float]:
    """Where a point is in the picture: from -1 at the left and at the bottom to 1."""
    outside = camera.outside
    assert outside is not None
    assert outside.target is not None
    ahead = unit(difference(outside.target, outside.position))
    right = unit(cross(ahead, (0.0, 0.0, 1.0)))
    x, y, z = point
    way = difference((x, y, z), outside.position)
    wide = dot(way, ahead) * math.tan(camera.fov / 2.0)
    return dot(way, right) / wide, dot(way, cross(right, ahead)) / (wide * 9.0 / 16.0)


def unit(vector: Vector) -> Vector:
    return scaled(vector, 1.0 / math.hypot(*vector))


def is_shown(camera: CameraSetup, point: Iterable[float]) -> bool:
    return max(map(abs, place(camera, point))) <= 1.0


def ends(model: RobotModel, task: str) -> list[Vector]:
    """Places that a task reaches, by the cell's file."""
    cell = model.cell
    assert cell is not None
    assert cell.target is not None
    at = {part.name: part.pose for part in cell.parts}
    standing = [(at[name].x, at[name].y, 0.2 + STANDING) for name in ("platform_1", "platform_2")]
    area, middle = cell.target, cell.target.pose
    corners = [
        (middle.x + side * area.length / 2.0, middle.y + end * area.width / 2.0, 0.0)
        for side in (-1.0, 1.0)
        for end in (-1.0, 1.0)
    ]
    bins = [(pose.x, pose.y, pose.z) for name, pose in at.items() if name.startswith(("servo", "bracket", "tube"))]
    car = (at["car"].x, at["car"].y, at["car"].z)
    return {
        "assemble": [*standing[:1], *bins],
        "step": standing,
        "lift": [*standing[:1], *corners],
        "car": [car, *bins, (1.1, 2.0, 0.1)],
        "demo": [car, *standing, *bins, *corners, (1.1, 2.0, 0.1)],
    }[task]


@pytest.mark.parametrize("task", [*NEEDED, "demo"])
def test_places_that_a_task_reaches_are_in_its_film(model: RobotModel, task: str) -> None:
    camera = camera_of(model, FILMED_BY[task])
    assert [point for point in ends(model, task) if not is_shown(camera, point)] == []


@pytest.mark.parametrize("shift", [(1.5, 0.0, 0.0), (-1.5, 0.0, 0.0), (0.0, 0.0, 0.6), (0.0, 0.0, -0.6)])
def test_a_camera_that_looks_beside_is_found(model: RobotModel, shift: Vector) -> None:
    camera = camera_of(model, "story")
    assert camera.outside is not None
    assert camera.outside.target is not None
    x, y, z = camera.outside.target
    beside = replace(camera, outside=replace(camera.outside, target=(x + shift[0], y + shift[1], z + shift[2])))
    assert not all(is_shown(beside, point) for point in ends(model, "demo"))


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize("task", NEEDED)
def test_all_that_moves_is_in_the_film(model: RobotModel, task: str) -> None:
    camera = camera_of(model, FILMED_BY[task])
    seen: list[np.ndarray] = []

    async def run() -> list[str]:
        async with simulated(SEED) as session:
            robot = session.true._robot
            bodies = [number for number in range(1, robot.model.nbody) if robot.model.body_mass[number] > 0.01]

            async def watch() -> None:
                while True:
                    seen.append(robot.data.xipos[bodies].copy())
                    await session.cell.sleep(PERIOD)

            watching = asyncio.create_task(watch())
            found = await TASKS[task](session, SEED)
            watching.cancel()
            assert found.success, found.failure
            return [str(robot.model.body(number).name) for number in bodies]

    names = asyncio.run(run())
    places = np.array(seen)
    moved = np.flatnonzero(np.linalg.norm(places - places[0], axis=2).max(axis=0) > MOVED)
    assert len(moved) > 5
    cut = {
        names[number]
        for number in moved
        for point in places[:, number]
        if names[number] != "belt" and not is_shown(camera, point)
    }
    assert cut == set()
