"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class QueryCostMap2DRec(rt.Struct):
    """QueryCostMap2DRec.

    max_width: 0..10000 meter. Largest size along the rows, in metres
    max_height: 0..10000 meter. Largest size along the columns, in metres
    """

    max_width: float
    max_height: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MaxWidth", rt.real("H", 0.0, 10000.0, "meter")),
            ("MaxHeight", rt.real("H", 0.0, 10000.0, "meter")),
        )


@dataclass(slots=True, repr=False)
class CostMap2DGlobalPoseRec(rt.Struct):
    """CostMap2DGlobalPoseRec.

    map_center_latitude: -90..90 degree. Latitude of the middle (WGS 84), in degrees
    map_center_longitude: -180..180 degree. Longitude of the middle (WGS 84), in degrees
    map_rotation: -3.14159265359..3.14159265359 radian. Rotation of the map about its middle, in radians
    """

    map_center_latitude: float
    map_center_longitude: float
    map_rotation: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MapCenterLatitude", rt.real("I", -90.0, 90.0, "degree")),
            ("MapCenterLongitude", rt.real("I", -180.0, 180.0, "degree")),
            ("MapRotation", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        map_center_latitude_, map_center_longitude_, map_rotation_ = _S_2IH.unpack_from(data, at)
        self.map_center_latitude = -90.0 + map_center_latitude_ * 4.190951586745435e-08
        self.map_center_longitude = -180.0 + map_center_longitude_ * 8.38190317349087e-08
        self.map_rotation = -3.141592653589793 + map_rotation_ * 9.587526218325454e-05
        return self, at + 10

    def _write(self, out: bytearray) -> None:
        map_center_latitude_ = self.map_center_latitude
        if not -90.0 <= map_center_latitude_ <= 90.0: raise rt.Reject
        near = map_center_latitude_ * 23860929.416666668 + 2147483648.0
        map_center_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_center_latitude_raw_ < 0.9999847412109375: map_center_latitude_raw_ = rt.exact_raw(map_center_latitude_, _R_1)
        map_center_longitude_ = self.map_center_longitude
        if not -180.0 <= map_center_longitude_ <= 180.0: raise rt.Reject
        near = map_center_longitude_ * 11930464.708333334 + 2147483648.0
        map_center_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_center_longitude_raw_ < 0.9999847412109375: map_center_longitude_raw_ = rt.exact_raw(map_center_longitude_, _R_2)
        map_rotation_ = self.map_rotation
        if not -3.141592653589793 <= map_rotation_ <= 3.141592653589793: raise rt.Reject
        near = map_rotation_ * 10430.219195527361 + 32768.0
        map_rotation_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_rotation_raw_ < 0.9999847412109375: map_rotation_raw_ = rt.exact_raw(map_rotation_, _R_3)
        out += _S_2IH.pack(map_center_latitude_raw_, map_center_longitude_raw_, map_rotation_raw_)


@dataclass(slots=True, repr=False)
class CostMap2DLocalPoseRec(rt.Struct):
    """CostMap2DLocalPoseRec.

    map_center_x: -100000..100000 meter. Position of the middle along X, in metres
    map_center_y: -100000..100000 meter. Position of the middle along Y, in metres
    map_rotation: -3.14159265359..3.14159265359 radian. Rotation of the map about its middle, in radians
    """

    map_center_x: float
    map_center_y: float
    map_rotation: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MapCenterX", rt.real("I", -100000.0, 100000.0, "meter")),
            ("MapCenterY", rt.real("I", -100000.0, 100000.0, "meter")),
            ("MapRotation", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        map_center_x_, map_center_y_, map_rotation_ = _S_2IH.unpack_from(data, at)
        self.map_center_x = -100000.0 + map_center_x_ * 4.656612874161595e-05
        self.map_center_y = -100000.0 + map_center_y_ * 4.656612874161595e-05
        self.map_rotation = -3.141592653589793 + map_rotation_ * 9.587526218325454e-05
        return self, at + 10

    def _write(self, out: bytearray) -> None:
        map_center_x_ = self.map_center_x
        if not -100000.0 <= map_center_x_ <= 100000.0: raise rt.Reject
        near = map_center_x_ * 21474.836475 + 2147483648.0
        map_center_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_center_x_raw_ < 0.9999847412109375: map_center_x_raw_ = rt.exact_raw(map_center_x_, _R_4)
        map_center_y_ = self.map_center_y
        if not -100000.0 <= map_center_y_ <= 100000.0: raise rt.Reject
        near = map_center_y_ * 21474.836475 + 2147483648.0
        map_center_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_center_y_raw_ < 0.9999847412109375: map_center_y_raw_ = rt.exact_raw(map_center_y_, _R_4)
        map_rotation_ = self.map_rotation
        if not -3.141592653589793 <= map_rotation_ <= 3.141592653589793: raise rt.Reject
        near = map_rotation_ * 10430.219195527361 + 32768.0
        map_rotation_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_rotation_raw_ < 0.9999847412109375: map_rotation_raw_ = rt.exact_raw(map_rotation_, _R_3)
        out += _S_2IH.pack(map_center_x_raw_, map_center_y_raw_, map_rotation_raw_)


@dataclass(slots=True, repr=False)
class GlobalVertexRec(rt.Struct):
    """GlobalVertexRec.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    """

    latitude: float
    longitude: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
        )


@dataclass(slots=True, repr=False)
class LocalVertexRec(rt.Struct):
    """LocalVertexRec.

    x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    """

    x: float
    y: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("Y", rt.real("I", -100000.0, 100000.0, "meter")),
        )


@dataclass(slots=True, repr=False)
class CostMap2DRec(rt.Struct):
    """CostMap2DRec.

    number_of_rows: Cells in each column
    number_of_columns: Cells in each row
    map_width: 0..10000 meter. Size along the rows, in metres
    map_height: 0..10000 meter. Size along the columns, in metres
    """

    number_of_rows: int
    number_of_columns: int
    map_width: float
    map_height: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NumberOfRows", rt.Number("H")),
            ("NumberOfColumns", rt.Number("H")),
            ("MapWidth", rt.real("H", 0.0, 10000.0, "meter")),
            ("MapHeight", rt.real("H", 0.0, 10000.0, "meter")),
        )


@dataclass(slots=True, repr=False)
class CostDataRec(rt.Struct):
    """CostDataRec.

    cost: 0..254 or 255..255. Cost of the cell from 0 to 254; higher is harder to drive. 255 is outside of this scale
    """

    cost: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Cost", rt.Number("B", rt.Values(None, ((0, 254), (255, 255))))),
        )


@dataclass(slots=True, repr=False)
class CostAndConfidenceDataRec(rt.Struct):
    """CostAndConfidenceDataRec.

    cost: 0..254. Cost of the cell from 0 to 254; higher is harder to drive
    confidence: 0..100. How certain the cost is, in percent
    """

    cost: int
    confidence: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Cost", rt.Number("B", rt.Values(None, ((0, 254),)))),
            ("Confidence", rt.real("B", 0.0, 100.0)),
        )


@dataclass(slots=True, repr=False)
class RunLengthEncodedDataRec(rt.Struct):
    """RunLengthEncodedDataRec.

    cost_and_run_length: A run of cells with equal cost
    """

    class CertaintySubField(IntEnum):
        """Values of CertaintySubField."""

        UNKNOWN = 0
        KNOWN = 1

    @dataclass(slots=True, repr=False)
    class CostAndRunLength(rt.Struct):
        """A run of cells with equal cost.

        cost_sub_field: bits 0..2. Cost of the cells.
        certainty_sub_field: bit 3. Whether the cost is known.
        number_cells_sub_field: bits 4..15. Number of cells.
        """

        cost_sub_field: int
        certainty_sub_field: RunLengthEncodedDataRec.CertaintySubField | int
        number_cells_sub_field: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "H",
                (
                    rt.Bit("cost_sub_field", 0, 0x7, rt.Values(None, ((0, 7),))),
                    rt.Bit("certainty_sub_field", 3, 0x1, rt.Values(RunLengthEncodedDataRec.CertaintySubField)),
                    rt.Bit("number_cells_sub_field", 4, 0xFFF, rt.Values(None, ((0, 4095),))),
                ),
            )

    cost_and_run_length: RunLengthEncodedDataRec.CostAndRunLength

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("CostAndRunLength", RunLengthEncodedDataRec.CostAndRunLength.layout()),
        )


@dataclass(slots=True, repr=False)
class DigitalResourceEndpointRec(rt.Struct):
    """DigitalResourceEndpointRec.

    server_type: ServerType. Protocol for fetching it
    server_url: up to 255 characters. Where to fetch it
    jaus_id: optional. The component that the stream or file belongs to
    resource_id: optional. Number of the resource in its component, as a sensor has one
    """

    class ServerType(IntEnum):
        """Values of ServerType."""

        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7

    server_type: DigitalResourceEndpointRec.ServerType | int
    server_url: str
    jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = None
    resource_id: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("ServerType", rt.Number("B", rt.Values(DigitalResourceEndpointRec.ServerType))),
            ("ServerURL", rt.Text(count=rt.Count("B", 0, 255))),
            ("JAUS_ID", environment_sensing_v1_0_types.JAUS_ID.layout(), True),
            ("ResourceID", rt.Number("H"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        server_type_ = data[at + 1]
        self.server_type = _E_DigitalResourceEndpointRec_ServerType[server_type_]
        server_url_end_ = at + 3 + data[at + 2]
        self.server_url = data[at + 3:server_url_end_].decode("latin-1")
        packer = _M_iop_v1_0_types_DigitalResourceEndpointRec_2[mask & 0x3]
        raw = iter(packer.unpack_from(data, server_url_end_)).__next__
        at = server_url_end_ + packer.size
        if mask & 1:
            jaus_id_ = raw()
            self.jaus_id = environment_sensing_v1_0_types.JAUS_ID(jaus_id_ & 0xFF, jaus_id_ >> 8 & 0xFF, jaus_id_ >> 16 & 0xFFFF)
        else: self.jaus_id = None
        self.resource_id = raw() if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        server_type_ = self.server_type
        if server_type_ not in _E_DigitalResourceEndpointRec_ServerType: raise rt.Reject
        out.append(server_type_)
        server_url_raw_ = self.server_url.encode("latin-1")
        out.append(len(server_url_raw_))
        out += server_url_raw_
        raw: list[int | float | bytes] = []
        jaus_id_ = self.jaus_id
        if jaus_id_ is not None:
            mask |= 1
            if type(jaus_id_) is not environment_sensing_v1_0_types.JAUS_ID: raise rt.Reject
            component_id_ = jaus_id_.component_id
            if not 0 <= component_id_ <= 255: raise rt.Reject
            node_id_ = jaus_id_.node_id
            if not 0 <= node_id_ <= 255: raise rt.Reject
            subsystem_id_ = jaus_id_.subsystem_id
            if not 0 <= subsystem_id_ <= 65535: raise rt.Reject
            raw.append(component_id_ | node_id_ << 8 | subsystem_id_ << 16)
        resource_id_ = self.resource_id
        if resource_id_ is not None:
            mask |= 2
            raw.append(resource_id_)
        out += _M_iop_v1_0_types_DigitalResourceEndpointRec_2[mask & 0x3].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReleaseControlRec(rt.Struct):
    """ReleaseControlRec.

    id: Number of the request
    response_code: ResponseCode. Whether the controlling client hands over
    """

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        GRANTED = 0
        DENIED = 1
        WAIT = 2

    id: int
    response_code: ReleaseControlRec.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ID", rt.Number("B")),
            ("ResponseCode", rt.Number("B", rt.Values(ReleaseControlRec.ResponseCode))),
        )


@dataclass(slots=True, repr=False)
class DeviceRec(rt.Struct):
    """DeviceRec.

    device_name: up to 255 characters. Name of the device
    device_designation: up to 255 characters, optional. Type of the device
    classification: up to 255 characters, optional. Kind of the device
    """

    device_name: str
    device_designation: str | None = None
    classification: str | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("DeviceName", rt.Text(count=rt.Count("B", 0, 255))),
            ("DeviceDesignation", rt.Text(count=rt.Count("B", 0, 255)), True),
            ("Classification", rt.Text(count=rt.Count("B", 0, 255)), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        device_name_end_ = at + 2 + data[at + 1]
        self.device_name = data[at + 2:device_name_end_].decode("latin-1")
        at = device_name_end_
        if mask & 1:
            device_designation_end_ = at + 1 + data[at]
            self.device_designation = data[at + 1:device_designation_end_].decode("latin-1")
            at = device_designation_end_
        else: self.device_designation = None
        if mask & 2:
            classification_end_ = at + 1 + data[at]
            self.classification = data[at + 1:classification_end_].decode("latin-1")
            at = classification_end_
        else: self.classification = None
        self.reserved_presence = mask & 0xFC
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        device_name_raw_ = self.device_name.encode("latin-1")
        out.append(len(device_name_raw_))
        out += device_name_raw_
        device_designation_ = self.device_designation
        if device_designation_ is not None:
            mask |= 1
            device_designation_raw_ = device_designation_.encode("latin-1")
            out.append(len(device_designation_raw_))
            out += device_designation_raw_
        classification_ = self.classification
        if classification_ is not None:
            mask |= 2
            classification_raw_ = classification_.encode("latin-1")
            out.append(len(classification_raw_))
            out += classification_raw_
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReadingRec(rt.Struct):
    """ReadingRec.

    sensor: up to 255 characters. Name of the sensor
    source: up to 255 characters. What is measured
    type: up to 255 characters. Kind of reading
    unit: up to 255 characters, optional. Unit of the values
    minimum: optional. Smallest reading
    avarage: optional. Mean of the readings
    maximum: optional. Largest reading
    alert_level: AlertLevel, optional. How serious the reading is
    alert_explanation: up to 255 characters, optional. Why there is an alert, for people
    extended_info: up to 255 characters, optional. What else there is to say
    """

    class AlertLevel(IntEnum):
        """Values of AlertLevel."""

        NO_ALERT = 0
        LOW = 1
        MIDDLE = 2
        HIGHT = 3
        NOT_SUPPORTED = 255

    sensor: str
    source: str
    type: str
    unit: str | None = None
    minimum: int | None = None
    avarage: int | None = None
    maximum: int | None = None
    alert_level: ReadingRec.AlertLevel | int | None = None
    alert_explanation: str | None = None
    extended_info: str | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Sensor", rt.Text(count=rt.Count("B", 0, 255))),
            ("Source", rt.Text(count=rt.Count("B", 0, 255))),
            ("Type", rt.Text(count=rt.Count("B", 0, 255))),
            ("Unit", rt.Text(count=rt.Count("B", 0, 255)), True),
            ("Minimum", rt.Number("B"), True),
            ("Avarage", rt.Number("B"), True),
            ("Maximum", rt.Number("B"), True),
            ("AlertLevel", rt.Number("B", rt.Values(ReadingRec.AlertLevel)), True),
            ("AlertExplanation", rt.Text(count=rt.Count("B", 0, 255)), True),
            ("ExtendedInfo", rt.Text(count=rt.Count("B", 0, 255)), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        sensor_end_ = at + 2 + data[at + 1]
        self.sensor = data[at + 2:sensor_end_].decode("latin-1")
        source_end_ = sensor_end_ + 1 + data[sensor_end_]
        self.source = data[sensor_end_ + 1:source_end_].decode("latin-1")
        type_end_ = source_end_ + 1 + data[source_end_]
        self.type = data[source_end_ + 1:type_end_].decode("latin-1")
        at = type_end_
        if mask & 1:
            unit_end_ = at + 1 + data[at]
            self.unit = data[at + 1:unit_end_].decode("latin-1")
            at = unit_end_
        else: self.unit = None
        packer = _M_iop_v1_0_types_ReadingRec_4[mask & 0x1E]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.minimum = raw() if mask & 2 else None
        self.avarage = raw() if mask & 4 else None
        self.maximum = raw() if mask & 8 else None
        if mask & 16:
            alert_level_ = raw()
            self.alert_level = _E_ReadingRec_AlertLevel[alert_level_]
        else: self.alert_level = None
        if mask & 32:
            alert_explanation_end_ = at + 1 + data[at]
            self.alert_explanation = data[at + 1:alert_explanation_end_].decode("latin-1")
            at = alert_explanation_end_
        else: self.alert_explanation = None
        if mask & 64:
            extended_info_end_ = at + 1 + data[at]
            self.extended_info = data[at + 1:extended_info_end_].decode("latin-1")
            at = extended_info_end_
        else: self.extended_info = None
        self.reserved_presence = mask & 0x80
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7F: raise rt.Reject
        sensor_raw_ = self.sensor.encode("latin-1")
        out.append(len(sensor_raw_))
        out += sensor_raw_
        source_raw_ = self.source.encode("latin-1")
        out.append(len(source_raw_))
        out += source_raw_
        type_raw_ = self.type.encode("latin-1")
        out.append(len(type_raw_))
        out += type_raw_
        unit_ = self.unit
        if unit_ is not None:
            mask |= 1
            unit_raw_ = unit_.encode("latin-1")
            out.append(len(unit_raw_))
            out += unit_raw_
        raw: list[int | float | bytes] = []
        minimum_ = self.minimum
        if minimum_ is not None:
            mask |= 2
            raw.append(minimum_)
        avarage_ = self.avarage
        if avarage_ is not None:
            mask |= 4
            raw.append(avarage_)
        maximum_ = self.maximum
        if maximum_ is not None:
            mask |= 8
            raw.append(maximum_)
        alert_level_ = self.alert_level
        if alert_level_ is not None:
            mask |= 16
            if alert_level_ not in _E_ReadingRec_AlertLevel: raise rt.Reject
            raw.append(alert_level_)
        out += _M_iop_v1_0_types_ReadingRec_4[mask & 0x1E].pack(*raw)
        alert_explanation_ = self.alert_explanation
        if alert_explanation_ is not None:
            mask |= 32
            alert_explanation_raw_ = alert_explanation_.encode("latin-1")
            out.append(len(alert_explanation_raw_))
            out += alert_explanation_raw_
        extended_info_ = self.extended_info
        if extended_info_ is not None:
            mask |= 64
            extended_info_raw_ = extended_info_.encode("latin-1")
            out.append(len(extended_info_raw_))
            out += extended_info_raw_
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ValueRec(rt.Struct):
    """ValueRec.

    value: -10000..10000. One value
    """

    value: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Value", rt.real("I", -10000.0, 10000.0)),
        )


@dataclass(slots=True, repr=False)
class GlobalPoseRec(rt.Struct):
    """GlobalPoseRec.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    """

    latitude: float | None = None
    longitude: float | None = None
    altitude: float | None = None
    position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    attitude_rms: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree"), True),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree"), True),
            ("Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Position_RMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_iop_v1_0_types_GlobalPoseRec_0[mask & 0xFF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
        self.longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
        self.altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 4 else None
        self.position_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        self.yaw = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 128 else None
        self.reserved_presence = mask & 0xFF00
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0xFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if latitude_ is not None:
            mask |= 1
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_1)
            raw.append(latitude_raw_)
        longitude_ = self.longitude
        if longitude_ is not None:
            mask |= 2
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_2)
            raw.append(longitude_raw_)
        altitude_ = self.altitude
        if altitude_ is not None:
            mask |= 4
            if not -10000.0 <= altitude_ <= 35000.0: raise rt.Reject
            near = altitude_ * 95443.71766666666 + 954437177.1666666
            altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_raw_ < 0.9999847412109375: altitude_raw_ = rt.exact_raw(altitude_, _R_12)
            raw.append(altitude_raw_)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0: raise rt.Reject
            near = position_rms_ * 42949672.95 + 0.5
            position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_rms_raw_ < 0.9999847412109375: position_rms_raw_ = rt.exact_raw(position_rms_, _R_13)
            raw.append(position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_3)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_3)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_3)
            raw.append(yaw_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_14)
            raw.append(attitude_rms_raw_)
        out += _M_iop_v1_0_types_GlobalPoseRec_0[mask & 0xFF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class TimestampRec(rt.Struct):
    """TimestampRec.

    time_stamp: Time within the month, in UTC
    """

    time_stamp: core_v1_0_types.TimeStamp

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("TimeStamp", core_v1_0_types.TimeStamp.layout()),
        )


@dataclass(slots=True, repr=False)
class PathReporterCapabilitiesRec(rt.Struct):
    """PathReporterCapabilitiesRec.

    path_type: PathType. Whether the path was travelled or is planned, and its frame
    min_target_resolution: 0..10000 meter, optional. Smallest distance of points, in metres
    max_target_resolution: 0..10000 meter, optional. Largest distance of points, in metres
    maximum_points: optional. Largest number of points
    maximum_distance: in meter, optional. Largest length of the path, in metres
    maximum_time: in second, optional. Longest time that the path covers, in seconds
    """

    class PathType(IntEnum):
        """Values of PathType."""

        HISTORICAL_GLOBAL_PATH = 0
        HISTORICAL_LOCAL_PATH = 1
        PLANNED_GLOBAL_PATH = 2
        PLANNED_LOCAL_PATH = 3

    path_type: PathReporterCapabilitiesRec.PathType | int
    min_target_resolution: float | None = None
    max_target_resolution: float | None = None
    maximum_points: int | None = None
    maximum_distance: int | None = None
    maximum_time: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("PathType", rt.Number("B", rt.Values(PathReporterCapabilitiesRec.PathType))),
            ("MinTargetResolution", rt.real("H", 0.0, 10000.0, "meter"), True),
            ("MaxTargetResolution", rt.real("H", 0.0, 10000.0, "meter"), True),
            ("MaximumPoints", rt.Number("H"), True),
            ("MaximumDistance", rt.Number("I", rt.ANY, "meter"), True),
            ("MaximumTime", rt.Number("I", rt.ANY, "second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_iop_v1_0_types_PathReporterCapabilitiesRec_0[mask & 0x1F]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        path_type_ = raw()
        self.path_type = _E_PathReporterCapabilitiesRec_PathType[path_type_]
        self.min_target_resolution = raw() * 0.15259021896696423 if mask & 1 else None
        self.max_target_resolution = raw() * 0.15259021896696423 if mask & 2 else None
        self.maximum_points = raw() if mask & 4 else None
        self.maximum_distance = raw() if mask & 8 else None
        self.maximum_time = raw() if mask & 16 else None
        self.reserved_presence = mask & 0xE0
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        raw: list[int | float | bytes] = []
        path_type_ = self.path_type
        if path_type_ not in _E_PathReporterCapabilitiesRec_PathType: raise rt.Reject
        raw.append(path_type_)
        min_target_resolution_ = self.min_target_resolution
        if min_target_resolution_ is not None:
            mask |= 1
            if not 0.0 <= min_target_resolution_ <= 10000.0: raise rt.Reject
            near = min_target_resolution_ * 6.5535 + 0.5
            min_target_resolution_raw_ = int(near)
            if not 1.52587890625e-05 < near - min_target_resolution_raw_ < 0.9999847412109375: min_target_resolution_raw_ = rt.exact_raw(min_target_resolution_, _R_17)
            raw.append(min_target_resolution_raw_)
        max_target_resolution_ = self.max_target_resolution
        if max_target_resolution_ is not None:
            mask |= 2
            if not 0.0 <= max_target_resolution_ <= 10000.0: raise rt.Reject
            near = max_target_resolution_ * 6.5535 + 0.5
            max_target_resolution_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_target_resolution_raw_ < 0.9999847412109375: max_target_resolution_raw_ = rt.exact_raw(max_target_resolution_, _R_17)
            raw.append(max_target_resolution_raw_)
        maximum_points_ = self.maximum_points
        if maximum_points_ is not None:
            mask |= 4
            raw.append(maximum_points_)
        maximum_distance_ = self.maximum_distance
        if maximum_distance_ is not None:
            mask |= 8
            raw.append(maximum_distance_)
        maximum_time_ = self.maximum_time
        if maximum_time_ is not None:
            mask |= 16
            raw.append(maximum_time_)
        out += _M_iop_v1_0_types_PathReporterCapabilitiesRec_0[mask & 0x1F].pack(*raw)
        _S_B.pack_into(out, start, mask)


_S_2IH = rt.Packer("<2IH")
_R_1 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_2 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_3 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_4 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_E_DigitalResourceEndpointRec_ServerType = rt.members(DigitalResourceEndpointRec.ServerType)
_M_iop_v1_0_types_DigitalResourceEndpointRec_2 = rt.Masks("", ((1, "I"), (2, "H")))
_S_B = rt.Packer("<B")
_M_iop_v1_0_types_ReadingRec_4 = rt.Masks("", ((2, "B"), (4, "B"), (8, "B"), (16, "B")))
_E_ReadingRec_AlertLevel = rt.members(ReadingRec.AlertLevel)
_S_H = rt.Packer("<H")
_M_iop_v1_0_types_GlobalPoseRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H")))
_R_12 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_13 = rt.Scaling(0.0, 100.0, 4294967295)
_R_14 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_iop_v1_0_types_PathReporterCapabilitiesRec_0 = rt.Masks("", ((0, "B"), (1, "H"), (2, "H"), (4, "H"), (8, "I"), (16, "I")))
_E_PathReporterCapabilitiesRec_PathType = rt.members(PathReporterCapabilitiesRec.PathType)
_R_17 = rt.Scaling(0.0, 10000.0, 65535)
