"""Makes a map out of scans and odometry, and says where the robot is on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.matching import match
from jauspy.mapping.pose import PlanarPose, Points

MAX_RANGE: Final = 15.0
"""Metres that are mapped of a ray; farther away a small tilt of the robot counts for too much."""
MIN_DISTANCE: Final = 0.1
MIN_TURN: Final = math.radians(5.0)
"""Metres and radians of driving after which a scan goes into the map."""
ODOMETRY_DEVIATION: Final = (0.05, math.radians(2.0))
"""How far odometry may be off from one of those scans to the next, in metres and radians (standard deviations)."""


class Mapper:
    """Feed it scans; `grid` is the map, in the frame of the first odometry's origin."""

    def __init__(self, grid: OccupancyGrid | None = None, *, matching: bool = True, reach: float = MAX_RANGE) -> None:
        self.grid = grid or OccupancyGrid()
        self.path: list[PlanarPose] = []
        """Where the robot was when scans went into the map."""
        self._matching = matching
        self._reach = reach
        self._correction = PlanarPose()

    def add(
        self, odometry: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> PlanarPose:
        """A scan of a lidar that sits at `lidar` on the robot: radians and metres; inf is no echo, -inf too close.

        Returns where the robot is on the map. `odometry`: where it thinks it is, which may drift.
        """
        guess = self._correction.then(odometry)
        if self.path and not _moved(guess.since(self.path[-1])):
            return guess
        ends, echoes = self._ends(lidar, angles, ranges)
        pose = match(self.grid, ends[echoes], guess, ODOMETRY_DEVIATION) if self.path and self._matching else guess
        self.grid.add(np.array(pose.then(lidar)[:2]), pose.apply(ends), echoes)
        self.path.append(pose)
        self._correction = pose.then(odometry.inverse())
        return pose

    def _ends(
        self, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> tuple[Points, NDArray[np.bool_]]:
        """Where rays end, in the robot's frame, and which of them at something."""
        at, far = np.asarray(angles), np.asarray(ranges)
        used = far > 0.0
        at, far = at[used], far[used]
        echoes = far <= self._reach
        far = np.minimum(far, self._reach)
        return lidar.apply(np.column_stack([far * np.cos(at), far * np.sin(at)])), echoes


def _moved(step: PlanarPose) -> bool:
    return math.hypot(step.x, step.y) >= MIN_DISTANCE or abs(step.yaw) >= MIN_TURN
