"""urn:jaus:jss:mobility:GlobalLoiterDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class SetGlobalLoiter(rt.Message):
    """SetGlobalLoiter (0x0425): Sets place and pattern to loiter on the globe.

    global_loiter_rec: The middle of the pattern on the globe, the speed and the tolerance
    loiter: The pattern
    """

    CODE = 0x0425
    NAME = "SetGlobalLoiter"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @dataclass(slots=True, repr=False)
    class GlobalLoiterRec(rt.Struct):
        """The middle of the pattern on the globe, the speed and the tolerance.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        z_position: optional. Vertical position and its datum
        """

        latitude: float
        longitude: float
        z_position: mobility_v1_0_types.GlobalZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
                ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
                ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
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
                self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
            else: self.z_position = None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            latitude_ = self.latitude
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_1)
            longitude_ = self.longitude
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_2)
            out += _S_2I.pack(latitude_raw_, longitude_raw_)
            z_position_ = self.z_position
            if z_position_ is not None:
                mask |= 1
                if type(z_position_) is not mobility_v1_0_types.GlobalZPosition: raise rt.Reject
                z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class HoverPreference(IntEnum):
        """Values of HoverPreference."""

        LAT_LON_PRIORITY = 0
        Z_PRIORITY = 1

    @dataclass(slots=True, repr=False)
    class HoverRec(rt.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """

        hover_preference: SetGlobalLoiter.HoverPreference | int
        xy_tolerance: float
        z_tolerance: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HoverPreference", rt.Number("B", rt.Values(SetGlobalLoiter.HoverPreference))),
                ("XYTolerance", rt.real("I", 0.0, 100000.0, "meter")),
                ("ZTolerance", rt.real("I", 0.0, 50000.0, "meter")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            hover_preference_, xy_tolerance_, z_tolerance_ = _S_B2I.unpack_from(data, at)
            self.hover_preference = _E_SetGlobalLoiter_HoverPreference[hover_preference_]
            self.xy_tolerance = xy_tolerance_ * 2.3283064370807974e-05
            self.z_tolerance = z_tolerance_ * 1.1641532185403987e-05
            return self, at + 9

        def _write(self, out: bytearray) -> None:
            hover_preference_ = self.hover_preference
            if hover_preference_ not in _E_SetGlobalLoiter_HoverPreference: raise rt.Reject
            xy_tolerance_ = self.xy_tolerance
            if not 0.0 <= xy_tolerance_ <= 100000.0: raise rt.Reject
            near = xy_tolerance_ * 42949.67295 + 0.5
            xy_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_tolerance_raw_ < 0.9999847412109375: xy_tolerance_raw_ = rt.exact_raw(xy_tolerance_, _R_6)
            z_tolerance_ = self.z_tolerance
            if not 0.0 <= z_tolerance_ <= 50000.0: raise rt.Reject
            near = z_tolerance_ * 85899.3459 + 0.5
            z_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_tolerance_raw_ < 0.9999847412109375: z_tolerance_raw_ = rt.exact_raw(z_tolerance_, _R_7)
            out += _S_B2I.pack(hover_preference_, xy_tolerance_raw_, z_tolerance_raw_)

    global_loiter_rec: SetGlobalLoiter.GlobalLoiterRec
    loiter: SetGlobalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GlobalLoiterRec", SetGlobalLoiter.GlobalLoiterRec.layout()),
            ("Loiter", rt.Union.of("B", hover_rec=SetGlobalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x25 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.global_loiter_rec, at = SetGlobalLoiter.GlobalLoiterRec._read(data, at, nesting)
        tag = data[at]
        at += 1
        self.loiter, at = _U_8[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x25\x04")
        global_loiter_rec_ = self.global_loiter_rec
        if type(global_loiter_rec_) is not SetGlobalLoiter.GlobalLoiterRec: raise rt.Reject
        global_loiter_rec_._write(out)
        loiter_ = self.loiter
        out.append(_T_9[type(loiter_)])
        loiter_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class SetTravelSpeedExt(rt.Message):
    """SetTravelSpeedExt (0x04AA): Sets the speed on the way as one of several kinds of speed.

    speed: Speed on the way, and its kind
    """

    CODE = 0x04AA
    NAME = "SetTravelSpeedExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    Speed = mobility_v1_0_types.Speed

    speed: mobility_v1_0_types.Speed

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Speed", mobility_v1_0_types.Speed.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAA or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.speed, at = mobility_v1_0_types.Speed._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xaa\x04")
        speed_ = self.speed
        if type(speed_) is not mobility_v1_0_types.Speed: raise rt.Reject
        speed_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryGlobalLoiter(rt.Message):
    """QueryGlobalLoiter (0x2425): Asks for place and pattern of loitering on the globe.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2425
    NAME = "QueryGlobalLoiter"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalLoiter]]

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
        if code != 0x2425: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2425, self.presence_vector)


@dataclass(slots=True, repr=False)
class QueryTravelSpeedExt(rt.Message):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    CODE = 0x24AA
    NAME = "QueryTravelSpeedExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTravelSpeedExt]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\xaa$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x24AA)


@dataclass(slots=True, repr=False)
class ReportGlobalLoiter(rt.Message):
    """ReportGlobalLoiter (0x4425): Tells place and pattern of loitering on the globe.

    global_loiter_rec: The middle of the pattern on the globe, the speed and the tolerance
    loiter: The pattern
    """

    CODE = 0x4425
    NAME = "ReportGlobalLoiter"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @dataclass(slots=True, repr=False)
    class GlobalLoiterRec(rt.Struct):
        """The middle of the pattern on the globe, the speed and the tolerance.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        z_position: optional. Vertical position and its datum
        """

        latitude: float
        longitude: float
        z_position: mobility_v1_0_types.GlobalZPosition | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
                ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
                ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
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
                self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
            else: self.z_position = None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            latitude_ = self.latitude
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_1)
            longitude_ = self.longitude
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_2)
            out += _S_2I.pack(latitude_raw_, longitude_raw_)
            z_position_ = self.z_position
            if z_position_ is not None:
                mask |= 1
                if type(z_position_) is not mobility_v1_0_types.GlobalZPosition: raise rt.Reject
                z_position_._write(out)
            _S_B.pack_into(out, start, mask)

    class HoverPreference(IntEnum):
        """Values of HoverPreference."""

        LAT_LON_PRIORITY = 0
        Z_PRIORITY = 1

    @dataclass(slots=True, repr=False)
    class HoverRec(rt.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """

        hover_preference: ReportGlobalLoiter.HoverPreference | int
        xy_tolerance: float
        z_tolerance: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HoverPreference", rt.Number("B", rt.Values(ReportGlobalLoiter.HoverPreference))),
                ("XYTolerance", rt.real("I", 0.0, 100000.0, "meter")),
                ("ZTolerance", rt.real("I", 0.0, 50000.0, "meter")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            hover_preference_, xy_tolerance_, z_tolerance_ = _S_B2I.unpack_from(data, at)
            self.hover_preference = _E_ReportGlobalLoiter_HoverPreference[hover_preference_]
            self.xy_tolerance = xy_tolerance_ * 2.3283064370807974e-05
            self.z_tolerance = z_tolerance_ * 1.1641532185403987e-05
            return self, at + 9

        def _write(self, out: bytearray) -> None:
            hover_preference_ = self.hover_preference
            if hover_preference_ not in _E_ReportGlobalLoiter_HoverPreference: raise rt.Reject
            xy_tolerance_ = self.xy_tolerance
            if not 0.0 <= xy_tolerance_ <= 100000.0: raise rt.Reject
            near = xy_tolerance_ * 42949.67295 + 0.5
            xy_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_tolerance_raw_ < 0.9999847412109375: xy_tolerance_raw_ = rt.exact_raw(xy_tolerance_, _R_6)
            z_tolerance_ = self.z_tolerance
            if not 0.0 <= z_tolerance_ <= 50000.0: raise rt.Reject
            near = z_tolerance_ * 85899.3459 + 0.5
            z_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_tolerance_raw_ < 0.9999847412109375: z_tolerance_raw_ = rt.exact_raw(z_tolerance_, _R_7)
            out += _S_B2I.pack(hover_preference_, xy_tolerance_raw_, z_tolerance_raw_)

    global_loiter_rec: ReportGlobalLoiter.GlobalLoiterRec
    loiter: ReportGlobalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GlobalLoiterRec", ReportGlobalLoiter.GlobalLoiterRec.layout()),
            ("Loiter", rt.Union.of("B", hover_rec=ReportGlobalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x25 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.global_loiter_rec, at = ReportGlobalLoiter.GlobalLoiterRec._read(data, at, nesting)
        tag = data[at]
        at += 1
        self.loiter, at = _U_13[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x25\x44")
        global_loiter_rec_ = self.global_loiter_rec
        if type(global_loiter_rec_) is not ReportGlobalLoiter.GlobalLoiterRec: raise rt.Reject
        global_loiter_rec_._write(out)
        loiter_ = self.loiter
        out.append(_T_14[type(loiter_)])
        loiter_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportTravelSpeedExt(rt.Message):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind.

    speed: Speed on the way, and its kind
    """

    CODE = 0x44AA
    NAME = "ReportTravelSpeedExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalLoiterDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    Speed = mobility_v1_0_types.Speed

    speed: mobility_v1_0_types.Speed

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Speed", mobility_v1_0_types.Speed.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAA or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        at = 2
        self.speed, at = mobility_v1_0_types.Speed._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xaa\x44")
        speed_ = self.speed
        if type(speed_) is not mobility_v1_0_types.Speed: raise rt.Reject
        speed_._write(out)
        return bytes(out)


_S_2I = rt.Packer("<2I")
_R_1 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_2 = rt.Scaling(-180.0, 180.0, 4294967295)
_S_B = rt.Packer("<B")
_E_SetGlobalLoiter_HoverPreference = rt.members(SetGlobalLoiter.HoverPreference)
_S_B2I = rt.Packer("<B2I")
_R_6 = rt.Scaling(0.0, 100000.0, 4294967295)
_R_7 = rt.Scaling(0.0, 50000.0, 4294967295)
_U_8: tuple[type[SetGlobalLoiter.HoverRec] | type[mobility_v1_0_types.PolygonRec] | type[mobility_v1_0_types.RaceTrackRec], ...] = (SetGlobalLoiter.HoverRec, mobility_v1_0_types.PolygonRec, mobility_v1_0_types.RaceTrackRec)
_T_9: dict[type[rt.Struct], int] = {SetGlobalLoiter.HoverRec: 0, mobility_v1_0_types.PolygonRec: 1, mobility_v1_0_types.RaceTrackRec: 2}
_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_E_ReportGlobalLoiter_HoverPreference = rt.members(ReportGlobalLoiter.HoverPreference)
_U_13: tuple[type[ReportGlobalLoiter.HoverRec] | type[mobility_v1_0_types.PolygonRec] | type[mobility_v1_0_types.RaceTrackRec], ...] = (ReportGlobalLoiter.HoverRec, mobility_v1_0_types.PolygonRec, mobility_v1_0_types.RaceTrackRec)
_T_14: dict[type[rt.Struct], int] = {ReportGlobalLoiter.HoverRec: 0, mobility_v1_0_types.PolygonRec: 1, mobility_v1_0_types.RaceTrackRec: 2}
QueryGlobalLoiter.REPORT = ReportGlobalLoiter
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
