"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver


@dataclass(slots=True, repr=False)
class ExecuteList(rt.Message):
    """ExecuteList (0x061E): Starts the list at an element, at a speed.

    element_uid: optional. The element to start with
    """

    CODE = 0x061E
    NAME = "ExecuteList"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    element_uid: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("ElementUID", rt.Number("H"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x061E: raise rt.Reject
        raw = iter(_M_ExecuteList[mask & 0x1].unpack(data)).__next__
        self = rt.new(cls)
        self.element_uid = raw() if mask & 1 else None
        self.reserved_presence = mask & 0xFE
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1: raise rt.Reject
        raw: list[int | float | bytes] = []
        element_uid_ = self.element_uid
        if element_uid_ is not None:
            mask |= 1
            raw.append(element_uid_)
        return _M_ExecuteList_pack[mask & 0x1].pack(0x061E, mask, *raw)


class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile):
    """SetMotionProfile (0x0607): Sets limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset):
    """SetToolOffset (0x0604): Sets where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    """QueryToolOffset (0x2604): Asks where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportToolOffset]]


@dataclass(slots=True, repr=False)
class QueryActiveElement(rt.Message):
    """QueryActiveElement (0x261E): Asks which element of the list is being carried out."""

    CODE = 0x261E
    NAME = "QueryActiveElement"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportActiveElement]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x1e&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x261E)


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    """QueryMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportMotionProfile]]


class QueryCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryCommandedEndEffectorPose):
    """QueryCommandedEndEffectorPose (0x2610): Asks for the commanded pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportCommandedEndEffectorPose]]


@dataclass(slots=True, repr=False)
class ReportActiveElement(rt.Message):
    """ReportActiveElement (0x461E): Tells which element of the list is being carried out.

    element_uid: The element being carried out; 0 when there is none
    """

    CODE = 0x461E
    NAME = "ReportActiveElement"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    element_uid: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementUID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.element_uid = _S_2H.unpack(data)
        if code != 0x461E: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x461E, self.element_uid)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile):
    """ReportMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


class ReportCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportCommandedEndEffectorPose):
    """ReportCommandedEndEffectorPose (0x4610): Tells the commanded pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset):
    """ReportToolOffset (0x4604): Tells where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
    VERSION = "1.0"


_S_HB = rt.Packer("<HB")
_M_ExecuteList = rt.Masks("3x", ((1, "H"),))
_M_ExecuteList_pack = rt.Masks("HB", ((1, "H"),))
_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
QueryToolOffset.REPORT = ReportToolOffset
QueryActiveElement.REPORT = ReportActiveElement
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryMotionProfile.REPORT = ReportMotionProfile
QueryCommandedEndEffectorPose.REPORT = ReportCommandedEndEffectorPose
