"""urn:jaus:jss:mobility:GlobalVectorDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_vector_driver as mobility_v1_0_global_vector_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


class SetGlobalVector(mobility_v1_0_global_vector_driver.SetGlobalVector):
    """SetGlobalVector (0x0407): Sets heading, speed and attitude on the globe."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class SetGlobalVectorExt(rt.Message):
    """SetGlobalVectorExt (0x04A7): Sets heading, attitude and one of several kinds of speed on the globe.

    speed: Wanted speed, and its kind
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is true north
    course: -3.14159265359..3.14159265359 radian, optional. Wanted direction of travel, in radians; 0 is true north
    """

    CODE = 0x04A7
    NAME = "SetGlobalVectorExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    Speed = mobility_v1_0_types.Speed
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition

    speed: mobility_v1_0_types.Speed
    z_position: mobility_v1_0_types.GlobalZPosition | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    course: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", mobility_v1_0_types.Speed.layout()),
            ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Course", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xA7 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        self.speed, at = mobility_v1_0_types.Speed._read(data, at, nesting)
        if mask & 1:
            self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetGlobalVectorExt_2[mask & 0x1E]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.reserved_presence = mask & 0xE0
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xa7\x04")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        speed_ = self.speed
        if type(speed_) is not mobility_v1_0_types.Speed: raise rt.Reject
        speed_._write(out)
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
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_1)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_1)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 8
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_1)
            raw.append(heading_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 16
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_1)
            raw.append(course_raw_)
        out += _M_SetGlobalVectorExt_2[mask & 0x1E].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


class QueryGlobalVector(mobility_v1_0_global_vector_driver.QueryGlobalVector):
    """QueryGlobalVector (0x2407): Asks for the commanded heading, speed and attitude on the globe."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportGlobalVector]]


@dataclass(slots=True, repr=False)
class QueryGlobalVectorExt(rt.Message):
    """QueryGlobalVectorExt (0x24A7): Asks for the commanded vector on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24A7
    NAME = "QueryGlobalVectorExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalVectorExt]]

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
        if code != 0x24A7: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x24A7, self.presence_vector)


class ReportGlobalVector(mobility_v1_0_global_vector_driver.ReportGlobalVector):
    """ReportGlobalVector (0x4407): Tells the commanded heading, speed and attitude on the globe."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportGlobalVectorExt(rt.Message):
    """ReportGlobalVectorExt (0x44A7): Tells the commanded vector on the globe, with the kind of speed.

    speed: Wanted speed, and its kind
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is true north
    course: -3.14159265359..3.14159265359 radian, optional. Wanted direction of travel, in radians; 0 is true north
    """

    CODE = 0x44A7
    NAME = "ReportGlobalVectorExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalVectorDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    Speed = mobility_v1_0_types.Speed
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition

    speed: mobility_v1_0_types.Speed
    z_position: mobility_v1_0_types.GlobalZPosition | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    course: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", mobility_v1_0_types.Speed.layout()),
            ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Course", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xA7 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        self.speed, at = mobility_v1_0_types.Speed._read(data, at, nesting)
        if mask & 1:
            self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetGlobalVectorExt_2[mask & 0x1E]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.reserved_presence = mask & 0xE0
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xa7\x44")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        speed_ = self.speed
        if type(speed_) is not mobility_v1_0_types.Speed: raise rt.Reject
        speed_._write(out)
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
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_1)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 4
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_1)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 8
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_1)
            raw.append(heading_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 16
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_1)
            raw.append(course_raw_)
        out += _M_SetGlobalVectorExt_2[mask & 0x1E].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_M_SetGlobalVectorExt_2 = rt.Masks("", ((2, "H"), (4, "H"), (8, "H"), (16, "H")))
_R_1 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_S_B = rt.Packer("<B")
_S_2H = rt.Packer("<2H")
QueryGlobalVector.REPORT = ReportGlobalVector
QueryGlobalVectorExt.REPORT = ReportGlobalVectorExt
