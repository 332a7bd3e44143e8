"""urn:jaus:jss:mobility:LocalPathSegmentDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver


@dataclass(slots=True, repr=False, kw_only=True)
class SetLocalPathSegment(rt.Message):
    """SetLocalPathSegment (0x0410): Describes a path segment in the local frame; sent as an element of the list,
    not by itself.

    p1_x: -100000..100000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -100000..100000 meter. Position of the shaping point P1 along Y, in metres
    p1_z: -10000..35000 meter, optional. Position of the shaping point P1 along Z, in metres
    p2_x: -100000..100000 meter. Position of the end point P2 along X, in metres
    p2_y: -100000..100000 meter. Position of the end point P2 along Y, in metres
    p2_z: -10000..35000 meter, optional. Position of the end point P2 along Z, in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x0410
    NAME = "SetLocalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    p1_x: float
    p1_y: float
    p1_z: float | None = None
    p2_x: float
    p2_y: float
    p2_z: float | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P1_Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P1_Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("P2_X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P2_Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P2_Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0410: raise rt.Reject
        raw = iter(_M_SetLocalPathSegment[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        p1_x_ = raw()
        self.p1_x = -100000.0 + p1_x_ * 4.656612874161595e-05
        p1_y_ = raw()
        self.p1_y = -100000.0 + p1_y_ * 4.656612874161595e-05
        self.p1_z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        p2_x_ = raw()
        self.p2_x = -100000.0 + p2_x_ * 4.656612874161595e-05
        p2_y_ = raw()
        self.p2_y = -100000.0 + p2_y_ * 4.656612874161595e-05
        self.p2_z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        p1_x_ = self.p1_x
        if not -100000.0 <= p1_x_ <= 100000.0: raise rt.Reject
        near = p1_x_ * 21474.836475 + 2147483648.0
        p1_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_x_raw_ < 0.9999847412109375: p1_x_raw_ = rt.exact_raw(p1_x_, _R_2)
        raw.append(p1_x_raw_)
        p1_y_ = self.p1_y
        if not -100000.0 <= p1_y_ <= 100000.0: raise rt.Reject
        near = p1_y_ * 21474.836475 + 2147483648.0
        p1_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_y_raw_ < 0.9999847412109375: p1_y_raw_ = rt.exact_raw(p1_y_, _R_2)
        raw.append(p1_y_raw_)
        p1_z_ = self.p1_z
        if p1_z_ is not None:
            mask |= 1
            if not -10000.0 <= p1_z_ <= 35000.0: raise rt.Reject
            near = p1_z_ * 95443.71766666666 + 954437177.1666666
            p1_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - p1_z_raw_ < 0.9999847412109375: p1_z_raw_ = rt.exact_raw(p1_z_, _R_3)
            raw.append(p1_z_raw_)
        p2_x_ = self.p2_x
        if not -100000.0 <= p2_x_ <= 100000.0: raise rt.Reject
        near = p2_x_ * 21474.836475 + 2147483648.0
        p2_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_x_raw_ < 0.9999847412109375: p2_x_raw_ = rt.exact_raw(p2_x_, _R_2)
        raw.append(p2_x_raw_)
        p2_y_ = self.p2_y
        if not -100000.0 <= p2_y_ <= 100000.0: raise rt.Reject
        near = p2_y_ * 21474.836475 + 2147483648.0
        p2_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_y_raw_ < 0.9999847412109375: p2_y_raw_ = rt.exact_raw(p2_y_, _R_2)
        raw.append(p2_y_raw_)
        p2_z_ = self.p2_z
        if p2_z_ is not None:
            mask |= 2
            if not -10000.0 <= p2_z_ <= 35000.0: raise rt.Reject
            near = p2_z_ * 95443.71766666666 + 954437177.1666666
            p2_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - p2_z_raw_ < 0.9999847412109375: p2_z_raw_ = rt.exact_raw(p2_z_, _R_3)
            raw.append(p2_z_raw_)
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_4)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_5)
            raw.append(path_tolerance_raw_)
        return _M_SetLocalPathSegment_pack[mask & 0x7].pack(0x0410, mask, *raw)


class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList):
    """ExecuteList (0x041E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportTravelSpeed]]


@dataclass(slots=True, repr=False)
class QueryLocalPathSegment(rt.Message):
    """QueryLocalPathSegment (0x2410): Asks for the path segment in the local frame being followed.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2410
    NAME = "QueryLocalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalPathSegment]]

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
        if code != 0x2410: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2410, self.presence_vector)


class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False, kw_only=True)
class ReportLocalPathSegment(rt.Message):
    """ReportLocalPathSegment (0x4410): Tells the path segment in the local frame being followed.

    p1_x: -100000..100000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -100000..100000 meter. Position of the shaping point P1 along Y, in metres
    p1_z: -10000..35000 meter, optional. Position of the shaping point P1 along Z, in metres
    p2_x: -100000..100000 meter. Position of the end point P2 along X, in metres
    p2_y: -100000..100000 meter. Position of the end point P2 along Y, in metres
    p2_z: -10000..35000 meter, optional. Position of the end point P2 along Z, in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x4410
    NAME = "ReportLocalPathSegment"
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    p1_x: float
    p1_y: float
    p1_z: float | None = None
    p2_x: float
    p2_y: float
    p2_z: float | None = None
    weighting_factor: float
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("P1_X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P1_Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P1_Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("P2_X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P2_Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("P2_Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("WeightingFactor", rt.real("H", 0.0, 500.0)),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4410: raise rt.Reject
        raw = iter(_M_SetLocalPathSegment[mask & 0x7].unpack(data)).__next__
        self = rt.new(cls)
        p1_x_ = raw()
        self.p1_x = -100000.0 + p1_x_ * 4.656612874161595e-05
        p1_y_ = raw()
        self.p1_y = -100000.0 + p1_y_ * 4.656612874161595e-05
        self.p1_z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        p2_x_ = raw()
        self.p2_x = -100000.0 + p2_x_ * 4.656612874161595e-05
        p2_y_ = raw()
        self.p2_y = -100000.0 + p2_y_ * 4.656612874161595e-05
        self.p2_z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        weighting_factor_ = raw()
        self.weighting_factor = weighting_factor_ * 0.007629510948348211
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        p1_x_ = self.p1_x
        if not -100000.0 <= p1_x_ <= 100000.0: raise rt.Reject
        near = p1_x_ * 21474.836475 + 2147483648.0
        p1_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_x_raw_ < 0.9999847412109375: p1_x_raw_ = rt.exact_raw(p1_x_, _R_2)
        raw.append(p1_x_raw_)
        p1_y_ = self.p1_y
        if not -100000.0 <= p1_y_ <= 100000.0: raise rt.Reject
        near = p1_y_ * 21474.836475 + 2147483648.0
        p1_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p1_y_raw_ < 0.9999847412109375: p1_y_raw_ = rt.exact_raw(p1_y_, _R_2)
        raw.append(p1_y_raw_)
        p1_z_ = self.p1_z
        if p1_z_ is not None:
            mask |= 1
            if not -10000.0 <= p1_z_ <= 35000.0: raise rt.Reject
            near = p1_z_ * 95443.71766666666 + 954437177.1666666
            p1_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - p1_z_raw_ < 0.9999847412109375: p1_z_raw_ = rt.exact_raw(p1_z_, _R_3)
            raw.append(p1_z_raw_)
        p2_x_ = self.p2_x
        if not -100000.0 <= p2_x_ <= 100000.0: raise rt.Reject
        near = p2_x_ * 21474.836475 + 2147483648.0
        p2_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_x_raw_ < 0.9999847412109375: p2_x_raw_ = rt.exact_raw(p2_x_, _R_2)
        raw.append(p2_x_raw_)
        p2_y_ = self.p2_y
        if not -100000.0 <= p2_y_ <= 100000.0: raise rt.Reject
        near = p2_y_ * 21474.836475 + 2147483648.0
        p2_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - p2_y_raw_ < 0.9999847412109375: p2_y_raw_ = rt.exact_raw(p2_y_, _R_2)
        raw.append(p2_y_raw_)
        p2_z_ = self.p2_z
        if p2_z_ is not None:
            mask |= 2
            if not -10000.0 <= p2_z_ <= 35000.0: raise rt.Reject
            near = p2_z_ * 95443.71766666666 + 954437177.1666666
            p2_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - p2_z_raw_ < 0.9999847412109375: p2_z_raw_ = rt.exact_raw(p2_z_, _R_3)
            raw.append(p2_z_raw_)
        weighting_factor_ = self.weighting_factor
        if not 0.0 <= weighting_factor_ <= 500.0: raise rt.Reject
        near = weighting_factor_ * 131.07 + 0.5
        weighting_factor_raw_ = int(near)
        if not 1.52587890625e-05 < near - weighting_factor_raw_ < 0.9999847412109375: weighting_factor_raw_ = rt.exact_raw(weighting_factor_, _R_4)
        raw.append(weighting_factor_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 4
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_5)
            raw.append(path_tolerance_raw_)
        return _M_SetLocalPathSegment_pack[mask & 0x7].pack(0x4410, mask, *raw)


class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPathSegmentDriver"
    VERSION = "1.0"


_S_HB = rt.Packer("<HB")
_M_SetLocalPathSegment = rt.Masks("3x", ((0, "I"), (0, "I"), (1, "I"), (0, "I"), (0, "I"), (2, "I"), (0, "H"), (4, "I")))
_R_2 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_R_3 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_4 = rt.Scaling(0.0, 500.0, 65535)
_R_5 = rt.Scaling(0.0, 100000.0, 4294967295)
_M_SetLocalPathSegment_pack = rt.Masks("HB", ((0, "I"), (0, "I"), (1, "I"), (0, "I"), (0, "I"), (2, "I"), (0, "H"), (4, "I")))
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryLocalPathSegment.REPORT = ReportLocalPathSegment
QueryActiveElement.REPORT = ReportActiveElement
