"""urn:jaus:jss:environmentSensing:RangeSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output


@dataclass(slots=True, repr=False)
class SetRangeSensorConfiguration(rt.Message):
    """SetRangeSensorConfiguration (0x0802): Sets the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """

    CODE = 0x0802
    NAME = "SetRangeSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RequestIdRec(rt.Struct):
        """RequestIdRec.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    class SensorState(IntEnum):
        """Values of SensorState."""

        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    @dataclass(slots=True, repr=False)
    class RangeSensorConfigurationRec(rt.Struct):
        """Settings of one sensor.

        sensor_id: 1..65535. Identifies the sensor
        horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from left to right, in radians
        horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from left to right, in radians
        vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from top to bottom, in radians
        vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from top to bottom, in radians
        update_rate: 0..1000 hertz, optional. Rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        sensor_state: SensorState, optional. Whether the sensor works
        """

        sensor_id: int
        horizontal_field_of_view_start_angle: float | None = None
        horizontal_field_of_view_stop_angle: float | None = None
        vertical_field_of_view_start_angle: float | None = None
        vertical_field_of_view_stop_angle: float | None = None
        update_rate: float | None = None
        minimum_range: float | None = None
        maximum_range: float | None = None
        sensor_state: SetRangeSensorConfiguration.SensorState | int | None = None

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("HorizontalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("HorizontalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("UpdateRate", rt.real("H", 0.0, 1000.0, "hertz"), True),
                ("MinimumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("MaximumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("SensorState", rt.Number("B", rt.Values(SetRangeSensorConfiguration.SensorState)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetRangeSensorConfiguration_RangeSensorConfigurationRec_0[mask & 0xFF]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.horizontal_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 1 else None
            self.horizontal_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 2 else None
            self.vertical_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 4 else None
            self.vertical_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 8 else None
            self.update_rate = raw() * 0.015259021896696421 if mask & 16 else None
            self.minimum_range = raw() * 0.00023283064370807974 if mask & 32 else None
            self.maximum_range = raw() * 0.00023283064370807974 if mask & 64 else None
            if mask & 128:
                sensor_state_ = raw()
                self.sensor_state = _E_SetRangeSensorConfiguration_SensorState[sensor_state_]
            else: self.sensor_state = None
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = 0
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            horizontal_field_of_view_start_angle_ = self.horizontal_field_of_view_start_angle
            if horizontal_field_of_view_start_angle_ is not None:
                mask |= 1
                if not -3.141592653589793 <= horizontal_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_start_angle_raw_ < 0.9999847412109375: horizontal_field_of_view_start_angle_raw_ = rt.exact_raw(horizontal_field_of_view_start_angle_, _R_2)
                raw.append(horizontal_field_of_view_start_angle_raw_)
            horizontal_field_of_view_stop_angle_ = self.horizontal_field_of_view_stop_angle
            if horizontal_field_of_view_stop_angle_ is not None:
                mask |= 2
                if not -3.141592653589793 <= horizontal_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_stop_angle_raw_ < 0.9999847412109375: horizontal_field_of_view_stop_angle_raw_ = rt.exact_raw(horizontal_field_of_view_stop_angle_, _R_2)
                raw.append(horizontal_field_of_view_stop_angle_raw_)
            vertical_field_of_view_start_angle_ = self.vertical_field_of_view_start_angle
            if vertical_field_of_view_start_angle_ is not None:
                mask |= 4
                if not -3.141592653589793 <= vertical_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_start_angle_raw_ < 0.9999847412109375: vertical_field_of_view_start_angle_raw_ = rt.exact_raw(vertical_field_of_view_start_angle_, _R_2)
                raw.append(vertical_field_of_view_start_angle_raw_)
            vertical_field_of_view_stop_angle_ = self.vertical_field_of_view_stop_angle
            if vertical_field_of_view_stop_angle_ is not None:
                mask |= 8
                if not -3.141592653589793 <= vertical_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_stop_angle_raw_ < 0.9999847412109375: vertical_field_of_view_stop_angle_raw_ = rt.exact_raw(vertical_field_of_view_stop_angle_, _R_2)
                raw.append(vertical_field_of_view_stop_angle_raw_)
            update_rate_ = self.update_rate
            if update_rate_ is not None:
                mask |= 16
                if not 0.0 <= update_rate_ <= 1000.0: raise rt.Reject
                near = update_rate_ * 65.535 + 0.5
                update_rate_raw_ = int(near)
                if not 1.52587890625e-05 < near - update_rate_raw_ < 0.9999847412109375: update_rate_raw_ = rt.exact_raw(update_rate_, _R_3)
                raw.append(update_rate_raw_)
            minimum_range_ = self.minimum_range
            if minimum_range_ is not None:
                mask |= 32
                if not 0.0 <= minimum_range_ <= 1000000.0: raise rt.Reject
                near = minimum_range_ * 4294.967295 + 0.5
                minimum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_range_raw_ < 0.9999847412109375: minimum_range_raw_ = rt.exact_raw(minimum_range_, _R_4)
                raw.append(minimum_range_raw_)
            maximum_range_ = self.maximum_range
            if maximum_range_ is not None:
                mask |= 64
                if not 0.0 <= maximum_range_ <= 1000000.0: raise rt.Reject
                near = maximum_range_ * 4294.967295 + 0.5
                maximum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_range_raw_ < 0.9999847412109375: maximum_range_raw_ = rt.exact_raw(maximum_range_, _R_4)
                raw.append(maximum_range_raw_)
            sensor_state_ = self.sensor_state
            if sensor_state_ is not None:
                mask |= 128
                if sensor_state_ not in _E_SetRangeSensorConfiguration_SensorState: raise rt.Reject
                raw.append(sensor_state_)
            out += _M_SetRangeSensorConfiguration_RangeSensorConfigurationRec_0[mask & 0xFF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetRangeSensorConfiguration.RequestIdRec
    range_sensor_configuration_list: list[SetRangeSensorConfiguration.RangeSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetRangeSensorConfiguration.RequestIdRec.layout()),
            ("RangeSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), SetRangeSensorConfiguration.RangeSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetRangeSensorConfiguration.RequestIdRec(request_id_)
        (range_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 3)
        if range_sensor_configuration_list_count_ * 3 > size - 5: raise rt.Reject
        at = 5
        range_sensor_configuration_list_ = []
        for _ in range(range_sensor_configuration_list_count_):
            item_, at = SetRangeSensorConfiguration.RangeSensorConfigurationRec._read(data, at, nesting)
            range_sensor_configuration_list_.append(item_)
        self.range_sensor_configuration_list = range_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetRangeSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        range_sensor_configuration_list_ = self.range_sensor_configuration_list
        if type(range_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_configuration_list_))
        for item_ in range_sensor_configuration_list_:
            if type(item_) is not SetRangeSensorConfiguration.RangeSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QuerySensorGeometricProperties(rt.Message):
    """QuerySensorGeometricProperties (0x2805): Asks where sensors are mounted.

    sensor_id_list: 0..65535 items. The sensors
    """

    CODE = 0x2805
    NAME = "QuerySensorGeometricProperties"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportSensorGeometricProperties]]

    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec

    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorIdList", rt.Repeat(rt.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x05 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (sensor_id_list_count_,) = _S_H.unpack_from(data, 2)
        sensor_id_list_end_ = 4 + sensor_id_list_count_ * 2
        self.sensor_id_list = [environment_sensing_v1_0_types.SensorIDQueryRec(_E_SensorIDQueryRec_SensorID.get(sensor_id_, sensor_id_)) for sensor_id_ in _L_H[sensor_id_list_count_].unpack_from(data, 4)]
        if sensor_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x05\x28")
        sensor_id_list_ = self.sensor_id_list
        if type(sensor_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(sensor_id_list_))
        raw_: list[int | float] = []
        for item_ in sensor_id_list_:
            if type(item_) is not environment_sensing_v1_0_types.SensorIDQueryRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryRangeSensorCompressedData(rt.Message):
    """QueryRangeSensorCompressedData (0x2804): Asks for measurements of range in a compressed form.

    query_range_sensor_compressed_data_list: 0..65535 items. The sensors
    """

    CODE = 0x2804
    NAME = "QueryRangeSensorCompressedData"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportRangeSensorCompressedData]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    class DataCompression(IntEnum):
        """Values of DataCompression."""

        NONE = 0
        DEFLATE = 1
        BZIP2 = 2
        LZMA = 3

    @dataclass(slots=True, repr=False)
    class QueryRangeSensorCompressedDataRec(rt.Struct):
        """QueryRangeSensorCompressedDataRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        data_compression: DataCompression. Kind of compression
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryRangeSensorCompressedData.SensorID | int
        report_coordinate_system: QueryRangeSensorCompressedData.ReportCoordinateSystem | int
        data_compression: QueryRangeSensorCompressedData.DataCompression | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryRangeSensorCompressedData.SensorID, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(QueryRangeSensorCompressedData.ReportCoordinateSystem))),
                ("DataCompression", rt.Number("B", rt.Values(QueryRangeSensorCompressedData.DataCompression))),
                ("QueryPresenceVector", rt.Number("H")),
            )

    query_range_sensor_compressed_data_list: list[QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryRangeSensorCompressedDataList", rt.Repeat(rt.Count("H", 0, 65535), QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_range_sensor_compressed_data_list_count_,) = _S_H.unpack_from(data, 2)
        query_range_sensor_compressed_data_list_end_ = 4 + query_range_sensor_compressed_data_list_count_ * 6
        self.query_range_sensor_compressed_data_list = [QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec(_E_QueryRangeSensorCompressedData_SensorID.get(sensor_id_, sensor_id_), _E_QueryRangeSensorCompressedData_ReportCoordinateSystem[report_coordinate_system_], _E_QueryRangeSensorCompressedData_DataCompression[data_compression_], query_presence_vector_) for sensor_id_, report_coordinate_system_, data_compression_, query_presence_vector_ in _S_H2BH.iter_unpack(data[4:query_range_sensor_compressed_data_list_end_])]
        if query_range_sensor_compressed_data_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x28")
        query_range_sensor_compressed_data_list_ = self.query_range_sensor_compressed_data_list
        if type(query_range_sensor_compressed_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_range_sensor_compressed_data_list_))
        for item_ in query_range_sensor_compressed_data_list_:
            if type(item_) is not QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec: raise rt.Reject
            report_coordinate_system_ = item_.report_coordinate_system
            if report_coordinate_system_ not in _E_QueryRangeSensorCompressedData_ReportCoordinateSystem: raise rt.Reject
            data_compression_ = item_.data_compression
            if data_compression_ not in _E_QueryRangeSensorCompressedData_DataCompression: raise rt.Reject
            out += _S_H2BH.pack(item_.sensor_id, report_coordinate_system_, data_compression_, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryRangeSensorData(rt.Message):
    """QueryRangeSensorData (0x2803): Asks for measurements of range.

    query_range_sensor_data_list: 0..65535 items. The sensors
    """

    CODE = 0x2803
    NAME = "QueryRangeSensorData"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportRangeSensorData]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    @dataclass(slots=True, repr=False)
    class QueryRangeSensorDataRec(rt.Struct):
        """QueryRangeSensorDataRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryRangeSensorData.SensorID | int
        report_coordinate_system: QueryRangeSensorData.ReportCoordinateSystem | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryRangeSensorData.SensorID, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(QueryRangeSensorData.ReportCoordinateSystem))),
                ("QueryPresenceVector", rt.Number("H")),
            )

    query_range_sensor_data_list: list[QueryRangeSensorData.QueryRangeSensorDataRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryRangeSensorDataList", rt.Repeat(rt.Count("H", 0, 65535), QueryRangeSensorData.QueryRangeSensorDataRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_range_sensor_data_list_count_,) = _S_H.unpack_from(data, 2)
        query_range_sensor_data_list_end_ = 4 + query_range_sensor_data_list_count_ * 5
        self.query_range_sensor_data_list = [QueryRangeSensorData.QueryRangeSensorDataRec(_E_QueryRangeSensorData_SensorID.get(sensor_id_, sensor_id_), _E_QueryRangeSensorData_ReportCoordinateSystem[report_coordinate_system_], query_presence_vector_) for sensor_id_, report_coordinate_system_, query_presence_vector_ in _S_HBH.iter_unpack(data[4:query_range_sensor_data_list_end_])]
        if query_range_sensor_data_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x28")
        query_range_sensor_data_list_ = self.query_range_sensor_data_list
        if type(query_range_sensor_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_range_sensor_data_list_))
        for item_ in query_range_sensor_data_list_:
            if type(item_) is not QueryRangeSensorData.QueryRangeSensorDataRec: raise rt.Reject
            report_coordinate_system_ = item_.report_coordinate_system
            if report_coordinate_system_ not in _E_QueryRangeSensorData_ReportCoordinateSystem: raise rt.Reject
            out += _S_HBH.pack(item_.sensor_id, report_coordinate_system_, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryRangeSensorCapabilities(rt.Message):
    """QueryRangeSensorCapabilities (0x2801): Asks what range sensors can do.

    range_sensor_capabilities_list: 0..65535 items. The sensors
    """

    CODE = 0x2801
    NAME = "QueryRangeSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportRangeSensorCapabilities]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryRangeSensorCapabilitiesRec(rt.Struct):
        """QueryRangeSensorCapabilitiesRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryRangeSensorCapabilities.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryRangeSensorCapabilities.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("H")),
            )

    range_sensor_capabilities_list: list[QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        range_sensor_capabilities_list_end_ = 4 + range_sensor_capabilities_list_count_ * 4
        self.range_sensor_capabilities_list = [QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec(_E_QueryRangeSensorCapabilities_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_2H.iter_unpack(data[4:range_sensor_capabilities_list_end_])]
        if range_sensor_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x28")
        range_sensor_capabilities_list_ = self.range_sensor_capabilities_list
        if type(range_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_capabilities_list_))
        raw_: list[int | float] = []
        for item_ in range_sensor_capabilities_list_:
            if type(item_) is not QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec: raise rt.Reject
            raw_ += (item_.sensor_id, item_.query_presence_vector)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryRangeSensorConfiguration(rt.Message):
    """QueryRangeSensorConfiguration (0x2802): Asks for the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """

    CODE = 0x2802
    NAME = "QueryRangeSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportRangeSensorConfiguration]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryRangeSensorConfigurationRec(rt.Struct):
        """QueryRangeSensorConfigurationRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryRangeSensorConfiguration.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryRangeSensorConfiguration.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("H")),
            )

    range_sensor_configuration_list: list[QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        range_sensor_configuration_list_end_ = 4 + range_sensor_configuration_list_count_ * 4
        self.range_sensor_configuration_list = [QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec(_E_QueryRangeSensorConfiguration_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_2H.iter_unpack(data[4:range_sensor_configuration_list_end_])]
        if range_sensor_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x28")
        range_sensor_configuration_list_ = self.range_sensor_configuration_list
        if type(range_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_configuration_list_))
        raw_: list[int | float] = []
        for item_ in range_sensor_configuration_list_:
            if type(item_) is not QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec: raise rt.Reject
            raw_ += (item_.sensor_id, item_.query_presence_vector)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"


@dataclass(slots=True, repr=False)
class ReportRangeSensorCapabilities(rt.Message):
    """ReportRangeSensorCapabilities (0x4801): Tells what range sensors can do.

    range_sensor_capabilities_list: 0..65535 items. The sensors
    """

    CODE = 0x4801
    NAME = "ReportRangeSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedStates = environment_sensing_v1_0_types.SupportedStates
    SupportedCompression = environment_sensing_v1_0_types.SupportedCompression

    class CoordinateTransformationSupported(IntEnum):
        """Values of CoordinateTransformationSupported."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False)
    class RangeSensorCapabilitiesRec(rt.Struct):
        """RangeSensorCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        supported_states: optional. States that the sensor offers
        minimum_horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the first angle from left to right, in radians
        maximum_horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the last angle from left to right, in radians
        minimum_vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the first angle from top to bottom, in radians
        maximum_vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the last angle from top to bottom, in radians
        miniumum_update_rate: 0..1000 hertz, optional. Smallest rate of measurement, in hertz
        maximum_update_rate: 0..1000 hertz, optional. Largest rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        supported_compression: optional. Kinds of compression that the sensor offers
        coordinate_transformation_supported: CoordinateTransformationSupported, optional. Whether the sensor can report in the frame of the vehicle
        """

        sensor_id: int
        sensor_name: str
        supported_states: environment_sensing_v1_0_types.SupportedStates | None = None
        minimum_horizontal_field_of_view_start_angle: float | None = None
        maximum_horizontal_field_of_view_stop_angle: float | None = None
        minimum_vertical_field_of_view_start_angle: float | None = None
        maximum_vertical_field_of_view_stop_angle: float | None = None
        miniumum_update_rate: float | None = None
        maximum_update_rate: float | None = None
        minimum_range: float | None = None
        maximum_range: float | None = None
        supported_compression: environment_sensing_v1_0_types.SupportedCompression | None = None
        coordinate_transformation_supported: ReportRangeSensorCapabilities.CoordinateTransformationSupported | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("SensorName", rt.Text(count=rt.Count("B", 0, 255))),
                ("SupportedStates", environment_sensing_v1_0_types.SupportedStates.layout(), True),
                ("MinimumHorizontalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("MaximumHorizontalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("MinimumVerticalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("MaximumVerticalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("MiniumumUpdateRate", rt.real("H", 0.0, 1000.0, "hertz"), True),
                ("MaximumUpdateRate", rt.real("H", 0.0, 1000.0, "hertz"), True),
                ("MinimumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("MaximumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("SupportedCompression", environment_sensing_v1_0_types.SupportedCompression.layout(), True),
                ("CoordinateTransformationSupported", rt.Number("B", rt.Values(ReportRangeSensorCapabilities.CoordinateTransformationSupported)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            (sensor_id_,) = _S_H.unpack_from(data, at + 2)
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            sensor_name_end_ = at + 5 + data[at + 4]
            self.sensor_name = data[at + 5:sensor_name_end_].decode("latin-1")
            packer = _M_ReportRangeSensorCapabilities_RangeSensorCapabilitiesRec_2[mask & 0x7FF]
            raw = iter(packer.unpack_from(data, sensor_name_end_)).__next__
            at = sensor_name_end_ + packer.size
            if mask & 1:
                supported_states_ = raw()
                self.supported_states = environment_sensing_v1_0_types.SupportedStates(_E_SupportedStates_Active.get(supported_states_ & 0x1, supported_states_ & 0x1), _E_SupportedStates_Standby.get(supported_states_ >> 1 & 0x1, supported_states_ >> 1 & 0x1), _E_SupportedStates_Off.get(supported_states_ >> 2 & 0x1, supported_states_ >> 2 & 0x1), supported_states_ & 0xF8)
            else: self.supported_states = None
            self.minimum_horizontal_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 2 else None
            self.maximum_horizontal_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 4 else None
            self.minimum_vertical_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 8 else None
            self.maximum_vertical_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 16 else None
            self.miniumum_update_rate = raw() * 0.015259021896696421 if mask & 32 else None
            self.maximum_update_rate = raw() * 0.015259021896696421 if mask & 64 else None
            self.minimum_range = raw() * 0.00023283064370807974 if mask & 128 else None
            self.maximum_range = raw() * 0.00023283064370807974 if mask & 256 else None
            if mask & 512:
                supported_compression_ = raw()
                self.supported_compression = environment_sensing_v1_0_types.SupportedCompression(_E_SupportedCompression_NoCompression.get(supported_compression_ & 0x1, supported_compression_ & 0x1), _E_SupportedCompression_DEFLATE.get(supported_compression_ >> 1 & 0x1, supported_compression_ >> 1 & 0x1), _E_SupportedCompression_Bzip2.get(supported_compression_ >> 2 & 0x1, supported_compression_ >> 2 & 0x1), _E_SupportedCompression_LZMA.get(supported_compression_ >> 3 & 0x1, supported_compression_ >> 3 & 0x1), supported_compression_ & 0xF0)
            else: self.supported_compression = None
            if mask & 1024:
                coordinate_transformation_supported_ = raw()
                self.coordinate_transformation_supported = _E_ReportRangeSensorCapabilities_CoordinateTransformationSupported[coordinate_transformation_supported_]
            else: self.coordinate_transformation_supported = None
            self.reserved_presence = mask & 0xF800
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0x7FF: raise rt.Reject
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            out += _S_H.pack(sensor_id_)
            sensor_name_raw_ = self.sensor_name.encode("latin-1")
            out.append(len(sensor_name_raw_))
            out += sensor_name_raw_
            raw: list[int | float | bytes] = []
            supported_states_ = self.supported_states
            if supported_states_ is not None:
                mask |= 1
                if type(supported_states_) is not environment_sensing_v1_0_types.SupportedStates: raise rt.Reject
                active_ = supported_states_.active
                if not 0 <= active_ <= 1: raise rt.Reject
                standby_ = supported_states_.standby
                if not 0 <= standby_ <= 1: raise rt.Reject
                off_ = supported_states_.off
                if not 0 <= off_ <= 1: raise rt.Reject
                reserved_bits_ = supported_states_.reserved_bits
                if reserved_bits_ & 0x7: raise rt.Reject
                raw.append(active_ | standby_ << 1 | off_ << 2 | reserved_bits_)
            minimum_horizontal_field_of_view_start_angle_ = self.minimum_horizontal_field_of_view_start_angle
            if minimum_horizontal_field_of_view_start_angle_ is not None:
                mask |= 2
                if not -3.141592653589793 <= minimum_horizontal_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = minimum_horizontal_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                minimum_horizontal_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_horizontal_field_of_view_start_angle_raw_ < 0.9999847412109375: minimum_horizontal_field_of_view_start_angle_raw_ = rt.exact_raw(minimum_horizontal_field_of_view_start_angle_, _R_2)
                raw.append(minimum_horizontal_field_of_view_start_angle_raw_)
            maximum_horizontal_field_of_view_stop_angle_ = self.maximum_horizontal_field_of_view_stop_angle
            if maximum_horizontal_field_of_view_stop_angle_ is not None:
                mask |= 4
                if not -3.141592653589793 <= maximum_horizontal_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = maximum_horizontal_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                maximum_horizontal_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_horizontal_field_of_view_stop_angle_raw_ < 0.9999847412109375: maximum_horizontal_field_of_view_stop_angle_raw_ = rt.exact_raw(maximum_horizontal_field_of_view_stop_angle_, _R_2)
                raw.append(maximum_horizontal_field_of_view_stop_angle_raw_)
            minimum_vertical_field_of_view_start_angle_ = self.minimum_vertical_field_of_view_start_angle
            if minimum_vertical_field_of_view_start_angle_ is not None:
                mask |= 8
                if not -3.141592653589793 <= minimum_vertical_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = minimum_vertical_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                minimum_vertical_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_vertical_field_of_view_start_angle_raw_ < 0.9999847412109375: minimum_vertical_field_of_view_start_angle_raw_ = rt.exact_raw(minimum_vertical_field_of_view_start_angle_, _R_2)
                raw.append(minimum_vertical_field_of_view_start_angle_raw_)
            maximum_vertical_field_of_view_stop_angle_ = self.maximum_vertical_field_of_view_stop_angle
            if maximum_vertical_field_of_view_stop_angle_ is not None:
                mask |= 16
                if not -3.141592653589793 <= maximum_vertical_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = maximum_vertical_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                maximum_vertical_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_vertical_field_of_view_stop_angle_raw_ < 0.9999847412109375: maximum_vertical_field_of_view_stop_angle_raw_ = rt.exact_raw(maximum_vertical_field_of_view_stop_angle_, _R_2)
                raw.append(maximum_vertical_field_of_view_stop_angle_raw_)
            miniumum_update_rate_ = self.miniumum_update_rate
            if miniumum_update_rate_ is not None:
                mask |= 32
                if not 0.0 <= miniumum_update_rate_ <= 1000.0: raise rt.Reject
                near = miniumum_update_rate_ * 65.535 + 0.5
                miniumum_update_rate_raw_ = int(near)
                if not 1.52587890625e-05 < near - miniumum_update_rate_raw_ < 0.9999847412109375: miniumum_update_rate_raw_ = rt.exact_raw(miniumum_update_rate_, _R_3)
                raw.append(miniumum_update_rate_raw_)
            maximum_update_rate_ = self.maximum_update_rate
            if maximum_update_rate_ is not None:
                mask |= 64
                if not 0.0 <= maximum_update_rate_ <= 1000.0: raise rt.Reject
                near = maximum_update_rate_ * 65.535 + 0.5
                maximum_update_rate_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_update_rate_raw_ < 0.9999847412109375: maximum_update_rate_raw_ = rt.exact_raw(maximum_update_rate_, _R_3)
                raw.append(maximum_update_rate_raw_)
            minimum_range_ = self.minimum_range
            if minimum_range_ is not None:
                mask |= 128
                if not 0.0 <= minimum_range_ <= 1000000.0: raise rt.Reject
                near = minimum_range_ * 4294.967295 + 0.5
                minimum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_range_raw_ < 0.9999847412109375: minimum_range_raw_ = rt.exact_raw(minimum_range_, _R_4)
                raw.append(minimum_range_raw_)
            maximum_range_ = self.maximum_range
            if maximum_range_ is not None:
                mask |= 256
                if not 0.0 <= maximum_range_ <= 1000000.0: raise rt.Reject
                near = maximum_range_ * 4294.967295 + 0.5
                maximum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_range_raw_ < 0.9999847412109375: maximum_range_raw_ = rt.exact_raw(maximum_range_, _R_4)
                raw.append(maximum_range_raw_)
            supported_compression_ = self.supported_compression
            if supported_compression_ is not None:
                mask |= 512
                if type(supported_compression_) is not environment_sensing_v1_0_types.SupportedCompression: raise rt.Reject
                no_compression_ = supported_compression_.no_compression
                if not 0 <= no_compression_ <= 1: raise rt.Reject
                deflate_ = supported_compression_.deflate
                if not 0 <= deflate_ <= 1: raise rt.Reject
                bzip2_ = supported_compression_.bzip2
                if not 0 <= bzip2_ <= 1: raise rt.Reject
                lzma_ = supported_compression_.lzma
                if not 0 <= lzma_ <= 1: raise rt.Reject
                reserved_bits_2_ = supported_compression_.reserved_bits
                if reserved_bits_2_ & 0xF: raise rt.Reject
                raw.append(no_compression_ | deflate_ << 1 | bzip2_ << 2 | lzma_ << 3 | reserved_bits_2_)
            coordinate_transformation_supported_ = self.coordinate_transformation_supported
            if coordinate_transformation_supported_ is not None:
                mask |= 1024
                if coordinate_transformation_supported_ not in _E_ReportRangeSensorCapabilities_CoordinateTransformationSupported: raise rt.Reject
                raw.append(coordinate_transformation_supported_)
            out += _M_ReportRangeSensorCapabilities_RangeSensorCapabilitiesRec_2[mask & 0x7FF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    range_sensor_capabilities_list: list[ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if range_sensor_capabilities_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        range_sensor_capabilities_list_ = []
        for _ in range(range_sensor_capabilities_list_count_):
            item_, at = ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec._read(data, at, nesting)
            range_sensor_capabilities_list_.append(item_)
        self.range_sensor_capabilities_list = range_sensor_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x48")
        range_sensor_capabilities_list_ = self.range_sensor_capabilities_list
        if type(range_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_capabilities_list_))
        for item_ in range_sensor_capabilities_list_:
            if type(item_) is not ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportRangeSensorConfiguration(rt.Message):
    """ReportRangeSensorConfiguration (0x4802): Tells the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """

    CODE = 0x4802
    NAME = "ReportRangeSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SensorState(IntEnum):
        """Values of SensorState."""

        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    @dataclass(slots=True, repr=False)
    class RangeSensorConfigurationRec(rt.Struct):
        """Settings of one sensor.

        sensor_id: 1..65535. Identifies the sensor
        horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from left to right, in radians
        horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from left to right, in radians
        vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from top to bottom, in radians
        vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from top to bottom, in radians
        update_rate: 0..1000 hertz, optional. Rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        sensor_state: SensorState, optional. Whether the sensor works
        """

        sensor_id: int
        horizontal_field_of_view_start_angle: float | None = None
        horizontal_field_of_view_stop_angle: float | None = None
        vertical_field_of_view_start_angle: float | None = None
        vertical_field_of_view_stop_angle: float | None = None
        update_rate: float | None = None
        minimum_range: float | None = None
        maximum_range: float | None = None
        sensor_state: ReportRangeSensorConfiguration.SensorState | int | None = None

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("HorizontalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("HorizontalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfViewStartAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VerticalFieldOfViewStopAngle", rt.real("I", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("UpdateRate", rt.real("H", 0.0, 1000.0, "hertz"), True),
                ("MinimumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("MaximumRange", rt.real("I", 0.0, 1000000.0, "meter"), True),
                ("SensorState", rt.Number("B", rt.Values(ReportRangeSensorConfiguration.SensorState)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetRangeSensorConfiguration_RangeSensorConfigurationRec_0[mask & 0xFF]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.horizontal_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 1 else None
            self.horizontal_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 2 else None
            self.vertical_field_of_view_start_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 4 else None
            self.vertical_field_of_view_stop_angle = -3.141592653589793 + raw() * 1.4629180796077717e-09 if mask & 8 else None
            self.update_rate = raw() * 0.015259021896696421 if mask & 16 else None
            self.minimum_range = raw() * 0.00023283064370807974 if mask & 32 else None
            self.maximum_range = raw() * 0.00023283064370807974 if mask & 64 else None
            if mask & 128:
                sensor_state_ = raw()
                self.sensor_state = _E_ReportRangeSensorConfiguration_SensorState[sensor_state_]
            else: self.sensor_state = None
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = 0
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            horizontal_field_of_view_start_angle_ = self.horizontal_field_of_view_start_angle
            if horizontal_field_of_view_start_angle_ is not None:
                mask |= 1
                if not -3.141592653589793 <= horizontal_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_start_angle_raw_ < 0.9999847412109375: horizontal_field_of_view_start_angle_raw_ = rt.exact_raw(horizontal_field_of_view_start_angle_, _R_2)
                raw.append(horizontal_field_of_view_start_angle_raw_)
            horizontal_field_of_view_stop_angle_ = self.horizontal_field_of_view_stop_angle
            if horizontal_field_of_view_stop_angle_ is not None:
                mask |= 2
                if not -3.141592653589793 <= horizontal_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = horizontal_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                horizontal_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - horizontal_field_of_view_stop_angle_raw_ < 0.9999847412109375: horizontal_field_of_view_stop_angle_raw_ = rt.exact_raw(horizontal_field_of_view_stop_angle_, _R_2)
                raw.append(horizontal_field_of_view_stop_angle_raw_)
            vertical_field_of_view_start_angle_ = self.vertical_field_of_view_start_angle
            if vertical_field_of_view_start_angle_ is not None:
                mask |= 4
                if not -3.141592653589793 <= vertical_field_of_view_start_angle_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_start_angle_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_start_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_start_angle_raw_ < 0.9999847412109375: vertical_field_of_view_start_angle_raw_ = rt.exact_raw(vertical_field_of_view_start_angle_, _R_2)
                raw.append(vertical_field_of_view_start_angle_raw_)
            vertical_field_of_view_stop_angle_ = self.vertical_field_of_view_stop_angle
            if vertical_field_of_view_stop_angle_ is not None:
                mask |= 8
                if not -3.141592653589793 <= vertical_field_of_view_stop_angle_ <= 3.141592653589793: raise rt.Reject
                near = vertical_field_of_view_stop_angle_ * 683565275.4172766 + 2147483647.9999998
                vertical_field_of_view_stop_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - vertical_field_of_view_stop_angle_raw_ < 0.9999847412109375: vertical_field_of_view_stop_angle_raw_ = rt.exact_raw(vertical_field_of_view_stop_angle_, _R_2)
                raw.append(vertical_field_of_view_stop_angle_raw_)
            update_rate_ = self.update_rate
            if update_rate_ is not None:
                mask |= 16
                if not 0.0 <= update_rate_ <= 1000.0: raise rt.Reject
                near = update_rate_ * 65.535 + 0.5
                update_rate_raw_ = int(near)
                if not 1.52587890625e-05 < near - update_rate_raw_ < 0.9999847412109375: update_rate_raw_ = rt.exact_raw(update_rate_, _R_3)
                raw.append(update_rate_raw_)
            minimum_range_ = self.minimum_range
            if minimum_range_ is not None:
                mask |= 32
                if not 0.0 <= minimum_range_ <= 1000000.0: raise rt.Reject
                near = minimum_range_ * 4294.967295 + 0.5
                minimum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - minimum_range_raw_ < 0.9999847412109375: minimum_range_raw_ = rt.exact_raw(minimum_range_, _R_4)
                raw.append(minimum_range_raw_)
            maximum_range_ = self.maximum_range
            if maximum_range_ is not None:
                mask |= 64
                if not 0.0 <= maximum_range_ <= 1000000.0: raise rt.Reject
                near = maximum_range_ * 4294.967295 + 0.5
                maximum_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_range_raw_ < 0.9999847412109375: maximum_range_raw_ = rt.exact_raw(maximum_range_, _R_4)
                raw.append(maximum_range_raw_)
            sensor_state_ = self.sensor_state
            if sensor_state_ is not None:
                mask |= 128
                if sensor_state_ not in _E_ReportRangeSensorConfiguration_SensorState: raise rt.Reject
                raw.append(sensor_state_)
            out += _M_SetRangeSensorConfiguration_RangeSensorConfigurationRec_0[mask & 0xFF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    range_sensor_configuration_list: list[ReportRangeSensorConfiguration.RangeSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportRangeSensorConfiguration.RangeSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if range_sensor_configuration_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        range_sensor_configuration_list_ = []
        for _ in range(range_sensor_configuration_list_count_):
            item_, at = ReportRangeSensorConfiguration.RangeSensorConfigurationRec._read(data, at, nesting)
            range_sensor_configuration_list_.append(item_)
        self.range_sensor_configuration_list = range_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x48")
        range_sensor_configuration_list_ = self.range_sensor_configuration_list
        if type(range_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_configuration_list_))
        for item_ in range_sensor_configuration_list_:
            if type(item_) is not ReportRangeSensorConfiguration.RangeSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportRangeSensorData(rt.Message):
    """ReportRangeSensorData (0x4803): Tells measurements of range, point by point.

    range_sensor_data_list: 0..65535 items. The sensors
    """

    CODE = 0x4803
    NAME = "ReportRangeSensorData"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    class DataErrorCode(IntEnum):
        """Values of DataErrorCode."""

        SENSOR_NOT_ACTIVE = 0
        INVALID_COMPRESSION_FORMAT = 1
        UNKNOWN_ERROR = 255

    @dataclass(slots=True, repr=False)
    class RangeSensorDataErrorRec(rt.Struct):
        """Why a sensor has no measurement.

        sensor_id: 1..65535. Identifies the sensor
        data_error_code: DataErrorCode. Why there is no measurement
        error_message: up to 255 characters. An explanation for people
        """

        sensor_id: int
        data_error_code: ReportRangeSensorData.DataErrorCode | int
        error_message: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("DataErrorCode", rt.Number("B", rt.Values(ReportRangeSensorData.DataErrorCode))),
                ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            sensor_id_, data_error_code_ = _S_HB.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.data_error_code = _E_ReportRangeSensorData_DataErrorCode[data_error_code_]
            error_message_end_ = at + 4 + data[at + 3]
            self.error_message = data[at + 4:error_message_end_].decode("latin-1")
            return self, error_message_end_

        def _write(self, out: bytearray) -> None:
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            data_error_code_ = self.data_error_code
            if data_error_code_ not in _E_ReportRangeSensorData_DataErrorCode: raise rt.Reject
            out += _S_HB.pack(sensor_id_, data_error_code_)
            error_message_raw_ = self.error_message.encode("latin-1")
            out.append(len(error_message_raw_))
            out += error_message_raw_

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    @dataclass(slots=True, repr=False)
    class RangeSensorDataRec(rt.Struct):
        """RangeSensorDataRec.

        sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: Time within the month, in UTC
        """

        sensor_id: int
        report_coordinate_system: ReportRangeSensorData.ReportCoordinateSystem | int
        time_stamp: core_v1_0_types.TimeStamp

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(ReportRangeSensorData.ReportCoordinateSystem))),
                ("TimeStamp", core_v1_0_types.TimeStamp.layout()),
            )

    class RangeValidity(IntEnum):
        """Values of RangeValidity."""

        FALSE = 0
        TRUE = 1

    class BearingValidity(IntEnum):
        """Values of BearingValidity."""

        FALSE = 0
        TRUE = 1

    class InclinationValidity(IntEnum):
        """Values of InclinationValidity."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False, kw_only=True)
    class RangeSensorDataPointRec(rt.Struct):
        """RangeSensorDataPointRec.

        point_id: optional. Identifies the point
        range: 0..1000000 meter. Distance, in metres
        range_validity: RangeValidity, optional. Whether the distance can be used
        range_error_rms: 0..100000 meter, optional. Root mean square error of the distance, in metres
        bearing: -3.14159265359..3.14159265359 radian. Angle in the horizontal plane of the frame, in radians; 0 is ahead
        bearing_validity: BearingValidity, optional. Whether the bearing can be used
        bearing_error_rms: 0..3.14159265359 radian, optional. Root mean square error of the bearing, in radians
        inclination: -3.14159265359..3.14159265359 radian. Angle to the horizontal plane of the frame, in radians
        inclination_validity: InclinationValidity, optional. Whether the inclination can be used
        inclination_error_rms: 0..3.14159265359 radian, optional. Root mean square error of the inclination, in radians
        """

        point_id: int | None = None
        range: float
        range_validity: ReportRangeSensorData.RangeValidity | int | None = None
        range_error_rms: float | None = None
        bearing: float
        bearing_validity: ReportRangeSensorData.BearingValidity | int | None = None
        bearing_error_rms: float | None = None
        inclination: float
        inclination_validity: ReportRangeSensorData.InclinationValidity | int | None = None
        inclination_error_rms: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("PointID", rt.Number("I"), True),
                ("Range", rt.real("I", 0.0, 1000000.0, "meter")),
                ("RangeValidity", rt.Number("B", rt.Values(ReportRangeSensorData.RangeValidity)), True),
                ("RangeErrorRMS", rt.real("I", 0.0, 100000.0, "meter"), True),
                ("Bearing", rt.real("I", -3.141592653589793, 3.141592653589793, "radian")),
                ("BearingValidity", rt.Number("B", rt.Values(ReportRangeSensorData.BearingValidity)), True),
                ("BearingErrorRMS", rt.real("I", 0.0, 3.141592653589793, "radian"), True),
                ("Inclination", rt.real("I", -3.141592653589793, 3.141592653589793, "radian")),
                ("InclinationValidity", rt.Number("B", rt.Values(ReportRangeSensorData.InclinationValidity)), True),
                ("InclinationErrorRMS", rt.real("I", 0.0, 3.141592653589793, "radian"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportRangeSensorData_RangeSensorDataPointRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.point_id = raw() if mask & 1 else None
            range_ = raw()
            self.range = range_ * 0.00023283064370807974
            if mask & 2:
                range_validity_ = raw()
                self.range_validity = _E_ReportRangeSensorData_RangeValidity[range_validity_]
            else: self.range_validity = None
            self.range_error_rms = raw() * 2.3283064370807974e-05 if mask & 4 else None
            bearing_ = raw()
            self.bearing = -3.141592653589793 + bearing_ * 1.4629180796077717e-09
            if mask & 8:
                bearing_validity_ = raw()
                self.bearing_validity = _E_ReportRangeSensorData_BearingValidity[bearing_validity_]
            else: self.bearing_validity = None
            self.bearing_error_rms = raw() * 7.314590398038859e-10 if mask & 16 else None
            inclination_ = raw()
            self.inclination = -3.141592653589793 + inclination_ * 1.4629180796077717e-09
            if mask & 32:
                inclination_validity_ = raw()
                self.inclination_validity = _E_ReportRangeSensorData_InclinationValidity[inclination_validity_]
            else: self.inclination_validity = None
            self.inclination_error_rms = raw() * 7.314590398038859e-10 if mask & 64 else None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            point_id_ = self.point_id
            if point_id_ is not None:
                mask |= 1
                raw.append(point_id_)
            range_ = self.range
            if not 0.0 <= range_ <= 1000000.0: raise rt.Reject
            near = range_ * 4294.967295 + 0.5
            range_raw_ = int(near)
            if not 1.52587890625e-05 < near - range_raw_ < 0.9999847412109375: range_raw_ = rt.exact_raw(range_, _R_4)
            raw.append(range_raw_)
            range_validity_ = self.range_validity
            if range_validity_ is not None:
                mask |= 2
                if range_validity_ not in _E_ReportRangeSensorData_RangeValidity: raise rt.Reject
                raw.append(range_validity_)
            range_error_rms_ = self.range_error_rms
            if range_error_rms_ is not None:
                mask |= 4
                if not 0.0 <= range_error_rms_ <= 100000.0: raise rt.Reject
                near = range_error_rms_ * 42949.67295 + 0.5
                range_error_rms_raw_ = int(near)
                if not 1.52587890625e-05 < near - range_error_rms_raw_ < 0.9999847412109375: range_error_rms_raw_ = rt.exact_raw(range_error_rms_, _R_35)
                raw.append(range_error_rms_raw_)
            bearing_ = self.bearing
            if not -3.141592653589793 <= bearing_ <= 3.141592653589793: raise rt.Reject
            near = bearing_ * 683565275.4172766 + 2147483647.9999998
            bearing_raw_ = int(near)
            if not 1.52587890625e-05 < near - bearing_raw_ < 0.9999847412109375: bearing_raw_ = rt.exact_raw(bearing_, _R_2)
            raw.append(bearing_raw_)
            bearing_validity_ = self.bearing_validity
            if bearing_validity_ is not None:
                mask |= 8
                if bearing_validity_ not in _E_ReportRangeSensorData_BearingValidity: raise rt.Reject
                raw.append(bearing_validity_)
            bearing_error_rms_ = self.bearing_error_rms
            if bearing_error_rms_ is not None:
                mask |= 16
                if not 0.0 <= bearing_error_rms_ <= 3.141592653589793: raise rt.Reject
                near = bearing_error_rms_ * 1367130550.8345532 + 0.5
                bearing_error_rms_raw_ = int(near)
                if not 1.52587890625e-05 < near - bearing_error_rms_raw_ < 0.9999847412109375: bearing_error_rms_raw_ = rt.exact_raw(bearing_error_rms_, _R_36)
                raw.append(bearing_error_rms_raw_)
            inclination_ = self.inclination
            if not -3.141592653589793 <= inclination_ <= 3.141592653589793: raise rt.Reject
            near = inclination_ * 683565275.4172766 + 2147483647.9999998
            inclination_raw_ = int(near)
            if not 1.52587890625e-05 < near - inclination_raw_ < 0.9999847412109375: inclination_raw_ = rt.exact_raw(inclination_, _R_2)
            raw.append(inclination_raw_)
            inclination_validity_ = self.inclination_validity
            if inclination_validity_ is not None:
                mask |= 32
                if inclination_validity_ not in _E_ReportRangeSensorData_InclinationValidity: raise rt.Reject
                raw.append(inclination_validity_)
            inclination_error_rms_ = self.inclination_error_rms
            if inclination_error_rms_ is not None:
                mask |= 64
                if not 0.0 <= inclination_error_rms_ <= 3.141592653589793: raise rt.Reject
                near = inclination_error_rms_ * 1367130550.8345532 + 0.5
                inclination_error_rms_raw_ = int(near)
                if not 1.52587890625e-05 < near - inclination_error_rms_raw_ < 0.9999847412109375: inclination_error_rms_raw_ = rt.exact_raw(inclination_error_rms_, _R_36)
                raw.append(inclination_error_rms_raw_)
            out += _M_ReportRangeSensorData_RangeSensorDataPointRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class RangeSensorDataSeq(rt.Struct):
        """RangeSensorDataSeq.

        range_sensor_data_point_list: 0..65535 items. The points
        """

        range_sensor_data_rec: ReportRangeSensorData.RangeSensorDataRec
        range_sensor_data_point_list: list[ReportRangeSensorData.RangeSensorDataPointRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RangeSensorDataRec", ReportRangeSensorData.RangeSensorDataRec.layout()),
                ("RangeSensorDataPointList", rt.Repeat(rt.Count("H", 0, 65535), ReportRangeSensorData.RangeSensorDataPointRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            sensor_id_, report_coordinate_system_, time_stamp_ = _S_HBI.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.range_sensor_data_rec = ReportRangeSensorData.RangeSensorDataRec(sensor_id_, _E_ReportRangeSensorData_ReportCoordinateSystem[report_coordinate_system_], core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_))
            (range_sensor_data_point_list_count_,) = _S_H.unpack_from(data, at + 7)
            if range_sensor_data_point_list_count_ * 13 > size - (at + 9): raise rt.Reject
            at += 9
            range_sensor_data_point_list_ = []
            for _ in range(range_sensor_data_point_list_count_):
                item_, at = ReportRangeSensorData.RangeSensorDataPointRec._read(data, at, nesting)
                range_sensor_data_point_list_.append(item_)
            self.range_sensor_data_point_list = range_sensor_data_point_list_
            return self, at

        def _write(self, out: bytearray) -> None:
            range_sensor_data_rec_ = self.range_sensor_data_rec
            if type(range_sensor_data_rec_) is not ReportRangeSensorData.RangeSensorDataRec: raise rt.Reject
            sensor_id_ = range_sensor_data_rec_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            report_coordinate_system_ = range_sensor_data_rec_.report_coordinate_system
            if report_coordinate_system_ not in _E_ReportRangeSensorData_ReportCoordinateSystem: raise rt.Reject
            time_stamp_ = range_sensor_data_rec_.time_stamp
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            out += _S_HBI.pack(sensor_id_, report_coordinate_system_, milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
            range_sensor_data_point_list_ = self.range_sensor_data_point_list
            if type(range_sensor_data_point_list_) is not list: raise rt.Reject
            out += _S_H.pack(len(range_sensor_data_point_list_))
            for item_ in range_sensor_data_point_list_:
                if type(item_) is not ReportRangeSensorData.RangeSensorDataPointRec: raise rt.Reject
                item_._write(out)

    range_sensor_data_list: list[ReportRangeSensorData.RangeSensorDataErrorRec | ReportRangeSensorData.RangeSensorDataSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorDataList", rt.Repeat(rt.Count("H", 0, 65535), rt.Union.of("B", range_sensor_data_error_rec=ReportRangeSensorData.RangeSensorDataErrorRec, range_sensor_data_seq=ReportRangeSensorData.RangeSensorDataSeq))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_data_list_count_,) = _S_H.unpack_from(data, 2)
        if range_sensor_data_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        range_sensor_data_list_ = []
        for _ in range(range_sensor_data_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_39[tag]._read(data, at, nesting)
            range_sensor_data_list_.append(item_)
        self.range_sensor_data_list = range_sensor_data_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x48")
        range_sensor_data_list_ = self.range_sensor_data_list
        if type(range_sensor_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_data_list_))
        for item_ in range_sensor_data_list_:
            out.append(_T_40[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportRangeSensorCompressedData(rt.Message):
    """ReportRangeSensorCompressedData (0x4804): Tells measurements of range in a compressed form.

    range_sensor_compressed_data_list: 0..65535 items. The sensors
    """

    CODE = 0x4804
    NAME = "ReportRangeSensorCompressedData"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    class DataErrorCode(IntEnum):
        """Values of DataErrorCode."""

        SENSOR_NOT_ACTIVE = 0
        INVALID_COMPRESSION_FORMAT = 1
        UNKNOWN_ERROR = 255

    @dataclass(slots=True, repr=False)
    class RangeSensorDataErrorRec(rt.Struct):
        """Why a sensor has no measurement.

        sensor_id: 1..65535. Identifies the sensor
        data_error_code: DataErrorCode. Why there is no measurement
        error_message: up to 255 characters. An explanation for people
        """

        sensor_id: int
        data_error_code: ReportRangeSensorCompressedData.DataErrorCode | int
        error_message: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("DataErrorCode", rt.Number("B", rt.Values(ReportRangeSensorCompressedData.DataErrorCode))),
                ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            sensor_id_, data_error_code_ = _S_HB.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.data_error_code = _E_ReportRangeSensorCompressedData_DataErrorCode[data_error_code_]
            error_message_end_ = at + 4 + data[at + 3]
            self.error_message = data[at + 4:error_message_end_].decode("latin-1")
            return self, error_message_end_

        def _write(self, out: bytearray) -> None:
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            data_error_code_ = self.data_error_code
            if data_error_code_ not in _E_ReportRangeSensorCompressedData_DataErrorCode: raise rt.Reject
            out += _S_HB.pack(sensor_id_, data_error_code_)
            error_message_raw_ = self.error_message.encode("latin-1")
            out.append(len(error_message_raw_))
            out += error_message_raw_

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    class DataCompression(IntEnum):
        """Values of DataCompression."""

        NONE = 0
        DEFLATE = 1
        BZIP2 = 2
        LZMA = 3

    @dataclass(slots=True, repr=False)
    class RangeSensorCompressedDataRec(rt.Struct):
        """RangeSensorCompressedDataRec.

        sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: Time within the month, in UTC
        data_compression: DataCompression. Kind of compression
        compressed_data: RangeSensorDataPointList. The points of a report, compressed
        """

        sensor_id: int
        report_coordinate_system: ReportRangeSensorCompressedData.ReportCoordinateSystem | int
        time_stamp: core_v1_0_types.TimeStamp
        data_compression: ReportRangeSensorCompressedData.DataCompression | int
        compressed_data: bytes

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(ReportRangeSensorCompressedData.ReportCoordinateSystem))),
                ("TimeStamp", core_v1_0_types.TimeStamp.layout()),
                ("DataCompression", rt.Number("B", rt.Values(ReportRangeSensorCompressedData.DataCompression))),
                ("CompressedData", rt.Blob(rt.Count("I", 0, 2147483647))),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            sensor_id_, report_coordinate_system_, time_stamp_, data_compression_ = _S_HBIB.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.report_coordinate_system = _E_ReportRangeSensorCompressedData_ReportCoordinateSystem[report_coordinate_system_]
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.time_stamp = core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_)
            self.data_compression = _E_ReportRangeSensorCompressedData_DataCompression[data_compression_]
            (compressed_data_end_,) = _S_I.unpack_from(data, at + 8)
            if compressed_data_end_ > 2147483647: raise rt.Reject
            compressed_data_end_ += at + 12
            self.compressed_data = data[at + 12:compressed_data_end_]
            return self, compressed_data_end_

        def _write(self, out: bytearray) -> None:
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            report_coordinate_system_ = self.report_coordinate_system
            if report_coordinate_system_ not in _E_ReportRangeSensorCompressedData_ReportCoordinateSystem: raise rt.Reject
            time_stamp_ = self.time_stamp
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            data_compression_ = self.data_compression
            if data_compression_ not in _E_ReportRangeSensorCompressedData_DataCompression: raise rt.Reject
            out += _S_HBIB.pack(sensor_id_, report_coordinate_system_, milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27, data_compression_)
            compressed_data_raw_ = rt.plain_bytes(self.compressed_data)
            if len(compressed_data_raw_) > 2147483647: raise rt.Reject
            out += _S_I.pack(len(compressed_data_raw_))
            out += compressed_data_raw_

    range_sensor_compressed_data_list: list[ReportRangeSensorCompressedData.RangeSensorDataErrorRec | ReportRangeSensorCompressedData.RangeSensorCompressedDataRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RangeSensorCompressedDataList", rt.Repeat(rt.Count("H", 0, 65535), rt.Union.of("B", range_sensor_data_error_rec=ReportRangeSensorCompressedData.RangeSensorDataErrorRec, range_sensor_compressed_data_rec=ReportRangeSensorCompressedData.RangeSensorCompressedDataRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (range_sensor_compressed_data_list_count_,) = _S_H.unpack_from(data, 2)
        if range_sensor_compressed_data_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        range_sensor_compressed_data_list_ = []
        for _ in range(range_sensor_compressed_data_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_46[tag]._read(data, at, nesting)
            range_sensor_compressed_data_list_.append(item_)
        self.range_sensor_compressed_data_list = range_sensor_compressed_data_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x48")
        range_sensor_compressed_data_list_ = self.range_sensor_compressed_data_list
        if type(range_sensor_compressed_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(range_sensor_compressed_data_list_))
        for item_ in range_sensor_compressed_data_list_:
            out.append(_T_47[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportSensorGeometricProperties(rt.Message):
    """ReportSensorGeometricProperties (0x4805): Tells where sensors are mounted.

    geometric_properties_list: 0..65535 items. The sensors
    """

    CODE = 0x4805
    NAME = "ReportSensorGeometricProperties"
    SERVICE = "urn:jaus:jss:environmentSensing:RangeSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SensorIdRec = environment_sensing_v1_0_types.SensorIdRec
    StaticGeometricPropertiesRec = environment_sensing_v1_0_types.StaticGeometricPropertiesRec
    ManipulatorGeometricPropertiesRec = environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec

    @dataclass(slots=True, repr=False)
    class Empty0(rt.Struct):
        """Empty0."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class NoGeometricPropertiesVariant(rt.Struct):
        """Mounting is unknown.

        no_geometric_properties_variant: Mounting is unknown
        """

        no_geometric_properties_variant: ReportSensorGeometricProperties.Empty0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NoGeometricPropertiesVariant", rt.Union.of("B", empty0=ReportSensorGeometricProperties.Empty0)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.no_geometric_properties_variant, at = _U_48[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            no_geometric_properties_variant_ = self.no_geometric_properties_variant
            out.append(_T_49[type(no_geometric_properties_variant_)])
            no_geometric_properties_variant_._write(out)

    @dataclass(slots=True, repr=False)
    class GeometricPropertiesSequence(rt.Struct):
        """GeometricPropertiesSequence.

        sensor_id_rec: One sensor
        geometric_properties_variant: Mounting on the vehicle, on a manipulator, or unknown
        """

        sensor_id_rec: environment_sensing_v1_0_types.SensorIdRec
        geometric_properties_variant: ReportSensorGeometricProperties.NoGeometricPropertiesVariant | environment_sensing_v1_0_types.StaticGeometricPropertiesRec | environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorIdRec", environment_sensing_v1_0_types.SensorIdRec.layout()),
                ("GeometricPropertiesVariant", rt.Union.of("B", no_geometric_properties_variant=ReportSensorGeometricProperties.NoGeometricPropertiesVariant, static_geometric_properties_rec=environment_sensing_v1_0_types.StaticGeometricPropertiesRec, manipulator_geometric_properties_rec=environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec)),
            )

    geometric_properties_list: list[ReportSensorGeometricProperties.GeometricPropertiesSequence]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GeometricPropertiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportSensorGeometricProperties.GeometricPropertiesSequence.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x05 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (geometric_properties_list_count_,) = _S_H.unpack_from(data, 2)
        if geometric_properties_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        geometric_properties_list_ = []
        for _ in range(geometric_properties_list_count_):
            item_ = rt.new(ReportSensorGeometricProperties.GeometricPropertiesSequence)
            (sensor_id_,) = _S_H.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            item_.sensor_id_rec = environment_sensing_v1_0_types.SensorIdRec(sensor_id_)
            tag = data[at + 2]
            at += 3
            item_.geometric_properties_variant, at = _U_50[tag]._read(data, at, nesting)
            geometric_properties_list_.append(item_)
        self.geometric_properties_list = geometric_properties_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x05\x48")
        geometric_properties_list_ = self.geometric_properties_list
        if type(geometric_properties_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(geometric_properties_list_))
        for item_ in geometric_properties_list_:
            if type(item_) is not ReportSensorGeometricProperties.GeometricPropertiesSequence: raise rt.Reject
            sensor_id_rec_ = item_.sensor_id_rec
            if type(sensor_id_rec_) is not environment_sensing_v1_0_types.SensorIdRec: raise rt.Reject
            sensor_id_ = sensor_id_rec_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            out += _S_H.pack(sensor_id_)
            geometric_properties_variant_ = item_.geometric_properties_variant
            out.append(_T_51[type(geometric_properties_variant_)])
            geometric_properties_variant_._write(out)
        return bytes(out)


_M_SetRangeSensorConfiguration_RangeSensorConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "I"), (64, "I"), (128, "B")))
_E_SetRangeSensorConfiguration_SensorState = rt.members(SetRangeSensorConfiguration.SensorState)
_R_2 = rt.Scaling(-3.141592653589793, 3.141592653589793, 4294967295)
_R_3 = rt.Scaling(0.0, 1000.0, 65535)
_R_4 = rt.Scaling(0.0, 1000000.0, 4294967295)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_E_SensorIDQueryRec_SensorID = rt.members(environment_sensing_v1_0_types.SensorIDQueryRec.SensorID)
_L_H = rt.Rows("H")
_E_QueryRangeSensorCompressedData_SensorID = rt.members(QueryRangeSensorCompressedData.SensorID)
_E_QueryRangeSensorCompressedData_ReportCoordinateSystem = rt.members(QueryRangeSensorCompressedData.ReportCoordinateSystem)
_E_QueryRangeSensorCompressedData_DataCompression = rt.members(QueryRangeSensorCompressedData.DataCompression)
_S_H2BH = rt.Packer("<H2BH")
_E_QueryRangeSensorData_SensorID = rt.members(QueryRangeSensorData.SensorID)
_E_QueryRangeSensorData_ReportCoordinateSystem = rt.members(QueryRangeSensorData.ReportCoordinateSystem)
_S_HBH = rt.Packer("<HBH")
_E_QueryRangeSensorCapabilities_SensorID = rt.members(QueryRangeSensorCapabilities.SensorID)
_S_2H = rt.Packer("<2H")
_E_QueryRangeSensorConfiguration_SensorID = rt.members(QueryRangeSensorConfiguration.SensorID)
_M_ReportRangeSensorCapabilities_RangeSensorCapabilitiesRec_2 = rt.Masks("", ((1, "B"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "H"), (64, "H"), (128, "I"), (256, "I"), (512, "B"), (1024, "B")))
_E_SupportedStates_Active = rt.members(environment_sensing_v1_0_types.SupportedStates.Active)
_E_SupportedStates_Standby = rt.members(environment_sensing_v1_0_types.SupportedStates.Standby)
_E_SupportedStates_Off = rt.members(environment_sensing_v1_0_types.SupportedStates.Off)
_E_SupportedCompression_NoCompression = rt.members(environment_sensing_v1_0_types.SupportedCompression.NoCompression)
_E_SupportedCompression_DEFLATE = rt.members(environment_sensing_v1_0_types.SupportedCompression.DEFLATE)
_E_SupportedCompression_Bzip2 = rt.members(environment_sensing_v1_0_types.SupportedCompression.Bzip2)
_E_SupportedCompression_LZMA = rt.members(environment_sensing_v1_0_types.SupportedCompression.LZMA)
_E_ReportRangeSensorCapabilities_CoordinateTransformationSupported = rt.members(ReportRangeSensorCapabilities.CoordinateTransformationSupported)
_E_ReportRangeSensorConfiguration_SensorState = rt.members(ReportRangeSensorConfiguration.SensorState)
_E_ReportRangeSensorData_DataErrorCode = rt.members(ReportRangeSensorData.DataErrorCode)
_S_HB = rt.Packer("<HB")
_M_ReportRangeSensorData_RangeSensorDataPointRec_0 = rt.Masks("", ((1, "I"), (0, "I"), (2, "B"), (4, "I"), (0, "I"), (8, "B"), (16, "I"), (0, "I"), (32, "B"), (64, "I")))
_E_ReportRangeSensorData_RangeValidity = rt.members(ReportRangeSensorData.RangeValidity)
_E_ReportRangeSensorData_BearingValidity = rt.members(ReportRangeSensorData.BearingValidity)
_E_ReportRangeSensorData_InclinationValidity = rt.members(ReportRangeSensorData.InclinationValidity)
_R_35 = rt.Scaling(0.0, 100000.0, 4294967295)
_R_36 = rt.Scaling(0.0, 3.141592653589793, 4294967295)
_E_ReportRangeSensorData_ReportCoordinateSystem = rt.members(ReportRangeSensorData.ReportCoordinateSystem)
_S_HBI = rt.Packer("<HBI")
_U_39: tuple[type[ReportRangeSensorData.RangeSensorDataErrorRec] | type[ReportRangeSensorData.RangeSensorDataSeq], ...] = (ReportRangeSensorData.RangeSensorDataErrorRec, ReportRangeSensorData.RangeSensorDataSeq)
_T_40: dict[type[rt.Struct], int] = {ReportRangeSensorData.RangeSensorDataErrorRec: 0, ReportRangeSensorData.RangeSensorDataSeq: 1}
_E_ReportRangeSensorCompressedData_DataErrorCode = rt.members(ReportRangeSensorCompressedData.DataErrorCode)
_E_ReportRangeSensorCompressedData_ReportCoordinateSystem = rt.members(ReportRangeSensorCompressedData.ReportCoordinateSystem)
_E_ReportRangeSensorCompressedData_DataCompression = rt.members(ReportRangeSensorCompressedData.DataCompression)
_S_HBIB = rt.Packer("<HBIB")
_S_I = rt.Packer("<I")
_U_46: tuple[type[ReportRangeSensorCompressedData.RangeSensorDataErrorRec] | type[ReportRangeSensorCompressedData.RangeSensorCompressedDataRec], ...] = (ReportRangeSensorCompressedData.RangeSensorDataErrorRec, ReportRangeSensorCompressedData.RangeSensorCompressedDataRec)
_T_47: dict[type[rt.Struct], int] = {ReportRangeSensorCompressedData.RangeSensorDataErrorRec: 0, ReportRangeSensorCompressedData.RangeSensorCompressedDataRec: 1}
_U_48: tuple[type[ReportSensorGeometricProperties.Empty0], ...] = (ReportSensorGeometricProperties.Empty0,)
_T_49: dict[type[rt.Struct], int] = {ReportSensorGeometricProperties.Empty0: 0}
_U_50: tuple[type[ReportSensorGeometricProperties.NoGeometricPropertiesVariant] | type[environment_sensing_v1_0_types.StaticGeometricPropertiesRec] | type[environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec], ...] = (ReportSensorGeometricProperties.NoGeometricPropertiesVariant, environment_sensing_v1_0_types.StaticGeometricPropertiesRec, environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec)
_T_51: dict[type[rt.Struct], int] = {ReportSensorGeometricProperties.NoGeometricPropertiesVariant: 0, environment_sensing_v1_0_types.StaticGeometricPropertiesRec: 1, environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec: 2}
QuerySensorGeometricProperties.REPORT = ReportSensorGeometricProperties
QueryRangeSensorCompressedData.REPORT = ReportRangeSensorCompressedData
QueryRangeSensorData.REPORT = ReportRangeSensorData
QueryRangeSensorCapabilities.REPORT = ReportRangeSensorCapabilities
QueryRangeSensorConfiguration.REPORT = ReportRangeSensorConfiguration
