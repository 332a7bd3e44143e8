"""The contract with what measures distances in a plane: lidars."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True, slots=True)
class ScanSettings:
    """What a client may change of a lidar: radians counterclockwise from ahead, hertz, metres."""

    start: float = -math.pi
    stop: float = math.pi
    """Rays from `start` to `stop` are measured."""
    rate: float = 10.0
    """More than 0."""
    least: float = 0.1
    most: float = 30.0
    """Distances outside are not measured."""
    active: bool = True


@dataclass(frozen=True, slots=True)
class LidarSetup:
    """A lidar that scans the x-y plane of its link, all around."""

    name: str
    link: str
    rays: int = 360
    rate: float = 10.0
    """Scans per second, at most."""
    least: float = 0.1
    most: float = 30.0
    """Metres."""
    noise: float = 0.01
    """Standard deviation of a distance, in metres."""
    seed: int = 0
    """Of the noise: the same seed gives the same noise."""

    def angles(self) -> tuple[float, ...]:
        """Of all rays: radians counterclockwise from the link's x axis, from -pi on."""
        return tuple(-math.pi + math.tau * ray / self.rays for ray in range(self.rays))

    def settings(self) -> ScanSettings:
        """All that it can do."""
        return ScanSettings(rate=self.rate, least=self.least, most=self.most)


@dataclass(frozen=True, slots=True)
class RangeScan:
    """One turn of a lidar."""

    time: float
    """The robot's own, in seconds."""
    frame: str
    """The link in whose x-y plane the rays are."""
    angles: tuple[float, ...]
    """Radians counterclockwise from the frame's x axis, ascending."""
    ranges: tuple[float, ...]
    """Metres; inf where nothing is within reach, -inf where something is too close (REP-117)."""


class RangeFinder(Protocol):
    """A lidar of a robot."""

    @property
    def setup(self) -> LidarSetup:
        """What it can do."""
        ...

    @property
    def settings(self) -> ScanSettings:
        """What it was told to do."""
        ...

    def configure(self, settings: ScanSettings) -> None:
        """Measure so from the next scan on; beyond its setup it does what it can."""
        ...

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        ...

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        ...
