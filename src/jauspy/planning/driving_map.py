"""What a robot that finds its way knows of its surroundings: a map of scans, the last echoes, and an elevation grid."""

# ruff: noqa: ASYNC109 - a wait that ends early is no error

from __future__ import annotations

import asyncio
import math
import threading
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Final, ParamSpec, Self, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ResponseTimeout
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.elevation import ElevationGrid, GroundHeights
from jauspy.mapping.grid import OccupancyGrid, Points, transformed
from jauspy.mapping.live import LiveMapping
from jauspy.mapping.live_elevation import BODY_MARGIN, LiveElevation
from jauspy.mapping.mapper import Mapper
from jauspy.ocu.robot import Robot
from jauspy.planning.ground import Ground, GroundMemory
from jauspy.planning.mobility import Mobility
from jauspy.planning.own_body import OwnBody
from jauspy.planning.terrain_cost import OCCUPIED, TerrainCost
from jauspy.platform.description import RobotModel
from jauspy.robot.config import RobotConfig

MakeHeights: TypeAlias = Callable[[Callable[[], PlanarPose]], LiveElevation]
"""Makes what fills an elevation grid, in a frame of which the argument tells the pose of the local frame."""

P = ParamSpec("P")
T = TypeVar("T")

Corners: TypeAlias = tuple[tuple[float, float], ...]
"""Corners of a zone in the local frame, metres, y left."""

SCAN_RATE: Final = 10.0
"""Hz of the scans, so that what appears is seen soon."""
ECHO_RANGE: Final = 5.0
"""Metres of the echoes that count at once; farther ones, whose places are less certain, when the map has them."""
ECHO_TIME: Final = 0.6
"""Seconds for which an echo counts that the map does not have."""
STANDING_INTERVAL: Final = 0.5
"""Seconds after which scans of a robot that stands change the map, so that what was moved away disappears."""
WINDOW_MARGIN: Final = 4.0
"""Metres of the map around start and goal in which a way is sought, beyond all that is known."""
FIRST_SCAN_TIMEOUT: Final = 10.0
"""Seconds until the first scan."""
FIRST_HEIGHTS_TIMEOUT: Final = 20.0
"""Seconds until the first cloud that can be used: depth cameras take some to start."""
KEPT_WAY: Final = 7.0
"""Metres of the way after which heights are forgotten that were not measured again: poses drift by 2 mm a metre."""
HEIGHTS_SIZE: Final = 16.0
"""Side of the elevation grid, metres."""


@dataclass(frozen=True, slots=True)
class _Echoes:
    time: float
    points: Points
    """In the map, metres, shape (n, 2)."""


class DrivingMap:
    """The map of one robot while the block is entered; its frame is the local frame when the first scan was added.

    `known`, as by `load_map`, is a map that was made before, with a frame of its own: the place of the robot in it is
    searched around `start`, by default its pose in the local frame, and `ConfigError` raised if nothing there fits.
    `heights`, as by `heights_of_clouds`, makes what fills an elevation grid in the same frame. `allow_unknown`: the
    robot may drive where nothing is known. Without `threaded`, as on virtual time, all is computed in the event loop.
    """

    def __init__(
        self,
        robot: Robot,
        *,
        size: float = 40.0,
        resolution: float = 0.05,
        known: OccupancyGrid | None = None,
        start: PlanarPose | None = None,
        sensor: int = 1,
        allow_unknown: bool = True,
        heights: MakeHeights | None = None,
        threaded: bool = True,
    ) -> None:
        self.grid = OccupancyGrid(size, resolution) if known is None else known
        self.mapper = Mapper(self.grid, is_known=known is not None, start=start)
        self.zones: Sequence[Corners] = ()
        """Zones of the local frame that are not entered."""
        self.allow_unknown = allow_unknown
        self.heights = None if heights is None else heights(lambda: self.mapper.correction)
        """What fills the elevation grid; None without."""
        self._memory, self._lock = GroundMemory(), threading.Lock()
        self._ground: tuple[GroundHeights, Mobility, Ground] | None = None
        """The ground at last, and what it was made of."""
        self._threaded = threaded
        self.live = LiveMapping(
            robot, self.mapper, sensor, threaded=threaded, rate=SCAN_RATE, on_placed=self._take_scan
        )
        self._echoes: deque[_Echoes] = deque(maxlen=16)
        self._added = (0, -math.inf)
        self._first = asyncio.Event()
        self._news = asyncio.Event()
        self._running: list[asyncio.Task[None]] = []

    async def __aenter__(self) -> Self:
        self._running = [asyncio.create_task(self.live.run(), name="navigation: map")]
        first = asyncio.create_task(self._first.wait())
        await asyncio.wait({first, *self._running}, timeout=FIRST_SCAN_TIMEOUT, return_when=asyncio.FIRST_COMPLETED)
        first.cancel()
        try:
            self.check()
            if self.heights is not None:  # not before the place in the map is known
                self._running.append(asyncio.create_task(self.heights.run(), name="navigation: heights"))
            await self._until_heights()
        except BaseException:
            await self._end()
            raise
        return self

    async def _until_heights(self) -> None:
        """Wait for the first cloud; raises `ResponseTimeout` when none can be used."""
        clock = asyncio.get_running_loop().time
        end = clock() + FIRST_HEIGHTS_TIMEOUT
        while self.heights is not None and self.heights.latest is None:
            if clock() > end:
                reasons = ", ".join(f"{count} {reason}" for reason, count in self.heights.counters.items() if count)
                raise ResponseTimeout(f"no cloud could be used within {FIRST_HEIGHTS_TIMEOUT:g} s: {reasons or 'none'}")
            await asyncio.sleep(0.05)
            self.check()

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._end()

    async def _end(self) -> None:
        running, self._running = self._running, []
        for task in running:
            task.cancel()
        if running:
            await asyncio.wait(running)

    def check(self) -> None:
        """Raise the error that ended the map or the heights, if one did."""
        for task in self._running:
            if task.done() and not task.cancelled():
                task.result()

    async def wait(self, course: asyncio.Future[Any], timeout: float) -> None:
        """Wait until a scan has come since the last call, or a course has ended, at most for `timeout` seconds."""
        news = asyncio.create_task(self._news.wait())
        await asyncio.wait({course, news}, timeout=timeout, return_when=asyncio.FIRST_COMPLETED)
        news.cancel()
        self._news.clear()

    async def compute(self, function: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """The result of a function that takes long, computed in a thread if the map is `threaded`."""
        if self._threaded:
            return await asyncio.to_thread(function, *args, **kwargs)
        return function(*args, **kwargs)

    def to_map(self, local: PlanarPose) -> PlanarPose:
        """A pose of the local frame in the map, which compensates for the drift of odometry."""
        return self.mapper.correction @ local

    def to_local(self, x: float, y: float) -> tuple[float, float]:
        """A point of the map in the local frame."""
        found = self.mapper.correction.inverse() @ PlanarPose(x, y, 0.0)
        return found.x, found.y

    def terrain(self, mobility: Mobility, places: Sequence[tuple[float, float]], margin: float = 0.0) -> TerrainCost:
        """The cost for a robot in a window around some places of the map, in metres.

        With a `margin`, in metres, the window has it around the places; without, all that is known is in it.
        """
        grid, odds = self.grid, self.grid.log_odds
        side = grid.resolution
        points = np.array(places)
        low, high = points.min(axis=0) - (margin or WINDOW_MARGIN), points.max(axis=0) + (margin or WINDOW_MARGIN)
        if not margin:
            rows, columns = (np.flatnonzero((odds != 0.0).any(axis=axis)) for axis in (1, 0))
            if len(rows):
                seen = np.array([[columns[0], rows[0]], [columns[-1] + 1, rows[-1] + 1]]) * side + grid.low
                low, high = np.minimum(low, seen[0]), np.maximum(high, seen[1])
        first = np.clip(np.floor((low - grid.low) / side), 0, grid.cells - 1).astype(int)
        last = np.clip(np.ceil((high - grid.low) / side), first + 1, grid.cells).astype(int)
        window = odds[first[1] : last[1], first[0] : last[0]].copy()
        left, lower = (first * side + grid.low).tolist()
        return TerrainCost(
            mobility,
            (window > OCCUPIED) | self._zone_cells(window.shape, (left, lower)),
            window != 0.0,
            (left, lower),
            side,
            ground=self._ground_for(mobility),
            points=self._last_echoes(),
            allow_unknown=self.allow_unknown,
            scan_height=self.live.lidar_height,
        )

    def _ground_for(self, mobility: Mobility) -> Ground | None:
        """The ground for a robot, with what was known of it before; None without heights."""
        heights = None if self.heights is None else self.heights.latest
        if heights is None:
            return None
        with self._lock:  # of a call that was cancelled, the thread may still run
            if self._ground is None or self._ground[0] is not heights or self._ground[1] is not mobility:
                ground = self._memory.completed(Ground.of(heights, mobility, heights.hidden, heights.ages))
                self._ground = heights, mobility, ground
            return self._ground[2]

    def _zone_cells(self, shape: tuple[int, ...], origin: tuple[float, float]) -> NDArray[np.bool_]:
        """Cells of a window of this shape in the zones."""
        found = np.zeros(shape, np.bool_)
        side = self.grid.resolution
        ys, xs = np.indices(shape) * side + side / 2.0
        for zone in self.zones:
            corners = [self.mapper.correction @ PlanarPose(*corner) for corner in zone]
            inside = np.zeros(shape, np.bool_)
            for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):  # a ray along x crosses each edge or not
                y, x = ys + origin[1], xs + origin[0]
                crosses = (a.y > y) != (b.y > y)
                inside ^= crosses & (x < a.x + (b.x - a.x) * (y - a.y) / ((b.y - a.y) or 1.0))
            found |= inside
        return found

    def _last_echoes(self) -> Points | None:
        if not self._echoes:
            return None
        newest = self._echoes[-1].time
        return np.concatenate([echoes.points for echoes in self._echoes if newest - echoes.time < ECHO_TIME])

    def _take_scan(self, pose: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]) -> None:
        """Keep the near echoes of a scan; add the scan to the map if the robot stands."""
        now = asyncio.get_running_loop().time()
        bearings, distances = np.asarray(angles, np.float64), np.asarray(ranges, np.float64)
        near = (distances > 0.0) & (distances < ECHO_RANGE)
        ends = transformed(
            lidar, np.column_stack([np.cos(bearings[near]), np.sin(bearings[near])]) * distances[near, None]
        )
        self._echoes.append(_Echoes(now, transformed(self.to_map(pose), ends)))
        count, added = self._added
        if len(self.mapper.path) != count:
            self._added = len(self.mapper.path), now
        elif count and now - added > STANDING_INTERVAL:
            self._added = count, now
            self._add_again(self.to_map(pose) @ lidar, bearings, distances)
        if self.mapper.path or not self.mapper.is_known:  # in a known map, only then is the robot's place in it known
            self._first.set()
        self._news.set()

    def _add_again(self, lidar: PlanarPose, bearings: Points, distances: Points) -> None:
        used = distances > 0.0
        far = np.minimum(distances[used], self.mapper.max_range)
        ends = np.column_stack([far * np.cos(bearings[used]), far * np.sin(bearings[used])])
        self.grid.add(np.array(lidar[:2]), transformed(lidar, ends), distances[used] <= self.mapper.max_range)


def heights_of_clouds(
    robot: Robot, config: RobotConfig, model: RobotModel, clouds: Sequence[str], *, threaded: bool = True
) -> MakeHeights:
    """What makes the heights for a `DrivingMap` from the clouds at these addresses, as in `tcp://127.0.0.1:5566`."""
    body = OwnBody(model.description, BODY_MARGIN)

    def make(local: Callable[[], PlanarPose]) -> LiveElevation:
        grid = ElevationGrid(HEIGHTS_SIZE, kept_way=KEPT_WAY)
        return LiveElevation(robot, config, model, grid, clouds, local=local, is_own=body.contains, threaded=threaded)

    return make
