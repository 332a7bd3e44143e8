"""Recording of traffic into files that follow each other, within limits of size and time."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from typing import Final, NamedTuple

from jauspy.capture.dissect import Part
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.codec.registry import Registry
from jauspy.recording.described_robot import DescribedRobot
from jauspy.recording.run_files import NO_ROBOTS, RunFile, create, prepared

FLUSH_INTERVAL: Final = 0.5
"""Seconds of the traffic after which what was recorded is handed to the operating system."""
MAX_PICTURES: Final = 1000
"""Pictures that wait for the next datagram; the oldest go first."""


@dataclass(frozen=True, slots=True)
class Limits:
    """When a file ends, and the next one begins; and how many are kept."""

    size: float | None = None
    """Bytes of a file, at least those of one flush."""
    seconds: float | None = None
    """Seconds of traffic in a file."""
    files: int | None = None
    """Files that are kept; older ones of this recording are deleted."""

    @property
    def rotates(self) -> bool:
        """True if there may be several files."""
        return self.size is not None or self.seconds is not None


@dataclass(slots=True)
class Recorded:
    """What was recorded."""

    datagrams: int = 0
    messages: int = 0
    pictures: int = 0
    bytes: int = 0
    """Of files that were deleted, too."""
    files: list[Path] = field(default_factory=list)
    """Files that there are now."""


class Picture(NamedTuple):
    """A picture of a camera's H.264, as a byte stream of annex B."""

    camera: str
    time: float
    """Seconds since 1970, UTC."""
    access_unit: bytes
    is_idr: bool


class Recorder:
    """Writes datagrams to `path`, or to numbered files beside it if the limits rotate.

    Traffic hands over itself what was recorded before; while there is none, `flush` does so from any thread.
    """

    def __init__(
        self,
        path: Path,
        registry: Registry,
        limits: Limits = Limits(),
        fits: Callable[[Part], bool] | None = None,
        robots: Mapping[int, DescribedRobot] = NO_ROBOTS,
    ) -> None:
        self.recorded = Recorded()
        self._robots = robots
        self._pictures: deque[Picture] = deque(maxlen=MAX_PICTURES)
        self._path, self._registry, self._limits, self._fits = path, registry, limits, fits
        self._dissector = Dissector(registry)
        self._lock = threading.Lock()
        """Held while a file is used."""
        self._flushed_at, self._is_flushed = monotonic(), True
        """When something was handed over last (s, monotonic), and whether that was all."""
        self._problem: OSError | None = None
        """Why `flush` has failed."""
        self._number = 0
        self._start = self._flushed = 0.0
        if limits.rotates:
            prepared(path, registry, limits.size)  # now, so that no traffic waits for it
        self._file: RunFile | None = self._open() if not limits.rotates else None
        """The file that is written; with rotation from the first datagram on."""

    def run(self, datagrams: Iterable[Datagram]) -> None:
        """Record all of them; the last file is complete afterwards, also after an error."""
        try:
            for datagram in datagrams:
                self.add(datagram)
        finally:
            self.close()

    def add(self, datagram: Datagram) -> None:
        """Record a datagram if one of its messages fits."""
        self.write_pictures()
        parts = self._dissector.dissect(datagram.payload, datagram.time).parts
        if self._fits is not None:
            parts = tuple(filter(self._fits, parts))
            if not parts:
                return
        with self._lock:
            self._add(datagram, parts)

    def _add(self, datagram: Datagram, parts: tuple[Part, ...]) -> None:
        if self._problem is not None:
            raise self._problem
        if self._file is not None and self._is_full(self._file, datagram.time):
            self._complete()
        if self._file is None:
            self._file = self._open()
        if not self._start:
            self._start = self._flushed = datagram.time
        self._file.add(datagram, parts)
        self.recorded.datagrams += 1
        self.recorded.messages += len(parts)
        self._flush(self._file, datagram.time)

    def _flush(self, file: RunFile, now: float) -> None:
        self._is_flushed = False
        if now - self._flushed >= FLUSH_INTERVAL or now < self._flushed:
            file.flush()
            self._flushed, self._flushed_at, self._is_flushed = now, monotonic(), True

    def flush(self) -> None:
        """Write pictures that wait, and hand over to the operating system what was not in time; from any thread.

        An error is raised with the next datagram.
        """
        with self._lock:
            if self._file is None or self._problem is not None:
                return
            try:
                self._add_pictures(self._file)
                if not self._is_flushed and monotonic() - self._flushed_at >= FLUSH_INTERVAL:
                    self._file.flush()
                    self._flushed_at, self._is_flushed = monotonic(), True
            except OSError as error:
                self._problem = error

    def add_picture(self, picture: Picture) -> None:
        """Record a picture, from any thread; it is written with the next datagram."""
        self._pictures.append(picture)

    def write_pictures(self) -> None:
        """Write the pictures that wait, if a file is open."""
        with self._lock:
            if self._file is not None:
                self._add_pictures(self._file)

    def _add_pictures(self, file: RunFile) -> None:
        while self._pictures:
            camera, time, access_unit, is_idr = self._pictures.popleft()
            file.add_picture(camera, time, access_unit, is_idr=is_idr)
            self.recorded.pictures += 1
            self._flush(file, time)

    def close(self) -> None:
        """Complete the file that is written."""
        with self._lock:
            self._complete()

    def _complete(self) -> None:
        file, self._file = self._file, None
        if file is not None:
            try:
                self._add_pictures(file)
                file.close()
            finally:
                self.recorded.bytes += file.size

    def _is_full(self, file: RunFile, now: float) -> bool:
        limits = self._limits
        too_long = limits.seconds is not None and self._start > 0.0 and now - self._start >= limits.seconds
        return too_long or (limits.size is not None and file.size >= limits.size)

    def _open(self) -> RunFile:
        path = self._path
        if self._limits.rotates:
            self._number += 1
            path = path.with_stem(f"{path.stem}-{self._number:04d}")
        file = create(path, self._registry, self._robots, self._limits.size)
        self._start = 0.0
        files = self.recorded.files
        files.append(path)
        while self._limits.files is not None and len(files) > self._limits.files:
            files.pop(0).unlink(missing_ok=True)
        return file
