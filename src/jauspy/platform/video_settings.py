"""How a stream is encoded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError

MIN_BIT_RATE: Final = 64_000
MAX_BIT_RATE: Final = 20_000_000

MAX_RATE: Final = 60
"""Pictures per second."""


@dataclass(frozen=True, slots=True)
class VideoSettings:
    """Size in pixels, pictures and bits per second, and how many pictures at most from one IDR to the next."""

    width: int = 640
    height: int = 480
    rate: int = 15
    bit_rate: int = 2_000_000
    gop: int = 30

    def __post_init__(self) -> None:
        for name, low, high in (
            ("width", 16, 7680),
            ("height", 16, 4800),
            ("rate", 1, MAX_RATE),
            ("bit_rate", MIN_BIT_RATE, MAX_BIT_RATE),
            ("gop", 1, 255),
        ):
            value = getattr(self, name)
            if not low <= value <= high:
                raise ConfigError(f"video: {name} = {value} is not in {low}..{high}")
        if self.width % 2 or self.height % 2:
            raise ConfigError(f"video: {self.width}x{self.height} must be even both ways")
