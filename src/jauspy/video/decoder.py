"""H.264 to pictures, each as soon as its last packet is there. Import it after `extra.need_video`."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import av
from av.codec.context import Flags
from av.error import FFmpegError
from av.video.codeccontext import VideoCodecContext

from jauspy.video import h264_payload
from jauspy.video.h264_payload import Picture

if TYPE_CHECKING:
    from jauspy.platform.camera import Image


class H264Decoder:
    """Counters: `decoded`, `undecodable` (pictures from which the decoder made none, or an error)."""

    def __init__(self) -> None:
        self.counters: Counter[str] = Counter()
        codec = av.CodecContext.create("h264", "r")
        assert isinstance(codec, VideoCodecContext)
        codec.thread_count = 1
        codec.flags |= Flags.low_delay
        self._codec = codec

    def decode(self, picture: Picture) -> Image | None:
        """The image, red, green and blue; None when the decoder cannot make one of it."""
        try:
            frames = self._codec.decode(av.Packet(h264_payload.join_nals(picture.nals)))
        except FFmpegError:
            frames = []
        if not frames:
            self.counters["undecodable"] += 1
            return None
        self.counters["decoded"] += 1
        return frames[-1].to_ndarray(format="rgb24")  # type: ignore[return-value]  # PyAV does not say of which numbers
