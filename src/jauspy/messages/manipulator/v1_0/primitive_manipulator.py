"""urn:jaus:jss:manipulator:PrimitiveManipulator 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveManipulator"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class QueryJointEfforts(rt.Message):
    """QueryJointEfforts (0x2601): Asks for the effort of each joint."""

    CODE = 0x2601
    NAME = "QueryJointEfforts"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveManipulator"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportJointEfforts]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x01&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2601)


@dataclass(slots=True, repr=False)
class SetJointEfforts(rt.Message):
    """SetJointEfforts (0x0601): Sets the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0601
    NAME = "SetJointEfforts"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveManipulator"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    JointEffortRec = manipulator_v1_0_types.JointEffortRec

    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointEffortList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x06: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_effort_list_count_ = data[2]
        joint_effort_list_end_ = 3 + joint_effort_list_count_ * 2
        self.joint_effort_list = [manipulator_v1_0_types.JointEffortRec(-100.0 + joint_effort_ * 0.0030518043793392844) for joint_effort_ in _L_H[joint_effort_list_count_].unpack_from(data, 3)]
        if joint_effort_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x06")
        joint_effort_list_ = self.joint_effort_list
        if type(joint_effort_list_) is not list: raise rt.Reject
        out.append(len(joint_effort_list_))
        raw_: list[int | float] = []
        for item_ in joint_effort_list_:
            if type(item_) is not manipulator_v1_0_types.JointEffortRec: raise rt.Reject
            joint_effort_ = item_.joint_effort
            if not -100.0 <= joint_effort_ <= 100.0: raise rt.Reject
            near = joint_effort_ * 327.675 + 32768.0
            joint_effort_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_effort_raw_ < 0.9999847412109375: joint_effort_raw_ = rt.exact_raw(joint_effort_, _R_2)
            raw_.append(joint_effort_raw_)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveManipulator"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportJointEfforts(rt.Message):
    """ReportJointEfforts (0x4601): Tells the effort of each joint.

    joint_effort_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4601
    NAME = "ReportJointEfforts"
    SERVICE = "urn:jaus:jss:manipulator:PrimitiveManipulator"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    JointEffortRec = manipulator_v1_0_types.JointEffortRec

    joint_effort_list: list[manipulator_v1_0_types.JointEffortRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointEffortList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.JointEffortRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_effort_list_count_ = data[2]
        joint_effort_list_end_ = 3 + joint_effort_list_count_ * 2
        self.joint_effort_list = [manipulator_v1_0_types.JointEffortRec(-100.0 + joint_effort_ * 0.0030518043793392844) for joint_effort_ in _L_H[joint_effort_list_count_].unpack_from(data, 3)]
        if joint_effort_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x46")
        joint_effort_list_ = self.joint_effort_list
        if type(joint_effort_list_) is not list: raise rt.Reject
        out.append(len(joint_effort_list_))
        raw_: list[int | float] = []
        for item_ in joint_effort_list_:
            if type(item_) is not manipulator_v1_0_types.JointEffortRec: raise rt.Reject
            joint_effort_ = item_.joint_effort
            if not -100.0 <= joint_effort_ <= 100.0: raise rt.Reject
            near = joint_effort_ * 327.675 + 32768.0
            joint_effort_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_effort_raw_ < 0.9999847412109375: joint_effort_raw_ = rt.exact_raw(joint_effort_, _R_2)
            raw_.append(joint_effort_raw_)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


_S_H = rt.Packer("<H")
_L_H = rt.Rows("H")
_R_2 = rt.Scaling(-100.0, 100.0, 65535)
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryJointEfforts.REPORT = ReportJointEfforts
