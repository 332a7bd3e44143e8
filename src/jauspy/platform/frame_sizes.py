"""The sizes of images that JAUS has numbers for (FrameSize, AS6060)."""

from __future__ import annotations

from typing import Final

from jauspy.messages.environment_sensing.v1_0.types import SupportedFrameSizes
from jauspy.messages.environment_sensing.v2_0.digital_video import ReportDigitalVideoSensorConfiguration

FrameSize = ReportDigitalVideoSensorConfiguration.FrameSize

MAX_PIXELS: Final = 1920 * 1200
"""Pixels of the largest image that cameras support; small machines cannot encode larger ones in time."""


def _pixels(size: FrameSize) -> tuple[int, int]:
    _, width, height = size.name.split("_")
    return int(width), int(height.removeprefix("X"))


FRAME_SIZES: Final = {size: _pixels(size) for size in FrameSize}
"""Width and height in pixels of all sizes."""

SUPPORTED_FRAME_SIZES: Final = {
    size: (width, height) for size, (width, height) in FRAME_SIZES.items() if width * height <= MAX_PIXELS
}
"""Width and height in pixels of the sizes that cameras support."""


def frame_size(width: int, height: int) -> FrameSize | None:
    """Return the first size of that width and height; None when JAUS has none."""
    return next((size for size, pixels in FRAME_SIZES.items() if pixels == (width, height)), None)


def supported_frame_sizes() -> SupportedFrameSizes:
    """Return the supported sizes as the bit field of a capabilities report."""
    return SupportedFrameSizes(*(int(size in SUPPORTED_FRAME_SIZES) for size in FrameSize))
