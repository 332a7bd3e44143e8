"""urn:jaus:jss:manipulator:PrimitiveEndEffector 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryEndEffectorSpecification(rt.Message):
    """QueryEndEffectorSpecification (0x2632): Asks which manipulator carries the end effector."""

    CODE = 0x2632
    NAME = "QueryEndEffectorSpecification"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEndEffectorSpecification]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'2&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2632)


@dataclass(slots=True, repr=False)
class QueryEndEffectorEffort(rt.Message):
    """QueryEndEffectorEffort (0x2633): Asks for the effort of the end effector."""

    CODE = 0x2633
    NAME = "QueryEndEffectorEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEndEffectorEffort]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'3&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2633)


@dataclass(slots=True, repr=False)
class SetEndEffectorEffort(rt.Message):
    """SetEndEffectorEffort (0x0633): Sets the effort of the end effector.

    end_effector_effort: -100..100. Effort, in percent of the maximum
    """

    CODE = 0x0633
    NAME = "SetEndEffectorEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    end_effector_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EndEffectorEffort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, end_effector_effort_ = _S_2H.unpack(data)
        if code != 0x0633: raise rt.Reject
        self.end_effector_effort = -100.0 + end_effector_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        end_effector_effort_ = self.end_effector_effort
        if not -100.0 <= end_effector_effort_ <= 100.0: raise rt.Reject
        near = end_effector_effort_ * 327.675 + 32768.0
        end_effector_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - end_effector_effort_raw_ < 0.9999847412109375: end_effector_effort_raw_ = rt.exact_raw(end_effector_effort_, _R_2)
        return _S_2H.pack(0x0633, end_effector_effort_raw_)


@dataclass(slots=True, repr=False)
class ReportEndEffectorSpecification(rt.Message):
    """ReportEndEffectorSpecification (0x4632): Tells which manipulator carries the end effector.

    parent_id: Component of the manipulator that carries the end effector
    """

    CODE = 0x4632
    NAME = "ReportEndEffectorSpecification"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    parent_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ParentId", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.parent_id = _S_HI.unpack(data)
        if code != 0x4632: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HI.pack(0x4632, self.parent_id)


@dataclass(slots=True, repr=False)
class ReportEndEffectorEffort(rt.Message):
    """ReportEndEffectorEffort (0x4633): Tells the effort of the end effector.

    end_effector_effort: -100..100. Effort, in percent of the maximum
    """

    CODE = 0x4633
    NAME = "ReportEndEffectorEffort"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveEndEffector"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    end_effector_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EndEffectorEffort", rt.real("H", -100.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, end_effector_effort_ = _S_2H.unpack(data)
        if code != 0x4633: raise rt.Reject
        self.end_effector_effort = -100.0 + end_effector_effort_ * 0.0030518043793392844
        return self

    def _pack(self) -> bytes:
        end_effector_effort_ = self.end_effector_effort
        if not -100.0 <= end_effector_effort_ <= 100.0: raise rt.Reject
        near = end_effector_effort_ * 327.675 + 32768.0
        end_effector_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - end_effector_effort_raw_ < 0.9999847412109375: end_effector_effort_raw_ = rt.exact_raw(end_effector_effort_, _R_2)
        return _S_2H.pack(0x4633, end_effector_effort_raw_)


_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
_R_2 = rt.Scaling(-100.0, 100.0, 65535)
_S_HI = rt.Packer("<HI")
QueryEndEffectorSpecification.REPORT = ReportEndEffectorSpecification
QueryEndEffectorEffort.REPORT = ReportEndEffectorEffort
