"""Writes an occupancy grid in the format of ROS's map_server: a PGM image, and YAML with resolution and origin."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
import yaml
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.mapping.grid import FREE_THRESHOLD, OCCUPIED_THRESHOLD, OccupancyGrid

GREY_LEVELS: Final = {100: 0, 0: 254, -1: 205}
"""Grey levels of occupied, free and unknown cells."""


def save_map(grid: OccupancyGrid, path: Path) -> tuple[Path, Path]:
    """Write PATH.pgm and PATH.yaml, cropped to the known cells. Returns both paths; raises `ConfigError`."""
    cells = grid.occupancy()
    rows, columns = (np.flatnonzero((cells != -1).any(axis=axis)) for axis in (1, 0))
    top, bottom = (rows[0], rows[-1] + 1) if len(rows) else (0, 1)
    left, right = (columns[0], columns[-1] + 1) if len(columns) else (0, 1)
    image, metadata = path.with_suffix(".pgm"), path.with_suffix(".yaml")
    low = [round(float(grid.low + first * grid.resolution), 9) for first in (left, top)]
    try:
        image.write_bytes(_pgm(cells[top:bottom, left:right]))
        metadata.write_text(
            yaml.safe_dump(_metadata(image.name, grid.resolution, low), sort_keys=False), encoding="utf-8"
        )
    except OSError as error:
        raise ConfigError(f"{path}: the map cannot be written: {error.strerror}") from error
    return image, metadata


def _metadata(image: str, resolution: float, low: list[float]) -> dict[str, Any]:
    return {
        "image": image,
        "resolution": resolution,
        "origin": [*low, 0.0],
        "negate": 0,
        "occupied_thresh": OCCUPIED_THRESHOLD,
        "free_thresh": FREE_THRESHOLD,
    }


def _pgm(cells: NDArray[np.int8]) -> bytes:
    shades = np.full(cells.shape, GREY_LEVELS[-1], np.uint8)
    for value, shade in GREY_LEVELS.items():
        shades[cells == value] = shade
    height, width = cells.shape
    return b"P5\n%d %d\n255\n" % (width, height) + shades[::-1].tobytes()  # the first row of a picture is its top
