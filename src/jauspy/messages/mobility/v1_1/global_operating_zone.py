"""urn:jaus:jss:mobility:GlobalOperatingZone 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class SetGlobalOperatingZone(rt.Message):
    """SetGlobalOperatingZone (0x0423): Sets the zone on the globe to stay in and those to keep out of.

    global_operating_zone: 0..255 items. Corners of the zone to stay in
    global_exclusion_zones: 0..255 items. The zones to keep out of
    """

    CODE = 0x0423
    NAME = "SetGlobalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class MinZPositionChoice(IntEnum):
        """Values of MinZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class MinZPosition(rt.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: SetGlobalOperatingZone.MinZPositionChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.real("I", -50000.0, 50000.0, "meter"),
                    1: rt.real("I", -50000.0, 50000.0, "meter"),
                    2: rt.real("I", -50000.0, 50000.0, "meter"),
                    3: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(SetGlobalOperatingZone.MinZPositionChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_ * 2.3283064370807974e-05
                at += 5
            elif choice == 1:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
                at += 5
            elif choice == 2:
                (value_3_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
                at += 5
            elif choice == 3:
                (value_4_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_SetGlobalOperatingZone_MinZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_2)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_2)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_2)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    class MaxZPositionChoice(IntEnum):
        """Values of MaxZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class MaxZPosition(rt.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: SetGlobalOperatingZone.MaxZPositionChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.real("I", -50000.0, 50000.0, "meter"),
                    1: rt.real("I", -50000.0, 50000.0, "meter"),
                    2: rt.real("I", -50000.0, 50000.0, "meter"),
                    3: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(SetGlobalOperatingZone.MaxZPositionChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_ * 2.3283064370807974e-05
                at += 5
            elif choice == 1:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
                at += 5
            elif choice == 2:
                (value_3_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
                at += 5
            elif choice == 3:
                (value_4_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_SetGlobalOperatingZone_MaxZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_2)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_2)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_2)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    @dataclass(slots=True, repr=False)
    class GlobalPolygonPointRec(rt.Struct):
        """A corner on the globe with its vertical limits.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """

        latitude: float
        longitude: float
        min_z_position: SetGlobalOperatingZone.MinZPosition | None = None
        max_z_position: SetGlobalOperatingZone.MaxZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
                ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
                ("MinZPosition", SetGlobalOperatingZone.MinZPosition.layout(), True),
                ("MaxZPosition", SetGlobalOperatingZone.MaxZPosition.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            latitude_, longitude_ = _S_2I.unpack_from(data, at + 1)
            self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
            self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
            at += 9
            if mask & 1:
                self.min_z_position, at = SetGlobalOperatingZone.MinZPosition._read(data, at, nesting)
            else: self.min_z_position = None
            if mask & 2:
                self.max_z_position, at = SetGlobalOperatingZone.MaxZPosition._read(data, at, nesting)
            else: self.max_z_position = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            latitude_ = self.latitude
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_6)
            longitude_ = self.longitude
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_7)
            out += _S_2I.pack(latitude_raw_, longitude_raw_)
            min_z_position_ = self.min_z_position
            if min_z_position_ is not None:
                mask |= 1
                if type(min_z_position_) is not SetGlobalOperatingZone.MinZPosition: raise rt.Reject
                min_z_position_._write(out)
            max_z_position_ = self.max_z_position
            if max_z_position_ is not None:
                mask |= 2
                if type(max_z_position_) is not SetGlobalOperatingZone.MaxZPosition: raise rt.Reject
                max_z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    @dataclass(slots=True, repr=False)
    class GlobalExclusionZoneRec(rt.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """

        zone_id: SetGlobalOperatingZone.ZoneID | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneID", rt.Number("H", rt.Values(SetGlobalOperatingZone.ZoneID, ((2, 65535),)))),
            )

    @dataclass(slots=True, repr=False)
    class GlobalExclusionZoneSeq(rt.Struct):
        """GlobalExclusionZoneSeq.

        global_exclusion_zone_rec: Number of the zone
        global_polygon_point_rec: A corner on the globe with its vertical limits
        """

        global_exclusion_zone_rec: SetGlobalOperatingZone.GlobalExclusionZoneRec
        global_polygon_point_rec: SetGlobalOperatingZone.GlobalPolygonPointRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GlobalExclusionZoneRec", SetGlobalOperatingZone.GlobalExclusionZoneRec.layout()),
                ("GlobalPolygonPointRec", SetGlobalOperatingZone.GlobalPolygonPointRec.layout()),
            )

    global_operating_zone: list[SetGlobalOperatingZone.GlobalPolygonPointRec]
    global_exclusion_zones: list[list[SetGlobalOperatingZone.GlobalExclusionZoneSeq]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GlobalOperatingZone", rt.Repeat(rt.Count("B", 0, 255), SetGlobalOperatingZone.GlobalPolygonPointRec.layout())),
            ("GlobalExclusionZones", rt.Repeat(rt.Count("B", 0, 255), rt.Repeat(rt.Count("B", 0, 255), SetGlobalOperatingZone.GlobalExclusionZoneSeq.layout()))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x23 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        global_operating_zone_count_ = data[2]
        if global_operating_zone_count_ * 9 > size - 3: raise rt.Reject
        at = 3
        global_operating_zone_ = []
        for _ in range(global_operating_zone_count_):
            item_, at = SetGlobalOperatingZone.GlobalPolygonPointRec._read(data, at, nesting)
            global_operating_zone_.append(item_)
        self.global_operating_zone = global_operating_zone_
        global_exclusion_zones_count_ = data[at]
        if global_exclusion_zones_count_ * 1 > size - (at + 1): raise rt.Reject
        at += 1
        global_exclusion_zones_ = []
        for _ in range(global_exclusion_zones_count_):
            item_count_ = data[at]
            if item_count_ * 11 > size - (at + 1): raise rt.Reject
            at += 1
            item_3_ = []
            for _ in range(item_count_):
                item_4_ = rt.new(SetGlobalOperatingZone.GlobalExclusionZoneSeq)
                (zone_id_,) = _S_H.unpack_from(data, at)
                item_4_.global_exclusion_zone_rec = SetGlobalOperatingZone.GlobalExclusionZoneRec(_E_SetGlobalOperatingZone_ZoneID.get(zone_id_, zone_id_))
                at += 2
                item_4_.global_polygon_point_rec, at = SetGlobalOperatingZone.GlobalPolygonPointRec._read(data, at, nesting)
                item_3_.append(item_4_)
            item_2_ = item_3_
            global_exclusion_zones_.append(item_2_)
        self.global_exclusion_zones = global_exclusion_zones_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x23\x04")
        global_operating_zone_ = self.global_operating_zone
        if type(global_operating_zone_) is not list: raise rt.Reject
        out.append(len(global_operating_zone_))
        for item_ in global_operating_zone_:
            if type(item_) is not SetGlobalOperatingZone.GlobalPolygonPointRec: raise rt.Reject
            item_._write(out)
        global_exclusion_zones_ = self.global_exclusion_zones
        if type(global_exclusion_zones_) is not list: raise rt.Reject
        out.append(len(global_exclusion_zones_))
        for item_2_ in global_exclusion_zones_:
            if type(item_2_) is not list: raise rt.Reject
            out.append(len(item_2_))
            for item_3_ in item_2_:
                if type(item_3_) is not SetGlobalOperatingZone.GlobalExclusionZoneSeq: raise rt.Reject
                global_exclusion_zone_rec_ = item_3_.global_exclusion_zone_rec
                if type(global_exclusion_zone_rec_) is not SetGlobalOperatingZone.GlobalExclusionZoneRec: raise rt.Reject
                out += _S_H.pack(global_exclusion_zone_rec_.zone_id)
                global_polygon_point_rec_ = item_3_.global_polygon_point_rec
                if type(global_polygon_point_rec_) is not SetGlobalOperatingZone.GlobalPolygonPointRec: raise rt.Reject
                global_polygon_point_rec_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class DeleteZone(rt.Message):
    """DeleteZone (0x0422): Removes zones.

    zone_id_list: 0..255 items. The zones to remove
    """

    CODE = 0x0422
    NAME = "DeleteZone"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    ZoneIDRec = mobility_v1_0_types.ZoneIDRec

    zone_id_list: list[mobility_v1_0_types.ZoneIDRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ZoneIDList", rt.Repeat(rt.Count("B", 0, 255), mobility_v1_0_types.ZoneIDRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x22 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        zone_id_list_count_ = data[2]
        zone_id_list_end_ = 3 + zone_id_list_count_ * 2
        self.zone_id_list = [mobility_v1_0_types.ZoneIDRec(_E_ZoneIDRec_ZoneID.get(zone_id_, zone_id_)) for zone_id_ in _L_H[zone_id_list_count_].unpack_from(data, 3)]
        if zone_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x22\x04")
        zone_id_list_ = self.zone_id_list
        if type(zone_id_list_) is not list: raise rt.Reject
        out.append(len(zone_id_list_))
        raw_: list[int | float] = []
        for item_ in zone_id_list_:
            if type(item_) is not mobility_v1_0_types.ZoneIDRec: raise rt.Reject
            raw_.append(item_.zone_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryGlobalOperatingZone(rt.Message):
    """QueryGlobalOperatingZone (0x2423): Asks for zones on the globe.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """

    CODE = 0x2423
    NAME = "QueryGlobalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalOperatingZone]]

    class QueryZoneID(IntEnum):
        """Values of QueryZoneID."""

        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryGlobalOperatingZone.QueryZoneID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryZoneID", rt.Number("H", rt.Values(QueryGlobalOperatingZone.QueryZoneID, ((2, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, query_zone_id_ = _S_2H.unpack(data)
        if code != 0x2423: raise rt.Reject
        self.query_zone_id = _E_QueryGlobalOperatingZone_QueryZoneID.get(query_zone_id_, query_zone_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2423, self.query_zone_id)


@dataclass(slots=True, repr=False)
class QueryExcursion(rt.Message):
    """QueryExcursion (0x2424): Asks whether the platform is where it may be.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """

    CODE = 0x2424
    NAME = "QueryExcursion"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportExcursion]]

    class QueryZoneID(IntEnum):
        """Values of QueryZoneID."""

        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryExcursion.QueryZoneID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryZoneID", rt.Number("H", rt.Values(QueryExcursion.QueryZoneID, ((2, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, query_zone_id_ = _S_2H.unpack(data)
        if code != 0x2424: raise rt.Reject
        self.query_zone_id = _E_QueryExcursion_QueryZoneID.get(query_zone_id_, query_zone_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2424, self.query_zone_id)


@dataclass(slots=True, repr=False)
class ReportGlobalOperatingZone(rt.Message):
    """ReportGlobalOperatingZone (0x4423): Tells zones on the globe.

    global_operating_zone: 0..255 items. Corners of the zone to stay in
    global_exclusion_zones: 0..255 items. The zones to keep out of
    """

    CODE = 0x4423
    NAME = "ReportGlobalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class MinZPositionChoice(IntEnum):
        """Values of MinZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class MinZPosition(rt.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: ReportGlobalOperatingZone.MinZPositionChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.real("I", -50000.0, 50000.0, "meter"),
                    1: rt.real("I", -50000.0, 50000.0, "meter"),
                    2: rt.real("I", -50000.0, 50000.0, "meter"),
                    3: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(ReportGlobalOperatingZone.MinZPositionChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_ * 2.3283064370807974e-05
                at += 5
            elif choice == 1:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
                at += 5
            elif choice == 2:
                (value_3_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
                at += 5
            elif choice == 3:
                (value_4_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportGlobalOperatingZone_MinZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_2)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_2)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_2)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    class MaxZPositionChoice(IntEnum):
        """Values of MaxZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class MaxZPosition(rt.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: ReportGlobalOperatingZone.MaxZPositionChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.real("I", -50000.0, 50000.0, "meter"),
                    1: rt.real("I", -50000.0, 50000.0, "meter"),
                    2: rt.real("I", -50000.0, 50000.0, "meter"),
                    3: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(ReportGlobalOperatingZone.MaxZPositionChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_ * 2.3283064370807974e-05
                at += 5
            elif choice == 1:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
                at += 5
            elif choice == 2:
                (value_3_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
                at += 5
            elif choice == 3:
                (value_4_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportGlobalOperatingZone_MaxZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_2)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_2)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_2)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    @dataclass(slots=True, repr=False)
    class GlobalPolygonPointRec(rt.Struct):
        """A corner on the globe with its vertical limits.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """

        latitude: float
        longitude: float
        min_z_position: ReportGlobalOperatingZone.MinZPosition | None = None
        max_z_position: ReportGlobalOperatingZone.MaxZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
                ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
                ("MinZPosition", ReportGlobalOperatingZone.MinZPosition.layout(), True),
                ("MaxZPosition", ReportGlobalOperatingZone.MaxZPosition.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            latitude_, longitude_ = _S_2I.unpack_from(data, at + 1)
            self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
            self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
            at += 9
            if mask & 1:
                self.min_z_position, at = ReportGlobalOperatingZone.MinZPosition._read(data, at, nesting)
            else: self.min_z_position = None
            if mask & 2:
                self.max_z_position, at = ReportGlobalOperatingZone.MaxZPosition._read(data, at, nesting)
            else: self.max_z_position = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            latitude_ = self.latitude
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_6)
            longitude_ = self.longitude
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_7)
            out += _S_2I.pack(latitude_raw_, longitude_raw_)
            min_z_position_ = self.min_z_position
            if min_z_position_ is not None:
                mask |= 1
                if type(min_z_position_) is not ReportGlobalOperatingZone.MinZPosition: raise rt.Reject
                min_z_position_._write(out)
            max_z_position_ = self.max_z_position
            if max_z_position_ is not None:
                mask |= 2
                if type(max_z_position_) is not ReportGlobalOperatingZone.MaxZPosition: raise rt.Reject
                max_z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    @dataclass(slots=True, repr=False)
    class GlobalExclusionZoneRec(rt.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """

        zone_id: ReportGlobalOperatingZone.ZoneID | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneID", rt.Number("H", rt.Values(ReportGlobalOperatingZone.ZoneID, ((2, 65535),)))),
            )

    @dataclass(slots=True, repr=False)
    class GlobalExclusionZoneSeq(rt.Struct):
        """GlobalExclusionZoneSeq.

        global_exclusion_zone_rec: Number of the zone
        global_polygon_point_rec: A corner on the globe with its vertical limits
        """

        global_exclusion_zone_rec: ReportGlobalOperatingZone.GlobalExclusionZoneRec
        global_polygon_point_rec: ReportGlobalOperatingZone.GlobalPolygonPointRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GlobalExclusionZoneRec", ReportGlobalOperatingZone.GlobalExclusionZoneRec.layout()),
                ("GlobalPolygonPointRec", ReportGlobalOperatingZone.GlobalPolygonPointRec.layout()),
            )

    global_operating_zone: list[ReportGlobalOperatingZone.GlobalPolygonPointRec]
    global_exclusion_zones: list[list[ReportGlobalOperatingZone.GlobalExclusionZoneSeq]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GlobalOperatingZone", rt.Repeat(rt.Count("B", 0, 255), ReportGlobalOperatingZone.GlobalPolygonPointRec.layout())),
            ("GlobalExclusionZones", rt.Repeat(rt.Count("B", 0, 255), rt.Repeat(rt.Count("B", 0, 255), ReportGlobalOperatingZone.GlobalExclusionZoneSeq.layout()))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x23 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        global_operating_zone_count_ = data[2]
        if global_operating_zone_count_ * 9 > size - 3: raise rt.Reject
        at = 3
        global_operating_zone_ = []
        for _ in range(global_operating_zone_count_):
            item_, at = ReportGlobalOperatingZone.GlobalPolygonPointRec._read(data, at, nesting)
            global_operating_zone_.append(item_)
        self.global_operating_zone = global_operating_zone_
        global_exclusion_zones_count_ = data[at]
        if global_exclusion_zones_count_ * 1 > size - (at + 1): raise rt.Reject
        at += 1
        global_exclusion_zones_ = []
        for _ in range(global_exclusion_zones_count_):
            item_count_ = data[at]
            if item_count_ * 11 > size - (at + 1): raise rt.Reject
            at += 1
            item_3_ = []
            for _ in range(item_count_):
                item_4_ = rt.new(ReportGlobalOperatingZone.GlobalExclusionZoneSeq)
                (zone_id_,) = _S_H.unpack_from(data, at)
                item_4_.global_exclusion_zone_rec = ReportGlobalOperatingZone.GlobalExclusionZoneRec(_E_ReportGlobalOperatingZone_ZoneID.get(zone_id_, zone_id_))
                at += 2
                item_4_.global_polygon_point_rec, at = ReportGlobalOperatingZone.GlobalPolygonPointRec._read(data, at, nesting)
                item_3_.append(item_4_)
            item_2_ = item_3_
            global_exclusion_zones_.append(item_2_)
        self.global_exclusion_zones = global_exclusion_zones_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x23\x44")
        global_operating_zone_ = self.global_operating_zone
        if type(global_operating_zone_) is not list: raise rt.Reject
        out.append(len(global_operating_zone_))
        for item_ in global_operating_zone_:
            if type(item_) is not ReportGlobalOperatingZone.GlobalPolygonPointRec: raise rt.Reject
            item_._write(out)
        global_exclusion_zones_ = self.global_exclusion_zones
        if type(global_exclusion_zones_) is not list: raise rt.Reject
        out.append(len(global_exclusion_zones_))
        for item_2_ in global_exclusion_zones_:
            if type(item_2_) is not list: raise rt.Reject
            out.append(len(item_2_))
            for item_3_ in item_2_:
                if type(item_3_) is not ReportGlobalOperatingZone.GlobalExclusionZoneSeq: raise rt.Reject
                global_exclusion_zone_rec_ = item_3_.global_exclusion_zone_rec
                if type(global_exclusion_zone_rec_) is not ReportGlobalOperatingZone.GlobalExclusionZoneRec: raise rt.Reject
                out += _S_H.pack(global_exclusion_zone_rec_.zone_id)
                global_polygon_point_rec_ = item_3_.global_polygon_point_rec
                if type(global_polygon_point_rec_) is not ReportGlobalOperatingZone.GlobalPolygonPointRec: raise rt.Reject
                global_polygon_point_rec_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportExcursion(rt.Message):
    """ReportExcursion (0x4424): Tells for each zone whether the platform respects it.

    excursion: 0..255 items. The zones and whether they are respected
    """

    CODE = 0x4424
    NAME = "ReportExcursion"
    SERVICE = "urn:jaus:jss:mobility:GlobalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ExcursionRec = mobility_v1_0_types.ExcursionRec

    excursion: list[mobility_v1_0_types.ExcursionRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Excursion", rt.Repeat(rt.Count("B", 0, 255), mobility_v1_0_types.ExcursionRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x24 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        excursion_count_ = data[2]
        excursion_end_ = 3 + excursion_count_ * 3
        self.excursion = [mobility_v1_0_types.ExcursionRec(_E_ExcursionRec_ZoneID.get(zone_id_, zone_id_), _E_ExcursionRec_ZoneStatus[zone_status_]) for zone_id_, zone_status_ in _S_HB.iter_unpack(data[3:excursion_end_])]
        if excursion_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x24\x44")
        excursion_ = self.excursion
        if type(excursion_) is not list: raise rt.Reject
        out.append(len(excursion_))
        for item_ in excursion_:
            if type(item_) is not mobility_v1_0_types.ExcursionRec: raise rt.Reject
            zone_status_ = item_.zone_status
            if zone_status_ not in _E_ExcursionRec_ZoneStatus: raise rt.Reject
            out += _S_HB.pack(item_.zone_id, zone_status_)
        return bytes(out)


_S_I = rt.Packer("<I")
_E_SetGlobalOperatingZone_MinZPositionChoice = rt.members(SetGlobalOperatingZone.MinZPositionChoice)
_R_2 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_SetGlobalOperatingZone_MaxZPositionChoice = rt.members(SetGlobalOperatingZone.MaxZPositionChoice)
_S_2I = rt.Packer("<2I")
_R_6 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_7 = rt.Scaling(-180.0, 180.0, 4294967295)
_S_B = rt.Packer("<B")
_E_SetGlobalOperatingZone_ZoneID = rt.members(SetGlobalOperatingZone.ZoneID)
_S_H = rt.Packer("<H")
_E_ZoneIDRec_ZoneID = rt.members(mobility_v1_0_types.ZoneIDRec.ZoneID)
_L_H = rt.Rows("H")
_E_QueryGlobalOperatingZone_QueryZoneID = rt.members(QueryGlobalOperatingZone.QueryZoneID)
_S_2H = rt.Packer("<2H")
_E_QueryExcursion_QueryZoneID = rt.members(QueryExcursion.QueryZoneID)
_E_ReportGlobalOperatingZone_MinZPositionChoice = rt.members(ReportGlobalOperatingZone.MinZPositionChoice)
_E_ReportGlobalOperatingZone_MaxZPositionChoice = rt.members(ReportGlobalOperatingZone.MaxZPositionChoice)
_E_ReportGlobalOperatingZone_ZoneID = rt.members(ReportGlobalOperatingZone.ZoneID)
_E_ExcursionRec_ZoneID = rt.members(mobility_v1_0_types.ExcursionRec.ZoneID)
_E_ExcursionRec_ZoneStatus = rt.members(mobility_v1_0_types.ExcursionRec.ZoneStatus)
_S_HB = rt.Packer("<HB")
QueryGlobalOperatingZone.REPORT = ReportGlobalOperatingZone
QueryExcursion.REPORT = ReportExcursion
