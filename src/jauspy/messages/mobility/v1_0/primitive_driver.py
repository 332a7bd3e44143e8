"""urn:jaus:jss:mobility:PrimitiveDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetWrenchEffort(rt.Message):
    """SetWrenchEffort (0x0405): Sets propulsive and resistive efforts.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """

    CODE = 0x0405
    NAME = "SetWrenchEffort"
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    propulsive_linear_effort_x: float | None = None
    propulsive_linear_effort_y: float | None = None
    propulsive_linear_effort_z: float | None = None
    propulsive_rotational_effort_x: float | None = None
    propulsive_rotational_effort_y: float | None = None
    propulsive_rotational_effort_z: float | None = None
    resistive_linear_effort_x: float | None = None
    resistive_linear_effort_y: float | None = None
    resistive_linear_effort_z: float | None = None
    resistive_rotational_effort_x: float | None = None
    resistive_rotational_effort_y: float | None = None
    resistive_rotational_effort_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("PropulsiveLinearEffortX", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveLinearEffortY", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveLinearEffortZ", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortX", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortY", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortZ", rt.real("H", -100.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortX", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortY", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortZ", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortX", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortY", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortZ", rt.real("B", 0.0, 100.0, "percent"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x0405: raise rt.Reject
        raw = iter(_M_SetWrenchEffort[mask & 0xFFF].unpack(data)).__next__
        self = rt.new(cls)
        self.propulsive_linear_effort_x = -100.0 + raw() * 0.0030518043793392844 if mask & 1 else None
        self.propulsive_linear_effort_y = -100.0 + raw() * 0.0030518043793392844 if mask & 2 else None
        self.propulsive_linear_effort_z = -100.0 + raw() * 0.0030518043793392844 if mask & 4 else None
        self.propulsive_rotational_effort_x = -100.0 + raw() * 0.0030518043793392844 if mask & 8 else None
        self.propulsive_rotational_effort_y = -100.0 + raw() * 0.0030518043793392844 if mask & 16 else None
        self.propulsive_rotational_effort_z = -100.0 + raw() * 0.0030518043793392844 if mask & 32 else None
        self.resistive_linear_effort_x = raw() * 0.39215686274509803 if mask & 64 else None
        self.resistive_linear_effort_y = raw() * 0.39215686274509803 if mask & 128 else None
        self.resistive_linear_effort_z = raw() * 0.39215686274509803 if mask & 256 else None
        self.resistive_rotational_effort_x = raw() * 0.39215686274509803 if mask & 512 else None
        self.resistive_rotational_effort_y = raw() * 0.39215686274509803 if mask & 1024 else None
        self.resistive_rotational_effort_z = raw() * 0.39215686274509803 if mask & 2048 else None
        self.reserved_presence = mask & 0xF000
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xFFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        propulsive_linear_effort_x_ = self.propulsive_linear_effort_x
        if propulsive_linear_effort_x_ is not None:
            mask |= 1
            if not -100.0 <= propulsive_linear_effort_x_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_x_ * 327.675 + 32768.0
            propulsive_linear_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_x_raw_ < 0.9999847412109375: propulsive_linear_effort_x_raw_ = rt.exact_raw(propulsive_linear_effort_x_, _R_2)
            raw.append(propulsive_linear_effort_x_raw_)
        propulsive_linear_effort_y_ = self.propulsive_linear_effort_y
        if propulsive_linear_effort_y_ is not None:
            mask |= 2
            if not -100.0 <= propulsive_linear_effort_y_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_y_ * 327.675 + 32768.0
            propulsive_linear_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_y_raw_ < 0.9999847412109375: propulsive_linear_effort_y_raw_ = rt.exact_raw(propulsive_linear_effort_y_, _R_2)
            raw.append(propulsive_linear_effort_y_raw_)
        propulsive_linear_effort_z_ = self.propulsive_linear_effort_z
        if propulsive_linear_effort_z_ is not None:
            mask |= 4
            if not -100.0 <= propulsive_linear_effort_z_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_z_ * 327.675 + 32768.0
            propulsive_linear_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_z_raw_ < 0.9999847412109375: propulsive_linear_effort_z_raw_ = rt.exact_raw(propulsive_linear_effort_z_, _R_2)
            raw.append(propulsive_linear_effort_z_raw_)
        propulsive_rotational_effort_x_ = self.propulsive_rotational_effort_x
        if propulsive_rotational_effort_x_ is not None:
            mask |= 8
            if not -100.0 <= propulsive_rotational_effort_x_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_x_ * 327.675 + 32768.0
            propulsive_rotational_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_x_raw_ < 0.9999847412109375: propulsive_rotational_effort_x_raw_ = rt.exact_raw(propulsive_rotational_effort_x_, _R_2)
            raw.append(propulsive_rotational_effort_x_raw_)
        propulsive_rotational_effort_y_ = self.propulsive_rotational_effort_y
        if propulsive_rotational_effort_y_ is not None:
            mask |= 16
            if not -100.0 <= propulsive_rotational_effort_y_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_y_ * 327.675 + 32768.0
            propulsive_rotational_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_y_raw_ < 0.9999847412109375: propulsive_rotational_effort_y_raw_ = rt.exact_raw(propulsive_rotational_effort_y_, _R_2)
            raw.append(propulsive_rotational_effort_y_raw_)
        propulsive_rotational_effort_z_ = self.propulsive_rotational_effort_z
        if propulsive_rotational_effort_z_ is not None:
            mask |= 32
            if not -100.0 <= propulsive_rotational_effort_z_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_z_ * 327.675 + 32768.0
            propulsive_rotational_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_z_raw_ < 0.9999847412109375: propulsive_rotational_effort_z_raw_ = rt.exact_raw(propulsive_rotational_effort_z_, _R_2)
            raw.append(propulsive_rotational_effort_z_raw_)
        resistive_linear_effort_x_ = self.resistive_linear_effort_x
        if resistive_linear_effort_x_ is not None:
            mask |= 64
            if not 0.0 <= resistive_linear_effort_x_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_x_ * 2.55 + 0.5
            resistive_linear_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_x_raw_ < 0.9999847412109375: resistive_linear_effort_x_raw_ = rt.exact_raw(resistive_linear_effort_x_, _R_3)
            raw.append(resistive_linear_effort_x_raw_)
        resistive_linear_effort_y_ = self.resistive_linear_effort_y
        if resistive_linear_effort_y_ is not None:
            mask |= 128
            if not 0.0 <= resistive_linear_effort_y_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_y_ * 2.55 + 0.5
            resistive_linear_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_y_raw_ < 0.9999847412109375: resistive_linear_effort_y_raw_ = rt.exact_raw(resistive_linear_effort_y_, _R_3)
            raw.append(resistive_linear_effort_y_raw_)
        resistive_linear_effort_z_ = self.resistive_linear_effort_z
        if resistive_linear_effort_z_ is not None:
            mask |= 256
            if not 0.0 <= resistive_linear_effort_z_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_z_ * 2.55 + 0.5
            resistive_linear_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_z_raw_ < 0.9999847412109375: resistive_linear_effort_z_raw_ = rt.exact_raw(resistive_linear_effort_z_, _R_3)
            raw.append(resistive_linear_effort_z_raw_)
        resistive_rotational_effort_x_ = self.resistive_rotational_effort_x
        if resistive_rotational_effort_x_ is not None:
            mask |= 512
            if not 0.0 <= resistive_rotational_effort_x_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_x_ * 2.55 + 0.5
            resistive_rotational_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_x_raw_ < 0.9999847412109375: resistive_rotational_effort_x_raw_ = rt.exact_raw(resistive_rotational_effort_x_, _R_3)
            raw.append(resistive_rotational_effort_x_raw_)
        resistive_rotational_effort_y_ = self.resistive_rotational_effort_y
        if resistive_rotational_effort_y_ is not None:
            mask |= 1024
            if not 0.0 <= resistive_rotational_effort_y_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_y_ * 2.55 + 0.5
            resistive_rotational_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_y_raw_ < 0.9999847412109375: resistive_rotational_effort_y_raw_ = rt.exact_raw(resistive_rotational_effort_y_, _R_3)
            raw.append(resistive_rotational_effort_y_raw_)
        resistive_rotational_effort_z_ = self.resistive_rotational_effort_z
        if resistive_rotational_effort_z_ is not None:
            mask |= 2048
            if not 0.0 <= resistive_rotational_effort_z_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_z_ * 2.55 + 0.5
            resistive_rotational_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_z_raw_ < 0.9999847412109375: resistive_rotational_effort_z_raw_ = rt.exact_raw(resistive_rotational_effort_z_, _R_3)
            raw.append(resistive_rotational_effort_z_raw_)
        return _M_SetWrenchEffort_pack[mask & 0xFFF].pack(0x0405, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryWrenchEffort(rt.Message):
    """QueryWrenchEffort (0x2405): Asks for the efforts in use.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2405
    NAME = "QueryWrenchEffort"
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportWrenchEffort]]

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
        if code != 0x2405: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2405, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportWrenchEffort(rt.Message):
    """ReportWrenchEffort (0x4405): Tells the efforts in use.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """

    CODE = 0x4405
    NAME = "ReportWrenchEffort"
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    propulsive_linear_effort_x: float | None = None
    propulsive_linear_effort_y: float | None = None
    propulsive_linear_effort_z: float | None = None
    propulsive_rotational_effort_x: float | None = None
    propulsive_rotational_effort_y: float | None = None
    propulsive_rotational_effort_z: float | None = None
    resistive_linear_effort_x: float | None = None
    resistive_linear_effort_y: float | None = None
    resistive_linear_effort_z: float | None = None
    resistive_rotational_effort_x: float | None = None
    resistive_rotational_effort_y: float | None = None
    resistive_rotational_effort_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("PropulsiveLinearEffortX", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveLinearEffortY", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveLinearEffortZ", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortX", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortY", rt.real("H", -100.0, 100.0, "percent"), True),
            ("PropulsiveRotationalEffortZ", rt.real("H", -100.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortX", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortY", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveLinearEffortZ", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortX", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortY", rt.real("B", 0.0, 100.0, "percent"), True),
            ("ResistiveRotationalEffortZ", rt.real("B", 0.0, 100.0, "percent"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4405: raise rt.Reject
        raw = iter(_M_SetWrenchEffort[mask & 0xFFF].unpack(data)).__next__
        self = rt.new(cls)
        self.propulsive_linear_effort_x = -100.0 + raw() * 0.0030518043793392844 if mask & 1 else None
        self.propulsive_linear_effort_y = -100.0 + raw() * 0.0030518043793392844 if mask & 2 else None
        self.propulsive_linear_effort_z = -100.0 + raw() * 0.0030518043793392844 if mask & 4 else None
        self.propulsive_rotational_effort_x = -100.0 + raw() * 0.0030518043793392844 if mask & 8 else None
        self.propulsive_rotational_effort_y = -100.0 + raw() * 0.0030518043793392844 if mask & 16 else None
        self.propulsive_rotational_effort_z = -100.0 + raw() * 0.0030518043793392844 if mask & 32 else None
        self.resistive_linear_effort_x = raw() * 0.39215686274509803 if mask & 64 else None
        self.resistive_linear_effort_y = raw() * 0.39215686274509803 if mask & 128 else None
        self.resistive_linear_effort_z = raw() * 0.39215686274509803 if mask & 256 else None
        self.resistive_rotational_effort_x = raw() * 0.39215686274509803 if mask & 512 else None
        self.resistive_rotational_effort_y = raw() * 0.39215686274509803 if mask & 1024 else None
        self.resistive_rotational_effort_z = raw() * 0.39215686274509803 if mask & 2048 else None
        self.reserved_presence = mask & 0xF000
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xFFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        propulsive_linear_effort_x_ = self.propulsive_linear_effort_x
        if propulsive_linear_effort_x_ is not None:
            mask |= 1
            if not -100.0 <= propulsive_linear_effort_x_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_x_ * 327.675 + 32768.0
            propulsive_linear_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_x_raw_ < 0.9999847412109375: propulsive_linear_effort_x_raw_ = rt.exact_raw(propulsive_linear_effort_x_, _R_2)
            raw.append(propulsive_linear_effort_x_raw_)
        propulsive_linear_effort_y_ = self.propulsive_linear_effort_y
        if propulsive_linear_effort_y_ is not None:
            mask |= 2
            if not -100.0 <= propulsive_linear_effort_y_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_y_ * 327.675 + 32768.0
            propulsive_linear_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_y_raw_ < 0.9999847412109375: propulsive_linear_effort_y_raw_ = rt.exact_raw(propulsive_linear_effort_y_, _R_2)
            raw.append(propulsive_linear_effort_y_raw_)
        propulsive_linear_effort_z_ = self.propulsive_linear_effort_z
        if propulsive_linear_effort_z_ is not None:
            mask |= 4
            if not -100.0 <= propulsive_linear_effort_z_ <= 100.0: raise rt.Reject
            near = propulsive_linear_effort_z_ * 327.675 + 32768.0
            propulsive_linear_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_linear_effort_z_raw_ < 0.9999847412109375: propulsive_linear_effort_z_raw_ = rt.exact_raw(propulsive_linear_effort_z_, _R_2)
            raw.append(propulsive_linear_effort_z_raw_)
        propulsive_rotational_effort_x_ = self.propulsive_rotational_effort_x
        if propulsive_rotational_effort_x_ is not None:
            mask |= 8
            if not -100.0 <= propulsive_rotational_effort_x_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_x_ * 327.675 + 32768.0
            propulsive_rotational_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_x_raw_ < 0.9999847412109375: propulsive_rotational_effort_x_raw_ = rt.exact_raw(propulsive_rotational_effort_x_, _R_2)
            raw.append(propulsive_rotational_effort_x_raw_)
        propulsive_rotational_effort_y_ = self.propulsive_rotational_effort_y
        if propulsive_rotational_effort_y_ is not None:
            mask |= 16
            if not -100.0 <= propulsive_rotational_effort_y_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_y_ * 327.675 + 32768.0
            propulsive_rotational_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_y_raw_ < 0.9999847412109375: propulsive_rotational_effort_y_raw_ = rt.exact_raw(propulsive_rotational_effort_y_, _R_2)
            raw.append(propulsive_rotational_effort_y_raw_)
        propulsive_rotational_effort_z_ = self.propulsive_rotational_effort_z
        if propulsive_rotational_effort_z_ is not None:
            mask |= 32
            if not -100.0 <= propulsive_rotational_effort_z_ <= 100.0: raise rt.Reject
            near = propulsive_rotational_effort_z_ * 327.675 + 32768.0
            propulsive_rotational_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - propulsive_rotational_effort_z_raw_ < 0.9999847412109375: propulsive_rotational_effort_z_raw_ = rt.exact_raw(propulsive_rotational_effort_z_, _R_2)
            raw.append(propulsive_rotational_effort_z_raw_)
        resistive_linear_effort_x_ = self.resistive_linear_effort_x
        if resistive_linear_effort_x_ is not None:
            mask |= 64
            if not 0.0 <= resistive_linear_effort_x_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_x_ * 2.55 + 0.5
            resistive_linear_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_x_raw_ < 0.9999847412109375: resistive_linear_effort_x_raw_ = rt.exact_raw(resistive_linear_effort_x_, _R_3)
            raw.append(resistive_linear_effort_x_raw_)
        resistive_linear_effort_y_ = self.resistive_linear_effort_y
        if resistive_linear_effort_y_ is not None:
            mask |= 128
            if not 0.0 <= resistive_linear_effort_y_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_y_ * 2.55 + 0.5
            resistive_linear_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_y_raw_ < 0.9999847412109375: resistive_linear_effort_y_raw_ = rt.exact_raw(resistive_linear_effort_y_, _R_3)
            raw.append(resistive_linear_effort_y_raw_)
        resistive_linear_effort_z_ = self.resistive_linear_effort_z
        if resistive_linear_effort_z_ is not None:
            mask |= 256
            if not 0.0 <= resistive_linear_effort_z_ <= 100.0: raise rt.Reject
            near = resistive_linear_effort_z_ * 2.55 + 0.5
            resistive_linear_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_linear_effort_z_raw_ < 0.9999847412109375: resistive_linear_effort_z_raw_ = rt.exact_raw(resistive_linear_effort_z_, _R_3)
            raw.append(resistive_linear_effort_z_raw_)
        resistive_rotational_effort_x_ = self.resistive_rotational_effort_x
        if resistive_rotational_effort_x_ is not None:
            mask |= 512
            if not 0.0 <= resistive_rotational_effort_x_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_x_ * 2.55 + 0.5
            resistive_rotational_effort_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_x_raw_ < 0.9999847412109375: resistive_rotational_effort_x_raw_ = rt.exact_raw(resistive_rotational_effort_x_, _R_3)
            raw.append(resistive_rotational_effort_x_raw_)
        resistive_rotational_effort_y_ = self.resistive_rotational_effort_y
        if resistive_rotational_effort_y_ is not None:
            mask |= 1024
            if not 0.0 <= resistive_rotational_effort_y_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_y_ * 2.55 + 0.5
            resistive_rotational_effort_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_y_raw_ < 0.9999847412109375: resistive_rotational_effort_y_raw_ = rt.exact_raw(resistive_rotational_effort_y_, _R_3)
            raw.append(resistive_rotational_effort_y_raw_)
        resistive_rotational_effort_z_ = self.resistive_rotational_effort_z
        if resistive_rotational_effort_z_ is not None:
            mask |= 2048
            if not 0.0 <= resistive_rotational_effort_z_ <= 100.0: raise rt.Reject
            near = resistive_rotational_effort_z_ * 2.55 + 0.5
            resistive_rotational_effort_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - resistive_rotational_effort_z_raw_ < 0.9999847412109375: resistive_rotational_effort_z_raw_ = rt.exact_raw(resistive_rotational_effort_z_, _R_3)
            raw.append(resistive_rotational_effort_z_raw_)
        return _M_SetWrenchEffort_pack[mask & 0xFFF].pack(0x4405, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_SetWrenchEffort = rt.Masks("4x", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B")))
_R_2 = rt.Scaling(-100.0, 100.0, 65535)
_R_3 = rt.Scaling(0.0, 100.0, 255)
_M_SetWrenchEffort_pack = rt.Masks("HH", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B")))
QueryWrenchEffort.REPORT = ReportWrenchEffort
