"""Maps as files: what another reader finds in them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml

from jauspy.errors import ConfigError
from jauspy.mapping.files import save_map
from jauspy.mapping.grid import OccupancyGrid


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
