"""urn:jaus:jss:mobility:PrimitiveDriver 1.1. Generated from schemas/; do not edit."""

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

    CODE: ClassVar[int] = 0x0405
    NAME: ClassVar[str] = "SetWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

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
        return rt.Composite(
            cls,
            (
                rt.Slot("propulsive_linear_effort_x", "PropulsiveLinearEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_y", "PropulsiveLinearEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_z", "PropulsiveLinearEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_x", "PropulsiveRotationalEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_y", "PropulsiveRotationalEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_z", "PropulsiveRotationalEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_x", "ResistiveLinearEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_y", "ResistiveLinearEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_z", "ResistiveLinearEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_x", "ResistiveRotationalEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_y", "ResistiveRotationalEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_z", "ResistiveRotationalEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x0405:
            raise rt.Reject
        raw = iter(_M_SetWrenchEffort[mask & 0xFFF].unpack(data)).__next__
        propulsive_linear_effort_x_ = -100.0 + raw() * 0.0030518043793392844 if mask & 1 else None
        propulsive_linear_effort_y_ = -100.0 + raw() * 0.0030518043793392844 if mask & 2 else None
        propulsive_linear_effort_z_ = -100.0 + raw() * 0.0030518043793392844 if mask & 4 else None
        propulsive_rotational_effort_x_ = -100.0 + raw() * 0.0030518043793392844 if mask & 8 else None
        propulsive_rotational_effort_y_ = -100.0 + raw() * 0.0030518043793392844 if mask & 16 else None
        propulsive_rotational_effort_z_ = -100.0 + raw() * 0.0030518043793392844 if mask & 32 else None
        resistive_linear_effort_x_ = raw() * 0.39215686274509803 if mask & 64 else None
        resistive_linear_effort_y_ = raw() * 0.39215686274509803 if mask & 128 else None
        resistive_linear_effort_z_ = raw() * 0.39215686274509803 if mask & 256 else None
        resistive_rotational_effort_x_ = raw() * 0.39215686274509803 if mask & 512 else None
        resistive_rotational_effort_y_ = raw() * 0.39215686274509803 if mask & 1024 else None
        resistive_rotational_effort_z_ = raw() * 0.39215686274509803 if mask & 2048 else None
        return cls(propulsive_linear_effort_x_, propulsive_linear_effort_y_, propulsive_linear_effort_z_, propulsive_rotational_effort_x_, propulsive_rotational_effort_y_, propulsive_rotational_effort_z_, resistive_linear_effort_x_, resistive_linear_effort_y_, resistive_linear_effort_z_, resistive_rotational_effort_x_, resistive_rotational_effort_y_, resistive_rotational_effort_z_, mask & 0xF000)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xFFF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        propulsive_linear_effort_x_ = self.propulsive_linear_effort_x
        if propulsive_linear_effort_x_ is not None:
            mask |= 1
            if not -100.0 <= propulsive_linear_effort_x_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_x_pos = (propulsive_linear_effort_x_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_x_raw = int(propulsive_linear_effort_x_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_x_pos - propulsive_linear_effort_x_raw < 0.9999847412109375:
                propulsive_linear_effort_x_raw = rt.exact_raw(propulsive_linear_effort_x_, _R_2)
            raw.append(propulsive_linear_effort_x_raw)
        propulsive_linear_effort_y_ = self.propulsive_linear_effort_y
        if propulsive_linear_effort_y_ is not None:
            mask |= 2
            if not -100.0 <= propulsive_linear_effort_y_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_y_pos = (propulsive_linear_effort_y_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_y_raw = int(propulsive_linear_effort_y_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_y_pos - propulsive_linear_effort_y_raw < 0.9999847412109375:
                propulsive_linear_effort_y_raw = rt.exact_raw(propulsive_linear_effort_y_, _R_2)
            raw.append(propulsive_linear_effort_y_raw)
        propulsive_linear_effort_z_ = self.propulsive_linear_effort_z
        if propulsive_linear_effort_z_ is not None:
            mask |= 4
            if not -100.0 <= propulsive_linear_effort_z_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_z_pos = (propulsive_linear_effort_z_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_z_raw = int(propulsive_linear_effort_z_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_z_pos - propulsive_linear_effort_z_raw < 0.9999847412109375:
                propulsive_linear_effort_z_raw = rt.exact_raw(propulsive_linear_effort_z_, _R_2)
            raw.append(propulsive_linear_effort_z_raw)
        propulsive_rotational_effort_x_ = self.propulsive_rotational_effort_x
        if propulsive_rotational_effort_x_ is not None:
            mask |= 8
            if not -100.0 <= propulsive_rotational_effort_x_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_x_pos = (propulsive_rotational_effort_x_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_x_raw = int(propulsive_rotational_effort_x_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_x_pos - propulsive_rotational_effort_x_raw < 0.9999847412109375:
                propulsive_rotational_effort_x_raw = rt.exact_raw(propulsive_rotational_effort_x_, _R_2)
            raw.append(propulsive_rotational_effort_x_raw)
        propulsive_rotational_effort_y_ = self.propulsive_rotational_effort_y
        if propulsive_rotational_effort_y_ is not None:
            mask |= 16
            if not -100.0 <= propulsive_rotational_effort_y_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_y_pos = (propulsive_rotational_effort_y_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_y_raw = int(propulsive_rotational_effort_y_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_y_pos - propulsive_rotational_effort_y_raw < 0.9999847412109375:
                propulsive_rotational_effort_y_raw = rt.exact_raw(propulsive_rotational_effort_y_, _R_2)
            raw.append(propulsive_rotational_effort_y_raw)
        propulsive_rotational_effort_z_ = self.propulsive_rotational_effort_z
        if propulsive_rotational_effort_z_ is not None:
            mask |= 32
            if not -100.0 <= propulsive_rotational_effort_z_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_z_pos = (propulsive_rotational_effort_z_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_z_raw = int(propulsive_rotational_effort_z_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_z_pos - propulsive_rotational_effort_z_raw < 0.9999847412109375:
                propulsive_rotational_effort_z_raw = rt.exact_raw(propulsive_rotational_effort_z_, _R_2)
            raw.append(propulsive_rotational_effort_z_raw)
        resistive_linear_effort_x_ = self.resistive_linear_effort_x
        if resistive_linear_effort_x_ is not None:
            mask |= 64
            if not 0.0 <= resistive_linear_effort_x_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_x_pos = resistive_linear_effort_x_ * 2.55 + 0.5
            resistive_linear_effort_x_raw = int(resistive_linear_effort_x_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_x_pos - resistive_linear_effort_x_raw < 0.9999847412109375:
                resistive_linear_effort_x_raw = rt.exact_raw(resistive_linear_effort_x_, _R_3)
            raw.append(resistive_linear_effort_x_raw)
        resistive_linear_effort_y_ = self.resistive_linear_effort_y
        if resistive_linear_effort_y_ is not None:
            mask |= 128
            if not 0.0 <= resistive_linear_effort_y_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_y_pos = resistive_linear_effort_y_ * 2.55 + 0.5
            resistive_linear_effort_y_raw = int(resistive_linear_effort_y_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_y_pos - resistive_linear_effort_y_raw < 0.9999847412109375:
                resistive_linear_effort_y_raw = rt.exact_raw(resistive_linear_effort_y_, _R_3)
            raw.append(resistive_linear_effort_y_raw)
        resistive_linear_effort_z_ = self.resistive_linear_effort_z
        if resistive_linear_effort_z_ is not None:
            mask |= 256
            if not 0.0 <= resistive_linear_effort_z_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_z_pos = resistive_linear_effort_z_ * 2.55 + 0.5
            resistive_linear_effort_z_raw = int(resistive_linear_effort_z_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_z_pos - resistive_linear_effort_z_raw < 0.9999847412109375:
                resistive_linear_effort_z_raw = rt.exact_raw(resistive_linear_effort_z_, _R_3)
            raw.append(resistive_linear_effort_z_raw)
        resistive_rotational_effort_x_ = self.resistive_rotational_effort_x
        if resistive_rotational_effort_x_ is not None:
            mask |= 512
            if not 0.0 <= resistive_rotational_effort_x_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_x_pos = resistive_rotational_effort_x_ * 2.55 + 0.5
            resistive_rotational_effort_x_raw = int(resistive_rotational_effort_x_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_x_pos - resistive_rotational_effort_x_raw < 0.9999847412109375:
                resistive_rotational_effort_x_raw = rt.exact_raw(resistive_rotational_effort_x_, _R_3)
            raw.append(resistive_rotational_effort_x_raw)
        resistive_rotational_effort_y_ = self.resistive_rotational_effort_y
        if resistive_rotational_effort_y_ is not None:
            mask |= 1024
            if not 0.0 <= resistive_rotational_effort_y_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_y_pos = resistive_rotational_effort_y_ * 2.55 + 0.5
            resistive_rotational_effort_y_raw = int(resistive_rotational_effort_y_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_y_pos - resistive_rotational_effort_y_raw < 0.9999847412109375:
                resistive_rotational_effort_y_raw = rt.exact_raw(resistive_rotational_effort_y_, _R_3)
            raw.append(resistive_rotational_effort_y_raw)
        resistive_rotational_effort_z_ = self.resistive_rotational_effort_z
        if resistive_rotational_effort_z_ is not None:
            mask |= 2048
            if not 0.0 <= resistive_rotational_effort_z_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_z_pos = resistive_rotational_effort_z_ * 2.55 + 0.5
            resistive_rotational_effort_z_raw = int(resistive_rotational_effort_z_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_z_pos - resistive_rotational_effort_z_raw < 0.9999847412109375:
                resistive_rotational_effort_z_raw = rt.exact_raw(resistive_rotational_effort_z_, _R_3)
            raw.append(resistive_rotational_effort_z_raw)
        return _M_SetWrenchEffort_pack[mask & 0xFFF].pack(0x0405, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryWrenchEffort(rt.Message):
    """QueryWrenchEffort (0x2405): Asks for the efforts in use.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2405
    NAME: ClassVar[str] = "QueryWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
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
        if code != 0x2405:
            raise rt.Reject
        return cls(presence_vector_)

    def _pack(self) -> bytes:
        presence_vector_ = self.presence_vector
        return _S_2H.pack(0x2405, presence_vector_)


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

    CODE: ClassVar[int] = 0x4405
    NAME: ClassVar[str] = "ReportWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
        return rt.Composite(
            cls,
            (
                rt.Slot("propulsive_linear_effort_x", "PropulsiveLinearEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_y", "PropulsiveLinearEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_z", "PropulsiveLinearEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_x", "PropulsiveRotationalEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_y", "PropulsiveRotationalEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_z", "PropulsiveRotationalEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_x", "ResistiveLinearEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_y", "ResistiveLinearEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_z", "ResistiveLinearEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_x", "ResistiveRotationalEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_y", "ResistiveRotationalEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_z", "ResistiveRotationalEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4405:
            raise rt.Reject
        raw = iter(_M_SetWrenchEffort[mask & 0xFFF].unpack(data)).__next__
        propulsive_linear_effort_x_ = -100.0 + raw() * 0.0030518043793392844 if mask & 1 else None
        propulsive_linear_effort_y_ = -100.0 + raw() * 0.0030518043793392844 if mask & 2 else None
        propulsive_linear_effort_z_ = -100.0 + raw() * 0.0030518043793392844 if mask & 4 else None
        propulsive_rotational_effort_x_ = -100.0 + raw() * 0.0030518043793392844 if mask & 8 else None
        propulsive_rotational_effort_y_ = -100.0 + raw() * 0.0030518043793392844 if mask & 16 else None
        propulsive_rotational_effort_z_ = -100.0 + raw() * 0.0030518043793392844 if mask & 32 else None
        resistive_linear_effort_x_ = raw() * 0.39215686274509803 if mask & 64 else None
        resistive_linear_effort_y_ = raw() * 0.39215686274509803 if mask & 128 else None
        resistive_linear_effort_z_ = raw() * 0.39215686274509803 if mask & 256 else None
        resistive_rotational_effort_x_ = raw() * 0.39215686274509803 if mask & 512 else None
        resistive_rotational_effort_y_ = raw() * 0.39215686274509803 if mask & 1024 else None
        resistive_rotational_effort_z_ = raw() * 0.39215686274509803 if mask & 2048 else None
        return cls(propulsive_linear_effort_x_, propulsive_linear_effort_y_, propulsive_linear_effort_z_, propulsive_rotational_effort_x_, propulsive_rotational_effort_y_, propulsive_rotational_effort_z_, resistive_linear_effort_x_, resistive_linear_effort_y_, resistive_linear_effort_z_, resistive_rotational_effort_x_, resistive_rotational_effort_y_, resistive_rotational_effort_z_, mask & 0xF000)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xFFF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        propulsive_linear_effort_x_ = self.propulsive_linear_effort_x
        if propulsive_linear_effort_x_ is not None:
            mask |= 1
            if not -100.0 <= propulsive_linear_effort_x_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_x_pos = (propulsive_linear_effort_x_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_x_raw = int(propulsive_linear_effort_x_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_x_pos - propulsive_linear_effort_x_raw < 0.9999847412109375:
                propulsive_linear_effort_x_raw = rt.exact_raw(propulsive_linear_effort_x_, _R_2)
            raw.append(propulsive_linear_effort_x_raw)
        propulsive_linear_effort_y_ = self.propulsive_linear_effort_y
        if propulsive_linear_effort_y_ is not None:
            mask |= 2
            if not -100.0 <= propulsive_linear_effort_y_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_y_pos = (propulsive_linear_effort_y_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_y_raw = int(propulsive_linear_effort_y_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_y_pos - propulsive_linear_effort_y_raw < 0.9999847412109375:
                propulsive_linear_effort_y_raw = rt.exact_raw(propulsive_linear_effort_y_, _R_2)
            raw.append(propulsive_linear_effort_y_raw)
        propulsive_linear_effort_z_ = self.propulsive_linear_effort_z
        if propulsive_linear_effort_z_ is not None:
            mask |= 4
            if not -100.0 <= propulsive_linear_effort_z_ <= 100.0:
                raise rt.Reject
            propulsive_linear_effort_z_pos = (propulsive_linear_effort_z_ + 100.0) * 327.675 + 0.5
            propulsive_linear_effort_z_raw = int(propulsive_linear_effort_z_pos)
            if not 1.52587890625e-05 < propulsive_linear_effort_z_pos - propulsive_linear_effort_z_raw < 0.9999847412109375:
                propulsive_linear_effort_z_raw = rt.exact_raw(propulsive_linear_effort_z_, _R_2)
            raw.append(propulsive_linear_effort_z_raw)
        propulsive_rotational_effort_x_ = self.propulsive_rotational_effort_x
        if propulsive_rotational_effort_x_ is not None:
            mask |= 8
            if not -100.0 <= propulsive_rotational_effort_x_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_x_pos = (propulsive_rotational_effort_x_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_x_raw = int(propulsive_rotational_effort_x_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_x_pos - propulsive_rotational_effort_x_raw < 0.9999847412109375:
                propulsive_rotational_effort_x_raw = rt.exact_raw(propulsive_rotational_effort_x_, _R_2)
            raw.append(propulsive_rotational_effort_x_raw)
        propulsive_rotational_effort_y_ = self.propulsive_rotational_effort_y
        if propulsive_rotational_effort_y_ is not None:
            mask |= 16
            if not -100.0 <= propulsive_rotational_effort_y_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_y_pos = (propulsive_rotational_effort_y_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_y_raw = int(propulsive_rotational_effort_y_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_y_pos - propulsive_rotational_effort_y_raw < 0.9999847412109375:
                propulsive_rotational_effort_y_raw = rt.exact_raw(propulsive_rotational_effort_y_, _R_2)
            raw.append(propulsive_rotational_effort_y_raw)
        propulsive_rotational_effort_z_ = self.propulsive_rotational_effort_z
        if propulsive_rotational_effort_z_ is not None:
            mask |= 32
            if not -100.0 <= propulsive_rotational_effort_z_ <= 100.0:
                raise rt.Reject
            propulsive_rotational_effort_z_pos = (propulsive_rotational_effort_z_ + 100.0) * 327.675 + 0.5
            propulsive_rotational_effort_z_raw = int(propulsive_rotational_effort_z_pos)
            if not 1.52587890625e-05 < propulsive_rotational_effort_z_pos - propulsive_rotational_effort_z_raw < 0.9999847412109375:
                propulsive_rotational_effort_z_raw = rt.exact_raw(propulsive_rotational_effort_z_, _R_2)
            raw.append(propulsive_rotational_effort_z_raw)
        resistive_linear_effort_x_ = self.resistive_linear_effort_x
        if resistive_linear_effort_x_ is not None:
            mask |= 64
            if not 0.0 <= resistive_linear_effort_x_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_x_pos = resistive_linear_effort_x_ * 2.55 + 0.5
            resistive_linear_effort_x_raw = int(resistive_linear_effort_x_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_x_pos - resistive_linear_effort_x_raw < 0.9999847412109375:
                resistive_linear_effort_x_raw = rt.exact_raw(resistive_linear_effort_x_, _R_3)
            raw.append(resistive_linear_effort_x_raw)
        resistive_linear_effort_y_ = self.resistive_linear_effort_y
        if resistive_linear_effort_y_ is not None:
            mask |= 128
            if not 0.0 <= resistive_linear_effort_y_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_y_pos = resistive_linear_effort_y_ * 2.55 + 0.5
            resistive_linear_effort_y_raw = int(resistive_linear_effort_y_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_y_pos - resistive_linear_effort_y_raw < 0.9999847412109375:
                resistive_linear_effort_y_raw = rt.exact_raw(resistive_linear_effort_y_, _R_3)
            raw.append(resistive_linear_effort_y_raw)
        resistive_linear_effort_z_ = self.resistive_linear_effort_z
        if resistive_linear_effort_z_ is not None:
            mask |= 256
            if not 0.0 <= resistive_linear_effort_z_ <= 100.0:
                raise rt.Reject
            resistive_linear_effort_z_pos = resistive_linear_effort_z_ * 2.55 + 0.5
            resistive_linear_effort_z_raw = int(resistive_linear_effort_z_pos)
            if not 1.52587890625e-05 < resistive_linear_effort_z_pos - resistive_linear_effort_z_raw < 0.9999847412109375:
                resistive_linear_effort_z_raw = rt.exact_raw(resistive_linear_effort_z_, _R_3)
            raw.append(resistive_linear_effort_z_raw)
        resistive_rotational_effort_x_ = self.resistive_rotational_effort_x
        if resistive_rotational_effort_x_ is not None:
            mask |= 512
            if not 0.0 <= resistive_rotational_effort_x_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_x_pos = resistive_rotational_effort_x_ * 2.55 + 0.5
            resistive_rotational_effort_x_raw = int(resistive_rotational_effort_x_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_x_pos - resistive_rotational_effort_x_raw < 0.9999847412109375:
                resistive_rotational_effort_x_raw = rt.exact_raw(resistive_rotational_effort_x_, _R_3)
            raw.append(resistive_rotational_effort_x_raw)
        resistive_rotational_effort_y_ = self.resistive_rotational_effort_y
        if resistive_rotational_effort_y_ is not None:
            mask |= 1024
            if not 0.0 <= resistive_rotational_effort_y_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_y_pos = resistive_rotational_effort_y_ * 2.55 + 0.5
            resistive_rotational_effort_y_raw = int(resistive_rotational_effort_y_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_y_pos - resistive_rotational_effort_y_raw < 0.9999847412109375:
                resistive_rotational_effort_y_raw = rt.exact_raw(resistive_rotational_effort_y_, _R_3)
            raw.append(resistive_rotational_effort_y_raw)
        resistive_rotational_effort_z_ = self.resistive_rotational_effort_z
        if resistive_rotational_effort_z_ is not None:
            mask |= 2048
            if not 0.0 <= resistive_rotational_effort_z_ <= 100.0:
                raise rt.Reject
            resistive_rotational_effort_z_pos = resistive_rotational_effort_z_ * 2.55 + 0.5
            resistive_rotational_effort_z_raw = int(resistive_rotational_effort_z_pos)
            if not 1.52587890625e-05 < resistive_rotational_effort_z_pos - resistive_rotational_effort_z_raw < 0.9999847412109375:
                resistive_rotational_effort_z_raw = rt.exact_raw(resistive_rotational_effort_z_, _R_3)
            raw.append(resistive_rotational_effort_z_raw)
        return _M_SetWrenchEffort_pack[mask & 0xFFF].pack(0x4405, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_SetWrenchEffort = rt.Masks("4x", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B")))
_R_2 = rt.Scaling(-100.0, 100.0, 65535)
_R_3 = rt.Scaling(0.0, 100.0, 255)
_M_SetWrenchEffort_pack = rt.Masks("HH", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "B"), (128, "B"), (256, "B"), (512, "B"), (1024, "B"), (2048, "B")))
