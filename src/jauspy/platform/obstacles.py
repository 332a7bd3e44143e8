"""Obstacles around a robot, from its lidars and depth cameras, as points in the frame of its odometry. Needs numpy."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, NamedTuple, TypeAlias

import numpy as np

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.description import GuardedTeleopSetup
from jauspy.platform.ranging import RangeFinder, RangeScan

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[np.floating[Any]]

HISTORY: Final = 64
"""States of the robot that are kept, to place what was seen before."""
OWN: Final = 0.04
"""Metres around the robot's own links in which points are its own."""
CELL: Final = 0.04
"""Metres of a cell of the ground, of which one point is kept."""
MEMORY: Final = 30.0
"""Seconds for which points are kept that depth cameras see no more: what is near is below or beside their sight."""
PIXEL: Final = 0.05
"""Tangent of the angle of a cell of a depth camera's view, in which it sees whether a point has gone."""
GONE: Final = 0.15
"""Metres by which a camera must see beyond a point for it to have gone."""
MAX_POINTS: Final = 4000
"""Points of depth cameras that are kept."""
MANY: Final = 720
"""Points of one measurement above which one is kept of each cell; fewer are exact."""
REACH: Final = 5.0
"""Metres from the sensor in which points are kept."""


class _Moment(NamedTuple):
    """The robot at one time."""

    time: float
    pose: Pose
    posture: Sequence[float]


class Obstacles:
    """Points that are higher above the ground than a robot drives over, and lower than it is.

    A point's height counts above the plane that the robot stands on and above the level of its base, whichever is less:
    neither the ramp that it drives on nor the ground ahead of its nose is an obstacle then.
    """

    def __init__(self, setup: GuardedTeleopSetup, boxes: LinkBoxes, sensors: Sequence[str]) -> None:
        self._height = setup.height
        self._boxes = boxes
        self._scans: dict[str, RangeScan] = {}
        self._lidar: dict[str, Array] = {}
        self._camera = np.zeros((0, 4))
        """x, y, z and the time at which they were seen."""
        self._moments: deque[_Moment] = deque(maxlen=HISTORY)
        self._seen = dict.fromkeys(sensors, 0.0)
        """When the sensors that are waited for measured last."""

    def clear(self, now: float) -> None:
        """Forget all; sensors have some time from `now` on to see again."""
        self._scans, self._lidar, self._camera = {}, {}, np.zeros((0, 4))
        self._seen = dict.fromkeys(self._seen, now)

    def oldest(self, now: float) -> tuple[str, float]:
        """The sensor, of those that are waited for, that measured longest ago, and the seconds since."""
        name = min(self._seen, key=lambda name: self._seen[name])
        return name, now - self._seen[name]

    def update(self, now: float, pose: Pose, posture: Sequence[float], lidars: Mapping[str, RangeFinder]) -> None:
        """Take the last scans, which show the robot's surroundings at their times."""
        self._moments.append(_Moment(now, pose, posture))
        for name, lidar in lidars.items():
            scan = lidar.scan
            if scan is None:
                self._lidar.pop(name, None)
            elif scan is not self._scans.get(name):
                self._scans[name] = scan
                self._lidar[name] = self._placed(scan.frame, _points(scan), self._moment(scan.time))
                self._note(name, scan.time)
        if len(self._camera):
            self._camera = self._camera[self._camera[:, 3] >= now - MEMORY]

    def add_points(self, camera: str, frame: str, points: Array, time: float) -> None:
        """Take points (n, 3) that a camera saw in the frame of a link at a time of the robot, in seconds.

        Where it sees beyond points that were there before, these are forgotten.
        """
        self._note(camera, time)
        moment = self._moment(time)
        points = points[np.isfinite(points).all(axis=1)]
        placed = self._placed(frame, points, moment)
        if len(self._camera) and len(points):
            turn, place = self._pose(frame, moment)
            self._camera = self._camera[~_seen_through((self._camera[:, :3] - place) @ turn, points)]
        if len(placed):
            rows = np.concatenate((np.column_stack((placed, np.full(len(placed), time))), self._camera))
            self._camera = rows[_one_a_cell(rows)][:MAX_POINTS]

    def around(self, pose: Pose, reach: float) -> Array:
        """The points within `reach` metres, in the level frame of the robot at this pose: shape (n, 2)."""
        points = np.concatenate((*self._lidar.values(), self._camera[:, :3]))
        offsets = points[:, :2] - (pose.x, pose.y)
        offsets = offsets[np.abs(offsets).max(axis=1) <= reach]
        cosine, sine = np.cos(pose.yaw), np.sin(pose.yaw)
        return np.column_stack(
            (cosine * offsets[:, 0] + sine * offsets[:, 1], cosine * offsets[:, 1] - sine * offsets[:, 0])
        )

    def _note(self, sensor: str, time: float) -> None:
        if sensor in self._seen:
            self._seen[sensor] = max(self._seen[sensor], time)

    def _moment(self, time: float) -> _Moment:
        """The state of the robot that was nearest to a time."""
        standing = _Moment(time, Pose(), [0.0] * len(self._boxes.joints))
        return min(self._moments, key=lambda moment: abs(moment.time - time), default=standing)

    def _pose(self, frame: str, moment: _Moment) -> tuple[Array, Array]:
        """Rotation and position of a link in the frame of the odometry."""
        turn, place = self._boxes.frame(frame, moment.posture)
        base = Transform.from_pose(moment.pose)
        rotation = np.array(base.rotation)
        return rotation @ turn, rotation @ place + np.array(base.position)

    def _placed(self, frame: str, points: Array, moment: _Moment) -> Array:
        """The points that are obstacles, in the frame of the odometry: shape (n, 3)."""
        turn, place = self._boxes.frame(frame, moment.posture)
        on_base = points[np.isfinite(points).all(axis=1)] @ turn.T + place
        base = Transform.from_pose(moment.pose)
        level = on_base @ np.array(base.rotation).T
        height = np.minimum(on_base[:, 2], level[:, 2])
        is_near = np.abs(level[:, :2]).max(axis=1, initial=0.0) <= REACH
        chosen = is_near & (height >= self._height[0]) & (level[:, 2] <= self._height[1])
        on_base, level = on_base[chosen], level[chosen]
        if not len(level):
            return np.zeros((0, 3))
        if len(level) > MANY:
            kept = _one_a_cell(level)
            on_base, level = on_base[kept], level[kept]
        found: Array = level[~self._boxes.contain(on_base, moment.posture, OWN)] + np.array(base.position)
        return found


def _seen_through(points: Array, seen: Array) -> NDArray[np.bool_]:
    """For each point in a camera's frame (x ahead): True if all that was `seen` in that direction is beyond it."""
    cells, first = np.unique(_directions(seen[np.argsort(seen[:, 0])]), return_index=True)
    nearest = np.sort(seen[:, 0])[first]
    ahead = np.maximum(points[:, 0], CELL)
    directions = _directions(np.column_stack((ahead, points[:, 1:])))
    places = np.minimum(np.searchsorted(cells, directions), len(cells) - 1)
    found: NDArray[np.bool_] = (
        (points[:, 0] > 0.0) & (cells[places] == directions) & (nearest[places] > points[:, 0] + GONE)
    )
    return found


def _directions(points: Array) -> NDArray[np.int64]:
    """The cell of the view in which each point is."""
    across, up = (np.floor(points[:, axis] / (PIXEL * points[:, 0])).astype(np.int64) for axis in (1, 2))
    return across * (1 << 32) + up


def _one_a_cell(points: Array) -> NDArray[np.intp]:
    """The numbers of the points of which one is in each cell of x and y, the first of each; ascending."""
    cells = np.floor(points[:, :2] / CELL).astype(np.int64)
    _, first = np.unique(cells[:, 0] * (1 << 32) + cells[:, 1], return_index=True)
    return np.sort(first)


def _points(scan: RangeScan) -> Array:
    """The end points of the rays with an echo, in the lidar's frame: shape (n, 3)."""
    ranges = scan.image().astype(float)
    ranges = np.where(np.isfinite(ranges), ranges, np.nan)
    up, bearing = np.array(scan.inclinations)[:, None], np.array(scan.angles)[None]
    level = ranges * np.cos(up)
    return np.stack((level * np.cos(bearing), level * np.sin(bearing), ranges * np.sin(up)), axis=-1).reshape(-1, 3)
