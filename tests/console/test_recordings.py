"""The recordings' list, and files whose names or contents were made to do harm."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("fastapi", reason="needs the extra 'console'")
pytest.importorskip("mcap", reason="needs the extra 'recording'")
pytest.importorskip("foxglove", reason="needs the extra 'recording'")
pytest.importorskip("av", reason="the extra 'video' is not installed")

import httpx
from fastapi import FastAPI
from mcap.reader import make_reader
from tests.helpers.recorded_run import RADIUS, write_run

from jauspy.console.recordings import Timelines, add_recordings, checked_file, listed
from jauspy.console.run_timeline import PICTURE_HEADER, pictures, read_timeline
from jauspy.errors import ConfigError


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_run(tmp_path_factory.mktemp("run") / "circle.mcap")


class Browser:
    """Asks a console that has this folder, and one open page with the token "page"."""

    def __init__(self, folder: Path, notes: Callable[[str], None] = lambda _: None) -> None:
        self._app = FastAPI()
        add_recordings(self._app, folder, lambda token: token == "page", notes)

    def get(self, path: str, **headers: str) -> httpx.Response:
        async def answer() -> httpx.Response:
            transport = httpx.ASGITransport(self._app)
            async with httpx.AsyncClient(transport=transport, base_url="http://console") as client:
                return await client.get(path, headers=headers)

        return asyncio.run(answer())


def test_the_list_has_recordings_only_the_newest_first(tmp_path: Path) -> None:
    for age, name in enumerate(
        ("new.mcap", "old.mp4", "notes.txt", ".hidden.mcap", "<b>.mcap", "50%.mp4", " a.mp4", "run.mcap.part")
    ):
        (tmp_path / name).write_bytes(bytes(100))
        os.utime(tmp_path / name, (1e9 - age, 1e9 - age))
    (tmp_path / "folder.mcap").mkdir()
    (tmp_path / "link.mcap").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe.mcap")
    found = listed(tmp_path)
    assert [(each["name"], each["kind"], each["size"]) for each in found["files"]] == [
        ("new.mcap", "run", 100),
        ("old.mp4", "film", 100),
    ]
    assert (found["misnamed"], found["others"]) == (4, 5)
    assert listed(tmp_path / "missing")["files"] == []


@pytest.mark.parametrize(
    "name",
    [
        "../secret.mcap",
        "..%2Fsecret.mcap",
        "%2e%2e%2fsecret.mcap",
        "/etc/passwd",
        "link.mcap",
        "pipe.mcap",
        "a\x00.mcap",
        "folder.mcap",
        ".mcap",
        "..",
        "",
        "a" * 300 + ".mcap",
        "secret.txt",
        "\u202emcap.mcap",
        "-x.mcap",
        "a\n.mcap",
    ],
)
def test_no_name_leads_out_of_the_folder(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "recordings"
    folder.mkdir()
    for place in (tmp_path / "secret.mcap", folder / "secret.txt"):
        place.write_text("secret")
    (folder / "link.mcap").symlink_to(tmp_path / "secret.mcap")
    (folder / "folder.mcap").mkdir()
    os.mkfifo(folder / "pipe.mcap")
    with pytest.raises(ConfigError):
        checked_file(folder, name)
    page = Browser(folder)
    for what in ("file", "run", "pictures"):
        answer = page.get(
            f"/recordings/page/{what}/{name}?topic=x&begin=0&end=1".replace("\0", "%00").replace("\n", "%0a")
        )
        assert answer.status_code in (404, 405, 307) or (name in ("", "..") and answer.status_code == 200)
        assert "secret" not in answer.text.replace("secret.mcap", "").replace("secret.txt", "")


def test_only_an_open_page_reads(run: Path) -> None:
    page = Browser(run.parent)
    for what in ("", "/file/circle.mcap", "/run/circle.mcap", "/pictures/circle.mcap?topic=x&begin=0&end=1"):
        assert page.get(f"/recordings/other{what}").status_code == 403


def test_a_file_is_downloaded_in_parts_under_its_name(run: Path) -> None:
    answer = Browser(run.parent).get("/recordings/page/file/circle.mcap", range="bytes=1-4")
    assert (answer.status_code, answer.content) == (206, b"MCAP")
    assert answer.headers["content-disposition"] == "attachment; filename*=UTF-8''circle.mcap"


def test_a_timeline_has_track_values_events_and_pictures(run: Path) -> None:
    found = read_timeline(run)
    track = found.tracks["101.1.102"]
    assert found.seconds == pytest.approx(7.9, abs=0.01)
    assert max(abs(point[2]) for point in track) == pytest.approx(2 * RADIUS, abs=0.05)
    assert all(point[2] >= -0.01 for point in track), "a turn to the left has positive y"
    assert [(round(time), text) for time, _, _, text in found.events][:2] == [
        (0, "101.1.102 is in STANDBY"),
        (2, "101.1.102 is in READY"),
    ]
    names = {series.name: len(series.points) for series in found.series.values()}
    assert names["101.1.102 VelocityState.velocity_x"] == 80
    times = found.cameras["/101.1.106/video"]
    assert len(times) == 80
    assert [time for time, key in times if key] == pytest.approx(range(8), abs=0.01)
    part = pictures(run, "/101.1.106/video", 2.0, 3.0)
    size, key, time = PICTURE_HEADER.unpack_from(part)
    assert (key, time) == (1, pytest.approx(2.0, abs=0.01))
    assert part[PICTURE_HEADER.size :][:4] == b"\0\0\0\1"
    assert size < len(part)
    assert pictures(run, "/nothing", 0.0, 8.0) == b""


@pytest.mark.slow
def test_damaged_files_are_one_sentence(run: Path, tmp_path: Path) -> None:
    """Cut off anywhere, or with bytes changed anywhere: a sentence that names the file, or a timeline."""
    whole = run.read_bytes()
    with run.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    chunk = summary.chunk_indexes[0]
    path = tmp_path / "x.mcap"

    def problem(content: bytes) -> str | None:
        path.write_bytes(content)
        try:
            read_timeline(path)
            pictures(path, "/101.1.106/video", 0.0, 8.0)
        except ConfigError as error:
            return str(error)
        return None

    def changed(at: int) -> bytes:
        return whole[:at] + bytes([whole[at] ^ 0xFF]) + whole[at + 1 :]

    step = chunk.compressed_size // 10
    end = chunk.chunk_start_offset + chunk.chunk_length
    messages = [changed(at) for at in range(end - chunk.compressed_size, end, step)]
    anywhere = [changed(at) for at in range(0, len(whole), len(whole) // 20)]
    cut = [whole[: len(whole) * part // 23] for part in range(23)]
    foreign = [b"", b"\x89MCAP", bytes(1000), b"<script>alert(1)</script>"]
    damaged = [problem(content) for content in [*messages, *cut, *foreign]]
    problems = [said for said in damaged if said is not None]
    assert len(problems) == len(damaged)
    problems += [said for content in anywhere if (said := problem(content)) is not None]
    assert all("x.mcap" in said and "\n" not in said and len(said) < 400 for said in problems)


@pytest.mark.slow
def test_a_reader_that_dies_or_floods_is_one_sentence(run: Path) -> None:
    found = run.stat()
    for program, said in (
        ("import os; os.abort()", "ended early"),
        ("import sys\nwhile True: sys.stdout.write('x' * 65536)", "more than"),
    ):
        with pytest.raises(ConfigError, match=said):
            asyncio.run(Timelines((sys.executable, "-c", program)).read(run, found))


@pytest.mark.slow
def test_a_run_that_cannot_be_read_is_refused_with_its_sentence(tmp_path: Path) -> None:
    (tmp_path / "cut.mcap").write_bytes(b"\x89MCAP0\r\n")
    notes: list[str] = []
    answer = Browser(tmp_path, notes.append).get("/recordings/page/run/cut.mcap")
    assert answer.status_code == 422
    assert "cut.mcap is no complete MCAP file" in answer.json()["detail"]
    assert notes == []


@pytest.mark.parametrize("query", ["begin=0&end=1e9", "begin=nan&end=1", "begin=5&end=1", "begin=-1e300&end=-1e300"])
def test_parts_of_video_are_bounded(run: Path, query: str) -> None:
    assert Browser(run.parent).get(f"/recordings/page/pictures/circle.mcap?topic=x&{query}").status_code == 422
