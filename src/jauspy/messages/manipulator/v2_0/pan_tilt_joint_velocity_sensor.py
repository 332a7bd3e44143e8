"""urn:jaus:jss:manipulator:PanTiltJointVelocitySensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryPanTiltJointVelocity(rt.Message):
    """QueryPanTiltJointVelocity (0x2623): Asks for the angular velocities."""

    CODE = 0x2623
    NAME = "QueryPanTiltJointVelocity"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitySensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPanTiltJointVelocity]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'#&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2623)


@dataclass(slots=True, repr=False)
class ReportPanTiltJointVelocity(rt.Message):
    """ReportPanTiltJointVelocity (0x4623): Tells the angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """

    CODE = 0x4623
    NAME = "ReportPanTiltJointVelocity"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitySensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    joint1_velocity: float
    joint2_velocity: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Velocity", rt.real("I", -31.41592653589793, 31.41592653589793, "radian per second")),
            ("Joint2Velocity", rt.real("I", -31.41592653589793, 31.41592653589793, "radian per second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_velocity_, joint2_velocity_ = _S_H2I.unpack(data)
        if code != 0x4623: raise rt.Reject
        self.joint1_velocity = -31.41592653589793 + joint1_velocity_ * 1.4629180796077718e-08
        self.joint2_velocity = -31.41592653589793 + joint2_velocity_ * 1.4629180796077718e-08
        return self

    def _pack(self) -> bytes:
        joint1_velocity_ = self.joint1_velocity
        if not -31.41592653589793 <= joint1_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint1_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint1_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_velocity_raw_ < 0.9999847412109375: joint1_velocity_raw_ = rt.exact_raw(joint1_velocity_, _R_2)
        joint2_velocity_ = self.joint2_velocity
        if not -31.41592653589793 <= joint2_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint2_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint2_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_velocity_raw_ < 0.9999847412109375: joint2_velocity_raw_ = rt.exact_raw(joint2_velocity_, _R_2)
        return _S_H2I.pack(0x4623, joint1_velocity_raw_, joint2_velocity_raw_)


_S_H = rt.Packer("<H")
_S_H2I = rt.Packer("<H2I")
_R_2 = rt.Scaling(-31.41592653589793, 31.41592653589793, 4294967295)
QueryPanTiltJointVelocity.REPORT = ReportPanTiltJointVelocity
