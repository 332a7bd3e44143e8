"""A lidar out of something that measures distances: when it scans, and what of that it can see."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final, TypeAlias

from jauspy.platform.ranging import LidarSetup, RangeScan, ScanSettings
from jauspy.platform.sampling import Sampling

Measure: TypeAlias = Callable[[Sequence[float]], Sequence[float]]
"""Distances along rays, given as angles in the plane of the lidar's link: metres, inf where nothing is."""

SLACK: Final = 1e-6
"""Radians by which a ray may be outside of the angles that are set: they come rounded."""


def sees_nothing(angles: Sequence[float]) -> list[float]:
    """The `Measure` of a world without obstacles."""
    return [math.inf] * len(angles)


class Scanner:
    """A `RangeFinder`; `step` lets it live."""

    def __init__(self, setup: LidarSetup, measure: Measure = sees_nothing) -> None:
        self._setup = setup
        self._measure = measure
        self._settings = setup.settings()
        self._angles = setup.angles()
        self._now = 0.0
        self._sampling = Sampling(setup.rate)
        self._scan: RangeScan | None = None

    @property
    def setup(self) -> LidarSetup:
        """What it can do."""
        return self._setup

    @property
    def settings(self) -> ScanSettings:
        """What it was told to do."""
        return self._settings

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        return self._scan

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        return self._now - self._scan.time if self._scan else 0.0

    def configure(self, settings: ScanSettings) -> None:
        """Measure so from the next scan on, which comes with the next step."""
        setup = self._setup
        settings = replace(
            settings,
            rate=min(setup.rate, settings.rate),
            least=max(setup.least, settings.least),
            most=min(setup.most, settings.most),
        )
        self._settings = settings
        first, last = settings.start - SLACK, settings.stop + SLACK
        self._angles = tuple(angle for angle in setup.angles() if first <= angle <= last)
        self._sampling.rate = settings.rate
        self._sampling.restart(self._now)
        if not settings.active:
            self._scan = None

    def wait(self, now: float) -> None:
        """The robot's time is `now`; nothing is measured."""
        self._now = now

    def step(self, now: float) -> None:
        """The robot's time is `now`; never earlier than in the call before."""
        self._now = now
        if not self._settings.active or not self._sampling.is_due(now):
            return
        ranges = _limited(self._measure(self._angles), self._settings.least, self._settings.most)
        self._scan = RangeScan(now, self._setup.link, self._angles, ranges)


def _limited(distances: Sequence[float], least: float, most: float) -> tuple[float, ...]:
    far, near = math.inf, -math.inf
    return tuple([far if each > most else each if each >= least else near for each in distances])
