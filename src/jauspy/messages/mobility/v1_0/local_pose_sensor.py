"""urn:jaus:jss:mobility:LocalPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class SetLocalPose(rt.Message):
    """SetLocalPose (0x0403): Sets the pose that the sensor is to assume as the present one.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time of the measurement
    """

    CODE = 0x0403
    NAME = "SetLocalPose"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    x: float | None = None
    y: float | None = None
    z: float | None = None
    position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    attitude_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("X", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Y", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Z", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Position_RMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x0403: raise rt.Reject
        raw = iter(_M_SetLocalPose[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
        self.x = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
        self.y = -100000.0 + raw() * 4.656612874161595e-05 if mask & 2 else None
        self.z = -100000.0 + raw() * 4.656612874161595e-05 if mask & 4 else None
        self.position_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        self.yaw = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 128 else None
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
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
            near = x_ * 21474.836475 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_2)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
            near = y_ * 21474.836475 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_2)
            raw.append(y_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 4
            if not -100000.0 <= z_ <= 100000.0: raise rt.Reject
            near = z_ * 21474.836475 + 2147483648.0
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_2)
            raw.append(z_raw_)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0: raise rt.Reject
            near = position_rms_ * 42949672.95 + 0.5
            position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_rms_raw_ < 0.9999847412109375: position_rms_raw_ = rt.exact_raw(position_rms_, _R_3)
            raw.append(position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_4)
            raw.append(yaw_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw_)
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
        return _M_SetLocalPose_pack[mask & 0x1FF].pack(0x0403, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryLocalPose(rt.Message):
    """QueryLocalPose (0x2403): Asks for the pose.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2403
    NAME = "QueryLocalPose"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalPose]]

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
        if code != 0x2403: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2403, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportLocalPose(rt.Message):
    """ReportLocalPose (0x4403): Tells the pose.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time of the measurement
    """

    CODE = 0x4403
    NAME = "ReportLocalPose"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    x: float | None = None
    y: float | None = None
    z: float | None = None
    position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    attitude_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("X", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Y", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Z", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Position_RMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4403: raise rt.Reject
        raw = iter(_M_SetLocalPose[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
        self.x = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
        self.y = -100000.0 + raw() * 4.656612874161595e-05 if mask & 2 else None
        self.z = -100000.0 + raw() * 4.656612874161595e-05 if mask & 4 else None
        self.position_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        self.yaw = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 128 else None
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
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
            near = x_ * 21474.836475 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_2)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
            near = y_ * 21474.836475 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_2)
            raw.append(y_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 4
            if not -100000.0 <= z_ <= 100000.0: raise rt.Reject
            near = z_ * 21474.836475 + 2147483648.0
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_2)
            raw.append(z_raw_)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0: raise rt.Reject
            near = position_rms_ * 42949672.95 + 0.5
            position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_rms_raw_ < 0.9999847412109375: position_rms_raw_ = rt.exact_raw(position_rms_, _R_3)
            raw.append(position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_4)
            raw.append(yaw_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw_)
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
        return _M_SetLocalPose_pack[mask & 0x1FF].pack(0x4403, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_SetLocalPose = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_R_3 = rt.Scaling(0.0, 100.0, 4294967295)
_R_4 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_5 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_SetLocalPose_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
QueryLocalPose.REPORT = ReportLocalPose
