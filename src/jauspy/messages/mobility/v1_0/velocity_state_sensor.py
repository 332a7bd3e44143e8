"""urn:jaus:jss:mobility:VelocityStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class QueryVelocityState(rt.Message):
    """QueryVelocityState (0x2404): Asks for the velocity.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2404
    NAME = "QueryVelocityState"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVelocityState]]

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
        if code != 0x2404: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2404, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportVelocityState(rt.Message):
    """ReportVelocityState (0x4404): Tells the velocity.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..3.14159265359 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    time_stamp: optional. Time within the month, in UTC
    """

    CODE = 0x4404
    NAME = "ReportVelocityState"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    velocity_rms: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    rate_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_RMS", rt.real("I", 0.0, 100.0, "meter per second"), True),
            ("RollRate", rt.real("H", -32.768, 32.767, "radian per second"), True),
            ("PitchRate", rt.real("H", -32.768, 32.767, "radian per second"), True),
            ("YawRate", rt.real("H", -32.768, 32.767, "radian per second"), True),
            ("Rate_RMS", rt.real("H", 0.0, 3.141592653589793, "radian per second"), True),
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4404: raise rt.Reject
        raw = iter(_M_ReportVelocityState[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.velocity_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        if mask & 16:
            roll_rate_ = raw()
            self.roll_rate = 32.767 if roll_rate_ == 65535 else -32.768 + roll_rate_ * 0.001
        else: self.roll_rate = None
        if mask & 32:
            pitch_rate_ = raw()
            self.pitch_rate = 32.767 if pitch_rate_ == 65535 else -32.768 + pitch_rate_ * 0.001
        else: self.pitch_rate = None
        if mask & 64:
            yaw_rate_ = raw()
            self.yaw_rate = 32.767 if yaw_rate_ == 65535 else -32.768 + yaw_rate_ * 0.001
        else: self.yaw_rate = None
        self.rate_rms = raw() * 4.793763109162727e-05 if mask & 128 else None
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
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_2)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_2)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_2)
            raw.append(velocity_z_raw_)
        velocity_rms_ = self.velocity_rms
        if velocity_rms_ is not None:
            mask |= 8
            if not 0.0 <= velocity_rms_ <= 100.0: raise rt.Reject
            near = velocity_rms_ * 42949672.95 + 0.5
            velocity_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_rms_raw_ < 0.9999847412109375: velocity_rms_raw_ = rt.exact_raw(velocity_rms_, _R_3)
            raw.append(velocity_rms_raw_)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 16
            if not -32.768 <= roll_rate_ <= 32.767: raise rt.Reject
            near = roll_rate_ * 1000.0 + 32768.5
            roll_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_rate_raw_ < 0.9999847412109375: roll_rate_raw_ = rt.exact_raw(roll_rate_, _R_4)
            raw.append(roll_rate_raw_)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 32
            if not -32.768 <= pitch_rate_ <= 32.767: raise rt.Reject
            near = pitch_rate_ * 1000.0 + 32768.5
            pitch_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_rate_raw_ < 0.9999847412109375: pitch_rate_raw_ = rt.exact_raw(pitch_rate_, _R_4)
            raw.append(pitch_rate_raw_)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 64
            if not -32.768 <= yaw_rate_ <= 32.767: raise rt.Reject
            near = yaw_rate_ * 1000.0 + 32768.5
            yaw_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_rate_raw_ < 0.9999847412109375: yaw_rate_raw_ = rt.exact_raw(yaw_rate_, _R_4)
            raw.append(yaw_rate_raw_)
        rate_rms_ = self.rate_rms
        if rate_rms_ is not None:
            mask |= 128
            if not 0.0 <= rate_rms_ <= 3.141592653589793: raise rt.Reject
            near = rate_rms_ * 20860.438391054722 + 0.5
            rate_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rate_rms_raw_ < 0.9999847412109375: rate_rms_raw_ = rt.exact_raw(rate_rms_, _R_5)
            raw.append(rate_rms_raw_)
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
        return _M_ReportVelocityState_pack[mask & 0x1FF].pack(0x4404, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_ReportVelocityState = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-327.68, 327.67, 4294967295)
_R_3 = rt.Scaling(0.0, 100.0, 4294967295)
_R_4 = rt.Scaling(-32.768, 32.767, 65535)
_R_5 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_ReportVelocityState_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
QueryVelocityState.REPORT = ReportVelocityState
