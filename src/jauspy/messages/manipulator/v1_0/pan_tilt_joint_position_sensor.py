"""urn:jaus:jss:manipulator:PanTiltJointPositionSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver


@dataclass(slots=True, repr=False)
class QueryPanTiltJointPositions(rt.Message):
    """QueryPanTiltJointPositions (0x2622): Asks for the angles."""

    CODE = 0x2622
    NAME = "QueryPanTiltJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPanTiltJointPositions]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'"&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2622)


class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    """QueryPanTiltSpecifications (0x2620): Asks for mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportPanTiltSpecifications]]


@dataclass(slots=True, repr=False)
class ReportPanTiltJointPositions(rt.Message):
    """ReportPanTiltJointPositions (0x4622): Tells the angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """

    CODE = 0x4622
    NAME = "ReportPanTiltJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    joint1_position: float
    joint2_position: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint2Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_position_, joint2_position_ = _S_H2I.unpack(data)
        if code != 0x4622: raise rt.Reject
        self.joint1_position = -25.132741228718345 + joint1_position_ * 1.1703344636862174e-08
        self.joint2_position = -25.132741228718345 + joint2_position_ * 1.1703344636862174e-08
        return self

    def _pack(self) -> bytes:
        joint1_position_ = self.joint1_position
        if not -25.132741228718345 <= joint1_position_ <= 25.132741228718345: raise rt.Reject
        near = joint1_position_ * 85445659.42715958 + 2147483647.9999998
        joint1_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_position_raw_ < 0.9999847412109375: joint1_position_raw_ = rt.exact_raw(joint1_position_, _R_2)
        joint2_position_ = self.joint2_position
        if not -25.132741228718345 <= joint2_position_ <= 25.132741228718345: raise rt.Reject
        near = joint2_position_ * 85445659.42715958 + 2147483647.9999998
        joint2_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_position_raw_ < 0.9999847412109375: joint2_position_raw_ = rt.exact_raw(joint2_position_, _R_2)
        return _S_H2I.pack(0x4622, joint1_position_raw_, joint2_position_raw_)


class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications):
    """ReportPanTiltSpecifications (0x4620): Tells mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "1.0"


_S_H = rt.Packer("<H")
_S_H2I = rt.Packer("<H2I")
_R_2 = rt.Scaling(-25.132741228718345, 25.132741228718345, 4294967295)
QueryPanTiltJointPositions.REPORT = ReportPanTiltJointPositions
QueryPanTiltSpecifications.REPORT = ReportPanTiltSpecifications
