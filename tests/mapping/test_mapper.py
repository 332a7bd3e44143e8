"""Scan matching in a room whose walls are known."""

from __future__ import annotations

import math
import tracemalloc

import numpy as np
import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, Points
from jauspy.mapping.mapper import Mapper, locate, match, search

ANGLES = np.linspace(-math.pi, math.pi, 360, endpoint=False)
DEVIATION = (0.1, 0.1)


def ranges(pose: PlanarPose, *, corridor: bool = False) -> list[float]:
    """In a room 8 m long and 5 m wide around the origin; a corridor has no ends."""
    found = []
    for angle in ANGLES + pose.yaw:
        c, s = math.cos(angle), math.sin(angle)
        across = ((2.5 if s > 0 else -2.5) - pose.y) / s if s else math.inf
        along = ((4.0 if c > 0 else -4.0) - pose.x) / c if c and not corridor else math.inf
        found.append(min(across, along))
    return found


def ends(pose: PlanarPose, *, corridor: bool = False) -> Points:
    found = np.array(ranges(pose, corridor=corridor))
    keep = found < 12.0
    return np.column_stack([found[keep] * np.cos(ANGLES[keep]), found[keep] * np.sin(ANGLES[keep])])


def mapped(*, corridor: bool = False) -> OccupancyGrid:
    mapper = Mapper(OccupancyGrid(30.0), matching=False)
    for x in (-1.0, -0.5, 0.0, 0.5, 1.0):
        pose = PlanarPose(x, 0.0, x / 10.0)
        mapper.add(pose, PlanarPose(), ANGLES.tolist(), ranges(pose, corridor=corridor))
    return mapper.grid


@pytest.mark.parametrize("off", [(0.1, 0.0, 0.0), (0.0, -0.1, 0.0), (0.0, 0.0, 0.06), (-0.08, 0.08, -0.05)])
def test_matching_finds_the_pose(off: tuple[float, float, float]) -> None:
    pose = PlanarPose(0.7, 0.4, 0.3)
    found = match(mapped(), ends(pose), pose @ PlanarPose(*off), DEVIATION)
    assert math.hypot(found.x - pose.x, found.y - pose.y) < 0.05, "a cell: the walls lie between two"
    assert abs(found.yaw - pose.yaw) < 0.005


def test_corridor_keeps_the_guess_along_it() -> None:
    pose = PlanarPose(0.7, 0.2, 0.0)
    found = match(mapped(corridor=True), ends(pose, corridor=True), PlanarPose(0.5, 0.28, 0.02), DEVIATION)
    assert found.x == pytest.approx(0.5, abs=0.05)
    assert found.y == pytest.approx(0.2, abs=0.04)
    assert found.yaw == pytest.approx(0.0, abs=0.005)


@pytest.mark.parametrize("slip", [(-0.5, 0.0), (0.7, -0.2), (0.0, 0.6)])
def test_after_a_gap_a_pose_far_off_is_found(slip: tuple[float, float]) -> None:
    """Tracks slip on a kerb, where the scans of the tilted robot are left out."""
    mapper, mapped_at, pose = Mapper(OccupancyGrid(30.0)), PlanarPose(), PlanarPose(1.2, 0.0, 0.0)
    mapper.add(mapped_at, PlanarPose(), ANGLES.tolist(), ranges(mapped_at))
    odometry = PlanarPose(pose.x + slip[0], pose.y + slip[1], pose.yaw)
    found = mapper.add(odometry, PlanarPose(), ANGLES.tolist(), ranges(pose))
    assert math.hypot(found.x - pose.x, found.y - pose.y) < 0.05


def test_a_robot_that_slipped_all_the_way_is_found_where_it_was() -> None:
    before, pose = PlanarPose(0.4, 0.1), PlanarPose(0.5, 0.1)
    found = search(mapped(), ends(pose), PlanarPose(2.3, 0.4), before)
    assert math.hypot(found.x - pose.x, found.y - pose.y) < 0.11, "a step of the search"


def test_corridor_keeps_the_guess_along_it_after_a_gap() -> None:
    pose = PlanarPose(1.5, 0.2, 0.0)
    found = search(mapped(corridor=True), ends(pose, corridor=True), PlanarPose(1.2, 0.5, 0.0), PlanarPose(0.8, 0.5))
    assert found.x == pytest.approx(1.2, abs=0.11), "a step of the search"
    assert found.y == pytest.approx(0.2, abs=0.1)


def test_a_scan_with_few_echoes_is_not_matched() -> None:
    guess = PlanarPose(1.0, 2.0, 0.1)
    assert match(mapped(), ends(PlanarPose())[:10], guess, DEVIATION) == guess


def test_empty_map_keeps_the_guess() -> None:
    guess = PlanarPose(1.0, 2.0, 0.1)
    assert match(OccupancyGrid(30.0), ends(PlanarPose()), guess, DEVIATION) == pytest.approx(guess)


def test_scans_are_added_only_after_some_motion() -> None:
    mapper = Mapper(OccupancyGrid(30.0))
    for step in range(26):
        pose = PlanarPose(step * 0.01)
        mapper.add(pose, PlanarPose(), ANGLES.tolist(), ranges(pose))
    assert len(mapper.path) == 3


@pytest.mark.slow
def test_a_scan_with_more_rays_than_are_useful_costs_no_more() -> None:
    """As many as a message of a robot may have, all 15 m long, would take gigabytes."""
    rays = 65535
    angles = np.linspace(-math.pi, math.pi, rays, endpoint=False).tolist()
    mapper = Mapper(OccupancyGrid(30.0), matching=False)
    tracemalloc.start()
    try:
        mapper.add(PlanarPose(), PlanarPose(), angles, [14.0] * rays)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 300e6
    crossed = np.count_nonzero(mapper.grid.log_odds < 0.0) * 0.05**2
    assert crossed == pytest.approx(math.pi * 14.0**2, rel=0.02), "no cell is left out"


def test_rays_without_a_direction_are_left_out() -> None:
    mapper = Mapper(OccupancyGrid(30.0), matching=False)
    mapper.add(PlanarPose(), PlanarPose(), [math.inf, math.nan, 0.0], [3.0, 3.0, 3.0])
    assert int((mapper.grid.log_odds > 0.0).sum()) == 1


def test_the_robot_is_found_in_a_known_map_near_a_rough_guess() -> None:
    grid, random = mapped(), np.random.default_rng(1)
    for _ in range(20):
        pose = PlanarPose(*random.uniform((-2.0, -1.0, -3.0), (2.0, 1.0, 3.0)).tolist())
        off = PlanarPose(*random.uniform((-0.4, -0.4, -0.3), (0.4, 0.4, 0.3)).tolist())
        found = locate(grid, ends(pose), pose @ off)
        assert math.hypot(found.x - pose.x, found.y - pose.y) < 0.05
        assert abs(math.remainder(found.yaw - pose.yaw, math.tau)) < 0.005


def test_the_first_scan_in_a_known_map_corrects_the_odometry() -> None:
    pose, odometry = PlanarPose(0.7, 0.4, 0.3), PlanarPose(5.0, -2.0, 1.0)
    mapper = Mapper(mapped(), is_known=True, start=PlanarPose(0.5, 0.6, 0.2))
    mapper.add(odometry, PlanarPose(), ANGLES.tolist(), ranges(pose))
    assert tuple(mapper.correction @ odometry) == pytest.approx(tuple(pose), abs=0.05)


@pytest.mark.parametrize(
    ("pose", "guess", "said"),
    [
        (PlanarPose(0.0, 0.0, 1.6), PlanarPose(0.0, -1e-9), "does not fit the map near (0, 0) and 0 degrees"),
        (PlanarPose(), PlanarPose(2.5, 0.0), "does not fit the map"),
        (PlanarPose(), PlanarPose(14.0, 14.0), "does not fit the map near (14, 14)"),
        (PlanarPose(), PlanarPose(900.0, -900.0), "does not fit the map"),
    ],
)
def test_a_wrong_guess_is_told(pose: PlanarPose, guess: PlanarPose, said: str) -> None:
    with pytest.raises(ConfigError) as caught:
        locate(mapped(), ends(pose), guess)
    assert said in str(caught.value)


def test_a_robot_that_sees_little_is_not_found() -> None:
    with pytest.raises(ConfigError, match="sees too little to find the robot in the map"):
        locate(mapped(), ends(PlanarPose())[:10], PlanarPose())
