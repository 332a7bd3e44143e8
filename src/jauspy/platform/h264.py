"""How H.264 is coded: profile, level, effort and refresh (ITU-T H.264, annex A)."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final, NamedTuple

BLOCK: Final = 16
"""Pixels of a macroblock's side."""


class Profile(Enum):
    """Sets of coding tools. Baseline here is constrained baseline, too, which every decoder knows."""

    BASELINE = "baseline"
    MAIN = "main"
    HIGH = "high"


class Preset(Enum):
    """What is paid with the machine's time: x264's names for how much of it a picture takes."""

    LOW_LATENCY = "ultrafast"
    SLOW_COMMS = "veryfast"
    BEST_QUALITY = "fast"


class Level(NamedTuple):
    """What a decoder must be able to do, at most (table A-1)."""

    name: str
    macroblocks_per_second: int
    macroblocks: int
    bits_per_second: int
    """Of the coded pictures in Baseline and Main; High may have a quarter more."""


LEVELS: Final = (
    Level("1", 1_485, 99, 64_000),
    Level("1b", 1_485, 99, 128_000),
    Level("1.1", 3_000, 396, 192_000),
    Level("1.2", 6_000, 396, 384_000),
    Level("1.3", 11_880, 396, 768_000),
    Level("2", 11_880, 396, 2_000_000),
    Level("2.1", 19_800, 792, 4_000_000),
    Level("2.2", 20_250, 1_620, 4_000_000),
    Level("3", 40_500, 1_620, 10_000_000),
    Level("3.1", 108_000, 3_600, 14_000_000),
    Level("3.2", 216_000, 5_120, 20_000_000),
    Level("4", 245_760, 8_192, 20_000_000),
    Level("4.1", 245_760, 8_192, 50_000_000),
    Level("4.2", 522_240, 8_704, 50_000_000),
    Level("5", 589_824, 22_080, 135_000_000),
    Level("5.1", 983_040, 36_864, 240_000_000),
    Level("5.2", 2_073_600, 36_864, 240_000_000),
    Level("6", 4_177_920, 139_264, 240_000_000),
    Level("6.1", 8_355_840, 139_264, 480_000_000),
    Level("6.2", 16_711_680, 139_264, 800_000_000),
)


@dataclass(frozen=True, slots=True)
class H264Settings:
    """How a stream is coded, apart from its size and rates."""

    profile: Profile = Profile.BASELINE
    level: int | None = None
    """Index in `LEVELS`; None is the lowest that does."""
    preset: Preset = Preset.LOW_LATENCY
    gradual: bool = False
    """Pictures are refreshed column by column, instead of by whole ones that come at once."""


def blocks(pixels: int) -> int:
    """Macroblocks that a row or column of so many pixels takes."""
    return -(-pixels // BLOCK)


def suffices(level: Level, size: tuple[int, int], rate: int, bit_rate: int, profile: Profile) -> bool:
    """True when decoders of that level can take such a stream; size in pixels, rates per second."""
    across, down = (blocks(pixels) for pixels in size)
    bits = level.bits_per_second * (5 if profile is Profile.HIGH else 4) // 4
    return (
        across * down <= level.macroblocks
        and max(across, down) ** 2 <= 8 * level.macroblocks
        and across * down * rate <= level.macroblocks_per_second
        and bit_rate <= bits
    )
