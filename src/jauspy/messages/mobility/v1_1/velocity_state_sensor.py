"""urn:jaus:jss:mobility:VelocityStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class QueryVelocityState(rt.Message):
    """QueryVelocityState (0x2404): Asks for the velocity.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2404
    NAME: ClassVar[str] = "QueryVelocityState"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
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
        if code != 0x2404:
            raise rt.Reject
        return cls(presence_vector_)

    def _pack(self) -> bytes:
        presence_vector_ = self.presence_vector
        return _S_2H.pack(0x2404, presence_vector_)


@dataclass(slots=True, repr=False)
class QueryVelocityStateExt(rt.Message):
    """QueryVelocityStateExt (0x24A4): Asks for the velocity in its wider form.

    velocity_var_presence_vector: Which velocity components the report is to have, by bit
    report_velocity_state_ext_rec_presence_vector: Which other fields the report is to have, by bit
    """

    CODE: ClassVar[int] = 0x24A4
    NAME: ClassVar[str] = "QueryVelocityStateExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    velocity_var_presence_vector: int
    report_velocity_state_ext_rec_presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_var_presence_vector", "VelocityVarPresenceVector", rt.Number("B")),
                rt.Slot("report_velocity_state_ext_rec_presence_vector", "ReportVelocityStateExtRecPresenceVector", rt.Number("H")),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, velocity_var_presence_vector_, report_velocity_state_ext_rec_presence_vector_ = _S_HBH.unpack(data)
        if code != 0x24A4:
            raise rt.Reject
        return cls(velocity_var_presence_vector_, report_velocity_state_ext_rec_presence_vector_)

    def _pack(self) -> bytes:
        velocity_var_presence_vector_ = self.velocity_var_presence_vector
        report_velocity_state_ext_rec_presence_vector_ = self.report_velocity_state_ext_rec_presence_vector
        return _S_HBH.pack(0x24A4, velocity_var_presence_vector_, report_velocity_state_ext_rec_presence_vector_)


@dataclass(slots=True, repr=False)
class ReportVelocityState(rt.Message):
    """ReportVelocityState (0x4404): Tells the velocity.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..3.14159265359 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x4404
    NAME: ClassVar[str] = "ReportVelocityState"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    TimeStamp = core_v1_0_types.TimeStamp

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    velocity_rms: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    rate_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_x", "Velocity_X", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_y", "Velocity_Y", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_z", "Velocity_Z", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_rms", "Velocity_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter per second"), optional=True),
                rt.Slot("roll_rate", "RollRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("pitch_rate", "PitchRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("yaw_rate", "YawRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("rate_rms", "Rate_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian per second"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x4404:
            raise rt.Reject
        raw = iter(_M_ReportVelocityState[mask & 0x1FF].unpack(data)).__next__
        velocity_x_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        velocity_y_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        velocity_z_ = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        velocity_rms_ = raw() * 2.3283064370807974e-08 if mask & 8 else None
        if mask & 16:
            roll_rate_ = raw()
            roll_rate_ = 32.767 if roll_rate_ == 65535 else -32.768 + roll_rate_ * 0.001
        else:
            roll_rate_ = None
        if mask & 32:
            pitch_rate_ = raw()
            pitch_rate_ = 32.767 if pitch_rate_ == 65535 else -32.768 + pitch_rate_ * 0.001
        else:
            pitch_rate_ = None
        if mask & 64:
            yaw_rate_ = raw()
            yaw_rate_ = 32.767 if yaw_rate_ == 65535 else -32.768 + yaw_rate_ * 0.001
        else:
            yaw_rate_ = None
        rate_rms_ = raw() * 4.793763109162727e-05 if mask & 128 else None
        if mask & 256:
            time_stamp_ = raw()
            part = time_stamp_ & 0x3FF
            if part > 999:
                raise rt.Reject
            part = time_stamp_ >> 10 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 16 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 22 & 0x1F
            if part > 23:
                raise rt.Reject
            part = time_stamp_ >> 27 & 0x1F
            if part < 1:
                raise rt.Reject
            time_stamp_ = core_v1_0_types.TimeStamp(time_stamp_ & 0x3FF, time_stamp_ >> 10 & 0x3F, time_stamp_ >> 16 & 0x3F, time_stamp_ >> 22 & 0x1F, time_stamp_ >> 27 & 0x1F)
        else:
            time_stamp_ = None
        return cls(velocity_x_, velocity_y_, velocity_z_, velocity_rms_, roll_rate_, pitch_rate_, yaw_rate_, rate_rms_, time_stamp_, mask & 0xFE00)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x1FF:
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
                velocity_x_raw = rt.exact_raw(velocity_x_, _R_3)
            raw.append(velocity_x_raw)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67:
                raise rt.Reject
            velocity_y_pos = (velocity_y_ + 327.68) * 6553700.0 + 0.5
            velocity_y_raw = int(velocity_y_pos)
            if not 1.52587890625e-05 < velocity_y_pos - velocity_y_raw < 0.9999847412109375:
                velocity_y_raw = rt.exact_raw(velocity_y_, _R_3)
            raw.append(velocity_y_raw)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67:
                raise rt.Reject
            velocity_z_pos = (velocity_z_ + 327.68) * 6553700.0 + 0.5
            velocity_z_raw = int(velocity_z_pos)
            if not 1.52587890625e-05 < velocity_z_pos - velocity_z_raw < 0.9999847412109375:
                velocity_z_raw = rt.exact_raw(velocity_z_, _R_3)
            raw.append(velocity_z_raw)
        velocity_rms_ = self.velocity_rms
        if velocity_rms_ is not None:
            mask |= 8
            if not 0.0 <= velocity_rms_ <= 100.0:
                raise rt.Reject
            velocity_rms_pos = velocity_rms_ * 42949672.95 + 0.5
            velocity_rms_raw = int(velocity_rms_pos)
            if not 1.52587890625e-05 < velocity_rms_pos - velocity_rms_raw < 0.9999847412109375:
                velocity_rms_raw = rt.exact_raw(velocity_rms_, _R_4)
            raw.append(velocity_rms_raw)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 16
            if not -32.768 <= roll_rate_ <= 32.767:
                raise rt.Reject
            roll_rate_pos = (roll_rate_ + 32.768) * 1000.0 + 0.5
            roll_rate_raw = int(roll_rate_pos)
            if not 1.52587890625e-05 < roll_rate_pos - roll_rate_raw < 0.9999847412109375:
                roll_rate_raw = rt.exact_raw(roll_rate_, _R_5)
            raw.append(roll_rate_raw)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 32
            if not -32.768 <= pitch_rate_ <= 32.767:
                raise rt.Reject
            pitch_rate_pos = (pitch_rate_ + 32.768) * 1000.0 + 0.5
            pitch_rate_raw = int(pitch_rate_pos)
            if not 1.52587890625e-05 < pitch_rate_pos - pitch_rate_raw < 0.9999847412109375:
                pitch_rate_raw = rt.exact_raw(pitch_rate_, _R_5)
            raw.append(pitch_rate_raw)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 64
            if not -32.768 <= yaw_rate_ <= 32.767:
                raise rt.Reject
            yaw_rate_pos = (yaw_rate_ + 32.768) * 1000.0 + 0.5
            yaw_rate_raw = int(yaw_rate_pos)
            if not 1.52587890625e-05 < yaw_rate_pos - yaw_rate_raw < 0.9999847412109375:
                yaw_rate_raw = rt.exact_raw(yaw_rate_, _R_5)
            raw.append(yaw_rate_raw)
        rate_rms_ = self.rate_rms
        if rate_rms_ is not None:
            mask |= 128
            if not 0.0 <= rate_rms_ <= 3.141592653589793:
                raise rt.Reject
            rate_rms_pos = rate_rms_ * 20860.438391054722 + 0.5
            rate_rms_raw = int(rate_rms_pos)
            if not 1.52587890625e-05 < rate_rms_pos - rate_rms_raw < 0.9999847412109375:
                rate_rms_raw = rt.exact_raw(rate_rms_, _R_6)
            raw.append(rate_rms_raw)
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 256
            if type(time_stamp_) is not core_v1_0_types.TimeStamp:
                raise rt.Reject
            time_stamp_milliseconds_ = time_stamp_.milliseconds
            if not 0 <= time_stamp_milliseconds_ <= 999:
                raise rt.Reject
            time_stamp_seconds_ = time_stamp_.seconds
            if not 0 <= time_stamp_seconds_ <= 59:
                raise rt.Reject
            time_stamp_minutes_ = time_stamp_.minutes
            if not 0 <= time_stamp_minutes_ <= 59:
                raise rt.Reject
            time_stamp_hour_ = time_stamp_.hour
            if not 0 <= time_stamp_hour_ <= 23:
                raise rt.Reject
            time_stamp_day_ = time_stamp_.day
            if not 1 <= time_stamp_day_ <= 31:
                raise rt.Reject
            raw.append(time_stamp_milliseconds_ | time_stamp_seconds_ << 10 | time_stamp_minutes_ << 16 | time_stamp_hour_ << 22 | time_stamp_day_ << 27)
        return _M_ReportVelocityState_pack[mask & 0x1FF].pack(0x4404, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportVelocityStateExt(rt.Message):
    """ReportVelocityStateExt (0x44A4): Tells the velocity in one of three frames, with speeds and shaft rotation.

    velocity_var: Velocity and its frame
    report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
    """

    CODE: ClassVar[int] = 0x44A4
    NAME: ClassVar[str] = "ReportVelocityStateExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    VelocityVehicleXYZRec = mobility_v1_0_types.VelocityVehicleXYZRec
    VelocityLocalXYZRec = mobility_v1_0_types.VelocityLocalXYZRec
    VelocityNEDRec = mobility_v1_0_types.VelocityNEDRec
    ReportVelocityStateExtRec = mobility_v1_0_types.ReportVelocityStateExtRec

    velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec
    report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_var", "VelocityVar", rt.Union.of("B", velocity_vehicle_xyz_rec=mobility_v1_0_types.VelocityVehicleXYZRec, velocity_local_xyz_rec=mobility_v1_0_types.VelocityLocalXYZRec, velocity_ned_rec=mobility_v1_0_types.VelocityNEDRec)),
                rt.Slot("report_velocity_state_ext_rec", "ReportVelocityStateExtRec", mobility_v1_0_types.ReportVelocityStateExtRec.layout()),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xA4 or data[1] != 0x44:
            raise rt.Reject
        at = 2
        tag = data[at]
        at += 1
        velocity_var_: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec
        if tag == 0:
            velocity_var_, at = mobility_v1_0_types.VelocityVehicleXYZRec._read(data, at, depth)
        elif tag == 1:
            velocity_var_, at = mobility_v1_0_types.VelocityLocalXYZRec._read(data, at, depth)
        elif tag == 2:
            velocity_var_, at = mobility_v1_0_types.VelocityNEDRec._read(data, at, depth)
        else:
            raise rt.Reject
        report_velocity_state_ext_rec_, at = mobility_v1_0_types.ReportVelocityStateExtRec._read(data, at, depth)
        if at != len(data):
            raise rt.Reject
        return cls(velocity_var_, report_velocity_state_ext_rec_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xa4\x44")
        velocity_var_ = self.velocity_var
        velocity_var_kind = type(velocity_var_)
        if velocity_var_kind is mobility_v1_0_types.VelocityVehicleXYZRec:
            out.append(0)
        elif velocity_var_kind is mobility_v1_0_types.VelocityLocalXYZRec:
            out.append(1)
        elif velocity_var_kind is mobility_v1_0_types.VelocityNEDRec:
            out.append(2)
        else:
            raise rt.Reject
        velocity_var_._write(out)
        report_velocity_state_ext_rec_ = self.report_velocity_state_ext_rec
        if type(report_velocity_state_ext_rec_) is not mobility_v1_0_types.ReportVelocityStateExtRec:
            raise rt.Reject
        report_velocity_state_ext_rec_._write(out)
        return bytes(out)


_S_2H = rt.Packer("<2H")
_S_HBH = rt.Packer("<HBH")
_M_ReportVelocityState = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
_R_3 = rt.Scaling(-327.68, 327.67, 4294967295)
_R_4 = rt.Scaling(0.0, 100.0, 4294967295)
_R_5 = rt.Scaling(-32.768, 32.767, 65535)
_R_6 = rt.Scaling(0.0, 3.141592653589793, 65535)
_M_ReportVelocityState_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "I")))
