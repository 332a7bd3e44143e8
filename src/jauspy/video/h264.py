"""Pictures to H.264 by libx264, without a delay of pictures. Import it after `extra.need_video`."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import TYPE_CHECKING, Final

import av
import cv2
import numpy as np
from av.codec.context import Flags
from av.error import FFmpegError
from av.video.codeccontext import VideoCodecContext
from av.video.frame import PictureType
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import LEVELS, H264Profile, VideoSettings
from jauspy.video import h264_payload
from jauspy.video.h264_payload import MAX_PAYLOAD, Picture

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

VBV_BUFFER: Final = 0.25
"""Seconds of the bit rate that one picture may take at most, so that IDR pictures do not flood the network."""


class H264Encoder:
    """Encodes one slice per NAL unit and RTP packet, so that a lost packet damages only a part of a picture.

    Every IDR comes with its parameter sets (SPS, PPS). `settings` may be changed at any time: the next picture is an
    IDR of a fresh encoder, which takes 4 ms to open.
    """

    def __init__(self, settings: VideoSettings = VideoSettings()) -> None:  # noqa: B008 - frozen
        self._settings = settings
        self._codec: VideoCodecContext | None = None
        self._count = 0

    @property
    def settings(self) -> VideoSettings:
        """The settings of the encoder from the next picture on."""
        return self._settings

    @settings.setter
    def settings(self, settings: VideoSettings) -> None:
        if settings != self._settings:
            self._settings = settings
            self._codec = None

    def encode(self, image: Image, *, idr: bool = False) -> list[bytes]:
        """The NAL units of an image in red, green and blue, of shape (height, width, 3) as in `settings`.

        With `idr`, decoders can start with this picture. Raises `ConfigError` for an image of another size.
        """
        size = self._settings.height, self._settings.width
        if image.shape[:2] != size:
            raise ConfigError(f"video: a picture of {image.shape[1]}x{image.shape[0]} for {size[1]}x{size[0]}")
        if self._codec is None:
            self._codec = _open(self._settings)
        planes: NDArray[np.uint8] = np.asarray(cv2.cvtColor(image, cv2.COLOR_RGB2YUV_I420), np.uint8)
        frame = av.VideoFrame.from_ndarray(planes, format="yuv420p")
        frame.pts = self._count
        frame.pict_type = PictureType.I if idr else PictureType.NONE
        self._count += 1
        return h264_payload.split_nals(b"".join(bytes(packet) for packet in self._codec.encode(frame)))


def _open(settings: VideoSettings) -> VideoCodecContext:
    codec = av.CodecContext.create("libx264", "w")
    assert isinstance(codec, VideoCodecContext)
    codec.width, codec.height, codec.pix_fmt = settings.width, settings.height, "yuv420p"
    codec.framerate = Fraction(settings.rate)
    codec.time_base = Fraction(1, settings.rate)
    codec.bit_rate = settings.bit_rate
    codec.gop_size = settings.gop
    codec.max_b_frames = 0
    codec.thread_count = 1
    codec.options = {
        "preset": settings.coding.preset.value,
        "tune": "zerolatency",
        "profile": settings.coding.profile.value,
        "forced-idr": "1",
        "x264-params": ":".join(f"{name}={value}" for name, value in _parameters(settings).items()),
    }
    codec.open()
    return codec


def _parameters(settings: VideoSettings) -> dict[str, object]:
    """Parameters of x264 by its own names; the presets leave out coding tools that a profile is meant to have."""
    rate, profile = settings.bit_rate // 1000, settings.coding.profile
    level = {} if settings.level is None else {"level": LEVELS[settings.level].name}
    return level | {
        "slice-max-size": MAX_PAYLOAD,
        "vbv-maxrate": rate,
        "vbv-bufsize": round(rate * VBV_BUFFER),
        "scenecut": 0,
        "cabac": int(profile is not H264Profile.BASELINE),
        "8x8dct": int(profile is H264Profile.HIGH),
        "intra-refresh": int(settings.coding.gradual),
    }


class H264Decoder:
    """Decodes pictures without delay.

    Counters: `decoded`, `undecodable` (pictures without an image, or with an error).
    """

    def __init__(self) -> None:
        self.counters: Counter[str] = Counter()
        codec = av.CodecContext.create("h264", "r")
        assert isinstance(codec, VideoCodecContext)
        codec.thread_count = 1
        codec.flags |= Flags.low_delay
        self._codec = codec

    def decode(self, picture: Picture) -> Image | None:
        """The image, of shape (height, width, 3) in red, green and blue; None when it cannot be decoded."""
        try:
            frames = self._codec.decode(av.Packet(h264_payload.join_nals(picture.nals)))
        except FFmpegError:
            frames = []
        if not frames:
            self.counters["undecodable"] += 1
            return None
        self.counters["decoded"] += 1
        return frames[-1].to_ndarray(format="rgb24")  # type: ignore[return-value]  # PyAV does not say of which numbers
