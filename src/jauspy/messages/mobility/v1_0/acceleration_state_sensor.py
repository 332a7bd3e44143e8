"""urn:jaus:jss:mobility:AccelerationStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class QueryAccelerationState(rt.Message):
    """QueryAccelerationState (0x2417): Asks for the acceleration.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2417
    NAME = "QueryAccelerationState"
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAccelerationState]]

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector = _S_2H.unpack(data)
        if code != 0x2417: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2417, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportAccelerationState(rt.Message):
    """ReportAccelerationState (0x4417): Tells the acceleration.

    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..3.14159265359 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_stamp: optional. Time within the month, in UTC
    """

    CODE = 0x4417
    NAME = "ReportAccelerationState"
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    acceleration_x: float | None = None
    acceleration_y: float | None = None
    acceleration_z: float | None = None
    acceleration_rms: float | None = None
    roll_acceleration: float | None = None
    pitch_acceleration: float | None = None
    yaw_acceleration: float | None = None
    rotational_acceleration_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Acceleration_X", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Y", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Z", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_RMS", rt.real("I", 0.0, 100.0, "meter per second squared"), True),
            ("RollAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("PitchAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("YawAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("RotationalAcceleration_RMS", rt.real("H", 0.0, 3.141592653589793, "radian per second squared"), True),
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4417: raise rt.Reject
        raw = iter(_M_ReportAccelerationState[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
        self.acceleration_x = -1310.68 + raw() * 6.103329361906119e-07 if mask & 1 else None
        self.acceleration_y = -1310.68 + raw() * 6.103329361906119e-07 if mask & 2 else None
        self.acceleration_z = -1310.68 + raw() * 6.103329361906119e-07 if mask & 4 else None
        self.acceleration_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 16 else None
        self.pitch_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 32 else None
        self.yaw_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 64 else None
        self.rotational_acceleration_rms = raw() * 4.793763109162727e-05 if mask & 128 else None
        if mask & 256:
            time_stamp_ = raw()
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.time_stamp = core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_)
        else: self.time_stamp = None
        self.reserved_presence = mask & 0xFE00
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        acceleration_x_ = self.acceleration_x
        if acceleration_x_ is not None:
            mask |= 1
            if not -1310.68 <= acceleration_x_ <= 1310.68: raise rt.Reject
            near = acceleration_x_ * 1638450.001144444 + 2147483648.0
            acceleration_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_x_raw_ < 0.9999847412109375: acceleration_x_raw_ = rt.exact_raw(acceleration_x_, _R_2)
            raw.append(acceleration_x_raw_)
        acceleration_y_ = self.acceleration_y
        if acceleration_y_ is not None:
            mask |= 2
            if not -1310.68 <= acceleration_y_ <= 1310.68: raise rt.Reject
            near = acceleration_y_ * 1638450.001144444 + 2147483648.0
            acceleration_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_y_raw_ < 0.9999847412109375: acceleration_y_raw_ = rt.exact_raw(acceleration_y_, _R_2)
            raw.append(acceleration_y_raw_)
        acceleration_z_ = self.acceleration_z
        if acceleration_z_ is not None:
            mask |= 4
            if not -1310.68 <= acceleration_z_ <= 1310.68: raise rt.Reject
            near = acceleration_z_ * 1638450.001144444 + 2147483648.0
            acceleration_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_z_raw_ < 0.9999847412109375: acceleration_z_raw_ = rt.exact_raw(acceleration_z_, _R_2)
            raw.append(acceleration_z_raw_)
        acceleration_rms_ = self.acceleration_rms
        if acceleration_rms_ is not None:
            mask |= 8
            if not 0.0 <= acceleration_rms_ <= 100.0: raise rt.Reject
            near = acceleration_rms_ * 42949672.95 + 0.5
            acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_rms_raw_ < 0.9999847412109375: acceleration_rms_raw_ = rt.exact_raw(acceleration_rms_, _R_3)
            raw.append(acceleration_rms_raw_)
        roll_acceleration_ = self.roll_acceleration
        if roll_acceleration_ is not None:
            mask |= 16
            if not -13106.8 <= roll_acceleration_ <= 13106.8: raise rt.Reject
            near = roll_acceleration_ * 163845.0001144444 + 2147483647.9999998
            roll_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_acceleration_raw_ < 0.9999847412109375: roll_acceleration_raw_ = rt.exact_raw(roll_acceleration_, _R_4)
            raw.append(roll_acceleration_raw_)
        pitch_acceleration_ = self.pitch_acceleration
        if pitch_acceleration_ is not None:
            mask |= 32
            if not -13106.8 <= pitch_acceleration_ <= 13106.8: raise rt.Reject
            near = pitch_acceleration_ * 163845.0001144444 + 2147483647.9999998
            pitch_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_acceleration_raw_ < 0.9999847412109375: pitch_acceleration_raw_ = rt.exact_raw(pitch_acceleration_, _R_4)
            raw.append(pitch_acceleration_raw_)
        yaw_acceleration_ = self.yaw_acceleration
        if yaw_acceleration_ is not None:
            mask |= 64
            if not -13106.8 <= yaw_acceleration_ <= 13106.8: raise rt.Reject
            near = yaw_acceleration_ * 163845.0001144444 + 2147483647.9999998
            yaw_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_acceleration_raw_ < 0.9999847412109375: yaw_acceleration_raw_ = rt.exact_raw(yaw_acceleration_, _R_4)
            raw.append(yaw_acceleration_raw_)
        rotational_acceleration_rms_ = self.rotational_acceleration_rms
        if rotational_acceleration_rms_ is not None:
            mask |= 128
            if not 0.0 <= rotational_acceleration_rms_ <= 3.141592653589793: raise rt.Reject
            near = rotational_acceleration_rms_ * 20860.438391054722 + 0.5
            rotational_acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rotational_acceleration_rms_raw_ < 0.9999847412109375: rotational_acceleration_rms_raw_ = rt.exact_raw(rotational_acceleration_rms_, _R_5)
            raw.append(rotational_acceleration_rms_raw_)
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 256
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            raw.append(milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
        return _M_ReportAccelerationState_pack[mask & 0x1FF].pack(0x4417, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_ReportAccelerationState = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-1310.68, 1310.68, 4294967295)
_R_3 = rt.Scaling(0.0, 100.0, 4294967295)
_R_4 = rt.Scaling(-13106.8, 13106.8, 4294967295)
_R_5 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_ReportAccelerationState_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "H"), (256, "I")))
QueryAccelerationState.REPORT = ReportAccelerationState
