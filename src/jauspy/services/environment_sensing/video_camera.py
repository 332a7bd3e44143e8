"""A camera as its services see it."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol, TypeAlias
from urllib.parse import urlsplit

from jauspy.errors import ConfigError
from jauspy.platform.camera import CameraSetup
from jauspy.platform.stills import Still, StillSettings
from jauspy.platform.vectors import Transform
from jauspy.platform.video_settings import VideoSettings
from jauspy.services.axes import jaus_frame
from jauspy.services.environment_sensing.mounting import OnJoint

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
class VideoCamera:
    """A camera of the vehicle, and where it is mounted."""

    source: VideoSource
    frame: Callable[[], Transform]
    """Its frame in the vehicle's now, both as in REP-103."""
    is_fixed: bool = True
    """The frame never changes."""
    carrier: OnJoint | None = None
    """What it moves with, if JAUS knows it."""

    @property
    def in_vehicle(self) -> Transform:
        """Its frame in the vehicle's now, both with JAUS's axes."""
        return jaus_frame(self.frame())


Cameras: TypeAlias = Mapping[int, VideoCamera]
"""The cameras of a component by the ids of their sensors, which count from 1."""


def address_of(url: str) -> Address:
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
