"""urn:jaus:jss:mobility:GlobalWaypointDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver


@dataclass(slots=True, repr=False)
class SetTravelSpeed(rt.Message):
    """SetTravelSpeed (0x040A): Sets the speed on the way.

    speed: 0..327.67 meter per second. Speed on the way, in metres per second
    """

    CODE = 0x040A
    NAME = "SetTravelSpeed"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    speed: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Speed", rt.real("H", 0.0, 327.67, "meter per second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, speed_ = _S_2H.unpack(data)
        if code != 0x040A: raise rt.Reject
        self.speed = speed_ * 0.0049999237048905165
        return self

    def _pack(self) -> bytes:
        speed_ = self.speed
        if not 0.0 <= speed_ <= 327.67: raise rt.Reject
        near = speed_ * 200.0030518509476 + 0.5
        speed_raw_ = int(near)
        if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_1)
        return _S_2H.pack(0x040A, speed_raw_)


@dataclass(slots=True, repr=False)
class SetGlobalWaypoint(rt.Message):
    """SetGlobalWaypoint (0x040C): Sets the waypoint on the globe to drive to.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is true north
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x040C
    NAME = "SetGlobalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    latitude: float
    longitude: float
    altitude: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    waypoint_tolerance: float | None = None
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("H", 0.0, 100.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x040C: raise rt.Reject
        raw = iter(_M_SetGlobalWaypoint[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        latitude_ = raw()
        self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
        longitude_ = raw()
        self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
        self.altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.yaw = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.waypoint_tolerance = raw() * 0.0015259021896696422 if mask & 16 else None
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
        near = latitude_ * 23860929.416666668 + 2147483648.0
        latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_4)
        raw.append(latitude_raw_)
        longitude_ = self.longitude
        if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
        near = longitude_ * 11930464.708333334 + 2147483648.0
        longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_5)
        raw.append(longitude_raw_)
        altitude_ = self.altitude
        if altitude_ is not None:
            mask |= 1
            if not -10000.0 <= altitude_ <= 35000.0: raise rt.Reject
            near = altitude_ * 95443.71766666666 + 954437177.1666666
            altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_raw_ < 0.9999847412109375: altitude_raw_ = rt.exact_raw(altitude_, _R_6)
            raw.append(altitude_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_7)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_7)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 8
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_7)
            raw.append(yaw_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 100.0: raise rt.Reject
            near = waypoint_tolerance_ * 655.35 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_8)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_9)
            raw.append(path_tolerance_raw_)
        return _M_SetGlobalWaypoint_pack[mask & 0x3F].pack(0x040C, mask, *raw)


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportTravelSpeed]]


@dataclass(slots=True, repr=False)
class QueryGlobalWaypoint(rt.Message):
    """QueryGlobalWaypoint (0x240C): Asks for the waypoint on the globe being driven to.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x240C
    NAME = "QueryGlobalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalWaypoint]]

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
        if code != 0x240C: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x240C, self.presence_vector)


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportGlobalWaypoint(rt.Message):
    """ReportGlobalWaypoint (0x440C): Tells the waypoint on the globe being driven to.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is true north
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x440C
    NAME = "ReportGlobalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    latitude: float
    longitude: float
    altitude: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    waypoint_tolerance: float | None = None
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("Altitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("H", 0.0, 100.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x440C: raise rt.Reject
        raw = iter(_M_SetGlobalWaypoint[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        latitude_ = raw()
        self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
        longitude_ = raw()
        self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
        self.altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 1 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.yaw = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.waypoint_tolerance = raw() * 0.0015259021896696422 if mask & 16 else None
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
        near = latitude_ * 23860929.416666668 + 2147483648.0
        latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_4)
        raw.append(latitude_raw_)
        longitude_ = self.longitude
        if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
        near = longitude_ * 11930464.708333334 + 2147483648.0
        longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_5)
        raw.append(longitude_raw_)
        altitude_ = self.altitude
        if altitude_ is not None:
            mask |= 1
            if not -10000.0 <= altitude_ <= 35000.0: raise rt.Reject
            near = altitude_ * 95443.71766666666 + 954437177.1666666
            altitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_raw_ < 0.9999847412109375: altitude_raw_ = rt.exact_raw(altitude_, _R_6)
            raw.append(altitude_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_7)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_7)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 8
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_7)
            raw.append(yaw_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 100.0: raise rt.Reject
            near = waypoint_tolerance_ * 655.35 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_8)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_9)
            raw.append(path_tolerance_raw_)
        return _M_SetGlobalWaypoint_pack[mask & 0x3F].pack(0x440C, mask, *raw)


_S_2H = rt.Packer("<2H")
_R_1 = rt.Scaling(0.0, 327.67, 65535)
_S_HB = rt.Packer("<HB")
_M_SetGlobalWaypoint = rt.Masks("3x", ((0, "I"), (0, "I"), (1, "I"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "I")))
_R_4 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_5 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_6 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_7 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_8 = rt.Scaling(0.0, 100.0, 65535)
_R_9 = rt.Scaling(0.0, 100000.0, 4294967295)
_M_SetGlobalWaypoint_pack = rt.Masks("HB", ((0, "I"), (0, "I"), (1, "I"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "I")))
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryGlobalWaypoint.REPORT = ReportGlobalWaypoint
