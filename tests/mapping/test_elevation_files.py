"""Files of elevation grids, read by other programs."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from tests.mapping.test_elevation import flat, kerb, made

from jauspy.errors import ConfigError
from jauspy.mapping.elevation import ElevationGrid
from jauspy.mapping.elevation_files import STEP, UNKNOWN, ZOOM, save_elevation


def colours(path: Path) -> np.ndarray:
    """One pixel of each cell, rows along y ascending, red, green, blue."""
    picture = cv2.imread(str(path))
    assert picture is not None
    return picture[ZOOM // 2 :: ZOOM, ZOOM // 2 :: ZOOM, ::-1][::-1]


def test_picture_shows_unknown_cells_steps_and_heights(tmp_path: Path) -> None:
    grid = made(kerb)
    picture, _ = save_elevation(grid, tmp_path / "ground")
    seen = colours(picture)
    assert seen.shape == (grid.cells, grid.cells, 3)
    unknown = (seen == UNKNOWN).all(axis=2)
    assert np.array_equal(unknown, np.isnan(grid.heights))
    steps = (seen == STEP).all(axis=2)
    columns = np.nonzero(steps)[1]
    assert np.median(columns) == pytest.approx((1.0 - grid.origin[0]) / grid.resolution, abs=1.5)
    assert steps.sum() == pytest.approx(2 * 60, abs=20)
    lightness = seen.astype(float).sum(axis=2)
    column = round((2.0 - grid.origin[0]) / grid.resolution)
    assert lightness[40, column] > lightness[40, column - 20] + 30.0, "the pavement is higher than the road"


def test_arrays_are_those_of_the_grid(tmp_path: Path) -> None:
    grid = made(kerb)
    _, arrays = save_elevation(grid, tmp_path / "ground.v2")
    with np.load(arrays) as found:
        assert np.array_equal(found["heights"], grid.heights, equal_nan=True)
        assert found["origin"].tolist() == list(grid.origin)
        assert float(found["resolution"]) == grid.resolution
        assert float(found["stamp"]) == grid.stamp
        assert set(found) >= {"slopes", "steps", "roughness", "ages"}


def test_an_empty_grid_is_a_grey_picture_and_flat_ground_has_no_steps(tmp_path: Path) -> None:
    empty, _ = save_elevation(ElevationGrid(4.0, 0.1), tmp_path / "empty")
    assert (colours(empty) == UNKNOWN).all()
    level, _ = save_elevation(made(flat), tmp_path / "level")
    assert (colours(level) == STEP).all(axis=2).sum() < 5


def test_a_path_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"nowhere/ground: the map cannot be written: No such file"):
        save_elevation(made(flat, 1), tmp_path / "nowhere" / "ground")
