"""urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


@dataclass(slots=True, repr=False)
class QueryJointVelocities(rt.Message):
    """QueryJointVelocities (0x2603): Asks for the velocity of each joint."""

    CODE = 0x2603
    NAME = "QueryJointVelocities"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportJointVelocities]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x03&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2603)


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class ReportJointVelocities(rt.Message):
    """ReportJointVelocities (0x4603): Tells the velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4603
    NAME = "ReportJointVelocities"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"
    VERSION = "1.0"
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
        if data[0] != 0x03 or data[1] != 0x46: raise rt.Reject
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
        out = bytearray(b"\x03\x46")
        joint_velocity_list_ = self.joint_velocity_list
        if type(joint_velocity_list_) is not list: raise rt.Reject
        out.append(len(joint_velocity_list_))
        for item_ in joint_velocity_list_:
            if type(item_) is not manipulator_v1_0_types.JointVelocityRec: raise rt.Reject
            joint_velocity_ = item_.joint_velocity
            if type(joint_velocity_) is not manipulator_v1_0_types.JointVelocityRec.JointVelocity: raise rt.Reject
            joint_velocity_._write(out)
        return bytes(out)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"
    VERSION = "1.0"


_S_H = rt.Packer("<H")
QueryJointVelocities.REPORT = ReportJointVelocities
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
