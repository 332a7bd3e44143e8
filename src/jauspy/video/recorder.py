"""Writes received pictures to a film, as they came: nothing is encoded again. Import it after `extra.need_video`."""

from __future__ import annotations

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
from jauspy.video.h264_payload import Picture
from jauspy.video.rtp import CLOCK_RATE

_TICK: Final = Fraction(1, CLOCK_RATE)
_AFTER_RESTART: Final = CLOCK_RATE // 10
"""Ticks from the last picture of one source to the first of the next, since the real time is not known."""


class Recorder:
    """Records from the first whole IDR picture on, as `.mp4` or `.mkv`, by the suffix of the path.

    A file has one image size: after a change of the parameter sets, `ended` is true and pictures are ignored.
    """

    def __init__(self, path: Path) -> None:
        try:
            self._container: OutputContainer = av.open(str(path), "w")
        except (OSError, ValueError, FFmpegError) as error:
            raise ConfigError(f"cannot record to {path}: {error}; the name should end in .mp4 or .mkv") from error
        self._stream: VideoStream | None = None
        self._parameters: bytes = b""
        self._first = self._last = self._source = 0
        self.pictures = 0
        self.ended = False

    def add(self, picture: Picture) -> None:
        """Write a picture at the time of its time stamp."""
        parameters = h264_payload.join_nals(
            unit for unit in picture.nals if h264_payload.nal_type(unit) in {h264_payload.SPS, h264_payload.PPS}
        )
        if self._stream is None:
            if picture.is_idr and picture.whole:
                self._begin(picture, parameters)
        elif parameters and parameters != self._parameters:
            self.ended = True
        if self._stream is not None and not self.ended:
            self._write(self._stream, picture)

    def close(self) -> None:
        """Close the file; without effect when closed."""
        self._container.close()
        self.ended = True

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _begin(self, picture: Picture, parameters: bytes) -> None:
        """Create the container's stream, with size and parameter sets of this picture."""
        try:
            with av.open(BytesIO(h264_payload.join_nals(picture.nals)), format="h264") as sample:
                stream = self._container.add_stream_from_template(sample.streams.video[0])
        except (FFmpegError, IndexError):  # not decodable
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
        self._container.mux(packet)
        self.pictures += 1
