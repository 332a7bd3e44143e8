"""Sizes of pictures as JAUS counts them."""

from __future__ import annotations

from typing import Final

from jauspy.messages.environment_sensing.v1_0.types import SupportedFrameSizes
from jauspy.messages.environment_sensing.v2_0.digital_video import ReportDigitalVideoSensorConfiguration

FrameSize = ReportDigitalVideoSensorConfiguration.FrameSize

LARGEST: Final = 1920 * 1200
"""Pixels of the largest picture that is offered: above it no small machine keeps up."""


def _pixels(size: FrameSize) -> tuple[int, int]:
    _, width, height = size.name.split("_")
    return int(width), int(height.removeprefix("X"))


SIZES: Final = {size: _pixels(size) for size in FrameSize}
"""Width and height."""

OFFERED: Final = {size: (width, height) for size, (width, height) in SIZES.items() if width * height <= LARGEST}


def number_of(width: int, height: int) -> FrameSize | None:
    """The first size that is so wide and high; None when JAUS has none."""
    return next((size for size, pixels in SIZES.items() if pixels == (width, height)), None)


def offered() -> SupportedFrameSizes:
    """All sizes that are offered, for a report."""
    return SupportedFrameSizes(*(int(size in OFFERED) for size in FrameSize))
