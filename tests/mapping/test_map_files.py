"""Files of maps: what is written is read again, and damaged files are told in one sentence."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
import yaml
from hypothesis import given, strategies as st

from jauspy.errors import ConfigError
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.known_map import LOADED_LOG_ODDS, load_map
from jauspy.mapping.map_files import save_map


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


@pytest.mark.parametrize(("size", "asked"), [(10.0, 0.0), (10.1, 0.0), (10.1, 40.0), (10.0, 7.3)])
def test_a_map_is_read_as_it_was_written(tmp_path: Path, size: float, asked: float) -> None:
    grid = OccupancyGrid(size, 0.1)
    grid.log_odds[:] = np.random.default_rng(1).choice([-3.0, 0.0, 3.0], grid.log_odds.shape)
    _, notes = save_map(grid, tmp_path / "noise")
    found = load_map(notes, asked)
    assert found.resolution == grid.resolution
    assert found.cells * found.resolution >= max(size, asked)
    rows, columns = np.indices(grid.log_odds.shape).reshape(2, -1)
    centres = (np.column_stack([columns, rows]) + 0.5) * grid.resolution + grid.low
    places = np.rint(found.cell_coordinates(centres)).astype(int)
    assert np.array_equal(
        found.log_odds[places[:, 1], places[:, 0]], np.sign(grid.log_odds.reshape(-1)) * LOADED_LOG_ODDS
    )
    assert np.count_nonzero(found.log_odds) == np.count_nonzero(grid.log_odds), "beside it nothing is known"


def test_an_inverted_picture_with_comments(tmp_path: Path) -> None:
    (tmp_path / "a.pgm").write_bytes(b"P5 # by hand\n2 # columns\n 1\n255\n\xff\x00")
    (tmp_path / "a.yaml").write_text(
        "{image: a.pgm, resolution: 0.1, origin: [0.0, 0.0, 0.0], negate: 1, mode: trinary}"
    )
    found = load_map(tmp_path / "a.yaml", 1.0)
    assert found.log_odds[5, 5:8].tolist() == [LOADED_LOG_ODDS, -LOADED_LOG_ODDS, 0.0]


GOOD: dict[str, Any] = {"image": "a.pgm", "resolution": 0.05, "origin": [0.0, 0.0, 0.0]}
DAMAGED = {
    "no YAML": ("[", "is no map of map_server: while parsing"),
    "nested": ("[" * 9999, "nested too deeply"),
    "an alias": ("a: &a 1\nb: *a", "aliases are not read"),
    "a date": ("a: 2001-99-99", "month must be in 1..12"),
    "a list": ("[1, 2]", "is no map of map_server: the file: "),
    "bytes": ("\x00", "is no map of map_server"),
    "no image": ({"image": None}, "image: Input should be a valid string"),
    "a path": ({"image": "../a.pgm"}, "its image must be a file in the same folder"),
    "an absolute path": ({"image": "/etc/passwd"}, "its image must be a file in the same folder"),
    "a folder": ({"image": ".."}, "its image must be a file in the same folder"),
    "no resolution": ({"resolution": 0.0}, "resolution: Input should be greater"),
    "not a number": ({"resolution": float("nan")}, "resolution: "),
    "turned": ({"origin": [0.0, 0.0, 0.3]}, "its origin is turned by 0.3 rad"),
    "far away": ({"origin": [1e9, 0.0, 0.0]}, "lies more than 100 m from the origin"),
    "raw": ({"mode": "raw"}, "maps of the mode 'raw' cannot be used"),
}


@pytest.mark.parametrize(("change", "said"), DAMAGED.values(), ids=DAMAGED)
def test_damaged_notes_are_told(tmp_path: Path, change: str | dict[str, Any], said: str) -> None:
    (tmp_path / "a.pgm").write_bytes(b"P5\n1 1\n255\n\x00")
    text = change if isinstance(change, str) else yaml.safe_dump(GOOD | change)
    (tmp_path / "a.yaml").write_text(text)
    with pytest.raises(ConfigError) as caught:
        load_map(tmp_path / "a.yaml")
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 600


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"P2\n1 1\n255\n0", "no binary PGM"),
        (b"P5\n9999 9999\n255\n", "9999 x 9999 pixels"),
        (b"P5\n0 1\n255\n", "0 x 1 pixels"),
        (b"P5\n2 2\n65535\n" + bytes(8), "up to 65535"),
        (b"P5\n2 2\n255\n" + bytes(3), "3 of 4 pixels"),
        (b"P5" + b" " * 100_000, "no binary PGM"),
        (b"P5" + b"#\n" * 100_000 + b"1", "no binary PGM"),
        (b"", "no binary PGM"),
    ],
)
def test_damaged_pictures_are_told(tmp_path: Path, data: bytes, said: str) -> None:
    (tmp_path / "a.pgm").write_bytes(data)
    (tmp_path / "a.yaml").write_text(yaml.safe_dump(GOOD))
    with pytest.raises(ConfigError, match=said):
        load_map(tmp_path / "a.yaml")


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"a\.yaml: cannot be read"):
        load_map(tmp_path / "a.yaml")


@given(st.binary(max_size=60), st.binary(max_size=60))
def test_any_files_are_maps_or_told(tmp_path_factory: pytest.TempPathFactory, notes: bytes, picture: bytes) -> None:
    folder = tmp_path_factory.getbasetemp()
    (folder / "fuzz.pgm").write_bytes(b"P5\n" + picture)
    for data in (notes, b"{image: fuzz.pgm, origin: [0.0, 0.0, 0.0], resolution: 0.05}", b"image: fuzz.pgm\n" + notes):
        (folder / "fuzz.yaml").write_bytes(data)
        with suppress(ConfigError):
            assert load_map(folder / "fuzz.yaml", 1.0).cells >= 2
