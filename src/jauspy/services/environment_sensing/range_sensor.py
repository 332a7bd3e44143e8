"""RangeSensor: what lidars measure, and their settings (AS6060)."""

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
from jauspy.services.environment_sensing.sensors import Mounted, geometric_properties, requested_sensors
from jauspy.services.messaging import requested_fields
from jauspy.services.service import Service
from jauspy.services.units import time_stamp

Wanted = SetRangeSensorConfiguration.RangeSensorConfigurationRec
State = SetRangeSensorConfiguration.SensorState
Code = RangeSensorErrorRec.RangeSensorErrorCode

RATE_STEP: Final = 1000.0 / 65535.0
"""Of a rate on the wire, in hertz: what a client sets to the limit may arrive just beyond it."""
RANGE_STEP: Final = 1e6 / (2**32 - 1)
"""Of a distance on the wire, in metres."""
FLAT: Final = 1e-6
"""Radians that count as zero, which lies between two steps on the wire."""


def settings(wanted: Wanted, present: ScanSettings) -> ScanSettings:
    """The settings with what is wanted; angles counted as in REP-103, so left and right change places."""
    start, stop = wanted.horizontal_field_of_view_start_angle, wanted.horizontal_field_of_view_stop_angle
    given: dict[str, Any] = {
        "start": None if stop is None else -stop,
        "stop": None if start is None else -start,
        "rate": wanted.update_rate,
        "least": wanted.minimum_range,
        "most": wanted.maximum_range,
        "active": None if wanted.sensor_state is None else wanted.sensor_state == State.ACTIVE,
    }
    return replace(present, **{name: value for name, value in given.items() if value is not None})


def refusal(wanted: Wanted, present: ScanSettings, setup: LidarSetup) -> RangeSensorErrorRec | None:
    """Why the sensor cannot be set so; None when it can."""
    wrong = _problems(wanted, settings(wanted, present), setup)
    if not wrong:
        return None
    code = wrong[0][0] if len(wrong) == 1 else Code.MULTIPLE_INVALID_PARAMETERS
    return RangeSensorErrorRec(wanted.sensor_id, code, "; ".join(text for _, text in wrong)[:255])


def _problems(wanted: Wanted, new: ScanSettings, setup: LidarSetup) -> list[tuple[Code, str]]:
    wrong = []
    if new.start >= new.stop:
        wrong.append((Code.INVALID_HORIZONTAL_FOV, "the first angle must be less than the last"))
    vertical = (wanted.vertical_field_of_view_start_angle, wanted.vertical_field_of_view_stop_angle)
    if any(angle is not None and abs(angle) > FLAT for angle in vertical):
        wrong.append((Code.INVALID_VERTICAL_FOV, "it scans in one plane; vertical angles are 0"))
    if not 0.0 < new.rate <= setup.rate + RATE_STEP:
        wrong.append((Code.INVALID_UPDATE_RATE, f"rates are more than 0 and at most {setup.rate:g} Hz"))
    if new.least < setup.least - RANGE_STEP or new.most > setup.most + RANGE_STEP or new.least >= new.most:
        wrong.append((Code.INVALID_SENSOR_RANGE, f"distances are within {setup.least:g}..{setup.most:g} m"))
    return wrong


Point = ReportRangeSensorData.RangeSensorDataPointRec

VALIDITY_BIT: Final = 1 << 1
"""Of a query's presence vector: it asks for RangeValidity."""

COUNT: Final = 2
"""Bytes of the count of a list of points."""

_Compression = QueryRangeSensorCompressedData.DataCompression
COMPRESS: Final[Mapping[int, Callable[[bytes], bytes]]] = {
    _Compression.NONE: bytes,
    _Compression.DEFLATE: zlib.compress,
    _Compression.BZIP2: bz2.compress,
    _Compression.LZMA: lambda data: lzma.compress(data, lzma.FORMAT_ALONE),
}
"""AS6060 names the methods and not the containers: these are zlib's (RFC 1950), .bz2 and .lzma."""


def points(scan: RangeScan, lidar: RangeFinder, asked: int, frame: Transform | None = None) -> list[Point]:
    """The rays that met something, and those that did not if the query asks which are valid.

    In the sensor's own frame, or, when its frame in the vehicle's is given, in the vehicle's; both with JAUS's axes.
    """
    tells_validity = bool(asked & VALIDITY_BIT)
    rays = enumerate(zip(scan.angles, scan.ranges, strict=True))
    found = [(number, ray) for number, ray in rays if tells_validity or math.isfinite(ray[1])]
    return [requested_fields(_point(number, ray, lidar, frame), asked) for number, ray in found]


def _point(number: int, ray: tuple[float, float], lidar: RangeFinder, frame: Transform | None) -> Point:
    angle, distance = ray
    limits = lidar.settings
    metres = min(limits.most, max(limits.least, distance))
    bearing, inclination = -angle, 0.0  # JAUS counts clockwise
    if frame is not None:
        metres, bearing, inclination = _polar(frame, metres, bearing)
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


def _polar(frame: Transform, distance: float, bearing: float) -> tuple[float, float, float]:
    x, y, z = frame.apply((distance * math.cos(bearing), distance * math.sin(bearing), 0.0))
    across = math.hypot(x, y)
    return math.hypot(across, z), math.atan2(y, x), math.atan2(-z, across)  # about y, which is right: up is positive


def data_rec(sensor: int, in_vehicle: bool, stamp: TimeStamp) -> ReportRangeSensorData.RangeSensorDataRec:
    """The head of a report."""
    return ReportRangeSensorData.RangeSensorDataRec(sensor, int(in_vehicle), stamp)


def encoded(found: list[Point], head: ReportRangeSensorData.RangeSensorDataRec) -> bytes:
    """The list of points alone, with its count, as it stands in a report that is not compressed."""
    empty, full = (
        ReportRangeSensorData([ReportRangeSensorData.RangeSensorDataSeq(head, each)]).encode() for each in ([], found)
    )
    return full[len(empty) - COUNT :]


_Compressed = ReportRangeSensorCompressedData
_Error = ReportRangeSensorData.DataErrorCode
_Capabilities = ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec
_Configuration = ReportRangeSensorConfiguration.RangeSensorConfigurationRec

PLANAR: Final = {"vertical_field_of_view_start_angle": 0.0, "vertical_field_of_view_stop_angle": 0.0}


class RangeSensor(Service, urn="urn:jaus:jss:environmentSensing:RangeSensor"):
    """The lidars of a vehicle; their ids count from 1 in the order they are given.

    Bearings are clockwise, inclinations positive upwards (JAUS's z is down). A ray without an echo is reported only
    when the query asks for RangeValidity: then with the largest distance, and not valid.
    """

    omits = frozenset(
        {
            "send_report_range_sensor_data_in_native_coordinate_system",
            "send_report_range_sensor_compressed_data_in_native_coordinate_system",
        }
    )

    def __init__(self, sensors: Sequence[Mounted]) -> None:
        self._sensors = dict(enumerate(sensors, start=1))
        self._states = dict.fromkeys(self._sensors, State.ACTIVE)
        self._stamps: dict[int, tuple[RangeScan, TimeStamp]] = {}

    def is_coordinate_tranform_supported(self) -> bool:
        """Every sensor's place on the vehicle is known."""
        return True

    # --- data

    def send_report_range_sensor_data_in_requested_coordinate_system(
        self, query: QueryRangeSensorData
    ) -> ReportRangeSensorData:
        """The last scan of each sensor that is asked for."""
        wanted = requested_sensors(query.query_range_sensor_data_list, self._sensors)
        return ReportRangeSensorData([self._data(sensor, record) for sensor, record in wanted])

    def send_report_range_sensor_compressed_data_in_requested_coordinate_system(
        self, query: QueryRangeSensorCompressedData
    ) -> ReportRangeSensorCompressedData:
        """The same, with the list of points compressed."""
        wanted = requested_sensors(query.query_range_sensor_compressed_data_list, self._sensors)
        return ReportRangeSensorCompressedData([self._compressed(sensor, record) for sensor, record in wanted])

    def _data(
        self, sensor: int, asked: Any
    ) -> ReportRangeSensorData.RangeSensorDataSeq | ReportRangeSensorData.RangeSensorDataErrorRec:
        found = self._found(sensor, asked)
        if isinstance(found, tuple):
            return ReportRangeSensorData.RangeSensorDataSeq(*found)
        return ReportRangeSensorData.RangeSensorDataErrorRec(sensor, *_described(found))

    def _compressed(
        self, sensor: int, asked: Any
    ) -> _Compressed.RangeSensorCompressedDataRec | _Compressed.RangeSensorDataErrorRec:
        method = asked.data_compression
        found = self._found(sensor, asked) if method in COMPRESS else _Error.INVALID_COMPRESSION_FORMAT
        if not isinstance(found, tuple):
            return _Compressed.RangeSensorDataErrorRec(sensor, *_described(found))
        head, measured = found
        data = COMPRESS[method](encoded(measured, head))
        return _Compressed.RangeSensorCompressedDataRec(
            sensor, head.report_coordinate_system, head.time_stamp, method, data
        )

    def _found(self, sensor: int, asked: Any) -> tuple[ReportRangeSensorData.RangeSensorDataRec, list[Point]] | _Error:
        """Head and points of a sensor's report, or why there is none."""
        mounted = self._sensors.get(sensor)
        if mounted is None:
            return _Error.UNKNOWN_ERROR
        lidar = mounted.lidar
        scan = lidar.scan
        if scan is None:
            return _Error.SENSOR_NOT_ACTIVE
        in_vehicle = asked.report_coordinate_system == ReportRangeSensorData.ReportCoordinateSystem.VEHICLE
        frame = mounted.in_vehicle if in_vehicle else None
        measured = points(scan, lidar, asked.query_presence_vector, frame)
        return data_rec(sensor, in_vehicle, self._stamp(sensor, scan, lidar.age)), measured

    def _stamp(self, sensor: int, scan: RangeScan, age: float) -> TimeStamp:
        """When a scan was made: always the same for the same scan, so that events on change tell of new ones."""
        known = self._stamps.get(sensor)
        if known is None or known[0] is not scan:
            known = self._stamps[sensor] = scan, time_stamp(self.host.utc_time - timedelta(seconds=age))
        return known[1]

    # --- what they are, and how they are set

    def send_report_range_sensor_capabilities(
        self, query: QueryRangeSensorCapabilities
    ) -> ReportRangeSensorCapabilities:
        """What each sensor can do."""
        wanted = requested_sensors(query.range_sensor_capabilities_list, self._sensors, known_only=True)
        return ReportRangeSensorCapabilities([self._capabilities(sensor) for sensor, _ in wanted])

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
            minimum_range=setup.least,
            maximum_range=setup.most,
            supported_compression=ReportRangeSensorCapabilities.SupportedCompression(1, 1, 1, 1),
            coordinate_transformation_supported=1,
        )

    def send_report_range_sensor_configuration(
        self, query: QueryRangeSensorConfiguration
    ) -> ReportRangeSensorConfiguration:
        """How each sensor is set."""
        wanted = requested_sensors(query.range_sensor_configuration_list, self._sensors, known_only=True)
        return ReportRangeSensorConfiguration([self._configuration(sensor) for sensor, _ in wanted])

    def _configuration(self, sensor: int) -> _Configuration:
        now = self._sensors[sensor].lidar.settings
        return _Configuration(
            sensor,
            horizontal_field_of_view_start_angle=-now.stop,
            horizontal_field_of_view_stop_angle=-now.start,
            **PLANAR,
            update_rate=now.rate,
            minimum_range=now.least,
            maximum_range=now.most,
            sensor_state=self._states[sensor],
        )

    def send_report_sensor_geometric_properties(
        self, query: QuerySensorGeometricProperties
    ) -> ReportSensorGeometricProperties:
        """Where each sensor is on the vehicle."""
        wanted = requested_sensors(query.sensor_id_list, self._sensors, known_only=True)
        return ReportSensorGeometricProperties(
            [geometric_properties(sensor, self._sensors[sensor]) for sensor, _ in wanted]
        )

    # --- settings

    def send_confirm_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> ConfirmSensorConfiguration:
        """For each sensor that it is set, or why not."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = requested_sensors(msg.range_sensor_configuration_list, self._sensors)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def update_range_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> None:
        """Set those that can be set so; a setting that is left out stays."""
        for sensor, record in requested_sensors(msg.range_sensor_configuration_list, self._sensors, known_only=True):
            if self._refusal(sensor, record) is None:
                lidar = self._sensors[sensor].lidar
                lidar.configure(settings(record, lidar.settings))
                if record.sensor_state is not None:
                    self._states[sensor] = State(record.sensor_state)

    def _refusal(self, sensor: int, record: Wanted) -> RangeSensorErrorRec | None:
        mounted = self._sensors.get(sensor)
        if mounted is None:
            known = ", ".join(map(str, self._sensors))
            return RangeSensorErrorRec(
                sensor, Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}; there are: {known}"
            )
        refused = refusal(record, mounted.lidar.settings, mounted.lidar.setup)
        return None if refused is None else replace(refused, sensor_id=sensor)


def _described(code: _Error) -> tuple[_Error, str]:
    return code, _REASONS[code]


_REASONS: Final = {
    _Error.SENSOR_NOT_ACTIVE: "the sensor is in standby, off, or has just been started",
    _Error.INVALID_COMPRESSION_FORMAT: "the sensor does not have this compression",
    _Error.UNKNOWN_ERROR: "there is no sensor of this id",
}
