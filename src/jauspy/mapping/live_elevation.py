"""The elevation grid of a running robot, from its clouds, poses and joints."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Sequence
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.cloud.stream import Cloud
from jauspy.errors import ResponseTimeout
from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import PlanarPose, Pose, Transform
from jauspy.mapping.elevation import MAX_POINTS, ElevationGrid, GroundHeights
from jauspy.mapping.sensor_feed import Array, Measurement, Positions, SensorFeed
from jauspy.ocu.lidar import Scan
from jauspy.ocu.robot import Robot
from jauspy.platform.description import RobotModel
from jauspy.robot.config import RobotConfig

Flags: TypeAlias = NDArray[np.bool_]
BodyFilter: TypeAlias = Callable[[Array, Sequence[Positions]], Flags]
"""For each point in the frame of the base, shape (n, 3): true if it is in the robot in one of these postures."""

CLOUD_TIMEOUT: Final = 15.0
"""Seconds without a cloud after which `ResponseTimeout` is raised: depth cameras take seconds to start."""
WATCH_INTERVAL: Final = 0.5
"""Seconds between two looks for addresses that are silent."""
TIPPING: Final = 0.04
"""Radians between two clouds by which a robot tips that climbs an edge or comes down from it; on ramps it is less."""
SETTLING_TIME: Final = 1.0
"""Seconds after which its tilt is known well again: accelerations disturb the measured one, and 0.1 rad are 0.3 m of
height three metres ahead."""
BODY_MARGIN: Final = 0.05
"""Metres around the boxes of the robot's links within which points are its own."""


class LiveElevation(SensorFeed):
    """Fills `grid` with the clouds published at `addresses`, in a frame of which `local` tells the local frame's pose.

    Points in the boxes of the robot's links are left out, or those for which `is_own` is true.
    """

    def __init__(
        self,
        robot: Robot,
        config: RobotConfig,
        model: RobotModel,
        grid: ElevationGrid,
        addresses: Sequence[str],
        *,
        local: Callable[[], PlanarPose] = PlanarPose,
        is_own: BodyFilter | None = None,
        threaded: bool = True,
    ) -> None:
        super().__init__(robot, model, clouds=addresses, lidars=False, movers=config.movers, threaded=threaded)
        self.grid = grid
        """To be read between clouds; `latest` is what other threads read."""
        self.latest: GroundHeights | None = None
        """The heights after the last cloud; None before the first."""
        joints = [joint.name for joint in model.description.joints.values() if joint.is_independent]
        self._boxes = LinkBoxes(model.description, joints)
        self._is_own = is_own or self._in_boxes
        self._local = local
        self._up = np.array([0.0, 0.0, 1.0])
        """The vertical in the frame of the robot, at the last cloud."""
        self._tipped = -math.inf
        """When that last changed fast."""
        self._has_tipped = False
        """True if it has, since the last cloud that was used."""
        self._arrivals = dict.fromkeys(self._clouds, math.nan)
        """When the last cloud of each address came, by the clock of the event loop."""

    async def run(self) -> None:
        """Map until cancelled; errors are those of `SensorFeed`, and `ResponseTimeout` for addresses without clouds."""
        self._arrivals = dict.fromkeys(self._clouds, self._clock())
        try:
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(super().run())
                tasks.create_task(self._watch())
        except ExceptionGroup as group:
            raise group.exceptions[0] from group

    async def _watch(self) -> None:
        while True:
            await asyncio.sleep(WATCH_INTERVAL)
            for address, at in self._arrivals.items():
                if self._clock() - at > CLOUD_TIMEOUT:
                    raise ResponseTimeout(
                        f"{address}: no cloud for {CLOUD_TIMEOUT:g} s; is the robot started with --cloud {address}?"
                    )

    def offer(self, name: str, measured: Cloud | tuple[Scan, Transform]) -> None:
        """Take the newest cloud of an address; one that still waits for its turn is dropped and counted."""
        self._arrivals[name] = self._clock()
        super().offer(name, measured)

    def use(self, measured: Measurement) -> bool:
        """Add a cloud to the grid, unless the robot tips or has just tipped: then its tilt is not known well enough."""
        up = np.array(measured.base.rotation)[2]
        if np.linalg.norm(up - self._up) > TIPPING:
            self._tipped = measured.time
        self._up = up
        if 0.0 <= measured.time - self._tipped < SETTLING_TIME:
            self.counters["clouds of a robot that tips"] += 1
            self._has_tipped = True
            return False
        positions = measured.postures[-1]
        every = max(1, -(-len(measured.points) // MAX_POINTS))
        points = np.asarray(measured.points[::every, :3], np.float64)
        finite = np.isfinite(points).all(axis=1)
        self.counters["points that are no positions"] += int(len(points) - np.count_nonzero(finite))
        points = points[finite]
        turn, place = np.array(measured.mount.rotation), np.array(measured.mount.position)
        own = self._is_own(points @ turn.T + place, measured.postures)
        self.counters["own points"] += int(np.count_nonzero(own))
        x, y, yaw = self._local()
        base = Transform.from_pose(Pose(x, y, yaw=yaw)) @ measured.base
        used = self.grid.add(points[~own], base @ measured.mount, measured.time, has_tipped=self._has_tipped)
        self._has_tipped = False
        if self._boxes.names:
            size, ground = footprint(self._boxes, positions)
            self.grid.add_footprint(base, size, ground, measured.time)
        self.counters["clouds"] += 1
        self.latest = self.grid.ground
        return used > 0

    def _in_boxes(self, points: Array, postures: Sequence[Positions]) -> Flags:
        found: Flags = np.zeros(len(points), np.bool_)
        for positions in postures:
            found |= self._boxes.contain(points, _row(self._boxes, positions), BODY_MARGIN)
        return found


def _row(boxes: LinkBoxes, positions: Positions) -> list[float]:
    return [positions.get(name, 0.0) for name in boxes.joints]


def footprint(boxes: LinkBoxes, positions: Positions) -> tuple[tuple[float, float], float]:
    """Length and width, m, of the lowest boxes of the robot around its base, and how far they reach below it, m."""
    turns, middles = boxes.poses(np.array([_row(boxes, positions)]))
    reach: NDArray[Any] = (np.abs(turns[0]) @ boxes.halves[..., None])[..., 0]
    low, high = middles[0] - reach, middles[0] + reach
    bottom = low[:, 2].min()
    standing = low[:, 2] < bottom + BODY_MARGIN
    x, y = np.minimum(-low[standing].min(axis=0), high[standing].max(axis=0))[:2]
    return (2.0 * max(0.0, float(x)), 2.0 * max(0.0, float(y))), -float(bottom)
