"""The worker process of a loudspeaker: receives sound, and plays it to a file, a sound card, and microphones."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable
from datetime import UTC, datetime
from itertools import islice
from pathlib import Path
from typing import Final

import numpy as np

from jauspy.audio.coding import FRAME, FRAME_TIME, Sound
from jauspy.audio.receiver import AudioReceiver
from jauspy.audio.sound_card import SoundCard, open_sound_card
from jauspy.audio.wav_files import MAX_LENGTH, WavWriter
from jauspy.audio.worker_messages import ChangeAudio, OpenPort, PlaySource, PortOpened, SoundPlayed, StartLoudspeaker
from jauspy.errors import ConfigError, TransportError
from jauspy.logs import get_logger
from jauspy.worker_process import CountersReport, Parent, WorkerReady

_LOG: Final = get_logger("jauspy.audio")

POLL: Final = 0.01
"""Seconds between two looks at the port while something is played."""
COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""
MAX_FILES: Final = 200
"""Recordings in a folder; when there are so many, nothing more is kept."""
MAX_BURST: Final = 50.0
"""Frames that are played at once, 1 s, of a sender that sends faster than in real time."""
SILENCE: Final = 2.0
"""Seconds without sound after which a recording ends."""


def run(start: StartLoudspeaker, parent: Parent) -> None:
    """Serve one loudspeaker until the parent closes the connection."""
    worker = LoudspeakerWorker(start, parent.send)
    try:
        while not parent.ended:
            for command in parent.receive(worker.timeout()):
                worker.execute(command)
            worker.play_received()
    finally:
        worker.close()


class LoudspeakerWorker:
    """One loudspeaker; `report` takes the messages to the parent.

    Counters: those of the receiver, `played` frames, `files` begun, `unrecorded` (sounds without a file),
    and `too_fast` ones (more than can be played).
    """

    def __init__(
        self, start: StartLoudspeaker, report: Callable[[object], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._setup, self._settings, self._report, self._clock = start.setup, start.settings, report, clock
        self._receiver: AudioReceiver | None = None
        self._source = PlaySource(frozenset())
        self._file: WavWriter | None = None
        self._card: SoundCard | None = open_sound_card(self._setup.name) if self._setup.sound_card else None
        self._counts: Counter[str] = Counter()
        """Its own, and those of receivers that were closed."""
        self._room = MAX_BURST
        """Frames that may be played now."""
        self._room_at = clock()
        self._host = ""
        self._rest = np.zeros(0, np.float32)
        self._heard_at = self._counted = clock()
        report(WorkerReady("plays to " + (self._setup.folder or "no file") + (", sound card" if self._card else "")))

    def timeout(self) -> float | None:
        """Seconds after which to look at the port; None while nothing is to be played."""
        return POLL if self._receiver is not None else None

    def execute(self, command: object) -> None:
        """Execute a command of the parent."""
        match command:
            case ChangeAudio(settings):
                self._settings = settings
            case OpenPort(host, port):
                self._open(host, port or self._setup.port)
            case PlaySource() if command != self._source:
                self._end()
                self._source = command

    def play_received(self) -> None:
        """Play what has arrived."""
        now = self._clock()
        if self._receiver is not None:
            for sound in self._receiver.take():
                self._heard_at = now
                self._play(sound)
            if self._file is not None and now - self._heard_at > SILENCE:
                self._end()
        if now - self._counted >= COUNTER_INTERVAL:
            self._counted = now
            self._report_counters()

    def close(self) -> None:
        """End the recording and close the port."""
        self._end()
        self._close_receiver()
        if self._card is not None:
            self._card.close()

    def _open(self, host: str, port: int) -> None:
        if self._receiver is None or self._host != host:
            self._end()
            self._close_receiver()
            self._host = host
            try:
                self._receiver = AudioReceiver(host, port, only=self._may_send)
            except TransportError as error:
                _LOG.warning("loudspeaker %s: %s", self._setup.name, error)
        self._report(PortOpened(host, self._receiver.port if self._receiver else 0))

    def _may_send(self, host: str, port: int) -> bool:
        return host in self._source.hosts and self._source.port in (None, port)

    def _play(self, sound: Sound) -> None:
        now, frames = self._clock(), len(sound) / FRAME
        self._room = min(MAX_BURST, self._room + (now - self._room_at) / FRAME_TIME)
        self._room_at = now
        if frames > self._room:
            self._counts["too_fast"] += 1
            return
        self._room -= frames
        sound = np.clip(sound * np.float32(2.0 * self._settings.gain), -1.0, 1.0)
        self._record(sound)
        if self._card is not None:
            self._card.play(sound)
        self._rest = np.concatenate([self._rest, sound])
        while len(self._rest) >= FRAME:
            self._counts["played"] += 1
            self._report(SoundPlayed(self._setup.name, self._rest[:FRAME].tobytes()))
            self._rest = self._rest[FRAME:]

    def _record(self, sound: Sound) -> None:
        if self._setup.folder is None:
            return
        if self._file is None:
            try:
                self._file = _new_file(Path(self._setup.folder), self._setup.name, datetime.now(UTC))
            except ConfigError as error:
                if not self._counts["unrecorded"]:
                    _LOG.warning("loudspeaker %s: %s", self._setup.name, error)
                self._counts["unrecorded"] += 1
                return
            self._counts["files"] += 1
        self._file.add(sound)
        if self._file.seconds >= MAX_LENGTH:
            self._end()

    def _end(self) -> None:
        """Play the rest, and complete the recording."""
        if self._receiver is not None:
            for sound in (*self._receiver.take(), *self._receiver.end()):
                self._play(sound)
        if self._file is not None:
            self._file.close()
            self._file = None
            self._report_counters()

    def _close_receiver(self) -> None:
        if self._receiver is not None:
            self._counts += Counter(self._receiver.counters)
            self._receiver.close()
            self._receiver = None

    def _report_counters(self) -> None:
        received = Counter(self._receiver.counters if self._receiver is not None else {})
        self._report(CountersReport(self._counts + received))


def _new_file(folder: Path, name: str, now: datetime) -> WavWriter:
    """A new file in the folder, which is made if it is missing, with the name of the loudspeaker and the time."""
    try:
        folder.mkdir(exist_ok=True)
        if folder.is_symlink():
            raise ConfigError(f"{folder}: is a link, and recordings are not written to where it leads")
        count = sum(1 for _ in islice(folder.iterdir(), MAX_FILES))
    except OSError as error:
        raise ConfigError(f"{folder}: cannot hold recordings: {error.strerror}") from error
    if count >= MAX_FILES:
        raise ConfigError(f"{folder}: has {MAX_FILES} files already, so nothing more is recorded; move them away")
    return WavWriter(folder / f"{name}-{now:%Y%m%d-%H%M%S-%f}.wav", new=True)
