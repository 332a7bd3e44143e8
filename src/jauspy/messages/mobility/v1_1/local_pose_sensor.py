"""urn:jaus:jss:mobility:LocalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


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
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x0403
    NAME: ClassVar[str] = "SetLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

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
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z", "Z", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("position_rms", "Position_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("yaw", "Yaw", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x0403:
            raise rt.Reject
        raw = iter(_M_SetLocalPose[mask & 0x1FF].unpack(data)).__next__
        x_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
        y_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 2 else None
        z_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 4 else None
        position_rms_ = raw() * 2.3283064370807974e-08 if mask & 8 else None
        roll_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        pitch_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        yaw_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        attitude_rms_ = raw() * 4.793763109162727e-05 if mask & 128 else None
        if mask & 256:
            time_stamp_ = raw()
            part = time_stamp_ & 0x3FF
            if part > 999:
                raise rt.Reject
            part = time_stamp_ >> 10 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 16 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 22 & 0x1F
            if part > 23:
                raise rt.Reject
            part = time_stamp_ >> 27 & 0x1F
            if part < 1:
                raise rt.Reject
            time_stamp_ = core_v1_0_types.TimeStamp(time_stamp_ & 0x3FF, time_stamp_ >> 10 & 0x3F, time_stamp_ >> 16 & 0x3F, time_stamp_ >> 22 & 0x1F, time_stamp_ >> 27 & 0x1F)
        else:
            time_stamp_ = None
        return cls(x_, y_, z_, position_rms_, roll_, pitch_, yaw_, attitude_rms_, time_stamp_, mask & 0xFE00)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1FF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -100000.0 <= x_ <= 100000.0:
                raise rt.Reject
            x_pos = (x_ + 100000.0) * 21474.836475 + 0.5
            x_raw = int(x_pos)
            if not 1.52587890625e-05 < x_pos - x_raw < 0.9999847412109375:
                x_raw = rt.exact_raw(x_, _R_2)
            raw.append(x_raw)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -100000.0 <= y_ <= 100000.0:
                raise rt.Reject
            y_pos = (y_ + 100000.0) * 21474.836475 + 0.5
            y_raw = int(y_pos)
            if not 1.52587890625e-05 < y_pos - y_raw < 0.9999847412109375:
                y_raw = rt.exact_raw(y_, _R_2)
            raw.append(y_raw)
        z_ = self.z
        if z_ is not None:
            mask |= 4
            if not -100000.0 <= z_ <= 100000.0:
                raise rt.Reject
            z_pos = (z_ + 100000.0) * 21474.836475 + 0.5
            z_raw = int(z_pos)
            if not 1.52587890625e-05 < z_pos - z_raw < 0.9999847412109375:
                z_raw = rt.exact_raw(z_, _R_2)
            raw.append(z_raw)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0:
                raise rt.Reject
            position_rms_pos = position_rms_ * 42949672.95 + 0.5
            position_rms_raw = int(position_rms_pos)
            if not 1.52587890625e-05 < position_rms_pos - position_rms_raw < 0.9999847412109375:
                position_rms_raw = rt.exact_raw(position_rms_, _R_3)
            raw.append(position_rms_raw)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793:
                raise rt.Reject
            roll_pos = (roll_ + 3.141592653589793) * 10430.219195527361 + 0.5
            roll_raw = int(roll_pos)
            if not 1.52587890625e-05 < roll_pos - roll_raw < 0.9999847412109375:
                roll_raw = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793:
                raise rt.Reject
            pitch_pos = (pitch_ + 3.141592653589793) * 10430.219195527361 + 0.5
            pitch_raw = int(pitch_pos)
            if not 1.52587890625e-05 < pitch_pos - pitch_raw < 0.9999847412109375:
                pitch_raw = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793:
                raise rt.Reject
            yaw_pos = (yaw_ + 3.141592653589793) * 10430.219195527361 + 0.5
            yaw_raw = int(yaw_pos)
            if not 1.52587890625e-05 < yaw_pos - yaw_raw < 0.9999847412109375:
                yaw_raw = rt.exact_raw(yaw_, _R_4)
            raw.append(yaw_raw)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793:
                raise rt.Reject
            attitude_rms_pos = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw = int(attitude_rms_pos)
            if not 1.52587890625e-05 < attitude_rms_pos - attitude_rms_raw < 0.9999847412109375:
                attitude_rms_raw = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw)
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 256
            if type(time_stamp_) is not core_v1_0_types.TimeStamp:
                raise rt.Reject
            time_stamp_milliseconds_ = time_stamp_.milliseconds
            if not 0 <= time_stamp_milliseconds_ <= 999:
                raise rt.Reject
            time_stamp_seconds_ = time_stamp_.seconds
            if not 0 <= time_stamp_seconds_ <= 59:
                raise rt.Reject
            time_stamp_minutes_ = time_stamp_.minutes
            if not 0 <= time_stamp_minutes_ <= 59:
                raise rt.Reject
            time_stamp_hour_ = time_stamp_.hour
            if not 0 <= time_stamp_hour_ <= 23:
                raise rt.Reject
            time_stamp_day_ = time_stamp_.day
            if not 1 <= time_stamp_day_ <= 31:
                raise rt.Reject
            raw.append(time_stamp_milliseconds_ | time_stamp_seconds_ << 10 | time_stamp_minutes_ << 16 | time_stamp_hour_ << 22 | time_stamp_day_ << 27)
        return _M_SetLocalPose_pack[mask & 0x1FF].pack(0x0403, mask, *raw)


@dataclass(slots=True, repr=False)
class SetLocalPoseExt(rt.Message):
    """SetLocalPoseExt (0x04A3): Sets the present pose, with a wider range and a choice of the vertical datum.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    z_position: optional. Vertical position and its datum
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE: ClassVar[int] = 0x04A3
    NAME: ClassVar[str] = "SetLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    ZPosition = mobility_v1_0_types.ZPosition

    x: float | None = None
    y: float | None = None
    z_position: mobility_v1_0_types.ZPosition | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position", "ZPosition", mobility_v1_0_types.ZPosition.layout(), optional=True),
                rt.Slot("xy_position_rms", "XYPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position_rms", "ZPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("heading", "Heading", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_seconds", "TimeSeconds", rt.Number("I", rt.ANY, "second"), optional=True),
                rt.Slot("time_nano_seconds", "TimeNanoSeconds", rt.Number("I"), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xA3 or data[1] != 0x04:
            raise rt.Reject
        at = 2
        (mask,) = _S_H.unpack_from(data, at)
        at += 2
        packer = _M_SetLocalPoseExt_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        x_ = -20000000.0 + raw() * 0.00931322574832319 if mask & 1 else None
        y_ = -20000000.0 + raw() * 0.00931322574832319 if mask & 2 else None
        z_position_: mobility_v1_0_types.ZPosition | None = None
        if mask & 4:
            z_position_, at = mobility_v1_0_types.ZPosition._read(data, at, depth)
        packer = _M_SetLocalPoseExt_2[mask & 0x7F8]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        xy_position_rms_ = raw() * 2.3283064370807974e-08 if mask & 8 else None
        z_position_rms_ = raw() * 2.3283064370807974e-08 if mask & 16 else None
        roll_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        pitch_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        heading_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 128 else None
        attitude_rms_ = raw() * 4.793763109162727e-05 if mask & 256 else None
        time_seconds_ = raw() if mask & 512 else None
        time_nano_seconds_ = raw() if mask & 1024 else None
        if at != len(data):
            raise rt.Reject
        return cls(x_, y_, z_position_, xy_position_rms_, z_position_rms_, roll_, pitch_, heading_, attitude_rms_, time_seconds_, time_nano_seconds_, mask & 0xF800)

    def _pack(self) -> bytes:
        out = bytearray(b"\xa3\x04")
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -20000000.0 <= x_ <= 20000000.0:
                raise rt.Reject
            x_pos = (x_ + 20000000.0) * 107.374182375 + 0.5
            x_raw = int(x_pos)
            if not 1.52587890625e-05 < x_pos - x_raw < 0.9999847412109375:
                x_raw = rt.exact_raw(x_, _R_10)
            raw.append(x_raw)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -20000000.0 <= y_ <= 20000000.0:
                raise rt.Reject
            y_pos = (y_ + 20000000.0) * 107.374182375 + 0.5
            y_raw = int(y_pos)
            if not 1.52587890625e-05 < y_pos - y_raw < 0.9999847412109375:
                y_raw = rt.exact_raw(y_, _R_10)
            raw.append(y_raw)
        out += _M_SetLocalPoseExt_0[mask & 0x3].pack(*raw)
        z_position_ = self.z_position
        if z_position_ is not None:
            mask |= 4
            if type(z_position_) is not mobility_v1_0_types.ZPosition:
                raise rt.Reject
            z_position_._write(out)
        raw = []
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 8
            if not 0.0 <= xy_position_rms_ <= 100.0:
                raise rt.Reject
            xy_position_rms_pos = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw = int(xy_position_rms_pos)
            if not 1.52587890625e-05 < xy_position_rms_pos - xy_position_rms_raw < 0.9999847412109375:
                xy_position_rms_raw = rt.exact_raw(xy_position_rms_, _R_3)
            raw.append(xy_position_rms_raw)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 16
            if not 0.0 <= z_position_rms_ <= 100.0:
                raise rt.Reject
            z_position_rms_pos = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw = int(z_position_rms_pos)
            if not 1.52587890625e-05 < z_position_rms_pos - z_position_rms_raw < 0.9999847412109375:
                z_position_rms_raw = rt.exact_raw(z_position_rms_, _R_3)
            raw.append(z_position_rms_raw)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 32
            if not -3.141592653589793 <= roll_ <= 3.141592653589793:
                raise rt.Reject
            roll_pos = (roll_ + 3.141592653589793) * 10430.219195527361 + 0.5
            roll_raw = int(roll_pos)
            if not 1.52587890625e-05 < roll_pos - roll_raw < 0.9999847412109375:
                roll_raw = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 64
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793:
                raise rt.Reject
            pitch_pos = (pitch_ + 3.141592653589793) * 10430.219195527361 + 0.5
            pitch_raw = int(pitch_pos)
            if not 1.52587890625e-05 < pitch_pos - pitch_raw < 0.9999847412109375:
                pitch_raw = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 128
            if not -3.141592653589793 <= heading_ <= 3.141592653589793:
                raise rt.Reject
            heading_pos = (heading_ + 3.141592653589793) * 10430.219195527361 + 0.5
            heading_raw = int(heading_pos)
            if not 1.52587890625e-05 < heading_pos - heading_raw < 0.9999847412109375:
                heading_raw = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 256
            if not 0.0 <= attitude_rms_ <= 3.141592653589793:
                raise rt.Reject
            attitude_rms_pos = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw = int(attitude_rms_pos)
            if not 1.52587890625e-05 < attitude_rms_pos - attitude_rms_raw < 0.9999847412109375:
                attitude_rms_raw = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 512
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 1024
            raw.append(time_nano_seconds_)
        out += _M_SetLocalPoseExt_2[mask & 0x7F8].pack(*raw)
        _S_H.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryLocalPose(rt.Message):
    """QueryLocalPose (0x2403): Asks for the pose.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2403
    NAME: ClassVar[str] = "QueryLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("presence_vector", "PresenceVector", rt.Number("H")),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, presence_vector_ = _S_2H.unpack(data)
        if code != 0x2403:
            raise rt.Reject
        return cls(presence_vector_)

    def _pack(self) -> bytes:
        presence_vector_ = self.presence_vector
        return _S_2H.pack(0x2403, presence_vector_)


@dataclass(slots=True, repr=False)
class QueryLocalPoseExt(rt.Message):
    """QueryLocalPoseExt (0x24A3): Asks for the pose in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x24A3
    NAME: ClassVar[str] = "QueryLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("presence_vector", "PresenceVector", rt.Number("H")),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, presence_vector_ = _S_2H.unpack(data)
        if code != 0x24A3:
            raise rt.Reject
        return cls(presence_vector_)

    def _pack(self) -> bytes:
        presence_vector_ = self.presence_vector
        return _S_2H.pack(0x24A3, presence_vector_)


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
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x4403
    NAME: ClassVar[str] = "ReportLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z", "Z", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("position_rms", "Position_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("yaw", "Yaw", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4403:
            raise rt.Reject
        raw = iter(_M_SetLocalPose[mask & 0x1FF].unpack(data)).__next__
        x_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
        y_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 2 else None
        z_ = -100000.0 + raw() * 4.656612874161595e-05 if mask & 4 else None
        position_rms_ = raw() * 2.3283064370807974e-08 if mask & 8 else None
        roll_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        pitch_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        yaw_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        attitude_rms_ = raw() * 4.793763109162727e-05 if mask & 128 else None
        if mask & 256:
            time_stamp_ = raw()
            part = time_stamp_ & 0x3FF
            if part > 999:
                raise rt.Reject
            part = time_stamp_ >> 10 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 16 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 22 & 0x1F
            if part > 23:
                raise rt.Reject
            part = time_stamp_ >> 27 & 0x1F
            if part < 1:
                raise rt.Reject
            time_stamp_ = core_v1_0_types.TimeStamp(time_stamp_ & 0x3FF, time_stamp_ >> 10 & 0x3F, time_stamp_ >> 16 & 0x3F, time_stamp_ >> 22 & 0x1F, time_stamp_ >> 27 & 0x1F)
        else:
            time_stamp_ = None
        return cls(x_, y_, z_, position_rms_, roll_, pitch_, yaw_, attitude_rms_, time_stamp_, mask & 0xFE00)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1FF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -100000.0 <= x_ <= 100000.0:
                raise rt.Reject
            x_pos = (x_ + 100000.0) * 21474.836475 + 0.5
            x_raw = int(x_pos)
            if not 1.52587890625e-05 < x_pos - x_raw < 0.9999847412109375:
                x_raw = rt.exact_raw(x_, _R_2)
            raw.append(x_raw)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -100000.0 <= y_ <= 100000.0:
                raise rt.Reject
            y_pos = (y_ + 100000.0) * 21474.836475 + 0.5
            y_raw = int(y_pos)
            if not 1.52587890625e-05 < y_pos - y_raw < 0.9999847412109375:
                y_raw = rt.exact_raw(y_, _R_2)
            raw.append(y_raw)
        z_ = self.z
        if z_ is not None:
            mask |= 4
            if not -100000.0 <= z_ <= 100000.0:
                raise rt.Reject
            z_pos = (z_ + 100000.0) * 21474.836475 + 0.5
            z_raw = int(z_pos)
            if not 1.52587890625e-05 < z_pos - z_raw < 0.9999847412109375:
                z_raw = rt.exact_raw(z_, _R_2)
            raw.append(z_raw)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0:
                raise rt.Reject
            position_rms_pos = position_rms_ * 42949672.95 + 0.5
            position_rms_raw = int(position_rms_pos)
            if not 1.52587890625e-05 < position_rms_pos - position_rms_raw < 0.9999847412109375:
                position_rms_raw = rt.exact_raw(position_rms_, _R_3)
            raw.append(position_rms_raw)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793:
                raise rt.Reject
            roll_pos = (roll_ + 3.141592653589793) * 10430.219195527361 + 0.5
            roll_raw = int(roll_pos)
            if not 1.52587890625e-05 < roll_pos - roll_raw < 0.9999847412109375:
                roll_raw = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793:
                raise rt.Reject
            pitch_pos = (pitch_ + 3.141592653589793) * 10430.219195527361 + 0.5
            pitch_raw = int(pitch_pos)
            if not 1.52587890625e-05 < pitch_pos - pitch_raw < 0.9999847412109375:
                pitch_raw = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793:
                raise rt.Reject
            yaw_pos = (yaw_ + 3.141592653589793) * 10430.219195527361 + 0.5
            yaw_raw = int(yaw_pos)
            if not 1.52587890625e-05 < yaw_pos - yaw_raw < 0.9999847412109375:
                yaw_raw = rt.exact_raw(yaw_, _R_4)
            raw.append(yaw_raw)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793:
                raise rt.Reject
            attitude_rms_pos = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw = int(attitude_rms_pos)
            if not 1.52587890625e-05 < attitude_rms_pos - attitude_rms_raw < 0.9999847412109375:
                attitude_rms_raw = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw)
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 256
            if type(time_stamp_) is not core_v1_0_types.TimeStamp:
                raise rt.Reject
            time_stamp_milliseconds_ = time_stamp_.milliseconds
            if not 0 <= time_stamp_milliseconds_ <= 999:
                raise rt.Reject
            time_stamp_seconds_ = time_stamp_.seconds
            if not 0 <= time_stamp_seconds_ <= 59:
                raise rt.Reject
            time_stamp_minutes_ = time_stamp_.minutes
            if not 0 <= time_stamp_minutes_ <= 59:
                raise rt.Reject
            time_stamp_hour_ = time_stamp_.hour
            if not 0 <= time_stamp_hour_ <= 23:
                raise rt.Reject
            time_stamp_day_ = time_stamp_.day
            if not 1 <= time_stamp_day_ <= 31:
                raise rt.Reject
            raw.append(time_stamp_milliseconds_ | time_stamp_seconds_ << 10 | time_stamp_minutes_ << 16 | time_stamp_hour_ << 22 | time_stamp_day_ << 27)
        return _M_SetLocalPose_pack[mask & 0x1FF].pack(0x4403, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportLocalPoseExt(rt.Message):
    """ReportLocalPoseExt (0x44A3): Tells the pose, with a wider range and several vertical datums.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    z_local: -50000..50000 meter, optional. Position along Z of the local frame, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is along X
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE: ClassVar[int] = 0x44A3
    NAME: ClassVar[str] = "ReportLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    x: float | None = None
    y: float | None = None
    altitude_agl: float | None = None
    altitude_msl: float | None = None
    altitude_asf: float | None = None
    depth: float | None = None
    z_local: float | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    course: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_agl", "AltitudeAGL", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_msl", "AltitudeMSL", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_asf", "AltitudeASF", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("depth", "Depth", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_local", "ZLocal", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("xy_position_rms", "XYPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position_rms", "ZPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("heading", "Heading", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("course", "Course", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_seconds", "TimeSeconds", rt.Number("I", rt.ANY, "second"), optional=True),
                rt.Slot("time_nano_seconds", "TimeNanoSeconds", rt.Number("I"), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x44A3:
            raise rt.Reject
        raw = iter(_M_ReportLocalPoseExt[mask & 0xFFFF].unpack(data)).__next__
        x_ = -20000000.0 + raw() * 0.00931322574832319 if mask & 1 else None
        y_ = -20000000.0 + raw() * 0.00931322574832319 if mask & 2 else None
        altitude_agl_ = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 4 else None
        altitude_msl_ = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 8 else None
        altitude_asf_ = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 16 else None
        depth_ = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 32 else None
        z_local_ = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 64 else None
        xy_position_rms_ = raw() * 2.3283064370807974e-08 if mask & 128 else None
        z_position_rms_ = raw() * 2.3283064370807974e-08 if mask & 256 else None
        roll_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 512 else None
        pitch_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
        heading_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2048 else None
        attitude_rms_ = raw() * 4.793763109162727e-05 if mask & 4096 else None
        course_ = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8192 else None
        time_seconds_ = raw() if mask & 16384 else None
        time_nano_seconds_ = raw() if mask & 32768 else None
        return cls(x_, y_, altitude_agl_, altitude_msl_, altitude_asf_, depth_, z_local_, xy_position_rms_, z_position_rms_, roll_, pitch_, heading_, attitude_rms_, course_, time_seconds_, time_nano_seconds_)

    def _pack(self) -> bytes:
        mask = 0
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -20000000.0 <= x_ <= 20000000.0:
                raise rt.Reject
            x_pos = (x_ + 20000000.0) * 107.374182375 + 0.5
            x_raw = int(x_pos)
            if not 1.52587890625e-05 < x_pos - x_raw < 0.9999847412109375:
                x_raw = rt.exact_raw(x_, _R_10)
            raw.append(x_raw)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -20000000.0 <= y_ <= 20000000.0:
                raise rt.Reject
            y_pos = (y_ + 20000000.0) * 107.374182375 + 0.5
            y_raw = int(y_pos)
            if not 1.52587890625e-05 < y_pos - y_raw < 0.9999847412109375:
                y_raw = rt.exact_raw(y_, _R_10)
            raw.append(y_raw)
        altitude_agl_ = self.altitude_agl
        if altitude_agl_ is not None:
            mask |= 4
            if not -50000.0 <= altitude_agl_ <= 50000.0:
                raise rt.Reject
            altitude_agl_pos = (altitude_agl_ + 50000.0) * 42949.67295 + 0.5
            altitude_agl_raw = int(altitude_agl_pos)
            if not 1.52587890625e-05 < altitude_agl_pos - altitude_agl_raw < 0.9999847412109375:
                altitude_agl_raw = rt.exact_raw(altitude_agl_, _R_12)
            raw.append(altitude_agl_raw)
        altitude_msl_ = self.altitude_msl
        if altitude_msl_ is not None:
            mask |= 8
            if not -50000.0 <= altitude_msl_ <= 50000.0:
                raise rt.Reject
            altitude_msl_pos = (altitude_msl_ + 50000.0) * 42949.67295 + 0.5
            altitude_msl_raw = int(altitude_msl_pos)
            if not 1.52587890625e-05 < altitude_msl_pos - altitude_msl_raw < 0.9999847412109375:
                altitude_msl_raw = rt.exact_raw(altitude_msl_, _R_12)
            raw.append(altitude_msl_raw)
        altitude_asf_ = self.altitude_asf
        if altitude_asf_ is not None:
            mask |= 16
            if not -50000.0 <= altitude_asf_ <= 50000.0:
                raise rt.Reject
            altitude_asf_pos = (altitude_asf_ + 50000.0) * 42949.67295 + 0.5
            altitude_asf_raw = int(altitude_asf_pos)
            if not 1.52587890625e-05 < altitude_asf_pos - altitude_asf_raw < 0.9999847412109375:
                altitude_asf_raw = rt.exact_raw(altitude_asf_, _R_12)
            raw.append(altitude_asf_raw)
        depth_ = self.depth
        if depth_ is not None:
            mask |= 32
            if not -50000.0 <= depth_ <= 50000.0:
                raise rt.Reject
            depth_pos = (depth_ + 50000.0) * 42949.67295 + 0.5
            depth_raw = int(depth_pos)
            if not 1.52587890625e-05 < depth_pos - depth_raw < 0.9999847412109375:
                depth_raw = rt.exact_raw(depth_, _R_12)
            raw.append(depth_raw)
        z_local_ = self.z_local
        if z_local_ is not None:
            mask |= 64
            if not -50000.0 <= z_local_ <= 50000.0:
                raise rt.Reject
            z_local_pos = (z_local_ + 50000.0) * 42949.67295 + 0.5
            z_local_raw = int(z_local_pos)
            if not 1.52587890625e-05 < z_local_pos - z_local_raw < 0.9999847412109375:
                z_local_raw = rt.exact_raw(z_local_, _R_12)
            raw.append(z_local_raw)
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 128
            if not 0.0 <= xy_position_rms_ <= 100.0:
                raise rt.Reject
            xy_position_rms_pos = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw = int(xy_position_rms_pos)
            if not 1.52587890625e-05 < xy_position_rms_pos - xy_position_rms_raw < 0.9999847412109375:
                xy_position_rms_raw = rt.exact_raw(xy_position_rms_, _R_3)
            raw.append(xy_position_rms_raw)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 256
            if not 0.0 <= z_position_rms_ <= 100.0:
                raise rt.Reject
            z_position_rms_pos = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw = int(z_position_rms_pos)
            if not 1.52587890625e-05 < z_position_rms_pos - z_position_rms_raw < 0.9999847412109375:
                z_position_rms_raw = rt.exact_raw(z_position_rms_, _R_3)
            raw.append(z_position_rms_raw)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 512
            if not -3.141592653589793 <= roll_ <= 3.141592653589793:
                raise rt.Reject
            roll_pos = (roll_ + 3.141592653589793) * 10430.219195527361 + 0.5
            roll_raw = int(roll_pos)
            if not 1.52587890625e-05 < roll_pos - roll_raw < 0.9999847412109375:
                roll_raw = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 1024
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793:
                raise rt.Reject
            pitch_pos = (pitch_ + 3.141592653589793) * 10430.219195527361 + 0.5
            pitch_raw = int(pitch_pos)
            if not 1.52587890625e-05 < pitch_pos - pitch_raw < 0.9999847412109375:
                pitch_raw = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 2048
            if not -3.141592653589793 <= heading_ <= 3.141592653589793:
                raise rt.Reject
            heading_pos = (heading_ + 3.141592653589793) * 10430.219195527361 + 0.5
            heading_raw = int(heading_pos)
            if not 1.52587890625e-05 < heading_pos - heading_raw < 0.9999847412109375:
                heading_raw = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 4096
            if not 0.0 <= attitude_rms_ <= 3.141592653589793:
                raise rt.Reject
            attitude_rms_pos = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw = int(attitude_rms_pos)
            if not 1.52587890625e-05 < attitude_rms_pos - attitude_rms_raw < 0.9999847412109375:
                attitude_rms_raw = rt.exact_raw(attitude_rms_, _R_5)
            raw.append(attitude_rms_raw)
        course_ = self.course
        if course_ is not None:
            mask |= 8192
            if not -3.141592653589793 <= course_ <= 3.141592653589793:
                raise rt.Reject
            course_pos = (course_ + 3.141592653589793) * 10430.219195527361 + 0.5
            course_raw = int(course_pos)
            if not 1.52587890625e-05 < course_pos - course_raw < 0.9999847412109375:
                course_raw = rt.exact_raw(course_, _R_4)
            raw.append(course_raw)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 16384
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 32768
            raw.append(time_nano_seconds_)
        return _M_ReportLocalPoseExt_pack[mask & 0xFFFF].pack(0x44A3, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_SetLocalPose = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_R_3 = rt.Scaling(0.0, 100.0, 4294967295)
_R_4 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_5 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_SetLocalPose_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_S_H = rt.Packer("<H")
_M_SetLocalPoseExt_0 = rt.Masks("", ((1, "I"), (2, "I")))
_M_SetLocalPoseExt_2 = rt.Masks("", ((8, "I"), (16, "I"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "I"), (1024, "I")))
_R_10 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_M_ReportLocalPoseExt = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "I"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "H"), (16384, "I"), (32768, "I")))
_R_12 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_M_ReportLocalPoseExt_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "I"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "H"), (16384, "I"), (32768, "I")))
