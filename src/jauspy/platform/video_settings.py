"""How a stream is encoded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError
from jauspy.platform.h264 import LEVELS, H264Settings, Level, blocks, suffices

MIN_BIT_RATE: Final = 64_000
MAX_BIT_RATE: Final = 20_000_000

MAX_RATE: Final = 60
"""Pictures per second."""

PLAIN: Final = H264Settings()


@dataclass(frozen=True, slots=True)
class VideoSettings:
    """Size in pixels, pictures and bits per second, how many pictures at most from one IDR to the next, and the coding.

    With gradual refreshes `gop` is from the begin of one to that of the next.
    """

    width: int = 640
    height: int = 480
    rate: int = 15
    bit_rate: int = 2_000_000
    gop: int = 30
    coding: H264Settings = PLAIN

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
        if self.coding.level is not None and not self._fits(LEVELS[self.coding.level]):
            raise ConfigError(
                f"video: level {LEVELS[self.coding.level].name} has no {self.width}x{self.height} with {self.rate} "
                f"pictures and {self.bit_rate} bits a second"
            )

    @property
    def level(self) -> int | None:
        """Index in `LEVELS` of the one that is set, or of the lowest that does; None when all are too low."""
        if self.coding.level is not None:
            return self.coding.level
        return next((number for number, level in enumerate(LEVELS) if self._fits(level)), None)

    @property
    def refresh(self) -> int:
        """Pictures that a gradual refresh takes: each one refreshes a column of macroblocks, or more."""
        return min(self.gop, blocks(self.width))

    def _fits(self, level: Level) -> bool:
        return suffices(level, (self.width, self.height), self.rate, self.bit_rate, self.coding.profile)
