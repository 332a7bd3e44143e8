"""WAV files: read as sound at 48 kHz, and written sample by sample. Needs NumPy and PyAV."""

from __future__ import annotations

import os
import wave
from pathlib import Path
from types import TracebackType
from typing import Final, Self

import av
import numpy as np
from av.audio.resampler import AudioResampler
from av.error import FFmpegError

from jauspy.audio.coding import FRAME, Sound
from jauspy.errors import ConfigError
from jauspy.platform.sound import SAMPLE_RATE

MAX_LENGTH: Final = 600.0
"""Seconds of a file that is read or written; the rest is left out."""
_SUFFIX: Final = ".wav"


def read_wav(path: Path) -> Sound:
    """The sound of a file, one channel; raises `ConfigError`."""
    if not path.is_file():
        raise ConfigError(f"{path}: is no file; give a WAV file")
    parts: list[Sound] = []
    count = 0
    try:
        with av.open(str(path), format="wav") as container:
            if not container.streams.audio:
                raise ConfigError(f"{path}: has no sound in it")
            resampler = AudioResampler("flt", "mono", SAMPLE_RATE)
            for frame in container.decode(container.streams.audio[0]):
                for converted in resampler.resample(frame):
                    parts.append(converted.to_ndarray()[0])
                    count += len(parts[-1])
                if count > MAX_LENGTH * SAMPLE_RATE:
                    raise ConfigError(f"{path}: is longer than {MAX_LENGTH:g} s; cut it into several files")
            parts += [converted.to_ndarray()[0] for converted in resampler.resample(None)]
    except (FFmpegError, OSError, ValueError) as error:
        raise ConfigError(f"{path}: is not a WAV file that can be read: {error}") from error
    sound = np.concatenate(parts) if parts else np.zeros(0, np.float32)
    if not len(sound):
        raise ConfigError(f"{path}: has no sound in it")
    return np.clip(np.nan_to_num(sound), -1.0, 1.0).astype(np.float32)


def padded(sound: Sound, lead: float) -> Sound:
    """The sound with so many seconds of silence before and after it, in whole frames."""
    silence = round(lead * SAMPLE_RATE)
    return np.pad(sound, (silence, silence + -(len(sound) + 2 * silence) % FRAME))


def check_wav_name(path: Path) -> None:
    """Raise `ConfigError` unless a recording can be written there."""
    if path.suffix.lower() != _SUFFIX:
        raise ConfigError(f"{path}: recordings are WAV files; give a name that ends in {_SUFFIX}")
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise ConfigError(f"{path}: cannot be written: it is a folder, or its folder is not there")
    if not os.access(path if path.exists() else path.absolute().parent, os.W_OK):
        raise ConfigError(f"{path}: cannot be written; choose another file")


class WavWriter:
    """Writes one channel of 16 bits at 48 kHz; `seconds` have been written. Raises `ConfigError` for a bad path."""

    def __init__(self, path: Path, *, new: bool = False) -> None:
        self.path = path
        self.samples = 0
        try:
            self._stream = path.open("xb" if new else "wb")
            self._file = wave.open(self._stream, "wb")  # noqa: SIM115 - closed by `close`
        except OSError as error:
            raise ConfigError(f"{path}: cannot be written: {error.strerror}") from error
        self._file.setnchannels(1)
        self._file.setsampwidth(2)
        self._file.setframerate(SAMPLE_RATE)

    @property
    def seconds(self) -> float:
        """Seconds that have been written."""
        return self.samples / SAMPLE_RATE

    def add(self, sound: Sound) -> None:
        """Write sound, up to `MAX_LENGTH` in all."""
        room = max(0, round(MAX_LENGTH * SAMPLE_RATE) - self.samples)
        integers = np.clip(np.rint(sound[:room] * 32767.0), -32768, 32767).astype("<i2")
        self._file.writeframes(integers.tobytes())
        self.samples += len(integers)

    def close(self) -> None:
        """Complete the file; without effect when closed."""
        self._file.close()
        self._stream.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
