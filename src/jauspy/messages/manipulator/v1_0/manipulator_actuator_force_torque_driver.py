"""urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types


@dataclass(slots=True, repr=False)
class QueryManipulatorSpecifications(rt.Message):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2600
    NAME = "QueryManipulatorSpecifications"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector = _S_HB.unpack(data)
        if code != 0x2600: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2600, self.presence_vector)


@dataclass(slots=True, repr=False)
class QueryCommandedActuatorForceTorques(rt.Message):
    """QueryCommandedActuatorForceTorques (0x2613): Asks for the commanded force or torque of each joint."""

    CODE = 0x2613
    NAME = "QueryCommandedActuatorForceTorques"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedActuatorForceTorques]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x13&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2613)


@dataclass(slots=True, repr=False)
class SetActuatorForceTorques(rt.Message):
    """SetActuatorForceTorques (0x0613): Sets the force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0613
    NAME = "SetActuatorForceTorques"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec

    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ActuatorForceTorqueList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x13 or data[1] != 0x06: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        actuator_force_torque_list_count_ = data[2]
        if actuator_force_torque_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        actuator_force_torque_list_ = []
        for _ in range(actuator_force_torque_list_count_):
            item_ = rt.new(manipulator_v1_0_types.ActuatorForceTorqueRec)
            item_.joint_force_torque, at = manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque._read(data, at, nesting)
            actuator_force_torque_list_.append(item_)
        self.actuator_force_torque_list = actuator_force_torque_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x13\x06")
        actuator_force_torque_list_ = self.actuator_force_torque_list
        if type(actuator_force_torque_list_) is not list: raise rt.Reject
        out.append(len(actuator_force_torque_list_))
        for item_ in actuator_force_torque_list_:
            if type(item_) is not manipulator_v1_0_types.ActuatorForceTorqueRec: raise rt.Reject
            joint_force_torque_ = item_.joint_force_torque
            if type(joint_force_torque_) is not manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque: raise rt.Reject
            joint_force_torque_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False, kw_only=True)
class ReportManipulatorSpecifications(rt.Message):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator.

    manipulator_coordinate_system_rec: optional. Where the base is mounted on the vehicle
    first_joint_parameters: The first joint, revolute or prismatic
    joint_specification_list: 0..255 items. The joints after the first
    """

    CODE = 0x4600
    NAME = "ReportManipulatorSpecifications"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    ManipulatorCoordinateSystemRec = manipulator_v1_0_types.ManipulatorCoordinateSystemRec
    RevoluteJoint1OffsetRec = manipulator_v1_0_types.RevoluteJoint1OffsetRec
    PrismaticJoint1AngleRec = manipulator_v1_0_types.PrismaticJoint1AngleRec
    RevoluteJointSpecificationRec = manipulator_v1_0_types.RevoluteJointSpecificationRec
    PrismaticJointSpecificationRec = manipulator_v1_0_types.PrismaticJointSpecificationRec

    manipulator_coordinate_system_rec: manipulator_v1_0_types.ManipulatorCoordinateSystemRec | None = None
    first_joint_parameters: manipulator_v1_0_types.RevoluteJoint1OffsetRec | manipulator_v1_0_types.PrismaticJoint1AngleRec
    joint_specification_list: list[manipulator_v1_0_types.RevoluteJointSpecificationRec | manipulator_v1_0_types.PrismaticJointSpecificationRec]
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("ManipulatorCoordinateSystemRec", manipulator_v1_0_types.ManipulatorCoordinateSystemRec.layout(), True),
            ("FirstJointParameters", rt.Union.of("B", revolute_joint1_offset_rec=manipulator_v1_0_types.RevoluteJoint1OffsetRec, prismatic_joint1_angle_rec=manipulator_v1_0_types.PrismaticJoint1AngleRec)),
            ("JointSpecificationList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_joint_specification_rec=manipulator_v1_0_types.RevoluteJointSpecificationRec, prismatic_joint_specification_rec=manipulator_v1_0_types.PrismaticJointSpecificationRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        if mask & 1:
            manipulator_coordinate_sys_x_, manipulator_coordinate_sys_y_, manipulator_coordinate_sys_z_, d_component_of_unit_quaternion_q_, a_component_of_unit_quaternion_q_, b_component_of_unit_quaternion_q_, c_component_of_unit_quaternion_q_ = _S_7I.unpack_from(data, at)
            self.manipulator_coordinate_system_rec = manipulator_v1_0_types.ManipulatorCoordinateSystemRec(-30.0 + manipulator_coordinate_sys_x_ * 1.3969838622484784e-08, -30.0 + manipulator_coordinate_sys_y_ * 1.3969838622484784e-08, -30.0 + manipulator_coordinate_sys_z_ * 1.3969838622484784e-08, -1.0 + d_component_of_unit_quaternion_q_ * 4.656612874161595e-10, -1.0 + a_component_of_unit_quaternion_q_ * 4.656612874161595e-10, -1.0 + b_component_of_unit_quaternion_q_ * 4.656612874161595e-10, -1.0 + c_component_of_unit_quaternion_q_ * 4.656612874161595e-10)
            at += 28
        else: self.manipulator_coordinate_system_rec = None
        tag = data[at]
        at += 1
        self.first_joint_parameters, at = _U_3[tag]._read(data, at, nesting)
        joint_specification_list_count_ = data[at]
        if joint_specification_list_count_ * 8 > size - (at + 1): raise rt.Reject
        at += 1
        joint_specification_list_ = []
        for _ in range(joint_specification_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_4[tag]._read(data, at, nesting)
            joint_specification_list_.append(item_)
        self.joint_specification_list = joint_specification_list_
        self.reserved_presence = mask & 0xFE
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x46")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1: raise rt.Reject
        manipulator_coordinate_system_rec_ = self.manipulator_coordinate_system_rec
        if manipulator_coordinate_system_rec_ is not None:
            mask |= 1
            if type(manipulator_coordinate_system_rec_) is not manipulator_v1_0_types.ManipulatorCoordinateSystemRec: raise rt.Reject
            manipulator_coordinate_sys_x_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_x
            if not -30.0 <= manipulator_coordinate_sys_x_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_x_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_x_raw_ < 0.9999847412109375: manipulator_coordinate_sys_x_raw_ = rt.exact_raw(manipulator_coordinate_sys_x_, _R_5)
            manipulator_coordinate_sys_y_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_y
            if not -30.0 <= manipulator_coordinate_sys_y_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_y_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_y_raw_ < 0.9999847412109375: manipulator_coordinate_sys_y_raw_ = rt.exact_raw(manipulator_coordinate_sys_y_, _R_5)
            manipulator_coordinate_sys_z_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_z
            if not -30.0 <= manipulator_coordinate_sys_z_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_z_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_z_raw_ < 0.9999847412109375: manipulator_coordinate_sys_z_raw_ = rt.exact_raw(manipulator_coordinate_sys_z_, _R_5)
            d_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.d_component_of_unit_quaternion_q
            if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            d_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_6)
            a_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.a_component_of_unit_quaternion_q
            if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            a_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_6)
            b_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.b_component_of_unit_quaternion_q
            if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            b_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_6)
            c_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.c_component_of_unit_quaternion_q
            if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            c_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_6)
            out += _S_7I.pack(manipulator_coordinate_sys_x_raw_, manipulator_coordinate_sys_y_raw_, manipulator_coordinate_sys_z_raw_, d_component_of_unit_quaternion_q_raw_, a_component_of_unit_quaternion_q_raw_, b_component_of_unit_quaternion_q_raw_, c_component_of_unit_quaternion_q_raw_)
        first_joint_parameters_ = self.first_joint_parameters
        out.append(_T_7[type(first_joint_parameters_)])
        first_joint_parameters_._write(out)
        joint_specification_list_ = self.joint_specification_list
        if type(joint_specification_list_) is not list: raise rt.Reject
        out.append(len(joint_specification_list_))
        for item_ in joint_specification_list_:
            out.append(_T_8[type(item_)])
            item_._write(out)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportCommandedActuatorForceTorques(rt.Message):
    """ReportCommandedActuatorForceTorques (0x4613): Tells the commanded force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4613
    NAME = "ReportCommandedActuatorForceTorques"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec

    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ActuatorForceTorqueList", rt.Repeat(rt.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x13 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        actuator_force_torque_list_count_ = data[2]
        if actuator_force_torque_list_count_ * 5 > size - 3: raise rt.Reject
        at = 3
        actuator_force_torque_list_ = []
        for _ in range(actuator_force_torque_list_count_):
            item_ = rt.new(manipulator_v1_0_types.ActuatorForceTorqueRec)
            item_.joint_force_torque, at = manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque._read(data, at, nesting)
            actuator_force_torque_list_.append(item_)
        self.actuator_force_torque_list = actuator_force_torque_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x13\x46")
        actuator_force_torque_list_ = self.actuator_force_torque_list
        if type(actuator_force_torque_list_) is not list: raise rt.Reject
        out.append(len(actuator_force_torque_list_))
        for item_ in actuator_force_torque_list_:
            if type(item_) is not manipulator_v1_0_types.ActuatorForceTorqueRec: raise rt.Reject
            joint_force_torque_ = item_.joint_force_torque
            if type(joint_force_torque_) is not manipulator_v1_0_types.ActuatorForceTorqueRec.JointForceTorque: raise rt.Reject
            joint_force_torque_._write(out)
        return bytes(out)


_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_S_7I = rt.Packer("<7I")
_U_3: tuple[type[manipulator_v1_0_types.RevoluteJoint1OffsetRec] | type[manipulator_v1_0_types.PrismaticJoint1AngleRec], ...] = (manipulator_v1_0_types.RevoluteJoint1OffsetRec, manipulator_v1_0_types.PrismaticJoint1AngleRec)
_U_4: tuple[type[manipulator_v1_0_types.RevoluteJointSpecificationRec] | type[manipulator_v1_0_types.PrismaticJointSpecificationRec], ...] = (manipulator_v1_0_types.RevoluteJointSpecificationRec, manipulator_v1_0_types.PrismaticJointSpecificationRec)
_R_5 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_6 = rt.Scaling(-1.0, 1.0, 4294967295)
_T_7: dict[type[rt.Struct], int] = {manipulator_v1_0_types.RevoluteJoint1OffsetRec: 0, manipulator_v1_0_types.PrismaticJoint1AngleRec: 1}
_T_8: dict[type[rt.Struct], int] = {manipulator_v1_0_types.RevoluteJointSpecificationRec: 0, manipulator_v1_0_types.PrismaticJointSpecificationRec: 1}
_S_B = rt.Packer("<B")
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryCommandedActuatorForceTorques.REPORT = ReportCommandedActuatorForceTorques
