"""Files of an elevation grid: its layers as arrays of numpy, and a picture of heights and steps."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.mapping.elevation import ElevationGrid

Bytes: TypeAlias = NDArray[np.uint8]

UNKNOWN: Final = (205, 205, 205)
STEP: Final = (200, 30, 30)
"""Colours, red, green and blue, of unknown cells and of those at a step."""
LOW_COLOUR: Final = (35, 60, 110)
HIGH_COLOUR: Final = (245, 225, 150)
"""Colours of the lowest and of the highest ground; between them the colour changes linearly."""
MIN_SPAN: Final = 0.5
"""Metres between the two at least, so that noise of flat ground is not seen as hills."""
SHOWN_STEP: Final = 0.08
"""Metres of a step that is drawn, at least."""
ZOOM: Final = 4
"""Pixels of a cell along a side."""


def save_elevation(grid: ElevationGrid, path: Path) -> tuple[Path, Path]:
    """Write PATH.png and PATH.npz. Returns both paths; raises `ConfigError`.

    The arrays are `heights` (m), `slopes` (rad), `steps`, `roughness` (m), `ages` (s, at the latest cloud), `origin`,
    `resolution` (m) and `stamp` (s).
    """
    picture, arrays = path.with_suffix(".png"), path.with_suffix(".npz")
    try:
        picture.write_bytes(png(drawn(grid)))
        np.savez_compressed(
            arrays,
            heights=grid.heights,
            slopes=grid.slopes(),
            steps=grid.steps(),
            roughness=grid.roughness(),
            ages=grid.ages(grid.stamp).astype(np.float32),
            origin=np.array(grid.origin),
            resolution=np.array(grid.resolution),
            stamp=np.array(grid.stamp),
        )
    except OSError as error:
        raise ConfigError(f"{path}: the map cannot be written: {error.strerror}") from error
    return picture, arrays


def drawn(grid: ElevationGrid) -> Bytes:
    """The picture, shape (rows, columns, 3): y upwards, low ground dark, high ground light, steps red, unknown grey."""
    heights, known = grid.heights, np.isfinite(grid.heights)
    found = np.full((*heights.shape, 3), UNKNOWN, np.float64)
    if known.any():
        low, high = np.percentile(heights[known], (2.0, 98.0))
        part = np.clip((heights[known] - low) / max(MIN_SPAN, high - low), 0.0, 1.0)[:, None]
        found[known] = np.array(LOW_COLOUR) + part * (np.array(HIGH_COLOUR) - np.array(LOW_COLOUR))
    with np.errstate(invalid="ignore"):
        found[known & (grid.steps() >= SHOWN_STEP)] = STEP
    enlarged = np.kron(found[::-1], np.ones((ZOOM, ZOOM, 1)))
    pixels: Bytes = np.rint(enlarged).astype(np.uint8)
    return pixels


def png(pixels: Bytes) -> bytes:
    """A picture, shape (rows, columns, 3), as PNG (ISO/IEC 15948): 8 bits for each colour, no filters."""
    rows, columns, _ = pixels.shape
    lines = np.pad(pixels.reshape(rows, -1), ((0, 0), (1, 0)))
    header = struct.pack(">2I5B", columns, rows, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(lines.tobytes())), (b"IEND", b""))
    encoded = (struct.pack(">I", len(d)) + k + d + struct.pack(">I", zlib.crc32(k + d)) for k, d in chunks)
    return b"\x89PNG\r\n\x1a\n" + b"".join(encoded)
