"""RangeSensor: what lidars measure, and their settings (AS6060)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import timedelta
from typing import Any, Final

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
from jauspy.platform.ranging import RangeScan
from jauspy.services.environment_sensing.mounting import Mounted, geometric_properties
from jauspy.services.environment_sensing.points import COMPRESS, Point, data_rec, encoded, points
from jauspy.services.environment_sensing.range_settings import Code, State, Wanted, refusal, settings
from jauspy.services.environment_sensing.wanted import chosen
from jauspy.services.service import Service
from jauspy.services.units import time_stamp

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
        wanted = chosen(query.query_range_sensor_data_list, self._sensors)
        return ReportRangeSensorData([self._data(sensor, record) for sensor, record in wanted])

    def send_report_range_sensor_compressed_data_in_requested_coordinate_system(
        self, query: QueryRangeSensorCompressedData
    ) -> ReportRangeSensorCompressedData:
        """The same, with the list of points compressed."""
        wanted = chosen(query.query_range_sensor_compressed_data_list, self._sensors)
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
        wanted = chosen(query.range_sensor_capabilities_list, self._sensors, known_only=True)
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
        wanted = chosen(query.range_sensor_configuration_list, self._sensors, known_only=True)
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
        wanted = chosen(query.sensor_id_list, self._sensors, known_only=True)
        return ReportSensorGeometricProperties(
            [geometric_properties(sensor, self._sensors[sensor]) for sensor, _ in wanted]
        )

    # --- settings

    def send_confirm_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> ConfirmSensorConfiguration:
        """For each sensor that it is set, or why not."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = chosen(msg.range_sensor_configuration_list, self._sensors)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def update_range_sensor_configuration(self, msg: SetRangeSensorConfiguration) -> None:
        """Set those that can be set so; a setting that is left out stays."""
        for sensor, record in chosen(msg.range_sensor_configuration_list, self._sensors, known_only=True):
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
