"""urn:jaus:jss:mobility:GlobalWaypointDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver


class SetTravelSpeed(mobility_v1_0_global_waypoint_driver.SetTravelSpeed):
    """SetTravelSpeed (0x040A): Sets the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


class SetTravelSpeedExt(mobility_v1_1_global_loiter_driver.SetTravelSpeedExt):
    """SetTravelSpeedExt (0x04AA): Sets the speed on the way as one of several kinds of speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


class SetGlobalWaypoint(mobility_v1_0_global_waypoint_driver.SetGlobalWaypoint):
    """SetGlobalWaypoint (0x040C): Sets the waypoint on the globe to drive to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class SetGlobalWaypointExt(rt.Message):
    """SetGlobalWaypointExt (0x04AC): Sets the waypoint on the globe to drive to, with a choice of the vertical
    datum.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is true north
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x04AC
    NAME = "SetGlobalWaypointExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    GlobalZPosition = mobility_v1_0_types.GlobalZPosition

    latitude: float
    longitude: float
    z_position: mobility_v1_0_types.GlobalZPosition | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    waypoint_tolerance: float | None = None
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("I", 0.0, 10000.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAC or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        latitude_, longitude_ = _S_2I.unpack_from(data, 3)
        self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
        self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
        at = 11
        if mask & 1:
            self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetGlobalWaypointExt_2[mask & 0x3E]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.waypoint_tolerance = raw() * 2.3283064370807974e-06 if mask & 16 else None
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xac\x04")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        latitude_ = self.latitude
        if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
        near = latitude_ * 23860929.416666668 + 2147483648.0
        latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_2)
        longitude_ = self.longitude
        if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
        near = longitude_ * 11930464.708333334 + 2147483648.0
        longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_3)
        out += _S_2I.pack(latitude_raw_, longitude_raw_)
        z_position_ = self.z_position
        if z_position_ is not None:
            mask |= 1
            if type(z_position_) is not mobility_v1_0_types.GlobalZPosition: raise rt.Reject
            z_position_._write(out)
        raw: list[int | float | bytes] = []
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 8
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 10000.0: raise rt.Reject
            near = waypoint_tolerance_ * 429496.7295 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_5)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_6)
            raw.append(path_tolerance_raw_)
        out += _M_SetGlobalWaypointExt_2[mask & 0x3E].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeed]]


class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTravelSpeedExt]]


class QueryGlobalWaypoint(mobility_v1_0_global_waypoint_driver.QueryGlobalWaypoint):
    """QueryGlobalWaypoint (0x240C): Asks for the waypoint on the globe being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportGlobalWaypoint]]


@dataclass(slots=True, repr=False)
class QueryGlobalWaypointExt(rt.Message):
    """QueryGlobalWaypointExt (0x24AC): Asks for the waypoint on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24AC
    NAME = "QueryGlobalWaypointExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalWaypointExt]]

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
        if code != 0x24AC: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x24AC, self.presence_vector)


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


class ReportGlobalWaypoint(mobility_v1_0_global_waypoint_driver.ReportGlobalWaypoint):
    """ReportGlobalWaypoint (0x440C): Tells the waypoint on the globe being driven to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportGlobalWaypointExt(rt.Message):
    """ReportGlobalWaypointExt (0x44AC): Tells the waypoint on the globe, with its vertical datum.

    latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction at the waypoint, in radians; 0 is true north
    waypoint_tolerance: 0..10000 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x44AC
    NAME = "ReportGlobalWaypointExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalWaypointDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    GlobalZPosition = mobility_v1_0_types.GlobalZPosition

    latitude: float
    longitude: float
    z_position: mobility_v1_0_types.GlobalZPosition | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    waypoint_tolerance: float | None = None
    path_tolerance: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree")),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree")),
            ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("I", 0.0, 10000.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xAC or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        latitude_, longitude_ = _S_2I.unpack_from(data, 3)
        self.latitude = -90.0 + latitude_ * 4.190951586745435e-08
        self.longitude = -180.0 + longitude_ * 8.38190317349087e-08
        at = 11
        if mask & 1:
            self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetGlobalWaypointExt_2[mask & 0x3E]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.waypoint_tolerance = raw() * 2.3283064370807974e-06 if mask & 16 else None
        self.path_tolerance = raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xac\x44")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        latitude_ = self.latitude
        if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
        near = latitude_ * 23860929.416666668 + 2147483648.0
        latitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_2)
        longitude_ = self.longitude
        if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
        near = longitude_ * 11930464.708333334 + 2147483648.0
        longitude_raw_ = int(near)
        if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_3)
        out += _S_2I.pack(latitude_raw_, longitude_raw_)
        z_position_ = self.z_position
        if z_position_ is not None:
            mask |= 1
            if type(z_position_) is not mobility_v1_0_types.GlobalZPosition: raise rt.Reject
            z_position_._write(out)
        raw: list[int | float | bytes] = []
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 8
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 10000.0: raise rt.Reject
            near = waypoint_tolerance_ * 429496.7295 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_5)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_6)
            raw.append(path_tolerance_raw_)
        out += _M_SetGlobalWaypointExt_2[mask & 0x3E].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_S_2I = rt.Packer("<2I")
_M_SetGlobalWaypointExt_2 = rt.Masks("", ((2, "H"), (4, "H"), (8, "H"), (16, "I"), (32, "I")))
_R_2 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_3 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_4 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_5 = rt.Scaling(0.0, 10000.0, 4294967295)
_R_6 = rt.Scaling(0.0, 100000.0, 4294967295)
_S_B = rt.Packer("<B")
_S_2H = rt.Packer("<2H")
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryTravelSpeedExt.REPORT = ReportTravelSpeedExt
QueryGlobalWaypoint.REPORT = ReportGlobalWaypoint
QueryGlobalWaypointExt.REPORT = ReportGlobalWaypointExt
