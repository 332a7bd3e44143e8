"""urn:jaus:jss:mobility:AccelerationStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import acceleration_state_sensor as mobility_v1_0_acceleration_state_sensor


class QueryAccelerationState(mobility_v1_0_acceleration_state_sensor.QueryAccelerationState):
    """QueryAccelerationState (0x2417): Asks for the acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportAccelerationState]]


@dataclass(slots=True, repr=False)
class QueryAccelerationStateExt(rt.Message):
    """QueryAccelerationStateExt (0x24B7): Asks for the acceleration with its finer time of measurement.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24B7
    NAME = "QueryAccelerationStateExt"
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAccelerationStateExt]]

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
        if code != 0x24B7: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x24B7, self.presence_vector)


class ReportAccelerationState(mobility_v1_0_acceleration_state_sensor.ReportAccelerationState):
    """ReportAccelerationState (0x4417): Tells the acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportAccelerationStateExt(rt.Message):
    """ReportAccelerationStateExt (0x44B7): Tells the acceleration, with a time of measurement in nanoseconds.

    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..1000 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE = 0x44B7
    NAME = "ReportAccelerationStateExt"
    SERVICE = "urn:jaus:jss:mobility:AccelerationStateSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    acceleration_x: float | None = None
    acceleration_y: float | None = None
    acceleration_z: float | None = None
    acceleration_rms: float | None = None
    roll_acceleration: float | None = None
    pitch_acceleration: float | None = None
    yaw_acceleration: float | None = None
    rotational_acceleration_rms: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Acceleration_X", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Y", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Z", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_RMS", rt.real("I", 0.0, 100.0, "meter per second squared"), True),
            ("RollAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("PitchAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("YawAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("RotationalAcceleration_RMS", rt.real("H", 0.0, 1000.0, "radian per second squared"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x44B7: raise rt.Reject
        raw = iter(_M_ReportAccelerationStateExt[mask & 0x3FF].unpack(data)).__next__
        self = rt.new(cls)
        self.acceleration_x = -1310.68 + raw() * 6.103329361906119e-07 if mask & 1 else None
        self.acceleration_y = -1310.68 + raw() * 6.103329361906119e-07 if mask & 2 else None
        self.acceleration_z = -1310.68 + raw() * 6.103329361906119e-07 if mask & 4 else None
        self.acceleration_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.roll_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 16 else None
        self.pitch_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 32 else None
        self.yaw_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 64 else None
        self.rotational_acceleration_rms = raw() * 0.015259021896696421 if mask & 128 else None
        self.time_seconds = raw() if mask & 256 else None
        self.time_nano_seconds = raw() if mask & 512 else None
        self.reserved_presence = mask & 0xFC00
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        acceleration_x_ = self.acceleration_x
        if acceleration_x_ is not None:
            mask |= 1
            if not -1310.68 <= acceleration_x_ <= 1310.68: raise rt.Reject
            near = acceleration_x_ * 1638450.001144444 + 2147483648.0
            acceleration_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_x_raw_ < 0.9999847412109375: acceleration_x_raw_ = rt.exact_raw(acceleration_x_, _R_2)
            raw.append(acceleration_x_raw_)
        acceleration_y_ = self.acceleration_y
        if acceleration_y_ is not None:
            mask |= 2
            if not -1310.68 <= acceleration_y_ <= 1310.68: raise rt.Reject
            near = acceleration_y_ * 1638450.001144444 + 2147483648.0
            acceleration_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_y_raw_ < 0.9999847412109375: acceleration_y_raw_ = rt.exact_raw(acceleration_y_, _R_2)
            raw.append(acceleration_y_raw_)
        acceleration_z_ = self.acceleration_z
        if acceleration_z_ is not None:
            mask |= 4
            if not -1310.68 <= acceleration_z_ <= 1310.68: raise rt.Reject
            near = acceleration_z_ * 1638450.001144444 + 2147483648.0
            acceleration_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_z_raw_ < 0.9999847412109375: acceleration_z_raw_ = rt.exact_raw(acceleration_z_, _R_2)
            raw.append(acceleration_z_raw_)
        acceleration_rms_ = self.acceleration_rms
        if acceleration_rms_ is not None:
            mask |= 8
            if not 0.0 <= acceleration_rms_ <= 100.0: raise rt.Reject
            near = acceleration_rms_ * 42949672.95 + 0.5
            acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_rms_raw_ < 0.9999847412109375: acceleration_rms_raw_ = rt.exact_raw(acceleration_rms_, _R_3)
            raw.append(acceleration_rms_raw_)
        roll_acceleration_ = self.roll_acceleration
        if roll_acceleration_ is not None:
            mask |= 16
            if not -13106.8 <= roll_acceleration_ <= 13106.8: raise rt.Reject
            near = roll_acceleration_ * 163845.0001144444 + 2147483647.9999998
            roll_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_acceleration_raw_ < 0.9999847412109375: roll_acceleration_raw_ = rt.exact_raw(roll_acceleration_, _R_4)
            raw.append(roll_acceleration_raw_)
        pitch_acceleration_ = self.pitch_acceleration
        if pitch_acceleration_ is not None:
            mask |= 32
            if not -13106.8 <= pitch_acceleration_ <= 13106.8: raise rt.Reject
            near = pitch_acceleration_ * 163845.0001144444 + 2147483647.9999998
            pitch_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_acceleration_raw_ < 0.9999847412109375: pitch_acceleration_raw_ = rt.exact_raw(pitch_acceleration_, _R_4)
            raw.append(pitch_acceleration_raw_)
        yaw_acceleration_ = self.yaw_acceleration
        if yaw_acceleration_ is not None:
            mask |= 64
            if not -13106.8 <= yaw_acceleration_ <= 13106.8: raise rt.Reject
            near = yaw_acceleration_ * 163845.0001144444 + 2147483647.9999998
            yaw_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_acceleration_raw_ < 0.9999847412109375: yaw_acceleration_raw_ = rt.exact_raw(yaw_acceleration_, _R_4)
            raw.append(yaw_acceleration_raw_)
        rotational_acceleration_rms_ = self.rotational_acceleration_rms
        if rotational_acceleration_rms_ is not None:
            mask |= 128
            if not 0.0 <= rotational_acceleration_rms_ <= 1000.0: raise rt.Reject
            near = rotational_acceleration_rms_ * 65.535 + 0.5
            rotational_acceleration_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rotational_acceleration_rms_raw_ < 0.9999847412109375: rotational_acceleration_rms_raw_ = rt.exact_raw(rotational_acceleration_rms_, _R_5)
            raw.append(rotational_acceleration_rms_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 256
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 512
            raw.append(time_nano_seconds_)
        return _M_ReportAccelerationStateExt_pack[mask & 0x3FF].pack(0x44B7, mask, *raw)


_S_2H = rt.Packer("<2H")
_M_ReportAccelerationStateExt = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "H"), (256, "I"), (512, "I")))
_R_2 = rt.Scaling(-1310.68, 1310.68, 4294967295)
_R_3 = rt.Scaling(0.0, 100.0, 4294967295)
_R_4 = rt.Scaling(-13106.8, 13106.8, 4294967295)
_R_5 = rt.Scaling(0.0, 1000.0, 65535)
_M_ReportAccelerationStateExt_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "H"), (256, "I"), (512, "I")))
QueryAccelerationState.REPORT = ReportAccelerationState
QueryAccelerationStateExt.REPORT = ReportAccelerationStateExt
