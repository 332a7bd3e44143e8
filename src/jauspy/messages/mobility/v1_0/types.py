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
                0: rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"),
                1: rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"),
                2: rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"),
                3: rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"),
                4: rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"),
            },
            rt.Values(ZPosition.Choice),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        choice = data[at]
        at += 1
        if choice == 0:
            (value_,) = _S_I.unpack_from(data, at)
            at += 4
            value = -50000.0 + value_ * 2.3283064370807974e-05
        elif choice == 1:
            (value_,) = _S_I.unpack_from(data, at)
            at += 4
            value = -50000.0 + value_ * 2.3283064370807974e-05
        elif choice == 2:
            (value_,) = _S_I.unpack_from(data, at)
            at += 4
            value = -50000.0 + value_ * 2.3283064370807974e-05
        elif choice == 3:
            (value_,) = _S_I.unpack_from(data, at)
            at += 4
            value = -50000.0 + value_ * 2.3283064370807974e-05
        elif choice == 4:
            (value_,) = _S_I.unpack_from(data, at)
            at += 4
            value = -50000.0 + value_ * 2.3283064370807974e-05
        else:
            raise rt.Reject
        return cls(_E_ZPosition_Choice[choice], value), at

    def _write(self, out: bytearray) -> None:
        choice = self.choice
        value_ = self.value
        if choice == 0:
            if not -50000.0 <= value_ <= 50000.0:
                raise rt.Reject
            value_pos = (value_ + 50000.0) * 42949.67295 + 0.5
            value_raw = int(value_pos)
            if not 1.52587890625e-05 < value_pos - value_raw < 0.9999847412109375:
                value_raw = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw)
        elif choice == 1:
            if not -50000.0 <= value_ <= 50000.0:
                raise rt.Reject
            value_pos = (value_ + 50000.0) * 42949.67295 + 0.5
            value_raw = int(value_pos)
            if not 1.52587890625e-05 < value_pos - value_raw < 0.9999847412109375:
                value_raw = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw)
        elif choice == 2:
            if not -50000.0 <= value_ <= 50000.0:
                raise rt.Reject
            value_pos = (value_ + 50000.0) * 42949.67295 + 0.5
            value_raw = int(value_pos)
            if not 1.52587890625e-05 < value_pos - value_raw < 0.9999847412109375:
                value_raw = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw)
        elif choice == 3:
            if not -50000.0 <= value_ <= 50000.0:
                raise rt.Reject
            value_pos = (value_ + 50000.0) * 42949.67295 + 0.5
            value_raw = int(value_pos)
            if not 1.52587890625e-05 < value_pos - value_raw < 0.9999847412109375:
                value_raw = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw)
        elif choice == 4:
            if not -50000.0 <= value_ <= 50000.0:
                raise rt.Reject
            value_pos = (value_ + 50000.0) * 42949.67295 + 0.5
            value_raw = int(value_pos)
            if not 1.52587890625e-05 < value_pos - value_raw < 0.9999847412109375:
                value_raw = rt.exact_raw(value_, _R_2)
            out += _S_BI.pack(choice, value_raw)
        else:
            raise rt.Reject


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
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_x", "Velocity_X", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_y", "Velocity_Y", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_z", "Velocity_Z", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
            ),
            "B",
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        mask = data[at]
        at += 1
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        velocity_x_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        velocity_y_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        velocity_z_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        return cls(velocity_x_, velocity_y_, velocity_z_, mask & 0xF8), at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67:
                raise rt.Reject
            velocity_x_pos = (velocity_x_ + 327.68) * 6553700.0 + 0.5
            velocity_x_raw = int(velocity_x_pos)
            if not 1.52587890625e-05 < velocity_x_pos - velocity_x_raw < 0.9999847412109375:
                velocity_x_raw = rt.exact_raw(velocity_x_, _R_5)
            raw.append(velocity_x_raw)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67:
                raise rt.Reject
            velocity_y_pos = (velocity_y_ + 327.68) * 6553700.0 + 0.5
            velocity_y_raw = int(velocity_y_pos)
            if not 1.52587890625e-05 < velocity_y_pos - velocity_y_raw < 0.9999847412109375:
                velocity_y_raw = rt.exact_raw(velocity_y_, _R_5)
            raw.append(velocity_y_raw)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67:
                raise rt.Reject
            velocity_z_pos = (velocity_z_ + 327.68) * 6553700.0 + 0.5
            velocity_z_raw = int(velocity_z_pos)
            if not 1.52587890625e-05 < velocity_z_pos - velocity_z_raw < 0.9999847412109375:
                velocity_z_raw = rt.exact_raw(velocity_z_, _R_5)
            raw.append(velocity_z_raw)
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
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_x", "Velocity_X", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_y", "Velocity_Y", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_z", "Velocity_Z", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
            ),
            "B",
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        mask = data[at]
        at += 1
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        velocity_x_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        velocity_y_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        velocity_z_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        return cls(velocity_x_, velocity_y_, velocity_z_, mask & 0xF8), at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67:
                raise rt.Reject
            velocity_x_pos = (velocity_x_ + 327.68) * 6553700.0 + 0.5
            velocity_x_raw = int(velocity_x_pos)
            if not 1.52587890625e-05 < velocity_x_pos - velocity_x_raw < 0.9999847412109375:
                velocity_x_raw = rt.exact_raw(velocity_x_, _R_5)
            raw.append(velocity_x_raw)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67:
                raise rt.Reject
            velocity_y_pos = (velocity_y_ + 327.68) * 6553700.0 + 0.5
            velocity_y_raw = int(velocity_y_pos)
            if not 1.52587890625e-05 < velocity_y_pos - velocity_y_raw < 0.9999847412109375:
                velocity_y_raw = rt.exact_raw(velocity_y_, _R_5)
            raw.append(velocity_y_raw)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67:
                raise rt.Reject
            velocity_z_pos = (velocity_z_ + 327.68) * 6553700.0 + 0.5
            velocity_z_raw = int(velocity_z_pos)
            if not 1.52587890625e-05 < velocity_z_pos - velocity_z_raw < 0.9999847412109375:
                velocity_z_raw = rt.exact_raw(velocity_z_, _R_5)
            raw.append(velocity_z_raw)
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
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_n", "Velocity_N", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_e", "Velocity_E", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_d", "Velocity_D", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
            ),
            "B",
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        mask = data[at]
        at += 1
        packer = _M_mobility_v1_0_types_VelocityVehicleXYZRec_0[mask & 0x7]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        velocity_n_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        velocity_e_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        velocity_d_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        return cls(velocity_n_, velocity_e_, velocity_d_, mask & 0xF8), at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x7:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_n_ = self.velocity_n
        if velocity_n_ is not None:
            mask |= 1
            if not -327.68 <= velocity_n_ <= 327.67:
                raise rt.Reject
            velocity_n_pos = (velocity_n_ + 327.68) * 6553700.0 + 0.5
            velocity_n_raw = int(velocity_n_pos)
            if not 1.52587890625e-05 < velocity_n_pos - velocity_n_raw < 0.9999847412109375:
                velocity_n_raw = rt.exact_raw(velocity_n_, _R_5)
            raw.append(velocity_n_raw)
        velocity_e_ = self.velocity_e
        if velocity_e_ is not None:
            mask |= 2
            if not -327.68 <= velocity_e_ <= 327.67:
                raise rt.Reject
            velocity_e_pos = (velocity_e_ + 327.68) * 6553700.0 + 0.5
            velocity_e_raw = int(velocity_e_pos)
            if not 1.52587890625e-05 < velocity_e_pos - velocity_e_raw < 0.9999847412109375:
                velocity_e_raw = rt.exact_raw(velocity_e_, _R_5)
            raw.append(velocity_e_raw)
        velocity_d_ = self.velocity_d
        if velocity_d_ is not None:
            mask |= 4
            if not -327.68 <= velocity_d_ <= 327.67:
                raise rt.Reject
            velocity_d_pos = (velocity_d_ + 327.68) * 6553700.0 + 0.5
            velocity_d_raw = int(velocity_d_pos)
            if not 1.52587890625e-05 < velocity_d_pos - velocity_d_raw < 0.9999847412109375:
                velocity_d_raw = rt.exact_raw(velocity_d_, _R_5)
            raw.append(velocity_d_raw)
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
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_rms", "Velocity_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter per second"), optional=True),
                rt.Slot("roll_rate", "RollRate", rt.Real("I", rt.Scaling(-32.768, 32.767, 4294967295), "radian per second"), optional=True),
                rt.Slot("pitch_rate", "PitchRate", rt.Real("I", rt.Scaling(-32.768, 32.767, 4294967295), "radian per second"), optional=True),
                rt.Slot("yaw_rate", "YawRate", rt.Real("I", rt.Scaling(-32.768, 32.767, 4294967295), "radian per second"), optional=True),
                rt.Slot("rate_rms", "Rate_RMS", rt.Real("H", rt.Scaling(0.0, 100.0, 65535), "radian per second"), optional=True),
                rt.Slot("speed_over_ground", "SpeedOverGround", rt.Real("H", rt.Scaling(-327.68, 327.67, 65535), "meter per second"), optional=True),
                rt.Slot("speed_relative_to_medium", "SpeedRelativeToMedium", rt.Real("H", rt.Scaling(-327.68, 327.67, 65535), "meter per second"), optional=True),
                rt.Slot("rotations_per_minute", "RotationsPerMinute", rt.Real("H", rt.Scaling(-1000.0, 1000.0, 65535), "rotations per minute"), optional=True),
                rt.Slot("indicated_speed", "IndicatedSpeed", rt.Real("H", rt.Scaling(-327.68, 327.67, 65535), "meter per second"), optional=True),
                rt.Slot("time_seconds", "TimeSeconds", rt.Number("I", rt.ANY, "second"), optional=True),
                rt.Slot("time_nano_seconds", "TimeNanoSeconds", rt.Number("I"), optional=True),
            ),
            "H",
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        (mask,) = _S_H.unpack_from(data, at)
        at += 2
        packer = _M_mobility_v1_0_types_ReportVelocityStateExtRec_0[mask & 0x7FF]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        velocity_rms_ = raw() * 2.3283064370807974e-08 if mask & 1 else None
        if mask & 2:
            roll_rate_ = raw()
            roll_rate_ = 32.767 if roll_rate_ == 4294967295 else -32.768 + roll_rate_ * 1.5258556235409003e-08
        else:
            roll_rate_ = None
        if mask & 4:
            pitch_rate_ = raw()
            pitch_rate_ = 32.767 if pitch_rate_ == 4294967295 else -32.768 + pitch_rate_ * 1.5258556235409003e-08
        else:
            pitch_rate_ = None
        if mask & 8:
            yaw_rate_ = raw()
            yaw_rate_ = 32.767 if yaw_rate_ == 4294967295 else -32.768 + yaw_rate_ * 1.5258556235409003e-08
        else:
            yaw_rate_ = None
        rate_rms_ = raw() * 0.0015259021896696422 if mask & 16 else None
        speed_over_ground_ = -327.68 + raw() * 0.01 if mask & 32 else None
        speed_relative_to_medium_ = -327.68 + raw() * 0.01 if mask & 64 else None
        rotations_per_minute_ = -1000.0 + raw() * 0.030518043793392843 if mask & 128 else None
        indicated_speed_ = -327.68 + raw() * 0.01 if mask & 256 else None
        time_seconds_ = raw() if mask & 512 else None
        time_nano_seconds_ = raw() if mask & 1024 else None
        return cls(velocity_rms_, roll_rate_, pitch_rate_, yaw_rate_, rate_rms_, speed_over_ground_, speed_relative_to_medium_, rotations_per_minute_, indicated_speed_, time_seconds_, time_nano_seconds_, mask & 0xF800), at

    def _write(self, out: bytearray) -> None:
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        velocity_rms_ = self.velocity_rms
        if velocity_rms_ is not None:
            mask |= 1
            if not 0.0 <= velocity_rms_ <= 100.0:
                raise rt.Reject
            velocity_rms_pos = velocity_rms_ * 42949672.95 + 0.5
            velocity_rms_raw = int(velocity_rms_pos)
            if not 1.52587890625e-05 < velocity_rms_pos - velocity_rms_raw < 0.9999847412109375:
                velocity_rms_raw = rt.exact_raw(velocity_rms_, _R_9)
            raw.append(velocity_rms_raw)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 2
            if not -32.768 <= roll_rate_ <= 32.767:
                raise rt.Reject
            roll_rate_pos = (roll_rate_ + 32.768) * 65537000.0 + 0.5
            roll_rate_raw = int(roll_rate_pos)
            if not 1.52587890625e-05 < roll_rate_pos - roll_rate_raw < 0.9999847412109375:
                roll_rate_raw = rt.exact_raw(roll_rate_, _R_10)
            raw.append(roll_rate_raw)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 4
            if not -32.768 <= pitch_rate_ <= 32.767:
                raise rt.Reject
            pitch_rate_pos = (pitch_rate_ + 32.768) * 65537000.0 + 0.5
            pitch_rate_raw = int(pitch_rate_pos)
            if not 1.52587890625e-05 < pitch_rate_pos - pitch_rate_raw < 0.9999847412109375:
                pitch_rate_raw = rt.exact_raw(pitch_rate_, _R_10)
            raw.append(pitch_rate_raw)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 8
            if not -32.768 <= yaw_rate_ <= 32.767:
                raise rt.Reject
            yaw_rate_pos = (yaw_rate_ + 32.768) * 65537000.0 + 0.5
            yaw_rate_raw = int(yaw_rate_pos)
            if not 1.52587890625e-05 < yaw_rate_pos - yaw_rate_raw < 0.9999847412109375:
                yaw_rate_raw = rt.exact_raw(yaw_rate_, _R_10)
            raw.append(yaw_rate_raw)
        rate_rms_ = self.rate_rms
        if rate_rms_ is not None:
            mask |= 16
            if not 0.0 <= rate_rms_ <= 100.0:
                raise rt.Reject
            rate_rms_pos = rate_rms_ * 655.35 + 0.5
            rate_rms_raw = int(rate_rms_pos)
            if not 1.52587890625e-05 < rate_rms_pos - rate_rms_raw < 0.9999847412109375:
                rate_rms_raw = rt.exact_raw(rate_rms_, _R_11)
            raw.append(rate_rms_raw)
        speed_over_ground_ = self.speed_over_ground
        if speed_over_ground_ is not None:
            mask |= 32
            if not -327.68 <= speed_over_ground_ <= 327.67:
                raise rt.Reject
            speed_over_ground_pos = (speed_over_ground_ + 327.68) * 100.0 + 0.5
            speed_over_ground_raw = int(speed_over_ground_pos)
            if not 1.52587890625e-05 < speed_over_ground_pos - speed_over_ground_raw < 0.9999847412109375:
                speed_over_ground_raw = rt.exact_raw(speed_over_ground_, _R_12)
            raw.append(speed_over_ground_raw)
        speed_relative_to_medium_ = self.speed_relative_to_medium
        if speed_relative_to_medium_ is not None:
            mask |= 64
            if not -327.68 <= speed_relative_to_medium_ <= 327.67:
                raise rt.Reject
            speed_relative_to_medium_pos = (speed_relative_to_medium_ + 327.68) * 100.0 + 0.5
            speed_relative_to_medium_raw = int(speed_relative_to_medium_pos)
            if not 1.52587890625e-05 < speed_relative_to_medium_pos - speed_relative_to_medium_raw < 0.9999847412109375:
                speed_relative_to_medium_raw = rt.exact_raw(speed_relative_to_medium_, _R_12)
            raw.append(speed_relative_to_medium_raw)
        rotations_per_minute_ = self.rotations_per_minute
        if rotations_per_minute_ is not None:
            mask |= 128
            if not -1000.0 <= rotations_per_minute_ <= 1000.0:
                raise rt.Reject
            rotations_per_minute_pos = (rotations_per_minute_ + 1000.0) * 32.7675 + 0.5
            rotations_per_minute_raw = int(rotations_per_minute_pos)
            if not 1.52587890625e-05 < rotations_per_minute_pos - rotations_per_minute_raw < 0.9999847412109375:
                rotations_per_minute_raw = rt.exact_raw(rotations_per_minute_, _R_13)
            raw.append(rotations_per_minute_raw)
        indicated_speed_ = self.indicated_speed
        if indicated_speed_ is not None:
            mask |= 256
            if not -327.68 <= indicated_speed_ <= 327.67:
                raise rt.Reject
            indicated_speed_pos = (indicated_speed_ + 327.68) * 100.0 + 0.5
            indicated_speed_raw = int(indicated_speed_pos)
            if not 1.52587890625e-05 < indicated_speed_pos - indicated_speed_raw < 0.9999847412109375:
                indicated_speed_raw = rt.exact_raw(indicated_speed_, _R_12)
            raw.append(indicated_speed_raw)
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
_E_ZPosition_Choice = {member.value: member for member in ZPosition.Choice}
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
