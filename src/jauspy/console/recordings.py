"""The recordings of the console's folder: list, download, and the timelines of recorded runs, over HTTP.

Names of files come from browsers and from whoever writes the folder. A name is one that `checked_file` accepts: no
folder, no link, no other kind of file. Files are read in a process of their own, see `run_timeline`.
"""

from __future__ import annotations

import asyncio
import os
import re
import stat
import sys
from collections.abc import Callable
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from typing import Any, Final
from urllib.parse import quote

import orjson
from fastapi import FastAPI, HTTPException
from starlette.responses import FileResponse, Response

from jauspy.console.languages import ENGLISH, sentence, translated
from jauspy.errors import ConfigError, JausError
from jauspy.printable import printable

KINDS: Final = {
    ".mcap": ("run", "application/octet-stream"),
    ".mp4": ("film", "video/mp4"),
    ".pcapng": ("capture", "application/octet-stream"),
    ".pcap": ("capture", "application/octet-stream"),
    ".wav": ("sound", "audio/wav"),
    ".jpg": ("picture", "image/jpeg"),
    ".png": ("picture", "image/png"),
}
"""What files are, and their media types, by suffix; others are not listed."""
MAX_NAME: Final = 200
MAX_LISTED: Final = 1000
MAX_LOOKED_AT: Final = 10_000
"""Entries of the folder that are looked at."""
MAX_TIMELINE: Final = 64 << 20
"""Bytes of a timeline."""
MAX_TIMELINES: Final = 2
"""Timelines that are kept; one that was not read for long goes first."""
READ_TIME: Final = 330.0
"""Seconds until reading a file is given up."""
MAX_SECONDS: Final = 20.0
"""Seconds of pictures in one answer."""
_NAME: Final = re.compile(r"[\w][\w .+@,()-]*")
_JSON: Final = "application/json"


def checked_file(folder: Path, name: str) -> tuple[Path, os.stat_result]:
    """The regular file of this name in the folder; raises `ConfigError`."""
    suffix = Path(name).suffix.lower()
    if not _NAME.fullmatch(name) or len(name) > MAX_NAME or suffix not in KINDS:
        raise ConfigError(sentence("{name!r} is not the name of a recording", name=printable(name)[:MAX_NAME]))
    path = folder / name
    try:
        found = path.lstat()
    except OSError as error:
        raise ConfigError(sentence("{name} cannot be read: {strerror}", name=name, strerror=error.strerror)) from None
    if not stat.S_ISREG(found.st_mode):
        raise ConfigError(sentence("{name} is not a regular file", name=name))
    return path, found


def listed(folder: Path) -> dict[str, Any]:
    """The recordings of the folder as JSON, the newest first, and how many files are left out for which reason."""
    files: list[dict[str, Any]] = []
    misnamed = others = 0
    try:
        with os.scandir(folder) as entries:
            names = [entry.name for entry in islice(entries, MAX_LOOKED_AT)]
    except FileNotFoundError:
        names = []
    except OSError as error:
        return {"folder": printable(str(folder)), "files": [], "problem": f"it cannot be read: {error.strerror}"}
    for name in names:
        try:
            path, found = checked_file(folder, name)
        except ConfigError:
            is_misnamed = Path(name).suffix.lower() in KINDS and not _NAME.fullmatch(name)
            misnamed, others = misnamed + is_misnamed, others + (not is_misnamed)
            continue
        kind = KINDS[path.suffix.lower()][0]
        files.append({"name": name, "kind": kind, "size": found.st_size, "time": found.st_mtime})
    files.sort(key=lambda each: (-each["time"], each["name"]))
    return {
        "folder": printable(str(folder)),
        "files": files[:MAX_LISTED],
        "left_out": max(0, len(files) - MAX_LISTED),
        "misnamed": misnamed,
        "others": others,
    }


class Timelines:
    """Timelines of runs as JSON, read once; one file is read at a time."""

    def __init__(self, command: tuple[str, ...] = (sys.executable, "-m", "jauspy.console.run_timeline")) -> None:
        self._command = command
        self._kept: dict[tuple[str, int, int], bytes] = {}
        self._reading = asyncio.Lock()

    async def read(self, path: Path, found: os.stat_result) -> bytes:
        """The timeline of a file; raises `ConfigError` in one sentence."""
        if find_spec("mcap") is None or find_spec("foxglove") is None or find_spec("av") is None:
            raise ConfigError(
                sentence("runs are read with packages of jauspy's extras: pip install 'jauspy[recording,video]'")
            )
        key = (str(path), found.st_mtime_ns, found.st_size)
        async with self._reading:
            content = self._kept.pop(key, None) or await self._read(path)
            self._kept[key] = content
            while len(self._kept) > MAX_TIMELINES:
                del self._kept[next(iter(self._kept))]
            return content

    async def _read(self, path: Path) -> bytes:
        process = await asyncio.create_subprocess_exec(
            *self._command, str(path), stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.DEVNULL
        )
        assert process.stdout is not None
        content = bytearray()
        try:
            async with asyncio.timeout(READ_TIME):
                while len(content) <= MAX_TIMELINE and (part := await process.stdout.read(1 << 16)):
                    content += part
        except TimeoutError:
            raise ConfigError(
                sentence("{name} could not be read in {seconds:.0f} s", name=path.name, seconds=READ_TIME)
            ) from None
        finally:
            if process.returncode is None:
                process.kill()
            await process.wait()
        if len(content) > MAX_TIMELINE:
            raise ConfigError(
                sentence(
                    "{name} has a timeline of more than {most} MiB",
                    name=path.name,
                    most=MAX_TIMELINE >> 20,
                )
            )
        try:
            found = orjson.loads(content)
        except orjson.JSONDecodeError:
            raise ConfigError(
                sentence("{name} could not be read: the process that read it ended early", name=path.name)
            ) from None
        if problem := found.get("problem"):
            raise ConfigError(problem)
        return bytes(content)


def add_recordings(
    app: FastAPI,
    folder: Path,
    is_page: Callable[[str], bool],
    note: Callable[[str], None],
    *,
    language_of: Callable[[str], str] = lambda _: ENGLISH,
) -> None:
    """Add the addresses; `is_page` is true for the token of a page of the present user, `note` logs what it did.

    `language_of` returns the code of the language of the page of a token.
    """
    timelines = Timelines()

    def refusal(token: str, status: int, text: str) -> HTTPException:
        return HTTPException(status, translated(text, language_of(token)))

    def check(token: str) -> None:
        if not is_page(token):
            raise refusal(token, 403, sentence("this page is not open any more"))

    def file(token: str, name: str) -> tuple[Path, os.stat_result]:
        check(token)
        try:
            return checked_file(folder, name)
        except ConfigError as error:
            raise refusal(token, 404, str(error)) from None

    @app.get("/recordings/{token}")
    async def files(token: str) -> Response:
        check(token)
        return _json(orjson.dumps(await asyncio.to_thread(listed, folder)))

    @app.get("/recordings/{token}/file/{name}")
    async def download(token: str, name: str) -> Response:
        path, _ = file(token, name)
        headers = {
            "Cache-Control": "no-store",
            "Content-Disposition": f"attachment; filename*=UTF-8''{quote(name)}",
        }
        return FileResponse(path, media_type=KINDS[path.suffix.lower()][1], headers=headers)

    @app.get("/recordings/{token}/run/{name}")
    async def run(token: str, name: str) -> Response:
        path, found = file(token, name)
        try:
            content = await timelines.read(path, found)
        except JausError as error:
            raise refusal(token, 422, str(error)) from None
        note(sentence("opened the recording {name}", name=name))
        return _json(content)

    @app.get("/recordings/{token}/pictures/{name}")
    async def pictures(token: str, name: str, topic: str, begin: float, end: float) -> Response:
        path, _ = file(token, name)
        if not 0.0 <= end - begin <= MAX_SECONDS or not abs(begin) < 1e9:
            raise refusal(token, 422, sentence("pictures of 0 to {most:g} s can be read at once", most=MAX_SECONDS))
        from jauspy.console.run_timeline import pictures as read  # noqa: PLC0415 - of the extra `recording`

        try:
            content = await asyncio.to_thread(read, path, topic, begin, end)
        except JausError as error:
            raise refusal(token, 422, str(error)) from None
        return Response(content, media_type="application/octet-stream", headers={"Cache-Control": "no-store"})


def _json(content: bytes) -> Response:
    return Response(content, media_type=_JSON, headers={"Cache-Control": "no-store"})
