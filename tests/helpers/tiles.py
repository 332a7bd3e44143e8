"""An offline map as MBTiles: a chessboard of tiles around a place, each with its numbers."""

from __future__ import annotations

import io
import math
import sqlite3
from contextlib import closing
from pathlib import Path

from PIL import Image, ImageDraw


def tile_of(latitude: float, longitude: float, zoom: int) -> tuple[int, int]:
    """Column and row (from the north) of the tile at a place in degrees."""
    x = (longitude + 180.0) / 360.0 * 2**zoom
    y = (1.0 - math.asinh(math.tan(math.radians(latitude))) / math.pi) / 2.0 * 2**zoom
    return int(x), int(y)


def write_tiles(path: Path, latitude: float, longitude: float, zooms: range = range(18, 22)) -> Path:
    """Write 9 x 9 tiles of each zoom."""
    with closing(sqlite3.connect(path)) as database:
        database.execute("CREATE TABLE metadata (name, value)")
        database.execute("CREATE TABLE tiles (zoom_level, tile_column, tile_row, tile_data)")
        database.execute("INSERT INTO metadata VALUES ('attribution', 'a chessboard')")
        for zoom in zooms:
            column, row = tile_of(latitude, longitude, zoom)
            for x in range(column - 4, column + 5):
                for y in range(row - 4, row + 5):
                    image = Image.new("RGB", (256, 256), (196, 214, 180) if (x + y) % 2 else (226, 214, 190))
                    ImageDraw.Draw(image).text((20, 20), f"{zoom}/{x}/{y}", fill=(90, 90, 90))
                    data = io.BytesIO()
                    image.save(data, "PNG")
                    rows = (zoom, x, 2**zoom - 1 - y, data.getvalue())
                    database.execute("INSERT INTO tiles VALUES (?, ?, ?, ?)", rows)
        database.commit()
    return path
