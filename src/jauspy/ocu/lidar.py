"""A lidar: its scans as plain numbers, with the axes of REP-103."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncGenerator
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.messages.environment_sensing.v1_0.types import SensorIDQueryRec, StaticGeometricPropertiesRec
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    QueryRangeSensorCapabilities,
    QueryRangeSensorData,
    QuerySensorGeometricProperties,
    ReportRangeSensorCapabilities,
    ReportRangeSensorData,
    ReportSensorGeometricProperties,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.state import RobotPose, datetime_of
from jauspy.ocu.subscription import subscribe
from jauspy.ocu.subsystems import ComponentInfo, choose_sensor
from jauspy.printable import printable

RANGE_SENSOR: Final = "environmentSensing:RangeSensor"
VALIDITY_FIELD: Final = 1 << 1
"""Presence vector of a point: its validity. Without it, rays without an echo are left out."""
MAX_WAITING: Final = 4
"""Scans that wait to be read, at most; the oldest go first."""
SILENCE: Final = 5.0
"""Seconds without a scan after which reading raises."""


@dataclass(frozen=True, slots=True)
class Scan:
    """One scan of a lidar, in the frame of its link: x forward, y left, z up. Metres and radians."""

    angles: tuple[float, ...]
    """The direction of each ray in the x-y plane, counterclockwise from x."""
    ranges: tuple[float, ...]
    """The distance along each ray; infinite without an echo."""
    inclinations: tuple[float, ...] = field(repr=False)
    """How far each ray points above the x-y plane; zero for a lidar of one layer."""
    time: datetime | None
    """The time of the measurement, by the robot's clock."""

    def points(self) -> list[tuple[float, float, float]]:
        """The points that returned an echo: x, y and z."""
        rows = zip(self.angles, self.ranges, self.inclinations, strict=True)
        return [
            (
                distance * math.cos(angle) * math.cos(inclination),
                distance * math.sin(angle) * math.cos(inclination),
                distance * math.sin(inclination),
            )
            for angle, distance, inclination in rows
            if math.isfinite(distance)
        ]


class Lidar:
    """One lidar of a robot; `name` is that of the sensor, None for the only one."""

    def __init__(self, connection: Connection, components: tuple[ComponentInfo, ...], name: str | None) -> None:
        self.name: str | None = name
        """The name that was given to `Robot.lidar`."""
        self._connection = connection
        self._components = components
        self._found: tuple[ComponentInfo, int] | None = None

    def __repr__(self) -> str:
        return f"<lidar {self.name or ''}>"

    async def scans(
        self, *, rate: float | None = None, buffer: int = MAX_WAITING, silence: float = SILENCE
    ) -> AsyncGenerator[Scan, None]:
        """Scans as they are measured, or at `rate` Hz.

        At most `buffer` scans wait to be read; a slow reader loses the oldest. Raises `ConfigError` when the robot has
        no such lidar, and when no scan arrives for `silence` seconds `RequestError` with the robot's reason, or
        `ResponseTimeout`. The robot stops sending when the loop is left.
        """
        check_number(silence, "silence")
        component, sensor = await self._find()
        query = QueryRangeSensorData([QueryRangeSensorData.QueryRangeSensorDataRec(sensor, _NATIVE, VALIDITY_FIELD)])
        clock, reason = asyncio.get_running_loop().time, ""
        end = clock() + silence
        reports = subscribe(
            self._connection, component.id, query, ReportRangeSensorData, rate=rate, buffer=buffer, silence=silence
        )
        async with reports:
            while True:
                try:
                    report = await reports.get()
                except ResponseTimeout as error:
                    raise RequestError(reason) if reason else error from None
                for record in report.range_sensor_data_list:
                    if isinstance(record, ReportRangeSensorData.RangeSensorDataSeq):
                        yield _scan(record)
                        end, reason = clock() + silence, ""
                    else:  # a lidar that has just been started measures soon
                        reason = f"the lidar of {component.id} does not measure: {_reason(record)}"
                if reason and clock() > end:
                    raise RequestError(reason)

    async def pose(self) -> RobotPose:
        """Where it is mounted: the pose of its link in the robot's frame.

        Raises `ConfigError` when the robot does not report a fixed place.
        """
        component, sensor = await self._find()
        query = QuerySensorGeometricProperties([SensorIDQueryRec(sensor)])
        report = await self._connection.query(component.id, query, expects=ReportSensorGeometricProperties)
        assert isinstance(report, ReportSensorGeometricProperties)
        for found in report.geometric_properties_list:
            place = found.geometric_properties_variant
            if isinstance(place, StaticGeometricPropertiesRec):
                x, y, z = place.sensor_position
                reported = Transform(rotation_from_quaternion(*place.unit_quaternion), (x, y, z))
                pose = (JAUS_FROM_REP_103 @ reported @ JAUS_FROM_REP_103).to_pose()
                return RobotPose(pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw)
        raise ConfigError(f"{component.id} does not report that its sensor {sensor} is fixed to the robot, and where")

    # --- inside ---------------------------------------------------------------------------------------------------

    async def _find(self) -> tuple[ComponentInfo, int]:
        """The component and the number of the sensor."""
        if self._found is None:
            self._found = await self._search()
        return self._found

    async def _search(self) -> tuple[ComponentInfo, int]:
        if not self._components:
            raise ConfigError(f"this robot has no lidar: it does not offer {RANGE_SENSOR}")
        sensors: list[tuple[ComponentInfo, int, str]] = []
        for component in self._components:
            kind = QueryRangeSensorCapabilities
            query = kind([kind.QueryRangeSensorCapabilitiesRec(kind.SensorID.ALL_SENSORS, 0)])
            report = await self._connection.query(component.id, query, expects=ReportRangeSensorCapabilities)
            assert isinstance(report, ReportRangeSensorCapabilities)
            sensors += [
                (component, int(found.sensor_id), found.sensor_name) for found in report.range_sensor_capabilities_list
            ]
        if not sensors:
            raise ConfigError(f"{self._components[0].id} reports no lidar")
        return choose_sensor(sensors, self.name, "lidar")


_NATIVE: Final = QueryRangeSensorData.ReportCoordinateSystem.NATIVE


def _reason(record: ReportRangeSensorData.RangeSensorDataErrorRec) -> str:
    return printable(record.error_message) or f"error code {int(record.data_error_code)}"


def _scan(record: ReportRangeSensorData.RangeSensorDataSeq) -> Scan:
    points = record.range_sensor_data_point_list
    return Scan(
        tuple(-point.bearing for point in points),
        tuple(math.inf if point.range_validity == 0 else point.range for point in points),
        tuple(point.inclination for point in points),
        datetime_of(record.range_sensor_data_rec.time_stamp, datetime.now(UTC)),
    )
