"""The elevation grid on ground whose height is known, with noise of a seed."""

from __future__ import annotations

import math
import tracemalloc
import warnings
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.mapping.elevation import MAX_POINTS, ElevationGrid
from jauspy.mapping.surfaces import fitted_planes, largest_steps

Floats = NDArray[np.float64]
Ground = Callable[[Floats, Floats], Floats]
SENSOR = Transform.from_pose(Pose(0.3, 0.1, 0.5, 0.05, -0.1, 0.4))
NOISE = 0.01


def flat(x: Floats, y: Floats) -> Floats:
    return np.zeros_like(x)


def kerb(x: Floats, y: Floats) -> Floats:
    return np.where(x > 1.0, 0.12, 0.0)


def ramp(x: Floats, y: Floats) -> Floats:
    return 0.2 * np.maximum(0.0, x)


def cloud(ground: Ground, seed: int = 1, count: int = 15_000, sensor: Transform = SENSOR) -> Floats:
    """Points of the ground within 3 m, in the sensor's frame."""
    random = np.random.default_rng(seed)
    x, y = random.uniform(-3.0, 3.0, (2, count))
    points = np.column_stack([x, y, ground(x, y) + random.normal(0.0, NOISE, count)])
    return in_frame(points, sensor)


def in_frame(points: Floats, sensor: Transform = SENSOR) -> Floats:
    inner: Floats = (points - np.array(sensor.position)) @ np.array(sensor.rotation)
    return inner


def made(ground: Ground, clouds: int = 3) -> ElevationGrid:
    grid = ElevationGrid(8.0, 0.1)
    for seed in range(clouds):
        grid.add(cloud(ground, seed), SENSOR, seed / 10.0)
    return grid


def errors(grid: ElevationGrid, ground: Ground) -> Floats:
    """Errors of the known cells away from edges."""
    left, low = grid.origin
    x, y = np.meshgrid(*(edge + (np.arange(grid.cells) + 0.5) * grid.resolution for edge in (left, low)))
    used = np.isfinite(grid.heights) & (np.abs(x - 1.0) > 0.15)
    found: Floats = np.abs(grid.heights - ground(x, y))[used]
    return found


@pytest.mark.parametrize("ground", [flat, kerb, ramp])
def test_heights_are_those_of_the_ground(ground: Ground) -> None:
    grid = made(ground)
    assert np.percentile(errors(grid, ground), 95) < 0.02
    assert np.isfinite(grid.heights).sum() > 3000
    assert grid.heights.dtype == np.float32
    assert grid.stamp == pytest.approx(0.2)


@pytest.mark.parametrize(
    "wrong",
    [
        Transform(),
        Transform(SENSOR.rotation, (0.3, 0.1, 0.6)),
        Transform.from_pose(Pose(0.3, 0.1, 0.5, 0.05, 0.0, 0.4)),
        SENSOR.inverse(),
    ],
    ids=["no pose", "10 cm too high", "6 degrees of pitch", "inverse"],
)
def test_a_wrong_pose_of_the_sensor_is_seen_in_the_heights(wrong: Transform) -> None:
    grid = ElevationGrid(8.0, 0.1)
    for seed in range(3):
        grid.add(cloud(kerb, seed), wrong, seed / 10.0)
    found = errors(grid, kerb)
    assert not len(found) or np.percentile(found, 95) > 0.05


@pytest.mark.parametrize("turn", [(0.0, 0.02), (0.025, 0.0), (-0.02, 0.015)])
def test_a_tilt_that_is_measured_wrong_makes_no_steps(turn: tuple[float, float]) -> None:
    """A cloud of which the pose is tilted, after those with the right pose: it would raise ground by 8 cm at 3 m."""
    grid = made(kerb)
    wrong = SENSOR @ Transform.from_pose(Pose(0.0, 0.0, 0.0, *turn, 0.0))
    for seed in range(3, 6):
        grid.add(cloud(kerb, seed), wrong, seed / 10.0)
    assert np.nanmax(np.abs(errors(grid, kerb))) < 0.035
    assert grid.counters["tilted"] == 0


def test_a_strip_of_known_ground_does_not_tilt_what_lies_behind() -> None:
    """As of a corridor, when a door comes into view: an error along 0.3 m would be ten times that in the room."""
    level = Transform.from_pose(Pose(0.0, 0.0, 0.5))
    grid = ElevationGrid(12.0, 0.1)
    random = np.random.default_rng(4)
    strip = np.column_stack([random.uniform(0.6, 0.9, 600), random.uniform(-0.5, 0.5, 600), np.zeros(600)])
    raised = strip + np.column_stack([np.zeros((600, 2)), 0.05 * (strip[:, 0] - 0.75)])
    for number in range(3):
        grid.add(in_frame(raised, level), level, number / 10.0)
    floor = np.column_stack([random.uniform(2.0, 4.0, 3000), random.uniform(-1.0, 1.0, 3000), np.zeros(3000)])
    grid.add(in_frame(np.concatenate([strip, floor]), level), level, 0.3)
    grid.add(in_frame(np.concatenate([strip, floor]), level), level, 0.4)
    left, low = grid.origin
    room = grid.heights[
        round((-0.8 - low) / 0.1) : round((0.8 - low) / 0.1), round((2.2 - left) / 0.1) : round((3.8 - left) / 0.1)
    ]
    assert np.nanmax(np.abs(room)) < 0.04


def shifted(x: float, up: float = 0.0) -> Transform:
    """The sensor so many metres farther along x, with a pose that is `up` metres too high."""
    return Transform.from_pose(Pose(x, 0.0, up)) @ SENSOR


@pytest.mark.parametrize("up", [0.08, -0.15, 0.25])
@pytest.mark.parametrize("ground", [flat, kerb])
def test_a_height_that_is_off_since_an_edge_makes_no_steps(ground: Ground, up: float) -> None:
    """Tracks that slipped at a kerb ran on, up or down, while the robot was tilted."""
    grid = made(ground)
    for seed in range(3, 6):
        grid.add(cloud(ground, seed), shifted(0.0, up), seed / 10.0, has_tipped=seed == 3)
    assert np.percentile(errors(grid, ground), 99) < 0.03
    grid.add_footprint(Transform.from_pose(Pose(3.5, 3.5, up)), (0.4, 0.4), 0.0, 1.0)
    assert grid.height_at(3.5, 3.5) == pytest.approx(0.0, abs=0.03)
    without = made(ground)
    for seed in range(3, 6):
        without.add(cloud(ground, seed), shifted(0.0, up), seed / 10.0)
    assert np.percentile(errors(without, ground), 99) > 0.05


def test_ground_that_nothing_agrees_with_tells_no_height() -> None:
    grid = made(flat)
    grid.add(cloud(ramp, 9), shifted(0.0, 0.1), 1.0, has_tipped=True)
    assert abs(grid._rise) < 0.12
    empty = ElevationGrid(8.0, 0.1)
    empty.add(cloud(flat), shifted(0.0, 0.2), 0.0, has_tipped=True)
    assert empty._rise == 0.0


@pytest.mark.parametrize(("kept_way", "is_forgotten"), [(6.0, True), (math.inf, False)])
def test_ground_that_was_seen_long_ago_on_the_way_is_forgotten(kept_way: float, is_forgotten: bool) -> None:
    """Poses drift by centimetres in ten metres: ground that is seen again would be a step beside older ground."""
    grid = ElevationGrid(40.0, 0.1, kept_way=kept_way)
    grid.add(cloud(flat, 0, 30_000), SENSOR, 0.0)
    known = np.isfinite(grid.heights).sum()
    assert known > 2000
    for number in range(1, 13):
        grid.add(np.empty((0, 3)), shifted(0.4 * number), float(number))
    assert np.isfinite(grid.heights).sum() == known, "it is not so long"
    for number in range(13, 18):
        grid.add(np.empty((0, 3)), shifted(0.4 * number), float(number))
    assert bool(np.isnan(grid.heights).all()) is is_forgotten


def test_a_robot_that_stands_forgets_nothing() -> None:
    grid = ElevationGrid(8.0, 0.1, kept_way=6.0)
    for seed in range(3):
        grid.add(cloud(flat, seed), SENSOR, seed / 10.0)
    before = grid.heights.copy()
    for number in range(100):
        grid.add(np.empty((0, 3)), shifted(0.2 * (number % 2)), 1.0 + number)
    assert np.array_equal(grid.heights, before, equal_nan=True)


def test_cells_that_were_approached_and_not_seen_are_hidden_also_when_the_grid_moves() -> None:
    grid = ElevationGrid(12.0, 0.1)
    for number in range(11):
        grid.add(np.empty((0, 3)), shifted(0.4 * number), float(number))
    left, low = grid.ground.origin
    ys, xs = (np.indices(grid.ground.hidden.shape) + 0.5) * 0.1
    xs, ys = xs + left, ys + low
    start, end = (np.array(shifted(x).position) for x in (0.0, 4.0))
    assert left > -6.0, "it has moved"
    for place in (start, end):
        assert grid.ground.hidden[np.hypot(xs - place[0], ys - place[1]) < 2.8].all()
    beyond = np.hypot(ys - end[1], np.clip(xs, start[0], end[0]) - xs) > 3.1
    assert not grid.ground.hidden[beyond].any()


def test_ground_that_was_seen_and_forgotten_is_not_hidden() -> None:
    grid = ElevationGrid(12.0, 0.1, kept_way=2.0)
    for seed in range(3):
        grid.add(cloud(flat, seed, 30_000), SENSOR, 0.1 * seed)
    known = np.isfinite(grid.ground.heights)
    assert known.any()
    assert not grid.ground.hidden[known].any()
    for number in range(1, 8):
        grid.add(np.empty((0, 3)), shifted(0.5 * (number % 2)), float(number))
    assert np.isnan(grid.ground.heights).all()
    assert not grid.ground.hidden[known].any()


def test_a_tilt_that_is_measured_wrong_at_first_is_corrected_by_what_comes_after() -> None:
    grid = ElevationGrid(8.0, 0.1)
    grid.add(cloud(flat, 0), SENSOR @ Transform.from_pose(Pose(pitch=0.03)), 0.0)
    assert np.quantile(errors(grid, flat), 0.9) > 0.06
    for seed in range(1, 25):
        grid.add(cloud(flat, seed), SENSOR, seed / 2.0)
    assert np.quantile(errors(grid, flat), 0.99) < 0.02  # at the border are cells that only the first cloud had


def test_what_is_new_on_the_ground_is_not_taken_for_a_tilt() -> None:
    grid = made(flat)
    for seed in range(3, 6):
        grid.add(cloud(kerb, seed), SENSOR, seed / 10.0)
    assert np.nanmax(np.abs(errors(grid, kerb))) < 0.035


def test_a_tilt_beyond_what_sensors_err_by_is_counted_and_left_as_measured() -> None:
    grid = made(flat)
    grid.add(cloud(flat, 3), SENSOR @ Transform.from_pose(Pose(pitch=0.1)), 0.3)
    assert grid.counters["tilted"] == 1


def test_slope_step_and_roughness() -> None:
    slope, step = made(ramp), made(kerb)
    column = round((1.5 - slope.origin[0]) / 0.1)
    middle = np.s_[30:50, column]
    assert np.median(slope.slopes()[middle]) == pytest.approx(math.atan(0.2), abs=0.02)
    assert np.median(slope.roughness()[middle]) < 0.01
    assert np.nanmax(slope.steps()[middle]) < 0.06
    edge = round((1.0 - step.origin[0]) / 0.1)
    assert step.steps()[30:50, edge - 1 : edge + 1].max(axis=1) == pytest.approx(np.full(20, 0.12), abs=0.03)
    assert np.nanpercentile(step.steps()[30:50, edge + 3 : edge + 9], 95) < 0.04
    assert np.median(step.roughness()[30:50, edge]) > 0.02


@pytest.mark.parametrize("height", [0.08, 0.1])
def test_the_edge_of_a_step_is_in_one_cell(height: float) -> None:
    """Also where its lower and its upper ground are in two layers of voxels above each other."""
    grid = made(lambda x, y: np.where(x > 1.05, height, 0.0))
    beside = [grid.height_at(x, 0.5) for x in (0.95, 1.05, 1.15)]
    assert beside == pytest.approx([0.0, height, height], abs=0.02)


def test_ceilings_and_what_the_robot_fits_under_are_not_ground() -> None:
    random = np.random.default_rng(7)
    x, y = random.uniform(-3.0, 3.0, (2, 15_000))
    above = np.concatenate([np.column_stack([x, y, np.full_like(x, height)]) for height in (0.9, 2.4)])
    grid = ElevationGrid(8.0, 0.1, clearance=0.6)
    for seed in range(3):
        grid.add(np.concatenate([cloud(flat, seed), in_frame(above)]), SENSOR, seed / 10.0)
    assert np.percentile(errors(grid, flat), 95) < 0.02


def test_a_board_too_low_to_drive_under_is_an_obstacle() -> None:
    random = np.random.default_rng(7)
    board = np.column_stack([random.uniform(1.5, 2.0, 2000), random.uniform(-0.5, 0.5, 2000), np.full(2000, 0.35)])
    grid = ElevationGrid(8.0, 0.1, clearance=0.6)
    for seed in range(3):
        grid.add(np.concatenate([cloud(flat, seed), in_frame(board)]), SENSOR, seed / 10.0)
    assert grid.height_at(1.75, 0.0) == pytest.approx(0.35, abs=0.03)
    assert grid.height_at(1.75, 1.0) == pytest.approx(0.0, abs=0.03)


def test_a_crate_that_moved_away_is_forgotten_and_one_that_came_is_seen() -> None:
    grid = made(flat)
    crate = lambda x, y: np.where((np.abs(x - 1.7) < 0.3) & (np.abs(y) < 0.3), 0.4, 0.0)  # noqa: E731
    for seed in range(3):
        grid.add(cloud(crate, seed), SENSOR, 1.0 + seed / 10.0)
    assert grid.height_at(1.7, 0.0) == pytest.approx(0.4, abs=0.03)
    for seed in range(15):
        grid.add(cloud(flat, seed), SENSOR, 2.0 + seed / 10.0)
    assert grid.height_at(1.7, 0.0) == pytest.approx(0.0, abs=0.03)


def test_drift_of_the_height_is_followed() -> None:
    grid = made(flat)
    for seed in range(10):
        grid.add(cloud(lambda x, y: np.full_like(x, 0.08), seed), SENSOR, 1.0)
    assert np.nanmedian(grid.heights) == pytest.approx(0.08, abs=0.01)
    for seed in range(10):
        grid.add(cloud(flat, seed), SENSOR, 1.0)
    assert np.nanmedian(grid.heights) == pytest.approx(0.0, abs=0.02)


def test_the_grid_moves_with_the_sensor_and_keeps_what_it_covers() -> None:
    grid = made(kerb)
    before = grid.height_at(1.55, 0.35)
    moved = Transform(SENSOR.rotation, (2.3, 0.1, 0.5))
    grid.add(np.empty((0, 3)), moved, 1.0)
    assert grid.origin == pytest.approx((2.3 - 4.0, 0.1 - 4.0), abs=0.1001)
    assert grid.height_at(1.55, 0.35) == before
    assert math.isnan(grid.height_at(-2.0, 0.0)), "it is outside now"
    grid.add(np.empty((0, 3)), Transform(SENSOR.rotation, (2.3, 0.1, 1.4)), 1.0)
    assert grid.height_at(1.55, 0.35) == pytest.approx(before, abs=1e-5), "the columns moved up"
    grid.add(np.empty((0, 3)), Transform(SENSOR.rotation, (500.0, 0.1, 0.5)), 1.0)
    assert np.isnan(grid.heights).all()
    assert grid.heights.shape == (80, 80)


def test_ages_are_those_of_the_cells() -> None:
    grid = made(flat)
    half = cloud(flat, 9, 30_000)
    outer = half @ np.array(SENSOR.rotation).T + np.array(SENSOR.position)
    grid.add(half[outer[:, 0] > 0.0], SENSOR, 5.0)
    ages = grid.ages(6.0)
    column = round(-grid.origin[0] / grid.resolution)
    assert np.nanmedian(ages[:, column + 2 : column + 28]) == pytest.approx(1.0)
    assert np.nanmin(ages[:, : column - 1]) == pytest.approx(5.8)
    assert np.isnan(ages).any()


def test_the_ground_below_the_robot_is_known_until_it_is_seen() -> None:
    grid = ElevationGrid(8.0, 0.1)
    base = Transform.from_pose(Pose(0.0, 0.0, 0.3, 0.0, 0.0, 0.5))
    grid.add_footprint(base, (0.7, 0.5), 0.1, 0.0)
    assert grid.height_at(0.0, 0.0) == pytest.approx(0.2, abs=1e-3)
    assert np.isfinite(grid.heights).sum() == pytest.approx(0.7 * 0.5 / 0.1**2, abs=25)
    seen = made(flat)
    before = seen.heights.copy()
    seen.add_footprint(base, (0.7, 0.5), 0.1, 1.0)
    assert seen.height_at(0.0, 0.0) == pytest.approx(0.0, abs=0.02)
    assert np.nanmax(np.abs(seen.heights - before)) < 1e-6


HOSTILE = [
    np.empty((0, 3)),
    np.full((100, 3), np.nan),
    np.full((100, 3), np.inf, np.float32),
    np.full((100, 3), 3e38, np.float32),
    np.full((100, 3), 1e300),
    np.zeros((100, 3)),
    np.full((100, 3), -1e-300),
]


@pytest.mark.parametrize("points", HOSTILE)
def test_hostile_clouds_change_nothing_that_is_known(points: Floats) -> None:
    grid = made(flat)
    before = grid.heights.copy()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        grid.add(points, SENSOR, 1.0)
    known = np.isfinite(before)
    assert np.isfinite(grid.heights[known]).all()
    assert np.count_nonzero(np.abs(grid.heights - before)[known] > 0.02) <= 1, "at most the cell of the sensor"


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_a_cloud_without_a_pose_or_a_time_is_dropped_and_counted(value: float) -> None:
    grid = made(flat)
    before = grid.heights.copy()
    assert grid.add(cloud(kerb), Transform(SENSOR.rotation, (value, 0.0, 0.0)), 1.0) == 0
    assert grid.add(cloud(kerb), SENSOR, value) == 0
    grid.add_footprint(Transform(SENSOR.rotation, (value, 0.0, 0.0)), (0.7, 0.5), 0.1, 1.0)
    assert grid.counters["no pose"] == 3
    assert np.array_equal(grid.heights, before, equal_nan=True)


def test_a_pose_far_away_is_no_overflow() -> None:
    grid = made(flat)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert grid.add(cloud(flat), Transform(SENSOR.rotation, (1e30, -1e30, 1e30)), 1.0) == 0
        grid.add(np.empty((0, 3)), Transform(SENSOR.rotation, (9e6, -9e6, 9e6)), 1.0)
    assert np.isnan(grid.heights).all()
    assert math.isnan(grid.height_at(math.nan, 0.0))
    assert math.isnan(grid.height_at(1e30, 0.0))


def test_memory_is_bounded_for_a_huge_cloud() -> None:
    grid = ElevationGrid(12.0, 0.1)
    points = np.random.default_rng(0).uniform(-5.0, 5.0, (1_000_000, 3)).astype(np.float32)
    tracemalloc.start()
    try:
        used = grid.add(points, SENSOR, 0.0)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert 0 < used <= MAX_POINTS
    assert peak < 80e6


@pytest.mark.parametrize(("size", "resolution"), [(100.0, 0.01), (0.1, 0.1)])
def test_size_is_bounded(size: float, resolution: float) -> None:
    with pytest.raises(ConfigError, match=r"cells along a side; an elevation grid has 4\.\.400"):
        ElevationGrid(size, resolution)


def test_an_empty_grid_knows_nothing() -> None:
    grid = ElevationGrid(4.0, 0.1)
    for values in (grid.heights, grid.slopes(), grid.steps(), grid.roughness(), grid.ages(1.0)):
        assert values.shape == (40, 40)
        assert np.isnan(values).all()
    assert math.isnan(grid.stamp)
    assert grid.origin == pytest.approx((-2.0, -2.0))


def test_planes_need_cells_on_more_than_one_line() -> None:
    heights = np.full((20, 20), np.nan, np.float32)
    heights[10, :] = 0.3
    assert np.isnan(fitted_planes(heights, 0.1, 0.3)[0]).all()
    heights[9:12, :] = 0.3
    assert fitted_planes(heights, 0.1, 0.3)[0][10, 10] == pytest.approx(0.0, abs=1e-6)


def test_steps_of_known_neighbours_only() -> None:
    heights = np.full((3, 3), np.nan, np.float32)
    heights[1, 1] = 1.0
    assert np.isnan(largest_steps(heights)).all()
    heights[0, 0] = 0.25
    assert largest_steps(heights)[1, 1] == pytest.approx(0.75)
    assert largest_steps(heights)[0, 0] == pytest.approx(0.75)
