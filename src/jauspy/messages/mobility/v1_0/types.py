"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class GlobalPoseRec(rt.Struct):
    """GlobalPoseRec.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """

    latitude: float | None = None
    longitude: float | None = None
    altitude: float | None = None
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
            ("Latitude", rt.real("I", -90.0, 90.0, "degree"), True),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree"), True),
            ("Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Position_RMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_GlobalPoseRec_0[mask & 0x1FF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
        self.longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
        self.altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 4 else None
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
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x1FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if latitude_ is not None:
            mask |= 1
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_2)
            raw.append(latitude_raw_)
        longitude_ = self.longitude
        if longitude_ is not None:
            mask |= 2
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_3)
            raw.append(longitude_raw_)
        altitude_ = self.altitude
        if altitude_ is not None:
            mask |= 4
            if not -10000.0 <= altitude_ <= 35000.0: raise rt.Reject
            near = altitude_ * 95443.71766666666 + 954437177.1666666
            altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_raw_ < 0.9999847412109375: altitude_raw_ = rt.exact_raw(altitude_, _R_4)
            raw.append(altitude_raw_)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0: raise rt.Reject
            near = position_rms_ * 42949672.95 + 0.5
            position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_rms_raw_ < 0.9999847412109375: position_rms_raw_ = rt.exact_raw(position_rms_, _R_5)
            raw.append(position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_6)
            raw.append(yaw_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
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
        out += _M_mobility_v1_0_types_GlobalPoseRec_0[mask & 0x1FF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class LocalPoseRec(rt.Struct):
    """LocalPoseRec.

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
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_GlobalPoseRec_0[mask & 0x1FF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
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
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x1FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
            near = x_ * 21474.836475 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_8)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
            near = y_ * 21474.836475 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_8)
            raw.append(y_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 4
            if not -100000.0 <= z_ <= 100000.0: raise rt.Reject
            near = z_ * 21474.836475 + 2147483648.0
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_8)
            raw.append(z_raw_)
        position_rms_ = self.position_rms
        if position_rms_ is not None:
            mask |= 8
            if not 0.0 <= position_rms_ <= 100.0: raise rt.Reject
            near = position_rms_ * 42949672.95 + 0.5
            position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_rms_raw_ < 0.9999847412109375: position_rms_raw_ = rt.exact_raw(position_rms_, _R_5)
            raw.append(position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 16
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 32
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 64
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_6)
            raw.append(yaw_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 128
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
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
        out += _M_mobility_v1_0_types_GlobalPoseRec_0[mask & 0x1FF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class GlobalZPosition(rt.Struct):
    """GlobalZPosition.

    0: meter, -50000..50000 meter
    1: meter, -50000..50000 meter
    2: meter, -50000..50000 meter
    3: meter, -50000..50000 meter
    """

    class Choice(IntEnum):
        """Values of Choice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    choice: GlobalZPosition.Choice | int
    value: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Choice(
            cls,
            {
                0: rt.real("I", -50000.0, 50000.0, "meter"),
                1: rt.real("I", -50000.0, 50000.0, "meter"),
                2: rt.real("I", -50000.0, 50000.0, "meter"),
                3: rt.real("I", -50000.0, 50000.0, "meter"),
            },
            rt.Values(GlobalZPosition.Choice),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        choice = data[at]
        if choice == 0:
            (value_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_ * 2.3283064370807974e-05
            at += 5
        elif choice == 1:
            (value_2_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
            at += 5
        elif choice == 2:
            (value_3_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
            at += 5
        elif choice == 3:
            (value_4_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
            at += 5
        else: raise rt.Reject
        self.choice = _E_GlobalZPosition_Choice[choice]
        return self, at

    def _write(self, out: bytearray) -> None:
        choice = self.choice
        if choice == 0:
            value_ = self.value
            if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
            near = value_ * 42949.67295 + 2147483648.0
            value_raw_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_11)
            out += _S_BI.pack(choice, value_raw_)
        elif choice == 1:
            value_2_ = self.value
            if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
            near = value_2_ * 42949.67295 + 2147483648.0
            value_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_11)
            out += _S_BI.pack(choice, value_raw_2_)
        elif choice == 2:
            value_3_ = self.value
            if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
            near = value_3_ * 42949.67295 + 2147483648.0
            value_raw_3_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_11)
            out += _S_BI.pack(choice, value_raw_3_)
        elif choice == 3:
            value_4_ = self.value
            if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
            near = value_4_ * 42949.67295 + 2147483648.0
            value_raw_4_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_11)
            out += _S_BI.pack(choice, value_raw_4_)
        else: raise rt.Reject


@dataclass(slots=True, repr=False)
class PolygonRec(rt.Struct):
    """PolygonRec.

    number_loiter_vertices: Number of corners of the polygon
    xy_extent: 0..100000 meter. Horizontal size of the polygon, in metres
    loiter_direction: LoiterDirection. Sense of rotation, seen from above
    loiter_bearing: 0..3.14159265359 radian. Direction of the polygon, in radians
    """

    class LoiterDirection(IntEnum):
        """Values of LoiterDirection."""

        VEHICLE_DEPENDENT = 0
        CLOCKWISE = 1
        COUNTERCLOCKWISE = 2

    number_loiter_vertices: int
    xy_extent: float
    loiter_direction: PolygonRec.LoiterDirection | int
    loiter_bearing: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NumberLoiterVertices", rt.Number("B")),
            ("XYExtent", rt.real("I", 0.0, 100000.0, "meter")),
            ("LoiterDirection", rt.Number("B", rt.Values(PolygonRec.LoiterDirection))),
            ("LoiterBearing", rt.real("H", 0.0, 3.141592653589793, "radian")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.number_loiter_vertices, xy_extent_, loiter_direction_, loiter_bearing_ = _S_BIBH.unpack_from(data, at)
        self.xy_extent = xy_extent_ * 2.3283064370807974e-05
        self.loiter_direction = _E_PolygonRec_LoiterDirection[loiter_direction_]
        self.loiter_bearing = loiter_bearing_ * 4.793763109162727e-05
        return self, at + 8

    def _write(self, out: bytearray) -> None:
        xy_extent_ = self.xy_extent
        if not 0.0 <= xy_extent_ <= 100000.0: raise rt.Reject
        near = xy_extent_ * 42949.67295 + 0.5
        xy_extent_raw_ = int(near)
        if not 1.52587890625e-05 < near - xy_extent_raw_ < 0.9999847412109375: xy_extent_raw_ = rt.exact_raw(xy_extent_, _R_15)
        loiter_direction_ = self.loiter_direction
        if loiter_direction_ not in _E_PolygonRec_LoiterDirection: raise rt.Reject
        loiter_bearing_ = self.loiter_bearing
        if not 0.0 <= loiter_bearing_ <= 3.141592653589793: raise rt.Reject
        near = loiter_bearing_ * 20860.438391054722 + 0.5
        loiter_bearing_raw_ = int(near)
        if not 1.52587890625e-05 < near - loiter_bearing_raw_ < 0.9999847412109375: loiter_bearing_raw_ = rt.exact_raw(loiter_bearing_, _R_7)
        out += _S_BIBH.pack(self.number_loiter_vertices, xy_extent_raw_, loiter_direction_, loiter_bearing_raw_)


@dataclass(slots=True, repr=False)
class RaceTrackRec(rt.Struct):
    """RaceTrackRec.

    loiter_type: LoiterType. Whether the straights are parallel or cross
    loiter_radius: 0..200000 meter. Radius of the turns, in metres
    loiter_length: 0..200000 meter. Length of the pattern, in metres
    loiter_direction: LoiterDirection. Sense of rotation, seen from above
    loiter_bearing: 0..3.14159265359 radian. Direction of the long axis of the pattern, in radians
    """

    class LoiterType(IntEnum):
        """Values of LoiterType."""

        RACETRACK = 0
        FIGURE_8 = 1

    class LoiterDirection(IntEnum):
        """Values of LoiterDirection."""

        VEHICLE_DEPENDENT = 0
        CLOCKWISE = 1
        COUNTERCLOCKWISE = 2

    loiter_type: RaceTrackRec.LoiterType | int
    loiter_radius: float
    loiter_length: float
    loiter_direction: RaceTrackRec.LoiterDirection | int
    loiter_bearing: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("LoiterType", rt.Number("B", rt.Values(RaceTrackRec.LoiterType))),
            ("LoiterRadius", rt.real("I", 0.0, 200000.0, "meter")),
            ("LoiterLength", rt.real("I", 0.0, 200000.0, "meter")),
            ("LoiterDirection", rt.Number("B", rt.Values(RaceTrackRec.LoiterDirection))),
            ("LoiterBearing", rt.real("H", 0.0, 3.141592653589793, "radian")),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        loiter_type_, loiter_radius_, loiter_length_, loiter_direction_, loiter_bearing_ = _S_B2IBH.unpack_from(data, at)
        self.loiter_type = _E_RaceTrackRec_LoiterType[loiter_type_]
        self.loiter_radius = loiter_radius_ * 4.656612874161595e-05
        self.loiter_length = loiter_length_ * 4.656612874161595e-05
        self.loiter_direction = _E_RaceTrackRec_LoiterDirection[loiter_direction_]
        self.loiter_bearing = loiter_bearing_ * 4.793763109162727e-05
        return self, at + 12

    def _write(self, out: bytearray) -> None:
        loiter_type_ = self.loiter_type
        if loiter_type_ not in _E_RaceTrackRec_LoiterType: raise rt.Reject
        loiter_radius_ = self.loiter_radius
        if not 0.0 <= loiter_radius_ <= 200000.0: raise rt.Reject
        near = loiter_radius_ * 21474.836475 + 0.5
        loiter_radius_raw_ = int(near)
        if not 1.52587890625e-05 < near - loiter_radius_raw_ < 0.9999847412109375: loiter_radius_raw_ = rt.exact_raw(loiter_radius_, _R_19)
        loiter_length_ = self.loiter_length
        if not 0.0 <= loiter_length_ <= 200000.0: raise rt.Reject
        near = loiter_length_ * 21474.836475 + 0.5
        loiter_length_raw_ = int(near)
        if not 1.52587890625e-05 < near - loiter_length_raw_ < 0.9999847412109375: loiter_length_raw_ = rt.exact_raw(loiter_length_, _R_19)
        loiter_direction_ = self.loiter_direction
        if loiter_direction_ not in _E_RaceTrackRec_LoiterDirection: raise rt.Reject
        loiter_bearing_ = self.loiter_bearing
        if not 0.0 <= loiter_bearing_ <= 3.141592653589793: raise rt.Reject
        near = loiter_bearing_ * 20860.438391054722 + 0.5
        loiter_bearing_raw_ = int(near)
        if not 1.52587890625e-05 < near - loiter_bearing_raw_ < 0.9999847412109375: loiter_bearing_raw_ = rt.exact_raw(loiter_bearing_, _R_7)
        out += _S_B2IBH.pack(loiter_type_, loiter_radius_raw_, loiter_length_raw_, loiter_direction_, loiter_bearing_raw_)


@dataclass(slots=True, repr=False)
class Speed(rt.Struct):
    """Speed.

    0: meter per second, -327.68..327.67 meter per second
    1: meter per second, -327.68..327.67 meter per second
    2: rotations per minute, -1000..1000 rotations per minute
    3: meter per second, -327.68..327.67 meter per second
    """

    class Choice(IntEnum):
        """Values of Choice."""

        SPEED_OVER_GROUND = 0
        SPEED_RELATIVE_TO_MEDIUM = 1
        ROTATIONS_PER_MINUTE = 2
        INDICATED_SPEED = 3

    choice: Speed.Choice | int
    value: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Choice(
            cls,
            {
                0: rt.real("H", -327.68, 327.67, "meter per second"),
                1: rt.real("H", -327.68, 327.67, "meter per second"),
                2: rt.real("H", -1000.0, 1000.0, "rotations per minute"),
                3: rt.real("H", -327.68, 327.67, "meter per second"),
            },
            rt.Values(Speed.Choice),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        choice = data[at]
        if choice == 0:
            (value_,) = _S_H.unpack_from(data, at + 1)
            self.value = -327.68 + value_ * 0.01
            at += 3
        elif choice == 1:
            (value_2_,) = _S_H.unpack_from(data, at + 1)
            self.value = -327.68 + value_2_ * 0.01
            at += 3
        elif choice == 2:
            (value_3_,) = _S_H.unpack_from(data, at + 1)
            self.value = -1000.0 + value_3_ * 0.030518043793392843
            at += 3
        elif choice == 3:
            (value_4_,) = _S_H.unpack_from(data, at + 1)
            self.value = -327.68 + value_4_ * 0.01
            at += 3
        else: raise rt.Reject
        self.choice = _E_Speed_Choice[choice]
        return self, at

    def _write(self, out: bytearray) -> None:
        choice = self.choice
        if choice == 0:
            value_ = self.value
            if not -327.68 <= value_ <= 327.67: raise rt.Reject
            near = value_ * 100.0 + 32768.5
            value_raw_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_21)
            out += _S_BH.pack(choice, value_raw_)
        elif choice == 1:
            value_2_ = self.value
            if not -327.68 <= value_2_ <= 327.67: raise rt.Reject
            near = value_2_ * 100.0 + 32768.5
            value_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_21)
            out += _S_BH.pack(choice, value_raw_2_)
        elif choice == 2:
            value_3_ = self.value
            if not -1000.0 <= value_3_ <= 1000.0: raise rt.Reject
            near = value_3_ * 32.7675 + 32768.0
            value_raw_3_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_23)
            out += _S_BH.pack(choice, value_raw_3_)
        elif choice == 3:
            value_4_ = self.value
            if not -327.68 <= value_4_ <= 327.67: raise rt.Reject
            near = value_4_ * 100.0 + 32768.5
            value_raw_4_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_21)
            out += _S_BH.pack(choice, value_raw_4_)
        else: raise rt.Reject


@dataclass(slots=True, repr=False)
class ZoneIDRec(rt.Struct):
    """ZoneIDRec.

    zone_id: ZoneID or 2..65535. Number of the zone
    """

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    zone_id: ZoneIDRec.ZoneID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ZoneID", rt.Number("H", rt.Values(ZoneIDRec.ZoneID, ((2, 65535),)))),
        )


@dataclass(slots=True, repr=False)
class ExcursionRec(rt.Struct):
    """ExcursionRec.

    zone_id: ZoneID or 2..65535. Number of the zone
    zone_status: ZoneStatus. Where the platform is with regard to the zone
    """

    class ZoneID(IntEnum):
        """Values of ZoneID."""

        RESERVED = 0
        OPERATING_ZONE = 1

    class ZoneStatus(IntEnum):
        """Values of ZoneStatus."""

        INSIDE_SAFE_ZONE = 0
        OUTSIDE_SAFE_ZONE = 1
        INSIDE_SAFE_AND_EXCLUSION_ZONE = 2

    zone_id: ExcursionRec.ZoneID | int
    zone_status: ExcursionRec.ZoneStatus | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ZoneID", rt.Number("H", rt.Values(ExcursionRec.ZoneID, ((2, 65535),)))),
            ("ZoneStatus", rt.Number("B", rt.Values(ExcursionRec.ZoneStatus))),
        )


@dataclass(slots=True, repr=False)
class ZPosition(rt.Struct):
    """ZPosition.

    0: meter, -50000..50000 meter
    1: meter, -50000..50000 meter
    2: meter, -50000..50000 meter
    3: meter, -50000..50000 meter
    4: meter, -50000..50000 meter
    """

    class Choice(IntEnum):
        """Values of Choice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    choice: ZPosition.Choice | int
    value: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Choice(
            cls,
            {
                0: rt.real("I", -50000.0, 50000.0, "meter"),
                1: rt.real("I", -50000.0, 50000.0, "meter"),
                2: rt.real("I", -50000.0, 50000.0, "meter"),
                3: rt.real("I", -50000.0, 50000.0, "meter"),
                4: rt.real("I", -50000.0, 50000.0, "meter"),
            },
            rt.Values(ZPosition.Choice),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        choice = data[at]
        if choice == 0:
            (value_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_ * 2.3283064370807974e-05
            at += 5
        elif choice == 1:
            (value_2_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
            at += 5
        elif choice == 2:
            (value_3_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
            at += 5
        elif choice == 3:
            (value_4_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
            at += 5
        elif choice == 4:
            (value_5_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
            at += 5
        else: raise rt.Reject
        self.choice = _E_ZPosition_Choice[choice]
        return self, at

    def _write(self, out: bytearray) -> None:
        choice = self.choice
        if choice == 0:
            value_ = self.value
            if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
            near = value_ * 42949.67295 + 2147483648.0
            value_raw_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_11)
            out += _S_BI.pack(choice, value_raw_)
        elif choice == 1:
            value_2_ = self.value
            if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
            near = value_2_ * 42949.67295 + 2147483648.0
            value_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_11)
            out += _S_BI.pack(choice, value_raw_2_)
        elif choice == 2:
            value_3_ = self.value
            if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
            near = value_3_ * 42949.67295 + 2147483648.0
            value_raw_3_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_11)
            out += _S_BI.pack(choice, value_raw_3_)
        elif choice == 3:
            value_4_ = self.value
            if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
            near = value_4_ * 42949.67295 + 2147483648.0
            value_raw_4_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_11)
            out += _S_BI.pack(choice, value_raw_4_)
        elif choice == 4:
            value_5_ = self.value
            if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
            near = value_5_ * 42949.67295 + 2147483648.0
            value_raw_5_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_11)
            out += _S_BI.pack(choice, value_raw_5_)
        else: raise rt.Reject


@dataclass(slots=True, repr=False)
class ReportGlobalPoseExtRec(rt.Struct):
    """ReportGlobalPoseExtRec.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is true north
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    latitude: float | None = None
    longitude: float | None = None
    altitude_agl: float | None = None
    altitude_msl: float | None = None
    altitude_asf: float | None = None
    depth: float | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    course: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree"), True),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree"), True),
            ("AltitudeAGL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeMSL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeASF", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("Depth", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("XYPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("ZPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("Course", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_ReportGlobalPoseExtRec_0[mask & 0x7FFF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
        self.longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
        self.altitude_agl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.altitude_msl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 8 else None
        self.altitude_asf = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 16 else None
        self.depth = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.xy_position_rms = raw() * 2.3283064370807974e-08 if mask & 64 else None
        self.z_position_rms = raw() * 2.3283064370807974e-08 if mask & 128 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 256 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 512 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 2048 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4096 else None
        self.time_seconds = raw() if mask & 8192 else None
        self.time_nano_seconds = raw() if mask & 16384 else None
        self.reserved_presence = mask & 0x8000
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if latitude_ is not None:
            mask |= 1
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_2)
            raw.append(latitude_raw_)
        longitude_ = self.longitude
        if longitude_ is not None:
            mask |= 2
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_3)
            raw.append(longitude_raw_)
        altitude_agl_ = self.altitude_agl
        if altitude_agl_ is not None:
            mask |= 4
            if not -50000.0 <= altitude_agl_ <= 50000.0: raise rt.Reject
            near = altitude_agl_ * 42949.67295 + 2147483648.0
            altitude_agl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_agl_raw_ < 0.9999847412109375: altitude_agl_raw_ = rt.exact_raw(altitude_agl_, _R_11)
            raw.append(altitude_agl_raw_)
        altitude_msl_ = self.altitude_msl
        if altitude_msl_ is not None:
            mask |= 8
            if not -50000.0 <= altitude_msl_ <= 50000.0: raise rt.Reject
            near = altitude_msl_ * 42949.67295 + 2147483648.0
            altitude_msl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_msl_raw_ < 0.9999847412109375: altitude_msl_raw_ = rt.exact_raw(altitude_msl_, _R_11)
            raw.append(altitude_msl_raw_)
        altitude_asf_ = self.altitude_asf
        if altitude_asf_ is not None:
            mask |= 16
            if not -50000.0 <= altitude_asf_ <= 50000.0: raise rt.Reject
            near = altitude_asf_ * 42949.67295 + 2147483648.0
            altitude_asf_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_asf_raw_ < 0.9999847412109375: altitude_asf_raw_ = rt.exact_raw(altitude_asf_, _R_11)
            raw.append(altitude_asf_raw_)
        depth_ = self.depth
        if depth_ is not None:
            mask |= 32
            if not -50000.0 <= depth_ <= 50000.0: raise rt.Reject
            near = depth_ * 42949.67295 + 2147483648.0
            depth_raw_ = int(near)
            if not 1.52587890625e-05 < near - depth_raw_ < 0.9999847412109375: depth_raw_ = rt.exact_raw(depth_, _R_11)
            raw.append(depth_raw_)
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 64
            if not 0.0 <= xy_position_rms_ <= 100.0: raise rt.Reject
            near = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_position_rms_raw_ < 0.9999847412109375: xy_position_rms_raw_ = rt.exact_raw(xy_position_rms_, _R_5)
            raw.append(xy_position_rms_raw_)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 128
            if not 0.0 <= z_position_rms_ <= 100.0: raise rt.Reject
            near = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_position_rms_raw_ < 0.9999847412109375: z_position_rms_raw_ = rt.exact_raw(z_position_rms_, _R_5)
            raw.append(z_position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 256
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 512
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 1024
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_6)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 2048
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
            raw.append(attitude_rms_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 4096
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_6)
            raw.append(course_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 8192
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 16384
            raw.append(time_nano_seconds_)
        out += _M_mobility_v1_0_types_ReportGlobalPoseExtRec_0[mask & 0x7FFF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReportLocalPoseExtRec(rt.Struct):
    """ReportLocalPoseExtRec.

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
        return rt.composite(
            cls, "H",
            ("X", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("Y", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("AltitudeAGL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeMSL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeASF", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("Depth", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("ZLocal", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("XYPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("ZPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("Course", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_ReportLocalPoseExtRec_0[mask & 0xFFFF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.x = -20000000.0 + raw() * 0.00931322574832319 if mask & 1 else None
        self.y = -20000000.0 + raw() * 0.00931322574832319 if mask & 2 else None
        self.altitude_agl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.altitude_msl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 8 else None
        self.altitude_asf = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 16 else None
        self.depth = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.z_local = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 64 else None
        self.xy_position_rms = raw() * 2.3283064370807974e-08 if mask & 128 else None
        self.z_position_rms = raw() * 2.3283064370807974e-08 if mask & 256 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 512 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2048 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 4096 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8192 else None
        self.time_seconds = raw() if mask & 16384 else None
        self.time_nano_seconds = raw() if mask & 32768 else None
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = 0
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_27)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_27)
            raw.append(y_raw_)
        altitude_agl_ = self.altitude_agl
        if altitude_agl_ is not None:
            mask |= 4
            if not -50000.0 <= altitude_agl_ <= 50000.0: raise rt.Reject
            near = altitude_agl_ * 42949.67295 + 2147483648.0
            altitude_agl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_agl_raw_ < 0.9999847412109375: altitude_agl_raw_ = rt.exact_raw(altitude_agl_, _R_11)
            raw.append(altitude_agl_raw_)
        altitude_msl_ = self.altitude_msl
        if altitude_msl_ is not None:
            mask |= 8
            if not -50000.0 <= altitude_msl_ <= 50000.0: raise rt.Reject
            near = altitude_msl_ * 42949.67295 + 2147483648.0
            altitude_msl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_msl_raw_ < 0.9999847412109375: altitude_msl_raw_ = rt.exact_raw(altitude_msl_, _R_11)
            raw.append(altitude_msl_raw_)
        altitude_asf_ = self.altitude_asf
        if altitude_asf_ is not None:
            mask |= 16
            if not -50000.0 <= altitude_asf_ <= 50000.0: raise rt.Reject
            near = altitude_asf_ * 42949.67295 + 2147483648.0
            altitude_asf_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_asf_raw_ < 0.9999847412109375: altitude_asf_raw_ = rt.exact_raw(altitude_asf_, _R_11)
            raw.append(altitude_asf_raw_)
        depth_ = self.depth
        if depth_ is not None:
            mask |= 32
            if not -50000.0 <= depth_ <= 50000.0: raise rt.Reject
            near = depth_ * 42949.67295 + 2147483648.0
            depth_raw_ = int(near)
            if not 1.52587890625e-05 < near - depth_raw_ < 0.9999847412109375: depth_raw_ = rt.exact_raw(depth_, _R_11)
            raw.append(depth_raw_)
        z_local_ = self.z_local
        if z_local_ is not None:
            mask |= 64
            if not -50000.0 <= z_local_ <= 50000.0: raise rt.Reject
            near = z_local_ * 42949.67295 + 2147483648.0
            z_local_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_local_raw_ < 0.9999847412109375: z_local_raw_ = rt.exact_raw(z_local_, _R_11)
            raw.append(z_local_raw_)
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 128
            if not 0.0 <= xy_position_rms_ <= 100.0: raise rt.Reject
            near = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_position_rms_raw_ < 0.9999847412109375: xy_position_rms_raw_ = rt.exact_raw(xy_position_rms_, _R_5)
            raw.append(xy_position_rms_raw_)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 256
            if not 0.0 <= z_position_rms_ <= 100.0: raise rt.Reject
            near = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_position_rms_raw_ < 0.9999847412109375: z_position_rms_raw_ = rt.exact_raw(z_position_rms_, _R_5)
            raw.append(z_position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 512
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 1024
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 2048
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_6)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 4096
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
            raw.append(attitude_rms_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 8192
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_6)
            raw.append(course_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 16384
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 32768
            raw.append(time_nano_seconds_)
        out += _M_mobility_v1_0_types_ReportLocalPoseExtRec_0[mask & 0xFFFF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class VelocityVehicleXYZRec(rt.Struct):
    """VelocityVehicleXYZRec.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    """

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_29)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_29)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_29)
            raw.append(velocity_z_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class VelocityLocalXYZRec(rt.Struct):
    """VelocityLocalXYZRec.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity along X of the local frame, in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity along Y of the local frame, in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity along Z of the local frame, in metres per second
    """

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_29)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_29)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_29)
            raw.append(velocity_z_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class VelocityNEDRec(rt.Struct):
    """VelocityNEDRec.

    velocity_n: -327.68..327.67 meter per second, optional. Velocity to the north, in metres per second
    velocity_e: -327.68..327.67 meter per second, optional. Velocity to the east, in metres per second
    velocity_d: -327.68..327.67 meter per second, optional. Velocity down, in metres per second
    """

    velocity_n: float | None = None
    velocity_e: float | None = None
    velocity_d: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_N", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_E", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_D", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_n = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_e = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_d = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_n_ = self.velocity_n
        if velocity_n_ is not None:
            mask |= 1
            if not -327.68 <= velocity_n_ <= 327.67: raise rt.Reject
            near = velocity_n_ * 6553700.0 + 2147516416.5
            velocity_n_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_n_raw_ < 0.9999847412109375: velocity_n_raw_ = rt.exact_raw(velocity_n_, _R_29)
            raw.append(velocity_n_raw_)
        velocity_e_ = self.velocity_e
        if velocity_e_ is not None:
            mask |= 2
            if not -327.68 <= velocity_e_ <= 327.67: raise rt.Reject
            near = velocity_e_ * 6553700.0 + 2147516416.5
            velocity_e_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_e_raw_ < 0.9999847412109375: velocity_e_raw_ = rt.exact_raw(velocity_e_, _R_29)
            raw.append(velocity_e_raw_)
        velocity_d_ = self.velocity_d
        if velocity_d_ is not None:
            mask |= 4
            if not -327.68 <= velocity_d_ <= 327.67: raise rt.Reject
            near = velocity_d_ * 6553700.0 + 2147516416.5
            velocity_d_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_d_raw_ < 0.9999847412109375: velocity_d_raw_ = rt.exact_raw(velocity_d_, _R_29)
            raw.append(velocity_d_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReportVelocityStateExtRec(rt.Struct):
    """ReportVelocityStateExtRec.

    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..100 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    speed_over_ground: -327.68..327.67 meter per second, optional. Speed over ground, in metres per second
    speed_relative_to_medium: -327.68..327.67 meter per second, optional. Speed through air or water, in metres per second
    rotations_per_minute: -1000..1000 rotations per minute, optional. Rotation of propeller or drive shaft, per minute
    indicated_speed: -327.68..327.67 meter per second, optional. Speed as an air or water speed indicator shows it, in metres per second
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    velocity_rms: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    rate_rms: float | None = None
    speed_over_ground: float | None = None
    speed_relative_to_medium: float | None = None
    rotations_per_minute: float | None = None
    indicated_speed: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Velocity_RMS", rt.real("I", 0.0, 100.0, "meter per second"), True),
            ("RollRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("PitchRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("YawRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("Rate_RMS", rt.real("H", 0.0, 100.0, "radian per second"), True),
            ("SpeedOverGround", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("SpeedRelativeToMedium", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("RotationsPerMinute", rt.real("H", -1000.0, 1000.0, "rotations per minute"), True),
            ("IndicatedSpeed", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_ReportVelocityStateExtRec_0[mask & 0x7FF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.velocity_rms = raw() * 2.3283064370807974e-08 if mask & 1 else None
        if mask & 2:
            roll_rate_ = raw()
            self.roll_rate = 32.767 if roll_rate_ == 4294967295 else -32.768 + roll_rate_ * 1.5258556235409003e-08
        else: self.roll_rate = None
        if mask & 4:
            pitch_rate_ = raw()
            self.pitch_rate = 32.767 if pitch_rate_ == 4294967295 else -32.768 + pitch_rate_ * 1.5258556235409003e-08
        else: self.pitch_rate = None
        if mask & 8:
            yaw_rate_ = raw()
            self.yaw_rate = 32.767 if yaw_rate_ == 4294967295 else -32.768 + yaw_rate_ * 1.5258556235409003e-08
        else: self.yaw_rate = None
        self.rate_rms = raw() * 0.0015259021896696422 if mask & 16 else None
        self.speed_over_ground = -327.68 + raw() * 0.01 if mask & 32 else None
        self.speed_relative_to_medium = -327.68 + raw() * 0.01 if mask & 64 else None
        self.rotations_per_minute = -1000.0 + raw() * 0.030518043793392843 if mask & 128 else None
        self.indicated_speed = -327.68 + raw() * 0.01 if mask & 256 else None
        self.time_seconds = raw() if mask & 512 else None
        self.time_nano_seconds = raw() if mask & 1024 else None
        self.reserved_presence = mask & 0xF800
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_rms_ = self.velocity_rms
        if velocity_rms_ is not None:
            mask |= 1
            if not 0.0 <= velocity_rms_ <= 100.0: raise rt.Reject
            near = velocity_rms_ * 42949672.95 + 0.5
            velocity_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_rms_raw_ < 0.9999847412109375: velocity_rms_raw_ = rt.exact_raw(velocity_rms_, _R_5)
            raw.append(velocity_rms_raw_)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 2
            if not -32.768 <= roll_rate_ <= 32.767: raise rt.Reject
            near = roll_rate_ * 65537000.0 + 2147516416.5
            roll_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_rate_raw_ < 0.9999847412109375: roll_rate_raw_ = rt.exact_raw(roll_rate_, _R_32)
            raw.append(roll_rate_raw_)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 4
            if not -32.768 <= pitch_rate_ <= 32.767: raise rt.Reject
            near = pitch_rate_ * 65537000.0 + 2147516416.5
            pitch_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_rate_raw_ < 0.9999847412109375: pitch_rate_raw_ = rt.exact_raw(pitch_rate_, _R_32)
            raw.append(pitch_rate_raw_)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 8
            if not -32.768 <= yaw_rate_ <= 32.767: raise rt.Reject
            near = yaw_rate_ * 65537000.0 + 2147516416.5
            yaw_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_rate_raw_ < 0.9999847412109375: yaw_rate_raw_ = rt.exact_raw(yaw_rate_, _R_32)
            raw.append(yaw_rate_raw_)
        rate_rms_ = self.rate_rms
        if rate_rms_ is not None:
            mask |= 16
            if not 0.0 <= rate_rms_ <= 100.0: raise rt.Reject
            near = rate_rms_ * 655.35 + 0.5
            rate_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rate_rms_raw_ < 0.9999847412109375: rate_rms_raw_ = rt.exact_raw(rate_rms_, _R_33)
            raw.append(rate_rms_raw_)
        speed_over_ground_ = self.speed_over_ground
        if speed_over_ground_ is not None:
            mask |= 32
            if not -327.68 <= speed_over_ground_ <= 327.67: raise rt.Reject
            near = speed_over_ground_ * 100.0 + 32768.5
            speed_over_ground_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_over_ground_raw_ < 0.9999847412109375: speed_over_ground_raw_ = rt.exact_raw(speed_over_ground_, _R_21)
            raw.append(speed_over_ground_raw_)
        speed_relative_to_medium_ = self.speed_relative_to_medium
        if speed_relative_to_medium_ is not None:
            mask |= 64
            if not -327.68 <= speed_relative_to_medium_ <= 327.67: raise rt.Reject
            near = speed_relative_to_medium_ * 100.0 + 32768.5
            speed_relative_to_medium_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_relative_to_medium_raw_ < 0.9999847412109375: speed_relative_to_medium_raw_ = rt.exact_raw(speed_relative_to_medium_, _R_21)
            raw.append(speed_relative_to_medium_raw_)
        rotations_per_minute_ = self.rotations_per_minute
        if rotations_per_minute_ is not None:
            mask |= 128
            if not -1000.0 <= rotations_per_minute_ <= 1000.0: raise rt.Reject
            near = rotations_per_minute_ * 32.7675 + 32768.0
            rotations_per_minute_raw_ = int(near)
            if not 1.52587890625e-05 < near - rotations_per_minute_raw_ < 0.9999847412109375: rotations_per_minute_raw_ = rt.exact_raw(rotations_per_minute_, _R_23)
            raw.append(rotations_per_minute_raw_)
        indicated_speed_ = self.indicated_speed
        if indicated_speed_ is not None:
            mask |= 256
            if not -327.68 <= indicated_speed_ <= 327.67: raise rt.Reject
            near = indicated_speed_ * 100.0 + 32768.5
            indicated_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - indicated_speed_raw_ < 0.9999847412109375: indicated_speed_raw_ = rt.exact_raw(indicated_speed_, _R_21)
            raw.append(indicated_speed_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 512
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 1024
            raw.append(time_nano_seconds_)
        out += _M_mobility_v1_0_types_ReportVelocityStateExtRec_0[mask & 0x7FF].pack(*raw)
        _S_H.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReportAccelerationStateExtRec(rt.Struct):
    """ReportAccelerationStateExtRec.

    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..1000 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    acceleration_x: float | None = None
    acceleration_y: float | None = None
    acceleration_z: float | None = None
    acceleration_rms: float | None = None
    roll_acceleration: float | None = None
    pitch_acceleration: float | None = None
    yaw_acceleration: float | None = None
    rotational_acceleration_rms: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
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
            ("RotationalAcceleration_RMS", rt.real("H", 0.0, 1000.0, "radian per second squared"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_ReportAccelerationStateExtRec_0[mask & 0x3FF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.acceleration_x = -1310.68 + raw() * 6.103329361906119e-07 if mask & 1 else None
        self.acceleration_y = -1310.68 + raw() * 6.103329361906119e-07 if mask & 2 else None
        self.acceleration_z = -1310.68 + raw() * 6.103329361906119e-07 if mask & 4 else None
        self.acceleration_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 16 else None
        self.pitch_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 32 else None
        self.yaw_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 64 else None
        self.rotational_acceleration_rms = raw() * 0.015259021896696421 if mask & 128 else None
        self.time_seconds = raw() if mask & 256 else None
        self.time_nano_seconds = raw() if mask & 512 else None
        self.reserved_presence = mask & 0xFC00
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x3FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        acceleration_x_ = self.acceleration_x
        if acceleration_x_ is not None:
            mask |= 1
            if not -1310.68 <= acceleration_x_ <= 1310.68: raise rt.Reject
            near = acceleration_x_ * 1638450.001144444 + 2147483648.0
            acceleration_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_x_raw_ < 0.9999847412109375: acceleration_x_raw_ = rt.exact_raw(acceleration_x_, _R_35)
            raw.append(acceleration_x_raw_)
        acceleration_y_ = self.acceleration_y
        if acceleration_y_ is not None:
            mask |= 2
            if not -1310.68 <= acceleration_y_ <= 1310.68: raise rt.Reject
            near = acceleration_y_ * 1638450.001144444 + 2147483648.0
            acceleration_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_y_raw_ < 0.9999847412109375: acceleration_y_raw_ = rt.exact_raw(acceleration_y_, _R_35)
            raw.append(acceleration_y_raw_)
        acceleration_z_ = self.acceleration_z
        if acceleration_z_ is not None:
            mask |= 4
            if not -1310.68 <= acceleration_z_ <= 1310.68: raise rt.Reject
            near = acceleration_z_ * 1638450.001144444 + 2147483648.0
            acceleration_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_z_raw_ < 0.9999847412109375: acceleration_z_raw_ = rt.exact_raw(acceleration_z_, _R_35)
            raw.append(acceleration_z_raw_)
        acceleration_rms_ = self.acceleration_rms
        if acceleration_rms_ is not None:
            mask |= 8
            if not 0.0 <= acceleration_rms_ <= 100.0: raise rt.Reject
            near = acceleration_rms_ * 42949672.95 + 0.5
            acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_rms_raw_ < 0.9999847412109375: acceleration_rms_raw_ = rt.exact_raw(acceleration_rms_, _R_5)
            raw.append(acceleration_rms_raw_)
        roll_acceleration_ = self.roll_acceleration
        if roll_acceleration_ is not None:
            mask |= 16
            if not -13106.8 <= roll_acceleration_ <= 13106.8: raise rt.Reject
            near = roll_acceleration_ * 163845.0001144444 + 2147483647.9999998
            roll_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_acceleration_raw_ < 0.9999847412109375: roll_acceleration_raw_ = rt.exact_raw(roll_acceleration_, _R_36)
            raw.append(roll_acceleration_raw_)
        pitch_acceleration_ = self.pitch_acceleration
        if pitch_acceleration_ is not None:
            mask |= 32
            if not -13106.8 <= pitch_acceleration_ <= 13106.8: raise rt.Reject
            near = pitch_acceleration_ * 163845.0001144444 + 2147483647.9999998
            pitch_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_acceleration_raw_ < 0.9999847412109375: pitch_acceleration_raw_ = rt.exact_raw(pitch_acceleration_, _R_36)
            raw.append(pitch_acceleration_raw_)
        yaw_acceleration_ = self.yaw_acceleration
        if yaw_acceleration_ is not None:
            mask |= 64
            if not -13106.8 <= yaw_acceleration_ <= 13106.8: raise rt.Reject
            near = yaw_acceleration_ * 163845.0001144444 + 2147483647.9999998
            yaw_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_acceleration_raw_ < 0.9999847412109375: yaw_acceleration_raw_ = rt.exact_raw(yaw_acceleration_, _R_36)
            raw.append(yaw_acceleration_raw_)
        rotational_acceleration_rms_ = self.rotational_acceleration_rms
        if rotational_acceleration_rms_ is not None:
            mask |= 128
            if not 0.0 <= rotational_acceleration_rms_ <= 1000.0: raise rt.Reject
            near = rotational_acceleration_rms_ * 65.535 + 0.5
            rotational_acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rotational_acceleration_rms_raw_ < 0.9999847412109375: rotational_acceleration_rms_raw_ = rt.exact_raw(rotational_acceleration_rms_, _R_37)
            raw.append(rotational_acceleration_rms_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 256
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 512
            raw.append(time_nano_seconds_)
        out += _M_mobility_v1_0_types_ReportAccelerationStateExtRec_0[mask & 0x3FF].pack(*raw)
        _S_H.pack_into(out, start, mask)


_S_H = rt.Packer("<H")
_M_mobility_v1_0_types_GlobalPoseRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_3 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_4 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_5 = rt.Scaling(0.0, 100.0, 4294967295)
_R_6 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_7 = rt.Scaling(0.0, 3.141592653589793, 65535)
_R_8 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_S_I = rt.Packer("<I")
_E_GlobalZPosition_Choice = rt.members(GlobalZPosition.Choice)
_R_11 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_E_PolygonRec_LoiterDirection = rt.members(PolygonRec.LoiterDirection)
_S_BIBH = rt.Packer("<BIBH")
_R_15 = rt.Scaling(0.0, 100000.0, 4294967295)
_E_RaceTrackRec_LoiterType = rt.members(RaceTrackRec.LoiterType)
_E_RaceTrackRec_LoiterDirection = rt.members(RaceTrackRec.LoiterDirection)
_S_B2IBH = rt.Packer("<B2IBH")
_R_19 = rt.Scaling(0.0, 200000.0, 4294967295)
_E_Speed_Choice = rt.members(Speed.Choice)
_R_21 = rt.Scaling(-327.68, 327.67, 65535)
_S_BH = rt.Packer("<BH")
_R_23 = rt.Scaling(-1000.0, 1000.0, 65535)
_E_ZPosition_Choice = rt.members(ZPosition.Choice)
_M_mobility_v1_0_types_ReportGlobalPoseExtRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "I"), (16384, "I")))
_M_mobility_v1_0_types_ReportLocalPoseExtRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "I"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "H"), (16384, "I"), (32768, "I")))
_R_27 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_M_mobility_v1_0_types_VelocityVehicleXYZRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I")))
_R_29 = rt.Scaling(-327.68, 327.67, 4294967295)
_S_B = rt.Packer("<B")
_M_mobility_v1_0_types_ReportVelocityStateExtRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "I"), (1024, "I")))
_R_32 = rt.Scaling(-32.768, 32.767, 4294967295)
_R_33 = rt.Scaling(0.0, 100.0, 65535)
_M_mobility_v1_0_types_ReportAccelerationStateExtRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "H"), (256, "I"), (512, "I")))
_R_35 = rt.Scaling(-1310.68, 1310.68, 4294967295)
_R_36 = rt.Scaling(-13106.8, 13106.8, 4294967295)
_R_37 = rt.Scaling(0.0, 1000.0, 65535)
