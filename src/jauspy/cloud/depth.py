"""What a depth camera's clouds are made of, and where they go."""

from __future__ import annotations

from dataclasses import dataclass

from jauspy.platform.camera import Camera


@dataclass(frozen=True, slots=True)
class DepthSettings:
    """How a camera's cloud is made."""

    width: int = 400
    height: int = 250
    """Points of a cloud, at most: one for each pixel that shows something within range."""
    rate: float = 10.0
    """Clouds per second."""
    least: float = 0.2
    most: float = 10.0
    """Metres along the camera's x axis."""


@dataclass(frozen=True, slots=True)
class DepthStream:
    """Which camera's clouds are published, and at which address."""

    camera: Camera
    settings: DepthSettings
    address: str
