"""urn:jaus:jss:manipulator:PrimitivePanTilt 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryPanTiltJointEffort(rt.Message):
    """QueryPanTiltJointEffort (0x2621): Asks for the efforts of pan and tilt."""

    CODE = 0x2621
    NAME = "QueryPanTiltJointEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitivePanTilt"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPanTiltJointEffort]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'!&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2621)


@dataclass(slots=True, repr=False)
class SetPanTiltJointEffort(rt.Message):
    """SetPanTiltJointEffort (0x0621): Sets the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """

    CODE = 0x0621
    NAME = "SetPanTiltJointEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitivePanTilt"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    joint1_effort: float
    joint2_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Effort", rt.real("H", -100.0, 100.0)),
            ("Joint2Effort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_effort_, joint2_effort_ = _S_3H.unpack(data)
        if code != 0x0621: raise rt.Reject
        self.joint1_effort = -100.0 + joint1_effort_ * 0.0030518043793392844
        self.joint2_effort = -100.0 + joint2_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        joint1_effort_ = self.joint1_effort
        if not -100.0 <= joint1_effort_ <= 100.0: raise rt.Reject
        near = joint1_effort_ * 327.675 + 32768.0
        joint1_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_effort_raw_ < 0.9999847412109375: joint1_effort_raw_ = rt.exact_raw(joint1_effort_, _R_2)
        joint2_effort_ = self.joint2_effort
        if not -100.0 <= joint2_effort_ <= 100.0: raise rt.Reject
        near = joint2_effort_ * 327.675 + 32768.0
        joint2_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_effort_raw_ < 0.9999847412109375: joint2_effort_raw_ = rt.exact_raw(joint2_effort_, _R_2)
        return _S_3H.pack(0x0621, joint1_effort_raw_, joint2_effort_raw_)


@dataclass(slots=True, repr=False)
class ReportPanTiltJointEffort(rt.Message):
    """ReportPanTiltJointEffort (0x4621): Tells the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """

    CODE = 0x4621
    NAME = "ReportPanTiltJointEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitivePanTilt"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    joint1_effort: float
    joint2_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Effort", rt.real("H", -100.0, 100.0)),
            ("Joint2Effort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_effort_, joint2_effort_ = _S_3H.unpack(data)
        if code != 0x4621: raise rt.Reject
        self.joint1_effort = -100.0 + joint1_effort_ * 0.0030518043793392844
        self.joint2_effort = -100.0 + joint2_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        joint1_effort_ = self.joint1_effort
        if not -100.0 <= joint1_effort_ <= 100.0: raise rt.Reject
        near = joint1_effort_ * 327.675 + 32768.0
        joint1_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_effort_raw_ < 0.9999847412109375: joint1_effort_raw_ = rt.exact_raw(joint1_effort_, _R_2)
        joint2_effort_ = self.joint2_effort
        if not -100.0 <= joint2_effort_ <= 100.0: raise rt.Reject
        near = joint2_effort_ * 327.675 + 32768.0
        joint2_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_effort_raw_ < 0.9999847412109375: joint2_effort_raw_ = rt.exact_raw(joint2_effort_, _R_2)
        return _S_3H.pack(0x4621, joint1_effort_raw_, joint2_effort_raw_)


_S_H = rt.Packer("<H")
_S_3H = rt.Packer("<3H")
_R_2 = rt.Scaling(-100.0, 100.0, 65535)
QueryPanTiltJointEffort.REPORT = ReportPanTiltJointEffort
