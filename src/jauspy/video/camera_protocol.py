"""The messages between the robot's process and the worker process of a camera."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from jauspy.platform.camera import CameraSource
from jauspy.platform.imaging_settings import ImagingSettings
from jauspy.platform.video_settings import StillSettings, VideoSettings

Address: TypeAlias = tuple[str, int]
"""IP address and port for RTP; RTCP uses the port above it."""


@dataclass(frozen=True, slots=True)
class StartCamera:
    """The first command. With `stamped`, images show their number and time, as `stamp` draws them."""

    camera: CameraSource
    settings: VideoSettings
    imaging: ImagingSettings
    stamped: bool
    niceness: int
    """The highest one, in addition to that of the robot's process."""


@dataclass(frozen=True, slots=True)
class ChangeSettings:
    """Encode with these settings from the next picture on."""

    settings: VideoSettings


@dataclass(frozen=True, slots=True)
class ChangeImaging:
    """Take pictures with these settings of lens and sensor."""

    settings: ImagingSettings


@dataclass(frozen=True, slots=True)
class AddReceiver:
    """Send to this address, or pause sending; playing starts with an IDR picture."""

    address: Address
    playing: bool = True


@dataclass(frozen=True, slots=True)
class RemoveReceiver:
    """Stop sending to this address."""

    address: Address


@dataclass(frozen=True, slots=True)
class TakeStill:
    """Take a still image."""

    number: int
    settings: StillSettings


@dataclass(frozen=True, slots=True)
class StillTaken:
    """A still image as the content of a file; `at` is in seconds of the machine's monotonic clock."""

    number: int
    content: bytes
    at: float


@dataclass(frozen=True, slots=True)
class StreamReduced:
    """The machine is too slow for the settings: a sentence for users with what is sent; empty when all is."""

    text: str
