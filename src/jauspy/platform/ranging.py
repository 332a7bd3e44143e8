"""The contract with what measures distances around it: lidars of one layer or of several."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Final, Protocol, TypeAlias

from annotated_types import Interval

from jauspy.platform.tables import Converted, Seed, Table, UrdfName, check_order

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

DUE_TOLERANCE: Final = 1e-6
"""Seconds by which a sample may be early, because sums of steps are not exact."""

ANGLE_TOLERANCE: Final = 1e-6
"""Radians by which a ray may be outside of the configured angles, which are rounded on the wire."""

Measure: TypeAlias = Callable[[Sequence[float]], Sequence[float]]
"""Distances along rays, given as angles in the plane of the lidar's link: metres, inf where nothing is."""


@dataclass(frozen=True, slots=True)
class ScanSettings:
    """The settings of a lidar that a client may change: radians counterclockwise from ahead, hertz, metres."""

    start: float = -math.pi
    stop: float = math.pi
    """Rays from `start` to `stop` are measured."""
    rate: float = 10.0
    """Scans per second, more than 0."""
    min_range: float = 0.1
    max_range: float = 30.0
    """Distances outside of `min_range` to `max_range` are not measured."""
    active: bool = True


_Inclination: TypeAlias = Annotated[float, Interval(ge=-89.0, le=89.0), Converted(math.radians)]

MAX_RAYS: Final = 100_000
"""Rays of one scan."""


@dataclass(frozen=True, slots=True)
class LidarSetup(Table):
    """A lidar that scans the x-y plane of its link, all around; with several layers also cones above and below it."""

    name: UrdfName
    link: UrdfName
    rays: Annotated[int, Interval(ge=1, le=3600)] = 360
    """Rays of each layer."""
    layers: Annotated[int, Interval(ge=1, le=128)] = 1
    vertical: tuple[_Inclination, _Inclination] = (math.radians(-15.0), math.radians(15.0))
    """Inclinations of the lowest and highest of several layers, in radians (degrees in the file), positive upwards."""
    rate: Annotated[float, Interval(gt=0.0, le=100.0)] = 10.0
    """Scans per second, at most."""
    range: tuple[Annotated[float, Interval(ge=0.0)], Annotated[float, Interval(gt=0.0, le=1000.0)]] = (0.1, 30.0)
    """Minimal and maximal measured distance, in metres."""
    noise: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.01
    """Standard deviation of a distance in a simulation, in metres."""
    seed: Seed = 0
    """Seed of the noise: the same seed gives the same noise."""

    def __post_init__(self) -> None:
        check_order("range", self.range, "the minimal and then the maximal distance")
        if self.vertical[0] >= self.vertical[1]:
            low, high = (round(math.degrees(angle), 6) for angle in self.vertical)
            raise ValueError(f"vertical: [{low:g}, {high:g}] is empty; give the lowest and then the highest angle")
        if self.layers * self.rays > MAX_RAYS:
            raise ValueError(f"layers: {self.layers} of {self.rays} rays are too many; a scan may have {MAX_RAYS}")

    @property
    def min_range(self) -> float:
        """Minimal measured distance, in metres."""
        return self.range[0]

    @property
    def max_range(self) -> float:
        """Maximal measured distance, in metres."""
        return self.range[1]

    def inclinations(self) -> tuple[float, ...]:
        """Inclinations of the layers, ascending: radians, positive upwards."""
        if self.layers == 1:
            return (0.0,)
        low, high = self.vertical
        return tuple(low + (high - low) * layer / (self.layers - 1) for layer in range(self.layers))

    def angles(self) -> tuple[float, ...]:
        """The angles of all rays: radians counterclockwise from the link's x axis, from -pi on."""
        return tuple(-math.pi + math.tau * ray / self.rays for ray in range(self.rays))

    def settings(self) -> ScanSettings:
        """The widest possible settings."""
        return ScanSettings(rate=self.rate, min_range=self.min_range, max_range=self.max_range)


@dataclass(frozen=True, slots=True)
class RangeScan:
    """One turn of a lidar."""

    time: float
    """The robot's time, in seconds."""
    frame: str
    """The link in whose x-y plane the rays are."""
    angles: tuple[float, ...]
    """Radians counterclockwise from the frame's x axis, ascending."""
    ranges: tuple[float, ...]
    """Metres; inf where nothing is within reach, -inf where something is too close (REP-117).

    Of several layers, those of the one that is nearest to the x-y plane.
    """
    inclinations: tuple[float, ...] = (0.0,)
    """Inclinations of the layers, ascending: radians, positive upwards."""
    layers: bytes = b""
    """The ranges of all layers, if there are several: float32 in native order, layer by layer, lowest first."""

    @property
    def inclination(self) -> float:
        """Inclination of the layer in `ranges`, radians."""
        return self.inclinations[nearest_layer(self.inclinations)]

    def image(self) -> NDArray[np.float32]:
        """The range image, metres: a row for each of `inclinations`, a column for each of `angles`. Needs numpy."""
        import numpy as np  # noqa: PLC0415 - only robots with a simulation have it

        if not self.layers:
            return np.array([self.ranges], np.float32)
        return np.frombuffer(self.layers, np.float32).reshape(len(self.inclinations), len(self.angles))


def nearest_layer(inclinations: Sequence[float]) -> int:
    """The layer nearest to the x-y plane; of two, the upper one, which meets the ground later."""
    return min(range(len(inclinations)), key=lambda layer: (round(abs(inclinations[layer]), 9), -layer))


class RangeFinder(Protocol):
    """A lidar of a robot."""

    @property
    def setup(self) -> LidarSetup:
        """Link, number of rays and limits."""
        ...

    @property
    def settings(self) -> ScanSettings:
        """The present settings."""
        ...

    def configure(self, settings: ScanSettings) -> None:
        """Apply settings from the next scan on, clamped to the limits of `setup`."""
        ...

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        ...

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        ...


class Sampling:
    """Schedules samples: at once, and then `rate` times a second; missed samples are skipped."""

    def __init__(self, rate: float) -> None:
        self.rate = rate
        """Hertz, more than 0; a change takes effect after the next sample."""
        self._due = 0.0

    def restart(self, now: float) -> None:
        """Make a sample due at once."""
        self._due = now

    def is_due(self, now: float) -> bool:
        """True once for each time; `now` in seconds, never earlier than in the call before."""
        if now < self._due - DUE_TOLERANCE:
            return False
        period = 1.0 / self.rate
        self._due = self._due + period if self._due + period > now else now + period
        return True


def no_obstacles(angles: Sequence[float]) -> list[float]:
    """The `Measure` of a world without obstacles."""
    return [math.inf] * len(angles)


class Scanner:
    """A `RangeFinder` that scans in `step`; if it has several layers, all measure the same."""

    def __init__(self, setup: LidarSetup, measure: Measure = no_obstacles) -> None:
        self._setup = setup
        self._measure = measure
        self._settings = setup.settings()
        self._angles = setup.angles()
        self._now = 0.0
        self._sampling = Sampling(setup.rate)
        self._scan: RangeScan | None = None

    @property
    def setup(self) -> LidarSetup:
        """Link, number of rays and limits."""
        return self._setup

    @property
    def settings(self) -> ScanSettings:
        """The present settings."""
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
        """Apply settings, clamped to the limits of `setup`, and scan with the next step."""
        setup = self._setup
        settings = replace(
            settings,
            rate=min(setup.rate, settings.rate),
            min_range=max(setup.min_range, settings.min_range),
            max_range=min(setup.max_range, settings.max_range),
        )
        self._settings = settings
        first, last = settings.start - ANGLE_TOLERANCE, settings.stop + ANGLE_TOLERANCE
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
        self._begin(now)

    def _begin(self, now: float) -> None:
        """Make a scan."""
        ranges = _limited(self._measure(self._angles), self._settings.min_range, self._settings.max_range)
        layers = self._setup.layers
        image = b"" if layers == 1 else array("f", ranges * layers).tobytes()
        self._scan = RangeScan(
            time=now,
            frame=self._setup.link,
            angles=self._angles,
            ranges=ranges,
            inclinations=self._setup.inclinations(),
            layers=image,
        )


def _limited(distances: Sequence[float], min_range: float, max_range: float) -> tuple[float, ...]:
    far, near = math.inf, -math.inf
    return tuple(
        [far if distance > max_range else distance if distance >= min_range else near for distance in distances]
    )
