"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class ActuatorForceTorqueRec(rt.Struct):
    """ActuatorForceTorqueRec.

    joint_force_torque: Torque of a revolute or force of a prismatic joint
    """

    class JointForceTorqueChoice(IntEnum):
        """Values of JointForceTorqueChoice."""

        NEWTON_METER = 1
        NEWTON = 2

    @dataclass(slots=True, repr=False)
    class JointForceTorque(rt.Struct):
        """Torque of a revolute or force of a prismatic joint.

        1: newton meter, -1000..1000 newton meter
        2: newton, -500..500 newton
        """

        choice: ActuatorForceTorqueRec.JointForceTorqueChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    1: rt.real("I", -1000.0, 1000.0, "newton meter"),
                    2: rt.real("I", -500.0, 500.0, "newton"),
                },
                rt.Values(ActuatorForceTorqueRec.JointForceTorqueChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 1:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -1000.0 + value_ * 4.656612874161595e-07
                at += 5
            elif choice == 2:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -500.0 + value_2_ * 2.3283064370807974e-07
                at += 5
            else: raise rt.Reject
            self.choice = _E_ActuatorForceTorqueRec_JointForceTorqueChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 1:
                value_ = self.value
                if not -1000.0 <= value_ <= 1000.0: raise rt.Reject
                near = value_ * 2147483.6475 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 2:
                value_2_ = self.value
                if not -500.0 <= value_2_ <= 500.0: raise rt.Reject
                near = value_2_ * 4294967.295 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_4)
                out += _S_BI.pack(choice, value_raw_2_)
            else: raise rt.Reject

    joint_force_torque: ActuatorForceTorqueRec.JointForceTorque

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointForceTorque", ActuatorForceTorqueRec.JointForceTorque.layout()),
        )


@dataclass(slots=True, repr=False)
class ManipulatorCoordinateSystemRec(rt.Struct):
    """ManipulatorCoordinateSystemRec.

    manipulator_coordinate_sys_x: -30..30 meter. Position of the base on the vehicle along X, in metres
    manipulator_coordinate_sys_y: -30..30 meter. Position of the base on the vehicle along Y, in metres
    manipulator_coordinate_sys_z: -30..30 meter. Position of the base on the vehicle along Z, in metres
    d_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1. Unit quaternion of the attitude: factor of k
    """

    manipulator_coordinate_sys_x: float
    manipulator_coordinate_sys_y: float
    manipulator_coordinate_sys_z: float
    d_component_of_unit_quaternion_q: float
    a_component_of_unit_quaternion_q: float
    b_component_of_unit_quaternion_q: float
    c_component_of_unit_quaternion_q: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ManipulatorCoordinateSysX", rt.real("I", -30.0, 30.0, "meter")),
            ("ManipulatorCoordinateSysY", rt.real("I", -30.0, 30.0, "meter")),
            ("ManipulatorCoordinateSysZ", rt.real("I", -30.0, 30.0, "meter")),
            ("DComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("AComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("BComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
            ("CComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0)),
        )


@dataclass(slots=True, repr=False)
class RevoluteJoint1OffsetRec(rt.Struct):
    """RevoluteJoint1OffsetRec.

    joint1_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
    joint1_min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
    joint1_max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
    joint1_max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
    joint1_max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
    """

    joint1_offset: float
    joint1_min_value: float | None = None
    joint1_max_value: float | None = None
    joint1_max_speed: float | None = None
    joint1_max_torque: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Joint1Offset", rt.real("H", -10.0, 10.0, "meter")),
            ("Joint1MinValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian"), True),
            ("Joint1MaxValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian"), True),
            ("Joint1MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second"), True),
            ("Joint1MaxTorque", rt.real("I", 0.0, 5000.0, "newton meter"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_manipulator_v1_0_types_RevoluteJoint1OffsetRec_0[mask & 0xF]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        joint1_offset_ = raw()
        self.joint1_offset = -10.0 + joint1_offset_ * 0.00030518043793392844
        self.joint1_min_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 1 else None
        self.joint1_max_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 2 else None
        self.joint1_max_speed = raw() * 7.314590398038859e-09 if mask & 4 else None
        self.joint1_max_torque = raw() * 1.1641532185403987e-06 if mask & 8 else None
        self.reserved_presence = mask & 0xF0
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0xF: raise rt.Reject
        raw: list[int | float | bytes] = []
        joint1_offset_ = self.joint1_offset
        if not -10.0 <= joint1_offset_ <= 10.0: raise rt.Reject
        near = joint1_offset_ * 3276.75 + 32768.0
        joint1_offset_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_offset_raw_ < 0.9999847412109375: joint1_offset_raw_ = rt.exact_raw(joint1_offset_, _R_6)
        raw.append(joint1_offset_raw_)
        joint1_min_value_ = self.joint1_min_value
        if joint1_min_value_ is not None:
            mask |= 1
            if not -25.132741228718345 <= joint1_min_value_ <= 25.132741228718345: raise rt.Reject
            near = joint1_min_value_ * 85445659.42715958 + 2147483647.9999998
            joint1_min_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_min_value_raw_ < 0.9999847412109375: joint1_min_value_raw_ = rt.exact_raw(joint1_min_value_, _R_7)
            raw.append(joint1_min_value_raw_)
        joint1_max_value_ = self.joint1_max_value
        if joint1_max_value_ is not None:
            mask |= 2
            if not -25.132741228718345 <= joint1_max_value_ <= 25.132741228718345: raise rt.Reject
            near = joint1_max_value_ * 85445659.42715958 + 2147483647.9999998
            joint1_max_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_value_raw_ < 0.9999847412109375: joint1_max_value_raw_ = rt.exact_raw(joint1_max_value_, _R_7)
            raw.append(joint1_max_value_raw_)
        joint1_max_speed_ = self.joint1_max_speed
        if joint1_max_speed_ is not None:
            mask |= 4
            if not 0.0 <= joint1_max_speed_ <= 31.41592653589793: raise rt.Reject
            near = joint1_max_speed_ * 136713055.08345532 + 0.5
            joint1_max_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_8)
            raw.append(joint1_max_speed_raw_)
        joint1_max_torque_ = self.joint1_max_torque
        if joint1_max_torque_ is not None:
            mask |= 8
            if not 0.0 <= joint1_max_torque_ <= 5000.0: raise rt.Reject
            near = joint1_max_torque_ * 858993.459 + 0.5
            joint1_max_torque_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_torque_raw_ < 0.9999847412109375: joint1_max_torque_raw_ = rt.exact_raw(joint1_max_torque_, _R_9)
            raw.append(joint1_max_torque_raw_)
        out += _M_manipulator_v1_0_types_RevoluteJoint1OffsetRec_0[mask & 0xF].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class PrismaticJoint1AngleRec(rt.Struct):
    """PrismaticJoint1AngleRec.

    joint1_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
    joint1_min_value: -10..10 meter. Smallest position, in metres
    joint1_max_value: -10..10 meter. Largest position, in metres
    joint1_max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
    joint1_max_force: 0..5000 newton, optional. Largest force, in newtons
    """

    joint1_angle: float
    joint1_min_value: float
    joint1_max_value: float
    joint1_max_speed: float | None = None
    joint1_max_force: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Joint1Angle", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
            ("Joint1MinValue", rt.real("I", -10.0, 10.0, "meter")),
            ("Joint1MaxValue", rt.real("I", -10.0, 10.0, "meter")),
            ("Joint1MaxSpeed", rt.real("I", -5.0, 5.0, "meter per second"), True),
            ("Joint1MaxForce", rt.real("I", 0.0, 5000.0, "newton"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_manipulator_v1_0_types_PrismaticJoint1AngleRec_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        joint1_angle_ = raw()
        self.joint1_angle = -3.141592653589793 + joint1_angle_ * 9.587526218325454e-05
        joint1_min_value_ = raw()
        self.joint1_min_value = -10.0 + joint1_min_value_ * 4.656612874161595e-09
        joint1_max_value_ = raw()
        self.joint1_max_value = -10.0 + joint1_max_value_ * 4.656612874161595e-09
        self.joint1_max_speed = -5.0 + raw() * 2.3283064370807974e-09 if mask & 1 else None
        self.joint1_max_force = raw() * 1.1641532185403987e-06 if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        joint1_angle_ = self.joint1_angle
        if not -3.141592653589793 <= joint1_angle_ <= 3.141592653589793: raise rt.Reject
        near = joint1_angle_ * 10430.219195527361 + 32768.0
        joint1_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_angle_raw_ < 0.9999847412109375: joint1_angle_raw_ = rt.exact_raw(joint1_angle_, _R_12)
        raw.append(joint1_angle_raw_)
        joint1_min_value_ = self.joint1_min_value
        if not -10.0 <= joint1_min_value_ <= 10.0: raise rt.Reject
        near = joint1_min_value_ * 214748364.75 + 2147483648.0
        joint1_min_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_min_value_raw_ < 0.9999847412109375: joint1_min_value_raw_ = rt.exact_raw(joint1_min_value_, _R_13)
        raw.append(joint1_min_value_raw_)
        joint1_max_value_ = self.joint1_max_value
        if not -10.0 <= joint1_max_value_ <= 10.0: raise rt.Reject
        near = joint1_max_value_ * 214748364.75 + 2147483648.0
        joint1_max_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_value_raw_ < 0.9999847412109375: joint1_max_value_raw_ = rt.exact_raw(joint1_max_value_, _R_13)
        raw.append(joint1_max_value_raw_)
        joint1_max_speed_ = self.joint1_max_speed
        if joint1_max_speed_ is not None:
            mask |= 1
            if not -5.0 <= joint1_max_speed_ <= 5.0: raise rt.Reject
            near = joint1_max_speed_ * 429496729.5 + 2147483648.0
            joint1_max_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_14)
            raw.append(joint1_max_speed_raw_)
        joint1_max_force_ = self.joint1_max_force
        if joint1_max_force_ is not None:
            mask |= 2
            if not 0.0 <= joint1_max_force_ <= 5000.0: raise rt.Reject
            near = joint1_max_force_ * 858993.459 + 0.5
            joint1_max_force_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_force_raw_ < 0.9999847412109375: joint1_max_force_raw_ = rt.exact_raw(joint1_max_force_, _R_9)
            raw.append(joint1_max_force_raw_)
        out += _M_manipulator_v1_0_types_PrismaticJoint1AngleRec_0[mask & 0x3].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class RevoluteJointSpecificationRec(rt.Struct):
    """RevoluteJointSpecificationRec.

    link_length: -10..10 meter. Distance to the axis of the joint before, in metres
    twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
    joint_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
    min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
    max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
    max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
    max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
    """

    link_length: float
    twist_angle: float
    joint_offset: float
    min_value: float | None = None
    max_value: float | None = None
    max_speed: float | None = None
    max_torque: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("LinkLength", rt.real("H", -10.0, 10.0, "meter")),
            ("TwistAngle", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
            ("JointOffset", rt.real("H", -10.0, 10.0, "meter")),
            ("MinValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian"), True),
            ("MaxValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian"), True),
            ("MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second"), True),
            ("MaxTorque", rt.real("I", 0.0, 5000.0, "newton meter"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_manipulator_v1_0_types_RevoluteJointSpecificationRec_0[mask & 0xF]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        link_length_ = raw()
        self.link_length = -10.0 + link_length_ * 0.00030518043793392844
        twist_angle_ = raw()
        self.twist_angle = -3.141592653589793 + twist_angle_ * 9.587526218325454e-05
        joint_offset_ = raw()
        self.joint_offset = -10.0 + joint_offset_ * 0.00030518043793392844
        self.min_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 1 else None
        self.max_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 2 else None
        self.max_speed = raw() * 7.314590398038859e-09 if mask & 4 else None
        self.max_torque = raw() * 1.1641532185403987e-06 if mask & 8 else None
        self.reserved_presence = mask & 0xF0
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0xF: raise rt.Reject
        raw: list[int | float | bytes] = []
        link_length_ = self.link_length
        if not -10.0 <= link_length_ <= 10.0: raise rt.Reject
        near = link_length_ * 3276.75 + 32768.0
        link_length_raw_ = int(near)
        if not 1.52587890625e-05 < near - link_length_raw_ < 0.9999847412109375: link_length_raw_ = rt.exact_raw(link_length_, _R_6)
        raw.append(link_length_raw_)
        twist_angle_ = self.twist_angle
        if not -3.141592653589793 <= twist_angle_ <= 3.141592653589793: raise rt.Reject
        near = twist_angle_ * 10430.219195527361 + 32768.0
        twist_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - twist_angle_raw_ < 0.9999847412109375: twist_angle_raw_ = rt.exact_raw(twist_angle_, _R_12)
        raw.append(twist_angle_raw_)
        joint_offset_ = self.joint_offset
        if not -10.0 <= joint_offset_ <= 10.0: raise rt.Reject
        near = joint_offset_ * 3276.75 + 32768.0
        joint_offset_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_offset_raw_ < 0.9999847412109375: joint_offset_raw_ = rt.exact_raw(joint_offset_, _R_6)
        raw.append(joint_offset_raw_)
        min_value_ = self.min_value
        if min_value_ is not None:
            mask |= 1
            if not -25.132741228718345 <= min_value_ <= 25.132741228718345: raise rt.Reject
            near = min_value_ * 85445659.42715958 + 2147483647.9999998
            min_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - min_value_raw_ < 0.9999847412109375: min_value_raw_ = rt.exact_raw(min_value_, _R_7)
            raw.append(min_value_raw_)
        max_value_ = self.max_value
        if max_value_ is not None:
            mask |= 2
            if not -25.132741228718345 <= max_value_ <= 25.132741228718345: raise rt.Reject
            near = max_value_ * 85445659.42715958 + 2147483647.9999998
            max_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_value_raw_ < 0.9999847412109375: max_value_raw_ = rt.exact_raw(max_value_, _R_7)
            raw.append(max_value_raw_)
        max_speed_ = self.max_speed
        if max_speed_ is not None:
            mask |= 4
            if not 0.0 <= max_speed_ <= 31.41592653589793: raise rt.Reject
            near = max_speed_ * 136713055.08345532 + 0.5
            max_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_speed_raw_ < 0.9999847412109375: max_speed_raw_ = rt.exact_raw(max_speed_, _R_8)
            raw.append(max_speed_raw_)
        max_torque_ = self.max_torque
        if max_torque_ is not None:
            mask |= 8
            if not 0.0 <= max_torque_ <= 5000.0: raise rt.Reject
            near = max_torque_ * 858993.459 + 0.5
            max_torque_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_torque_raw_ < 0.9999847412109375: max_torque_raw_ = rt.exact_raw(max_torque_, _R_9)
            raw.append(max_torque_raw_)
        out += _M_manipulator_v1_0_types_RevoluteJointSpecificationRec_0[mask & 0xF].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class PrismaticJointSpecificationRec(rt.Struct):
    """PrismaticJointSpecificationRec.

    link_length: -10..10 meter. Distance to the axis of the joint before, in metres
    twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
    joint_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
    min_value: -10..10 meter. Smallest position, in metres
    max_value: -10..10 meter. Largest position, in metres
    max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
    max_force: 0..5000 newton, optional. Largest force, in newtons
    """

    link_length: float
    twist_angle: float
    joint_angle: float
    min_value: float
    max_value: float
    max_speed: float | None = None
    max_force: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("LinkLength", rt.real("H", -10.0, 10.0, "meter")),
            ("TwistAngle", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
            ("JointAngle", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
            ("MinValue", rt.real("I", -10.0, 10.0, "meter")),
            ("MaxValue", rt.real("I", -10.0, 10.0, "meter")),
            ("MaxSpeed", rt.real("I", -5.0, 5.0, "meter per second"), True),
            ("MaxForce", rt.real("I", 0.0, 5000.0, "newton"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_manipulator_v1_0_types_PrismaticJointSpecificationRec_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        link_length_ = raw()
        self.link_length = -10.0 + link_length_ * 0.00030518043793392844
        twist_angle_ = raw()
        self.twist_angle = -3.141592653589793 + twist_angle_ * 9.587526218325454e-05
        joint_angle_ = raw()
        self.joint_angle = -3.141592653589793 + joint_angle_ * 9.587526218325454e-05
        min_value_ = raw()
        self.min_value = -10.0 + min_value_ * 4.656612874161595e-09
        max_value_ = raw()
        self.max_value = -10.0 + max_value_ * 4.656612874161595e-09
        self.max_speed = -5.0 + raw() * 2.3283064370807974e-09 if mask & 1 else None
        self.max_force = raw() * 1.1641532185403987e-06 if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        link_length_ = self.link_length
        if not -10.0 <= link_length_ <= 10.0: raise rt.Reject
        near = link_length_ * 3276.75 + 32768.0
        link_length_raw_ = int(near)
        if not 1.52587890625e-05 < near - link_length_raw_ < 0.9999847412109375: link_length_raw_ = rt.exact_raw(link_length_, _R_6)
        raw.append(link_length_raw_)
        twist_angle_ = self.twist_angle
        if not -3.141592653589793 <= twist_angle_ <= 3.141592653589793: raise rt.Reject
        near = twist_angle_ * 10430.219195527361 + 32768.0
        twist_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - twist_angle_raw_ < 0.9999847412109375: twist_angle_raw_ = rt.exact_raw(twist_angle_, _R_12)
        raw.append(twist_angle_raw_)
        joint_angle_ = self.joint_angle
        if not -3.141592653589793 <= joint_angle_ <= 3.141592653589793: raise rt.Reject
        near = joint_angle_ * 10430.219195527361 + 32768.0
        joint_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_angle_raw_ < 0.9999847412109375: joint_angle_raw_ = rt.exact_raw(joint_angle_, _R_12)
        raw.append(joint_angle_raw_)
        min_value_ = self.min_value
        if not -10.0 <= min_value_ <= 10.0: raise rt.Reject
        near = min_value_ * 214748364.75 + 2147483648.0
        min_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - min_value_raw_ < 0.9999847412109375: min_value_raw_ = rt.exact_raw(min_value_, _R_13)
        raw.append(min_value_raw_)
        max_value_ = self.max_value
        if not -10.0 <= max_value_ <= 10.0: raise rt.Reject
        near = max_value_ * 214748364.75 + 2147483648.0
        max_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - max_value_raw_ < 0.9999847412109375: max_value_raw_ = rt.exact_raw(max_value_, _R_13)
        raw.append(max_value_raw_)
        max_speed_ = self.max_speed
        if max_speed_ is not None:
            mask |= 1
            if not -5.0 <= max_speed_ <= 5.0: raise rt.Reject
            near = max_speed_ * 429496729.5 + 2147483648.0
            max_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_speed_raw_ < 0.9999847412109375: max_speed_raw_ = rt.exact_raw(max_speed_, _R_14)
            raw.append(max_speed_raw_)
        max_force_ = self.max_force
        if max_force_ is not None:
            mask |= 2
            if not 0.0 <= max_force_ <= 5000.0: raise rt.Reject
            near = max_force_ * 858993.459 + 0.5
            max_force_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_force_raw_ < 0.9999847412109375: max_force_raw_ = rt.exact_raw(max_force_, _R_9)
            raw.append(max_force_raw_)
        out += _M_manipulator_v1_0_types_PrismaticJointSpecificationRec_0[mask & 0x3].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class RevoluteMotionProfileRec(rt.Struct):
    """RevoluteMotionProfileRec.

    joint_max_speed: 0..31.4159265359 radian per second. Largest speed, in radians per second
    joint_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration, in radians per second squared
    joint_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration, in radians per second squared
    """

    joint_max_speed: float
    joint_max_acceleration_rate: float
    joint_max_deceleration_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointMaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("JointMaxAccelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("JointMaxDecelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        joint_max_speed_, joint_max_acceleration_rate_, joint_max_deceleration_rate_ = _S_3I.unpack_from(data, at)
        self.joint_max_speed = joint_max_speed_ * 7.314590398038859e-09
        self.joint_max_acceleration_rate = joint_max_acceleration_rate_ * 7.314590398038859e-09
        self.joint_max_deceleration_rate = joint_max_deceleration_rate_ * 7.314590398038859e-09
        return self, at + 12

    def _write(self, out: bytearray) -> None:
        joint_max_speed_ = self.joint_max_speed
        if not 0.0 <= joint_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint_max_speed_ * 136713055.08345532 + 0.5
        joint_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_8)
        joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
        if not 0.0 <= joint_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint_max_acceleration_rate_ * 136713055.08345532 + 0.5
        joint_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_8)
        joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
        if not 0.0 <= joint_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint_max_deceleration_rate_ * 136713055.08345532 + 0.5
        joint_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_8)
        out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)


@dataclass(slots=True, repr=False)
class PrismaticMotionProfileRec(rt.Struct):
    """PrismaticMotionProfileRec.

    joint_max_speed: 0..5 meter per second. Largest speed, in metres per second
    joint_max_acceleration_rate: 0..20 meter per second squared. Largest acceleration, in metres per second squared
    joint_max_deceleration_rate: 0..20 meter per second squared. Largest deceleration, in metres per second squared
    """

    joint_max_speed: float
    joint_max_acceleration_rate: float
    joint_max_deceleration_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointMaxSpeed", rt.real("I", 0.0, 5.0, "meter per second")),
            ("JointMaxAccelerationRate", rt.real("I", 0.0, 20.0, "meter per second squared")),
            ("JointMaxDecelerationRate", rt.real("I", 0.0, 20.0, "meter per second squared")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        joint_max_speed_, joint_max_acceleration_rate_, joint_max_deceleration_rate_ = _S_3I.unpack_from(data, at)
        self.joint_max_speed = joint_max_speed_ * 1.1641532185403987e-09
        self.joint_max_acceleration_rate = joint_max_acceleration_rate_ * 4.656612874161595e-09
        self.joint_max_deceleration_rate = joint_max_deceleration_rate_ * 4.656612874161595e-09
        return self, at + 12

    def _write(self, out: bytearray) -> None:
        joint_max_speed_ = self.joint_max_speed
        if not 0.0 <= joint_max_speed_ <= 5.0: raise rt.Reject
        near = joint_max_speed_ * 858993459.0 + 0.5
        joint_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_18)
        joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
        if not 0.0 <= joint_max_acceleration_rate_ <= 20.0: raise rt.Reject
        near = joint_max_acceleration_rate_ * 214748364.75 + 0.5
        joint_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_19)
        joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
        if not 0.0 <= joint_max_deceleration_rate_ <= 20.0: raise rt.Reject
        near = joint_max_deceleration_rate_ * 214748364.75 + 0.5
        joint_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_19)
        out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)


@dataclass(slots=True, repr=False)
class JointPositionRec(rt.Struct):
    """JointPositionRec.

    joint_position: Angle of a revolute or travel of a prismatic joint
    """

    class JointPositionChoice(IntEnum):
        """Values of JointPositionChoice."""

        RADIAN = 1
        METER = 2

    @dataclass(slots=True, repr=False)
    class JointPosition(rt.Struct):
        """Angle of a revolute or travel of a prismatic joint.

        1: radian, -25.1327412287..25.1327412287 radian
        2: meter, -10..10 meter
        """

        choice: JointPositionRec.JointPositionChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    1: rt.real("I", -25.132741228718345, 25.132741228718345, "radian"),
                    2: rt.real("I", -10.0, 10.0, "meter"),
                },
                rt.Values(JointPositionRec.JointPositionChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 1:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -25.132741228718345 + value_ * 1.1703344636862174e-08
                at += 5
            elif choice == 2:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -10.0 + value_2_ * 4.656612874161595e-09
                at += 5
            else: raise rt.Reject
            self.choice = _E_JointPositionRec_JointPositionChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 1:
                value_ = self.value
                if not -25.132741228718345 <= value_ <= 25.132741228718345: raise rt.Reject
                near = value_ * 85445659.42715958 + 2147483647.9999998
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_7)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 2:
                value_2_ = self.value
                if not -10.0 <= value_2_ <= 10.0: raise rt.Reject
                near = value_2_ * 214748364.75 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_13)
                out += _S_BI.pack(choice, value_raw_2_)
            else: raise rt.Reject

    joint_position: JointPositionRec.JointPosition

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointPosition", JointPositionRec.JointPosition.layout()),
        )


@dataclass(slots=True, repr=False)
class JointVelocityRec(rt.Struct):
    """JointVelocityRec.

    joint_velocity: Velocity of a revolute or prismatic joint
    """

    class JointVelocityChoice(IntEnum):
        """Values of JointVelocityChoice."""

        RADIAN_PER_SECOND = 1
        METER_PER_SECOND = 2

    @dataclass(slots=True, repr=False)
    class JointVelocity(rt.Struct):
        """Velocity of a revolute or prismatic joint.

        1: radian per second, -31.4159265359..31.4159265359 radian per second
        2: meter per second, -5..5 meter per second
        """

        choice: JointVelocityRec.JointVelocityChoice | int
        value: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    1: rt.real("I", -31.41592653589793, 31.41592653589793, "radian per second"),
                    2: rt.real("I", -5.0, 5.0, "meter per second"),
                },
                rt.Values(JointVelocityRec.JointVelocityChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 1:
                (value_,) = _S_I.unpack_from(data, at + 1)
                self.value = -31.41592653589793 + value_ * 1.4629180796077718e-08
                at += 5
            elif choice == 2:
                (value_2_,) = _S_I.unpack_from(data, at + 1)
                self.value = -5.0 + value_2_ * 2.3283064370807974e-09
                at += 5
            else: raise rt.Reject
            self.choice = _E_JointVelocityRec_JointVelocityChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 1:
                value_ = self.value
                if not -31.41592653589793 <= value_ <= 31.41592653589793: raise rt.Reject
                near = value_ * 68356527.54172766 + 2147483647.9999998
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_22)
                out += _S_BI.pack(choice, value_raw_)
            elif choice == 2:
                value_2_ = self.value
                if not -5.0 <= value_2_ <= 5.0: raise rt.Reject
                near = value_2_ * 429496729.5 + 2147483648.0
                value_raw_2_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_14)
                out += _S_BI.pack(choice, value_raw_2_)
            else: raise rt.Reject

    joint_velocity: JointVelocityRec.JointVelocity

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointVelocity", JointVelocityRec.JointVelocity.layout()),
        )


@dataclass(slots=True, repr=False)
class JointEffortRec(rt.Struct):
    """JointEffortRec.

    joint_effort: -100..100. Effort, in percent of the maximum
    """

    joint_effort: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointEffort", rt.real("H", -100.0, 100.0)),
        )


_S_I = rt.Packer("<I")
_E_ActuatorForceTorqueRec_JointForceTorqueChoice = rt.members(ActuatorForceTorqueRec.JointForceTorqueChoice)
_R_2 = rt.Scaling(-1000.0, 1000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_R_4 = rt.Scaling(-500.0, 500.0, 4294967295)
_M_manipulator_v1_0_types_RevoluteJoint1OffsetRec_0 = rt.Masks("", ((0, "H"), (1, "I"), (2, "I"), (4, "I"), (8, "I")))
_R_6 = rt.Scaling(-10.0, 10.0, 65535)
_R_7 = rt.Scaling(-25.132741228718345, 25.132741228718345, 4294967295)
_R_8 = rt.Scaling(0.0, 31.41592653589793, 4294967295)
_R_9 = rt.Scaling(0.0, 5000.0, 4294967295)
_S_B = rt.Packer("<B")
_M_manipulator_v1_0_types_PrismaticJoint1AngleRec_0 = rt.Masks("", ((0, "H"), (0, "I"), (0, "I"), (1, "I"), (2, "I")))
_R_12 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_13 = rt.Scaling(-10.0, 10.0, 4294967295)
_R_14 = rt.Scaling(-5.0, 5.0, 4294967295)
_M_manipulator_v1_0_types_RevoluteJointSpecificationRec_0 = rt.Masks("", ((0, "H"), (0, "H"), (0, "H"), (1, "I"), (2, "I"), (4, "I"), (8, "I")))
_M_manipulator_v1_0_types_PrismaticJointSpecificationRec_0 = rt.Masks("", ((0, "H"), (0, "H"), (0, "H"), (0, "I"), (0, "I"), (1, "I"), (2, "I")))
_S_3I = rt.Packer("<3I")
_R_18 = rt.Scaling(0.0, 5.0, 4294967295)
_R_19 = rt.Scaling(0.0, 20.0, 4294967295)
_E_JointPositionRec_JointPositionChoice = rt.members(JointPositionRec.JointPositionChoice)
_E_JointVelocityRec_JointVelocityChoice = rt.members(JointVelocityRec.JointVelocityChoice)
_R_22 = rt.Scaling(-31.41592653589793, 31.41592653589793, 4294967295)
