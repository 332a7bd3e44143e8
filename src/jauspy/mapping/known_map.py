"""Reads a map in the format of ROS's map_server, as `jauspy map` writes it."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Annotated, Final

import numpy as np
import yaml
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from jauspy.errors import ConfigError
from jauspy.mapping.grid import FREE_THRESHOLD, MAX_CELLS, OCCUPIED_THRESHOLD, OccupancyGrid
from jauspy.plain_yaml import parse_yaml
from jauspy.user_files import MAX_REASON, read_file

LOADED_LOG_ODDS: Final = 2.0
"""Log odds of the cells of a file: five rays that cross an occupied cell take it for free again."""
MAX_NOTES: Final = 64 << 10
"""Bytes of the YAML file."""
_SPACE: Final = rb"(?:\s|#[^\n]*+\n)++"
_HEADER: Final = re.compile(rb"P5" + _SPACE + rb"(\d{1,5})" + _SPACE + rb"(\d{1,5})" + _SPACE + rb"(\d{1,5})\s")


class _Notes(BaseModel):
    """The YAML file; further keys are of no concern."""

    model_config = ConfigDict(allow_inf_nan=False)

    image: Annotated[str, Field(min_length=1, max_length=255)]
    resolution: Annotated[float, Field(ge=0.005, le=10.0)]
    """Metres of a cell."""
    origin: tuple[float, float, float]
    """The pose of the lower left corner: metres and radians."""
    negate: Annotated[int, Field(ge=0, le=1)] = 0
    occupied_thresh: Annotated[float, Field(ge=0.0, le=1.0)] = OCCUPIED_THRESHOLD
    free_thresh: Annotated[float, Field(ge=0.0, le=1.0)] = FREE_THRESHOLD
    mode: str = "trinary"


def load_map(path: Path, size: float = 40.0) -> OccupancyGrid:
    """The map of a YAML file and of the PGM image beside it; the grid has at least `size` metres along a side.

    Its cells have the log odds `LOADED_LOG_ODDS`, so that what has changed is seen. Raises `ConfigError`.
    """
    notes = _read_notes(path)
    shades = _read_pgm(path.parent / notes.image)
    if notes.origin[2] != 0.0:
        raise ConfigError(f"{path}: its origin is turned by {notes.origin[2]:g} rad; only maps with 0 can be used")
    side = notes.resolution
    low = np.round(np.array(notes.origin[:2]) / side, 3)  # in cells
    high = low + shades.shape[::-1]
    if max(np.abs(low).max(), np.abs(high).max()) > MAX_CELLS / 2:
        raise ConfigError(f"{path}: it lies more than {MAX_CELLS * side / 2.0:g} m from the origin")
    half = max(size / side / 2.0, float(np.abs(low).max()), float(np.abs(high).max()))
    # the grid's lower edge is half its number of cells from the origin: odd numbers keep cells where the file has them
    is_odd = round(2.0 * float(low[0])) % 2
    grid = OccupancyGrid((2 * math.ceil(half) + is_odd) * side, side)
    column, row = np.rint(low - grid.low / side).astype(int).tolist()
    chances = (shades if notes.negate else 255 - shades)[::-1] / 255.0  # the first row of a picture is its top
    odds: NDArray[np.float64] = np.zeros(chances.shape)
    odds[chances > notes.occupied_thresh] = LOADED_LOG_ODDS
    odds[chances < notes.free_thresh] = -LOADED_LOG_ODDS
    window = grid.log_odds[row : row + odds.shape[0], column : column + odds.shape[1]]
    window[:] = odds[: window.shape[0], : window.shape[1]]
    return grid


def _read_notes(path: Path) -> _Notes:
    try:
        notes = _Notes.model_validate(parse_yaml(read_file(path, MAX_NOTES)))
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise ConfigError(f"{path}: is no map of map_server: {' '.join(str(error).split())[:MAX_REASON]}") from None
    except ValidationError as error:
        problem = error.errors(include_url=False, include_context=False, include_input=False)[0]
        place = ".".join(map(str, problem["loc"])) or "the file"
        raise ConfigError(f"{path}: is no map of map_server: {place}: {problem['msg'][:MAX_REASON]}") from None
    if notes.mode not in ("trinary", "scale"):
        raise ConfigError(f"{path}: maps of the mode {notes.mode[:MAX_REASON]!r} cannot be used; save it as trinary")
    if notes.image != Path(notes.image).name or notes.image in ("", ".", ".."):
        raise ConfigError(f"{path}: its image must be a file in the same folder")
    return notes


def _read_pgm(path: Path) -> NDArray[np.uint8]:
    data = read_file(path)
    if (header := _HEADER.match(data)) is None:
        raise ConfigError(f"{path}: is no binary PGM image (P5), as map_server saves maps")
    width, height, most = (int(number) for number in header.groups())
    if not (1 <= width <= MAX_CELLS and 1 <= height <= MAX_CELLS and most == 255):
        raise ConfigError(f"{path}: has {width} x {height} pixels up to {most}; maps have up to {MAX_CELLS} and 255")
    pixels = np.frombuffer(data, np.uint8, offset=header.end())
    if len(pixels) < width * height:
        raise ConfigError(f"{path}: has {len(pixels)} of {width * height} pixels")
    return pixels[: width * height].reshape(height, width)
