"""urn:jaus:jss:ugv:AckermannDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetAckermannConfiguration(rt.Message):
    """SetAckermannConfiguration (0x0500): Sets throttle, brake and steering.

    steering_angle: -1.57079632679..1.57079632679 radian. Angle of the steered wheels, in radians; positive turns right
    throttle_effort: 0..100. Throttle, in percent of the maximum
    brake_effort: 0..100. Brake, in percent of the maximum
    max_steering_rate: 0..32.767 radian per second, optional. Largest rate of the steering angle, in radians per second
    max_steering_torque: 0..500 newton meter, optional. Largest torque on the steering, in newton metres
    """

    CODE = 0x0500
    NAME = "SetAckermannConfiguration"
    SERVICE = "urn:jaus:jss:ugv:AckermannDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    steering_angle: float
    throttle_effort: float
    brake_effort: float
    max_steering_rate: float | None = None
    max_steering_torque: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("SteeringAngle", rt.real("H", -1.5707963267948966, 1.5707963267948966, "radian")),
            ("ThrottleEffort", rt.real("H", 0.0, 100.0)),
            ("BrakeEffort", rt.real("H", 0.0, 100.0)),
            ("MaxSteeringRate", rt.real("H", 0.0, 32.767, "radian per second"), True),
            ("MaxSteeringTorque", rt.real("H", 0.0, 500.0, "newton meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0500: raise rt.Reject
        raw = iter(_M_SetAckermannConfiguration[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        steering_angle_ = raw()
        self.steering_angle = -1.5707963267948966 + steering_angle_ * 4.793763109162727e-05
        throttle_effort_ = raw()
        self.throttle_effort = throttle_effort_ * 0.0015259021896696422
        brake_effort_ = raw()
        self.brake_effort = brake_effort_ * 0.0015259021896696422
        self.max_steering_rate = raw() * 0.0004999923704890516 if mask & 1 else None
        self.max_steering_torque = raw() * 0.007629510948348211 if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        steering_angle_ = self.steering_angle
        if not -1.5707963267948966 <= steering_angle_ <= 1.5707963267948966: raise rt.Reject
        near = steering_angle_ * 20860.438391054722 + 32768.0
        steering_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - steering_angle_raw_ < 0.9999847412109375: steering_angle_raw_ = rt.exact_raw(steering_angle_, _R_2)
        raw.append(steering_angle_raw_)
        throttle_effort_ = self.throttle_effort
        if not 0.0 <= throttle_effort_ <= 100.0: raise rt.Reject
        near = throttle_effort_ * 655.35 + 0.5
        throttle_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - throttle_effort_raw_ < 0.9999847412109375: throttle_effort_raw_ = rt.exact_raw(throttle_effort_, _R_3)
        raw.append(throttle_effort_raw_)
        brake_effort_ = self.brake_effort
        if not 0.0 <= brake_effort_ <= 100.0: raise rt.Reject
        near = brake_effort_ * 655.35 + 0.5
        brake_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - brake_effort_raw_ < 0.9999847412109375: brake_effort_raw_ = rt.exact_raw(brake_effort_, _R_3)
        raw.append(brake_effort_raw_)
        max_steering_rate_ = self.max_steering_rate
        if max_steering_rate_ is not None:
            mask |= 1
            if not 0.0 <= max_steering_rate_ <= 32.767: raise rt.Reject
            near = max_steering_rate_ * 2000.0305185094758 + 0.5
            max_steering_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_steering_rate_raw_ < 0.9999847412109375: max_steering_rate_raw_ = rt.exact_raw(max_steering_rate_, _R_4)
            raw.append(max_steering_rate_raw_)
        max_steering_torque_ = self.max_steering_torque
        if max_steering_torque_ is not None:
            mask |= 2
            if not 0.0 <= max_steering_torque_ <= 500.0: raise rt.Reject
            near = max_steering_torque_ * 131.07 + 0.5
            max_steering_torque_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_steering_torque_raw_ < 0.9999847412109375: max_steering_torque_raw_ = rt.exact_raw(max_steering_torque_, _R_5)
            raw.append(max_steering_torque_raw_)
        return _M_SetAckermannConfiguration_pack[mask & 0x3].pack(0x0500, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryAckermannConfiguration(rt.Message):
    """QueryAckermannConfiguration (0x2500): Asks for throttle, brake and steering."""

    CODE = 0x2500
    NAME = "QueryAckermannConfiguration"
    SERVICE = "urn:jaus:jss:ugv:AckermannDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAckermannConfiguration]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x00%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2500)


@dataclass(slots=True, repr=False)
class ReportAckermannConfiguration(rt.Message):
    """ReportAckermannConfiguration (0x4500): Tells throttle, brake and steering.

    steering_angle: -1.57079632679..1.57079632679 radian. Angle of the steered wheels, in radians; positive turns right
    throttle_effort: 0..100. Throttle, in percent of the maximum
    brake_effort: 0..100. Brake, in percent of the maximum
    steering_rate: -32.767..32.768 radian per second, optional. Rate of the steering angle, in radians per second
    steering_torque: -500..500 newton meter, optional. Torque on the steering, in newton metres
    """

    CODE = 0x4500
    NAME = "ReportAckermannConfiguration"
    SERVICE = "urn:jaus:jss:ugv:AckermannDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    steering_angle: float
    throttle_effort: float
    brake_effort: float
    steering_rate: float | None = None
    steering_torque: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("SteeringAngle", rt.real("H", -1.5707963267948966, 1.5707963267948966, "radian")),
            ("ThrottleEffort", rt.real("H", 0.0, 100.0)),
            ("BrakeEffort", rt.real("H", 0.0, 100.0)),
            ("SteeringRate", rt.real("H", -32.767, 32.768, "radian per second"), True),
            ("SteeringTorque", rt.real("H", -500.0, 500.0, "newton meter"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4500: raise rt.Reject
        raw = iter(_M_SetAckermannConfiguration[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        steering_angle_ = raw()
        self.steering_angle = -1.5707963267948966 + steering_angle_ * 4.793763109162727e-05
        throttle_effort_ = raw()
        self.throttle_effort = throttle_effort_ * 0.0015259021896696422
        brake_effort_ = raw()
        self.brake_effort = brake_effort_ * 0.0015259021896696422
        if mask & 1:
            steering_rate_ = raw()
            self.steering_rate = 32.768 if steering_rate_ == 65535 else -32.767 + steering_rate_ * 0.001
        else: self.steering_rate = None
        self.steering_torque = -500.0 + raw() * 0.015259021896696421 if mask & 2 else None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        steering_angle_ = self.steering_angle
        if not -1.5707963267948966 <= steering_angle_ <= 1.5707963267948966: raise rt.Reject
        near = steering_angle_ * 20860.438391054722 + 32768.0
        steering_angle_raw_ = int(near)
        if not 1.52587890625e-05 < near - steering_angle_raw_ < 0.9999847412109375: steering_angle_raw_ = rt.exact_raw(steering_angle_, _R_2)
        raw.append(steering_angle_raw_)
        throttle_effort_ = self.throttle_effort
        if not 0.0 <= throttle_effort_ <= 100.0: raise rt.Reject
        near = throttle_effort_ * 655.35 + 0.5
        throttle_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - throttle_effort_raw_ < 0.9999847412109375: throttle_effort_raw_ = rt.exact_raw(throttle_effort_, _R_3)
        raw.append(throttle_effort_raw_)
        brake_effort_ = self.brake_effort
        if not 0.0 <= brake_effort_ <= 100.0: raise rt.Reject
        near = brake_effort_ * 655.35 + 0.5
        brake_effort_raw_ = int(near)
        if not 1.52587890625e-05 < near - brake_effort_raw_ < 0.9999847412109375: brake_effort_raw_ = rt.exact_raw(brake_effort_, _R_3)
        raw.append(brake_effort_raw_)
        steering_rate_ = self.steering_rate
        if steering_rate_ is not None:
            mask |= 1
            if not -32.767 <= steering_rate_ <= 32.768: raise rt.Reject
            near = steering_rate_ * 1000.0 + 32767.500000000004
            steering_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - steering_rate_raw_ < 0.9999847412109375: steering_rate_raw_ = rt.exact_raw(steering_rate_, _R_8)
            raw.append(steering_rate_raw_)
        steering_torque_ = self.steering_torque
        if steering_torque_ is not None:
            mask |= 2
            if not -500.0 <= steering_torque_ <= 500.0: raise rt.Reject
            near = steering_torque_ * 65.535 + 32768.0
            steering_torque_raw_ = int(near)
            if not 1.52587890625e-05 < near - steering_torque_raw_ < 0.9999847412109375: steering_torque_raw_ = rt.exact_raw(steering_torque_, _R_9)
            raw.append(steering_torque_raw_)
        return _M_SetAckermannConfiguration_pack[mask & 0x3].pack(0x4500, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetAckermannConfiguration = rt.Masks("3x", ((0, "H"), (0, "H"), (0, "H"), (1, "H"), (2, "H")))
_R_2 = rt.Scaling(-1.5707963267948966, 1.5707963267948966, 65535)
_R_3 = rt.Scaling(0.0, 100.0, 65535)
_R_4 = rt.Scaling(0.0, 32.767, 65535)
_R_5 = rt.Scaling(0.0, 500.0, 65535)
_M_SetAckermannConfiguration_pack = rt.Masks("HB", ((0, "H"), (0, "H"), (0, "H"), (1, "H"), (2, "H")))
_S_H = rt.Packer("<H")
_R_8 = rt.Scaling(-32.767, 32.768, 65535)
_R_9 = rt.Scaling(-500.0, 500.0, 65535)
QueryAckermannConfiguration.REPORT = ReportAckermannConfiguration
