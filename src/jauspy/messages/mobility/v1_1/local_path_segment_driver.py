"""urn:jaus:jss:mobility:LocalPathSegmentDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_path_segment_driver as mobility_v1_0_local_path_segment_driver
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver
from jauspy.messages.mobility.v1_1 import global_path_segment_driver as mobility_v1_1_global_path_segment_driver


class ExecuteList(mobility_v1_1_global_path_segment_driver.ExecuteList):
    """ExecuteList (0x041E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


class ExecuteListExt(mobility_v1_1_global_path_segment_driver.ExecuteListExt):
    """ExecuteListExt (0x04AE): Starts the list at an element, at one of several kinds of speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeedExt]]


class QueryLocalPathSegment(mobility_v1_0_local_path_segment_driver.QueryLocalPathSegment):
    """QueryLocalPathSegment (0x2410): Asks for the path segment in the local frame being followed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportLocalPathSegment]]


@dataclass(slots=True, repr=False)
class QueryLocalPathSegmentExt(rt.Message):
    """QueryLocalPathSegmentExt (0x24B0): Asks for the path segment in the local frame in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24B0
    NAME = "QueryLocalPathSegmentExt"
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalPathSegmentExt]]

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
        if code != 0x24B0: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x24B0, self.presence_vector)


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


class ReportLocalPathSegment(mobility_v1_0_local_path_segment_driver.ReportLocalPathSegment):
    """ReportLocalPathSegment (0x4410): Tells the path segment in the local frame being followed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False, kw_only=True)
class ReportLocalPathSegmentExt(rt.Message):
    """ReportLocalPathSegmentExt (0x44B0): Tells the path segment in the local frame, with its vertical datum.

    p1_x: -20000000..20000000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -20000000..20000000 meter. Position of the shaping point P1 along Y, in metres
    p1_z_position: optional. Vertical position of the shaping point P1 and its datum
    p2_x: -20000000..20000000 meter. Position of the end point P2 along X, in metres
    p2_y: -20000000..20000000 meter. Position of the end point P2 along Y, in metres
    p2_z_position: optional. Vertical position of the end point P2 and its datum
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x44B0
    NAME = "ReportLocalPathSegmentExt"
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class P1_ZPositionChoice(IntEnum):
        """Values of P1_ZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class P1_ZPosition(rt.Struct):
        """Vertical position of the shaping point P1 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: ReportLocalPathSegmentExt.P1_ZPositionChoice | int
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
                rt.Values(ReportLocalPathSegmentExt.P1_ZPositionChoice),
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
            self.choice = _E_ReportLocalPathSegmentExt_P1_ZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_3)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_3)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_3)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_3)
                out += _S_BI.pack(choice, value_raw_4_)
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_3)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    class P2_ZPositionChoice(IntEnum):
        """Values of P2_ZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @dataclass(slots=True, repr=False)
    class P2_ZPosition(rt.Struct):
        """Vertical position of the end point P2 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """

        choice: ReportLocalPathSegmentExt.P2_ZPositionChoice | int
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
                rt.Values(ReportLocalPathSegmentExt.P2_ZPositionChoice),
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
            self.choice = _E_ReportLocalPathSegmentExt_P2_ZPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                value_ = self.value
                if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
                near = value_ * 42949.67295 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_3)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 1:
                value_2_ = self.value
                if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
                near = value_2_ * 42949.67295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_3)
                out += _S_BI.pack(choice, value_raw_2_)
            elif choice == 2:
                value_3_ = self.value
                if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
                near = value_3_ * 42949.67295 + 2147483648.0
                value_raw_3_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_3)
                out += _S_BI.pack(choice, value_raw_3_)
            elif choice == 3:
                value_4_ = self.value
                if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
                near = value_4_ * 42949.67295 + 2147483648.0
                value_raw_4_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_3)
                out += _S_BI.pack(choice, value_raw_4_)
            elif choice == 4:
                value_5_ = self.value
                if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
                near = value_5_ * 42949.67295 + 2147483648.0
                value_raw_5_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_3)
                out += _S_BI.pack(choice, value_raw_5_)
            else: raise rt.Reject

    p1_x: float
    p1_y: float
    p1_z_position: ReportLocalPathSegmentExt.P1_ZPosition | None = None
    p2_x: float
    p2_y: float
    p2_z_position: ReportLocalPathSegmentExt.P2_ZPosition | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_X", rt.real("I", -20000000.0, 20000000.0, "meter")),
            ("P1_Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
            ("P1_ZPosition", ReportLocalPathSegmentExt.P1_ZPosition.layout(), True),
            ("P2_X", rt.real("I", -20000000.0, 20000000.0, "meter")),
            ("P2_Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
            ("P2_ZPosition", ReportLocalPathSegmentExt.P2_ZPosition.layout(), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xB0 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        p1_x_, p1_y_ = _S_2I.unpack_from(data, 3)
        self.p1_x = -20000000.0 + p1_x_ * 0.00931322574832319
        self.p1_y = -20000000.0 + p1_y_ * 0.00931322574832319
        at = 11
        if mask & 1:
            self.p1_z_position, at = ReportLocalPathSegmentExt.P1_ZPosition._read(data, at, nesting)
        else: self.p1_z_position = None
        p2_x_, p2_y_ = _S_2I.unpack_from(data, at)
        self.p2_x = -20000000.0 + p2_x_ * 0.00931322574832319
        self.p2_y = -20000000.0 + p2_y_ * 0.00931322574832319
        at += 8
        if mask & 2:
            self.p2_z_position, at = ReportLocalPathSegmentExt.P2_ZPosition._read(data, at, nesting)
        else: self.p2_z_position = None
        packer = _M_ReportLocalPathSegmentExt_4[mask & 0x4]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xb0\x44")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        p1_x_ = self.p1_x
        if not -20000000.0 <= p1_x_ <= 20000000.0: raise rt.Reject
        near = p1_x_ * 107.374182375 + 2147483648.0
        p1_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_x_raw_ < 0.9999847412109375: p1_x_raw_ = rt.exact_raw(p1_x_, _R_8)
        p1_y_ = self.p1_y
        if not -20000000.0 <= p1_y_ <= 20000000.0: raise rt.Reject
        near = p1_y_ * 107.374182375 + 2147483648.0
        p1_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_y_raw_ < 0.9999847412109375: p1_y_raw_ = rt.exact_raw(p1_y_, _R_8)
        out += _S_2I.pack(p1_x_raw_, p1_y_raw_)
        p1_z_position_ = self.p1_z_position
        if p1_z_position_ is not None:
            mask |= 1
            if type(p1_z_position_) is not ReportLocalPathSegmentExt.P1_ZPosition: raise rt.Reject
            p1_z_position_._write(out)
        p2_x_ = self.p2_x
        if not -20000000.0 <= p2_x_ <= 20000000.0: raise rt.Reject
        near = p2_x_ * 107.374182375 + 2147483648.0
        p2_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_x_raw_ < 0.9999847412109375: p2_x_raw_ = rt.exact_raw(p2_x_, _R_8)
        p2_y_ = self.p2_y
        if not -20000000.0 <= p2_y_ <= 20000000.0: raise rt.Reject
        near = p2_y_ * 107.374182375 + 2147483648.0
        p2_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_y_raw_ < 0.9999847412109375: p2_y_raw_ = rt.exact_raw(p2_y_, _R_8)
        out += _S_2I.pack(p2_x_raw_, p2_y_raw_)
        p2_z_position_ = self.p2_z_position
        if p2_z_position_ is not None:
            mask |= 2
            if type(p2_z_position_) is not ReportLocalPathSegmentExt.P2_ZPosition: raise rt.Reject
            p2_z_position_._write(out)
        raw: list[int | float | bytes] = []
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_9)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_10)
            raw.append(path_tolerance_raw_)
        out += _M_ReportLocalPathSegmentExt_4[mask & 0x4].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.1"


_S_HB = rt.Packer("<HB")
_S_I = rt.Packer("<I")
_E_ReportLocalPathSegmentExt_P1_ZPositionChoice = rt.members(ReportLocalPathSegmentExt.P1_ZPositionChoice)
_R_3 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_ReportLocalPathSegmentExt_P2_ZPositionChoice = rt.members(ReportLocalPathSegmentExt.P2_ZPositionChoice)
_S_2I = rt.Packer("<2I")
_M_ReportLocalPathSegmentExt_4 = rt.Masks("", ((0, "H"), (4, "I")))
_R_8 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_R_9 = rt.Scaling(0.0, 500.0, 65535)
_R_10 = rt.Scaling(0.0, 100000.0, 4294967295)
_S_B = rt.Packer("<B")
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
QueryLocalPathSegment.REPORT = ReportLocalPathSegment
QueryLocalPathSegmentExt.REPORT = ReportLocalPathSegmentExt
QueryActiveElement.REPORT = ReportActiveElement
