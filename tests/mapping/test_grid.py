"""The occupancy grid: what rays say about cells."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, save_map, transformed

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


def wall() -> OccupancyGrid:
    grid = OccupancyGrid(10.0, 0.1)
    ends = np.array([[2.05, y / 10 + 0.05] for y in range(10)])
    for _ in range(5):
        grid.add(np.zeros(2), ends, np.ones(10, bool))
    return grid


def test_image_and_metadata(tmp_path: Path) -> None:
    save_map(wall(), tmp_path / "yard")
    notes = yaml.safe_load((tmp_path / "yard.yaml").read_text())
    picture = cv2.imread(str(tmp_path / notes["image"]), cv2.IMREAD_GRAYSCALE)
    assert notes["negate"] == 0
    rows, columns = np.nonzero(picture == 0)
    # as map_server reads it: the origin is the lower left corner, and the first row is the top
    x = notes["origin"][0] + (columns + 0.5) * notes["resolution"]
    y = notes["origin"][1] + (picture.shape[0] - rows - 0.5) * notes["resolution"]
    assert set(np.round(x, 3)) == {2.05}
    assert sorted(np.round(y, 3)) == pytest.approx([n / 10 + 0.05 for n in range(10)])
    # probabilities as map_server computes them
    assert notes["occupied_thresh"] < (255 - 0) / 255
    assert (255 - 254) / 255 < notes["free_thresh"] < (255 - 205) / 255 < notes["occupied_thresh"]
    assert set(np.unique(picture)) == {0, 205, 254}


def test_an_empty_map_is_a_map(tmp_path: Path) -> None:
    picture, _ = save_map(OccupancyGrid(), tmp_path / "nothing")
    assert cv2.imread(str(picture), cv2.IMREAD_GRAYSCALE).tolist() == [[205]]


def test_a_path_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"nowhere/yard: the map cannot be written: No such file"):
        save_map(OccupancyGrid(), tmp_path / "nowhere" / "yard")
