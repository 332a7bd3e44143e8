"""urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver


class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    """QueryPanTiltSpecifications (0x2620): Asks for mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportPanTiltSpecifications]]


@dataclass(slots=True, repr=False)
class SetPanTiltJointVelocities(rt.Message):
    """SetPanTiltJointVelocities (0x0623): Sets the angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """

    CODE = 0x0623
    NAME = "SetPanTiltJointVelocities"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"
    IS_COMMAND = True
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
        if code != 0x0623: raise rt.Reject
        self.joint1_velocity = -31.41592653589793 + joint1_velocity_ * 1.4629180796077718e-08
        self.joint2_velocity = -31.41592653589793 + joint2_velocity_ * 1.4629180796077718e-08
        return self

    def _pack(self) -> bytes:
        joint1_velocity_ = self.joint1_velocity
        if not -31.41592653589793 <= joint1_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint1_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint1_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_velocity_raw_ < 0.9999847412109375: joint1_velocity_raw_ = rt.exact_raw(joint1_velocity_, _R_1)
        joint2_velocity_ = self.joint2_velocity
        if not -31.41592653589793 <= joint2_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint2_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint2_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_velocity_raw_ < 0.9999847412109375: joint2_velocity_raw_ = rt.exact_raw(joint2_velocity_, _R_1)
        return _S_H2I.pack(0x0623, joint1_velocity_raw_, joint2_velocity_raw_)


class SetPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.SetPanTiltMotionProfile):
    """SetPanTiltMotionProfile (0x0627): Sets limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class QueryCommandedPanTiltJointVelocities(rt.Message):
    """QueryCommandedPanTiltJointVelocities (0x2631): Asks for the commanded angular velocities."""

    CODE = 0x2631
    NAME = "QueryCommandedPanTiltJointVelocities"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedPanTiltJointVelocities]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'1&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2631)


class QueryPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltMotionProfile):
    """QueryPanTiltMotionProfile (0x2627): Asks for the limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportPanTiltMotionProfile]]


class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications):
    """ReportPanTiltSpecifications (0x4620): Tells mounting and limits of the pan-tilt unit."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportCommandedPanTiltJointVelocities(rt.Message):
    """ReportCommandedPanTiltJointVelocities (0x4631): Tells the commanded angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """

    CODE = 0x4631
    NAME = "ReportCommandedPanTiltJointVelocities"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"
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
        if code != 0x4631: raise rt.Reject
        self.joint1_velocity = -31.41592653589793 + joint1_velocity_ * 1.4629180796077718e-08
        self.joint2_velocity = -31.41592653589793 + joint2_velocity_ * 1.4629180796077718e-08
        return self

    def _pack(self) -> bytes:
        joint1_velocity_ = self.joint1_velocity
        if not -31.41592653589793 <= joint1_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint1_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint1_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_velocity_raw_ < 0.9999847412109375: joint1_velocity_raw_ = rt.exact_raw(joint1_velocity_, _R_1)
        joint2_velocity_ = self.joint2_velocity
        if not -31.41592653589793 <= joint2_velocity_ <= 31.41592653589793: raise rt.Reject
        near = joint2_velocity_ * 68356527.54172766 + 2147483647.9999998
        joint2_velocity_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_velocity_raw_ < 0.9999847412109375: joint2_velocity_raw_ = rt.exact_raw(joint2_velocity_, _R_1)
        return _S_H2I.pack(0x4631, joint1_velocity_raw_, joint2_velocity_raw_)


class ReportPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltMotionProfile):
    """ReportPanTiltMotionProfile (0x4627): Tells the limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver"
    VERSION = "1.0"


_S_H2I = rt.Packer("<H2I")
_R_1 = rt.Scaling(-31.41592653589793, 31.41592653589793, 4294967295)
_S_H = rt.Packer("<H")
QueryPanTiltSpecifications.REPORT = ReportPanTiltSpecifications
QueryCommandedPanTiltJointVelocities.REPORT = ReportCommandedPanTiltJointVelocities
QueryPanTiltMotionProfile.REPORT = ReportPanTiltMotionProfile
