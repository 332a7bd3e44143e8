"""urn:jaus:jss:mobility:LocalLoiterDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver


@dataclass(slots=True, repr=False)
class SetLocalLoiter(rt.Message):
    """SetLocalLoiter (0x0426): Sets place and pattern to loiter in the local frame.

    local_loiter_rec: The middle of the pattern in the local frame, the speed and the tolerance
    loiter: The pattern
    """

    CODE = 0x0426
    NAME = "SetLocalLoiter"
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    ZPosition = mobility_v1_0_types.ZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @dataclass(slots=True, repr=False)
    class LocalLoiterRec(rt.Struct):
        """The middle of the pattern in the local frame, the speed and the tolerance.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        z_position: optional. Vertical position and its datum
        """

        x: float
        y: float
        z_position: mobility_v1_0_types.ZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("X", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("ZPosition", mobility_v1_0_types.ZPosition.layout(), True),
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
                self.z_position, at = mobility_v1_0_types.ZPosition._read(data, at, nesting)
            else: self.z_position = None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            x_ = self.x
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_1)
            y_ = self.y
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_1)
            out += _S_2I.pack(x_raw_, y_raw_)
            z_position_ = self.z_position
            if z_position_ is not None:
                mask |= 1
                if type(z_position_) is not mobility_v1_0_types.ZPosition: raise rt.Reject
                z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class HoverPreference(IntEnum):
        """Values of HoverPreference."""

        XY_PRIORITY = 0
        Z_PRIORITY = 1

    @dataclass(slots=True, repr=False)
    class HoverRec(rt.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """

        hover_preference: SetLocalLoiter.HoverPreference | int
        xy_tolerance: float
        z_tolerance: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HoverPreference", rt.Number("B", rt.Values(SetLocalLoiter.HoverPreference))),
                ("XYTolerance", rt.real("I", 0.0, 100000.0, "meter")),
                ("ZTolerance", rt.real("I", 0.0, 50000.0, "meter")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            hover_preference_, xy_tolerance_, z_tolerance_ = _S_B2I.unpack_from(data, at)
            self.hover_preference = _E_SetLocalLoiter_HoverPreference[hover_preference_]
            self.xy_tolerance = xy_tolerance_ * 2.3283064370807974e-05
            self.z_tolerance = z_tolerance_ * 1.1641532185403987e-05
            return self, at + 9

        def _write(self, out: bytearray) -> None:
            hover_preference_ = self.hover_preference
            if hover_preference_ not in _E_SetLocalLoiter_HoverPreference: raise rt.Reject
            xy_tolerance_ = self.xy_tolerance
            if not 0.0 <= xy_tolerance_ <= 100000.0: raise rt.Reject
            near = xy_tolerance_ * 42949.67295 + 0.5
            xy_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_tolerance_raw_ < 0.9999847412109375: xy_tolerance_raw_ = rt.exact_raw(xy_tolerance_, _R_5)
            z_tolerance_ = self.z_tolerance
            if not 0.0 <= z_tolerance_ <= 50000.0: raise rt.Reject
            near = z_tolerance_ * 85899.3459 + 0.5
            z_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_tolerance_raw_ < 0.9999847412109375: z_tolerance_raw_ = rt.exact_raw(z_tolerance_, _R_6)
            out += _S_B2I.pack(hover_preference_, xy_tolerance_raw_, z_tolerance_raw_)

    local_loiter_rec: SetLocalLoiter.LocalLoiterRec
    loiter: SetLocalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LocalLoiterRec", SetLocalLoiter.LocalLoiterRec.layout()),
            ("Loiter", rt.Union.of("B", hover_rec=SetLocalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x26 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.local_loiter_rec, at = SetLocalLoiter.LocalLoiterRec._read(data, at, nesting)
        tag = data[at]
        at += 1
        self.loiter, at = _U_7[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x26\x04")
        local_loiter_rec_ = self.local_loiter_rec
        if type(local_loiter_rec_) is not SetLocalLoiter.LocalLoiterRec: raise rt.Reject
        local_loiter_rec_._write(out)
        loiter_ = self.loiter
        out.append(_T_8[type(loiter_)])
        loiter_._write(out)
        return bytes(out)


class SetTravelSpeedExt(mobility_v1_1_global_loiter_driver.SetTravelSpeedExt):
    """SetTravelSpeedExt (0x04AA): Sets the speed on the way as one of several kinds of speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class QueryLocalLoiter(rt.Message):
    """QueryLocalLoiter (0x2426): Asks for place and pattern of loitering in the local frame.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2426
    NAME = "QueryLocalLoiter"
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalLoiter]]

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
        if code != 0x2426: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2426, self.presence_vector)


class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeedExt]]


@dataclass(slots=True, repr=False)
class ReportLocalLoiter(rt.Message):
    """ReportLocalLoiter (0x4426): Tells place and pattern of loitering in the local frame.

    local_loiter_rec: The middle of the pattern in the local frame, the speed and the tolerance
    loiter: The pattern
    """

    CODE = 0x4426
    NAME = "ReportLocalLoiter"
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ZPosition = mobility_v1_0_types.ZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @dataclass(slots=True, repr=False)
    class LocalLoiterRec(rt.Struct):
        """The middle of the pattern in the local frame, the speed and the tolerance.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        z_position: optional. Vertical position and its datum
        """

        x: float
        y: float
        z_position: mobility_v1_0_types.ZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("X", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("Y", rt.real("I", -20000000.0, 20000000.0, "meter")),
                ("ZPosition", mobility_v1_0_types.ZPosition.layout(), True),
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
                self.z_position, at = mobility_v1_0_types.ZPosition._read(data, at, nesting)
            else: self.z_position = None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            x_ = self.x
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_1)
            y_ = self.y
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_1)
            out += _S_2I.pack(x_raw_, y_raw_)
            z_position_ = self.z_position
            if z_position_ is not None:
                mask |= 1
                if type(z_position_) is not mobility_v1_0_types.ZPosition: raise rt.Reject
                z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class HoverPreference(IntEnum):
        """Values of HoverPreference."""

        XY_PRIORITY = 0
        Z_PRIORITY = 1

    @dataclass(slots=True, repr=False)
    class HoverRec(rt.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """

        hover_preference: ReportLocalLoiter.HoverPreference | int
        xy_tolerance: float
        z_tolerance: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HoverPreference", rt.Number("B", rt.Values(ReportLocalLoiter.HoverPreference))),
                ("XYTolerance", rt.real("I", 0.0, 100000.0, "meter")),
                ("ZTolerance", rt.real("I", 0.0, 50000.0, "meter")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            hover_preference_, xy_tolerance_, z_tolerance_ = _S_B2I.unpack_from(data, at)
            self.hover_preference = _E_ReportLocalLoiter_HoverPreference[hover_preference_]
            self.xy_tolerance = xy_tolerance_ * 2.3283064370807974e-05
            self.z_tolerance = z_tolerance_ * 1.1641532185403987e-05
            return self, at + 9

        def _write(self, out: bytearray) -> None:
            hover_preference_ = self.hover_preference
            if hover_preference_ not in _E_ReportLocalLoiter_HoverPreference: raise rt.Reject
            xy_tolerance_ = self.xy_tolerance
            if not 0.0 <= xy_tolerance_ <= 100000.0: raise rt.Reject
            near = xy_tolerance_ * 42949.67295 + 0.5
            xy_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_tolerance_raw_ < 0.9999847412109375: xy_tolerance_raw_ = rt.exact_raw(xy_tolerance_, _R_5)
            z_tolerance_ = self.z_tolerance
            if not 0.0 <= z_tolerance_ <= 50000.0: raise rt.Reject
            near = z_tolerance_ * 85899.3459 + 0.5
            z_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_tolerance_raw_ < 0.9999847412109375: z_tolerance_raw_ = rt.exact_raw(z_tolerance_, _R_6)
            out += _S_B2I.pack(hover_preference_, xy_tolerance_raw_, z_tolerance_raw_)

    local_loiter_rec: ReportLocalLoiter.LocalLoiterRec
    loiter: ReportLocalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LocalLoiterRec", ReportLocalLoiter.LocalLoiterRec.layout()),
            ("Loiter", rt.Union.of("B", hover_rec=ReportLocalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x26 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.local_loiter_rec, at = ReportLocalLoiter.LocalLoiterRec._read(data, at, nesting)
        tag = data[at]
        at += 1
        self.loiter, at = _U_11[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x26\x44")
        local_loiter_rec_ = self.local_loiter_rec
        if type(local_loiter_rec_) is not ReportLocalLoiter.LocalLoiterRec: raise rt.Reject
        local_loiter_rec_._write(out)
        loiter_ = self.loiter
        out.append(_T_12[type(loiter_)])
        loiter_._write(out)
        return bytes(out)


class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalLoiterDriver"
    VERSION = "1.1"


_S_2I = rt.Packer("<2I")
_R_1 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_S_B = rt.Packer("<B")
_E_SetLocalLoiter_HoverPreference = rt.members(SetLocalLoiter.HoverPreference)
_S_B2I = rt.Packer("<B2I")
_R_5 = rt.Scaling(0.0, 100000.0, 4294967295)
_R_6 = rt.Scaling(0.0, 50000.0, 4294967295)
_U_7: tuple[type[SetLocalLoiter.HoverRec] | type[mobility_v1_0_types.PolygonRec] | type[mobility_v1_0_types.RaceTrackRec], ...] = (SetLocalLoiter.HoverRec, mobility_v1_0_types.PolygonRec, mobility_v1_0_types.RaceTrackRec)
_T_8: dict[type[rt.Struct], int] = {SetLocalLoiter.HoverRec: 0, mobility_v1_0_types.PolygonRec: 1, mobility_v1_0_types.RaceTrackRec: 2}
_S_HB = rt.Packer("<HB")
_E_ReportLocalLoiter_HoverPreference = rt.members(ReportLocalLoiter.HoverPreference)
_U_11: tuple[type[ReportLocalLoiter.HoverRec] | type[mobility_v1_0_types.PolygonRec] | type[mobility_v1_0_types.RaceTrackRec], ...] = (ReportLocalLoiter.HoverRec, mobility_v1_0_types.PolygonRec, mobility_v1_0_types.RaceTrackRec)
_T_12: dict[type[rt.Struct], int] = {ReportLocalLoiter.HoverRec: 0, mobility_v1_0_types.PolygonRec: 1, mobility_v1_0_types.RaceTrackRec: 2}
QueryLocalLoiter.REPORT = ReportLocalLoiter
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
