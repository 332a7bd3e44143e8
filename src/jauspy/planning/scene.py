"""The scene around a robot: voxels from what its sensors see, and primitives given by hand.

Voxels are kept in the robot's local frame (odometry), in which the world stands still while the robot drives, and are
given in the frame of its base. All input is checked: whatever a sensor sends, memory and time are bounded.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from threading import Lock
from types import MappingProxyType
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import RobotDescription
from jauspy.planning.lines_of_sight import LinesOfSight
from jauspy.planning.obstacles import Box, Obstacles, Primitive
from jauspy.planning.own_body import OwnBody
from jauspy.planning.voxels import Indices, VoxelWindow

Array: TypeAlias = NDArray[np.float64]

MAX_POINTS: Final = 150_000
"""Points of a sweep that are used, evenly spread."""
MAX_PRIMITIVES: Final = 1000
MAX_SENSORS: Final = 64
"""Sensors whose sweeps are counted by name; those of further ones are not used."""
FARTHEST: Final = 1000.0
"""Metres from a sensor beyond which a point is an error."""
FARTHEST_BASE: Final = 1e6
"""Metres of the local frame beyond which the pose of a base is an error."""
MAX_SPEED: Final = 10.0
MAX_TURN: Final = 6.0
"""m/s and rad/s; a base that moved faster between two sweeps was given another place, and the scene begins anew."""
MAX_JUMP: Final = (0.3, 0.3)
"""Metres and radians by which poses differ besides."""
MAX_BACK: Final = 2.0
"""Seconds by which a sweep may be older than the newest; a clock that goes back further was set."""
EXPLORE_PERIOD: Final = 0.5
"""Seconds between two sweeps of a sensor that make unknown space known, which takes longer than the rest."""


class Unknown(Enum):
    """The meaning of space that no sensor has looked into."""

    FREE = "free"
    FORBIDDEN = "forbidden"


class Frame(Enum):
    """The frame that a primitive stays in."""

    LOCAL = "local"
    """It stands in the world while the robot drives."""
    BASE = "base"
    """It rides on the robot."""


@dataclass(frozen=True, slots=True)
class SceneSetup:
    """Sizes in metres and times in seconds."""

    voxel_size: float = 0.04
    size: tuple[float, float, float] = (6.0, 6.0, 2.4)
    """Extent of the window of voxels, whose middle is `lift` above the robot's base."""
    lift: float = 0.6
    reach: float = 4.0
    """Distance from a sensor up to which points become voxels; beyond, they show that the space before is free."""
    margin: float = 0.05
    """Margin of the filter around the links' boxes."""
    gain: float = 15.0
    """Evidence of a hit: a thing that was seen once is kept for so long."""
    keep: float = 60.0
    """Evidence at most: a thing that nobody looks at any more vanishes after that time."""
    loss: float = 20.0
    """Evidence that a voxel loses in each sweep that looks through it."""
    unknown: Unknown = Unknown.FREE
    unknown_reach: float = 1.5
    """Distance from the base, along each axis, within which unknown space is forbidden."""

    def __post_init__(self) -> None:
        lengths = (self.voxel_size, *self.size, self.reach, self.gain, self.keep, self.loss, self.unknown_reach)
        if not all(math.isfinite(value) and value > 0.0 for value in lengths):
            raise ConfigError(f"sizes and times of a scene are numbers greater than 0: {self}")
        if not (0.0 <= self.margin <= 1.0 and math.isfinite(self.lift)):
            raise ConfigError(f"the margin of a scene is 0 to 1 m, not {self.margin}; its lift a number: {self.lift}")

    @property
    def shape(self) -> tuple[int, int, int]:
        """Voxels along x, y and z."""
        x, y, z = (math.ceil(round(side / self.voxel_size, 6)) for side in self.size)
        return x, y, z


@dataclass(frozen=True, slots=True)
class Sweep:
    """One measurement of a sensor: a cloud, or the scan of a lidar."""

    sensor: str
    """Its name, for the counters."""
    points: Array
    """Metres in the sensor's frame, shape (n, 3 or more), of which x, y and z are used; anything, from the network."""
    mount: Transform
    """The sensor's frame in that of the base."""
    base: Transform
    """The frame of the base in the local one."""
    time: float
    """Seconds of any clock that all sweeps of a scene have."""
    postures: Sequence[Mapping[str, float]] = (MappingProxyType({}),)
    """Positions of the joints, by name, during the measurement: the body is filtered out in all of them."""
    empty: Array | None = None
    """Points up to which rays without an echo met nothing, shape (m, 3)."""
    min_range: float = 0.0
    """Metres below which a point is an error of the sensor."""


@dataclass(frozen=True, slots=True)
class SceneSummary:
    """Numbers about a scene at one time."""

    voxels: int
    unknown: int
    """Voxels that are forbidden because nothing is known of them."""
    primitives: int
    low: tuple[float, float, float] | None
    high: tuple[float, float, float] | None
    """Extent of the occupied voxels in the frame of the base, metres; None without voxels."""
    ages: tuple[float, float, float] | None
    """Seconds since the last hit of voxels: the least, the median, the greatest."""
    sweeps: Mapping[str, int]
    """Sweeps that were used, by sensor."""
    dropped: Mapping[str, int]
    """What was not used, by reason."""
    memory: int
    """Bytes of the voxels."""


class Scene:
    """What a robot sees around it; `description` is the robot's, whose links are filtered out. May be used by threads.

    `add` takes what sensors measured, `obstacles` gives what a motion must not touch.
    """

    def __init__(self, description: RobotDescription | None = None, setup: SceneSetup = SceneSetup()) -> None:
        self.setup = setup
        try:
            self._window = VoxelWindow(setup.shape, setup.voxel_size)
        except ValueError as error:
            raise ConfigError(str(error)) from error
        self.body = None if description is None else OwnBody(description, setup.margin)
        """The robot's own body; None for a scene without a robot."""
        self.counters: Counter[str] = Counter()
        """What was not used, by reason."""
        self._sweeps: Counter[str] = Counter()
        self._explored: dict[str, float] = {}
        self._primitives: dict[str, tuple[Frame, Primitive]] = {}
        self._base = Transform()
        self._posture: Mapping[str, float] = MappingProxyType({})
        self._time: float | None = None
        self._placed = -math.inf
        """Time of the pose and the posture."""
        self._lock = Lock()

    @property
    def time(self) -> float | None:
        """Time of the newest sweep; None before the first."""
        return self._time

    def clear(self) -> None:
        """Forget all that was seen; primitives stay."""
        with self._lock:
            self._window.clear()
            self._time, self._placed = None, -math.inf

    def put(self, primitive: Primitive, frame: Frame = Frame.LOCAL, *, within: Frame = Frame.BASE) -> None:
        """Put a primitive into the scene, which replaces one of its name.

        It stays in `frame`; its pose is given `within` that of the base at present, or in the local frame.
        """
        if not all(map(math.isfinite, _numbers(primitive))):
            raise ConfigError(f"{primitive.name}: positions and sizes are finite numbers: {primitive}")
        if len(self._primitives) >= MAX_PRIMITIVES and primitive.name not in self._primitives:
            raise ConfigError(f"{primitive.name}: a scene has {MAX_PRIMITIVES} primitives at most")
        with self._lock:
            if frame is not within:
                base = self._base if frame is Frame.LOCAL else self._base.inverse()
                primitive = replace(primitive, pose=base @ primitive.pose)
            self._primitives[primitive.name] = frame, primitive

    def take_away(self, name: str) -> None:
        """Remove a primitive; without effect for an unknown name."""
        with self._lock:
            self._primitives.pop(name, None)

    def add(self, sweep: Sweep) -> bool:
        """Add what a sensor measured; False if it was dropped, which `counters` explain. Never raises for its data."""
        problem = self._problem(sweep)
        if problem:
            with self._lock:
                self.counters[problem] += 1
            return False
        points, dropped = _usable(sweep.points, sweep.min_range)
        with self._lock:
            self.counters.update(dropped)
            self._move(sweep)
            self._see(sweep, points)
            self._sweeps[sweep.sensor] += 1
        return True

    def move(self, base: Transform, time: float, posture: Mapping[str, float] | None = None) -> None:
        """Tell the pose of the base in the local frame, and the joints' positions, between sweeps."""
        with self._lock:
            if self._time is not None and self._placed <= time <= self._time + MAX_BACK and _is_pose(base):
                self._base, self._placed, self._posture = base, time, posture or self._posture

    def obstacles(self, time: float | None = None) -> Obstacles:
        """What a motion must not touch, in the frame of the base after the newest sweep or `move`.

        Voxels are cubes along the axes of the local frame. `time` is by default that of the newest sweep.
        """
        with self._lock:
            time = self._time if time is None else time
            cells, unknown = self._cells(time)
            back = self._base.inverse()
            points = _moved(back, self._window.centres(np.concatenate((cells, unknown))))
            if self.body is not None:
                points = points[~self.body.contains(points, [self._posture], 0.0)]
            primitives = tuple(
                primitive if frame is Frame.BASE else replace(primitive, pose=back @ primitive.pose)
                for frame, primitive in self._primitives.values()
            )
        return Obstacles(primitives, points, self.setup.voxel_size)

    def summary(self, time: float | None = None) -> SceneSummary:
        """Numbers about the scene; `time` as in `obstacles`."""
        with self._lock:
            time = self._time if time is None else time
            cells, unknown = self._cells(time)
            points = _moved(self._base.inverse(), self._window.centres(cells))
            low = high = ages = None
            if len(cells) and time is not None:
                half = self.setup.voxel_size / 2.0
                low, high = _triple(points.min(axis=0) - half), _triple(points.max(axis=0) + half)
                seen = self._window.ages(cells, time)
                ages = _triple(np.array((seen.min(), np.median(seen), seen.max())))
            return SceneSummary(
                voxels=len(cells),
                unknown=len(unknown),
                primitives=len(self._primitives),
                low=low,
                high=high,
                ages=ages,
                sweeps=dict(self._sweeps),
                dropped=dict(self.counters),
                memory=self._window.bytes,
            )

    # --- inside ---------------------------------------------------------------------------------------------------

    def _problem(self, sweep: Sweep) -> str:
        """The reason why a sweep cannot be used; empty if it can."""
        if not math.isfinite(sweep.time):
            return "sweep without a time"
        if not (_is_pose(sweep.base) and _is_pose(sweep.mount)):
            return "sweep without a pose"
        if sweep.points.ndim != 2 or sweep.points.shape[1] < 3:
            return "sweep without points"
        if not all(math.isfinite(position) for posture in sweep.postures for position in posture.values()):
            return "sweep without positions of joints"
        if sweep.sensor not in self._sweeps and len(self._sweeps) >= MAX_SENSORS:
            return "sweep of one sensor too many"
        return ""

    def _move(self, sweep: Sweep) -> None:
        """Move the window, and begin anew if the pose or the clock was set."""
        base, time = sweep.base, sweep.time
        if self._time is not None:
            elapsed = abs(time - self._placed)
            way, turn = math.dist(base.position, self._base.position), _angle(self._base, base)
            jumped = way > MAX_JUMP[0] + MAX_SPEED * elapsed or turn > MAX_JUMP[1] + MAX_TURN * elapsed
            if jumped or time < self._time - MAX_BACK:
                self.counters["scene cleared: the pose jumped" if jumped else "scene cleared: the clock went back"] += 1
                self._window.clear()
                self._time, self._placed = None, -math.inf
        self._time = time if self._time is None else max(time, self._time)
        if time >= self._placed:
            self._base, self._placed = base, time
            self._posture = sweep.postures[-1] if sweep.postures else self._posture
        x, y, z = self._base.position
        self._window.centre_on(np.array((x, y, z + self.setup.lift)))

    def _see(self, sweep: Sweep, points: Array) -> None:
        setup, window, body = self.setup, self._window, self.body
        sight = LinesOfSight(points, None if sweep.empty is None else _usable(sweep.empty, 0.0)[0])
        near = points[np.einsum("ni,ni->n", points, points) <= setup.reach**2]
        in_base = _moved(sweep.mount, near)
        if body is not None and len(in_base):
            in_base = in_base[~body.contains(in_base, sweep.postures)]
        hits = window.cells(_moved(sweep.base, in_base))
        seen = window.occupied(sweep.time)
        back = (sweep.base @ sweep.mount).inverse()
        window.pass_through(seen[sight.pass_through(_moved(back, window.centres(seen)), setup.voxel_size)], setup.loss)
        # after the rays, so that what they hit has its evidence, too: on a surface that is nearly along them, rays
        # graze the voxels that others of the same sweep hit
        window.hit(hits, sweep.time, setup.gain + setup.loss, setup.keep)
        if setup.unknown is Unknown.FORBIDDEN:
            self._explore(sweep, sight, back)

    def _explore(self, sweep: Sweep, sight: LinesOfSight, back: Transform) -> None:
        """Mark as known what the sensor looked through, and where the robot itself is; not in each sweep of many."""
        if abs(sweep.time - self._explored.get(sweep.sensor, -math.inf)) < EXPLORE_PERIOD:
            return
        self._explored[sweep.sensor] = sweep.time
        setup, window = self.setup, self._window
        around = window.unknown(np.array(sweep.base.position), setup.unknown_reach)
        passed = sight.pass_through(_moved(back, window.centres(around)), setup.voxel_size)
        window.mark_known(around[passed])
        if self.body is not None and sweep.postures:
            inside = self.body.samples(sweep.postures[-1], setup.voxel_size / 2.0)
            window.mark_known(window.cells(_moved(sweep.base, inside)))

    def _cells(self, time: float | None) -> tuple[Indices, Indices]:
        """The occupied voxels, and the unknown ones that are forbidden: those beside what is known."""
        nothing = np.empty((0, 3), np.int64)
        if time is None:
            return nothing, nothing
        occupied = self._window.occupied(time)
        if self.setup.unknown is Unknown.FREE:
            return occupied, nothing
        return occupied, self._window.frontier(np.array(self._base.position), self.setup.unknown_reach)


def _usable(points: Array, min_range: float) -> tuple[Array, dict[str, int]]:
    """The finite points of a sensor as float64, shape (n, 3), at most `MAX_POINTS`, and how many were dropped."""
    rows = points[:, :3] if points.ndim == 2 and points.shape[1] >= 3 else np.empty((0, 3))
    dropped: dict[str, int] = {}
    if len(rows) > MAX_POINTS:
        dropped["points beyond the most of a sweep"] = len(rows) - MAX_POINTS
        rows = rows[np.linspace(0, len(rows) - 1, MAX_POINTS).astype(np.intp)]
    # comparisons with NaN are false; both are made before any arithmetic, which would overflow
    within = (np.abs(rows) <= FARTHEST).all(axis=1)
    if count := len(rows) - int(within.sum()):
        dropped["points that are no positions"] = count
    found: Array = rows[within].astype(np.float64)
    return found[np.einsum("ni,ni->n", found, found) > min_range * min_range], dropped


def _moved(frame: Transform, points: Array) -> Array:
    """Points of an inner frame, shape (n, 3), in the outer one."""
    found: Array = points @ np.array(frame.rotation).T + np.array(frame.position)
    return found


def _is_pose(frame: Transform) -> bool:
    numbers = [value for row in frame.rotation for value in row]
    return all(map(math.isfinite, numbers)) and all(abs(value) <= FARTHEST_BASE for value in frame.position)


def _angle(one: Transform, other: Transform) -> float:
    """Radians between two attitudes."""
    trace = float(np.einsum("ij,ij->", np.array(one.rotation), np.array(other.rotation)))
    return math.acos(max(-1.0, min(1.0, (trace - 1.0) / 2.0)))


def _numbers(primitive: Primitive) -> Iterable[float]:
    yield from (value for row in primitive.pose.rotation for value in row)
    yield from primitive.pose.position
    if isinstance(primitive, Box):
        yield from primitive.size
    else:
        yield primitive.radius


def _triple(values: Array) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 4) for value in values)
    return x, y, z
