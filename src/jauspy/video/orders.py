"""What the robot's process and a camera's tell each other, and how it crosses the pipe between them."""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.platform.camera import Camera
from jauspy.platform.video_settings import StillSettings, VideoSettings

Address: TypeAlias = tuple[str, int]
"""Host, as a number, and port for RTP; RTCP goes to the port above it."""

LENGTH: Final = 4
"""Bytes that say how long a message is."""


@dataclass(frozen=True, slots=True)
class Begin:
    """The first order: through which camera. `stamped`: pictures show their number and time, as `stamp` draws them."""

    camera: Camera
    settings: VideoSettings
    stamped: bool


@dataclass(frozen=True, slots=True)
class Change:
    """Encode like this from the next picture on."""

    settings: VideoSettings


@dataclass(frozen=True, slots=True)
class Watch:
    """Send to that address, or pause sending there; anew with an IDR when it plays."""

    address: Address
    playing: bool = True


@dataclass(frozen=True, slots=True)
class Leave:
    """Send there no longer."""

    address: Address


@dataclass(frozen=True, slots=True)
class Take:
    """Take a still image."""

    number: int
    settings: StillSettings


Order: TypeAlias = Begin | Change | Watch | Leave | Take


@dataclass(frozen=True, slots=True)
class Opened:
    """The camera is open; how it comes to its pictures, and whether they are worse than elsewhere."""

    description: str
    reduced: bool


@dataclass(frozen=True, slots=True)
class Taken:
    """The image that was to be taken, as a file's content; `at`: seconds of the machine's monotonic clock."""

    number: int
    content: bytes
    at: float


@dataclass(frozen=True, slots=True)
class Counted:
    """What the camera's process has counted."""

    counters: Mapping[str, int]


Word: TypeAlias = Opened | Taken | Counted


def packed(message: Order | Word) -> bytes:
    """A message with its length before it."""
    body = pickle.dumps(message)
    return len(body).to_bytes(LENGTH, "big") + body


def unpacked(body: bytes) -> object:
    """The message; both ends of the pipe are ours, so what comes is what was sent."""
    return pickle.loads(body)  # noqa: S301


def length(head: bytes) -> int:
    """How long the message is that follows."""
    return int.from_bytes(head, "big")
