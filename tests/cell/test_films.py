"""What the cameras of films have in their picture: all places that a task reaches."""

from __future__ import annotations

from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="needs the extra 'sim'")

from tests.helpers.films import camera_of, is_shown

from jauspy.cell.tasks import FILMED_BY
from jauspy.geometry.vectors import Vector
from jauspy.platform.description import RobotModel

NEEDED = ("assemble", "lift", "step", "car")
STANDING = 1.15
"""Metres above a platform that an arm with five joints stands."""


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
