"""A flight recorder: keeps the last traffic in memory, and writes it to a file when something happens."""

from __future__ import annotations

import re
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from jauspy.capture.dissect import Part, dissect
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.protocol import judp
from jauspy.recording.incidents import Incident, IncidentDetector, Kind, may_show_incident
from jauspy.recording.run_files import RunFile, create

MAX_RING: Final = 64 << 20
"""Bytes of datagrams in memory, `OVERHEAD` included."""
OVERHEAD: Final = 300
"""Bytes of memory for a datagram beside its payload, about."""
MAX_FILE: Final = 256 << 20
"""Bytes of a file; while incidents go on, the next file follows."""
FLUSH_INTERVAL: Final = 0.5
"""Seconds after which what was recorded is handed to the operating system."""
_NAME: Final = re.compile(rf"\d{{8}}-\d{{6}}-({'|'.join(Kind)})(-\d+)?\.(mcap|pcapng)")
"""What follows the prefix in the name of a file."""


class Ring:
    """The datagrams of the last seconds, within a limit of bytes. Clocks that are set back by more empty it."""

    def __init__(self, seconds: float, size: int = MAX_RING) -> None:
        self._seconds, self._limit = seconds, size
        self._datagrams: deque[Datagram] = deque()
        self.size = 0
        """Bytes of what is kept."""
        self.dropped = 0
        """Datagrams that had to go before their time, for want of memory."""
        self.dropped_until = float("-inf")
        """The time of the last one of them."""

    def __len__(self) -> int:
        return len(self._datagrams)

    def __iter__(self) -> Iterator[Datagram]:
        return iter(self._datagrams)

    def add(self, datagram: Datagram) -> None:
        """Add a datagram; those that are too old go, and the oldest until it fits."""
        kept = self._datagrams
        kept.append(datagram)
        self.size += len(datagram.payload) + OVERHEAD
        while kept:
            is_old = abs(datagram.time - kept[0].time) > self._seconds
            if not is_old and self.size <= self._limit:
                return
            time = self._drop()
            if not is_old:
                self.dropped_until = time
                self.dropped += 1

    def _drop(self) -> float:
        oldest = self._datagrams.popleft()
        self.size -= len(oldest.payload) + OVERHEAD
        return oldest.time


@dataclass(frozen=True, slots=True)
class Folder:
    """Where files of incidents are, and how many of them are kept; the oldest are deleted for new ones."""

    path: Path
    prefix: str
    """Begins the names of the files that belong to this recorder; others are left alone."""
    suffix: str = ".mcap"
    files: int = 100
    size: int = 2 << 30
    """Bytes of all files."""

    def new(self, incident: Incident, at: float) -> Path:
        """A name that no file has, by time (UTC) and kind of the incident."""
        stem = f"{self.prefix}-{time.strftime('%Y%m%d-%H%M%S', time.gmtime(at))}-{incident.kind}"
        number, path = 1, self.path / f"{stem}{self.suffix}"
        while path.exists():
            number += 1
            path = self.path / f"{stem}-{number}{self.suffix}"
        return path

    def make_room(self) -> list[Path]:
        """Delete the oldest files until one more is within the limits; returns those that were deleted."""
        found = sorted((path.stat().st_mtime, path.stat().st_size, path) for path in self._own())
        total, deleted = sum(size for _, size, _ in found), []
        while found and (len(found) >= self.files or total + MAX_FILE > self.size):
            _, size, path = found.pop(0)
            path.unlink(missing_ok=True)
            total -= size
            deleted.append(path)
        return deleted

    def _own(self) -> Iterator[Path]:
        for path in self.path.iterdir():
            name = path.name.removeprefix(f"{self.prefix}-")
            if name != path.name and _NAME.fullmatch(name) and path.is_file():
                yield path


class FlightRecorder:
    """Writes the traffic from `before` an incident until `after` it, in seconds.

    An incident within the time of another one prolongs its file. Errors of writing are told to `log`; what is in memory
    stays there for the next incident.
    """

    def __init__(
        self,
        folder: Folder,
        registry: Registry,
        detector: IncidentDetector,
        *,
        before: float,
        after: float,
        log: Callable[[str], None],
    ) -> None:
        """Raises `ConfigError` if the folder cannot be made."""
        try:
            folder.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ConfigError(f"{folder.path} cannot be a folder of recordings: {error.strerror}") from None
        self.ring = Ring(before)
        self._folder, self._registry, self._detector = folder, registry, detector
        self._before, self._after, self._log = before, after, log
        self._dissector = Dissector(registry)
        """What has put together the large messages of the file that is written."""
        self._file: RunFile | None = None
        self._path = folder.path
        self._count = 0
        self._end = self._flushed = 0.0

    @property
    def is_recording(self) -> bool:
        """True while a file is written."""
        return self._file is not None

    def add(self, datagram: Datagram) -> None:
        """Keep a datagram, look for incidents in it, and record it while one is recent."""
        self.tick(datagram.time)
        was_recording = self.is_recording
        parts: Sequence[Part] = ()
        if was_recording:
            parts = self._dissector.dissect(datagram.payload, datagram.time).parts
        elif _may_show_incidents(datagram.payload):
            parts = dissect(datagram.payload, self._registry).parts
        self.ring.add(datagram)
        for incident in self._detector.incidents(parts):
            self._happened(incident, datagram.time)
        if was_recording:
            self._write(datagram, parts)

    def tick(self, now: float) -> None:
        """End a file whose time is over, and hand over what was recorded; `now` in seconds since 1970.

        To be called about once a second while there is no traffic.
        """
        if self._file is None:
            return
        if now > self._end:
            self.close()
        elif not 0.0 <= now - self._flushed < FLUSH_INTERVAL:
            self._flushed = now
            self._flush()

    def close(self) -> None:
        """Complete the file that is written."""
        file, self._file = self._file, None
        if file is not None and self._guarded(file.close):
            self._log(f"{self._path} is complete: {self._count} datagrams, {file.size} bytes")

    def _happened(self, incident: Incident, at: float) -> None:
        self._end = at + self._after
        what = f"{incident.kind} of {incident.component}"
        if self._file is not None:
            self._log(f"{what}: {self._path} goes on")
            return
        self._open(incident, at, what)
        self._dissector = Dissector(self._registry)
        for datagram in self.ring:
            self._write(datagram, self._dissector.dissect(datagram.payload, datagram.time).parts)
        self._flush()

    def _open(self, incident: Incident, at: float, what: str) -> None:
        self._incident, self._flushed, self._count = incident, at, 0
        try:
            for path in self._folder.make_room():
                self._log(f"{path} is deleted to make room")
            self._path = self._folder.new(incident, at)
            self._file = create(self._path, self._registry)
        except (OSError, ConfigError) as error:
            self._log(f"{what}: nothing is recorded: {error}")
            return
        reach = at - self.ring.dropped_until
        missing = f"; memory reached only {reach:.1f} s back" if reach < self._before else ""
        self._log(f"{what}: recording to {self._path}{missing}")

    def _write(self, datagram: Datagram, parts: Sequence[Part]) -> None:
        file = self._file
        if file is None:
            return
        if self._guarded(lambda: file.add(datagram, parts)):
            self._count += 1
            if file.size >= MAX_FILE:
                self.close()
                self._open(self._incident, datagram.time, f"{self._incident.kind} goes on")

    def _flush(self) -> None:
        if self._file is not None:
            self._guarded(self._file.flush)

    def _guarded(self, write: Callable[[], None]) -> bool:
        """Write; an error, as of a full disk, ends the file and is told."""
        try:
            write()
        except OSError as error:
            self._log(f"{self._path} is incomplete: {error.strerror}")
            file, self._file = self._file, None
            if file is not None:
                with suppress(OSError):  # the same one
                    file.close()
            return False
        return True


def _may_show_incidents(datagram: bytes) -> bool:
    packets, _ = judp.unpack_all(datagram)
    return any(may_show_incident(bytes(packet.payload)) for packet in packets)
