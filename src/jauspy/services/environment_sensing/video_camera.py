"""A camera as its services see it."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, Protocol, TypeAlias
from urllib.parse import urlsplit

from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import SupportedFrameSizes
from jauspy.messages.environment_sensing.v2_0.digital_video import ReportDigitalVideoSensorConfiguration
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import Still, StillSettings, VideoSettings
from jauspy.services.environment_sensing.sensors import OnVehicle

Address: TypeAlias = tuple[str, int]


class VideoSource(Protocol):
    """Encodes what a camera sees and sends it to all who watch, and takes still images; no caller ever waits."""

    @property
    def setup(self) -> CameraSetup:
        """What the camera is."""
        ...

    @property
    def settings(self) -> VideoSettings:
        """How the stream is encoded."""
        ...

    @settings.setter
    def settings(self, settings: VideoSettings) -> None: ...

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send there, or pause; `ConfigError` when it cannot."""
        ...

    def leave(self, address: Address) -> None:
        """Send there no longer."""
        ...

    def take(self, settings: StillSettings, then: Callable[[Still | None], None]) -> None:
        """Take a still image; `then` gets it, some time later, or None if none comes of it; `ConfigError` says why."""
        ...


@dataclass(frozen=True, slots=True)
class VideoCamera(OnVehicle):
    """A camera of the vehicle."""

    source: VideoSource = field(kw_only=True)


Cameras: TypeAlias = Mapping[int, VideoCamera]
"""The cameras of a component by the ids of their sensors, which count from 1."""


def parse_rtp_url(url: str) -> Address:
    """Where `rtp://ADDRESS:PORT` is; `ConfigError` says what is wrong with it. Names are not looked up."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname or "", parts.port or 0
        ipaddress.ip_address(host)
    except ValueError as error:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with an address in numbers: {error}") from error
    if parts.scheme != "rtp" or not 1 <= port <= 65534:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with a port of 1..65534")
    return host, port


FrameSize = ReportDigitalVideoSensorConfiguration.FrameSize

MAX_PIXELS: Final = 1920 * 1200
"""Pixels of the largest picture that is offered: above it no small machine keeps up."""


def _pixels(size: FrameSize) -> tuple[int, int]:
    _, width, height = size.name.split("_")
    return int(width), int(height.removeprefix("X"))


FRAME_SIZES: Final = {size: _pixels(size) for size in FrameSize}
"""Width and height."""

SUPPORTED_FRAME_SIZES: Final = {
    size: (width, height) for size, (width, height) in FRAME_SIZES.items() if width * height <= MAX_PIXELS
}


def frame_size(width: int, height: int) -> FrameSize | None:
    """The first size that is so wide and high; None when JAUS has none."""
    return next((size for size, pixels in FRAME_SIZES.items() if pixels == (width, height)), None)


def supported_frame_sizes() -> SupportedFrameSizes:
    """All sizes that are offered, for a report."""
    return SupportedFrameSizes(*(int(size in SUPPORTED_FRAME_SIZES) for size in FrameSize))
