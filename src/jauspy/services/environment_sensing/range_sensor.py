"""RangeSensor: scans of lidars, and their settings (AS6060)."""

from __future__ import annotations

import bz2
import lzma
import math
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from datetime import timedelta
from typing import Any, Final

from jauspy.geometry.poses import Transform
from jauspy.messages.core import TimeStamp
from jauspy.messages.environment_sensing.v1_0.types import RangeSensorErrorRec, SensorIdRec
from jauspy.messages.environment_sensing.v2_0.range_sensor import (
    ConfirmSensorConfiguration,
    QueryRangeSensorCapabilities,
    QueryRangeSensorCompressedData,
    QueryRangeSensorConfiguration,
    QueryRangeSensorData,
    QuerySensorGeometricProperties,
    ReportRangeSensorCapabilities,
    ReportRangeSensorCompressedData,
    ReportRangeSensorConfiguration,
    ReportRangeSensorData,
    ReportSensorGeometricProperties,
    SetRangeSensorConfiguration,
)
from jauspy.platform.ranging import LidarSetup, RangeFinder, RangeScan, ScanSettings
from jauspy.services.environment_sensing.sensors import MountedLidar, geometric_properties, requested_sensors
from jauspy.services.presence_vectors import requested_fields
from jauspy.services.service import Service
from jauspy.services.units import time_stamp

RequestedSettings = SetRangeSensorConfiguration.RangeSensorConfigurationRec

State = SetRangeSensorConfiguration.SensorState

Code = RangeSensorErrorRec.RangeSensorErrorCode

Point = ReportRangeSensorData.RangeSensorDataPointRec

_Compression = QueryRangeSensorCompressedData.DataCompression

_Compressed = ReportRangeSensorCompressedData

_Error = ReportRangeSensorData.DataErrorCode

_Capabilities = ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec

_Configuration = ReportRangeSensorConfiguration.RangeSensorConfigurationRec

RATE_STEP: Final = 1000.0 / 65535.0
"""Resolution of a rate on the wire, in hertz; a rate set to the limit may arrive that much above it."""

RANGE_STEP: Final = 1e6 / (2**32 - 1)
"""Resolution of a distance on the wire, in metres."""

ZERO_ANGLE: Final = 1e-6
"""Largest angle, in radians, that is zero: on the wire, zero lies between two steps."""

VALIDITY_BIT: Final = 1 << 1
"""Bit of a query's presence vector that requests RangeValidity."""

POINT_COUNT_SIZE: Final = 2
"""Bytes of the count of a list of points."""

COMPRESS: Final[Mapping[int, Callable[[bytes], bytes]]] = {
    _Compression.NONE: bytes,
    _Compression.DEFLATE: zlib.compress,
    _Compression.BZIP2: bz2.compress,
    _Compression.LZMA: lambda data: lzma.compress(data, lzma.FORMAT_ALONE),
}
"""AS6060 names the methods and not the containers: these are zlib's (RFC 1950), .bz2 and .lzma."""

PLANAR: Final = {"vertical_field_of_view_start_angle": 0.0, "vertical_field_of_view_stop_angle": 0.0}

_ERROR_TEXTS: Final = {
    _Error.SENSOR_NOT_ACTIVE: "the sensor is in standby, off, or has just been started",
    _Error.INVALID_COMPRESSION_FORMAT: "the sensor does not have this compression",
    _Error.UNKNOWN_ERROR: "there is no sensor of this id",
}


class RangeSensor(Service, urn="urn:jaus:jss:environmentSensing:RangeSensor"):
    """The lidars of a vehicle; their ids count from 1 in the order they are given.

    Of a lidar of several layers, the one that is nearest to the horizontal is reported.

    Bearings are clockwise, inclinations positive upwards (JAUS's z is down). A ray without an echo is reported only
    when the query asks for RangeValidity: then with the largest distance, and not valid.
    """

    omits = frozenset(
        {
            "send_report_range_sensor_data_in_native_coordinate_system",
            "send_report_range_sensor_compressed_data_in_native_coordinate_system",
        }
    )

    def __init__(self, sensors: Sequence[MountedLidar]) -> None:
        self._sensors = dict(enumerate(sensors, start=1))
        self._states = dict.fromkeys(self._sensors, State.ACTIVE)
        self._stamps: dict[int, tuple[RangeScan, TimeStamp]] = {}

    def is_coordinate_tranform_supported(self) -> bool:
        """Return True: points can be reported in the vehicle's frame."""
        return True

    def send_report_range_sensor_data_in_requested_coordinate_system(
        self, query: QueryRangeSensorData
    ) -> ReportRangeSensorData:
        """Return the last scan of each requested sensor."""
        requested = requested_sensors(query.query_range_sensor_data_list, self._sensors)
        return ReportRangeSensorData([self._data(sensor, record) for sensor, record in requested])

    def send_report_range_sensor_compressed_data_in_requested_coordinate_system(
        self, query: QueryRangeSensorCompressedData
    ) -> ReportRangeSensorCompressedData:
        """Return the last scan of each requested sensor, with compressed points."""
        requested = requested_sensors(query.query_range_sensor_compressed_data_list, self._sensors)
        return ReportRangeSensorCompressedData([self._compressed(sensor, record) for sensor, record in requested])

    def _data(
        self, sensor: int, record: Any
    ) -> ReportRangeSensorData.RangeSensorDataSeq | ReportRangeSensorData.RangeSensorDataErrorRec:
        found = self._scan(sensor, record)
        if isinstance(found, tuple):
            return ReportRangeSensorData.RangeSensorDataSeq(*found)
        return ReportRangeSensorData.RangeSensorDataErrorRec(sensor, *_with_text(found))

    def _compressed(
        self, sensor: int, record: Any
    ) -> _Compressed.RangeSensorCompressedDataRec | _Compressed.RangeSensorDataErrorRec:
        method = record.data_compression
        found = self._scan(sensor, record) if method in COMPRESS else _Error.INVALID_COMPRESSION_FORMAT
        if not isinstance(found, tuple):
            return _Compressed.RangeSensorDataErrorRec(sensor, *_with_text(found))
        head, measured = found
        data = COMPRESS[method](encoded(measured, head))
        return _Compressed.RangeSensorCompressedDataRec(
            sensor, head.report_coordinate_system, head.time_stamp, method, data
        )

    def _scan(self, sensor: int, record: Any) -> tuple[ReportRangeSensorData.RangeSensorDataRec, list[Point]] | _Error:
        """Return the record and the points of a sensor's last scan, or an error code."""
        mounted = self._sensors.get(sensor)
        if mounted is None:
            return _Error.UNKNOWN_ERROR
        lidar = mounted.lidar
        scan = lidar.scan
        if scan is None:
            return _Error.SENSOR_NOT_ACTIVE
        in_vehicle = record.report_coordinate_system == ReportRangeSensorData.ReportCoordinateSystem.VEHICLE
        frame = mounted.in_vehicle if in_vehicle else None
        measured = points(scan, lidar, record.query_presence_vector, frame)
        return data_rec(sensor, in_vehicle, self._stamp(sensor, scan, lidar.age)), measured

    def _stamp(self, sensor: int, scan: RangeScan, age: float) -> TimeStamp:
        """Return when a scan was made; the stamp of a scan never changes, so events on change report new scans only."""
        known = self._stamps.get(sensor)
        if known is None or known[0] is not scan:
            known = self._stamps[sensor] = scan, time_stamp(self.host.utc_time - timedelta(seconds=age))
        return known[1]

    def send_report_range_sensor_capabilities(
        self, query: QueryRangeSensorCapabilities
    ) -> ReportRangeSensorCapabilities:
        """Return the limits of each sensor (rad, Hz, m)."""
        requested = requested_sensors(query.range_sensor_capabilities_list, self._sensors, known_only=True)
        return ReportRangeSensorCapabilities([self._capabilities(sensor) for sensor, _ in requested])

    def _capabilities(self, sensor: int) -> _Capabilities:
        setup = self._sensors[sensor].lidar.setup
        whole = setup.settings()
        return _Capabilities(
            sensor,
            setup.name,
            supported_states=ReportRangeSensorCapabilities.SupportedStates(1, 1, 1),
            minimum_horizontal_field_of_view_start_angle=-whole.stop,
            maximum_horizontal_field_of_view_stop_angle=-whole.start,
            minimum_vertical_field_of_view_start_angle=0.0,
            maximum_vertical_field_of_view_stop_angle=0.0,
            miniumum_update_rate=0.0,
            maximum_update_rate=setup.rate,
            minimum_range=setup.min_range,
            maximum_range=setup.max_range,
            supported_compression=ReportRangeSensorCapabilities.SupportedCompression(1, 1, 1, 1),
            coordinate_transformation_supported=1,
        )

    def send_report_range_sensor_configuration(
        self, query: QueryRangeSensorConfiguration
    ) -> ReportRangeSensorConfiguration:
        """Return the settings of each sensor (rad, Hz, m)."""
        requested = requested_sensors(query.range_sensor_configuration_list, self._sensors, known_only=True)
        return ReportRangeSensorConfiguration([self._configuration(sensor) for sensor, _ in requested])

    def _configuration(self, sensor: int) -> _Configuration:
        now = self._sensors[sensor].lidar.settings
        return _Configuration(
            sensor,
            horizontal_field_of_view_start_angle=-now.stop,
            horizontal_field_of_view_stop_angle=-now.start,
            **PLANAR,
            update_rate=now.rate,
            minimum_range=now.min_range,
            maximum_range=now.max_range,
            sensor_state=self._states[sensor],
        )

    def send_report_sensor_geometric_properties(
        self, query: QuerySensorGeometricProperties
    ) -> ReportSensorGeometricProperties:
        """Return the mounting of each sensor."""
        requested = requested_sensors(query.sensor_id_list, self._sensors, known_only=True)
        return ReportSensorGeometricProperties(
            [geometric_properties(sensor, self._sensors[sensor]) for sensor, _ in requested]
        )

    def send_confirm_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> ConfirmSensorConfiguration:
        """Return for each sensor its id, or an error record with the reason."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = requested_sensors(msg.range_sensor_configuration_list, self._sensors)
        return ConfirmSensorConfiguration(
            request, [self._refusal(*request) or SensorIdRec(request[0]) for request in requested]
        )

    def update_range_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> None:
        """Apply valid settings; omitted settings keep their values."""
        for sensor, record in requested_sensors(msg.range_sensor_configuration_list, self._sensors, known_only=True):
            if self._refusal(sensor, record) is None:
                lidar = self._sensors[sensor].lidar
                lidar.configure(apply_settings(record, lidar.settings))
                if record.sensor_state is not None:
                    self._states[sensor] = State(record.sensor_state)

    def _refusal(self, sensor: int, record: RequestedSettings) -> RangeSensorErrorRec | None:
        mounted = self._sensors.get(sensor)
        if mounted is None:
            known = ", ".join(map(str, self._sensors))
            return RangeSensorErrorRec(
                sensor, Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}; there are: {known}"
            )
        refused = refusal(record, mounted.lidar.settings, mounted.lidar.setup)
        return None if refused is None else replace(refused, sensor_id=sensor)


def points(scan: RangeScan, lidar: RangeFinder, presence_vector: int, frame: Transform | None = None) -> list[Point]:
    """Return the rays with an echo, and all rays if the presence vector requests RangeValidity.

    Points are in the sensor's frame, or in the vehicle's if `frame`, the sensor's frame in it, is given; both with
    JAUS's axes.
    """
    with_validity = bool(presence_vector & VALIDITY_BIT)
    rays = enumerate(zip(scan.angles, scan.ranges, strict=True))
    found = [(number, ray) for number, ray in rays if with_validity or math.isfinite(ray[1])]
    up = scan.inclination
    return [requested_fields(_point(number, ray, up, lidar, frame), presence_vector) for number, ray in found]


def _point(
    number: int, ray: tuple[float, float], inclination: float, lidar: RangeFinder, frame: Transform | None
) -> Point:
    angle, distance = ray
    limits = lidar.settings
    metres = min(limits.max_range, max(limits.min_range, distance))
    bearing = -angle  # JAUS counts clockwise
    if frame is not None:
        metres, bearing, inclination = _polar(frame, metres, bearing, inclination)
    return Point(
        point_id=number,
        range=metres,
        range_validity=int(math.isfinite(distance)),
        range_error_rms=lidar.setup.noise,
        bearing=bearing,
        bearing_validity=1,
        bearing_error_rms=0.0,
        inclination=inclination,
        inclination_validity=1,
        inclination_error_rms=0.0,
    )


def _polar(frame: Transform, distance: float, bearing: float, inclination: float) -> tuple[float, float, float]:
    level, down = distance * math.cos(inclination), -distance * math.sin(inclination)
    x, y, z = frame.apply((level * math.cos(bearing), level * math.sin(bearing), down))
    horizontal = math.hypot(x, y)
    return (
        math.hypot(horizontal, z),
        math.atan2(y, x),
        math.atan2(-z, horizontal),
    )  # about y, which is right: up is positive


def data_rec(sensor: int, in_vehicle: bool, stamp: TimeStamp) -> ReportRangeSensorData.RangeSensorDataRec:
    """Return the record that precedes the points of a sensor."""
    return ReportRangeSensorData.RangeSensorDataRec(sensor, int(in_vehicle), stamp)


def encoded(found: list[Point], head: ReportRangeSensorData.RangeSensorDataRec) -> bytes:
    """Return the count and the points, encoded as in a report without compression."""
    empty, full = (
        ReportRangeSensorData([ReportRangeSensorData.RangeSensorDataSeq(head, readings)]).encode()
        for readings in ([], found)
    )
    return full[len(empty) - POINT_COUNT_SIZE :]


def _with_text(code: _Error) -> tuple[_Error, str]:
    return code, _ERROR_TEXTS[code]


def apply_settings(requested: RequestedSettings, present: ScanSettings) -> ScanSettings:
    """Return the present settings with the requested changes; REP-103 counts angles the other way round."""
    start, stop = requested.horizontal_field_of_view_start_angle, requested.horizontal_field_of_view_stop_angle
    given: dict[str, Any] = {
        "start": None if stop is None else -stop,
        "stop": None if start is None else -start,
        "rate": requested.update_rate,
        "min_range": requested.minimum_range,
        "max_range": requested.maximum_range,
        "active": None if requested.sensor_state is None else requested.sensor_state == State.ACTIVE,
    }
    return replace(present, **{name: value for name, value in given.items() if value is not None})


def refusal(requested: RequestedSettings, present: ScanSettings, setup: LidarSetup) -> RangeSensorErrorRec | None:
    """Return an error record with the reasons; None if the settings are valid."""
    problems = _find_problems(requested, apply_settings(requested, present), setup)
    if not problems:
        return None
    code = problems[0][0] if len(problems) == 1 else Code.MULTIPLE_INVALID_PARAMETERS
    return RangeSensorErrorRec(requested.sensor_id, code, "; ".join(text for _, text in problems)[:255])


def _find_problems(requested: RequestedSettings, new: ScanSettings, setup: LidarSetup) -> list[tuple[Code, str]]:
    problems = []
    if new.start >= new.stop:
        problems.append((Code.INVALID_HORIZONTAL_FOV, "the first angle must be less than the last"))
    vertical = (requested.vertical_field_of_view_start_angle, requested.vertical_field_of_view_stop_angle)
    if any(angle is not None and abs(angle) > ZERO_ANGLE for angle in vertical):
        problems.append((Code.INVALID_VERTICAL_FOV, "it scans in one plane; vertical angles are 0"))
    if not 0.0 < new.rate <= setup.rate + RATE_STEP:
        problems.append((Code.INVALID_UPDATE_RATE, f"rates are more than 0 and at most {setup.rate:g} Hz"))
    if (
        new.min_range < setup.min_range - RANGE_STEP
        or new.max_range > setup.max_range + RANGE_STEP
        or new.min_range >= new.max_range
    ):
        problems.append((Code.INVALID_SENSOR_RANGE, f"distances are within {setup.min_range:g}..{setup.max_range:g} m"))
    return problems
