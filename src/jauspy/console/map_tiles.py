"""Maps without a network: tiles of Web Mercator (XYZ) from an MBTiles file, or rendered from a GeoTIFF.

MBTiles 1.3 is a SQLite file with a table `tiles`, whose rows count from the south; vector tiles are refused. GeoTIFF of
any coordinate system is read by rasterio (extra `geo`). Both come from whoever starts the console, and both are read
with limits, since maps are downloaded.
"""

from __future__ import annotations

import math
import sqlite3
import threading
from collections import OrderedDict
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any, Final, Protocol

from fastapi import FastAPI, HTTPException
from starlette.concurrency import run_in_threadpool
from starlette.responses import Response

from jauspy.errors import ConfigError
from jauspy.printable import printable

SIDE: Final = 256
"""Pixels of a tile that is rendered."""
MAX_ZOOM: Final = 22
MAX_TILE: Final = 1 << 20
"""Bytes of a tile."""
MAX_TEXT: Final = 300
KEPT: Final = 256
"""Tiles that are kept."""
MAX_PIXELS: Final = 16_000_000
"""Pixels of a GeoTIFF without overviews that are read for one tile; with more, the tile stays empty."""
EXTENT: Final = 2.0 * math.pi * 6378137.0
"""Metres of Web Mercator from west to east."""
MERCATOR: Final = "EPSG:3857"
_KINDS: Final = ((b"\x89PNG\r\n\x1a\n", "image/png"), (b"\xff\xd8\xff", "image/jpeg"), (b"RIFF", "image/webp"))


class TileSource(Protocol):
    """A map; errors raise `ConfigError`."""

    min_zoom: int
    max_zoom: int
    attribution: str

    def tile(self, zoom: int, x: int, y: int) -> bytes | None:
        """An image of PNG, JPEG or WebP; None where the map has nothing. y counts from the north."""
        ...


class MBTiles:
    """Tiles of a SQLite file, which is opened for reading only."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock = threading.Lock()
        try:
            self._database = sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True, check_same_thread=False)
            self._database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, 2 * MAX_TILE)
            self._database.execute("PRAGMA trusted_schema = OFF")
            self._database.execute("PRAGMA cell_size_check = ON")
            self._steps(2_000_000)
            with closing(self._database.execute("SELECT name, value FROM metadata LIMIT 100")) as rows:
                metadata = {str(name): str(value)[:MAX_TEXT] for name, value in rows}
            with closing(self._database.execute("SELECT min(zoom_level), max(zoom_level) FROM tiles")) as rows:
                least, most = rows.fetchone()
        except (sqlite3.Error, OverflowError, ValueError) as error:
            raise ConfigError(f"{path}: is no MBTiles file: {printable(str(error))[:MAX_TEXT]}") from None
        if not isinstance(least, int) or not isinstance(most, int) or not 0 <= least <= most <= 30:
            raise ConfigError(f"{path}: has no tiles")
        if metadata.get("format") in ("pbf", "mvt"):
            raise ConfigError(f"{path}: has vector tiles; the map shows images (png, jpg, webp)")
        self.min_zoom, self.max_zoom = least, min(most, MAX_ZOOM)
        self.attribution = printable(metadata.get("attribution", ""))

    def _steps(self, most: int) -> None:
        """End what takes longer than this many steps of SQLite: a table of the file may be an endless view."""
        self._database.set_progress_handler(lambda: 1, most)

    def tile(self, zoom: int, x: int, y: int) -> bytes | None:
        """The image of a tile."""
        query = "SELECT tile_data FROM tiles WHERE zoom_level = ? AND tile_column = ? AND tile_row = ? LIMIT 1"
        with self._lock:
            try:
                with closing(self._database.execute(query, (zoom, x, (1 << zoom) - 1 - y))) as rows:
                    row = rows.fetchone()
            except (sqlite3.Error, OverflowError) as error:
                raise ConfigError(f"{self._path}: is damaged: {printable(str(error))[:MAX_TEXT]}") from None
        return row[0] if row is not None and isinstance(row[0], bytes) and len(row[0]) <= MAX_TILE else None


class GeoTiff:
    """Tiles that are rendered from an image with a coordinate system."""

    attribution = ""

    def __init__(self, path: Path) -> None:
        try:
            import rasterio  # noqa: PLC0415 - of the extra `geo`
            from rasterio.vrt import WarpedVRT  # noqa: PLC0415
            from rasterio.warp import transform_bounds  # noqa: PLC0415
        except ImportError:
            raise ConfigError(f"{path}: a GeoTIFF needs rasterio: pip install 'jauspy[geo]'") from None
        self._path = path
        self._lock = threading.Lock()
        try:
            image: Any = rasterio.open(path, driver="GTiff")
            if image.crs is None:
                raise ConfigError(f"{path}: has no coordinate system, so its place is not known")
            self._image = image
            self._bounds = transform_bounds(image.crs, MERCATOR, *image.bounds)
            with WarpedVRT(image, crs=MERCATOR) as warped:
                self._pixel = abs(warped.transform.a)
            self._has_overviews = bool(image.overviews(1))
        except rasterio.errors.RasterioError as error:
            raise ConfigError(f"{path}: is no GeoTIFF: {printable(str(error))[:MAX_TEXT]}") from None
        self.min_zoom = 0
        finest = math.log2(EXTENT / SIDE / self._pixel) if self._pixel > 0.0 else 0.0
        self.max_zoom = max(0, min(MAX_ZOOM, math.ceil(finest)))

    def tile(self, zoom: int, x: int, y: int) -> bytes | None:
        """The image of a tile as PNG."""
        import rasterio  # noqa: PLC0415 - of the extra `geo`
        from rasterio.transform import from_origin  # noqa: PLC0415
        from rasterio.vrt import WarpedVRT  # noqa: PLC0415

        side = EXTENT / (1 << zoom)
        west, north = x * side - EXTENT / 2.0, EXTENT / 2.0 - y * side
        left, bottom, right, top = self._bounds
        wide, high = min(right, west + side) - max(left, west), min(top, north) - max(bottom, north - side)
        if wide <= 0.0 or high <= 0.0:
            return None
        if not self._has_overviews and wide * high / self._pixel**2 > MAX_PIXELS:
            return None
        place = {"transform": from_origin(west, north, side / SIDE, side / SIDE), "width": SIDE, "height": SIDE}
        bands = min(self._image.count, 4)
        with self._lock:
            try:
                with WarpedVRT(self._image, crs=MERCATOR, add_alpha=bands in (1, 3), **place) as warped:
                    shown = list(range(1, bands + (bands in (1, 3)) + 1))
                    return _png(warped.read(indexes=shown, out_dtype="uint8"), warped.transform)
            except (rasterio.errors.RasterioError, ValueError, MemoryError) as error:
                raise ConfigError(f"{self._path}: is damaged: {printable(str(error))[:MAX_TEXT]}") from None


def _png(data: Any, transform: Any) -> bytes:
    """Bands as PNG: grey, grey with alpha, RGB or RGBA."""
    from rasterio.io import MemoryFile  # noqa: PLC0415 - of the extra `geo`

    bands, rows, columns = data.shape
    with MemoryFile() as file:
        with file.open(
            driver="PNG", width=columns, height=rows, count=bands, dtype="uint8", transform=transform
        ) as out:
            out.write(data)
        return bytes(file.read())


def open_map(path: Path) -> TileSource:
    """The map in a file, by its suffix; raises `ConfigError`."""
    if not path.is_file():
        raise ConfigError(f"{path}: there is no such file")
    if path.suffix.lower() in (".tif", ".tiff"):
        return GeoTiff(path)
    if path.suffix.lower() == ".mbtiles":
        return MBTiles(path)
    raise ConfigError(f"{path}: a map is a file .mbtiles, .tif or .tiff")


def media_type(image: bytes) -> str | None:
    """What an image is by its first bytes; None for anything else."""
    return next((kind for magic, kind in _KINDS if image.startswith(magic)), None)


def add_tiles(
    app: FastAPI, source: Callable[[], TileSource | None], is_page: Callable[[str], bool], note: Callable[[str], None]
) -> None:
    """Add the address of tiles; `is_page` is true for the token of a page of the present user."""
    kept: OrderedDict[tuple[int, int, int], bytes | None] = OrderedDict()
    told: set[str] = set()

    @app.get("/tiles/{token}/{zoom}/{x}/{y}")
    async def tile(token: str, zoom: int, x: int, y: int) -> Response:
        found = source()
        if found is None or not is_page(token):
            raise HTTPException(404)
        if not (found.min_zoom <= zoom <= found.max_zoom and 0 <= x < 1 << zoom and 0 <= y < 1 << zoom):
            raise HTTPException(404)
        key = (zoom, x, y)
        if key not in kept:
            try:
                kept[key] = await run_in_threadpool(found.tile, zoom, x, y)
            except ConfigError as error:
                if str(error) not in told and len(told) < 8:
                    told.add(str(error))
                    note(str(error))
                kept[key] = None
            while len(kept) > KEPT:
                kept.popitem(last=False)
        image = kept.get(key)
        kind = None if image is None else media_type(image)
        if image is None or kind is None:
            return Response(status_code=204, headers={"Cache-Control": "private, max-age=60"})
        return Response(image, media_type=kind, headers={"Cache-Control": "private, max-age=3600"})
