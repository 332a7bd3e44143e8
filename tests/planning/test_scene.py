"""Scenes of analytic sensors: time, motion, primitives, unknown space and wrong input."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.obstacles import Box, Cylinder, Sphere
from jauspy.planning.scene import MAX_PRIMITIVES, MAX_SENSORS, Frame, Scene, SceneSetup, Sweep, Unknown

SMALL = SceneSetup(voxel_size=0.05, size=(4.0, 4.0, 1.6), gain=10.0, keep=30.0, loss=10.0)
MOUNT = Transform(position=(0.0, 0.0, 0.5))


def wall(distance: float, half: float = 0.3) -> np.ndarray:
    """Points on a wall ahead of a sensor."""
    side = np.arange(-half, half + 1e-9, 0.01)
    y, z = np.meshgrid(side, side)
    return np.stack((np.full(y.size, distance), y.ravel(), z.ravel()), axis=1)


def sweep(points: np.ndarray, time: float = 0.0, base: Pose = Pose(), **more: object) -> Sweep:  # noqa: B008
    return Sweep("camera", points, MOUNT, Transform.from_pose(base), time, **more)  # type: ignore[arg-type]


def test_what_is_seen_is_an_obstacle_in_the_frame_of_the_base() -> None:
    scene = Scene(setup=SMALL)
    assert scene.add(sweep(wall(1.0)))
    found = scene.obstacles()
    assert found.voxel_size == 0.05
    assert 144 <= len(found.voxels) <= 2 * 169
    assert np.abs(found.voxels[:, 0] - 1.0).max() <= 0.026
    assert found.voxels[:, 2].mean() == pytest.approx(0.5, abs=0.04)
    assert scene.summary().sweeps == {"camera": 1}


def test_a_thing_that_was_taken_away_vanishes_when_what_is_behind_is_seen() -> None:
    scene = Scene(setup=SMALL)
    for number in range(10):
        scene.add(sweep(wall(1.0), 0.1 * number))
    for number in range(10, 14):
        scene.add(sweep(wall(1.8, 0.6), 0.1 * number))
    assert (scene.obstacles().voxels[:, 0] > 1.5).all()


def test_a_thing_that_is_hidden_stays_and_fades_with_age() -> None:
    scene = Scene(setup=SMALL)
    for number in range(10):
        scene.add(sweep(wall(1.0), 0.1 * number))
    for number in range(10, 20):
        scene.add(sweep(wall(0.6), 0.1 * number))
    assert (scene.obstacles().voxels[:, 0] > 0.9).any(), "what is nearer hides it"
    assert (scene.obstacles(30.5).voxels[:, 0] > 0.9).any()
    assert not (scene.obstacles(31.0).voxels[:, 0] > 0.9).any(), "30 s after its last hit"


def test_a_thing_stands_still_while_the_robot_turns_and_drives() -> None:
    scene = Scene(setup=SMALL)
    scene.add(sweep(wall(1.0)))
    scene.move(Transform.from_pose(Pose(x=0.5, y=0.2, yaw=math.pi / 2)), 0.1)
    middle = scene.obstacles().voxels.mean(axis=0)
    assert middle == pytest.approx((-0.2, -0.5, 0.5), abs=0.04)


def test_a_pose_or_a_clock_that_is_set_begins_a_new_scene() -> None:
    scene = Scene(setup=SMALL)
    scene.add(sweep(wall(1.0), 100.0))
    scene.add(sweep(wall(1.0)[:1], 100.1, Pose(x=1.6)))
    assert len(scene.obstacles().voxels) == 1
    scene.add(sweep(wall(1.0)[:1], 100.2, Pose(x=1.6, yaw=2.0)))
    assert len(scene.obstacles().voxels) == 1
    scene.add(sweep(wall(1.2)[:1], 3.0, Pose(x=1.6, yaw=2.0)))
    assert len(scene.obstacles().voxels) == 1
    assert scene.counters == {"scene cleared: the pose jumped": 2, "scene cleared: the clock went back": 1}


def test_unknown_space_is_forbidden_by_choice() -> None:
    free = Scene(setup=SMALL)
    careful = Scene(setup=dataclasses.replace(SMALL, unknown=Unknown.FORBIDDEN, unknown_reach=1.2))
    for scene in (free, careful):
        scene.add(sweep(wall(1.0)))
    assert free.summary().unknown == 0
    more = careful.obstacles().voxels
    assert len(more) > len(free.obstacles().voxels) + 100
    seen = (np.abs(more - (0.5, 0.0, 0.5)) < 0.06).all(axis=1)
    assert not seen.any(), "between sensor and wall it is free"
    behind = (np.abs(more - (1.06, 0.0, 0.5)) < 0.06).all(axis=1)
    assert behind.any(), "behind the wall nobody knows"


def test_rays_without_an_echo_free_what_they_pass() -> None:
    scene = Scene(setup=SMALL)
    scene.add(sweep(wall(1.0)))
    for number in range(1, 6):
        scene.add(sweep(np.empty((0, 3)), 0.1 * number, empty=3.0 * wall(1.0)))
    assert not len(scene.obstacles().voxels)


def test_primitives_stand_in_the_world_or_ride_on_the_robot() -> None:
    scene = Scene(setup=SMALL)
    scene.put(Box(Transform(position=(1.0, 0.0, 0.4)), (0.5, 1.0, 0.05), "table"))
    scene.put(Sphere(Transform(position=(0.2, 0.0, 0.3)), 0.1, "lamp"), Frame.BASE)
    scene.put(Cylinder(Transform(position=(5.0, 0.0, 0.0)), 0.1, 1.0, "post"), within=Frame.LOCAL)
    scene.add(sweep(wall(1.0), 0.0, Pose(x=1.0)))
    places = {each.name: each.pose.position for each in scene.obstacles().primitives}
    assert places == {"table": (0.0, 0.0, 0.4), "lamp": (0.2, 0.0, 0.3), "post": (4.0, 0.0, 0.0)}
    scene.put(Box(Transform(position=(1.0, 0.0, 0.4)), (0.5, 1.0, 0.05), "table"))
    assert dict(places, table=(1.0, 0.0, 0.4)) == {p.name: p.pose.position for p in scene.obstacles().primitives}
    scene.take_away("lamp")
    scene.clear()
    assert [each.name for each in scene.obstacles().primitives] == ["table", "post"]


def test_wrong_primitives_and_sizes_are_told() -> None:
    scene = Scene(setup=SMALL)
    with pytest.raises(ConfigError, match="ball: positions and sizes are finite numbers"):
        scene.put(Sphere(Transform(), math.nan, "ball"))
    for number in range(MAX_PRIMITIVES):
        scene.put(Sphere(Transform(), 0.1, f"ball {number}"))
    with pytest.raises(ConfigError, match="one more: a scene has 1000 primitives at most"):
        scene.put(Sphere(Transform(), 0.1, "one more"))
    with pytest.raises(ConfigError, match="numbers greater than 0"):
        SceneSetup(voxel_size=math.nan)
    with pytest.raises(ConfigError, match="16,000,000 at most"):
        Scene(setup=SceneSetup(voxel_size=0.001))


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        ({"time": math.nan}, "sweep without a time"),
        ({"base": Transform(position=(math.inf, 0.0, 0.0))}, "sweep without a pose"),
        ({"mount": Transform(rotation=((math.nan,) * 3,) * 3)}, "sweep without a pose"),
        ({"points": np.zeros((4, 2))}, "sweep without points"),
        ({"points": np.zeros(12)}, "sweep without points"),
    ],
)
def test_sweeps_that_make_no_sense_are_counted(wrong: dict[str, object], reason: str) -> None:
    scene = Scene(setup=SMALL)
    assert not scene.add(dataclasses.replace(sweep(wall(1.0)), **wrong))
    assert scene.counters == {reason: 1}
    assert not len(scene.obstacles().voxels)


def test_sensors_without_end_are_not_counted_without_end() -> None:
    scene = Scene(setup=SMALL)
    for number in range(MAX_SENSORS + 5):
        scene.add(dataclasses.replace(sweep(wall(1.0)[:5]), sensor=f"sensor {number}"))
    assert len(scene.summary().sweeps) == MAX_SENSORS
    assert scene.counters == {"sweep of one sensor too many": 5}
