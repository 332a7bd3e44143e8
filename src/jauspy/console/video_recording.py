"""Records a camera's pictures, as they arrive, to a file on the console's machine."""

from __future__ import annotations

import asyncio
import shutil
import time
from collections import deque
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final

from jauspy.console.languages import joined, sentence
from jauspy.errors import ConfigError
from jauspy.video import need_video
from jauspy.video.h264_payload import Picture

if TYPE_CHECKING:
    from jauspy.video.recorder import Recorder

MIN_FREE: Final = 512 << 20
"""Bytes of the disk that stay free; a recording ends when fewer are left."""
MAX_QUEUED: Final = 128
"""Pictures that wait for the disk; with more of them, all until the next IDR picture are left out, and counted."""
WRITE_INTERVAL: Final = 0.25
"""Seconds between two writes, in a thread, so that a slow disk delays nothing else."""


class VideoRecording:
    """Writes fragmented MP4 without re-encoding. A change of the image size begins another file."""

    def __init__(self, folder: Path, name: str, min_free: int = MIN_FREE) -> None:
        need_video()
        _make(folder)
        self._min_free = min_free
        self._check_space(folder)
        self._stem = folder / f"{name}-{datetime.now().astimezone():%Y%m%d-%H%M%S}"
        self._files = 0
        self._recorder: Recorder | None = None
        self._queue: deque[Picture] = deque()
        self._waits_for_idr, self._has_begun = True, False
        self._news = asyncio.Event()
        self.path = self._next_path()
        """The present file."""
        self._began = time.monotonic()
        self.pictures = 0
        self.left_out = 0
        self.size = 0
        """Bytes of all files so far."""
        self._pictures_before = self._size_before = 0
        self.problem = ""
        """Why it ended without a request; empty otherwise."""
        self.ended = False
        self._ending = False
        self.writing = asyncio.create_task(self._run(), name=f"console: recording {self.path.name}")
        """Done when the file is closed."""

    @property
    def seconds(self) -> int:
        """Seconds since it began."""
        return int(time.monotonic() - self._began)

    @property
    def summary(self) -> str:
        """A text with duration, size and path of the recording."""
        if not self.pictures:
            text = sentence("nothing was recorded: no picture arrived")
            return joined([text, self.problem]) if self.problem else text
        values = {"pictures": self.pictures, "size": self.size / 1e6, "path": self.path}
        parts = [sentence("recorded {pictures} pictures ({size:.1f} MB) to {path}", **values)]
        if self._files > 1:
            parts.append(sentence(" and {count} more", count=self._files - 1))
        if self.left_out:
            parts.append(sentence(", {count} left out because the disk was too slow", count=self.left_out))
        text = joined(parts, "")
        return joined([text, self.problem]) if self.problem else text

    def add(self, picture: Picture) -> None:
        """Record a picture; never waits."""
        if self.ended or self._ending:
            return
        if len(self._queue) >= MAX_QUEUED or (self._waits_for_idr and not picture.is_idr):
            self.left_out += self._has_begun
            self._waits_for_idr = True
            return
        self._waits_for_idr, self._has_begun = False, True
        self._queue.append(picture)
        self._news.set()

    async def close(self) -> None:
        """Write what waits, and close the file. May be called twice."""
        self._ending = True
        self._news.set()
        await asyncio.wait({self.writing})

    async def _run(self) -> None:
        try:
            while not self._ending:
                await self._news.wait()
                await self._write_queue()
                self._check_space(self._stem.parent)
                if not self._ending:
                    self._news.clear()
                    await asyncio.sleep(WRITE_INTERVAL)
            await self._write_queue()
        except ConfigError as error:
            self.problem = str(error)
        finally:
            self.ended = True
            try:
                await asyncio.to_thread(self._close_file)
            except ConfigError as error:
                self.problem = self.problem or str(error)

    async def _write_queue(self) -> None:
        pictures = list(self._queue)
        self._queue.clear()
        if pictures:
            await asyncio.to_thread(self._write, pictures)

    def _write(self, pictures: list[Picture]) -> None:
        """Write the file, in a thread. Raises `ConfigError` when the file cannot be written."""
        for picture in pictures:
            recorder = self._recorder or self._open()
            recorder.add(picture)
            if recorder.ended:  # the image size has changed, or the file cannot be written, which closing it raises
                self._close_file()
                recorder = self._open()
                recorder.add(picture)
            self.pictures = self._pictures_before + recorder.pictures
        self.size = self._size_before + self.path.stat().st_size

    def _open(self) -> Recorder:
        from jauspy.video.recorder import Recorder  # noqa: PLC0415 - of the extra `video`

        self.path = self._next_path()
        self._recorder = Recorder(self.path)
        self._files += 1
        return self._recorder

    def _close_file(self) -> None:
        recorder, self._recorder = self._recorder, None
        if recorder is None:
            return
        try:
            recorder.close()
        finally:
            if recorder.pictures:
                self._pictures_before += recorder.pictures
                self._size_before = self.size = self._size_before + self.path.stat().st_size
            else:
                self.path.unlink(missing_ok=True)

    def _next_path(self) -> Path:
        """A file that does not exist."""
        number = 1
        while True:
            suffix = "" if number == 1 else f"-{number}"
            path = self._stem.with_name(f"{self._stem.name}{suffix}.mp4")
            if not path.exists():
                return path
            number += 1

    def _check_space(self, folder: Path) -> None:
        free = shutil.disk_usage(folder).free
        if free < self._min_free:
            raise ConfigError(
                sentence(
                    "{folder} has {free:.0f} MB left, and {min_free:.0f} MB stay free: "
                    "delete something, or choose another folder with --recordings",
                    folder=folder,
                    free=free / 1000000.0,
                    min_free=self._min_free / 1000000.0,
                )
            )


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ConfigError(
            sentence(
                "recordings cannot be kept in {folder}: {strerror}; choose --recordings DIR",
                folder=folder,
                strerror=error.strerror,
            )
        ) from error
