"""urn:jaus:jss:manipulator:PanTiltJointPositionDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryPanTiltSpecifications(rt.Message):
    """QueryPanTiltSpecifications (0x2620): Asks for mounting and limits of the pan-tilt unit.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2620
    NAME = "QueryPanTiltSpecifications"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPanTiltSpecifications]]

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
        if code != 0x2620: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2620, self.presence_vector)


@dataclass(slots=True, repr=False)
class QueryCommandedPanTiltJointPositions(rt.Message):
    """QueryCommandedPanTiltJointPositions (0x2628): Asks for the commanded angles."""

    CODE = 0x2628
    NAME = "QueryCommandedPanTiltJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCommandedPanTiltJointPositions]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'(&': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2628)


@dataclass(slots=True, repr=False)
class QueryPanTiltMotionProfile(rt.Message):
    """QueryPanTiltMotionProfile (0x2627): Asks for the limits of speed and acceleration."""

    CODE = 0x2627
    NAME = "QueryPanTiltMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPanTiltMotionProfile]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"'&": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2627)


@dataclass(slots=True, repr=False)
class SetPanTiltJointPositions(rt.Message):
    """SetPanTiltJointPositions (0x0622): Sets the angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """

    CODE = 0x0622
    NAME = "SetPanTiltJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    joint1_position: float
    joint2_position: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint2Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_position_, joint2_position_ = _S_H2I.unpack(data)
        if code != 0x0622: raise rt.Reject
        self.joint1_position = -25.132741228718345 + joint1_position_ * 1.1703344636862174e-08
        self.joint2_position = -25.132741228718345 + joint2_position_ * 1.1703344636862174e-08
        return self

    def _pack(self) -> bytes:
        joint1_position_ = self.joint1_position
        if not -25.132741228718345 <= joint1_position_ <= 25.132741228718345: raise rt.Reject
        near = joint1_position_ * 85445659.42715958 + 2147483647.9999998
        joint1_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_position_raw_ < 0.9999847412109375: joint1_position_raw_ = rt.exact_raw(joint1_position_, _R_3)
        joint2_position_ = self.joint2_position
        if not -25.132741228718345 <= joint2_position_ <= 25.132741228718345: raise rt.Reject
        near = joint2_position_ * 85445659.42715958 + 2147483647.9999998
        joint2_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_position_raw_ < 0.9999847412109375: joint2_position_raw_ = rt.exact_raw(joint2_position_, _R_3)
        return _S_H2I.pack(0x0622, joint1_position_raw_, joint2_position_raw_)


@dataclass(slots=True, repr=False)
class SetPanTiltMotionProfile(rt.Message):
    """SetPanTiltMotionProfile (0x0627): Sets limits of speed and acceleration.

    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint1_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the pan joint, in radians per second squared
    joint1_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the pan joint, in radians per second squared
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    joint2_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the tilt joint, in radians per second squared
    joint2_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the tilt joint, in radians per second squared
    """

    CODE = 0x0627
    NAME = "SetPanTiltMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    joint1_max_speed: float
    joint1_max_acceleration_rate: float
    joint1_max_deceleration_rate: float
    joint2_max_speed: float
    joint2_max_acceleration_rate: float
    joint2_max_deceleration_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("Joint1MaxAccelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint1MaxDecelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint2MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("Joint2MaxAccelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint2MaxDecelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_max_speed_, joint1_max_acceleration_rate_, joint1_max_deceleration_rate_, joint2_max_speed_, joint2_max_acceleration_rate_, joint2_max_deceleration_rate_ = _S_H6I.unpack(data)
        if code != 0x0627: raise rt.Reject
        self.joint1_max_speed = joint1_max_speed_ * 7.314590398038859e-09
        self.joint1_max_acceleration_rate = joint1_max_acceleration_rate_ * 7.314590398038859e-09
        self.joint1_max_deceleration_rate = joint1_max_deceleration_rate_ * 7.314590398038859e-09
        self.joint2_max_speed = joint2_max_speed_ * 7.314590398038859e-09
        self.joint2_max_acceleration_rate = joint2_max_acceleration_rate_ * 7.314590398038859e-09
        self.joint2_max_deceleration_rate = joint2_max_deceleration_rate_ * 7.314590398038859e-09
        return self

    def _pack(self) -> bytes:
        joint1_max_speed_ = self.joint1_max_speed
        if not 0.0 <= joint1_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_speed_ * 136713055.08345532 + 0.5
        joint1_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_5)
        joint1_max_acceleration_rate_ = self.joint1_max_acceleration_rate
        if not 0.0 <= joint1_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_acceleration_rate_ * 136713055.08345532 + 0.5
        joint1_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_acceleration_rate_raw_ < 0.9999847412109375: joint1_max_acceleration_rate_raw_ = rt.exact_raw(joint1_max_acceleration_rate_, _R_5)
        joint1_max_deceleration_rate_ = self.joint1_max_deceleration_rate
        if not 0.0 <= joint1_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_deceleration_rate_ * 136713055.08345532 + 0.5
        joint1_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_deceleration_rate_raw_ < 0.9999847412109375: joint1_max_deceleration_rate_raw_ = rt.exact_raw(joint1_max_deceleration_rate_, _R_5)
        joint2_max_speed_ = self.joint2_max_speed
        if not 0.0 <= joint2_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_speed_ * 136713055.08345532 + 0.5
        joint2_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_speed_raw_ < 0.9999847412109375: joint2_max_speed_raw_ = rt.exact_raw(joint2_max_speed_, _R_5)
        joint2_max_acceleration_rate_ = self.joint2_max_acceleration_rate
        if not 0.0 <= joint2_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_acceleration_rate_ * 136713055.08345532 + 0.5
        joint2_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_acceleration_rate_raw_ < 0.9999847412109375: joint2_max_acceleration_rate_raw_ = rt.exact_raw(joint2_max_acceleration_rate_, _R_5)
        joint2_max_deceleration_rate_ = self.joint2_max_deceleration_rate
        if not 0.0 <= joint2_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_deceleration_rate_ * 136713055.08345532 + 0.5
        joint2_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_deceleration_rate_raw_ < 0.9999847412109375: joint2_max_deceleration_rate_raw_ = rt.exact_raw(joint2_max_deceleration_rate_, _R_5)
        return _S_H6I.pack(0x0627, joint1_max_speed_raw_, joint1_max_acceleration_rate_raw_, joint1_max_deceleration_rate_raw_, joint2_max_speed_raw_, joint2_max_acceleration_rate_raw_, joint2_max_deceleration_rate_raw_)


@dataclass(slots=True, repr=False, kw_only=True)
class ReportPanTiltSpecifications(rt.Message):
    """ReportPanTiltSpecifications (0x4620): Tells mounting and limits of the pan-tilt unit.

    pan_tilt_coordinate_sys_x: -30..30 meter, optional. Position of the unit on the vehicle along X, in metres
    pan_tilt_coordinate_sys_y: -30..30 meter, optional. Position of the unit on the vehicle along Y, in metres
    pan_tilt_coordinate_sys_z: -30..30 meter, optional. Position of the unit on the vehicle along Z, in metres
    d_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: real part
    a_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of i
    b_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of j
    c_component_of_unit_quaternion_q: -1..1, optional. Unit quaternion of the attitude: factor of k
    joint1_min_value: -25.1327412287..25.1327412287 radian. Smallest position of the pan joint, in radians
    joint1_max_value: -25.1327412287..25.1327412287 radian. Largest position of the pan joint, in radians
    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint2_min_value: -25.1327412287..25.1327412287 radian. Smallest position of the tilt joint, in radians
    joint2_max_value: -25.1327412287..25.1327412287 radian. Largest position of the tilt joint, in radians
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    """

    CODE = 0x4620
    NAME = "ReportPanTiltSpecifications"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    pan_tilt_coordinate_sys_x: float | None = None
    pan_tilt_coordinate_sys_y: float | None = None
    pan_tilt_coordinate_sys_z: float | None = None
    d_component_of_unit_quaternion_q: float | None = None
    a_component_of_unit_quaternion_q: float | None = None
    b_component_of_unit_quaternion_q: float | None = None
    c_component_of_unit_quaternion_q: float | None = None
    joint1_min_value: float
    joint1_max_value: float
    joint1_max_speed: float
    joint2_min_value: float
    joint2_max_value: float
    joint2_max_speed: float
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("PanTiltCoordinateSysX", rt.real("I", -30.0, 30.0, "meter"), True),
            ("PanTiltCoordinateSysY", rt.real("I", -30.0, 30.0, "meter"), True),
            ("PanTiltCoordinateSysZ", rt.real("I", -30.0, 30.0, "meter"), True),
            ("DComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0), True),
            ("AComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0), True),
            ("BComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0), True),
            ("CComponentOfUnitQuaternionQ", rt.real("I", -1.0, 1.0), True),
            ("Joint1MinValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint1MaxValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint1MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("Joint2MinValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint2MaxValue", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint2MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4620: raise rt.Reject
        raw = iter(_M_ReportPanTiltSpecifications[mask & 0x7F].unpack(data)).__next__
        self = rt.new(cls)
        self.pan_tilt_coordinate_sys_x = -30.0 + raw() * 1.3969838622484784e-08 if mask & 1 else None
        self.pan_tilt_coordinate_sys_y = -30.0 + raw() * 1.3969838622484784e-08 if mask & 2 else None
        self.pan_tilt_coordinate_sys_z = -30.0 + raw() * 1.3969838622484784e-08 if mask & 4 else None
        self.d_component_of_unit_quaternion_q = -1.0 + raw() * 4.656612874161595e-10 if mask & 8 else None
        self.a_component_of_unit_quaternion_q = -1.0 + raw() * 4.656612874161595e-10 if mask & 16 else None
        self.b_component_of_unit_quaternion_q = -1.0 + raw() * 4.656612874161595e-10 if mask & 32 else None
        self.c_component_of_unit_quaternion_q = -1.0 + raw() * 4.656612874161595e-10 if mask & 64 else None
        joint1_min_value_ = raw()
        self.joint1_min_value = -25.132741228718345 + joint1_min_value_ * 1.1703344636862174e-08
        joint1_max_value_ = raw()
        self.joint1_max_value = -25.132741228718345 + joint1_max_value_ * 1.1703344636862174e-08
        joint1_max_speed_ = raw()
        self.joint1_max_speed = joint1_max_speed_ * 7.314590398038859e-09
        joint2_min_value_ = raw()
        self.joint2_min_value = -25.132741228718345 + joint2_min_value_ * 1.1703344636862174e-08
        joint2_max_value_ = raw()
        self.joint2_max_value = -25.132741228718345 + joint2_max_value_ * 1.1703344636862174e-08
        joint2_max_speed_ = raw()
        self.joint2_max_speed = joint2_max_speed_ * 7.314590398038859e-09
        self.reserved_presence = mask & 0x80
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7F: raise rt.Reject
        raw: list[int | float | bytes] = []
        pan_tilt_coordinate_sys_x_ = self.pan_tilt_coordinate_sys_x
        if pan_tilt_coordinate_sys_x_ is not None:
            mask |= 1
            if not -30.0 <= pan_tilt_coordinate_sys_x_ <= 30.0: raise rt.Reject
            near = pan_tilt_coordinate_sys_x_ * 71582788.25 + 2147483648.0
            pan_tilt_coordinate_sys_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - pan_tilt_coordinate_sys_x_raw_ < 0.9999847412109375: pan_tilt_coordinate_sys_x_raw_ = rt.exact_raw(pan_tilt_coordinate_sys_x_, _R_7)
            raw.append(pan_tilt_coordinate_sys_x_raw_)
        pan_tilt_coordinate_sys_y_ = self.pan_tilt_coordinate_sys_y
        if pan_tilt_coordinate_sys_y_ is not None:
            mask |= 2
            if not -30.0 <= pan_tilt_coordinate_sys_y_ <= 30.0: raise rt.Reject
            near = pan_tilt_coordinate_sys_y_ * 71582788.25 + 2147483648.0
            pan_tilt_coordinate_sys_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - pan_tilt_coordinate_sys_y_raw_ < 0.9999847412109375: pan_tilt_coordinate_sys_y_raw_ = rt.exact_raw(pan_tilt_coordinate_sys_y_, _R_7)
            raw.append(pan_tilt_coordinate_sys_y_raw_)
        pan_tilt_coordinate_sys_z_ = self.pan_tilt_coordinate_sys_z
        if pan_tilt_coordinate_sys_z_ is not None:
            mask |= 4
            if not -30.0 <= pan_tilt_coordinate_sys_z_ <= 30.0: raise rt.Reject
            near = pan_tilt_coordinate_sys_z_ * 71582788.25 + 2147483648.0
            pan_tilt_coordinate_sys_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - pan_tilt_coordinate_sys_z_raw_ < 0.9999847412109375: pan_tilt_coordinate_sys_z_raw_ = rt.exact_raw(pan_tilt_coordinate_sys_z_, _R_7)
            raw.append(pan_tilt_coordinate_sys_z_raw_)
        d_component_of_unit_quaternion_q_ = self.d_component_of_unit_quaternion_q
        if d_component_of_unit_quaternion_q_ is not None:
            mask |= 8
            if not -1.0 <= d_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = d_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            d_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - d_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: d_component_of_unit_quaternion_q_raw_ = rt.exact_raw(d_component_of_unit_quaternion_q_, _R_8)
            raw.append(d_component_of_unit_quaternion_q_raw_)
        a_component_of_unit_quaternion_q_ = self.a_component_of_unit_quaternion_q
        if a_component_of_unit_quaternion_q_ is not None:
            mask |= 16
            if not -1.0 <= a_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = a_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            a_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - a_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: a_component_of_unit_quaternion_q_raw_ = rt.exact_raw(a_component_of_unit_quaternion_q_, _R_8)
            raw.append(a_component_of_unit_quaternion_q_raw_)
        b_component_of_unit_quaternion_q_ = self.b_component_of_unit_quaternion_q
        if b_component_of_unit_quaternion_q_ is not None:
            mask |= 32
            if not -1.0 <= b_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = b_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            b_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - b_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: b_component_of_unit_quaternion_q_raw_ = rt.exact_raw(b_component_of_unit_quaternion_q_, _R_8)
            raw.append(b_component_of_unit_quaternion_q_raw_)
        c_component_of_unit_quaternion_q_ = self.c_component_of_unit_quaternion_q
        if c_component_of_unit_quaternion_q_ is not None:
            mask |= 64
            if not -1.0 <= c_component_of_unit_quaternion_q_ <= 1.0: raise rt.Reject
            near = c_component_of_unit_quaternion_q_ * 2147483647.5 + 2147483648.0
            c_component_of_unit_quaternion_q_raw_ = int(near)
            if not 1.52587890625e-05 < near - c_component_of_unit_quaternion_q_raw_ < 0.9999847412109375: c_component_of_unit_quaternion_q_raw_ = rt.exact_raw(c_component_of_unit_quaternion_q_, _R_8)
            raw.append(c_component_of_unit_quaternion_q_raw_)
        joint1_min_value_ = self.joint1_min_value
        if not -25.132741228718345 <= joint1_min_value_ <= 25.132741228718345: raise rt.Reject
        near = joint1_min_value_ * 85445659.42715958 + 2147483647.9999998
        joint1_min_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_min_value_raw_ < 0.9999847412109375: joint1_min_value_raw_ = rt.exact_raw(joint1_min_value_, _R_3)
        raw.append(joint1_min_value_raw_)
        joint1_max_value_ = self.joint1_max_value
        if not -25.132741228718345 <= joint1_max_value_ <= 25.132741228718345: raise rt.Reject
        near = joint1_max_value_ * 85445659.42715958 + 2147483647.9999998
        joint1_max_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_value_raw_ < 0.9999847412109375: joint1_max_value_raw_ = rt.exact_raw(joint1_max_value_, _R_3)
        raw.append(joint1_max_value_raw_)
        joint1_max_speed_ = self.joint1_max_speed
        if not 0.0 <= joint1_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_speed_ * 136713055.08345532 + 0.5
        joint1_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_5)
        raw.append(joint1_max_speed_raw_)
        joint2_min_value_ = self.joint2_min_value
        if not -25.132741228718345 <= joint2_min_value_ <= 25.132741228718345: raise rt.Reject
        near = joint2_min_value_ * 85445659.42715958 + 2147483647.9999998
        joint2_min_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_min_value_raw_ < 0.9999847412109375: joint2_min_value_raw_ = rt.exact_raw(joint2_min_value_, _R_3)
        raw.append(joint2_min_value_raw_)
        joint2_max_value_ = self.joint2_max_value
        if not -25.132741228718345 <= joint2_max_value_ <= 25.132741228718345: raise rt.Reject
        near = joint2_max_value_ * 85445659.42715958 + 2147483647.9999998
        joint2_max_value_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_value_raw_ < 0.9999847412109375: joint2_max_value_raw_ = rt.exact_raw(joint2_max_value_, _R_3)
        raw.append(joint2_max_value_raw_)
        joint2_max_speed_ = self.joint2_max_speed
        if not 0.0 <= joint2_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_speed_ * 136713055.08345532 + 0.5
        joint2_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_speed_raw_ < 0.9999847412109375: joint2_max_speed_raw_ = rt.exact_raw(joint2_max_speed_, _R_5)
        raw.append(joint2_max_speed_raw_)
        return _M_ReportPanTiltSpecifications_pack[mask & 0x7F].pack(0x4620, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportCommandedPanTiltJointPositions(rt.Message):
    """ReportCommandedPanTiltJointPositions (0x4628): Tells the commanded angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """

    CODE = 0x4628
    NAME = "ReportCommandedPanTiltJointPositions"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    joint1_position: float
    joint2_position: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
            ("Joint2Position", rt.real("I", -25.132741228718345, 25.132741228718345, "radian")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_position_, joint2_position_ = _S_H2I.unpack(data)
        if code != 0x4628: raise rt.Reject
        self.joint1_position = -25.132741228718345 + joint1_position_ * 1.1703344636862174e-08
        self.joint2_position = -25.132741228718345 + joint2_position_ * 1.1703344636862174e-08
        return self

    def _pack(self) -> bytes:
        joint1_position_ = self.joint1_position
        if not -25.132741228718345 <= joint1_position_ <= 25.132741228718345: raise rt.Reject
        near = joint1_position_ * 85445659.42715958 + 2147483647.9999998
        joint1_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_position_raw_ < 0.9999847412109375: joint1_position_raw_ = rt.exact_raw(joint1_position_, _R_3)
        joint2_position_ = self.joint2_position
        if not -25.132741228718345 <= joint2_position_ <= 25.132741228718345: raise rt.Reject
        near = joint2_position_ * 85445659.42715958 + 2147483647.9999998
        joint2_position_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_position_raw_ < 0.9999847412109375: joint2_position_raw_ = rt.exact_raw(joint2_position_, _R_3)
        return _S_H2I.pack(0x4628, joint1_position_raw_, joint2_position_raw_)


@dataclass(slots=True, repr=False)
class ReportPanTiltMotionProfile(rt.Message):
    """ReportPanTiltMotionProfile (0x4627): Tells the limits of speed and acceleration.

    joint1_max_speed: 0..31.4159265359 radian per second. Largest speed of the pan joint, in radians per second
    joint1_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the pan joint, in radians per second squared
    joint1_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the pan joint, in radians per second squared
    joint2_max_speed: 0..31.4159265359 radian per second. Largest speed of the tilt joint, in radians per second
    joint2_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration of the tilt joint, in radians per second squared
    joint2_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration of the tilt joint, in radians per second squared
    """

    CODE = 0x4627
    NAME = "ReportPanTiltMotionProfile"
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    joint1_max_speed: float
    joint1_max_acceleration_rate: float
    joint1_max_deceleration_rate: float
    joint2_max_speed: float
    joint2_max_acceleration_rate: float
    joint2_max_deceleration_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Joint1MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("Joint1MaxAccelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint1MaxDecelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint2MaxSpeed", rt.real("I", 0.0, 31.41592653589793, "radian per second")),
            ("Joint2MaxAccelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
            ("Joint2MaxDecelerationRate", rt.real("I", 0.0, 31.41592653589793, "radian per second squared")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, joint1_max_speed_, joint1_max_acceleration_rate_, joint1_max_deceleration_rate_, joint2_max_speed_, joint2_max_acceleration_rate_, joint2_max_deceleration_rate_ = _S_H6I.unpack(data)
        if code != 0x4627: raise rt.Reject
        self.joint1_max_speed = joint1_max_speed_ * 7.314590398038859e-09
        self.joint1_max_acceleration_rate = joint1_max_acceleration_rate_ * 7.314590398038859e-09
        self.joint1_max_deceleration_rate = joint1_max_deceleration_rate_ * 7.314590398038859e-09
        self.joint2_max_speed = joint2_max_speed_ * 7.314590398038859e-09
        self.joint2_max_acceleration_rate = joint2_max_acceleration_rate_ * 7.314590398038859e-09
        self.joint2_max_deceleration_rate = joint2_max_deceleration_rate_ * 7.314590398038859e-09
        return self

    def _pack(self) -> bytes:
        joint1_max_speed_ = self.joint1_max_speed
        if not 0.0 <= joint1_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_speed_ * 136713055.08345532 + 0.5
        joint1_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_speed_raw_ < 0.9999847412109375: joint1_max_speed_raw_ = rt.exact_raw(joint1_max_speed_, _R_5)
        joint1_max_acceleration_rate_ = self.joint1_max_acceleration_rate
        if not 0.0 <= joint1_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_acceleration_rate_ * 136713055.08345532 + 0.5
        joint1_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_acceleration_rate_raw_ < 0.9999847412109375: joint1_max_acceleration_rate_raw_ = rt.exact_raw(joint1_max_acceleration_rate_, _R_5)
        joint1_max_deceleration_rate_ = self.joint1_max_deceleration_rate
        if not 0.0 <= joint1_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint1_max_deceleration_rate_ * 136713055.08345532 + 0.5
        joint1_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint1_max_deceleration_rate_raw_ < 0.9999847412109375: joint1_max_deceleration_rate_raw_ = rt.exact_raw(joint1_max_deceleration_rate_, _R_5)
        joint2_max_speed_ = self.joint2_max_speed
        if not 0.0 <= joint2_max_speed_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_speed_ * 136713055.08345532 + 0.5
        joint2_max_speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_speed_raw_ < 0.9999847412109375: joint2_max_speed_raw_ = rt.exact_raw(joint2_max_speed_, _R_5)
        joint2_max_acceleration_rate_ = self.joint2_max_acceleration_rate
        if not 0.0 <= joint2_max_acceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_acceleration_rate_ * 136713055.08345532 + 0.5
        joint2_max_acceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_acceleration_rate_raw_ < 0.9999847412109375: joint2_max_acceleration_rate_raw_ = rt.exact_raw(joint2_max_acceleration_rate_, _R_5)
        joint2_max_deceleration_rate_ = self.joint2_max_deceleration_rate
        if not 0.0 <= joint2_max_deceleration_rate_ <= 31.41592653589793: raise rt.Reject
        near = joint2_max_deceleration_rate_ * 136713055.08345532 + 0.5
        joint2_max_deceleration_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - joint2_max_deceleration_rate_raw_ < 0.9999847412109375: joint2_max_deceleration_rate_raw_ = rt.exact_raw(joint2_max_deceleration_rate_, _R_5)
        return _S_H6I.pack(0x4627, joint1_max_speed_raw_, joint1_max_acceleration_rate_raw_, joint1_max_deceleration_rate_raw_, joint2_max_speed_raw_, joint2_max_acceleration_rate_raw_, joint2_max_deceleration_rate_raw_)


_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_S_H2I = rt.Packer("<H2I")
_R_3 = rt.Scaling(-25.132741228718345, 25.132741228718345, 4294967295)
_S_H6I = rt.Packer("<H6I")
_R_5 = rt.Scaling(0.0, 31.41592653589793, 4294967295)
_M_ReportPanTiltSpecifications = rt.Masks("3x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I")))
_R_7 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_8 = rt.Scaling(-1.0, 1.0, 4294967295)
_M_ReportPanTiltSpecifications_pack = rt.Masks("HB", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I"), (0, "I")))
QueryPanTiltSpecifications.REPORT = ReportPanTiltSpecifications
QueryCommandedPanTiltJointPositions.REPORT = ReportCommandedPanTiltJointPositions
QueryPanTiltMotionProfile.REPORT = ReportPanTiltMotionProfile
