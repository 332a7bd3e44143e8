"""The sound card of the machine, by the package `sounddevice` (PortAudio), which is optional."""

from __future__ import annotations

from collections import deque
from importlib import import_module
from typing import Any, Final, Protocol

import numpy as np

from jauspy.audio.coding import FRAME, Sound
from jauspy.logs import get_logger
from jauspy.platform.sound import SAMPLE_RATE

_LOG: Final = get_logger("jauspy.audio")

MAX_WAITING: Final = 25
"""Pieces of sound that wait for the card, 0.5 s; the oldest go first."""


class SoundCard(Protocol):
    """Plays sound as it comes. No method blocks."""

    def play(self, sound: Sound) -> None:
        """Play this after what waits."""
        ...

    def close(self) -> None:
        """Stop."""
        ...


def open_sound_card(name: str) -> SoundCard | None:
    """The default sound card; None, and a sentence in the log, if there is none or `sounddevice` is not installed."""
    try:
        return _PortAudioCard(import_module("sounddevice"))
    except (ImportError, OSError) as error:
        _LOG.warning("loudspeaker %s: no sound card is used: %s (pip install sounddevice)", name, error)
    except Exception as error:  # noqa: BLE001 - PortAudioError, of a package that may be missing
        _LOG.warning("loudspeaker %s: no sound card is used: %s", name, error)
    return None


class _PortAudioCard:
    def __init__(self, library: Any) -> None:
        self._waiting: deque[Sound] = deque(maxlen=MAX_WAITING)
        self._rest = np.zeros(0, np.float32)
        self._stream = library.OutputStream(
            samplerate=SAMPLE_RATE, channels=1, dtype="float32", blocksize=FRAME, callback=self._fill
        )
        self._stream.start()

    def play(self, sound: Sound) -> None:
        self._waiting.append(sound)

    def close(self) -> None:
        self._stream.close()

    def _fill(self, output: Any, frames: int, _time: object, _status: object) -> None:
        """Called by the thread of PortAudio: the next samples, silence if there are none."""
        while len(self._rest) < frames and self._waiting:
            self._rest = np.concatenate([self._rest, self._waiting.popleft()])
        found, self._rest = self._rest[:frames], self._rest[frames:]
        output[: len(found), 0] = found
        output[len(found) :, 0] = 0.0
