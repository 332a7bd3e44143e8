"""The worker process of a simulated microphone: mixes, encodes and sends what it hears."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final

import numpy as np

from jauspy.audio.coding import FRAME_TIME
from jauspy.audio.hearing import Hearing
from jauspy.audio.sender import AudioSender
from jauspy.audio.worker_messages import (
    AddListener,
    ChangeAudio,
    MachineMoved,
    RemoveListener,
    SoundPlayed,
    StartMicrophone,
)
from jauspy.errors import JausError
from jauspy.worker_process import CountersReport, Parent, WorkerReady

COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""
MAX_LAG: Final = 0.2
"""Seconds that the worker may be late; what it could not send by then is left out."""


def run(start: StartMicrophone, parent: Parent) -> None:
    """Serve one microphone until the parent closes the connection."""
    worker = MicrophoneWorker(start, parent.send)
    try:
        while not parent.ended:
            for command in parent.receive(worker.time_to_frame()):
                worker.execute(command)
            worker.send_due()
    finally:
        worker.close()


class MicrophoneWorker:
    """One microphone; `report` takes the messages to the parent.

    Counters: those of the sender, `skipped` frames, and `refused` addresses.
    """

    def __init__(
        self, start: StartMicrophone, report: Callable[[object], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._report, self._clock = report, clock
        self._hearing = Hearing(start.scene)
        self._sender = AudioSender(start.scene.microphone.name)
        self._gain = 1.0
        self._apply(ChangeAudio(start.settings))
        self._due = self._counted = clock()
        report(WorkerReady("a synthesis of tracks, motors and loudspeakers"))

    def time_to_frame(self) -> float | None:
        """Seconds until the next frame is due; None while nobody listens."""
        return max(0.0, self._due - self._clock()) if self._sender.playing else None

    def execute(self, command: object) -> None:
        """Execute a command of the parent."""
        match command:
            case MachineMoved(state):
                self._hearing.update(state)
            case SoundPlayed(loudspeaker, frame):
                self._hearing.play(loudspeaker, np.frombuffer(frame, np.float32))
            case AddListener(address, playing, coding):
                was_playing = self._sender.playing
                try:
                    self._sender.add(address, coding, playing=playing)
                except JausError:
                    self._sender.counters["refused"] += 1
                if not was_playing:
                    self._due = self._clock()
            case RemoveListener(address):
                self._sender.remove(address)
            case ChangeAudio():
                self._apply(command)

    def send_due(self) -> None:
        """Send the frames that are due."""
        now = self._clock()
        while self._sender.playing and self._due <= now:
            if now - self._due > MAX_LAG:
                self._sender.counters["skipped"] += round((now - self._due) / FRAME_TIME)
                self._due = now
            frame = np.clip(self._hearing.frame() * np.float32(self._gain), -1.0, 1.0)
            self._sender.send(frame, now, time.time())
            self._due += FRAME_TIME
        if now - self._counted >= COUNTER_INTERVAL:
            self._counted = now
            self._report(CountersReport(dict(self._sender.counters)))

    def close(self) -> None:
        """Close the sockets."""
        self._sender.close()

    def _apply(self, change: ChangeAudio) -> None:
        self._gain, self._sender.bit_rate = 2.0 * change.settings.gain, change.settings.bit_rate
