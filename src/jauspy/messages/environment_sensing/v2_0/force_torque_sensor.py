"""urn:jaus:jss:environmentSensing:ForceTorqueSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryForceTorqueCapabilities(rt.Message):
    """QueryForceTorqueCapabilities (0x280B): Asks for the limits of measurement.

    query_force_torque_capabilities_list: 0..65535 items. The sensors
    """

    CODE = 0x280B
    NAME = "QueryForceTorqueCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:ForceTorqueSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportForceTorqueCapabilities]]

    @dataclass(slots=True, repr=False)
    class QueryForceTorqueCapabilitiesRec(rt.Struct):
        """QueryForceTorqueCapabilitiesRec.

        sensor_id: Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
                ("QueryPresenceVector", rt.Number("H")),
            )

    query_force_torque_capabilities_list: list[QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryForceTorqueCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0B or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_force_torque_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        query_force_torque_capabilities_list_end_ = 4 + query_force_torque_capabilities_list_count_ * 4
        self.query_force_torque_capabilities_list = [QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec(sensor_id_, query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_2H.iter_unpack(data[4:query_force_torque_capabilities_list_end_])]
        if query_force_torque_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0b\x28")
        query_force_torque_capabilities_list_ = self.query_force_torque_capabilities_list
        if type(query_force_torque_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_force_torque_capabilities_list_))
        raw_: list[int | float] = []
        for item_ in query_force_torque_capabilities_list_:
            if type(item_) is not QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec: raise rt.Reject
            raw_ += (item_.sensor_id, item_.query_presence_vector)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryForceTorque(rt.Message):
    """QueryForceTorque (0x280C): Asks for forces and torques.

    query_force_torque_list: 0..65535 items. The sensors
    """

    CODE = 0x280C
    NAME = "QueryForceTorque"
    SERVICE = "urn:jaus:jss:environmentSensing:ForceTorqueSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportForceTorque]]

    class CoordinateSystem(IntEnum):
        """Values of CoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    @dataclass(slots=True, repr=False)
    class QueryForceTorqueRec(rt.Struct):
        """QueryForceTorqueRec.

        sensor_id: Which sensor is meant; 0 is all
        coordinate_system: CoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: int
        coordinate_system: QueryForceTorque.CoordinateSystem | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
                ("CoordinateSystem", rt.Number("B", rt.Values(QueryForceTorque.CoordinateSystem))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_force_torque_list: list[QueryForceTorque.QueryForceTorqueRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryForceTorqueList", rt.Repeat(rt.Count("H", 0, 65535), QueryForceTorque.QueryForceTorqueRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0C or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_force_torque_list_count_,) = _S_H.unpack_from(data, 2)
        query_force_torque_list_end_ = 4 + query_force_torque_list_count_ * 4
        self.query_force_torque_list = [QueryForceTorque.QueryForceTorqueRec(sensor_id_, _E_QueryForceTorque_CoordinateSystem[coordinate_system_], query_presence_vector_) for sensor_id_, coordinate_system_, query_presence_vector_ in _S_H2B.iter_unpack(data[4:query_force_torque_list_end_])]
        if query_force_torque_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0c\x28")
        query_force_torque_list_ = self.query_force_torque_list
        if type(query_force_torque_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_force_torque_list_))
        for item_ in query_force_torque_list_:
            if type(item_) is not QueryForceTorque.QueryForceTorqueRec: raise rt.Reject
            coordinate_system_ = item_.coordinate_system
            if coordinate_system_ not in _E_QueryForceTorque_CoordinateSystem: raise rt.Reject
            out += _S_H2B.pack(item_.sensor_id, coordinate_system_, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportForceTorqueCapabilities(rt.Message):
    """ReportForceTorqueCapabilities (0x480B): Tells the limits of measurement.

    report_force_torque_capabilities_list: 0..65535 items. The sensors
    """

    CODE = 0x480B
    NAME = "ReportForceTorqueCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:ForceTorqueSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class CoordinateTransformSupported(IntEnum):
        """Values of CoordinateTransformSupported."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False)
    class ReportForceTorqueCapabilitiesRec(rt.Struct):
        """ReportForceTorqueCapabilitiesRec.

        sensor_id: Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        coordinate_transform_supported: CoordinateTransformSupported, optional. Whether the sensor can report in the frame of the vehicle
        min_force_x: -5000..5000 newton, optional. Smallest force along X, in newtons
        max_force_x: -5000..5000 newton, optional. Largest force along X, in newtons
        min_force_y: -5000..5000 newton, optional. Smallest force along Y, in newtons
        max_force_y: -5000..5000 newton, optional. Largest force along Y, in newtons
        min_force_z: -5000..5000 newton, optional. Smallest force along Z, in newtons
        max_force_z: -5000..5000 newton, optional. Largest force along Z, in newtons
        min_torque_x: -5000..5000 newton meter, optional. Smallest torque about X, in newton metres
        max_torque_x: -5000..5000 newton meter, optional. Largest torque about X, in newton metres
        min_torque_y: -5000..5000 newton meter, optional. Smallest torque about Y, in newton metres
        max_torque_y: -5000..5000 newton meter, optional. Largest torque about Y, in newton metres
        min_torque_z: -5000..5000 newton meter, optional. Smallest torque about Z, in newton metres
        max_torque_z: -5000..5000 newton meter, optional. Largest torque about Z, in newton metres
        """

        sensor_id: int
        sensor_name: str
        coordinate_transform_supported: ReportForceTorqueCapabilities.CoordinateTransformSupported | int | None = None
        min_force_x: float | None = None
        max_force_x: float | None = None
        min_force_y: float | None = None
        max_force_y: float | None = None
        min_force_z: float | None = None
        max_force_z: float | None = None
        min_torque_x: float | None = None
        max_torque_x: float | None = None
        min_torque_y: float | None = None
        max_torque_y: float | None = None
        min_torque_z: float | None = None
        max_torque_z: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("SensorID", rt.Number("H")),
                ("SensorName", rt.Text(count=rt.Count("B", 0, 255))),
                ("CoordinateTransformSupported", rt.Number("B", rt.Values(ReportForceTorqueCapabilities.CoordinateTransformSupported)), True),
                ("MinForceX", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MaxForceX", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MinForceY", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MaxForceY", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MinForceZ", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MaxForceZ", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("MinTorqueX", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("MaxTorqueX", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("MinTorqueY", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("MaxTorqueY", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("MinTorqueZ", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("MaxTorqueZ", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            (self.sensor_id,) = _S_H.unpack_from(data, at + 2)
            sensor_name_end_ = at + 5 + data[at + 4]
            self.sensor_name = data[at + 5:sensor_name_end_].decode("latin-1")
            packer = _M_ReportForceTorqueCapabilities_ReportForceTorqueCapabilitiesRec_2[mask & 0x1FFF]
            raw = iter(packer.unpack_from(data, sensor_name_end_)).__next__
            at = sensor_name_end_ + packer.size
            if mask & 1:
                coordinate_transform_supported_ = raw()
                self.coordinate_transform_supported = _E_ReportForceTorqueCapabilities_CoordinateTransformSupported[coordinate_transform_supported_]
            else: self.coordinate_transform_supported = None
            self.min_force_x = -5000.0 + raw() * 0.15259021896696423 if mask & 2 else None
            self.max_force_x = -5000.0 + raw() * 0.15259021896696423 if mask & 4 else None
            self.min_force_y = -5000.0 + raw() * 0.15259021896696423 if mask & 8 else None
            self.max_force_y = -5000.0 + raw() * 0.15259021896696423 if mask & 16 else None
            self.min_force_z = -5000.0 + raw() * 0.15259021896696423 if mask & 32 else None
            self.max_force_z = -5000.0 + raw() * 0.15259021896696423 if mask & 64 else None
            self.min_torque_x = -5000.0 + raw() * 0.15259021896696423 if mask & 128 else None
            self.max_torque_x = -5000.0 + raw() * 0.15259021896696423 if mask & 256 else None
            self.min_torque_y = -5000.0 + raw() * 0.15259021896696423 if mask & 512 else None
            self.max_torque_y = -5000.0 + raw() * 0.15259021896696423 if mask & 1024 else None
            self.min_torque_z = -5000.0 + raw() * 0.15259021896696423 if mask & 2048 else None
            self.max_torque_z = -5000.0 + raw() * 0.15259021896696423 if mask & 4096 else None
            self.reserved_presence = mask & 0xE000
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = self.reserved_presence
            if mask & 0x1FFF: raise rt.Reject
            out += _S_H.pack(self.sensor_id)
            sensor_name_raw_ = self.sensor_name.encode("latin-1")
            out.append(len(sensor_name_raw_))
            out += sensor_name_raw_
            raw: list[int | float | bytes] = []
            coordinate_transform_supported_ = self.coordinate_transform_supported
            if coordinate_transform_supported_ is not None:
                mask |= 1
                if coordinate_transform_supported_ not in _E_ReportForceTorqueCapabilities_CoordinateTransformSupported: raise rt.Reject
                raw.append(coordinate_transform_supported_)
            min_force_x_ = self.min_force_x
            if min_force_x_ is not None:
                mask |= 2
                if not -5000.0 <= min_force_x_ <= 5000.0: raise rt.Reject
                near = min_force_x_ * 6.5535 + 32768.0
                min_force_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_force_x_raw_ < 0.9999847412109375: min_force_x_raw_ = rt.exact_raw(min_force_x_, _R_7)
                raw.append(min_force_x_raw_)
            max_force_x_ = self.max_force_x
            if max_force_x_ is not None:
                mask |= 4
                if not -5000.0 <= max_force_x_ <= 5000.0: raise rt.Reject
                near = max_force_x_ * 6.5535 + 32768.0
                max_force_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_force_x_raw_ < 0.9999847412109375: max_force_x_raw_ = rt.exact_raw(max_force_x_, _R_7)
                raw.append(max_force_x_raw_)
            min_force_y_ = self.min_force_y
            if min_force_y_ is not None:
                mask |= 8
                if not -5000.0 <= min_force_y_ <= 5000.0: raise rt.Reject
                near = min_force_y_ * 6.5535 + 32768.0
                min_force_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_force_y_raw_ < 0.9999847412109375: min_force_y_raw_ = rt.exact_raw(min_force_y_, _R_7)
                raw.append(min_force_y_raw_)
            max_force_y_ = self.max_force_y
            if max_force_y_ is not None:
                mask |= 16
                if not -5000.0 <= max_force_y_ <= 5000.0: raise rt.Reject
                near = max_force_y_ * 6.5535 + 32768.0
                max_force_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_force_y_raw_ < 0.9999847412109375: max_force_y_raw_ = rt.exact_raw(max_force_y_, _R_7)
                raw.append(max_force_y_raw_)
            min_force_z_ = self.min_force_z
            if min_force_z_ is not None:
                mask |= 32
                if not -5000.0 <= min_force_z_ <= 5000.0: raise rt.Reject
                near = min_force_z_ * 6.5535 + 32768.0
                min_force_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_force_z_raw_ < 0.9999847412109375: min_force_z_raw_ = rt.exact_raw(min_force_z_, _R_7)
                raw.append(min_force_z_raw_)
            max_force_z_ = self.max_force_z
            if max_force_z_ is not None:
                mask |= 64
                if not -5000.0 <= max_force_z_ <= 5000.0: raise rt.Reject
                near = max_force_z_ * 6.5535 + 32768.0
                max_force_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_force_z_raw_ < 0.9999847412109375: max_force_z_raw_ = rt.exact_raw(max_force_z_, _R_7)
                raw.append(max_force_z_raw_)
            min_torque_x_ = self.min_torque_x
            if min_torque_x_ is not None:
                mask |= 128
                if not -5000.0 <= min_torque_x_ <= 5000.0: raise rt.Reject
                near = min_torque_x_ * 6.5535 + 32768.0
                min_torque_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_torque_x_raw_ < 0.9999847412109375: min_torque_x_raw_ = rt.exact_raw(min_torque_x_, _R_7)
                raw.append(min_torque_x_raw_)
            max_torque_x_ = self.max_torque_x
            if max_torque_x_ is not None:
                mask |= 256
                if not -5000.0 <= max_torque_x_ <= 5000.0: raise rt.Reject
                near = max_torque_x_ * 6.5535 + 32768.0
                max_torque_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_torque_x_raw_ < 0.9999847412109375: max_torque_x_raw_ = rt.exact_raw(max_torque_x_, _R_7)
                raw.append(max_torque_x_raw_)
            min_torque_y_ = self.min_torque_y
            if min_torque_y_ is not None:
                mask |= 512
                if not -5000.0 <= min_torque_y_ <= 5000.0: raise rt.Reject
                near = min_torque_y_ * 6.5535 + 32768.0
                min_torque_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_torque_y_raw_ < 0.9999847412109375: min_torque_y_raw_ = rt.exact_raw(min_torque_y_, _R_7)
                raw.append(min_torque_y_raw_)
            max_torque_y_ = self.max_torque_y
            if max_torque_y_ is not None:
                mask |= 1024
                if not -5000.0 <= max_torque_y_ <= 5000.0: raise rt.Reject
                near = max_torque_y_ * 6.5535 + 32768.0
                max_torque_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_torque_y_raw_ < 0.9999847412109375: max_torque_y_raw_ = rt.exact_raw(max_torque_y_, _R_7)
                raw.append(max_torque_y_raw_)
            min_torque_z_ = self.min_torque_z
            if min_torque_z_ is not None:
                mask |= 2048
                if not -5000.0 <= min_torque_z_ <= 5000.0: raise rt.Reject
                near = min_torque_z_ * 6.5535 + 32768.0
                min_torque_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_torque_z_raw_ < 0.9999847412109375: min_torque_z_raw_ = rt.exact_raw(min_torque_z_, _R_7)
                raw.append(min_torque_z_raw_)
            max_torque_z_ = self.max_torque_z
            if max_torque_z_ is not None:
                mask |= 4096
                if not -5000.0 <= max_torque_z_ <= 5000.0: raise rt.Reject
                near = max_torque_z_ * 6.5535 + 32768.0
                max_torque_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_torque_z_raw_ < 0.9999847412109375: max_torque_z_raw_ = rt.exact_raw(max_torque_z_, _R_7)
                raw.append(max_torque_z_raw_)
            out += _M_ReportForceTorqueCapabilities_ReportForceTorqueCapabilitiesRec_2[mask & 0x1FFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    report_force_torque_capabilities_list: list[ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReportForceTorqueCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0B or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (report_force_torque_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if report_force_torque_capabilities_list_count_ * 5 > size - 4: raise rt.Reject
        at = 4
        report_force_torque_capabilities_list_ = []
        for _ in range(report_force_torque_capabilities_list_count_):
            item_, at = ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec._read(data, at, nesting)
            report_force_torque_capabilities_list_.append(item_)
        self.report_force_torque_capabilities_list = report_force_torque_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0b\x48")
        report_force_torque_capabilities_list_ = self.report_force_torque_capabilities_list
        if type(report_force_torque_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(report_force_torque_capabilities_list_))
        for item_ in report_force_torque_capabilities_list_:
            if type(item_) is not ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportForceTorque(rt.Message):
    """ReportForceTorque (0x480C): Tells forces and torques.

    report_force_torque_list: 0..65535 items. The sensors
    """

    CODE = 0x480C
    NAME = "ReportForceTorque"
    SERVICE = "urn:jaus:jss:environmentSensing:ForceTorqueSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class CoordinateSystem(IntEnum):
        """Values of CoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    @dataclass(slots=True, repr=False)
    class ReportForceTorqueRec(rt.Struct):
        """ReportForceTorqueRec.

        sensor_id: Identifies the sensor
        coordinate_system: CoordinateSystem. Frame of the report
        force_x: -5000..5000 newton, optional. Force along X, in newtons
        force_y: -5000..5000 newton, optional. Force along Y, in newtons
        force_z: -5000..5000 newton, optional. Force along Z, in newtons
        torque_x: -5000..5000 newton meter, optional. Torque about X, in newton metres
        torque_y: -5000..5000 newton meter, optional. Torque about Y, in newton metres
        torque_z: -5000..5000 newton meter, optional. Torque about Z, in newton metres
        """

        sensor_id: int
        coordinate_system: ReportForceTorque.CoordinateSystem | int
        force_x: float | None = None
        force_y: float | None = None
        force_z: float | None = None
        torque_x: float | None = None
        torque_y: float | None = None
        torque_z: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H")),
                ("CoordinateSystem", rt.Number("B", rt.Values(ReportForceTorque.CoordinateSystem))),
                ("ForceX", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("ForceY", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("ForceZ", rt.real("H", -5000.0, 5000.0, "newton"), True),
                ("TorqueX", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("TorqueY", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
                ("TorqueZ", rt.real("H", -5000.0, 5000.0, "newton meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportForceTorque_ReportForceTorqueRec_0[mask & 0x3F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.sensor_id = raw()
            coordinate_system_ = raw()
            self.coordinate_system = _E_ReportForceTorque_CoordinateSystem[coordinate_system_]
            self.force_x = -5000.0 + raw() * 0.15259021896696423 if mask & 1 else None
            self.force_y = -5000.0 + raw() * 0.15259021896696423 if mask & 2 else None
            self.force_z = -5000.0 + raw() * 0.15259021896696423 if mask & 4 else None
            self.torque_x = -5000.0 + raw() * 0.15259021896696423 if mask & 8 else None
            self.torque_y = -5000.0 + raw() * 0.15259021896696423 if mask & 16 else None
            self.torque_z = -5000.0 + raw() * 0.15259021896696423 if mask & 32 else None
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            coordinate_system_ = self.coordinate_system
            if coordinate_system_ not in _E_ReportForceTorque_CoordinateSystem: raise rt.Reject
            raw.append(coordinate_system_)
            force_x_ = self.force_x
            if force_x_ is not None:
                mask |= 1
                if not -5000.0 <= force_x_ <= 5000.0: raise rt.Reject
                near = force_x_ * 6.5535 + 32768.0
                force_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - force_x_raw_ < 0.9999847412109375: force_x_raw_ = rt.exact_raw(force_x_, _R_7)
                raw.append(force_x_raw_)
            force_y_ = self.force_y
            if force_y_ is not None:
                mask |= 2
                if not -5000.0 <= force_y_ <= 5000.0: raise rt.Reject
                near = force_y_ * 6.5535 + 32768.0
                force_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - force_y_raw_ < 0.9999847412109375: force_y_raw_ = rt.exact_raw(force_y_, _R_7)
                raw.append(force_y_raw_)
            force_z_ = self.force_z
            if force_z_ is not None:
                mask |= 4
                if not -5000.0 <= force_z_ <= 5000.0: raise rt.Reject
                near = force_z_ * 6.5535 + 32768.0
                force_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - force_z_raw_ < 0.9999847412109375: force_z_raw_ = rt.exact_raw(force_z_, _R_7)
                raw.append(force_z_raw_)
            torque_x_ = self.torque_x
            if torque_x_ is not None:
                mask |= 8
                if not -5000.0 <= torque_x_ <= 5000.0: raise rt.Reject
                near = torque_x_ * 6.5535 + 32768.0
                torque_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - torque_x_raw_ < 0.9999847412109375: torque_x_raw_ = rt.exact_raw(torque_x_, _R_7)
                raw.append(torque_x_raw_)
            torque_y_ = self.torque_y
            if torque_y_ is not None:
                mask |= 16
                if not -5000.0 <= torque_y_ <= 5000.0: raise rt.Reject
                near = torque_y_ * 6.5535 + 32768.0
                torque_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - torque_y_raw_ < 0.9999847412109375: torque_y_raw_ = rt.exact_raw(torque_y_, _R_7)
                raw.append(torque_y_raw_)
            torque_z_ = self.torque_z
            if torque_z_ is not None:
                mask |= 32
                if not -5000.0 <= torque_z_ <= 5000.0: raise rt.Reject
                near = torque_z_ * 6.5535 + 32768.0
                torque_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - torque_z_raw_ < 0.9999847412109375: torque_z_raw_ = rt.exact_raw(torque_z_, _R_7)
                raw.append(torque_z_raw_)
            out += _M_ReportForceTorque_ReportForceTorqueRec_0[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    report_force_torque_list: list[ReportForceTorque.ReportForceTorqueRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReportForceTorqueList", rt.Repeat(rt.Count("H", 0, 65535), ReportForceTorque.ReportForceTorqueRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0C or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (report_force_torque_list_count_,) = _S_H.unpack_from(data, 2)
        if report_force_torque_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        report_force_torque_list_ = []
        for _ in range(report_force_torque_list_count_):
            item_, at = ReportForceTorque.ReportForceTorqueRec._read(data, at, nesting)
            report_force_torque_list_.append(item_)
        self.report_force_torque_list = report_force_torque_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0c\x48")
        report_force_torque_list_ = self.report_force_torque_list
        if type(report_force_torque_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(report_force_torque_list_))
        for item_ in report_force_torque_list_:
            if type(item_) is not ReportForceTorque.ReportForceTorqueRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
_L_H = rt.Rows("H")
_E_QueryForceTorque_CoordinateSystem = rt.members(QueryForceTorque.CoordinateSystem)
_S_H2B = rt.Packer("<H2B")
_M_ReportForceTorqueCapabilities_ReportForceTorqueCapabilitiesRec_2 = rt.Masks("", ((1, "B"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H")))
_E_ReportForceTorqueCapabilities_CoordinateTransformSupported = rt.members(ReportForceTorqueCapabilities.CoordinateTransformSupported)
_R_7 = rt.Scaling(-5000.0, 5000.0, 65535)
_M_ReportForceTorque_ReportForceTorqueRec_0 = rt.Masks("", ((0, "H"), (0, "B"), (1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H")))
_E_ReportForceTorque_CoordinateSystem = rt.members(ReportForceTorque.CoordinateSystem)
_S_B = rt.Packer("<B")
QueryForceTorqueCapabilities.REPORT = ReportForceTorqueCapabilities
QueryForceTorque.REPORT = ReportForceTorque
