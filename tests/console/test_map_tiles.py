"""Offline maps: MBTiles and GeoTIFF, and files that were made to do harm."""

from __future__ import annotations

import asyncio
import sqlite3
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

import pytest

pytest.importorskip("fastapi", reason="needs the extra 'console'")

import httpx
from fastapi import FastAPI

from jauspy.console.map_tiles import MAX_TILE, add_tiles, media_type, open_map
from jauspy.errors import ConfigError

PNG = b"\x89PNG\r\n\x1a\n" + bytes(20)


def write(path: Path, *statements: str, tiles: Sequence[tuple[int, int, int, object]] = ()) -> Path:
    with closing(sqlite3.connect(path)) as database:
        for statement in statements or (
            "CREATE TABLE metadata (name, value)",
            "CREATE TABLE tiles (zoom_level, tile_column, tile_row, tile_data)",
        ):
            database.execute(statement)
        if tiles:
            database.executemany("INSERT INTO tiles VALUES (?, ?, ?, ?)", tiles)
        database.commit()
    return path


def test_rows_of_mbtiles_count_from_the_south(tmp_path: Path) -> None:
    path = write(tmp_path / "a.mbtiles", tiles=[(2, 1, 0, PNG), (3, 0, 0, b"x" * (MAX_TILE + 1)), (3, 1, 0, "text")])
    found = open_map(path)
    assert (found.min_zoom, found.max_zoom) == (2, 3)
    assert found.tile(2, 1, 3) == PNG
    assert found.tile(2, 1, 0) is None
    assert found.tile(3, 0, 7) is None, "too large"
    assert found.tile(3, 1, 7) is None, "no bytes"
    assert [media_type(each) for each in (PNG, b"\xff\xd8\xff\xe0", b"<svg>", b"<script>")] == [
        "image/png",
        "image/jpeg",
        None,
        None,
    ]


def test_hostile_mbtiles_are_one_sentence_and_change_nothing(tmp_path: Path) -> None:
    endless = (
        "CREATE TABLE metadata (name, value)",
        """CREATE VIEW tiles AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)
        SELECT i AS zoom_level, i AS tile_column, i AS tile_row, zeroblob(9) AS tile_data FROM n""",
    )
    vector = ("CREATE TABLE metadata (name, value)", "INSERT INTO metadata VALUES ('format', 'pbf')")
    tables = "CREATE TABLE tiles (zoom_level, tile_column, tile_row, tile_data)"
    cases = {
        "endless": write(tmp_path / "endless.mbtiles", *endless),
        "vector": write(tmp_path / "vector.mbtiles", *vector, tables, tiles=[(1, 0, 0, b"")]),
        "empty": write(tmp_path / "empty.mbtiles"),
        "zoom": write(tmp_path / "zoom.mbtiles", tiles=[("x", 0, 0, PNG)]),
    }
    for name, content in (("text", b"<script>"), ("zero", bytes(5000)), ("cut", cases["empty"].read_bytes()[:4096])):
        cases[name] = tmp_path / f"{name}.mbtiles"
        cases[name].write_bytes(content)
    for name, path in cases.items():
        before = path.read_bytes()
        with pytest.raises(ConfigError, match=str(path)) as found:
            open_map(path)
        assert "\n" not in str(found.value), name
        assert path.read_bytes() == before
    for name in ("missing.mbtiles", "map.exe"):
        with pytest.raises(ConfigError, match=name):
            open_map(tmp_path / name)


@pytest.mark.filterwarnings("ignore:Dataset has no geotransform")
@pytest.mark.filterwarnings("ignore:Use `@` matmul:PendingDeprecationWarning")  # rasterio 1.4 with affine 3.1
def test_a_geotiff_is_drawn_at_its_place(tmp_path: Path) -> None:
    rasterio = pytest.importorskip("rasterio", reason="the extra 'geo' is not installed")
    numpy = pytest.importorskip("numpy")
    path = tmp_path / "map.tif"
    rows = numpy.zeros((3, 200, 200), numpy.uint8)
    rows[0, :100] = 200  # red in the north
    place = rasterio.transform.from_bounds(11.0, 48.0, 11.02, 48.02, 200, 200)
    with rasterio.open(
        path, "w", driver="GTiff", width=200, height=200, count=3, dtype="uint8", crs="EPSG:4326", transform=place
    ) as out:
        out.write(rows)
    found = open_map(path)
    zoom = 14
    west, north = int((11.01 + 180.0) / 360.0 * 2**zoom), 5678
    pictures = {y: found.tile(zoom, west, y) for y in range(north - 40, north + 40)}
    drawn = {y: picture for y, picture in pictures.items() if picture is not None}
    assert 1 <= len(drawn) <= 4
    with rasterio.io.MemoryFile(drawn[min(drawn)]) as file, file.open() as image:
        assert (image.width, image.height, image.count) == (256, 256, 4)
        assert image.read(1).max() == 200
        assert image.read(4).min() == 0, "clear where the map ends"
    assert found.tile(zoom, west + 100, north) is None
    path.write_bytes(path.read_bytes()[:300])
    with pytest.raises(ConfigError, match=r"map.tif: is (no GeoTIFF|damaged)"):
        open_map(path).tile(zoom, west, min(drawn))


def test_tiles_are_for_open_pages_and_images_only(tmp_path: Path) -> None:
    page = b"<script>alert(1)</script>"
    source = open_map(write(tmp_path / "a.mbtiles", tiles=[(2, 1, 0, PNG), (2, 2, 0, page)]))
    app = FastAPI()
    add_tiles(app, lambda: source, lambda token: token == "page", lambda _: None)

    async def status(*paths: str) -> list[tuple[int, bytes]]:
        async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://console") as client:
            answers = [await client.get(f"/tiles/{path}") for path in paths]
        return [(answer.status_code, answer.content) for answer in answers]

    found = asyncio.run(status("page/2/1/3", "page/2/2/3", "page/2/0/0", "other/2/1/3", "page/9/1/3", "page/2/1/4"))
    assert found[:3] == [(200, PNG), (204, b""), (204, b"")]
    assert [code for code, _ in found[3:]] == [404, 404, 404]
    huge = "9" * 400
    wrong = asyncio.run(status("page/2/-1/3", "page/2/1e9/3", f"page/{huge}/1/1", f"page/2/{huge}/1"))
    assert {code for code, _ in wrong} <= {404, 422}
