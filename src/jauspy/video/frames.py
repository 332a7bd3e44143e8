"""Frames of a video as NumPy arrays with the time at which they were taken. Import it after `need_video`."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Self

import numpy as np
from numpy.typing import NDArray

from jauspy.video.h264 import H264Decoder
from jauspy.video.h264_payload import Picture
from jauspy.video.receiver import RtpReceiver


class Frame(np.ndarray[tuple[int, int, int], np.dtype[np.uint8]]):
    """An image of shape (height, width, 3) in blue, green and red, as OpenCV has them."""

    time: datetime | None
    """Time of the picture by the robot's clock; None before its first report."""

    def __new__(cls, image: NDArray[np.uint8], time: datetime | None) -> Self:
        """A frame of an image in the same order of colours."""
        made = np.ascontiguousarray(image).view(cls)
        made.time = time
        return made

    def __array_finalize__(self, source: object) -> None:
        self.time = getattr(source, "time", None)


class FrameReader:
    """Receives a stream and decodes it; `take` returns the newest frame, if one has arrived since the last call."""

    def __init__(self, host: str) -> None:
        self.receiver = RtpReceiver(host)
        self._decoder = H264Decoder()

    def fileno(self) -> int:
        """File descriptor for an event loop: readable when there is something to `take`."""
        return self.receiver.fileno()

    def take(self) -> Frame | None:
        """The newest of the frames that have arrived; the others are decoded, and dropped."""
        newest, picture = None, None
        for packet in self.receiver.take():
            image = self._decoder.decode(packet)
            if image is not None:
                newest, picture = image, packet
        if newest is None or picture is None:
            return None
        return Frame(np.asarray(newest, np.uint8)[:, :, ::-1], self._taken(picture))

    def _taken(self, picture: Picture) -> datetime | None:
        seconds = self.receiver.taken(picture)
        return None if seconds is None else datetime.fromtimestamp(seconds, UTC)

    def close(self) -> None:
        """Close the sockets; without effect when closed."""
        self.receiver.close()
