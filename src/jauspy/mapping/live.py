"""A map while a robot drives: its scans and poses over JAUS."""

from __future__ import annotations

import asyncio
import math
from collections import Counter, deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.mapping.mapper import Mapper
from jauspy.mapping.pose import PlanarPose
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
"""Of a point's optional fields: tells rays without echo, which show what is free."""
POSE_RATE: Final = 25.0
"""Hz of the poses between which scans are placed."""
MAX_POSES: Final = 128
"""Poses that are remembered."""
POSE_TIMEOUT: Final = 1.0
"""Seconds in which a pose must come that is later than a scan."""
SILENCE_TIMEOUT: Final = 5.0
"""Seconds without a scan, or a pose, after which the sensor counts as gone."""
MAX_TILT: Final = math.radians(2.0)
"""Roll and pitch beyond which a scan is left out: on a ramp it shows the ground as a wall."""
DAY: Final = 86400.0


@dataclass(frozen=True, slots=True)
class _StampedPose:
    time: float
    pose: PlanarPose
    is_level: bool


class LiveMapping:
    """Maps with sensor `sensor` of a robot's RangeSensor, by its LocalPoseSensor as odometry.

    A scan takes some 30 ms of work. `threaded` does it in a thread, for programs that have other things to do in time.
    """

    def __init__(self, robot: Robot, mapper: Mapper, sensor: int = 1, *, threaded: bool = False) -> None:
        self._robot = robot
        self._sensor = sensor
        self._threaded = threaded
        self.mapper = mapper
        self.counters: Counter[str] = Counter()
        """`scans` used; and of others why not: `tilted`, `no pose in time`, `sensor not active`."""
        self._poses: deque[_StampedPose] = deque(maxlen=MAX_POSES)
        self._news = asyncio.Condition()

    async def run(self) -> None:
        """Until cancelled; raises `ResponseTimeout` when the robot falls silent, `ConfigError` for what it lacks."""
        ranging = self._robot.service("environmentSensing:RangeSensor")
        lidar = await self._mounting(ranging)
        try:
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(self._follow())
                tasks.create_task(self._scan(ranging, lidar))
        except ExceptionGroup as group:
            raise group.exceptions[0] from group

    async def _scan(self, ranging: ServiceClient, lidar: PlanarPose) -> None:
        record = QueryRangeSensorData.QueryRangeSensorDataRec(self._sensor, 0, VALIDITY_FIELD)
        query = QueryRangeSensorData([record])
        async for report in ranging.subscribe(query, expects=ReportRangeSensorData, silence=SILENCE_TIMEOUT):
            await self._take(report, lidar)

    async def _mounting(self, ranging: ServiceClient) -> PlanarPose:
        query = QuerySensorGeometricProperties([SensorIDQueryRec(self._sensor)])
        report = await ranging.query(query, expects=ReportSensorGeometricProperties)
        for found in report.geometric_properties_list:
            place = found.geometric_properties_variant
            if isinstance(place, StaticGeometricPropertiesRec):
                x, y, _ = place.sensor_position
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
            tilt = max(abs(report.roll or 0.0), abs(report.pitch or 0.0))
            pose = PlanarPose(report.x or 0.0, -(report.y or 0.0), -(report.yaw or 0.0))
            async with self._news:
                self._poses.append(_StampedPose(_seconds(report.time_stamp), pose, tilt < MAX_TILT))
                self._news.notify_all()

    async def _take(self, report: ReportRangeSensorData, lidar: PlanarPose) -> None:
        for found in report.range_sensor_data_list:
            if not isinstance(found, ReportRangeSensorData.RangeSensorDataSeq):
                self.counters["sensor not active"] += 1
                continue
            seen = await self._at(_seconds(found.range_sensor_data_rec.time_stamp))
            if seen is None or not seen.is_level:
                self.counters["no pose in time" if seen is None else "tilted"] += 1
                continue
            points = found.range_sensor_data_point_list
            ranges = [point.range if point.range_validity else math.inf for point in points]
            await self._add(seen.pose, lidar, [-point.bearing for point in points], ranges)
            self.counters["scans"] += 1

    async def _add(self, pose: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]) -> None:
        """Who cancels this finds the map whole."""
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
        """Where the robot was at that time of the day; None when no poses around it come."""
        try:
            async with asyncio.timeout(POSE_TIMEOUT), self._news:
                await self._news.wait_for(lambda: self._poses and _after(self._poses[-1].time, time) >= 0.0)
        except TimeoutError:
            return None
        earlier = [each for each in self._poses if _after(each.time, time) <= 0.0]
        later = next(each for each in self._poses if _after(each.time, time) >= 0.0)
        return interpolated(earlier[-1], later, time) if earlier else None


def interpolated(before: _StampedPose, later: _StampedPose, time: float) -> _StampedPose:
    """The pose at a time between those of two others."""
    whole = _after(later.time, before.time)
    part = _after(time, before.time) / whole if whole else 0.0
    step = later.pose.since(before.pose)
    moved = before.pose.then(PlanarPose(step.x * part, step.y * part, step.yaw * part))
    return _StampedPose(time, moved, before.is_level and later.is_level)


def _seconds(stamp: Any) -> float:
    """Of the day."""
    return float(stamp.hour * 3600.0 + stamp.minutes * 60.0 + stamp.seconds + stamp.milliseconds / 1000.0)


def _after(time: float, other: float) -> float:
    """How much later one time of the day is than another, also past midnight."""
    return math.remainder(time - other, DAY)
