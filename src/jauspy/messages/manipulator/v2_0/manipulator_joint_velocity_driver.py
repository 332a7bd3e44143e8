"""urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


@dataclass(slots=True, repr=False)
class SetJointVelocity(rt.Message):
    """SetJointVelocity (0x0603): Sets the velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0603
    NAME = "SetJointVelocity"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec

    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointVelocityList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x06: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_velocity_list_count_ = data[2]
        if joint_velocity_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        joint_velocity_list_ = []
        for _ in range(joint_velocity_list_count_):
            item_ = rt.new(manipulator_v1_0_types.JointVelocityRec)
            item_.joint_velocity, at = manipulator_v1_0_types.JointVelocityRec.JointVelocity._read(data, at, nesting)
            joint_velocity_list_.append(item_)
        self.joint_velocity_list = joint_velocity_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x06")
        joint_velocity_list_ = self.joint_velocity_list
        if type(joint_velocity_list_) is not list: raise rt.Reject
        out.append(len(joint_velocity_list_))
        for item_ in joint_velocity_list_:
            if type(item_) is not manipulator_v1_0_types.JointVelocityRec: raise rt.Reject
            joint_velocity_ = item_.joint_velocity
            if type(joint_velocity_) is not manipulator_v1_0_types.JointVelocityRec.JointVelocity: raise rt.Reject
            joint_velocity_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryCommandedJointVelocity(rt.Message):
    """QueryCommandedJointVelocity (0x2611): Asks for the commanded velocity of each joint."""

    CODE = 0x2611
    NAME = "QueryCommandedJointVelocity"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedJointVelocity]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x11&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2611)


@dataclass(slots=True, repr=False)
class ReportCommandedJointVelocity(rt.Message):
    """ReportCommandedJointVelocity (0x4611): Tells the commanded velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4611
    NAME = "ReportCommandedJointVelocity"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec

    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointVelocityList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x11 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_velocity_list_count_ = data[2]
        if joint_velocity_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        joint_velocity_list_ = []
        for _ in range(joint_velocity_list_count_):
            item_ = rt.new(manipulator_v1_0_types.JointVelocityRec)
            item_.joint_velocity, at = manipulator_v1_0_types.JointVelocityRec.JointVelocity._read(data, at, nesting)
            joint_velocity_list_.append(item_)
        self.joint_velocity_list = joint_velocity_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x11\x46")
        joint_velocity_list_ = self.joint_velocity_list
        if type(joint_velocity_list_) is not list: raise rt.Reject
        out.append(len(joint_velocity_list_))
        for item_ in joint_velocity_list_:
            if type(item_) is not manipulator_v1_0_types.JointVelocityRec: raise rt.Reject
            joint_velocity_ = item_.joint_velocity
            if type(joint_velocity_) is not manipulator_v1_0_types.JointVelocityRec.JointVelocity: raise rt.Reject
            joint_velocity_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
QueryCommandedJointVelocity.REPORT = ReportCommandedJointVelocity
