"""Writes received pictures to a file without encoding them again. Import it after `extra.need_video`."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from fractions import Fraction
from io import BytesIO
from pathlib import Path
from types import TracebackType
from typing import Final, Self

import av
from av.container import OutputContainer
from av.error import FFmpegError
from av.video.stream import VideoStream

from jauspy.errors import ConfigError
from jauspy.video import h264_payload
from jauspy.video.h264 import H264Decoder
from jauspy.video.h264_payload import Picture
from jauspy.video.receiver import CONFIRMED
from jauspy.video.rtp import CLOCK_RATE

_TICK: Final = Fraction(1, CLOCK_RATE)
_AFTER_RESTART: Final = CLOCK_RATE // 10
"""Ticks from the last picture of one source to the first of the next, since the real time is not known."""


_FRAGMENTS: Final = {
    "movflags": "frag_keyframe+empty_moov+default_base_moof",
    "frag_duration": "500000",  # microseconds
    "cluster_time_limit": "500",  # milliseconds, of Matroska
    "flush_packets": "1",
}
"""Options of the containers: a file without its end can be read."""


class Recorder:
    """Records from the first whole IDR picture on, as `.mp4` or `.mkv`, by the suffix of the path.

    The file is written in parts of half a second, each of which can be read when the program is killed or the disk is
    full. A file has one image size: after a change of the parameter sets, and when the file cannot be written, `ended`
    is true and pictures are ignored.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._container = self._open()
        self._stream: VideoStream | None = None
        self._parameters: bytes = b""
        self._first = self._last = self._source = 0
        self._error: ConfigError | None = None
        self._complete = 0
        """Size of the file without a part that could not be written."""
        self.pictures = 0
        self.ended = False

    def add(self, picture: Picture) -> None:
        """Write a picture at the time of its time stamp; `close` raises errors of the file."""
        if self.ended:
            return
        parameters = h264_payload.join_nals(
            unit for unit in picture.nals if h264_payload.nal_type(unit) in {h264_payload.SPS, h264_payload.PPS}
        )
        if self._stream is not None and parameters and parameters != self._parameters:
            if picture.source == self._source or self.pictures >= CONFIRMED:
                self.ended = True
            else:  # what was recorded were stray packets of another source
                self._begin_anew()
        if self._stream is None and picture.is_idr and picture.whole:
            self._begin(picture, parameters)
        if self._stream is not None and not self.ended:
            self._write(self._stream, picture)

    def close(self) -> None:
        """Close the file; without effect when closed. Raises `ConfigError` if not all could be written."""
        self.ended = True
        with self._writing():
            self._container.close()
        error, self._error = self._error, None
        if error is not None:
            with suppress(OSError):  # no regular file
                os.truncate(self._path, self._complete)
            raise error

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is None:
            self.close()
            return
        with suppress(ConfigError):  # the error that ended it says more
            self.close()

    def _open(self) -> OutputContainer:
        try:
            return av.open(str(self._path), "w", container_options=_FRAGMENTS)
        except (OSError, ValueError, FFmpegError) as error:
            raise ConfigError(f"cannot record to {self._path}: {error}; the name should end in .mp4 or .mkv") from error

    def _begin_anew(self) -> None:
        with self._writing():
            self._container.close()
            self._container = av.open(str(self._path), "w", container_options=_FRAGMENTS)
            self._stream, self.pictures = None, 0

    def _begin(self, picture: Picture, parameters: bytes) -> None:
        """Create the container's stream, with size and parameter sets of this picture, if it can be decoded."""
        if H264Decoder().decode(picture) is None:
            return
        try:
            with av.open(BytesIO(h264_payload.join_nals(picture.nals)), format="h264") as sample:
                stream = self._container.add_stream_from_template(sample.streams.video[0])
        except (FFmpegError, IndexError):
            return
        stream.time_base = _TICK
        self._stream, self._parameters = stream, parameters
        self._first, self._last, self._source = picture.timestamp, -1, picture.source

    def _write(self, stream: VideoStream, picture: Picture) -> None:
        packet = av.Packet(h264_payload.join_nals(picture.nals))
        packet.stream, packet.time_base, packet.is_keyframe = stream, _TICK, picture.is_idr
        if picture.source != self._source:  # its camera was restarted, with another clock
            self._first, self._source = picture.timestamp - self._last - _AFTER_RESTART, picture.source
        elapsed = (picture.timestamp - self._first) & 0xFFFFFFFF
        self._last = max(elapsed, self._last + 1)
        packet.pts = packet.dts = self._last
        with self._writing():
            self._container.mux(packet)
            self.pictures += 1
            self._complete = self._path.stat().st_size

    @contextmanager
    def _writing(self) -> Iterator[None]:
        try:
            yield
        except (OSError, FFmpegError) as error:
            self.ended = True
            reason = getattr(error, "strerror", None) or error
            self._error = self._error or ConfigError(
                f"cannot write {self._path}: {reason}; what was recorded before can be read, but for the last second"
            )
