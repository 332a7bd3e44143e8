"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class ZPosition(rt.Struct):
    """ZPosition.

    0: meter, -50000..50000 meter
    1: meter, -50000..50000 meter
    2: meter, -50000..50000 meter
    3: meter, -50000..50000 meter
    4: meter, -50000..50000 meter
    """

    class Choice(IntEnum):
        """Values of Choice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    choice: ZPosition.Choice | int
    value: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Choice(
            cls,
            {
                0: rt.real("I", -50000.0, 50000.0, "meter"),
                1: rt.real("I", -50000.0, 50000.0, "meter"),
                2: rt.real("I", -50000.0, 50000.0, "meter"),
                3: rt.real("I", -50000.0, 50000.0, "meter"),
                4: rt.real("I", -50000.0, 50000.0, "meter"),
            },
            rt.Values(ZPosition.Choice),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        self = rt.new(cls)
        choice = data[at]
        if choice == 0:
            (value_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_ * 2.3283064370807974e-05
            at += 5
        elif choice == 1:
            (value_2_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_2_ * 2.3283064370807974e-05
            at += 5
        elif choice == 2:
            (value_3_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_3_ * 2.3283064370807974e-05
            at += 5
        elif choice == 3:
            (value_4_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_4_ * 2.3283064370807974e-05
            at += 5
        elif choice == 4:
            (value_5_,) = _S_I.unpack_from(data, at + 1)
            self.value = -50000.0 + value_5_ * 2.3283064370807974e-05
            at += 5
        else: raise rt.Reject
        self.choice = _E_ZPosition_Choice[choice]
        return self, at

    def _write(self, out: bytearray) -> None:
        choice = self.choice
        if choice == 0:
            value_ = self.value
            if not -50000.0 <= value_ <= 50000.0: raise rt.Reject
            near = value_ * 42949.67295 + 2147483648.0
            value_raw_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw_)
        elif choice == 1:
            value_2_ = self.value
            if not -50000.0 <= value_2_ <= 50000.0: raise rt.Reject
            near = value_2_ * 42949.67295 + 2147483648.0
            value_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_2_ < 0.9999847412109375: value_raw_2_ = rt.exact_raw(value_2_, _R_2)
            out += _S_BI.pack(choice, value_raw_2_)
        elif choice == 2:
            value_3_ = self.value
            if not -50000.0 <= value_3_ <= 50000.0: raise rt.Reject
            near = value_3_ * 42949.67295 + 2147483648.0
            value_raw_3_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_3_ < 0.9999847412109375: value_raw_3_ = rt.exact_raw(value_3_, _R_2)
            out += _S_BI.pack(choice, value_raw_3_)
        elif choice == 3:
            value_4_ = self.value
            if not -50000.0 <= value_4_ <= 50000.0: raise rt.Reject
            near = value_4_ * 42949.67295 + 2147483648.0
            value_raw_4_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_4_ < 0.9999847412109375: value_raw_4_ = rt.exact_raw(value_4_, _R_2)
            out += _S_BI.pack(choice, value_raw_4_)
        elif choice == 4:
            value_5_ = self.value
            if not -50000.0 <= value_5_ <= 50000.0: raise rt.Reject
            near = value_5_ * 42949.67295 + 2147483648.0
            value_raw_5_ = int(near)
            if not 1.52587890625e-05 < near - value_raw_5_ < 0.9999847412109375: value_raw_5_ = rt.exact_raw(value_5_, _R_2)
            out += _S_BI.pack(choice, value_raw_5_)
        else: raise rt.Reject


@dataclass(slots=True, repr=False)
class VelocityVehicleXYZRec(rt.Struct):
    """VelocityVehicleXYZRec.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    """

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_5)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_5)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_5)
            raw.append(velocity_z_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class VelocityLocalXYZRec(rt.Struct):
    """VelocityLocalXYZRec.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity along X of the local frame, in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity along Y of the local frame, in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity along Z of the local frame, in metres per second
    """

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_5)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_5)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_5)
            raw.append(velocity_z_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class VelocityNEDRec(rt.Struct):
    """VelocityNEDRec.

    velocity_n: -327.68..327.67 meter per second, optional. Velocity to the north, in metres per second
    velocity_e: -327.68..327.67 meter per second, optional. Velocity to the east, in metres per second
    velocity_d: -327.68..327.67 meter per second, optional. Velocity down, in metres per second
    """

    velocity_n: float | None = None
    velocity_e: float | None = None
    velocity_d: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Velocity_N", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_E", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_D", rt.real("I", -327.68, 327.67, "meter per second"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        self = rt.new(cls)
        mask = data[at]
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at + 1)).__next__
        at = at + 1 + packer.size
        self.velocity_n = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_e = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_d = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        self.reserved_presence = mask & 0xF8
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_n_ = self.velocity_n
        if velocity_n_ is not None:
            mask |= 1
            if not -327.68 <= velocity_n_ <= 327.67: raise rt.Reject
            near = velocity_n_ * 6553700.0 + 2147516416.5
            velocity_n_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_n_raw_ < 0.9999847412109375: velocity_n_raw_ = rt.exact_raw(velocity_n_, _R_5)
            raw.append(velocity_n_raw_)
        velocity_e_ = self.velocity_e
        if velocity_e_ is not None:
            mask |= 2
            if not -327.68 <= velocity_e_ <= 327.67: raise rt.Reject
            near = velocity_e_ * 6553700.0 + 2147516416.5
            velocity_e_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_e_raw_ < 0.9999847412109375: velocity_e_raw_ = rt.exact_raw(velocity_e_, _R_5)
            raw.append(velocity_e_raw_)
        velocity_d_ = self.velocity_d
        if velocity_d_ is not None:
            mask |= 4
            if not -327.68 <= velocity_d_ <= 327.67: raise rt.Reject
            near = velocity_d_ * 6553700.0 + 2147516416.5
            velocity_d_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_d_raw_ < 0.9999847412109375: velocity_d_raw_ = rt.exact_raw(velocity_d_, _R_5)
            raw.append(velocity_d_raw_)
        out += _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7].pack(*raw)
        _S_B.pack_into(out, start, mask)


@dataclass(slots=True, repr=False)
class ReportVelocityStateExtRec(rt.Struct):
    """ReportVelocityStateExtRec.

    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..100 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    speed_over_ground: -327.68..327.67 meter per second, optional. Speed over ground, in metres per second
    speed_relative_to_medium: -327.68..327.67 meter per second, optional. Speed through air or water, in metres per second
    rotations_per_minute: -1000..1000 rotations per minute, optional. Rotation of propeller or drive shaft, per minute
    indicated_speed: -327.68..327.67 meter per second, optional. Speed as an air or water speed indicator shows it, in metres per second
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    velocity_rms: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    rate_rms: float | None = None
    speed_over_ground: float | None = None
    speed_relative_to_medium: float | None = None
    rotations_per_minute: float | None = None
    indicated_speed: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Velocity_RMS", rt.real("I", 0.0, 100.0, "meter per second"), True),
            ("RollRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("PitchRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("YawRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("Rate_RMS", rt.real("H", 0.0, 100.0, "radian per second"), True),
            ("SpeedOverGround", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("SpeedRelativeToMedium", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("RotationsPerMinute", rt.real("H", -1000.0, 1000.0, "rotations per minute"), True),
            ("IndicatedSpeed", rt.real("H", -327.68, 327.67, "meter per second"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, at)
        packer = _M_mobility_v1_0_types_ReportVelocityStateExtRec_0[mask & 0x7FF]
        raw = iter(packer.unpack_from(data, at + 2)).__next__
        at = at + 2 + packer.size
        self.velocity_rms = raw() * 2.3283064370807974e-08 if mask & 1 else None
        if mask & 2:
            roll_rate_ = raw()
            self.roll_rate = 32.767 if roll_rate_ == 4294967295 else -32.768 + roll_rate_ * 1.5258556235409003e-08
        else: self.roll_rate = None
        if mask & 4:
            pitch_rate_ = raw()
            self.pitch_rate = 32.767 if pitch_rate_ == 4294967295 else -32.768 + pitch_rate_ * 1.5258556235409003e-08
        else: self.pitch_rate = None
        if mask & 8:
            yaw_rate_ = raw()
            self.yaw_rate = 32.767 if yaw_rate_ == 4294967295 else -32.768 + yaw_rate_ * 1.5258556235409003e-08
        else: self.yaw_rate = None
        self.rate_rms = raw() * 0.0015259021896696422 if mask & 16 else None
        self.speed_over_ground = -327.68 + raw() * 0.01 if mask & 32 else None
        self.speed_relative_to_medium = -327.68 + raw() * 0.01 if mask & 64 else None
        self.rotations_per_minute = -1000.0 + raw() * 0.030518043793392843 if mask & 128 else None
        self.indicated_speed = -327.68 + raw() * 0.01 if mask & 256 else None
        self.time_seconds = raw() if mask & 512 else None
        self.time_nano_seconds = raw() if mask & 1024 else None
        self.reserved_presence = mask & 0xF800
        return self, at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_rms_ = self.velocity_rms
        if velocity_rms_ is not None:
            mask |= 1
            if not 0.0 <= velocity_rms_ <= 100.0: raise rt.Reject
            near = velocity_rms_ * 42949672.95 + 0.5
            velocity_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_rms_raw_ < 0.9999847412109375: velocity_rms_raw_ = rt.exact_raw(velocity_rms_, _R_9)
            raw.append(velocity_rms_raw_)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 2
            if not -32.768 <= roll_rate_ <= 32.767: raise rt.Reject
            near = roll_rate_ * 65537000.0 + 2147516416.5
            roll_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_rate_raw_ < 0.9999847412109375: roll_rate_raw_ = rt.exact_raw(roll_rate_, _R_10)
            raw.append(roll_rate_raw_)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 4
            if not -32.768 <= pitch_rate_ <= 32.767: raise rt.Reject
            near = pitch_rate_ * 65537000.0 + 2147516416.5
            pitch_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_rate_raw_ < 0.9999847412109375: pitch_rate_raw_ = rt.exact_raw(pitch_rate_, _R_10)
            raw.append(pitch_rate_raw_)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 8
            if not -32.768 <= yaw_rate_ <= 32.767: raise rt.Reject
            near = yaw_rate_ * 65537000.0 + 2147516416.5
            yaw_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_rate_raw_ < 0.9999847412109375: yaw_rate_raw_ = rt.exact_raw(yaw_rate_, _R_10)
            raw.append(yaw_rate_raw_)
        rate_rms_ = self.rate_rms
        if rate_rms_ is not None:
            mask |= 16
            if not 0.0 <= rate_rms_ <= 100.0: raise rt.Reject
            near = rate_rms_ * 655.35 + 0.5
            rate_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - rate_rms_raw_ < 0.9999847412109375: rate_rms_raw_ = rt.exact_raw(rate_rms_, _R_11)
            raw.append(rate_rms_raw_)
        speed_over_ground_ = self.speed_over_ground
        if speed_over_ground_ is not None:
            mask |= 32
            if not -327.68 <= speed_over_ground_ <= 327.67: raise rt.Reject
            near = speed_over_ground_ * 100.0 + 32768.5
            speed_over_ground_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_over_ground_raw_ < 0.9999847412109375: speed_over_ground_raw_ = rt.exact_raw(speed_over_ground_, _R_12)
            raw.append(speed_over_ground_raw_)
        speed_relative_to_medium_ = self.speed_relative_to_medium
        if speed_relative_to_medium_ is not None:
            mask |= 64
            if not -327.68 <= speed_relative_to_medium_ <= 327.67: raise rt.Reject
            near = speed_relative_to_medium_ * 100.0 + 32768.5
            speed_relative_to_medium_raw_ = int(near)
            if not 1.52587890625e-05 < near - speed_relative_to_medium_raw_ < 0.9999847412109375: speed_relative_to_medium_raw_ = rt.exact_raw(speed_relative_to_medium_, _R_12)
            raw.append(speed_relative_to_medium_raw_)
        rotations_per_minute_ = self.rotations_per_minute
        if rotations_per_minute_ is not None:
            mask |= 128
            if not -1000.0 <= rotations_per_minute_ <= 1000.0: raise rt.Reject
            near = rotations_per_minute_ * 32.7675 + 32768.0
            rotations_per_minute_raw_ = int(near)
            if not 1.52587890625e-05 < near - rotations_per_minute_raw_ < 0.9999847412109375: rotations_per_minute_raw_ = rt.exact_raw(rotations_per_minute_, _R_13)
            raw.append(rotations_per_minute_raw_)
        indicated_speed_ = self.indicated_speed
        if indicated_speed_ is not None:
            mask |= 256
            if not -327.68 <= indicated_speed_ <= 327.67: raise rt.Reject
            near = indicated_speed_ * 100.0 + 32768.5
            indicated_speed_raw_ = int(near)
            if not 1.52587890625e-05 < near - indicated_speed_raw_ < 0.9999847412109375: indicated_speed_raw_ = rt.exact_raw(indicated_speed_, _R_12)
            raw.append(indicated_speed_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 512
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 1024
            raw.append(time_nano_seconds_)
        out += _M_mobility_v1_0_types_ReportVelocityStateExtRec_0[mask & 0x7FF].pack(*raw)
        _S_H.pack_into(out, start, mask)


_S_I = rt.Packer("<I")
_E_ZPosition_Choice = rt.members(ZPosition.Choice)
_R_2 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_S_BI = rt.Packer("<BI")
_M_mobility_v1_0_types_VelocityVehicleXYZRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I")))
_R_5 = rt.Scaling(-327.68, 327.67, 4294967295)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_M_mobility_v1_0_types_ReportVelocityStateExtRec_0 = rt.Masks("", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "I"), (1024, "I")))
_R_9 = rt.Scaling(0.0, 100.0, 4294967295)
_R_10 = rt.Scaling(-32.768, 32.767, 4294967295)
_R_11 = rt.Scaling(0.0, 100.0, 65535)
_R_12 = rt.Scaling(-327.68, 327.67, 65535)
_R_13 = rt.Scaling(-1000.0, 1000.0, 65535)
