"""The logger of a robot's traffic for the service DataLogging: a worker process (`run`) writes the files.

The files are in one folder, with names made of the robot's id and the time, so that no client chooses a path. All
together have at most the bytes of the settings; the oldest are deleted for new ones.
"""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from jauspy.capture.dissect import Part
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.errors import ConfigError, TransportError
from jauspy.inspection.live import LiveCapture
from jauspy.logs import get_logger
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    RejectControl,
    ReleaseControl,
    RequestControl,
    Reset,
    SetEmergency,
    Shutdown,
)
from jauspy.recording.run_files import RunFile, create
from jauspy.services.iop import LogLevel, LogSettings, LogState, LogStatus
from jauspy.worker_process import CountersReport, Parent, SupervisedWorker

_LOG: Final = get_logger("jauspy.traffic_log")

NICENESS: Final = 10
"""Nice value above that of the robot's process."""
MAX_SIZE: Final = 1_000_000_000
"""Bytes of all files."""
FILES: Final = 8
"""A log is split into files of this part of the size, so that the oldest can give way."""
REPORT_INTERVAL: Final = 0.25
"""Seconds between two reports of the worker."""
RECONNECT_DELAY: Final = 1.0
"""Seconds until the worker looks for the node manager's traffic again."""
FLUSH_INTERVAL: Final = 0.5
"""Seconds of traffic after which it is handed to the operating system."""

CRITICAL: Final = frozenset({SetEmergency.CODE, ClearEmergency.CODE, Reset.CODE, Shutdown.CODE})
CONTROL: Final = frozenset({RequestControl.CODE, ReleaseControl.CODE, ConfirmControl.CODE, RejectControl.CODE})


@dataclass(frozen=True, slots=True)
class LogPlace:
    """Whose traffic is recorded, where it is seen, and where the files go."""

    subsystem: int
    root: Path
    """The local root of the node manager, which shows its traffic there."""
    folder: Path


@dataclass(frozen=True, slots=True)
class _Order:
    """Order for the worker, from now on."""

    state: LogState
    settings: LogSettings


@dataclass(frozen=True, slots=True)
class _Progress:
    """Report of the worker on what it has written."""

    size: int
    began: float | None
    ended: float | None
    """Seconds since 1970."""
    problem: str


class TrafficLog(SupervisedWorker):
    """Records between `open` and `close` while it is switched on; its process starts when it is switched on first.

    Counters: `datagrams` that were recorded, `lost` ones not read in time, `deleted` files, workers `started`.
    A problem, as a full disk, is logged and ends the log: its state is off then.
    """

    def __init__(self, place: LogPlace) -> None:
        super().__init__("jauspy.robot.traffic_log", NICENESS, "traffic log", _LOG)
        self._place = place
        self._order = _Order(LogState.OFF, LogSettings(size=MAX_SIZE))
        self._progress = _Progress(size_of(place), None, None, "")

    @property
    def max_size(self) -> int:
        """The most bytes that all files may have."""
        return MAX_SIZE

    @property
    def settings(self) -> LogSettings:
        """The present settings."""
        return self._order.settings

    @property
    def status(self) -> LogStatus:
        """The present status."""
        progress = self._progress
        return LogStatus(self._order.state, progress.size, _utc(progress.began), _utc(progress.ended))

    def configure(self, settings: LogSettings) -> None:
        """Change the settings, also of the log that is being written."""
        self._give(_Order(self._order.state, settings))

    def switch(self, state: LogState) -> None:
        """Change the state; the worker starts with the first log."""
        self._give(_Order(state, self._order.settings))
        if state is LogState.ON:
            self._supervise()

    async def open(self) -> None:
        """Allow logs; the folder is made for the first one. Raises `ConfigError` if there is a file in its place."""
        if self._place.folder.exists() and not self._place.folder.is_dir():
            raise ConfigError(f"{self._place.folder} is no folder, and recordings need one; choose another")

    @property
    def _descriptors(self) -> Sequence[int]:
        return ()

    def _give(self, order: _Order) -> None:
        self._order = order
        self._send(order)

    def _on_started(self) -> None:
        self._send(self._place)
        self._send(self._order)

    def _on_message(self, message: object) -> None:
        super()._on_message(message)
        if isinstance(message, _Progress):
            if message.problem:
                _LOG.error("the log of traffic ends: %s", message.problem)
                self._give(_Order(LogState.OFF, self._order.settings))
            self._progress = message


def _utc(seconds: float | None) -> datetime | None:
    return None if seconds is None else datetime.fromtimestamp(seconds, UTC)


# --- in the worker ----------------------------------------------------------------------------------------------------


def run(place: LogPlace, parent: Parent) -> None:
    """Record as ordered until the parent closes the connection."""
    writer = LogWriter(place)
    lock = threading.Lock()
    threading.Thread(target=_listen, args=(place, writer, lock), name="traffic", daemon=True).start()
    reported: object = None
    try:
        while not parent.ended:
            for message in parent.receive(REPORT_INTERVAL):
                if isinstance(message, _Order):
                    with lock:
                        writer.obey(message)
            with lock:
                writer.flush()
                progress, counters = writer.progress, dict(writer.counters)
                writer.problem = ""
            if (progress, counters) != reported:
                parent.send(progress)
                parent.send(CountersReport(counters))
                reported = (progress, counters)
    finally:
        with lock:
            writer.close()


def _listen(place: LogPlace, writer: LogWriter, lock: threading.Lock) -> None:
    """Give the writer what the node manager routes, also after the node manager was started again."""
    while True:
        try:
            capture = LiveCapture(place.root)
        except TransportError as error:
            _LOG.warning("%s", error)
            time.sleep(RECONNECT_DELAY)
            continue
        lost = 0
        with closing(capture):
            for datagram in capture:
                with lock:
                    writer.add(datagram)
                    writer.counters["lost"] += capture.lost - lost
                lost = capture.lost


class LogWriter:
    """Writes what concerns one robot into files below the folder, within the size of the settings."""

    def __init__(self, place: LogPlace) -> None:
        self._place = place
        self._order = _Order(LogState.OFF, LogSettings(size=MAX_SIZE))
        self._dissector = Dissector(registry)
        self._file: RunFile | None = None
        self._others = size_of(place)
        """Bytes of the files that are complete."""
        self._flushed, self._is_flushed = 0.0, True
        self._began: float | None = None
        self._ended: float | None = None
        self.counters = {"datagrams": 0, "lost": 0, "deleted": 0}
        self.problem = ""
        """Why the log has ended; empty if it was not because of a problem."""

    @property
    def progress(self) -> _Progress:
        """Report on the files written so far."""
        size = self._others + (self._file.size if self._file is not None else 0)
        return _Progress(size, self._began, self._ended, self.problem)

    def obey(self, order: _Order) -> None:
        """Change state and settings; on from off begins a new log."""
        before, self._order = self._order, order
        if order.state is LogState.OFF:
            self.close()
        elif order.state is LogState.ON and before.state is LogState.OFF:
            self._began = self._ended = None
            self._guarded(self._open)
        elif self._file is not None:
            self._guarded(self._file.flush)

    def add(self, datagram: Datagram) -> None:
        """Record a datagram if the log is on, and one of its messages is the robot's and of a recorded level."""
        if self._order.state is not LogState.ON or self._file is None:
            return
        parts = self._dissector.dissect(datagram.payload, datagram.time).parts
        parts = tuple(part for part in parts if self._is_own(part) and level_of(part) in self._order.settings.levels)
        if not parts:
            return
        self._guarded(lambda: self._write(datagram, parts))

    def flush(self) -> None:
        """Hand over to the operating system what was recorded, also while nothing comes."""
        now = time.time()
        if self._file is not None and not self._is_flushed and not 0.0 <= now - self._flushed < FLUSH_INTERVAL:
            self._flushed, self._is_flushed = now, True
            self._guarded(self._file.flush)

    def close(self) -> None:
        """Complete the file that is written."""
        file, self._file = self._file, None
        if file is not None:
            try:
                file.close()
            except OSError as error:
                self.problem = f"a file is incomplete: {error.strerror}"
            self._others = size_of(self._place)

    def _is_own(self, part: Part) -> bool:
        own = self._place.subsystem
        return own in (part.packet.source.subsystem, part.packet.destination.subsystem)

    def _write(self, datagram: Datagram, parts: Sequence[Part]) -> None:
        if self._file is not None and self._file.size >= self._order.settings.size // FILES:
            self.close()
            self._open()
        if self._file is None:
            return
        self._file.add(datagram, parts)
        self.counters["datagrams"] += 1
        self._ended = datagram.time
        if self._began is None:
            self._began = datagram.time
        self._is_flushed = False
        if not 0.0 <= datagram.time - self._flushed < FLUSH_INTERVAL:
            self._flushed = datagram.time
            self._file.flush()
            self._is_flushed = True

    def _open(self) -> None:
        self._place.folder.mkdir(parents=True, exist_ok=True)
        size = self._order.settings.size
        self._make_room()
        stem = f"{self._place.subsystem}-log-{time.strftime('%Y%m%d-%H%M%S', time.gmtime())}"
        suffix = ".mcap" if find_spec("foxglove") is not None else ".pcapng"
        number, path = 1, self._place.folder / f"{stem}{suffix}"
        while path.exists() or path.is_symlink():
            number += 1
            path = self._place.folder / f"{stem}-{number}{suffix}"
        self._file = create(path, registry, limit=size // FILES)
        self._others = size_of(self._place, without=path)

    def _make_room(self) -> None:
        """Delete the oldest files until one more is within the size."""
        size = self._order.settings.size
        found = sorted((path.stat().st_mtime, path.stat().st_size, path) for path in own_files(self._place))
        total = sum(length for _, length, _ in found)
        while found and total + size // FILES > size:
            _, length, path = found.pop(0)
            path.unlink(missing_ok=True)
            total -= length
            self.counters["deleted"] += 1

    def _guarded(self, write: Callable[[], None]) -> None:
        """Write; an error ends the log."""
        try:
            write()
        except (OSError, ConfigError) as error:
            self.problem = str(error)
            self._order = _Order(LogState.OFF, self._order.settings)
            self.close()


def own_files(place: LogPlace) -> Iterator[Path]:
    """The files that logs of this robot have made; others, and links, are left alone."""
    pattern = re.compile(rf"{place.subsystem}-log-\d{{8}}-\d{{6}}(-\d+)?\.(mcap|pcapng)")
    if place.folder.is_dir():
        for path in place.folder.iterdir():
            if pattern.fullmatch(path.name) and path.is_file() and not path.is_symlink():
                yield path


def size_of(place: LogPlace, without: Path | None = None) -> int:
    """Bytes of all files of this robot's logs."""
    return sum(path.stat().st_size for path in own_files(place) if path != without)


def level_of(part: Part) -> LogLevel:
    """The level of a message."""
    message, code = part.content.message, part.content.code
    if code in CRITICAL:
        return LogLevel.CRITICAL
    is_command = message is not None and message.IS_COMMAND
    return LogLevel.INFORMATION if is_command or code in CONTROL else LogLevel.VERBOSE
