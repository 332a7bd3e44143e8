"""urn:jaus:jss:manipulator:ManipulatorJointPositionSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


@dataclass(slots=True, repr=False)
class QueryJointPositions(rt.Message):
    """QueryJointPositions (0x2602): Asks for the position of each joint."""

    CODE = 0x2602
    NAME = "QueryJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportJointPositions]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2602)


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class ReportJointPositions(rt.Message):
    """ReportJointPositions (0x4602): Tells the position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4602
    NAME = "ReportJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    JointPositionRec = manipulator_v1_0_types.JointPositionRec

    joint_position_list: list[manipulator_v1_0_types.JointPositionRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointPositionList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.JointPositionRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_position_list_count_ = data[2]
        if joint_position_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        joint_position_list_ = []
        for _ in range(joint_position_list_count_):
            item_ = rt.new(manipulator_v1_0_types.JointPositionRec)
            item_.joint_position, at = manipulator_v1_0_types.JointPositionRec.JointPosition._read(data, at, nesting)
            joint_position_list_.append(item_)
        self.joint_position_list = joint_position_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x46")
        joint_position_list_ = self.joint_position_list
        if type(joint_position_list_) is not list: raise rt.Reject
        out.append(len(joint_position_list_))
        for item_ in joint_position_list_:
            if type(item_) is not manipulator_v1_0_types.JointPositionRec: raise rt.Reject
            joint_position_ = item_.joint_position
            if type(joint_position_) is not manipulator_v1_0_types.JointPositionRec.JointPosition: raise rt.Reject
            joint_position_._write(out)
        return bytes(out)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "1.0"


_S_H = rt.Packer("<H")
QueryJointPositions.REPORT = ReportJointPositions
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
