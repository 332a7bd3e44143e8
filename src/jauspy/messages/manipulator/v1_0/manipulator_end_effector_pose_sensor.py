"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    """QueryToolOffset (0x2604): Asks where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportToolOffset]]


class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset):
    """SetToolOffset (0x0604): Sets where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class QueryEndEffectorPose(rt.Message):
    """QueryEndEffectorPose (0x2615): Asks for the pose of the tool point."""

    CODE = 0x2615
    NAME = "QueryEndEffectorPose"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEndEffectorPose]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x15&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2615)


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"


class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset):
    """ReportToolOffset (0x4604): Tells where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportEndEffectorPose(rt.Message):
    """ReportEndEffectorPose (0x4615): Tells the pose of the tool point.

    tool_point_coordinate_x: -30..30 meter. Position of the tool point along X, in metres
    tool_point_coordinate_y: -30..30 meter. Position of the tool point along Y, in metres
    tool_point_coordinate_z: -30..30 meter. Position of the tool point along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """

    CODE = 0x4615
    NAME = "ReportEndEffectorPose"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
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
        if code != 0x4615: raise rt.Reject
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
        if not 1.52587890625e-05 < near - tool_point_coordinate_x_raw_ < 0.9999847412109375: tool_point_coordinate_x_raw_ = rt.exact_raw(tool_point_coordinate_x_, _R_2)
        tool_point_coordinate_y_ = self.tool_point_coordinate_y
        if not -30.0 <= tool_point_coordinate_y_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_y_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_y_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_y_raw_ < 0.9999847412109375: tool_point_coordinate_y_raw_ = rt.exact_raw(tool_point_coordinate_y_, _R_2)
        tool_point_coordinate_z_ = self.tool_point_coordinate_z
        if not -30.0 <= tool_point_coordinate_z_ <= 30.0: raise rt.Reject
        near = tool_point_coordinate_z_ * 71582788.25 + 2147483648.0
        tool_point_coordinate_z_raw_ = int(near)
        if not 1.52587890625e-05 < near - tool_point_coordinate_z_raw_ < 0.9999847412109375: tool_point_coordinate_z_raw_ = rt.exact_raw(tool_point_coordinate_z_, _R_2)
        d_component_of_unit_quaternion_q_ = self.d_component_of_unit_quaternion_q
        if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        d_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_3)
        a_component_of_unit_quaternion_q_ = self.a_component_of_unit_quaternion_q
        if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        a_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_3)
        b_component_of_unit_quaternion_q_ = self.b_component_of_unit_quaternion_q
        if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        b_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_3)
        c_component_of_unit_quaternion_q_ = self.c_component_of_unit_quaternion_q
        if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
        near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
        c_component_of_unit_quaternion_q_raw_ = int(near)
        if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_3)
        return _S_H7I.pack(0x4615, tool_point_coordinate_x_raw_, tool_point_coordinate_y_raw_, tool_point_coordinate_z_raw_, d_component_of_unit_quaternion_q_raw_, a_component_of_unit_quaternion_q_raw_, b_component_of_unit_quaternion_q_raw_, c_component_of_unit_quaternion_q_raw_)


_S_H = rt.Packer("<H")
_S_H7I = rt.Packer("<H7I")
_R_2 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_3 = rt.Scaling(-1.0, 1.0, 4294967295)
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryToolOffset.REPORT = ReportToolOffset
QueryEndEffectorPose.REPORT = ReportEndEffectorPose
