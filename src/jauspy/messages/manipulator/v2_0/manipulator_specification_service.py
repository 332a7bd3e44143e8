"""urn:jaus:jss:manipulator:ManipulatorSpecificationService 2.0. Generated from schemas/; do not edit."""

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
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorSpecificationService"
    VERSION = "2.0"
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


@dataclass(slots=True, repr=False, kw_only=True)
class ReportManipulatorSpecifications(rt.Message):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator.

    manipulator_coordinate_system_rec: optional. Where the base is mounted on the vehicle
    first_joint_parameters: The first joint, revolute or prismatic
    joint_specification_list: 0..255 items. The joints after the first
    joint_names_list: 0..255 items, optional. The joints, from the base
    """

    CODE = 0x4600
    NAME = "ReportManipulatorSpecifications"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorSpecificationService"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    ManipulatorCoordinateSystemRec = manipulator_v1_0_types.ManipulatorCoordinateSystemRec

    @dataclass(slots=True, repr=False)
    class RevoluteJoint1OffsetRec(rt.Struct):
        """The first joint, when revolute.

        joint1_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
        joint1_min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
        joint1_max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
        joint1_max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
        joint1_max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
        offset_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the offset, in metres
        """

        joint1_offset: float
        joint1_min_value: float | None = None
        joint1_max_value: float | None = None
        joint1_max_speed: float | None = None
        joint1_max_torque: float | None = None
        offset_bounding_cylinder_radius: float | None = None
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
                ("OffsetBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportManipulatorSpecifications_RevoluteJoint1OffsetRec_0[mask & 0x1F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            joint1_offset_ = raw()
            self.joint1_offset = -10.0 + joint1_offset_ * 0.00030518043793392844
            self.joint1_min_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 1 else None
            self.joint1_max_value = -25.132741228718345 + raw() * 1.1703344636862174e-08 if mask & 2 else None
            self.joint1_max_speed = raw() * 7.314590398038859e-09 if mask & 4 else None
            self.joint1_max_torque = raw() * 1.1641532185403987e-06 if mask & 8 else None
            self.offset_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 16 else None
            self.reserved_presence = mask & 0xE0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1F: raise rt.Reject
            raw: list[int | float | bytes] = []
            joint1_offset_ = self.joint1_offset
            if not -10.0 <= joint1_offset_ <= 10.0: raise rt.Reject
            near = joint1_offset_ * 3276.75 + 32768.0
            joint1_offset_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_offset_raw_ < 0.9999847412109375: joint1_offset_raw_ = rt.exact_raw(joint1_offset_, _R_2)
            raw.append(joint1_offset_raw_)
            joint1_min_value_ = self.joint1_min_value
            if joint1_min_value_ is not None:
                mask |= 1
                if not -25.132741228718345 <= joint1_min_value_ <= 25.132741228718345: raise rt.Reject
                near = joint1_min_value_ * 85445659.42715958 + 2147483647.9999998
                joint1_min_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_min_value_raw_ < 0.9999847412109375: joint1_min_value_raw_ = rt.exact_raw(joint1_min_value_, _R_3)
                raw.append(joint1_min_value_raw_)
            joint1_max_value_ = self.joint1_max_value
            if joint1_max_value_ is not None:
                mask |= 2
                if not -25.132741228718345 <= joint1_max_value_ <= 25.132741228718345: raise rt.Reject
                near = joint1_max_value_ * 85445659.42715958 + 2147483647.9999998
                joint1_max_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_max_value_raw_ < 0.9999847412109375: joint1_max_value_raw_ = rt.exact_raw(joint1_max_value_, _R_3)
                raw.append(joint1_max_value_raw_)
            joint1_max_speed_ = self.joint1_max_speed
            if joint1_max_speed_ is not None:
                mask |= 4
                if not 0.0 <= joint1_max_speed_ <= 31.41592653589793: raise rt.Reject
                near = joint1_max_speed_ * 136713055.08345532 + 0.5
                joint1_max_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_4)
                raw.append(joint1_max_speed_raw_)
            joint1_max_torque_ = self.joint1_max_torque
            if joint1_max_torque_ is not None:
                mask |= 8
                if not 0.0 <= joint1_max_torque_ <= 5000.0: raise rt.Reject
                near = joint1_max_torque_ * 858993.459 + 0.5
                joint1_max_torque_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_max_torque_raw_ < 0.9999847412109375: joint1_max_torque_raw_ = rt.exact_raw(joint1_max_torque_, _R_5)
                raw.append(joint1_max_torque_raw_)
            offset_bounding_cylinder_radius_ = self.offset_bounding_cylinder_radius
            if offset_bounding_cylinder_radius_ is not None:
                mask |= 16
                if not 0.0 <= offset_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = offset_bounding_cylinder_radius_ * 6553.5 + 0.5
                offset_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - offset_bounding_cylinder_radius_raw_ < 0.9999847412109375: offset_bounding_cylinder_radius_raw_ = rt.exact_raw(offset_bounding_cylinder_radius_, _R_6)
                raw.append(offset_bounding_cylinder_radius_raw_)
            out += _M_ReportManipulatorSpecifications_RevoluteJoint1OffsetRec_0[mask & 0x1F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PrismaticJoint1AngleRec(rt.Struct):
        """The first joint, when prismatic.

        joint1_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
        joint1_min_value: -10..10 meter. Smallest position, in metres
        joint1_max_value: -10..10 meter. Largest position, in metres
        joint1_max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
        joint1_max_force: 0..5000 newton, optional. Largest force, in newtons
        joint_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the joint, in metres
        """

        joint1_angle: float
        joint1_min_value: float
        joint1_max_value: float
        joint1_max_speed: float | None = None
        joint1_max_force: float | None = None
        joint_bounding_cylinder_radius: float | None = None
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
                ("JointBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportManipulatorSpecifications_PrismaticJoint1AngleRec_0[mask & 0x7]
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
            self.joint_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 4 else None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            joint1_angle_ = self.joint1_angle
            if not -3.141592653589793 <= joint1_angle_ <= 3.141592653589793: raise rt.Reject
            near = joint1_angle_ * 10430.219195527361 + 32768.0
            joint1_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_angle_raw_ < 0.9999847412109375: joint1_angle_raw_ = rt.exact_raw(joint1_angle_, _R_9)
            raw.append(joint1_angle_raw_)
            joint1_min_value_ = self.joint1_min_value
            if not -10.0 <= joint1_min_value_ <= 10.0: raise rt.Reject
            near = joint1_min_value_ * 214748364.75 + 2147483648.0
            joint1_min_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_min_value_raw_ < 0.9999847412109375: joint1_min_value_raw_ = rt.exact_raw(joint1_min_value_, _R_10)
            raw.append(joint1_min_value_raw_)
            joint1_max_value_ = self.joint1_max_value
            if not -10.0 <= joint1_max_value_ <= 10.0: raise rt.Reject
            near = joint1_max_value_ * 214748364.75 + 2147483648.0
            joint1_max_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint1_max_value_raw_ < 0.9999847412109375: joint1_max_value_raw_ = rt.exact_raw(joint1_max_value_, _R_10)
            raw.append(joint1_max_value_raw_)
            joint1_max_speed_ = self.joint1_max_speed
            if joint1_max_speed_ is not None:
                mask |= 1
                if not -5.0 <= joint1_max_speed_ <= 5.0: raise rt.Reject
                near = joint1_max_speed_ * 429496729.5 + 2147483648.0
                joint1_max_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_11)
                raw.append(joint1_max_speed_raw_)
            joint1_max_force_ = self.joint1_max_force
            if joint1_max_force_ is not None:
                mask |= 2
                if not 0.0 <= joint1_max_force_ <= 5000.0: raise rt.Reject
                near = joint1_max_force_ * 858993.459 + 0.5
                joint1_max_force_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint1_max_force_raw_ < 0.9999847412109375: joint1_max_force_raw_ = rt.exact_raw(joint1_max_force_, _R_5)
                raw.append(joint1_max_force_raw_)
            joint_bounding_cylinder_radius_ = self.joint_bounding_cylinder_radius
            if joint_bounding_cylinder_radius_ is not None:
                mask |= 4
                if not 0.0 <= joint_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = joint_bounding_cylinder_radius_ * 6553.5 + 0.5
                joint_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint_bounding_cylinder_radius_raw_ < 0.9999847412109375: joint_bounding_cylinder_radius_raw_ = rt.exact_raw(joint_bounding_cylinder_radius_, _R_6)
                raw.append(joint_bounding_cylinder_radius_raw_)
            out += _M_ReportManipulatorSpecifications_PrismaticJoint1AngleRec_0[mask & 0x7].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class RevoluteJointSpecificationRec(rt.Struct):
        """A revolute joint.

        link_length: -10..10 meter. Distance to the axis of the joint before, in metres
        twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
        joint_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
        min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
        max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
        max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
        max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
        offset_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the offset, in metres
        link_length_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the link, in metres
        """

        link_length: float
        twist_angle: float
        joint_offset: float
        min_value: float | None = None
        max_value: float | None = None
        max_speed: float | None = None
        max_torque: float | None = None
        offset_bounding_cylinder_radius: float | None = None
        link_length_bounding_cylinder_radius: float | None = None
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
                ("OffsetBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
                ("LinkLengthBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportManipulatorSpecifications_RevoluteJointSpecificationRec_0[mask & 0x3F]
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
            self.offset_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 16 else None
            self.link_length_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 32 else None
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
            raw: list[int | float | bytes] = []
            link_length_ = self.link_length
            if not -10.0 <= link_length_ <= 10.0: raise rt.Reject
            near = link_length_ * 3276.75 + 32768.0
            link_length_raw_ = int(near)
            if not 1.52587890625e-05 < near - link_length_raw_ < 0.9999847412109375: link_length_raw_ = rt.exact_raw(link_length_, _R_2)
            raw.append(link_length_raw_)
            twist_angle_ = self.twist_angle
            if not -3.141592653589793 <= twist_angle_ <= 3.141592653589793: raise rt.Reject
            near = twist_angle_ * 10430.219195527361 + 32768.0
            twist_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - twist_angle_raw_ < 0.9999847412109375: twist_angle_raw_ = rt.exact_raw(twist_angle_, _R_9)
            raw.append(twist_angle_raw_)
            joint_offset_ = self.joint_offset
            if not -10.0 <= joint_offset_ <= 10.0: raise rt.Reject
            near = joint_offset_ * 3276.75 + 32768.0
            joint_offset_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_offset_raw_ < 0.9999847412109375: joint_offset_raw_ = rt.exact_raw(joint_offset_, _R_2)
            raw.append(joint_offset_raw_)
            min_value_ = self.min_value
            if min_value_ is not None:
                mask |= 1
                if not -25.132741228718345 <= min_value_ <= 25.132741228718345: raise rt.Reject
                near = min_value_ * 85445659.42715958 + 2147483647.9999998
                min_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_value_raw_ < 0.9999847412109375: min_value_raw_ = rt.exact_raw(min_value_, _R_3)
                raw.append(min_value_raw_)
            max_value_ = self.max_value
            if max_value_ is not None:
                mask |= 2
                if not -25.132741228718345 <= max_value_ <= 25.132741228718345: raise rt.Reject
                near = max_value_ * 85445659.42715958 + 2147483647.9999998
                max_value_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_value_raw_ < 0.9999847412109375: max_value_raw_ = rt.exact_raw(max_value_, _R_3)
                raw.append(max_value_raw_)
            max_speed_ = self.max_speed
            if max_speed_ is not None:
                mask |= 4
                if not 0.0 <= max_speed_ <= 31.41592653589793: raise rt.Reject
                near = max_speed_ * 136713055.08345532 + 0.5
                max_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_speed_raw_ < 0.9999847412109375: max_speed_raw_ = rt.exact_raw(max_speed_, _R_4)
                raw.append(max_speed_raw_)
            max_torque_ = self.max_torque
            if max_torque_ is not None:
                mask |= 8
                if not 0.0 <= max_torque_ <= 5000.0: raise rt.Reject
                near = max_torque_ * 858993.459 + 0.5
                max_torque_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_torque_raw_ < 0.9999847412109375: max_torque_raw_ = rt.exact_raw(max_torque_, _R_5)
                raw.append(max_torque_raw_)
            offset_bounding_cylinder_radius_ = self.offset_bounding_cylinder_radius
            if offset_bounding_cylinder_radius_ is not None:
                mask |= 16
                if not 0.0 <= offset_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = offset_bounding_cylinder_radius_ * 6553.5 + 0.5
                offset_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - offset_bounding_cylinder_radius_raw_ < 0.9999847412109375: offset_bounding_cylinder_radius_raw_ = rt.exact_raw(offset_bounding_cylinder_radius_, _R_6)
                raw.append(offset_bounding_cylinder_radius_raw_)
            link_length_bounding_cylinder_radius_ = self.link_length_bounding_cylinder_radius
            if link_length_bounding_cylinder_radius_ is not None:
                mask |= 32
                if not 0.0 <= link_length_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = link_length_bounding_cylinder_radius_ * 6553.5 + 0.5
                link_length_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - link_length_bounding_cylinder_radius_raw_ < 0.9999847412109375: link_length_bounding_cylinder_radius_raw_ = rt.exact_raw(link_length_bounding_cylinder_radius_, _R_6)
                raw.append(link_length_bounding_cylinder_radius_raw_)
            out += _M_ReportManipulatorSpecifications_RevoluteJointSpecificationRec_0[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PrismaticJointSpecificationRec(rt.Struct):
        """A prismatic joint.

        link_length: -10..10 meter. Distance to the axis of the joint before, in metres
        twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
        joint_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
        min_value: -10..10 meter. Smallest position, in metres
        max_value: -10..10 meter. Largest position, in metres
        max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
        max_force: 0..5000 newton, optional. Largest force, in newtons
        joint_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the joint, in metres
        link_length_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the link, in metres
        """

        link_length: float
        twist_angle: float
        joint_angle: float
        min_value: float
        max_value: float
        max_speed: float | None = None
        max_force: float | None = None
        joint_bounding_cylinder_radius: float | None = None
        link_length_bounding_cylinder_radius: float | None = None
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
                ("JointBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
                ("LinkLengthBoundingCylinderRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportManipulatorSpecifications_PrismaticJointSpecificationRec_0[mask & 0xF]
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
            self.joint_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 4 else None
            self.link_length_bounding_cylinder_radius = raw() * 0.00015259021896696422 if mask & 8 else None
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
            if not 1.52587890625e-05 < near - link_length_raw_ < 0.9999847412109375: link_length_raw_ = rt.exact_raw(link_length_, _R_2)
            raw.append(link_length_raw_)
            twist_angle_ = self.twist_angle
            if not -3.141592653589793 <= twist_angle_ <= 3.141592653589793: raise rt.Reject
            near = twist_angle_ * 10430.219195527361 + 32768.0
            twist_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - twist_angle_raw_ < 0.9999847412109375: twist_angle_raw_ = rt.exact_raw(twist_angle_, _R_9)
            raw.append(twist_angle_raw_)
            joint_angle_ = self.joint_angle
            if not -3.141592653589793 <= joint_angle_ <= 3.141592653589793: raise rt.Reject
            near = joint_angle_ * 10430.219195527361 + 32768.0
            joint_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_angle_raw_ < 0.9999847412109375: joint_angle_raw_ = rt.exact_raw(joint_angle_, _R_9)
            raw.append(joint_angle_raw_)
            min_value_ = self.min_value
            if not -10.0 <= min_value_ <= 10.0: raise rt.Reject
            near = min_value_ * 214748364.75 + 2147483648.0
            min_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - min_value_raw_ < 0.9999847412109375: min_value_raw_ = rt.exact_raw(min_value_, _R_10)
            raw.append(min_value_raw_)
            max_value_ = self.max_value
            if not -10.0 <= max_value_ <= 10.0: raise rt.Reject
            near = max_value_ * 214748364.75 + 2147483648.0
            max_value_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_value_raw_ < 0.9999847412109375: max_value_raw_ = rt.exact_raw(max_value_, _R_10)
            raw.append(max_value_raw_)
            max_speed_ = self.max_speed
            if max_speed_ is not None:
                mask |= 1
                if not -5.0 <= max_speed_ <= 5.0: raise rt.Reject
                near = max_speed_ * 429496729.5 + 2147483648.0
                max_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_speed_raw_ < 0.9999847412109375: max_speed_raw_ = rt.exact_raw(max_speed_, _R_11)
                raw.append(max_speed_raw_)
            max_force_ = self.max_force
            if max_force_ is not None:
                mask |= 2
                if not 0.0 <= max_force_ <= 5000.0: raise rt.Reject
                near = max_force_ * 858993.459 + 0.5
                max_force_raw_ = int(near)
                if not 1.52587890625e-05 < near - max_force_raw_ < 0.9999847412109375: max_force_raw_ = rt.exact_raw(max_force_, _R_5)
                raw.append(max_force_raw_)
            joint_bounding_cylinder_radius_ = self.joint_bounding_cylinder_radius
            if joint_bounding_cylinder_radius_ is not None:
                mask |= 4
                if not 0.0 <= joint_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = joint_bounding_cylinder_radius_ * 6553.5 + 0.5
                joint_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - joint_bounding_cylinder_radius_raw_ < 0.9999847412109375: joint_bounding_cylinder_radius_raw_ = rt.exact_raw(joint_bounding_cylinder_radius_, _R_6)
                raw.append(joint_bounding_cylinder_radius_raw_)
            link_length_bounding_cylinder_radius_ = self.link_length_bounding_cylinder_radius
            if link_length_bounding_cylinder_radius_ is not None:
                mask |= 8
                if not 0.0 <= link_length_bounding_cylinder_radius_ <= 10.0: raise rt.Reject
                near = link_length_bounding_cylinder_radius_ * 6553.5 + 0.5
                link_length_bounding_cylinder_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - link_length_bounding_cylinder_radius_raw_ < 0.9999847412109375: link_length_bounding_cylinder_radius_raw_ = rt.exact_raw(link_length_bounding_cylinder_radius_, _R_6)
                raw.append(link_length_bounding_cylinder_radius_raw_)
            out += _M_ReportManipulatorSpecifications_PrismaticJointSpecificationRec_0[mask & 0xF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class JointNameRec(rt.Struct):
        """JointNameRec.

        description: up to 255 characters. Name of the joint, for people
        """

        description: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Description", rt.Text(count=rt.Count("B", 0, 255))),
            )

    manipulator_coordinate_system_rec: manipulator_v1_0_types.ManipulatorCoordinateSystemRec | None = None
    first_joint_parameters: ReportManipulatorSpecifications.RevoluteJoint1OffsetRec | ReportManipulatorSpecifications.PrismaticJoint1AngleRec
    joint_specification_list: list[ReportManipulatorSpecifications.RevoluteJointSpecificationRec | ReportManipulatorSpecifications.PrismaticJointSpecificationRec]
    joint_names_list: list[ReportManipulatorSpecifications.JointNameRec] | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("ManipulatorCoordinateSystemRec", manipulator_v1_0_types.ManipulatorCoordinateSystemRec.layout(), True),
            ("FirstJointParameters", rt.Union.of("B", revolute_joint1_offset_rec=ReportManipulatorSpecifications.RevoluteJoint1OffsetRec, prismatic_joint1_angle_rec=ReportManipulatorSpecifications.PrismaticJoint1AngleRec)),
            ("JointSpecificationList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_joint_specification_rec=ReportManipulatorSpecifications.RevoluteJointSpecificationRec, prismatic_joint_specification_rec=ReportManipulatorSpecifications.PrismaticJointSpecificationRec))),
            ("JointNamesList", rt.Repeat(rt.Count("B", 0, 255), ReportManipulatorSpecifications.JointNameRec.layout()), True),
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
        self.first_joint_parameters, at = _U_15[tag]._read(data, at, nesting)
        joint_specification_list_count_ = data[at]
        if joint_specification_list_count_ * 8 > size - (at + 1): raise rt.Reject
        at += 1
        joint_specification_list_ = []
        for _ in range(joint_specification_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_16[tag]._read(data, at, nesting)
            joint_specification_list_.append(item_)
        self.joint_specification_list = joint_specification_list_
        if mask & 2:
            joint_names_list_count_ = data[at]
            if joint_names_list_count_ * 1 > size - (at + 1): raise rt.Reject
            at += 1
            joint_names_list_ = []
            for _ in range(joint_names_list_count_):
                item_2_ = rt.new(ReportManipulatorSpecifications.JointNameRec)
                description_end_ = at + 1 + data[at]
                item_2_.description = data[at + 1:description_end_].decode("latin-1")
                at = description_end_
                joint_names_list_.append(item_2_)
            self.joint_names_list = joint_names_list_
        else: self.joint_names_list = None
        self.reserved_presence = mask & 0xFC
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x46")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        manipulator_coordinate_system_rec_ = self.manipulator_coordinate_system_rec
        if manipulator_coordinate_system_rec_ is not None:
            mask |= 1
            if type(manipulator_coordinate_system_rec_) is not manipulator_v1_0_types.ManipulatorCoordinateSystemRec: raise rt.Reject
            manipulator_coordinate_sys_x_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_x
            if not -30.0 <= manipulator_coordinate_sys_x_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_x_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_x_raw_ < 0.9999847412109375: manipulator_coordinate_sys_x_raw_ = rt.exact_raw(manipulator_coordinate_sys_x_, _R_17)
            manipulator_coordinate_sys_y_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_y
            if not -30.0 <= manipulator_coordinate_sys_y_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_y_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_y_raw_ < 0.9999847412109375: manipulator_coordinate_sys_y_raw_ = rt.exact_raw(manipulator_coordinate_sys_y_, _R_17)
            manipulator_coordinate_sys_z_ = manipulator_coordinate_system_rec_.manipulator_coordinate_sys_z
            if not -30.0 <= manipulator_coordinate_sys_z_ <= 30.0: raise rt.Reject
            near = manipulator_coordinate_sys_z_ * 71582788.25 + 2147483648.0
            manipulator_coordinate_sys_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - manipulator_coordinate_sys_z_raw_ < 0.9999847412109375: manipulator_coordinate_sys_z_raw_ = rt.exact_raw(manipulator_coordinate_sys_z_, _R_17)
            d_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.d_component_of_unit_quaternion_q
            if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            d_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_18)
            a_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.a_component_of_unit_quaternion_q
            if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            a_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_18)
            b_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.b_component_of_unit_quaternion_q
            if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            b_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_18)
            c_component_of_unit_quaternion_q_ = manipulator_coordinate_system_rec_.c_component_of_unit_quaternion_q
            if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            c_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_18)
            out += _S_7I.pack(manipulator_coordinate_sys_x_raw_, manipulator_coordinate_sys_y_raw_, manipulator_coordinate_sys_z_raw_, d_component_of_unit_quaternion_q_raw_, a_component_of_unit_quaternion_q_raw_, b_component_of_unit_quaternion_q_raw_, c_component_of_unit_quaternion_q_raw_)
        first_joint_parameters_ = self.first_joint_parameters
        out.append(_T_19[type(first_joint_parameters_)])
        first_joint_parameters_._write(out)
        joint_specification_list_ = self.joint_specification_list
        if type(joint_specification_list_) is not list: raise rt.Reject
        out.append(len(joint_specification_list_))
        for item_ in joint_specification_list_:
            out.append(_T_20[type(item_)])
            item_._write(out)
        joint_names_list_ = self.joint_names_list
        if joint_names_list_ is not None:
            mask |= 2
            if type(joint_names_list_) is not list: raise rt.Reject
            out.append(len(joint_names_list_))
            for item_2_ in joint_names_list_:
                if type(item_2_) is not ReportManipulatorSpecifications.JointNameRec: raise rt.Reject
                description_raw_ = item_2_.description.encode("latin-1")
                out.append(len(description_raw_))
                out += description_raw_
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_S_HB = rt.Packer("<HB")
_M_ReportManipulatorSpecifications_RevoluteJoint1OffsetRec_0 = rt.Masks("", ((0, "H"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H")))
_R_2 = rt.Scaling(-10.0, 10.0, 65535)
_R_3 = rt.Scaling(-25.132741228718345, 25.132741228718345, 4294967295)
_R_4 = rt.Scaling(0.0, 31.41592653589793, 4294967295)
_R_5 = rt.Scaling(0.0, 5000.0, 4294967295)
_R_6 = rt.Scaling(0.0, 10.0, 65535)
_S_B = rt.Packer("<B")
_M_ReportManipulatorSpecifications_PrismaticJoint1AngleRec_0 = rt.Masks("", ((0, "H"), (0, "I"), (0, "I"), (1, "I"), (2, "I"), (4, "H")))
_R_9 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_10 = rt.Scaling(-10.0, 10.0, 4294967295)
_R_11 = rt.Scaling(-5.0, 5.0, 4294967295)
_M_ReportManipulatorSpecifications_RevoluteJointSpecificationRec_0 = rt.Masks("", ((0, "H"), (0, "H"), (0, "H"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H")))
_M_ReportManipulatorSpecifications_PrismaticJointSpecificationRec_0 = rt.Masks("", ((0, "H"), (0, "H"), (0, "H"), (0, "I"), (0, "I"), (1, "I"), (2, "I"), (4, "H"), (8, "H")))
_S_7I = rt.Packer("<7I")
_U_15: tuple[type[ReportManipulatorSpecifications.RevoluteJoint1OffsetRec] | type[ReportManipulatorSpecifications.PrismaticJoint1AngleRec], ...] = (ReportManipulatorSpecifications.RevoluteJoint1OffsetRec, ReportManipulatorSpecifications.PrismaticJoint1AngleRec)
_U_16: tuple[type[ReportManipulatorSpecifications.RevoluteJointSpecificationRec] | type[ReportManipulatorSpecifications.PrismaticJointSpecificationRec], ...] = (ReportManipulatorSpecifications.RevoluteJointSpecificationRec, ReportManipulatorSpecifications.PrismaticJointSpecificationRec)
_R_17 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_18 = rt.Scaling(-1.0, 1.0, 4294967295)
_T_19: dict[type[rt.Struct], int] = {ReportManipulatorSpecifications.RevoluteJoint1OffsetRec: 0, ReportManipulatorSpecifications.PrismaticJoint1AngleRec: 1}
_T_20: dict[type[rt.Struct], int] = {ReportManipulatorSpecifications.RevoluteJointSpecificationRec: 0, ReportManipulatorSpecifications.PrismaticJointSpecificationRec: 1}
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
