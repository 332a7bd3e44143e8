"""The occupancy grid: what rays say about cells."""

from __future__ import annotations

import numpy as np
import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, transformed

START = np.zeros(2)


def cell(grid: OccupancyGrid, x: float, y: float) -> int:
    column, row = np.round(grid.cell_coordinates(np.array([[x, y]]))).astype(int)[0]
    return int(grid.occupancy()[row, column])


def test_ray_clears_crossed_cells_and_marks_its_end() -> None:
    grid = OccupancyGrid(10.0, 0.1)
    for _ in range(5):
        grid.add(START, np.array([[2.05, 1.05]]), np.array([True]))
    assert cell(grid, 2.05, 1.05) == 100
    assert cell(grid, 0.95, 0.48) == 0
    assert cell(grid, 2.25, 1.15) == -1, "behind it nothing is known"
    assert cell(grid, 1.05, 2.05) == -1, "rows are y"


def test_ray_without_echo_only_clears() -> None:
    grid = OccupancyGrid(10.0, 0.1)
    for _ in range(5):
        grid.add(START, np.array([[2.05, 1.05]]), np.array([False]))
    assert cell(grid, 1.9, 0.95) == 0
    assert not (grid.occupancy() == 100).any()


def test_an_obstacle_that_moved_away_is_cleared() -> None:
    grid = OccupancyGrid(10.0, 0.1)
    for _ in range(50):
        grid.add(START, np.array([[2.05, 0.05]]), np.array([True]))
    for _ in range(30):
        grid.add(START, np.array([[4.05, 0.05]]), np.array([True]))
    assert cell(grid, 2.05, 0.05) == 0


def test_points_outside_are_counted() -> None:
    grid = OccupancyGrid(4.0, 0.1)
    grid.add(START, np.array([[3.0, 0.0], [1.0, 0.0]]), np.array([True, True]))
    assert grid.outside == 1
    assert grid.log_odds.shape == (40, 40)


@pytest.mark.parametrize(("size", "resolution"), [(1000.0, 0.01), (0.01, 0.05)])
def test_grid_size_is_bounded(size: float, resolution: float) -> None:
    with pytest.raises(ConfigError, match=r"cells along a side; a map has 2\.\.4000"):
        OccupancyGrid(size, resolution)


def test_composition_of_planar_poses() -> None:
    a, b = PlanarPose(1.0, 2.0, 0.5), PlanarPose(-0.3, 0.7, 3.0)
    assert (a @ b).relative_to(a) == pytest.approx(b)
    assert a @ a.inverse() == pytest.approx((0.0, 0.0, 0.0))
    point = np.array([[4.0, 5.0]])
    assert transformed(a, transformed(b, point))[0] == pytest.approx(transformed(a @ b, point)[0])
