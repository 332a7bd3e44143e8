"""urn:jaus:jss:ugv:SkidSteerDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetSkidSteerEffort(rt.Message):
    """SetSkidSteerEffort (0x0501): Sets the efforts left and right.

    left_side_propulsive_effort: -100..100. Effort on the left, in percent of the maximum; positive drives forward
    right_side_propulsive_effort: -100..100. Effort on the right, in percent of the maximum; positive drives forward
    """

    CODE = 0x0501
    NAME = "SetSkidSteerEffort"
    SERVICE = "urn:jaus:jss:ugv:SkidSteerDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    left_side_propulsive_effort: float
    right_side_propulsive_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LeftSidePropulsiveEffort", rt.real("H", -100.0, 100.0)),
            ("RightSidePropulsiveEffort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, left_side_propulsive_effort_, right_side_propulsive_effort_ = _S_3H.unpack(data)
        if code != 0x0501: raise rt.Reject
        self.left_side_propulsive_effort = -100.0 + left_side_propulsive_effort_ * 0.0030518043793392844
        self.right_side_propulsive_effort = -100.0 + right_side_propulsive_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        left_side_propulsive_effort_ = self.left_side_propulsive_effort
        if not -100.0 <= left_side_propulsive_effort_ <= 100.0: raise rt.Reject
        near = left_side_propulsive_effort_ * 327.675 + 32768.0
        left_side_propulsive_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - left_side_propulsive_effort_raw_ < 0.9999847412109375: left_side_propulsive_effort_raw_ = rt.exact_raw(left_side_propulsive_effort_, _R_1)
        right_side_propulsive_effort_ = self.right_side_propulsive_effort
        if not -100.0 <= right_side_propulsive_effort_ <= 100.0: raise rt.Reject
        near = right_side_propulsive_effort_ * 327.675 + 32768.0
        right_side_propulsive_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - right_side_propulsive_effort_raw_ < 0.9999847412109375: right_side_propulsive_effort_raw_ = rt.exact_raw(right_side_propulsive_effort_, _R_1)
        return _S_3H.pack(0x0501, left_side_propulsive_effort_raw_, right_side_propulsive_effort_raw_)


@dataclass(slots=True, repr=False)
class QuerySkidSteerEffort(rt.Message):
    """QuerySkidSteerEffort (0x2501): Asks for the efforts left and right."""

    CODE = 0x2501
    NAME = "QuerySkidSteerEffort"
    SERVICE = "urn:jaus:jss:ugv:SkidSteerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportSkidSteerEffort]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x01%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2501)


@dataclass(slots=True, repr=False)
class ReportSkidSteerEffort(rt.Message):
    """ReportSkidSteerEffort (0x4501): Tells the efforts left and right.

    left_side_propulsive_effort: -100..100. Effort on the left, in percent of the maximum; positive drives forward
    right_side_propulsive_effort: -100..100. Effort on the right, in percent of the maximum; positive drives forward
    """

    CODE = 0x4501
    NAME = "ReportSkidSteerEffort"
    SERVICE = "urn:jaus:jss:ugv:SkidSteerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    left_side_propulsive_effort: float
    right_side_propulsive_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LeftSidePropulsiveEffort", rt.real("H", -100.0, 100.0)),
            ("RightSidePropulsiveEffort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, left_side_propulsive_effort_, right_side_propulsive_effort_ = _S_3H.unpack(data)
        if code != 0x4501: raise rt.Reject
        self.left_side_propulsive_effort = -100.0 + left_side_propulsive_effort_ * 0.0030518043793392844
        self.right_side_propulsive_effort = -100.0 + right_side_propulsive_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        left_side_propulsive_effort_ = self.left_side_propulsive_effort
        if not -100.0 <= left_side_propulsive_effort_ <= 100.0: raise rt.Reject
        near = left_side_propulsive_effort_ * 327.675 + 32768.0
        left_side_propulsive_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - left_side_propulsive_effort_raw_ < 0.9999847412109375: left_side_propulsive_effort_raw_ = rt.exact_raw(left_side_propulsive_effort_, _R_1)
        right_side_propulsive_effort_ = self.right_side_propulsive_effort
        if not -100.0 <= right_side_propulsive_effort_ <= 100.0: raise rt.Reject
        near = right_side_propulsive_effort_ * 327.675 + 32768.0
        right_side_propulsive_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - right_side_propulsive_effort_raw_ < 0.9999847412109375: right_side_propulsive_effort_raw_ = rt.exact_raw(right_side_propulsive_effort_, _R_1)
        return _S_3H.pack(0x4501, left_side_propulsive_effort_raw_, right_side_propulsive_effort_raw_)


_S_3H = rt.Packer("<3H")
_R_1 = rt.Scaling(-100.0, 100.0, 65535)
_S_H = rt.Packer("<H")
QuerySkidSteerEffort.REPORT = ReportSkidSteerEffort
