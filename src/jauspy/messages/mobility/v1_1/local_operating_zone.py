"""urn:jaus:jss:mobility:LocalOperatingZone 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_1 import global_operating_zone as mobility_v1_1_global_operating_zone


@dataclass(slots=True, repr=False)
class SetLocalOperatingZone(rt.Message):
    """SetLocalOperatingZone (0x0427): Sets the zone in the local frame to stay in and those to keep out of.

    local_operating_zone: 0..255 items. Corners of the zone to stay in
    local_exclusion_zones: 0..255 items. The zones to keep out of
    """

    CODE = 0x0427
    NAME = "SetLocalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class MinZPositionChoice(IntEnum):
        """Values of MinZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class MinZPosition(rt.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: SetLocalOperatingZone.MinZPositionChoice | int
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
                    4: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(SetLocalOperatingZone.MinZPositionChoice),
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
            elif choice == 4:
                (value_5_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_SetLocalOperatingZone_MinZPositionChoice[choice]
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
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_2)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    class MaxZPositionChoice(IntEnum):
        """Values of MaxZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class MaxZPosition(rt.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: SetLocalOperatingZone.MaxZPositionChoice | int
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
                    4: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(SetLocalOperatingZone.MaxZPositionChoice),
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
            elif choice == 4:
                (value_5_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_SetLocalOperatingZone_MaxZPositionChoice[choice]
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
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_2)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    @dataclass(slots=True, repr=False)
    class LocalPolygonPointRec(rt.Struct):
        """A corner in the local frame with its vertical limits.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """

        x: float
        y: float
        min_z_position: SetLocalOperatingZone.MinZPosition | None = None
        max_z_position: SetLocalOperatingZone.MaxZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("X", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("MinZPosition", SetLocalOperatingZone.MinZPosition.layout(), True),
                ("MaxZPosition", SetLocalOperatingZone.MaxZPosition.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            x_, y_ = _S_2I.unpack_from(data, at + 1)
            self.x = -20000000.0 + x_ * 0.00931322574832319
            self.y = -20000000.0 + y_ * 0.00931322574832319
            at += 9
            if mask & 1:
                self.min_z_position, at = SetLocalOperatingZone.MinZPosition._read(data, at, nesting)
            else: self.min_z_position = None
            if mask & 2:
                self.max_z_position, at = SetLocalOperatingZone.MaxZPosition._read(data, at, nesting)
            else: self.max_z_position = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            x_ = self.x
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_6)
            y_ = self.y
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_6)
            out += _S_2I.pack(x_raw_, y_raw_)
            min_z_position_ = self.min_z_position
            if min_z_position_ is not None:
                mask |= 1
                if type(min_z_position_) is not SetLocalOperatingZone.MinZPosition: raise rt.Reject
                min_z_position_._write(out)
            max_z_position_ = self.max_z_position
            if max_z_position_ is not None:
                mask |= 2
                if type(max_z_position_) is not SetLocalOperatingZone.MaxZPosition: raise rt.Reject
                max_z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    @dataclass(slots=True, repr=False)
    class LocalExclusionZoneRec(rt.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """

        zone_id: SetLocalOperatingZone.ZoneID | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneID", rt.Number("H", rt.Values(SetLocalOperatingZone.ZoneID, ((2, 65535),)))),
            )

    @dataclass(slots=True, repr=False)
    class LocalExclusionZoneSeq(rt.Struct):
        """LocalExclusionZoneSeq.

        local_exclusion_zone_rec: Number of the zone
        local_polygon_point_rec: A corner in the local frame with its vertical limits
        """

        local_exclusion_zone_rec: SetLocalOperatingZone.LocalExclusionZoneRec
        local_polygon_point_rec: SetLocalOperatingZone.LocalPolygonPointRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LocalExclusionZoneRec", SetLocalOperatingZone.LocalExclusionZoneRec.layout()),
                ("LocalPolygonPointRec", SetLocalOperatingZone.LocalPolygonPointRec.layout()),
            )

    local_operating_zone: list[SetLocalOperatingZone.LocalPolygonPointRec]
    local_exclusion_zones: list[list[SetLocalOperatingZone.LocalExclusionZoneSeq]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LocalOperatingZone", rt.Repeat(rt.Count("B", 0, 255), SetLocalOperatingZone.LocalPolygonPointRec.layout())),
            ("LocalExclusionZones", rt.Repeat(rt.Count("B", 0, 255), rt.Repeat(rt.Count("B", 0, 255), SetLocalOperatingZone.LocalExclusionZoneSeq.layout()))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x27 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        local_operating_zone_count_ = data[2]
        if local_operating_zone_count_ * 9 > size - 3: raise rt.Reject
        at = 3
        local_operating_zone_ = []
        for _ in range(local_operating_zone_count_):
            item_, at = SetLocalOperatingZone.LocalPolygonPointRec._read(data, at, nesting)
            local_operating_zone_.append(item_)
        self.local_operating_zone = local_operating_zone_
        local_exclusion_zones_count_ = data[at]
        if local_exclusion_zones_count_ * 1 > size - (at + 1): raise rt.Reject
        at += 1
        local_exclusion_zones_ = []
        for _ in range(local_exclusion_zones_count_):
            item_count_ = data[at]
            if item_count_ * 11 > size - (at + 1): raise rt.Reject
            at += 1
            item_3_ = []
            for _ in range(item_count_):
                item_4_ = rt.new(SetLocalOperatingZone.LocalExclusionZoneSeq)
                (zone_id_,) = _S_H.unpack_from(data, at)
                item_4_.local_exclusion_zone_rec = SetLocalOperatingZone.LocalExclusionZoneRec(_E_SetLocalOperatingZone_ZoneID.get(zone_id_, zone_id_))
                at += 2
                item_4_.local_polygon_point_rec, at = SetLocalOperatingZone.LocalPolygonPointRec._read(data, at, nesting)
                item_3_.append(item_4_)
            item_2_ = item_3_
            local_exclusion_zones_.append(item_2_)
        self.local_exclusion_zones = local_exclusion_zones_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x27\x04")
        local_operating_zone_ = self.local_operating_zone
        if type(local_operating_zone_) is not list: raise rt.Reject
        out.append(len(local_operating_zone_))
        for item_ in local_operating_zone_:
            if type(item_) is not SetLocalOperatingZone.LocalPolygonPointRec: raise rt.Reject
            item_._write(out)
        local_exclusion_zones_ = self.local_exclusion_zones
        if type(local_exclusion_zones_) is not list: raise rt.Reject
        out.append(len(local_exclusion_zones_))
        for item_2_ in local_exclusion_zones_:
            if type(item_2_) is not list: raise rt.Reject
            out.append(len(item_2_))
            for item_3_ in item_2_:
                if type(item_3_) is not SetLocalOperatingZone.LocalExclusionZoneSeq: raise rt.Reject
                local_exclusion_zone_rec_ = item_3_.local_exclusion_zone_rec
                if type(local_exclusion_zone_rec_) is not SetLocalOperatingZone.LocalExclusionZoneRec: raise rt.Reject
                out += _S_H.pack(local_exclusion_zone_rec_.zone_id)
                local_polygon_point_rec_ = item_3_.local_polygon_point_rec
                if type(local_polygon_point_rec_) is not SetLocalOperatingZone.LocalPolygonPointRec: raise rt.Reject
                local_polygon_point_rec_._write(out)
        return bytes(out)


class DeleteZone(mobility_v1_1_global_operating_zone.DeleteZone):
    """DeleteZone (0x0422): Removes zones."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class QueryLocalOperatingZone(rt.Message):
    """QueryLocalOperatingZone (0x2427): Asks for zones in the local frame.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """

    CODE = 0x2427
    NAME = "QueryLocalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalOperatingZone]]

    class QueryZoneID(IntEnum):
        """Values of QueryZoneID."""

        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryLocalOperatingZone.QueryZoneID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryZoneID", rt.Number("H", rt.Values(QueryLocalOperatingZone.QueryZoneID, ((2, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, query_zone_id_ = _S_2H.unpack(data)
        if code != 0x2427: raise rt.Reject
        self.query_zone_id = _E_QueryLocalOperatingZone_QueryZoneID.get(query_zone_id_, query_zone_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2427, self.query_zone_id)


class QueryExcursion(mobility_v1_1_global_operating_zone.QueryExcursion):
    """QueryExcursion (0x2424): Asks whether the platform is where it may be."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportExcursion]]


@dataclass(slots=True, repr=False)
class ReportLocalOperatingZone(rt.Message):
    """ReportLocalOperatingZone (0x4427): Tells zones in the local frame.

    local_operating_zone: 0..255 items. Corners of the zone to stay in
    local_exclusion_zones: 0..255 items. The zones to keep out of
    """

    CODE = 0x4427
    NAME = "ReportLocalOperatingZone"
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class MinZPositionChoice(IntEnum):
        """Values of MinZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class MinZPosition(rt.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: ReportLocalOperatingZone.MinZPositionChoice | int
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
                    4: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(ReportLocalOperatingZone.MinZPositionChoice),
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
            elif choice == 4:
                (value_5_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportLocalOperatingZone_MinZPositionChoice[choice]
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
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_2)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    class MaxZPositionChoice(IntEnum):
        """Values of MaxZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class MaxZPosition(rt.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: ReportLocalOperatingZone.MaxZPositionChoice | int
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
                    4: rt.real("I", -50000.0, 50000.0, "meter"),
                },
                rt.Values(ReportLocalOperatingZone.MaxZPositionChoice),
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
            elif choice == 4:
                (value_5_,) = _S_I.unpack_from(data, at + 1)
                self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportLocalOperatingZone_MaxZPositionChoice[choice]
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
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_2)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    @dataclass(slots=True, repr=False)
    class LocalPolygonPointRec(rt.Struct):
        """A corner in the local frame with its vertical limits.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """

        x: float
        y: float
        min_z_position: ReportLocalOperatingZone.MinZPosition | None = None
        max_z_position: ReportLocalOperatingZone.MaxZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("X", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("MinZPosition", ReportLocalOperatingZone.MinZPosition.layout(), True),
                ("MaxZPosition", ReportLocalOperatingZone.MaxZPosition.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            x_, y_ = _S_2I.unpack_from(data, at + 1)
            self.x = -20000000.0 + x_ * 0.00931322574832319
            self.y = -20000000.0 + y_ * 0.00931322574832319
            at += 9
            if mask & 1:
                self.min_z_position, at = ReportLocalOperatingZone.MinZPosition._read(data, at, nesting)
            else: self.min_z_position = None
            if mask & 2:
                self.max_z_position, at = ReportLocalOperatingZone.MaxZPosition._read(data, at, nesting)
            else: self.max_z_position = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            x_ = self.x
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_6)
            y_ = self.y
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_6)
            out += _S_2I.pack(x_raw_, y_raw_)
            min_z_position_ = self.min_z_position
            if min_z_position_ is not None:
                mask |= 1
                if type(min_z_position_) is not ReportLocalOperatingZone.MinZPosition: raise rt.Reject
                min_z_position_._write(out)
            max_z_position_ = self.max_z_position
            if max_z_position_ is not None:
                mask |= 2
                if type(max_z_position_) is not ReportLocalOperatingZone.MaxZPosition: raise rt.Reject
                max_z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    @dataclass(slots=True, repr=False)
    class LocalExclusionZoneRec(rt.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """

        zone_id: ReportLocalOperatingZone.ZoneID | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneID", rt.Number("H", rt.Values(ReportLocalOperatingZone.ZoneID, ((2, 65535),)))),
            )

    @dataclass(slots=True, repr=False)
    class LocalExclusionZoneSeq(rt.Struct):
        """LocalExclusionZoneSeq.

        local_exclusion_zone_rec: Number of the zone
        local_polygon_point_rec: A corner in the local frame with its vertical limits
        """

        local_exclusion_zone_rec: ReportLocalOperatingZone.LocalExclusionZoneRec
        local_polygon_point_rec: ReportLocalOperatingZone.LocalPolygonPointRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LocalExclusionZoneRec", ReportLocalOperatingZone.LocalExclusionZoneRec.layout()),
                ("LocalPolygonPointRec", ReportLocalOperatingZone.LocalPolygonPointRec.layout()),
            )

    local_operating_zone: list[ReportLocalOperatingZone.LocalPolygonPointRec]
    local_exclusion_zones: list[list[ReportLocalOperatingZone.LocalExclusionZoneSeq]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LocalOperatingZone", rt.Repeat(rt.Count("B", 0, 255), ReportLocalOperatingZone.LocalPolygonPointRec.layout())),
            ("LocalExclusionZones", rt.Repeat(rt.Count("B", 0, 255), rt.Repeat(rt.Count("B", 0, 255), ReportLocalOperatingZone.LocalExclusionZoneSeq.layout()))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x27 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        local_operating_zone_count_ = data[2]
        if local_operating_zone_count_ * 9 > size - 3: raise rt.Reject
        at = 3
        local_operating_zone_ = []
        for _ in range(local_operating_zone_count_):
            item_, at = ReportLocalOperatingZone.LocalPolygonPointRec._read(data, at, nesting)
            local_operating_zone_.append(item_)
        self.local_operating_zone = local_operating_zone_
        local_exclusion_zones_count_ = data[at]
        if local_exclusion_zones_count_ * 1 > size - (at + 1): raise rt.Reject
        at += 1
        local_exclusion_zones_ = []
        for _ in range(local_exclusion_zones_count_):
            item_count_ = data[at]
            if item_count_ * 11 > size - (at + 1): raise rt.Reject
            at += 1
            item_3_ = []
            for _ in range(item_count_):
                item_4_ = rt.new(ReportLocalOperatingZone.LocalExclusionZoneSeq)
                (zone_id_,) = _S_H.unpack_from(data, at)
                item_4_.local_exclusion_zone_rec = ReportLocalOperatingZone.LocalExclusionZoneRec(_E_ReportLocalOperatingZone_ZoneID.get(zone_id_, zone_id_))
                at += 2
                item_4_.local_polygon_point_rec, at = ReportLocalOperatingZone.LocalPolygonPointRec._read(data, at, nesting)
                item_3_.append(item_4_)
            item_2_ = item_3_
            local_exclusion_zones_.append(item_2_)
        self.local_exclusion_zones = local_exclusion_zones_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x27\x44")
        local_operating_zone_ = self.local_operating_zone
        if type(local_operating_zone_) is not list: raise rt.Reject
        out.append(len(local_operating_zone_))
        for item_ in local_operating_zone_:
            if type(item_) is not ReportLocalOperatingZone.LocalPolygonPointRec: raise rt.Reject
            item_._write(out)
        local_exclusion_zones_ = self.local_exclusion_zones
        if type(local_exclusion_zones_) is not list: raise rt.Reject
        out.append(len(local_exclusion_zones_))
        for item_2_ in local_exclusion_zones_:
            if type(item_2_) is not list: raise rt.Reject
            out.append(len(item_2_))
            for item_3_ in item_2_:
                if type(item_3_) is not ReportLocalOperatingZone.LocalExclusionZoneSeq: raise rt.Reject
                local_exclusion_zone_rec_ = item_3_.local_exclusion_zone_rec
                if type(local_exclusion_zone_rec_) is not ReportLocalOperatingZone.LocalExclusionZoneRec: raise rt.Reject
                out += _S_H.pack(local_exclusion_zone_rec_.zone_id)
                local_polygon_point_rec_ = item_3_.local_polygon_point_rec
                if type(local_polygon_point_rec_) is not ReportLocalOperatingZone.LocalPolygonPointRec: raise rt.Reject
                local_polygon_point_rec_._write(out)
        return bytes(out)


class ReportExcursion(mobility_v1_1_global_operating_zone.ReportExcursion):
    """ReportExcursion (0x4424): Tells for each zone whether the platform respects it."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalOperatingZone"
    VERSION = "1.1"


_S_I = rt.Packer("<I")
_E_SetLocalOperatingZone_MinZPositionChoice = rt.members(SetLocalOperatingZone.MinZPositionChoice)
_R_2 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_SetLocalOperatingZone_MaxZPositionChoice = rt.members(SetLocalOperatingZone.MaxZPositionChoice)
_S_2I = rt.Packer("<2I")
_R_6 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_S_B = rt.Packer("<B")
_E_SetLocalOperatingZone_ZoneID = rt.members(SetLocalOperatingZone.ZoneID)
_S_H = rt.Packer("<H")
_E_QueryLocalOperatingZone_QueryZoneID = rt.members(QueryLocalOperatingZone.QueryZoneID)
_S_2H = rt.Packer("<2H")
_E_ReportLocalOperatingZone_MinZPositionChoice = rt.members(ReportLocalOperatingZone.MinZPositionChoice)
_E_ReportLocalOperatingZone_MaxZPositionChoice = rt.members(ReportLocalOperatingZone.MaxZPositionChoice)
_E_ReportLocalOperatingZone_ZoneID = rt.members(ReportLocalOperatingZone.ZoneID)
QueryLocalOperatingZone.REPORT = ReportLocalOperatingZone
QueryExcursion.REPORT = ReportExcursion
