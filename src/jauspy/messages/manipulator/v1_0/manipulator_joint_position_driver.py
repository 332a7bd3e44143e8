"""urn:jaus:jss:manipulator:ManipulatorJointPositionDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class QueryCommandedJointPositions(rt.Message):
    """QueryCommandedJointPositions (0x2608): Asks for the commanded position of each joint."""

    CODE = 0x2608
    NAME = "QueryCommandedJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedJointPositions]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x08&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2608)


class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    """QueryMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportMotionProfile]]


@dataclass(slots=True, repr=False)
class SetJointPositions(rt.Message):
    """SetJointPositions (0x0602): Sets the position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0602
    NAME = "SetJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = True
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
        if data[0] != 0x02 or data[1] != 0x06: raise rt.Reject
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
        out = bytearray(b"\x02\x06")
        joint_position_list_ = self.joint_position_list
        if type(joint_position_list_) is not list: raise rt.Reject
        out.append(len(joint_position_list_))
        for item_ in joint_position_list_:
            if type(item_) is not manipulator_v1_0_types.JointPositionRec: raise rt.Reject
            joint_position_ = item_.joint_position
            if type(joint_position_) is not manipulator_v1_0_types.JointPositionRec.JointPosition: raise rt.Reject
            joint_position_._write(out)
        return bytes(out)


class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile):
    """SetMotionProfile (0x0607): Sets limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportCommandedJointPositions(rt.Message):
    """ReportCommandedJointPositions (0x4608): Tells the commanded position of each joint.

    joint_position_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4608
    NAME = "ReportCommandedJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
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
        if data[0] != 0x08 or data[1] != 0x46: raise rt.Reject
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
        out = bytearray(b"\x08\x46")
        joint_position_list_ = self.joint_position_list
        if type(joint_position_list_) is not list: raise rt.Reject
        out.append(len(joint_position_list_))
        for item_ in joint_position_list_:
            if type(item_) is not manipulator_v1_0_types.JointPositionRec: raise rt.Reject
            joint_position_ = item_.joint_position
            if type(joint_position_) is not manipulator_v1_0_types.JointPositionRec.JointPosition: raise rt.Reject
            joint_position_._write(out)
        return bytes(out)


class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile):
    """ReportMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "1.0"


_S_H = rt.Packer("<H")
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryCommandedJointPositions.REPORT = ReportCommandedJointPositions
QueryMotionProfile.REPORT = ReportMotionProfile
