"""urn:jaus:jss:mobility:GlobalPathSegmentDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False, kw_only=True)
class SetGlobalPathSegment(rt.Message):
    """SetGlobalPathSegment (0x040F): Describes a path segment on the globe; sent as an element of the list, not by
    itself.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_altitude: -10000..35000 meter, optional. Altitude of the shaping point P1 (WGS 84), in metres
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p2_altitude: -10000..35000 meter, optional. Altitude of the end point P2 (WGS 84), in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x040F
    NAME = "SetGlobalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    p1_latitude: float
    p1_longitude: float
    p1_altitude: float | None = None
    p2_latitude: float
    p2_longitude: float
    p2_altitude: float | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P1_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P1_Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("P2_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P2_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P2_Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x040F: raise rt.Reject
        raw = iter(_M_SetGlobalPathSegment[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        p1_latitude_ = raw()
        self.p1_latitude = -90.0 + p1_latitude_ * 4.190951586745435e-08
        p1_longitude_ = raw()
        self.p1_longitude = -180.0 + p1_longitude_ * 8.38190317349087e-08
        self.p1_altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        p2_latitude_ = raw()
        self.p2_latitude = -90.0 + p2_latitude_ * 4.190951586745435e-08
        p2_longitude_ = raw()
        self.p2_longitude = -180.0 + p2_longitude_ * 8.38190317349087e-08
        self.p2_altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        p1_latitude_ = self.p1_latitude
        if not -90.0 <= p1_latitude_ <= 90.0: raise rt.Reject
        near = p1_latitude_ * 23860929.416666668 + 2147483648.0
        p1_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_latitude_raw_ < 0.9999847412109375: p1_latitude_raw_ = rt.exact_raw(p1_latitude_, _R_2)
        raw.append(p1_latitude_raw_)
        p1_longitude_ = self.p1_longitude
        if not -180.0 <= p1_longitude_ <= 180.0: raise rt.Reject
        near = p1_longitude_ * 11930464.708333334 + 2147483648.0
        p1_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_longitude_raw_ < 0.9999847412109375: p1_longitude_raw_ = rt.exact_raw(p1_longitude_, _R_3)
        raw.append(p1_longitude_raw_)
        p1_altitude_ = self.p1_altitude
        if p1_altitude_ is not None:
            mask |= 1
            if not -10000.0 <= p1_altitude_ <= 35000.0: raise rt.Reject
            near = p1_altitude_ * 95443.71766666666 + 954437177.1666666
            p1_altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - p1_altitude_raw_ < 0.9999847412109375: p1_altitude_raw_ = rt.exact_raw(p1_altitude_, _R_4)
            raw.append(p1_altitude_raw_)
        p2_latitude_ = self.p2_latitude
        if not -90.0 <= p2_latitude_ <= 90.0: raise rt.Reject
        near = p2_latitude_ * 23860929.416666668 + 2147483648.0
        p2_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_latitude_raw_ < 0.9999847412109375: p2_latitude_raw_ = rt.exact_raw(p2_latitude_, _R_2)
        raw.append(p2_latitude_raw_)
        p2_longitude_ = self.p2_longitude
        if not -180.0 <= p2_longitude_ <= 180.0: raise rt.Reject
        near = p2_longitude_ * 11930464.708333334 + 2147483648.0
        p2_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_longitude_raw_ < 0.9999847412109375: p2_longitude_raw_ = rt.exact_raw(p2_longitude_, _R_3)
        raw.append(p2_longitude_raw_)
        p2_altitude_ = self.p2_altitude
        if p2_altitude_ is not None:
            mask |= 2
            if not -10000.0 <= p2_altitude_ <= 35000.0: raise rt.Reject
            near = p2_altitude_ * 95443.71766666666 + 954437177.1666666
            p2_altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - p2_altitude_raw_ < 0.9999847412109375: p2_altitude_raw_ = rt.exact_raw(p2_altitude_, _R_4)
            raw.append(p2_altitude_raw_)
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_5)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_6)
            raw.append(path_tolerance_raw_)
        return _M_SetGlobalPathSegment_pack[mask & 0x7].pack(0x040F, mask, *raw)


@dataclass(slots=True, repr=False)
class ExecuteList(rt.Message):
    """ExecuteList (0x041E): Starts the list at an element, at a speed.

    speed: 0..327.67 meter per second. Speed to go through the list, in metres per second
    element_uid: optional. The element to start with
    """

    CODE = 0x041E
    NAME = "ExecuteList"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
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
        if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_9)
        raw.append(speed_raw_)
        element_uid_ = self.element_uid
        if element_uid_ is not None:
            mask |= 1
            raw.append(element_uid_)
        return _M_ExecuteList_pack[mask & 0x1].pack(0x041E, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryTravelSpeed(rt.Message):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    CODE = 0x240A
    NAME = "QueryTravelSpeed"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTravelSpeed]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\n$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x240A)


@dataclass(slots=True, repr=False)
class QueryGlobalPathSegment(rt.Message):
    """QueryGlobalPathSegment (0x240F): Asks for the path segment on the globe being followed.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x240F
    NAME = "QueryGlobalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalPathSegment]]

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
        if code != 0x240F: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x240F, self.presence_vector)


@dataclass(slots=True, repr=False)
class QueryActiveElement(rt.Message):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    CODE = 0x241E
    NAME = "QueryActiveElement"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportActiveElement]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x1e$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x241E)


@dataclass(slots=True, repr=False)
class ReportTravelSpeed(rt.Message):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set.

    speed: 0..327.67 meter per second. Speed on the way, in metres per second
    """

    CODE = 0x440A
    NAME = "ReportTravelSpeed"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    speed: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Speed", rt.real("H", 0.0, 327.67, "meter per second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, speed_ = _S_2H.unpack(data)
        if code != 0x440A: raise rt.Reject
        self.speed = speed_ * 0.0049999237048905165
        return self

    def _pack(self) -> bytes:
        speed_ = self.speed
        if not 0.0 <= speed_ <= 327.67: raise rt.Reject
        near = speed_ * 200.0030518509476 + 0.5
        speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_9)
        return _S_2H.pack(0x440A, speed_raw_)


@dataclass(slots=True, repr=False, kw_only=True)
class ReportGlobalPathSegment(rt.Message):
    """ReportGlobalPathSegment (0x440F): Tells the path segment on the globe being followed.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_altitude: -10000..35000 meter, optional. Altitude of the shaping point P1 (WGS 84), in metres
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p2_altitude: -10000..35000 meter, optional. Altitude of the end point P2 (WGS 84), in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x440F
    NAME = "ReportGlobalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    p1_latitude: float
    p1_longitude: float
    p1_altitude: float | None = None
    p2_latitude: float
    p2_longitude: float
    p2_altitude: float | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P1_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P1_Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("P2_Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("P2_Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("P2_Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x440F: raise rt.Reject
        raw = iter(_M_SetGlobalPathSegment[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        p1_latitude_ = raw()
        self.p1_latitude = -90.0 + p1_latitude_ * 4.190951586745435e-08
        p1_longitude_ = raw()
        self.p1_longitude = -180.0 + p1_longitude_ * 8.38190317349087e-08
        self.p1_altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        p2_latitude_ = raw()
        self.p2_latitude = -90.0 + p2_latitude_ * 4.190951586745435e-08
        p2_longitude_ = raw()
        self.p2_longitude = -180.0 + p2_longitude_ * 8.38190317349087e-08
        self.p2_altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        p1_latitude_ = self.p1_latitude
        if not -90.0 <= p1_latitude_ <= 90.0: raise rt.Reject
        near = p1_latitude_ * 23860929.416666668 + 2147483648.0
        p1_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_latitude_raw_ < 0.9999847412109375: p1_latitude_raw_ = rt.exact_raw(p1_latitude_, _R_2)
        raw.append(p1_latitude_raw_)
        p1_longitude_ = self.p1_longitude
        if not -180.0 <= p1_longitude_ <= 180.0: raise rt.Reject
        near = p1_longitude_ * 11930464.708333334 + 2147483648.0
        p1_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_longitude_raw_ < 0.9999847412109375: p1_longitude_raw_ = rt.exact_raw(p1_longitude_, _R_3)
        raw.append(p1_longitude_raw_)
        p1_altitude_ = self.p1_altitude
        if p1_altitude_ is not None:
            mask |= 1
            if not -10000.0 <= p1_altitude_ <= 35000.0: raise rt.Reject
            near = p1_altitude_ * 95443.71766666666 + 954437177.1666666
            p1_altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - p1_altitude_raw_ < 0.9999847412109375: p1_altitude_raw_ = rt.exact_raw(p1_altitude_, _R_4)
            raw.append(p1_altitude_raw_)
        p2_latitude_ = self.p2_latitude
        if not -90.0 <= p2_latitude_ <= 90.0: raise rt.Reject
        near = p2_latitude_ * 23860929.416666668 + 2147483648.0
        p2_latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_latitude_raw_ < 0.9999847412109375: p2_latitude_raw_ = rt.exact_raw(p2_latitude_, _R_2)
        raw.append(p2_latitude_raw_)
        p2_longitude_ = self.p2_longitude
        if not -180.0 <= p2_longitude_ <= 180.0: raise rt.Reject
        near = p2_longitude_ * 11930464.708333334 + 2147483648.0
        p2_longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_longitude_raw_ < 0.9999847412109375: p2_longitude_raw_ = rt.exact_raw(p2_longitude_, _R_3)
        raw.append(p2_longitude_raw_)
        p2_altitude_ = self.p2_altitude
        if p2_altitude_ is not None:
            mask |= 2
            if not -10000.0 <= p2_altitude_ <= 35000.0: raise rt.Reject
            near = p2_altitude_ * 95443.71766666666 + 954437177.1666666
            p2_altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - p2_altitude_raw_ < 0.9999847412109375: p2_altitude_raw_ = rt.exact_raw(p2_altitude_, _R_4)
            raw.append(p2_altitude_raw_)
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_5)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_6)
            raw.append(path_tolerance_raw_)
        return _M_SetGlobalPathSegment_pack[mask & 0x7].pack(0x440F, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportActiveElement(rt.Message):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out.

    element_uid: The element being carried out; 0 when there is none
    """

    CODE = 0x441E
    NAME = "ReportActiveElement"
    SERVICE = "urn:jaus:jss:mobility:GlobalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    element_uid: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementUID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.element_uid = _S_2H.unpack(data)
        if code != 0x441E: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x441E, self.element_uid)


_S_HB = rt.Packer("<HB")
_M_SetGlobalPathSegment = rt.Masks("3x", ((0, "I"), (0, "I"), (1, "I"), (0, "I"), (0, "I"), (2, "I"), (0, "H"), (4, "I")))
_R_2 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_3 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_4 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_5 = rt.Scaling(0.0, 500.0, 65535)
_R_6 = rt.Scaling(0.0, 100000.0, 4294967295)
_M_SetGlobalPathSegment_pack = rt.Masks("HB", ((0, "I"), (0, "I"), (1, "I"), (0, "I"), (0, "I"), (2, "I"), (0, "H"), (4, "I")))
_M_ExecuteList = rt.Masks("3x", ((0, "H"), (1, "H")))
_R_9 = rt.Scaling(0.0, 327.67, 65535)
_M_ExecuteList_pack = rt.Masks("HB", ((0, "H"), (1, "H")))
_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryGlobalPathSegment.REPORT = ReportGlobalPathSegment
QueryActiveElement.REPORT = ReportActiveElement
