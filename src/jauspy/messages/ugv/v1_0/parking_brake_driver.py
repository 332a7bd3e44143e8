"""urn:jaus:jss:ugv:ParkingBrakeDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetParkingBrake(rt.Message):
    """SetParkingBrake (0x0512): Sets the parking brake.

    parking_brake: 0..100. Wanted braking, in percent of the maximum; 0 is released
    """

    CODE = 0x0512
    NAME = "SetParkingBrake"
    SERVICE = "urn:jaus:jss:ugv:ParkingBrakeDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    parking_brake: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("parkingBrake", rt.real("B", 0.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, parking_brake_ = _S_HB.unpack(data)
        if code != 0x0512: raise rt.Reject
        self.parking_brake = parking_brake_ * 0.39215686274509803
        return self

    def _pack(self) -> bytes:
        parking_brake_ = self.parking_brake
        if not 0.0 <= parking_brake_ <= 100.0: raise rt.Reject
        near = parking_brake_ * 2.55 + 0.5
        parking_brake_raw_ = int(near)
        if not 1.52587890625e-05 < near - parking_brake_raw_ < 0.9999847412109375: parking_brake_raw_ = rt.exact_raw(parking_brake_, _R_1)
        return _S_HB.pack(0x0512, parking_brake_raw_)


@dataclass(slots=True, repr=False)
class QueryParkingBrake(rt.Message):
    """QueryParkingBrake (0x2512): Asks for the parking brake."""

    CODE = 0x2512
    NAME = "QueryParkingBrake"
    SERVICE = "urn:jaus:jss:ugv:ParkingBrakeDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportParkingBrake]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x12%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2512)


@dataclass(slots=True, repr=False)
class ReportParkingBrake(rt.Message):
    """ReportParkingBrake (0x4512): Tells the commanded and the actual parking brake.

    commanded_parking_brake: 0..100. Wanted braking, in percent of the maximum
    actual_parking_brake: 0..100. Present braking, in percent of the maximum
    """

    CODE = 0x4512
    NAME = "ReportParkingBrake"
    SERVICE = "urn:jaus:jss:ugv:ParkingBrakeDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    commanded_parking_brake: float
    actual_parking_brake: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("commandedParkingBrake", rt.real("B", 0.0, 100.0)),
            ("actualParkingBrake", rt.real("B", 0.0, 100.0)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, commanded_parking_brake_, actual_parking_brake_ = _S_H2B.unpack(data)
        if code != 0x4512: raise rt.Reject
        self.commanded_parking_brake = commanded_parking_brake_ * 0.39215686274509803
        self.actual_parking_brake = actual_parking_brake_ * 0.39215686274509803
        return self

    def _pack(self) -> bytes:
        commanded_parking_brake_ = self.commanded_parking_brake
        if not 0.0 <= commanded_parking_brake_ <= 100.0: raise rt.Reject
        near = commanded_parking_brake_ * 2.55 + 0.5
        commanded_parking_brake_raw_ = int(near)
        if not 1.52587890625e-05 < near - commanded_parking_brake_raw_ < 0.9999847412109375: commanded_parking_brake_raw_ = rt.exact_raw(commanded_parking_brake_, _R_1)
        actual_parking_brake_ = self.actual_parking_brake
        if not 0.0 <= actual_parking_brake_ <= 100.0: raise rt.Reject
        near = actual_parking_brake_ * 2.55 + 0.5
        actual_parking_brake_raw_ = int(near)
        if not 1.52587890625e-05 < near - actual_parking_brake_raw_ < 0.9999847412109375: actual_parking_brake_raw_ = rt.exact_raw(actual_parking_brake_, _R_1)
        return _S_H2B.pack(0x4512, commanded_parking_brake_raw_, actual_parking_brake_raw_)


_S_HB = rt.Packer("<HB")
_R_1 = rt.Scaling(0.0, 100.0, 255)
_S_H = rt.Packer("<H")
_S_H2B = rt.Packer("<H2B")
QueryParkingBrake.REPORT = ReportParkingBrake
