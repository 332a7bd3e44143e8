"""urn:jaus:jss:mobility:GlobalPoseSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class SetGlobalPose(rt.Message):
    """SetGlobalPose (0x0402): Sets the pose on the globe that the sensor is to assume as the present one.

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

    CODE = 0x0402
    NAME = "SetGlobalPose"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

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
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x0402: raise rt.Reject
        raw = iter(_M_SetGlobalPose[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
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
        return self

    def _pack(self) -> bytes:
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
        return _M_SetGlobalPose_pack[mask & 0x1FF].pack(0x0402, mask, *raw)


@dataclass(slots=True, repr=False)
class SetGeomagneticProperty(rt.Message):
    """SetGeomagneticProperty (0x0412): Sets the magnetic variation at the present place.

    magnetic_variation: -3.14159265359..3.14159265359 radian. Angle from true to magnetic north, in radians; positive to the east
    """

    CODE = 0x0412
    NAME = "SetGeomagneticProperty"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    magnetic_variation: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MagneticVariation", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, magnetic_variation_ = _S_2H.unpack(data)
        if code != 0x0412: raise rt.Reject
        self.magnetic_variation = -3.141592653589793 + magnetic_variation_ * 9.587526218325454e-05
        return self

    def _pack(self) -> bytes:
        magnetic_variation_ = self.magnetic_variation
        if not -3.141592653589793 <= magnetic_variation_ <= 3.141592653589793: raise rt.Reject
        near = magnetic_variation_ * 10430.219195527361 + 32768.0
        magnetic_variation_raw_ = int(near)
        if not 1.52587890625e-05 < near - magnetic_variation_raw_ < 0.9999847412109375: magnetic_variation_raw_ = rt.exact_raw(magnetic_variation_, _R_6)
        return _S_2H.pack(0x0412, magnetic_variation_raw_)


@dataclass(slots=True, repr=False)
class QueryGlobalPose(rt.Message):
    """QueryGlobalPose (0x2402): Asks for the pose on the globe.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2402
    NAME = "QueryGlobalPose"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalPose]]

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
        if code != 0x2402: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2402, self.presence_vector)


@dataclass(slots=True, repr=False)
class QueryGeomagneticProperty(rt.Message):
    """QueryGeomagneticProperty (0x2412): Asks for the magnetic variation in use."""

    CODE = 0x2412
    NAME = "QueryGeomagneticProperty"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGeomagneticProperty]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x12$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2412)


@dataclass(slots=True, repr=False)
class ReportGlobalPose(rt.Message):
    """ReportGlobalPose (0x4402): Tells the pose on the globe.

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

    CODE = 0x4402
    NAME = "ReportGlobalPose"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

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
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4402: raise rt.Reject
        raw = iter(_M_SetGlobalPose[mask & 0x1FF].unpack(data)).__next__
        self = rt.new(cls)
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
        return self

    def _pack(self) -> bytes:
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
        return _M_SetGlobalPose_pack[mask & 0x1FF].pack(0x4402, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportGeomagneticProperty(rt.Message):
    """ReportGeomagneticProperty (0x4412): Tells the magnetic variation in use.

    magnetic_variation: -3.14159265359..3.14159265359 radian. Angle from true to magnetic north, in radians; positive to the east
    """

    CODE = 0x4412
    NAME = "ReportGeomagneticProperty"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    magnetic_variation: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("MagneticVariation", rt.real("H", -3.141592653589793, 3.141592653589793, "radian")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, magnetic_variation_ = _S_2H.unpack(data)
        if code != 0x4412: raise rt.Reject
        self.magnetic_variation = -3.141592653589793 + magnetic_variation_ * 9.587526218325454e-05
        return self

    def _pack(self) -> bytes:
        magnetic_variation_ = self.magnetic_variation
        if not -3.141592653589793 <= magnetic_variation_ <= 3.141592653589793: raise rt.Reject
        near = magnetic_variation_ * 10430.219195527361 + 32768.0
        magnetic_variation_raw_ = int(near)
        if not 1.52587890625e-05 < near - magnetic_variation_raw_ < 0.9999847412109375: magnetic_variation_raw_ = rt.exact_raw(magnetic_variation_, _R_6)
        return _S_2H.pack(0x4412, magnetic_variation_raw_)


_S_2H = rt.Packer("<2H")
_M_SetGlobalPose = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_2 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_3 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_4 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_5 = rt.Scaling(0.0, 100.0, 4294967295)
_R_6 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_7 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_SetGlobalPose_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_S_H = rt.Packer("<H")
QueryGlobalPose.REPORT = ReportGlobalPose
QueryGeomagneticProperty.REPORT = ReportGeomagneticProperty
