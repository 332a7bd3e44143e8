"""Maps a running robot: its scans and poses are read over JAUS."""

from __future__ import annotations

import asyncio
import math
from collections import Counter, deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.mapper import Mapper
from jauspy.messages.environment_sensing.v1_0.types import SensorIDQueryRec, StaticGeometricPropertiesRec
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    QueryRangeSensorData,
    QuerySensorGeometricProperties,
    ReportRangeSensorData,
    ReportSensorGeometricProperties,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.robot import Robot
from jauspy.ocu.service import ServiceClient

VALIDITY_FIELD: Final = 1 << 1
"""Presence vector of a point: its validity, which marks rays without an echo; they show free space."""
POSE_RATE: Final = 25.0
"""Rate of pose reports, Hz; the pose of a scan is interpolated between them."""
MAX_POSES: Final = 128
"""Poses kept for interpolation."""
POSE_TIMEOUT: Final = 1.0
"""Seconds to wait for a pose later than a scan."""
SILENCE_TIMEOUT: Final = 5.0
"""Seconds without a scan or a pose after which `ResponseTimeout` is raised."""
MAX_TILT: Final = math.radians(2.0)
"""Roll and pitch, rad, above which a scan is skipped: on a ramp the ground looks like a wall."""
DAY: Final = 86400.0


@dataclass(frozen=True, slots=True)
class _StampedPose:
    time: float
    pose: PlanarPose
    is_level: bool


class LiveMapping:
    """Maps with sensor `sensor` of a robot's RangeSensor, by its LocalPoseSensor as odometry.

    A scan takes about 30 ms of CPU time; with `threaded` it is processed in a thread, so that the event loop runs on.
    `rate` (Hz) is that of the scans, which otherwise come as they are measured. `on_scan` is called with each, used or
    not: the lidar's pose on the robot, the angles of the rays, and their lengths, inf without an echo. `on_placed` is
    called with those that are used, and the odometry's pose of the robot before them.
    """

    def __init__(
        self,
        robot: Robot,
        mapper: Mapper,
        sensor: int = 1,
        *,
        threaded: bool = False,
        rate: float | None = None,
        on_scan: Callable[[PlanarPose, Sequence[float], Sequence[float]], None] | None = None,
        on_placed: Callable[[PlanarPose, PlanarPose, Sequence[float], Sequence[float]], None] | None = None,
    ) -> None:
        self._robot = robot
        self._sensor = sensor
        self._threaded = threaded
        self._rate = rate
        self._on_scan = on_scan
        self._on_placed = on_placed
        self.lidar_height = 0.0
        """Metres above the origin of the robot, once the robot has reported it."""
        self.mapper = mapper
        self.counters: Counter[str] = Counter()
        """`scans` used, and those skipped by reason: `tilted`, `no pose in time`, `sensor not active`.

        `pose without time` counts the poses that were skipped.
        """
        self._poses: deque[_StampedPose] = deque(maxlen=MAX_POSES)
        self._updated = asyncio.Condition()

    async def run(self) -> None:
        """Map until cancelled. Raises `ResponseTimeout` without reports, `ConfigError` without a fixed sensor."""
        ranging = self._robot.service("environmentSensing:RangeSensor")
        lidar = await self._lidar_pose(ranging)
        try:
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(self._follow())
                tasks.create_task(self._scan(ranging, lidar))
        except ExceptionGroup as group:
            raise group.exceptions[0] from group

    async def _scan(self, ranging: ServiceClient, lidar: PlanarPose) -> None:
        record = QueryRangeSensorData.QueryRangeSensorDataRec(self._sensor, 0, VALIDITY_FIELD)
        query = QueryRangeSensorData([record])
        async for report in ranging.subscribe(
            query, rate=self._rate, expects=ReportRangeSensorData, silence=SILENCE_TIMEOUT
        ):
            await self._add_report(report, lidar)

    async def _lidar_pose(self, ranging: ServiceClient) -> PlanarPose:
        query = QuerySensorGeometricProperties([SensorIDQueryRec(self._sensor)])
        report = await ranging.query(query, expects=ReportSensorGeometricProperties)
        for found in report.geometric_properties_list:
            place = found.geometric_properties_variant
            if isinstance(place, StaticGeometricPropertiesRec):
                x, y, down = place.sensor_position
                self.lidar_height = -down
                d, _, _, c = place.unit_quaternion
                return PlanarPose(x, -y, -2.0 * math.atan2(c, d))
        raise ConfigError(
            f"{ranging.id}: sensor {self._sensor} is not there, or not fixed to the robot; maps need that"
        )

    async def _follow(self) -> None:
        sensor = self._robot.service("mobility:LocalPoseSensor")
        async for report in sensor.subscribe(
            QueryLocalPose(0x1FF), rate=POSE_RATE, silence=SILENCE_TIMEOUT, expects=ReportLocalPose
        ):
            if report.time_stamp is None:
                self.counters["pose without time"] += 1
                continue
            tilt = max(abs(report.roll or 0.0), abs(report.pitch or 0.0))
            pose = PlanarPose(report.x or 0.0, -(report.y or 0.0), -(report.yaw or 0.0))
            async with self._updated:
                self._poses.append(_StampedPose(time_of_day(report.time_stamp), pose, tilt < MAX_TILT))
                self._updated.notify_all()

    async def _add_report(self, report: ReportRangeSensorData, lidar: PlanarPose) -> None:
        for found in report.range_sensor_data_list:
            if not isinstance(found, ReportRangeSensorData.RangeSensorDataSeq):
                self.counters["sensor not active"] += 1
                continue
            points = found.range_sensor_data_point_list
            angles = [-point.bearing for point in points]
            ranges = [
                point.range * math.cos(point.inclination or 0.0) if point.range_validity else math.inf
                for point in points
            ]
            if self._on_scan is not None:
                self._on_scan(lidar, angles, ranges)
            stamped = await self._at(time_of_day(found.range_sensor_data_rec.time_stamp))
            if stamped is None or not stamped.is_level:
                self.counters["no pose in time" if stamped is None else "tilted"] += 1
                continue
            if self._on_placed is not None:
                self._on_placed(stamped.pose, lidar, angles, ranges)
            await self._add(stamped.pose, lidar, angles, ranges)
            self.counters["scans"] += 1

    async def _add(self, pose: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]) -> None:
        """Add a scan; when cancelled, wait until it is in the map."""
        if not self._threaded:
            self.mapper.add(pose, lidar, angles, ranges)
            return
        adding = asyncio.create_task(asyncio.to_thread(self.mapper.add, pose, lidar, angles, ranges))
        try:
            await asyncio.shield(adding)
        except asyncio.CancelledError:
            await adding
            raise

    async def _at(self, time: float) -> _StampedPose | None:
        """The pose at a time of day, s; None if there is none before or after it."""
        try:
            async with asyncio.timeout(POSE_TIMEOUT), self._updated:
                await self._updated.wait_for(lambda: self._poses and seconds_after(self._poses[-1].time, time) >= 0.0)
        except TimeoutError:
            return None
        earlier = [pose for pose in self._poses if seconds_after(pose.time, time) <= 0.0]
        later = next(pose for pose in self._poses if seconds_after(pose.time, time) >= 0.0)
        return interpolated(earlier[-1], later, time) if earlier else None


def interpolated(before: _StampedPose, later: _StampedPose, time: float) -> _StampedPose:
    """The pose at a time between two others, linearly."""
    whole = seconds_after(later.time, before.time)
    part = seconds_after(time, before.time) / whole if whole else 0.0
    step = later.pose.relative_to(before.pose)
    moved = before.pose @ PlanarPose(step.x * part, step.y * part, step.yaw * part)
    return _StampedPose(time, moved, before.is_level and later.is_level)


def time_of_day(stamp: Any) -> float:
    """Seconds since midnight."""
    return float(stamp.hour * 3600.0 + stamp.minutes * 60.0 + stamp.seconds + stamp.milliseconds / 1000.0)


def seconds_after(time: float, other: float) -> float:
    """Seconds from one time of day to another, also across midnight."""
    return math.remainder(time - other, DAY)
