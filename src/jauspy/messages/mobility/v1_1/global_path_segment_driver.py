"""urn:jaus:jss:mobility:GlobalPathSegmentDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver


@dataclass(slots=True, repr=False)
class ExecuteList(rt.Message):
    """ExecuteList (0x041E): Starts the list at an element, at a speed.

    speed: 0..327.67 meter per second. Speed to go through the list, in metres per second
    element_uid: optional. The element to start with
    """

    CODE = 0x041E
    NAME = "ExecuteList"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    speed: float
    element_uid: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", rt.real("H", 0.0, 327.67, "meter per second")),
            ("ElementUID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x041E: raise rt.Reject
        raw = iter(_M_ExecuteList[mask & 0x1].unpack(data)).__next__
        self = rt.new(cls)
        speed_ = raw()
        self.speed = speed_ * 0.0049999237048905165
        self.element_uid = raw() if mask & 1 else None
        self.reserved_presence = mask & 0xFE
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1: raise rt.Reject
        raw: list[int | float | bytes] = []
        speed_ = self.speed
        if not 0.0 <= speed_ <= 327.67: raise rt.Reject
        near = speed_ * 200.0030518509476 + 0.5
        speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_2)
        raw.append(speed_raw_)
        element_uid_ = self.element_uid
        if element_uid_ is not None:
            mask |= 1
            raw.append(element_uid_)
        return _M_ExecuteList_pack[mask & 0x1].pack(0x041E, mask, *raw)


@dataclass(slots=True, repr=False)
class ExecuteListExt(rt.Message):
    """ExecuteListExt (0x04AE): Starts the list at an element, at one of several kinds of speed.

    speed: Speed to go through the list, and its kind
    element_uid: optional. The element to start with
    """

    CODE = 0x04AE
    NAME = "ExecuteListExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    Speed = mobility_v1_0_types.Speed

    speed: mobility_v1_0_types.Speed
    element_uid: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", mobility_v1_0_types.Speed.layout()),
            ("ElementUID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAE or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        self.speed, at = mobility_v1_0_types.Speed._read(data, at, nesting)
        packer = _M_ExecuteListExt_1[mask & 0x1]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.element_uid = raw() if mask & 1 else None
        self.reserved_presence = mask & 0xFE
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xae\x04")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1: raise rt.Reject
        speed_ = self.speed
        if type(speed_) is not mobility_v1_0_types.Speed: raise rt.Reject
        speed_._write(out)
        raw: list[int | float | bytes] = []
        element_uid_ = self.element_uid
        if element_uid_ is not None:
            mask |= 1
            raw.append(element_uid_)
        out += _M_ExecuteListExt_1[mask & 0x1].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeedExt]]


class QueryGlobalPathSegment(mobility_v1_0_global_path_segment_driver.QueryGlobalPathSegment):
    """QueryGlobalPathSegment (0x240F): Asks for the path segment on the globe being followed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportGlobalPathSegment]]


@dataclass(slots=True, repr=False)
class QueryGlobalPathSegmentExt(rt.Message):
    """QueryGlobalPathSegmentExt (0x24AF): Asks for the path segment on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24AF
    NAME = "QueryGlobalPathSegmentExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalPathSegmentExt]]

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector = _S_HB.unpack(data)
        if code != 0x24AF: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x24AF, self.presence_vector)


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"


class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"


class ReportGlobalPathSegment(mobility_v1_0_global_path_segment_driver.ReportGlobalPathSegment):
    """ReportGlobalPathSegment (0x440F): Tells the path segment on the globe being followed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False, kw_only=True)
class ReportGlobalPathSegmentExt(rt.Message):
    """ReportGlobalPathSegmentExt (0x44AF): Tells the path segment on the globe, with its vertical datum.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_z_position: optional. Vertical position of the shaping point P1 and its datum
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p_z_position: optional. Vertical position of the end point P2 and its datum
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x44AF
    NAME = "ReportGlobalPathSegmentExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class P1_ZPositionChoice(IntEnum):
        """Values of P1_ZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class P1_ZPosition(rt.Struct):
        """Vertical position of the shaping point P1 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: ReportGlobalPathSegmentExt.P1_ZPositionChoice | int
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
                rt.Values(ReportGlobalPathSegmentExt.P1_ZPositionChoice),
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
            self.choice = _E_ReportGlobalPathSegmentExt_P1_ZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_8)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_8)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_8)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_8)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    class P_ZPositionChoice(IntEnum):
        """Values of P_ZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @dataclass(slots=True, repr=False)
    class P_ZPosition(rt.Struct):
        """Vertical position of the end point P2 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """

        choice: ReportGlobalPathSegmentExt.P_ZPositionChoice | int
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
                rt.Values(ReportGlobalPathSegmentExt.P_ZPositionChoice),
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
            self.choice = _E_ReportGlobalPathSegmentExt_P_ZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_8)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_8)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_8)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_8)
                out += _S_BI.pack(choice, value_raw_4_)
            else: raise rt.Reject

    p1_latitude: float
    p1_longitude: float
    p1_z_position: ReportGlobalPathSegmentExt.P1_ZPosition | None = None
    p2_latitude: float
    p2_longitude: float
    p_z_position: ReportGlobalPathSegmentExt.P_ZPosition | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P1_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P1_ZPosition", ReportGlobalPathSegmentExt.P1_ZPosition.layout(), True),
            ("P2_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P2_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P_ZPosition", ReportGlobalPathSegmentExt.P_ZPosition.layout(), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAF or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        p1_latitude_, p1_longitude_ = _S_2I.unpack_from(data, 3)
        self.p1_latitude = -90.0 + p1_latitude_ * 4.190951586745435e-08
        self.p1_longitude = -180.0 + p1_longitude_ * 8.38190317349087e-08
        at = 11
        if mask & 1:
            self.p1_z_position, at = ReportGlobalPathSegmentExt.P1_ZPosition._read(data, at, nesting)
        else: self.p1_z_position = None
        p2_latitude_, p2_longitude_ = _S_2I.unpack_from(data, at)
        self.p2_latitude = -90.0 + p2_latitude_ * 4.190951586745435e-08
        self.p2_longitude = -180.0 + p2_longitude_ * 8.38190317349087e-08
        at += 8
        if mask & 2:
            self.p_z_position, at = ReportGlobalPathSegmentExt.P_ZPosition._read(data, at, nesting)
        else: self.p_z_position = None
        packer = _M_ReportGlobalPathSegmentExt_4[mask & 0x4]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xaf\x44")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        p1_latitude_ = self.p1_latitude
        if not -90.0 <= p1_latitude_ <= 90.0: raise rt.Reject
        near = p1_latitude_ * 23860929.416666668 + 2147483648.0
        p1_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_latitude_raw_ < 0.9999847412109375: p1_latitude_raw_ = rt.exact_raw(p1_latitude_, _R_13)
        p1_longitude_ = self.p1_longitude
        if not -180.0 <= p1_longitude_ <= 180.0: raise rt.Reject
        near = p1_longitude_ * 11930464.708333334 + 2147483648.0
        p1_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_longitude_raw_ < 0.9999847412109375: p1_longitude_raw_ = rt.exact_raw(p1_longitude_, _R_14)
        out += _S_2I.pack(p1_latitude_raw_, p1_longitude_raw_)
        p1_z_position_ = self.p1_z_position
        if p1_z_position_ is not None:
            mask |= 1
            if type(p1_z_position_) is not ReportGlobalPathSegmentExt.P1_ZPosition: raise rt.Reject
            p1_z_position_._write(out)
        p2_latitude_ = self.p2_latitude
        if not -90.0 <= p2_latitude_ <= 90.0: raise rt.Reject
        near = p2_latitude_ * 23860929.416666668 + 2147483648.0
        p2_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_latitude_raw_ < 0.9999847412109375: p2_latitude_raw_ = rt.exact_raw(p2_latitude_, _R_13)
        p2_longitude_ = self.p2_longitude
        if not -180.0 <= p2_longitude_ <= 180.0: raise rt.Reject
        near = p2_longitude_ * 11930464.708333334 + 2147483648.0
        p2_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_longitude_raw_ < 0.9999847412109375: p2_longitude_raw_ = rt.exact_raw(p2_longitude_, _R_14)
        out += _S_2I.pack(p2_latitude_raw_, p2_longitude_raw_)
        p_z_position_ = self.p_z_position
        if p_z_position_ is not None:
            mask |= 2
            if type(p_z_position_) is not ReportGlobalPathSegmentExt.P_ZPosition: raise rt.Reject
            p_z_position_._write(out)
        raw: list[int | float | bytes] = []
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_15)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_16)
            raw.append(path_tolerance_raw_)
        out += _M_ReportGlobalPathSegmentExt_4[mask & 0x4].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.1"


_S_HB = rt.Packer("<HB")
_M_ExecuteList = rt.Masks("3x", ((0, "H"), (1, "H")))
_R_2 = rt.Scaling(0.0, 327.67, 65535)
_M_ExecuteList_pack = rt.Masks("HB", ((0, "H"), (1, "H")))
_M_ExecuteListExt_1 = rt.Masks("", ((1, "H"),))
_S_B = rt.Packer("<B")
_S_I = rt.Packer("<I")
_E_ReportGlobalPathSegmentExt_P1_ZPositionChoice = rt.members(ReportGlobalPathSegmentExt.P1_ZPositionChoice)
_R_8 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_ReportGlobalPathSegmentExt_P_ZPositionChoice = rt.members(ReportGlobalPathSegmentExt.P_ZPositionChoice)
_S_2I = rt.Packer("<2I")
_M_ReportGlobalPathSegmentExt_4 = rt.Masks("", ((0, "H"), (4, "I")))
_R_13 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_14 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_15 = rt.Scaling(0.0, 500.0, 65535)
_R_16 = rt.Scaling(0.0, 100000.0, 4294967295)
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
QueryGlobalPathSegment.REPORT = ReportGlobalPathSegment
QueryGlobalPathSegmentExt.REPORT = ReportGlobalPathSegmentExt
QueryActiveElement.REPORT = ReportActiveElement
