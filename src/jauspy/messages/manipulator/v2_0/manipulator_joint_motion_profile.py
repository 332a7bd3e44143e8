"""urn:jaus:jss:manipulator:ManipulatorJointMotionProfile 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryJointMotionProfile(rt.Message):
    """QueryJointMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""

    CODE = 0x2607
    NAME = "QueryJointMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointMotionProfile"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportJointMotionProfile]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x07&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2607)


@dataclass(slots=True, repr=False)
class SetJointMotionProfile(rt.Message):
    """SetJointMotionProfile (0x0607): Sets limits of speed and acceleration of each joint.

    joint_motion_profile_list: 0..255 items. The joints, from the base
    """

    CODE = 0x0607
    NAME = "SetJointMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointMotionProfile"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RevoluteJointMotionProfileRec(rt.Struct):
        """Limits of a revolute joint.

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
            if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_2)
            joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
            if not 0.0 <= joint_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
            near = joint_max_acceleration_rate_ * 136713055.08345532 + 0.5
            joint_max_acceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_2)
            joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
            if not 0.0 <= joint_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
            near = joint_max_deceleration_rate_ * 136713055.08345532 + 0.5
            joint_max_deceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_2)
            out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)

    @dataclass(slots=True, repr=False)
    class PrismaticJointMotionProfileRec(rt.Struct):
        """Limits of a prismatic joint.

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
            if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_3)
            joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
            if not 0.0 <= joint_max_acceleration_rate_ <= 20.0: raise rt.Reject
            near = joint_max_acceleration_rate_ * 214748364.75 + 0.5
            joint_max_acceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_4)
            joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
            if not 0.0 <= joint_max_deceleration_rate_ <= 20.0: raise rt.Reject
            near = joint_max_deceleration_rate_ * 214748364.75 + 0.5
            joint_max_deceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_4)
            out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)

    joint_motion_profile_list: list[SetJointMotionProfile.RevoluteJointMotionProfileRec | SetJointMotionProfile.PrismaticJointMotionProfileRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointMotionProfileList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_joint_motion_profile_rec=SetJointMotionProfile.RevoluteJointMotionProfileRec, prismatic_joint_motion_profile_rec=SetJointMotionProfile.PrismaticJointMotionProfileRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x06: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_motion_profile_list_count_ = data[2]
        if joint_motion_profile_list_count_ * 13 > size - 3: raise rt.Reject
        at = 3
        joint_motion_profile_list_ = []
        for _ in range(joint_motion_profile_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_5[tag]._read(data, at, nesting)
            joint_motion_profile_list_.append(item_)
        self.joint_motion_profile_list = joint_motion_profile_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x06")
        joint_motion_profile_list_ = self.joint_motion_profile_list
        if type(joint_motion_profile_list_) is not list: raise rt.Reject
        out.append(len(joint_motion_profile_list_))
        for item_ in joint_motion_profile_list_:
            out.append(_T_6[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportJointMotionProfile(rt.Message):
    """ReportJointMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint.

    joint_motion_profile_list: 0..255 items. The joints, from the base
    """

    CODE = 0x4607
    NAME = "ReportJointMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointMotionProfile"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RevoluteJointMotionProfileRec(rt.Struct):
        """Limits of a revolute joint.

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
            if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_2)
            joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
            if not 0.0 <= joint_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
            near = joint_max_acceleration_rate_ * 136713055.08345532 + 0.5
            joint_max_acceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_2)
            joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
            if not 0.0 <= joint_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
            near = joint_max_deceleration_rate_ * 136713055.08345532 + 0.5
            joint_max_deceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_2)
            out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)

    @dataclass(slots=True, repr=False)
    class PrismaticJointMotionProfileRec(rt.Struct):
        """Limits of a prismatic joint.

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
            if not 1.52587890625e-05 < near - joint_max_speed_raw_ < 0.9999847412109375: joint_max_speed_raw_ = rt.exact_raw(joint_max_speed_, _R_3)
            joint_max_acceleration_rate_ = self.joint_max_acceleration_rate
            if not 0.0 <= joint_max_acceleration_rate_ <= 20.0: raise rt.Reject
            near = joint_max_acceleration_rate_ * 214748364.75 + 0.5
            joint_max_acceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_acceleration_rate_raw_ < 0.9999847412109375: joint_max_acceleration_rate_raw_ = rt.exact_raw(joint_max_acceleration_rate_, _R_4)
            joint_max_deceleration_rate_ = self.joint_max_deceleration_rate
            if not 0.0 <= joint_max_deceleration_rate_ <= 20.0: raise rt.Reject
            near = joint_max_deceleration_rate_ * 214748364.75 + 0.5
            joint_max_deceleration_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - joint_max_deceleration_rate_raw_ < 0.9999847412109375: joint_max_deceleration_rate_raw_ = rt.exact_raw(joint_max_deceleration_rate_, _R_4)
            out += _S_3I.pack(joint_max_speed_raw_, joint_max_acceleration_rate_raw_, joint_max_deceleration_rate_raw_)

    joint_motion_profile_list: list[ReportJointMotionProfile.RevoluteJointMotionProfileRec | ReportJointMotionProfile.PrismaticJointMotionProfileRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("JointMotionProfileList", rt.Repeat(rt.Count("B", 0, 255), rt.Union.of("B", revolute_joint_motion_profile_rec=ReportJointMotionProfile.RevoluteJointMotionProfileRec, prismatic_joint_motion_profile_rec=ReportJointMotionProfile.PrismaticJointMotionProfileRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x46: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        joint_motion_profile_list_count_ = data[2]
        if joint_motion_profile_list_count_ * 13 > size - 3: raise rt.Reject
        at = 3
        joint_motion_profile_list_ = []
        for _ in range(joint_motion_profile_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_7[tag]._read(data, at, nesting)
            joint_motion_profile_list_.append(item_)
        self.joint_motion_profile_list = joint_motion_profile_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x46")
        joint_motion_profile_list_ = self.joint_motion_profile_list
        if type(joint_motion_profile_list_) is not list: raise rt.Reject
        out.append(len(joint_motion_profile_list_))
        for item_ in joint_motion_profile_list_:
            out.append(_T_8[type(item_)])
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_3I = rt.Packer("<3I")
_R_2 = rt.Scaling(0.0, 31.41592653589793, 4294967295)
_R_3 = rt.Scaling(0.0, 5.0, 4294967295)
_R_4 = rt.Scaling(0.0, 20.0, 4294967295)
_U_5: tuple[type[SetJointMotionProfile.RevoluteJointMotionProfileRec] | type[SetJointMotionProfile.PrismaticJointMotionProfileRec], ...] = (SetJointMotionProfile.RevoluteJointMotionProfileRec, SetJointMotionProfile.PrismaticJointMotionProfileRec)
_T_6: dict[type[rt.Struct], int] = {SetJointMotionProfile.RevoluteJointMotionProfileRec: 0, SetJointMotionProfile.PrismaticJointMotionProfileRec: 1}
_U_7: tuple[type[ReportJointMotionProfile.RevoluteJointMotionProfileRec] | type[ReportJointMotionProfile.PrismaticJointMotionProfileRec], ...] = (ReportJointMotionProfile.RevoluteJointMotionProfileRec, ReportJointMotionProfile.PrismaticJointMotionProfileRec)
_T_8: dict[type[rt.Struct], int] = {ReportJointMotionProfile.RevoluteJointMotionProfileRec: 0, ReportJointMotionProfile.PrismaticJointMotionProfileRec: 1}
QueryJointMotionProfile.REPORT = ReportJointMotionProfile
