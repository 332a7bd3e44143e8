"""Scenes of a robot in MuJoCo beside the true shapes of its world: what is seen, the own body, motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import numpy as np
from scipy.spatial import cKDTree
from tests.helpers.sighted import (
    CAMERA,
    FLOOR,
    LIDAR,
    OBSTACLES,
    Sighted,
    camera_rays,
    lidar_rays,
    write_world,
)

from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.link_looks import link_looks
from jauspy.planning.own_body import OwnBody
from jauspy.planning.scene import Scene, SceneSetup

VOXEL = SceneSetup().voxel_size
HALF_DIAGONAL = VOXEL * math.sqrt(3.0) / 2.0
ARM_CAMERA = "arm_camera_link"
RAYS = camera_rays(200, 125)


@pytest.fixture
def yard(tmp_path: Path) -> Iterator[Sighted]:
    opened = Sighted(write_world(tmp_path, OBSTACLES))
    yield opened
    opened.close()


@pytest.fixture
def hall(tmp_path: Path) -> Iterator[Sighted]:
    opened = Sighted(write_world(tmp_path, FLOOR))
    yield opened
    opened.close()


def in_world(robot: Sighted, scene: Scene) -> Any:
    """The voxels, where they are in the world."""
    voxels = scene.obstacles().voxels
    return voxels @ np.array(robot.base.rotation).T + np.array(robot.base.position)


def visible(robot: Sighted, reach: float) -> Any:
    """Points of the world that the camera sees, by other rays than those of its clouds."""
    points, _ = robot.look(CAMERA, camera_rays(61, 37))
    found = robot.in_world(CAMERA, points[np.linalg.norm(points, axis=1) < reach])
    return found[robot.distances(found) < 1e-3]


def recall(robot: Sighted, scene: Scene, reach: float = 3.0) -> float:
    """The part of the surface in view that has a voxel."""
    return float((cKDTree(in_world(robot, scene)).query(visible(robot, reach))[0] <= HALF_DIAGONAL).mean())


@pytest.mark.slow
def test_surfaces_in_view_are_voxels_and_nothing_else_is(yard: Sighted) -> None:
    scene = Scene(yard.description)
    for number in range(16):
        yard.place(-1.5 + 0.1 * number, 0.0, 0.0)
        scene.add(yard.sweep(CAMERA, 0.2 * number, RAYS))
        scene.add(yard.sweep(LIDAR, 0.2 * number, lidar_rays()))
    assert recall(yard, scene) >= 0.98
    errors = yard.distances(in_world(yard, scene))
    assert len(errors) > 5000
    assert errors.max() <= HALF_DIAGONAL + 1e-6, "each voxel holds a point of a surface"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["crate", "ball", "table"])
def test_what_is_taken_away_vanishes_within_four_sweeps_and_nothing_else(yard: Sighted, name: str) -> None:
    scene = Scene(yard.description)
    for number in range(10):
        scene.add(yard.sweep(CAMERA, 0.1 * number, RAYS))
    yard.hide(name)
    before = int((yard.distances(in_world(yard, scene)) > VOXEL).sum())
    assert before > 10
    for number in range(10, 14):
        scene.add(yard.sweep(CAMERA, 0.1 * number, RAYS))
    # a few voxels of the table are beside the post, which hides them in part
    left = int((yard.distances(in_world(yard, scene)) > VOXEL).sum())
    assert left <= (0.05 * before if name == "table" else 0)
    assert recall(yard, scene, 2.0) >= 0.98


def drive(robot: Sighted, believed: Callable[[float], Transform]) -> Any:
    """Errors of voxels after 3 m along the obstacles; the robot `believed` to be elsewhere after so many metres."""
    scene = Scene(robot.description)
    for number in range(16):
        way = 0.2 * number
        robot.place(-2.0 + way, 0.0, 0.0)
        scene.add(robot.sweep(CAMERA, 0.4 * number, RAYS, base=believed(way)))
    return robot.distances(in_world(robot, scene))


@pytest.mark.slow
def test_driving_3_m_does_not_smear(yard: Sighted) -> None:
    exact = drive(yard, lambda way: Transform.from_pose(Pose(x=-2.0 + way)))
    assert exact.max() <= HALF_DIAGONAL + 1e-6
    # odometry that is 1 % too long, and turns by 0.5 degrees on the way
    drifting = drive(
        yard, lambda way: Transform.from_pose(Pose(x=-2.0 + 1.01 * way, yaw=math.radians(0.5) * way / 3.0))
    )
    assert np.median(drifting) <= VOXEL / 2.0
    assert np.quantile(drifting, 0.99) <= 2.0 * VOXEL
    # a mutant: voxels that ride on the base, as if it stood still, are smeared by the whole way
    smeared = drive(yard, lambda _: Transform.from_pose(Pose(x=-2.0)))
    assert np.quantile(smeared, 0.99) > 3.0 * VOXEL


def swept(robot: Sighted, scene: Scene, believed: Callable[[Sighted], list[dict[str, float]]]) -> int:
    """Most voxels above the floor while the arm sweeps; there is nothing but the robot."""
    goals = [(0.0, 0.65, -1.29, -0.41, 0.0), (1.2, 1.7, -1.4, -0.5, 0.5), (-1.2, 0.65, -1.29, -0.41, 1.0)]
    names = [name for name in robot.positions if "arm_link" in name]
    before, most, time = [robot.positions[name] for name in names], 0, 0.0
    rays = camera_rays(80, 50)
    for goal in goals:
        for part in np.linspace(0.0, 1.0, 6):
            at = [one + part * (other - one) for one, other in zip(before, goal, strict=True)]
            robot.move(dict(zip(names, at, strict=True)))
            time += 0.1
            for link in (CAMERA, ARM_CAMERA):
                scene.add(robot.sweep(link, time, rays, postures=believed(robot)))
            scene.add(robot.sweep(LIDAR, time, lidar_rays(), postures=believed(robot)))
            most = max(most, int((in_world(robot, scene)[:, 2] > 0.09).sum()))
        before = list(goal)
    return most


@pytest.mark.slow
def test_the_own_body_never_appears_while_the_arm_sweeps(hall: Sighted) -> None:
    assert swept(hall, Scene(hall.description), lambda robot: [robot.positions]) == 0


@pytest.mark.slow
def test_mutants_of_the_filter_of_the_body_are_caught(hall: Sighted) -> None:
    start = dict(hall.positions)
    assert swept(hall, Scene(None), lambda _: []) > 50, "filter off"
    assert swept(hall, Scene(hall.description), lambda _: [start]) > 20, "positions of the start"
    reversed_yaw = "base_link_to_arm_link_1"
    assert (
        swept(hall, Scene(hall.description), lambda r: [{**r.positions, reversed_yaw: -r.positions[reversed_yaw]}]) > 20
    )


@pytest.mark.slow
def test_the_body_has_all_links_with_a_shape(hall: Sighted) -> None:
    body = OwnBody(hall.description, 0.05)
    assert body.unread == []
    assert set(body.without_shape) <= {"arm_camera_link", "chassis_camera_link", "lidar_link", "tool_link"}


@pytest.mark.slow
def test_the_looks_of_links_are_filtered_out_beyond_their_boxes(hall: Sighted) -> None:
    body = OwnBody(hall.description, 0.02)
    look = next(one for one in link_looks(hall.description.urdf, 0.0)[0] if one.link == "arm_link_4")
    cells = look.low + (np.argwhere(look.filled) + 0.5) * look.cell
    turn, place = body.frame("arm_link_4", hall.positions)
    points = cells @ turn.T + place
    assert body.contains(points, [hall.positions]).all()
    assert not body.contains(points, [hall.positions], 0.02).all(), "the wrist looks larger than its box"
    assert not body.contains(points + np.array((0.0, 0.0, 1.0)), [hall.positions]).any()
