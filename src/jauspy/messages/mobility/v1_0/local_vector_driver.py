"""urn:jaus:jss:mobility:LocalVectorDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetLocalVector(rt.Message):
    """SetLocalVector (0x0408): Sets heading, speed and attitude in the local frame.

    speed: 0..327.67 meter per second, optional. Wanted speed, in metres per second
    z: -10000..35000 meter, optional. Wanted position along Z of the local frame, in metres
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is along X
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    """

    CODE = 0x0408
    NAME = "SetLocalVector"
    SERVICE = "urn:jaus:jss:mobility:LocalVectorDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    speed: float | None = None
    z: float | None = None
    heading: float | None = None
    roll: float | None = None
    pitch: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", rt.real("H", 0.0, 327.67, "meter per second"), True),
            ("Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0408: raise rt.Reject
        raw = iter(_M_SetLocalVector[mask & 0x1F].unpack(data)).__next__
        self = rt.new(cls)
        self.speed = raw() * 0.0049999237048905165 if mask & 1 else None
        self.z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.reserved_presence = mask & 0xE0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        raw: list[int | float | bytes] = []
        speed_ = self.speed
        if speed_ is not None:
            mask |= 1
            if not 0.0 <= speed_ <= 327.67: raise rt.Reject
            near = speed_ * 200.0030518509476 + 0.5
            speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_2)
            raw.append(speed_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 2
            if not -10000.0 <= z_ <= 35000.0: raise rt.Reject
            near = z_ * 95443.71766666666 + 954437177.1666666
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_3)
            raw.append(z_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 4
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 8
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 16
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        return _M_SetLocalVector_pack[mask & 0x1F].pack(0x0408, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryLocalVector(rt.Message):
    """QueryLocalVector (0x2408): Asks for the commanded heading, speed and attitude in the local frame.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2408
    NAME = "QueryLocalVector"
    SERVICE = "urn:jaus:jss:mobility:LocalVectorDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalVector]]

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
        if code != 0x2408: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2408, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportLocalVector(rt.Message):
    """ReportLocalVector (0x4408): Tells the commanded heading, speed and attitude in the local frame.

    speed: 0..327.67 meter per second, optional. Wanted speed, in metres per second
    z: -10000..35000 meter, optional. Wanted position along Z of the local frame, in metres
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is along X
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    """

    CODE = 0x4408
    NAME = "ReportLocalVector"
    SERVICE = "urn:jaus:jss:mobility:LocalVectorDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    speed: float | None = None
    z: float | None = None
    heading: float | None = None
    roll: float | None = None
    pitch: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Speed", rt.real("H", 0.0, 327.67, "meter per second"), True),
            ("Z", rt.real("I", -10000.0, 35000.0, "meter"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4408: raise rt.Reject
        raw = iter(_M_SetLocalVector[mask & 0x1F].unpack(data)).__next__
        self = rt.new(cls)
        self.speed = raw() * 0.0049999237048905165 if mask & 1 else None
        self.z = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 2 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 16 else None
        self.reserved_presence = mask & 0xE0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1F: raise rt.Reject
        raw: list[int | float | bytes] = []
        speed_ = self.speed
        if speed_ is not None:
            mask |= 1
            if not 0.0 <= speed_ <= 327.67: raise rt.Reject
            near = speed_ * 200.0030518509476 + 0.5
            speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_raw_ < 0.9999847412109375: speed_raw_ = rt.exact_raw(speed_, _R_2)
            raw.append(speed_raw_)
        z_ = self.z
        if z_ is not None:
            mask |= 2
            if not -10000.0 <= z_ <= 35000.0: raise rt.Reject
            near = z_ * 95443.71766666666 + 954437177.1666666
            z_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_raw_ < 0.9999847412109375: z_raw_ = rt.exact_raw(z_, _R_3)
            raw.append(z_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 4
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_4)
            raw.append(heading_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 8
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_4)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 16
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_4)
            raw.append(pitch_raw_)
        return _M_SetLocalVector_pack[mask & 0x1F].pack(0x4408, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetLocalVector = rt.Masks("3x", ((1, "H"), (2, "I"), (4, "H"), (8, "H"), (16, "H")))
_R_2 = rt.Scaling(0.0, 327.67, 65535)
_R_3 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_R_4 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_M_SetLocalVector_pack = rt.Masks("HB", ((1, "H"), (2, "I"), (4, "H"), (8, "H"), (16, "H")))
QueryLocalVector.REPORT = ReportLocalVector
