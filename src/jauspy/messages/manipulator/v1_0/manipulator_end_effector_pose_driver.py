"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


@dataclass(slots=True, repr=False)
class QueryToolOffset(rt.Message):
    """QueryToolOffset (0x2604): Asks where the tool point is."""

    CODE = 0x2604
    NAME = "QueryToolOffset"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportToolOffset]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x04&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2604)


@dataclass(slots=True, repr=False)
class SetToolOffset(rt.Message):
    """SetToolOffset (0x0604): Sets where the tool point is.

    tool_point_coordinate_x: -15..15 meter. Position of the tool point along X of the frame of the last joint, in metres
    tool_point_coordinate_y: -15..15 meter. Position of the tool point along Y of the frame of the last joint, in metres
    tool_point_coordinate_z: -15..15 meter. Position of the tool point along Z of the frame of the last joint, in metres
    """

    CODE = 0x0604
    NAME = "SetToolOffset"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    tool_point_coordinate_x: float
    tool_point_coordinate_y: float
    tool_point_coordinate_z: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ToolPointCoordinateX", rt.real("I", -15.0, 15.0, "meter")),
            ("ToolPointCoordinateY", rt.real("I", -15.0, 15.0, "meter")),
            ("ToolPointCoordinateZ", rt.real("I", -15.0, 15.0, "meter")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, tool_point_coordinate_x_, tool_point_coordinate_y_, tool_point_coordinate_z_ = _S_H3I.unpack(data)
        if code != 0x0604: raise rt.Reject
        self.tool_point_coordinate_x = -15.0 + tool_point_coordinate_x_ * 6.984919311242392e-09
        self.tool_point_coordinate_y = -15.0 + tool_point_coordinate_y_ * 6.984919311242392e-09
        self.tool_point_coordinate_z = -15.0 + tool_point_coordinate_z_ * 6.984919311242392e-09
        return self

    def _pack(self) -> bytes:
        tool_point_coordinate_x_ = self.tool_point_coordinate_x
        if not -15.0 <= tool_point_coordinate_x_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_x_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_x_raw_ < 0.9999847412109375: tool_point_coordinate_x_raw_ = rt.exact_raw(tool_point_coordinate_x_, _R_2)
        tool_point_coordinate_y_ = self.tool_point_coordinate_y
        if not -15.0 <= tool_point_coordinate_y_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_y_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_y_raw_ < 0.9999847412109375: tool_point_coordinate_y_raw_ = rt.exact_raw(tool_point_coordinate_y_, _R_2)
        tool_point_coordinate_z_ = self.tool_point_coordinate_z
        if not -15.0 <= tool_point_coordinate_z_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_z_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_z_raw_ < 0.9999847412109375: tool_point_coordinate_z_raw_ = rt.exact_raw(tool_point_coordinate_z_, _R_2)
        return _S_H3I.pack(0x0604, tool_point_coordinate_x_raw_, tool_point_coordinate_y_raw_, tool_point_coordinate_z_raw_)


@dataclass(slots=True, repr=False)
class SetEndEffectorPose(rt.Message):
    """SetEndEffectorPose (0x0610): Sets the pose to move the tool point to.

    tool_point_coordinate_x: -30..30 meter. Position of the tool point along X, in metres
    tool_point_coordinate_y: -30..30 meter. Position of the tool point along Y, in metres
    tool_point_coordinate_z: -30..30 meter. Position of the tool point along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """

    CODE = 0x0610
    NAME = "SetEndEffectorPose"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    tool_point_coordinate_x: float
    tool_point_coordinate_y: float
    tool_point_coordinate_z: float
    d_component_of_unit_quaternion_q: float
    a_component_of_unit_quaternion_q: float
    b_component_of_unit_quaternion_q: float
    c_component_of_unit_quaternion_q: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ToolPointCoordinateX", rt.real("I", -30.0, 30.0, "meter")),
            ("ToolPointCoordinateY", rt.real("I", -30.0, 30.0, "meter")),
            ("ToolPointCoordinateZ", rt.real("I", -30.0, 30.0, "meter")),
            ("DComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("AComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("BComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("CComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, tool_point_coordinate_x_, tool_point_coordinate_y_, tool_point_coordinate_z_, d_component_of_unit_quaternion_q_, a_component_of_unit_quaternion_q_, b_component_of_unit_quaternion_q_, c_component_of_unit_quaternion_q_ = _S_H7I.unpack(data)
        if code != 0x0610: raise rt.Reject
        self.tool_point_coordinate_x = -30.0 + tool_point_coordinate_x_ * 1.3969838622484784e-08
        self.tool_point_coordinate_y = -30.0 + tool_point_coordinate_y_ * 1.3969838622484784e-08
        self.tool_point_coordinate_z = -30.0 + tool_point_coordinate_z_ * 1.3969838622484784e-08
        self.d_component_of_unit_quaternion_q = -1.0 + d_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.a_component_of_unit_quaternion_q = -1.0 + a_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.b_component_of_unit_quaternion_q = -1.0 + b_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.c_component_of_unit_quaternion_q = -1.0 + c_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        return self

    def _pack(self) -> bytes:
        tool_point_coordinate_x_ = self.tool_point_coordinate_x
        if not -30.0 <= tool_point_coordinate_x_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_x_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_x_raw_ < 0.9999847412109375: tool_point_coordinate_x_raw_ = rt.exact_raw(tool_point_coordinate_x_, _R_4)
        tool_point_coordinate_y_ = self.tool_point_coordinate_y
        if not -30.0 <= tool_point_coordinate_y_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_y_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_y_raw_ < 0.9999847412109375: tool_point_coordinate_y_raw_ = rt.exact_raw(tool_point_coordinate_y_, _R_4)
        tool_point_coordinate_z_ = self.tool_point_coordinate_z
        if not -30.0 <= tool_point_coordinate_z_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_z_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_z_raw_ < 0.9999847412109375: tool_point_coordinate_z_raw_ = rt.exact_raw(tool_point_coordinate_z_, _R_4)
        d_component_of_unit_quaternion_q_ = self.d_component_of_unit_quaternion_q
        if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        d_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_5)
        a_component_of_unit_quaternion_q_ = self.a_component_of_unit_quaternion_q
        if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        a_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_5)
        b_component_of_unit_quaternion_q_ = self.b_component_of_unit_quaternion_q
        if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        b_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_5)
        c_component_of_unit_quaternion_q_ = self.c_component_of_unit_quaternion_q
        if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        c_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_5)
        return _S_H7I.pack(0x0610, tool_point_coordinate_x_raw_, tool_point_coordinate_y_raw_, tool_point_coordinate_z_raw_, d_component_of_unit_quaternion_q_raw_, a_component_of_unit_quaternion_q_raw_, b_component_of_unit_quaternion_q_raw_, c_component_of_unit_quaternion_q_raw_)


@dataclass(slots=True, repr=False)
class SetMotionProfile(rt.Message):
    """SetMotionProfile (0x0607): Sets limits of speed and acceleration of each joint.

    motion_profile_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0607
    NAME = "SetMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    RevoluteMotionProfileRec = manipulator_v1_0_types.RevoluteMotionProfileRec
    PrismaticMotionProfileRec = manipulator_v1_0_types.PrismaticMotionProfileRec

    motion_profile_list: list[manipulator_v1_0_types.RevoluteMotionProfileRec | manipulator_v1_0_types.PrismaticMotionProfileRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MotionProfileList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_motion_profile_rec=manipulator_v1_0_types.RevoluteMotionProfileRec, prismatic_motion_profile_rec=manipulator_v1_0_types.PrismaticMotionProfileRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x06: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        motion_profile_list_count_ = data[2]
        if motion_profile_list_count_ * 13 > size - 3: raise rt.Reject
        at = 3
        motion_profile_list_ = []
        for _ in range(motion_profile_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_6[tag]._read(data, at, nesting)
            motion_profile_list_.append(item_)
        self.motion_profile_list = motion_profile_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x06")
        motion_profile_list_ = self.motion_profile_list
        if type(motion_profile_list_) is not list: raise rt.Reject
        out.append(len(motion_profile_list_))
        for item_ in motion_profile_list_:
            out.append(_T_7[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryCommandedEndEffectorPose(rt.Message):
    """QueryCommandedEndEffectorPose (0x2610): Asks for the commanded pose of the tool point."""

    CODE = 0x2610
    NAME = "QueryCommandedEndEffectorPose"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedEndEffectorPose]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x10&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2610)


@dataclass(slots=True, repr=False)
class QueryMotionProfile(rt.Message):
    """QueryMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""

    CODE = 0x2607
    NAME = "QueryMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportMotionProfile]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x07&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2607)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportToolOffset(rt.Message):
    """ReportToolOffset (0x4604): Tells where the tool point is.

    tool_point_coordinate_x: -15..15 meter. Position of the tool point along X of the frame of the last joint, in metres
    tool_point_coordinate_y: -15..15 meter. Position of the tool point along Y of the frame of the last joint, in metres
    tool_point_coordinate_z: -15..15 meter. Position of the tool point along Z of the frame of the last joint, in metres
    """

    CODE = 0x4604
    NAME = "ReportToolOffset"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    tool_point_coordinate_x: float
    tool_point_coordinate_y: float
    tool_point_coordinate_z: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ToolPointCoordinateX", rt.real("I", -15.0, 15.0, "meter")),
            ("ToolPointCoordinateY", rt.real("I", -15.0, 15.0, "meter")),
            ("ToolPointCoordinateZ", rt.real("I", -15.0, 15.0, "meter")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, tool_point_coordinate_x_, tool_point_coordinate_y_, tool_point_coordinate_z_ = _S_H3I.unpack(data)
        if code != 0x4604: raise rt.Reject
        self.tool_point_coordinate_x = -15.0 + tool_point_coordinate_x_ * 6.984919311242392e-09
        self.tool_point_coordinate_y = -15.0 + tool_point_coordinate_y_ * 6.984919311242392e-09
        self.tool_point_coordinate_z = -15.0 + tool_point_coordinate_z_ * 6.984919311242392e-09
        return self

    def _pack(self) -> bytes:
        tool_point_coordinate_x_ = self.tool_point_coordinate_x
        if not -15.0 <= tool_point_coordinate_x_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_x_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_x_raw_ < 0.9999847412109375: tool_point_coordinate_x_raw_ = rt.exact_raw(tool_point_coordinate_x_, _R_2)
        tool_point_coordinate_y_ = self.tool_point_coordinate_y
        if not -15.0 <= tool_point_coordinate_y_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_y_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_y_raw_ < 0.9999847412109375: tool_point_coordinate_y_raw_ = rt.exact_raw(tool_point_coordinate_y_, _R_2)
        tool_point_coordinate_z_ = self.tool_point_coordinate_z
        if not -15.0 <= tool_point_coordinate_z_ <= 15.0: raise rt.Reject
        near = tool_point_coordinate_z_ * 143165576.5 + 2147483648.0
        tool_point_coordinate_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_z_raw_ < 0.9999847412109375: tool_point_coordinate_z_raw_ = rt.exact_raw(tool_point_coordinate_z_, _R_2)
        return _S_H3I.pack(0x4604, tool_point_coordinate_x_raw_, tool_point_coordinate_y_raw_, tool_point_coordinate_z_raw_)


@dataclass(slots=True, repr=False)
class ReportCommandedEndEffectorPose(rt.Message):
    """ReportCommandedEndEffectorPose (0x4610): Tells the commanded pose of the tool point.

    tool_point_coordinate_x: -30..30 meter. Position of the tool point along X, in metres
    tool_point_coordinate_y: -30..30 meter. Position of the tool point along Y, in metres
    tool_point_coordinate_z: -30..30 meter. Position of the tool point along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """

    CODE = 0x4610
    NAME = "ReportCommandedEndEffectorPose"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    tool_point_coordinate_x: float
    tool_point_coordinate_y: float
    tool_point_coordinate_z: float
    d_component_of_unit_quaternion_q: float
    a_component_of_unit_quaternion_q: float
    b_component_of_unit_quaternion_q: float
    c_component_of_unit_quaternion_q: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ToolPointCoordinateX", rt.real("I", -30.0, 30.0, "meter")),
            ("ToolPointCoordinateY", rt.real("I", -30.0, 30.0, "meter")),
            ("ToolPointCoordinateZ", rt.real("I", -30.0, 30.0, "meter")),
            ("DComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("AComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("BComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("CComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, tool_point_coordinate_x_, tool_point_coordinate_y_, tool_point_coordinate_z_, d_component_of_unit_quaternion_q_, a_component_of_unit_quaternion_q_, b_component_of_unit_quaternion_q_, c_component_of_unit_quaternion_q_ = _S_H7I.unpack(data)
        if code != 0x4610: raise rt.Reject
        self.tool_point_coordinate_x = -30.0 + tool_point_coordinate_x_ * 1.3969838622484784e-08
        self.tool_point_coordinate_y = -30.0 + tool_point_coordinate_y_ * 1.3969838622484784e-08
        self.tool_point_coordinate_z = -30.0 + tool_point_coordinate_z_ * 1.3969838622484784e-08
        self.d_component_of_unit_quaternion_q = -1.0 + d_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.a_component_of_unit_quaternion_q = -1.0 + a_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.b_component_of_unit_quaternion_q = -1.0 + b_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        self.c_component_of_unit_quaternion_q = -1.0 + c_component_of_unit_quaternion_q_ * 4.656612874161595e-10
        return self

    def _pack(self) -> bytes:
        tool_point_coordinate_x_ = self.tool_point_coordinate_x
        if not -30.0 <= tool_point_coordinate_x_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_x_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_x_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_x_raw_ < 0.9999847412109375: tool_point_coordinate_x_raw_ = rt.exact_raw(tool_point_coordinate_x_, _R_4)
        tool_point_coordinate_y_ = self.tool_point_coordinate_y
        if not -30.0 <= tool_point_coordinate_y_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_y_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_y_raw_ < 0.9999847412109375: tool_point_coordinate_y_raw_ = rt.exact_raw(tool_point_coordinate_y_, _R_4)
        tool_point_coordinate_z_ = self.tool_point_coordinate_z
        if not -30.0 <= tool_point_coordinate_z_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_z_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_z_raw_ < 0.9999847412109375: tool_point_coordinate_z_raw_ = rt.exact_raw(tool_point_coordinate_z_, _R_4)
        d_component_of_unit_quaternion_q_ = self.d_component_of_unit_quaternion_q
        if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        d_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_5)
        a_component_of_unit_quaternion_q_ = self.a_component_of_unit_quaternion_q
        if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        a_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_5)
        b_component_of_unit_quaternion_q_ = self.b_component_of_unit_quaternion_q
        if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        b_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_5)
        c_component_of_unit_quaternion_q_ = self.c_component_of_unit_quaternion_q
        if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        c_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_5)
        return _S_H7I.pack(0x4610, tool_point_coordinate_x_raw_, tool_point_coordinate_y_raw_, tool_point_coordinate_z_raw_, d_component_of_unit_quaternion_q_raw_, a_component_of_unit_quaternion_q_raw_, b_component_of_unit_quaternion_q_raw_, c_component_of_unit_quaternion_q_raw_)


@dataclass(slots=True, repr=False)
class ReportMotionProfile(rt.Message):
    """ReportMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint.

    motion_profile_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4607
    NAME = "ReportMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    RevoluteMotionProfileRec = manipulator_v1_0_types.RevoluteMotionProfileRec
    PrismaticMotionProfileRec = manipulator_v1_0_types.PrismaticMotionProfileRec

    motion_profile_list: list[manipulator_v1_0_types.RevoluteMotionProfileRec | manipulator_v1_0_types.PrismaticMotionProfileRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MotionProfileList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_motion_profile_rec=manipulator_v1_0_types.RevoluteMotionProfileRec, prismatic_motion_profile_rec=manipulator_v1_0_types.PrismaticMotionProfileRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        motion_profile_list_count_ = data[2]
        if motion_profile_list_count_ * 13 > size - 3: raise rt.Reject
        at = 3
        motion_profile_list_ = []
        for _ in range(motion_profile_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_6[tag]._read(data, at, nesting)
            motion_profile_list_.append(item_)
        self.motion_profile_list = motion_profile_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x46")
        motion_profile_list_ = self.motion_profile_list
        if type(motion_profile_list_) is not list: raise rt.Reject
        out.append(len(motion_profile_list_))
        for item_ in motion_profile_list_:
            out.append(_T_7[type(item_)])
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_H3I = rt.Packer("<H3I")
_R_2 = rt.Scaling(-15.0, 15.0, 4294967295)
_S_H7I = rt.Packer("<H7I")
_R_4 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_5 = rt.Scaling(-1.0, 1.0, 4294967295)
_U_6: tuple[type[manipulator_v1_0_types.RevoluteMotionProfileRec] | type[manipulator_v1_0_types.PrismaticMotionProfileRec], ...] = (manipulator_v1_0_types.RevoluteMotionProfileRec, manipulator_v1_0_types.PrismaticMotionProfileRec)
_T_7: dict[type[rt.Struct], int] = {manipulator_v1_0_types.RevoluteMotionProfileRec: 0, manipulator_v1_0_types.PrismaticMotionProfileRec: 1}
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryToolOffset.REPORT = ReportToolOffset
QueryCommandedEndEffectorPose.REPORT = ReportCommandedEndEffectorPose
QueryMotionProfile.REPORT = ReportMotionProfile
