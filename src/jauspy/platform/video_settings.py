"""Settings of video streams (H.264) and of still images, and the sizes that JAUS has numbers for (AS6060)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Final, NamedTuple

from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import SupportedFrameSizes
from jauspy.messages.environment_sensing.v2_0.digital_video import ReportDigitalVideoSensorConfiguration

FrameSize = ReportDigitalVideoSensorConfiguration.FrameSize

RTP_SERVER_TYPE: Final = 201
"""Server type of an end point, from the range for private use: RTP over UDP, sent to the address of the URL."""

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


MACROBLOCK_SIZE: Final = 16
"""Pixels of a macroblock's side."""

MIN_BIT_RATE: Final = 64_000

MAX_BIT_RATE: Final = 20_000_000

MAX_RATE: Final = 60
"""Pictures per second."""

MAX_IMAGE_REPORT: Final = 8 << 20
"""Bytes of a report with an image; the largest supported frame size fits even without compression."""


class H264Profile(Enum):
    """Sets of coding tools. Baseline here is constrained baseline, too, which every decoder knows."""

    BASELINE = "baseline"
    MAIN = "main"
    HIGH = "high"


class Preset(Enum):
    """Presets of x264: slower ones compress better."""

    LOW_LATENCY = "ultrafast"
    SLOW_COMMS = "veryfast"
    BEST_QUALITY = "fast"


class Level(NamedTuple):
    """Limits of a stream that a decoder of the level must accept (ITU-T H.264, table A-1)."""

    name: str
    macroblocks_per_second: int
    macroblocks: int
    bits_per_second: int
    """Bit rate of the coded pictures in Baseline and Main; High may have a quarter more."""


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
    """The coding of a stream, apart from its size and rates."""

    profile: H264Profile = H264Profile.BASELINE
    level: int | None = None
    """Index in `LEVELS`; None selects the lowest sufficient level."""
    preset: Preset = Preset.LOW_LATENCY
    gradual: bool = False
    """Refresh frames column by column instead of by IDR frames."""


DEFAULT_CODING: Final = H264Settings()


@dataclass(frozen=True, slots=True)
class VideoSettings:
    """Size in pixels, pictures and bits per second, how many pictures at most from one IDR to the next, and the coding.

    With gradual refreshes `gop` counts from the start of one refresh to the start of the next.
    """

    width: int = 640
    height: int = 480
    rate: int = 15
    bit_rate: int = 2_000_000
    gop: int = 30
    coding: H264Settings = DEFAULT_CODING

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
        """Index in `LEVELS` of the selected level, or of the lowest sufficient one; None if all are too low."""
        if self.coding.level is not None:
            return self.coding.level
        return next((number for number, level in enumerate(LEVELS) if self._fits(level)), None)

    @property
    def refresh(self) -> int:
        """Pictures that a gradual refresh takes: each one refreshes a column of macroblocks, or more."""
        return min(self.gop, macroblocks(self.width))

    def _fits(self, level: Level) -> bool:
        return level_suffices(level, (self.width, self.height), self.rate, self.bit_rate, self.coding.profile)


def macroblocks(pixels: int) -> int:
    """Return the number of macroblocks in a row or column of pixels."""
    return -(-pixels // MACROBLOCK_SIZE)


def level_suffices(level: Level, size: tuple[int, int], rate: int, bit_rate: int, profile: H264Profile) -> bool:
    """Return True if decoders of the level accept the stream; size in pixels, rates per second."""
    columns, rows = (macroblocks(pixels) for pixels in size)
    bits = level.bits_per_second * (5 if profile is H264Profile.HIGH else 4) // 4
    return (
        columns * rows <= level.macroblocks
        and max(columns, rows) ** 2 <= 8 * level.macroblocks
        and columns * rows * rate <= level.macroblocks_per_second
        and bit_rate <= bits
    )


def with_parity(settings: VideoSettings, share: float) -> VideoSettings:
    """The settings of an encoder that leaves room in the bit rate for `share` parity packets with each packet."""
    return replace(settings, bit_rate=max(MIN_BIT_RATE, int(settings.bit_rate / (1.0 + share))))


class StillFormat(Enum):
    """Format of an image; the value is the file name extension."""

    JPEG = ".jpg"
    PNG = ".png"


@dataclass(frozen=True, slots=True)
class StillSettings:
    """Size in pixels and format of a still image."""

    width: int
    height: int
    format: StillFormat


@dataclass(frozen=True, slots=True)
class Still:
    """An image as the content of a file, taken `age` seconds ago."""

    content: bytes
    age: float
