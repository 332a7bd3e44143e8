"""urn:jaus:jss:mobility:LocalWaypointDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import global_waypoint_driver as mobility_v1_0_global_waypoint_driver


class SetTravelSpeed(mobility_v1_0_global_waypoint_driver.SetTravelSpeed):
    """SetTravelSpeed (0x040A): Sets the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class SetLocalWaypoint(rt.Message):
    """SetLocalWaypoint (0x040D): Sets the waypoint in the local frame to drive to.

    x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is along X
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x040D
    NAME = "SetLocalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    x: float
    y: float
    z: float | None = None
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
            ("X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("Z", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("H", 0.0, 100.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x040D: raise rt.Reject
        raw = iter(_M_SetLocalWaypoint[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        x_ = raw()
        self.x = -100000.0 + x_ * 4.656612874161595e-05
        y_ = raw()
        self.y = -100000.0 + y_ * 4.656612874161595e-05
        self.z = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
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
        x_ = self.x
        if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
        near = x_ * 21474.836475 + 2147483648.0
        x_raw_ = int(near)
        if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_2)
        raw.append(x_raw_)
        y_ = self.y
        if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
        near = y_ * 21474.836475 + 2147483648.0
        y_raw_ = int(near)
        if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_2)
        raw.append(y_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 1
            if not -100000.0 <= z_ <= 100000.0: raise rt.Reject
            near = z_ * 21474.836475 + 2147483648.0
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_2)
            raw.append(z_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_3)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_3)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 8
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_3)
            raw.append(yaw_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 100.0: raise rt.Reject
            near = waypoint_tolerance_ * 655.35 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_4)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_5)
            raw.append(path_tolerance_raw_)
        return _M_SetLocalWaypoint_pack[mask & 0x3F].pack(0x040D, mask, *raw)


class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportTravelSpeed]]


@dataclass(slots=True, repr=False)
class QueryLocalWaypoint(rt.Message):
    """QueryLocalWaypoint (0x240D): Asks for the waypoint in the local frame being driven to.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x240D
    NAME = "QueryLocalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalWaypoint]]

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
        if code != 0x240D: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x240D, self.presence_vector)


class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"


@dataclass(slots=True, repr=False)
class ReportLocalWaypoint(rt.Message):
    """ReportLocalWaypoint (0x440D): Tells the waypoint in the local frame being driven to.

    x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is along X
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    CODE = 0x440D
    NAME = "ReportLocalWaypoint"
    SERVICE = "urn:jaus:jss:mobility:LocalWaypointDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    x: float
    y: float
    z: float | None = None
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
            ("X", rt.real("I", -100000.0, 100000.0, "meter")),
            ("Y", rt.real("I", -100000.0, 100000.0, "meter")),
            ("Z", rt.real("I", -100000.0, 100000.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Yaw", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("WaypointTolerance", rt.real("H", 0.0, 100.0, "meter"), True),
            ("PathTolerance", rt.real("I", 0.0, 100000.0, "meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x440D: raise rt.Reject
        raw = iter(_M_SetLocalWaypoint[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        x_ = raw()
        self.x = -100000.0 + x_ * 4.656612874161595e-05
        y_ = raw()
        self.y = -100000.0 + y_ * 4.656612874161595e-05
        self.z = -100000.0 + raw() * 4.656612874161595e-05 if mask & 1 else None
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
        x_ = self.x
        if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
        near = x_ * 21474.836475 + 2147483648.0
        x_raw_ = int(near)
        if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_2)
        raw.append(x_raw_)
        y_ = self.y
        if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
        near = y_ * 21474.836475 + 2147483648.0
        y_raw_ = int(near)
        if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_2)
        raw.append(y_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 1
            if not -100000.0 <= z_ <= 100000.0: raise rt.Reject
            near = z_ * 21474.836475 + 2147483648.0
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_2)
            raw.append(z_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 2
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_3)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_3)
            raw.append(pitch_raw_)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 8
            if not -3.141592653589793 <= yaw_ <= 3.141592653589793: raise rt.Reject
            near = yaw_ * 10430.219195527361 + 32768.0
            yaw_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_raw_ < 0.9999847412109375: yaw_raw_ = rt.exact_raw(yaw_, _R_3)
            raw.append(yaw_raw_)
        waypoint_tolerance_ = self.waypoint_tolerance
        if waypoint_tolerance_ is not None:
            mask |= 16
            if not 0.0 <= waypoint_tolerance_ <= 100.0: raise rt.Reject
            near = waypoint_tolerance_ * 655.35 + 0.5
            waypoint_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - waypoint_tolerance_raw_ < 0.9999847412109375: waypoint_tolerance_raw_ = rt.exact_raw(waypoint_tolerance_, _R_4)
            raw.append(waypoint_tolerance_raw_)
        path_tolerance_ = self.path_tolerance
        if path_tolerance_ is not None:
            mask |= 32
            if not 0.0 <= path_tolerance_ <= 100000.0: raise rt.Reject
            near = path_tolerance_ * 42949.67295 + 0.5
            path_tolerance_raw_ = int(near)
            if not 1.52587890625e-05 < near - path_tolerance_raw_ < 0.9999847412109375: path_tolerance_raw_ = rt.exact_raw(path_tolerance_, _R_5)
            raw.append(path_tolerance_raw_)
        return _M_SetLocalWaypoint_pack[mask & 0x3F].pack(0x440D, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetLocalWaypoint = rt.Masks("3x", ((0, "I"), (0, "I"), (1, "I"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "I")))
_R_2 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_R_3 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_4 = rt.Scaling(0.0, 100.0, 65535)
_R_5 = rt.Scaling(0.0, 100000.0, 4294967295)
_M_SetLocalWaypoint_pack = rt.Masks("HB", ((0, "I"), (0, "I"), (1, "I"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "I")))
QueryTravelSpeed.REPORT = ReportTravelSpeed
QueryLocalWaypoint.REPORT = ReportLocalWaypoint
