"""urn:jaus:jss:mobility:VelocityStateDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import velocity_state_driver as mobility_v1_0_velocity_state_driver


class SetVelocityCommand(mobility_v1_0_velocity_state_driver.SetVelocityCommand):
    """SetVelocityCommand (0x0415): Sets the wanted velocity, its default, or one of its limits."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class SetVelocityCommandExt(rt.Message):
    """SetVelocityCommandExt (0x04B5): As SetVelocityCommand, with a choice between speed over ground and through
    the medium.

    command_type: CommandType. The wanted velocity, its default, or a limit; over ground (SOG) or through the medium (SRM)
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    CODE = 0x04B5
    NAME = "SetVelocityCommandExt"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class CommandType(IntEnum):
        """Values of CommandType."""

        SET_COMMAND_SOG = 0
        SET_MAX_SOG = 1
        SET_MIN_SOG = 2
        SET_DEFAULT_SOG = 3
        SET_COMMAND_SRM = 4
        SET_MAX_SRM = 5
        SET_MIN_SRM = 6
        SET_DEFAULT_SRM = 7

    command_type: SetVelocityCommandExt.CommandType | int
    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("CommandType", rt.Number("B", rt.Values(SetVelocityCommandExt.CommandType))),
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("RollRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("PitchRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("YawRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x04B5: raise rt.Reject
        raw = iter(_M_SetVelocityCommandExt[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        command_type_ = raw()
        self.command_type = _E_SetVelocityCommandExt_CommandType[command_type_]
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        if mask & 8:
            roll_rate_ = raw()
            self.roll_rate = 32.767 if roll_rate_ == 4294967295 else -32.768 + roll_rate_ * 1.5258556235409003e-08
        else: self.roll_rate = None
        if mask & 16:
            pitch_rate_ = raw()
            self.pitch_rate = 32.767 if pitch_rate_ == 4294967295 else -32.768 + pitch_rate_ * 1.5258556235409003e-08
        else: self.pitch_rate = None
        if mask & 32:
            yaw_rate_ = raw()
            self.yaw_rate = 32.767 if yaw_rate_ == 4294967295 else -32.768 + yaw_rate_ * 1.5258556235409003e-08
        else: self.yaw_rate = None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        command_type_ = self.command_type
        if command_type_ not in _E_SetVelocityCommandExt_CommandType: raise rt.Reject
        raw.append(command_type_)
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_3)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_3)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_3)
            raw.append(velocity_z_raw_)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 8
            if not -32.768 <= roll_rate_ <= 32.767: raise rt.Reject
            near = roll_rate_ * 65537000.0 + 2147516416.5
            roll_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_rate_raw_ < 0.9999847412109375: roll_rate_raw_ = rt.exact_raw(roll_rate_, _R_4)
            raw.append(roll_rate_raw_)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 16
            if not -32.768 <= pitch_rate_ <= 32.767: raise rt.Reject
            near = pitch_rate_ * 65537000.0 + 2147516416.5
            pitch_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_rate_raw_ < 0.9999847412109375: pitch_rate_raw_ = rt.exact_raw(pitch_rate_, _R_4)
            raw.append(pitch_rate_raw_)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 32
            if not -32.768 <= yaw_rate_ <= 32.767: raise rt.Reject
            near = yaw_rate_ * 65537000.0 + 2147516416.5
            yaw_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_rate_raw_ < 0.9999847412109375: yaw_rate_raw_ = rt.exact_raw(yaw_rate_, _R_4)
            raw.append(yaw_rate_raw_)
        return _M_SetVelocityCommandExt_pack[mask & 0x3F].pack(0x04B5, mask, *raw)


@dataclass(slots=True, repr=False)
class SetAccelerationLimit(rt.Message):
    """SetAccelerationLimit (0x0416): Sets the limits of acceleration or deceleration.

    command_type: CommandType. Whether speeding up or slowing down is limited
    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Limit along X, in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Limit along Y, in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Limit along Z, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Z, in radians per second squared
    """

    CODE = 0x0416
    NAME = "SetAccelerationLimit"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class CommandType(IntEnum):
        """Values of CommandType."""

        MAX_ACCELERATION = 1
        MAX_DECELERATION = 2

    command_type: SetAccelerationLimit.CommandType | int
    acceleration_x: float | None = None
    acceleration_y: float | None = None
    acceleration_z: float | None = None
    roll_acceleration: float | None = None
    pitch_acceleration: float | None = None
    yaw_acceleration: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("CommandType", rt.Number("B", rt.Values(SetAccelerationLimit.CommandType))),
            ("Acceleration_X", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Y", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Z", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("RollAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("PitchAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("YawAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0416: raise rt.Reject
        raw = iter(_M_SetVelocityCommandExt[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        command_type_ = raw()
        self.command_type = _E_SetAccelerationLimit_CommandType[command_type_]
        self.acceleration_x = -1310.68 + raw() * 6.103329361906119e-07 if mask & 1 else None
        self.acceleration_y = -1310.68 + raw() * 6.103329361906119e-07 if mask & 2 else None
        self.acceleration_z = -1310.68 + raw() * 6.103329361906119e-07 if mask & 4 else None
        self.roll_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 8 else None
        self.pitch_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 16 else None
        self.yaw_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        command_type_ = self.command_type
        if command_type_ not in _E_SetAccelerationLimit_CommandType: raise rt.Reject
        raw.append(command_type_)
        acceleration_x_ = self.acceleration_x
        if acceleration_x_ is not None:
            mask |= 1
            if not -1310.68 <= acceleration_x_ <= 1310.68: raise rt.Reject
            near = acceleration_x_ * 1638450.001144444 + 2147483648.0
            acceleration_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_x_raw_ < 0.9999847412109375: acceleration_x_raw_ = rt.exact_raw(acceleration_x_, _R_7)
            raw.append(acceleration_x_raw_)
        acceleration_y_ = self.acceleration_y
        if acceleration_y_ is not None:
            mask |= 2
            if not -1310.68 <= acceleration_y_ <= 1310.68: raise rt.Reject
            near = acceleration_y_ * 1638450.001144444 + 2147483648.0
            acceleration_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_y_raw_ < 0.9999847412109375: acceleration_y_raw_ = rt.exact_raw(acceleration_y_, _R_7)
            raw.append(acceleration_y_raw_)
        acceleration_z_ = self.acceleration_z
        if acceleration_z_ is not None:
            mask |= 4
            if not -1310.68 <= acceleration_z_ <= 1310.68: raise rt.Reject
            near = acceleration_z_ * 1638450.001144444 + 2147483648.0
            acceleration_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_z_raw_ < 0.9999847412109375: acceleration_z_raw_ = rt.exact_raw(acceleration_z_, _R_7)
            raw.append(acceleration_z_raw_)
        roll_acceleration_ = self.roll_acceleration
        if roll_acceleration_ is not None:
            mask |= 8
            if not -13106.8 <= roll_acceleration_ <= 13106.8: raise rt.Reject
            near = roll_acceleration_ * 163845.0001144444 + 2147483647.9999998
            roll_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_acceleration_raw_ < 0.9999847412109375: roll_acceleration_raw_ = rt.exact_raw(roll_acceleration_, _R_8)
            raw.append(roll_acceleration_raw_)
        pitch_acceleration_ = self.pitch_acceleration
        if pitch_acceleration_ is not None:
            mask |= 16
            if not -13106.8 <= pitch_acceleration_ <= 13106.8: raise rt.Reject
            near = pitch_acceleration_ * 163845.0001144444 + 2147483647.9999998
            pitch_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_acceleration_raw_ < 0.9999847412109375: pitch_acceleration_raw_ = rt.exact_raw(pitch_acceleration_, _R_8)
            raw.append(pitch_acceleration_raw_)
        yaw_acceleration_ = self.yaw_acceleration
        if yaw_acceleration_ is not None:
            mask |= 32
            if not -13106.8 <= yaw_acceleration_ <= 13106.8: raise rt.Reject
            near = yaw_acceleration_ * 163845.0001144444 + 2147483647.9999998
            yaw_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_acceleration_raw_ < 0.9999847412109375: yaw_acceleration_raw_ = rt.exact_raw(yaw_acceleration_, _R_8)
            raw.append(yaw_acceleration_raw_)
        return _M_SetVelocityCommandExt_pack[mask & 0x3F].pack(0x0416, mask, *raw)


class QueryVelocityCommand(mobility_v1_0_velocity_state_driver.QueryVelocityCommand):
    """QueryVelocityCommand (0x2415): Asks for the wanted velocity, its default, or one of its limits."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportVelocityCommand]]


@dataclass(slots=True, repr=False)
class QueryVelocityCommandExt(rt.Message):
    """QueryVelocityCommandExt (0x24B5): As QueryVelocityCommand, for speed over ground or through the medium.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    command_type: Which velocity is asked for; as in the report
    """

    CODE = 0x24B5
    NAME = "QueryVelocityCommandExt"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVelocityCommandExt]]

    presence_vector: int
    command_type: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("B")),
            ("CommandType", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector, self.command_type = _S_H2B.unpack(data)
        if code != 0x24B5: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0x24B5, self.presence_vector, self.command_type)


@dataclass(slots=True, repr=False)
class QueryAccelerationLimit(rt.Message):
    """QueryAccelerationLimit (0x2416): Asks for the limits of acceleration or deceleration.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    command_type: Which limit is asked for; as in the report
    """

    CODE = 0x2416
    NAME = "QueryAccelerationLimit"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAccelerationLimit]]

    presence_vector: int
    command_type: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("B")),
            ("CommandType", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector, self.command_type = _S_H2B.unpack(data)
        if code != 0x2416: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0x2416, self.presence_vector, self.command_type)


class ReportVelocityCommand(mobility_v1_0_velocity_state_driver.ReportVelocityCommand):
    """ReportVelocityCommand (0x4415): Tells the wanted velocity, its default, or one of its limits."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportVelocityCommandExt(rt.Message):
    """ReportVelocityCommandExt (0x44B5): As ReportVelocityCommand, for speed over ground or through the medium.

    command_type: CommandType. The wanted velocity, its default, or a limit; over ground (SOG) or through the medium (SRM)
    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    """

    CODE = 0x44B5
    NAME = "ReportVelocityCommandExt"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class CommandType(IntEnum):
        """Values of CommandType."""

        SET_COMMAND_SOG = 0
        SET_MAX_SOG = 1
        SET_MIN_SOG = 2
        SET_DEFAULT_SOG = 3
        SET_COMMAND_SRM = 4
        SET_MAX_SRM = 5
        SET_MIN_SRM = 6
        SET_DEFAULT_SRM = 7

    command_type: ReportVelocityCommandExt.CommandType | int
    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("CommandType", rt.Number("B", rt.Values(ReportVelocityCommandExt.CommandType))),
            ("Velocity_X", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Y", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("Velocity_Z", rt.real("I", -327.68, 327.67, "meter per second"), True),
            ("RollRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("PitchRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
            ("YawRate", rt.real("I", -32.768, 32.767, "radian per second"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x44B5: raise rt.Reject
        raw = iter(_M_SetVelocityCommandExt[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        command_type_ = raw()
        self.command_type = _E_ReportVelocityCommandExt_CommandType[command_type_]
        self.velocity_x = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
        self.velocity_y = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
        self.velocity_z = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
        if mask & 8:
            roll_rate_ = raw()
            self.roll_rate = 32.767 if roll_rate_ == 4294967295 else -32.768 + roll_rate_ * 1.5258556235409003e-08
        else: self.roll_rate = None
        if mask & 16:
            pitch_rate_ = raw()
            self.pitch_rate = 32.767 if pitch_rate_ == 4294967295 else -32.768 + pitch_rate_ * 1.5258556235409003e-08
        else: self.pitch_rate = None
        if mask & 32:
            yaw_rate_ = raw()
            self.yaw_rate = 32.767 if yaw_rate_ == 4294967295 else -32.768 + yaw_rate_ * 1.5258556235409003e-08
        else: self.yaw_rate = None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        command_type_ = self.command_type
        if command_type_ not in _E_ReportVelocityCommandExt_CommandType: raise rt.Reject
        raw.append(command_type_)
        velocity_x_ = self.velocity_x
        if velocity_x_ is not None:
            mask |= 1
            if not -327.68 <= velocity_x_ <= 327.67: raise rt.Reject
            near = velocity_x_ * 6553700.0 + 2147516416.5
            velocity_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_x_raw_ < 0.9999847412109375: velocity_x_raw_ = rt.exact_raw(velocity_x_, _R_3)
            raw.append(velocity_x_raw_)
        velocity_y_ = self.velocity_y
        if velocity_y_ is not None:
            mask |= 2
            if not -327.68 <= velocity_y_ <= 327.67: raise rt.Reject
            near = velocity_y_ * 6553700.0 + 2147516416.5
            velocity_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_y_raw_ < 0.9999847412109375: velocity_y_raw_ = rt.exact_raw(velocity_y_, _R_3)
            raw.append(velocity_y_raw_)
        velocity_z_ = self.velocity_z
        if velocity_z_ is not None:
            mask |= 4
            if not -327.68 <= velocity_z_ <= 327.67: raise rt.Reject
            near = velocity_z_ * 6553700.0 + 2147516416.5
            velocity_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - velocity_z_raw_ < 0.9999847412109375: velocity_z_raw_ = rt.exact_raw(velocity_z_, _R_3)
            raw.append(velocity_z_raw_)
        roll_rate_ = self.roll_rate
        if roll_rate_ is not None:
            mask |= 8
            if not -32.768 <= roll_rate_ <= 32.767: raise rt.Reject
            near = roll_rate_ * 65537000.0 + 2147516416.5
            roll_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_rate_raw_ < 0.9999847412109375: roll_rate_raw_ = rt.exact_raw(roll_rate_, _R_4)
            raw.append(roll_rate_raw_)
        pitch_rate_ = self.pitch_rate
        if pitch_rate_ is not None:
            mask |= 16
            if not -32.768 <= pitch_rate_ <= 32.767: raise rt.Reject
            near = pitch_rate_ * 65537000.0 + 2147516416.5
            pitch_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_rate_raw_ < 0.9999847412109375: pitch_rate_raw_ = rt.exact_raw(pitch_rate_, _R_4)
            raw.append(pitch_rate_raw_)
        yaw_rate_ = self.yaw_rate
        if yaw_rate_ is not None:
            mask |= 32
            if not -32.768 <= yaw_rate_ <= 32.767: raise rt.Reject
            near = yaw_rate_ * 65537000.0 + 2147516416.5
            yaw_rate_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_rate_raw_ < 0.9999847412109375: yaw_rate_raw_ = rt.exact_raw(yaw_rate_, _R_4)
            raw.append(yaw_rate_raw_)
        return _M_SetVelocityCommandExt_pack[mask & 0x3F].pack(0x44B5, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportAccelerationLimit(rt.Message):
    """ReportAccelerationLimit (0x4416): Tells the limits of acceleration or deceleration.

    command_type: CommandType. Whether speeding up or slowing down is limited
    acceleration_x: -1310.68..1310.68 meter per second squared, optional. Limit along X, in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Limit along Y, in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Limit along Z, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Limit about Z, in radians per second squared
    """

    CODE = 0x4416
    NAME = "ReportAccelerationLimit"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateDriver"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class CommandType(IntEnum):
        """Values of CommandType."""

        MAX_ACCELERATION = 1
        MAX_DECELERATION = 2

    command_type: ReportAccelerationLimit.CommandType | int
    acceleration_x: float | None = None
    acceleration_y: float | None = None
    acceleration_z: float | None = None
    roll_acceleration: float | None = None
    pitch_acceleration: float | None = None
    yaw_acceleration: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("CommandType", rt.Number("B", rt.Values(ReportAccelerationLimit.CommandType))),
            ("Acceleration_X", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Y", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("Acceleration_Z", rt.real("I", -1310.68, 1310.68, "meter per second squared"), True),
            ("RollAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("PitchAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
            ("YawAcceleration", rt.real("I", -13106.8, 13106.8, "radian per second squared"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4416: raise rt.Reject
        raw = iter(_M_SetVelocityCommandExt[mask & 0x3F].unpack(data)).__next__
        self = rt.new(cls)
        command_type_ = raw()
        self.command_type = _E_ReportAccelerationLimit_CommandType[command_type_]
        self.acceleration_x = -1310.68 + raw() * 6.103329361906119e-07 if mask & 1 else None
        self.acceleration_y = -1310.68 + raw() * 6.103329361906119e-07 if mask & 2 else None
        self.acceleration_z = -1310.68 + raw() * 6.103329361906119e-07 if mask & 4 else None
        self.roll_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 8 else None
        self.pitch_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 16 else None
        self.yaw_acceleration = -13106.8 + raw() * 6.103329361906118e-06 if mask & 32 else None
        self.reserved_presence = mask & 0xC0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        raw: list[int | float | bytes] = []
        command_type_ = self.command_type
        if command_type_ not in _E_ReportAccelerationLimit_CommandType: raise rt.Reject
        raw.append(command_type_)
        acceleration_x_ = self.acceleration_x
        if acceleration_x_ is not None:
            mask |= 1
            if not -1310.68 <= acceleration_x_ <= 1310.68: raise rt.Reject
            near = acceleration_x_ * 1638450.001144444 + 2147483648.0
            acceleration_x_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_x_raw_ < 0.9999847412109375: acceleration_x_raw_ = rt.exact_raw(acceleration_x_, _R_7)
            raw.append(acceleration_x_raw_)
        acceleration_y_ = self.acceleration_y
        if acceleration_y_ is not None:
            mask |= 2
            if not -1310.68 <= acceleration_y_ <= 1310.68: raise rt.Reject
            near = acceleration_y_ * 1638450.001144444 + 2147483648.0
            acceleration_y_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_y_raw_ < 0.9999847412109375: acceleration_y_raw_ = rt.exact_raw(acceleration_y_, _R_7)
            raw.append(acceleration_y_raw_)
        acceleration_z_ = self.acceleration_z
        if acceleration_z_ is not None:
            mask |= 4
            if not -1310.68 <= acceleration_z_ <= 1310.68: raise rt.Reject
            near = acceleration_z_ * 1638450.001144444 + 2147483648.0
            acceleration_z_raw_ = int(near)
            if not 1.52587890625e-05 < near - acceleration_z_raw_ < 0.9999847412109375: acceleration_z_raw_ = rt.exact_raw(acceleration_z_, _R_7)
            raw.append(acceleration_z_raw_)
        roll_acceleration_ = self.roll_acceleration
        if roll_acceleration_ is not None:
            mask |= 8
            if not -13106.8 <= roll_acceleration_ <= 13106.8: raise rt.Reject
            near = roll_acceleration_ * 163845.0001144444 + 2147483647.9999998
            roll_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_acceleration_raw_ < 0.9999847412109375: roll_acceleration_raw_ = rt.exact_raw(roll_acceleration_, _R_8)
            raw.append(roll_acceleration_raw_)
        pitch_acceleration_ = self.pitch_acceleration
        if pitch_acceleration_ is not None:
            mask |= 16
            if not -13106.8 <= pitch_acceleration_ <= 13106.8: raise rt.Reject
            near = pitch_acceleration_ * 163845.0001144444 + 2147483647.9999998
            pitch_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_acceleration_raw_ < 0.9999847412109375: pitch_acceleration_raw_ = rt.exact_raw(pitch_acceleration_, _R_8)
            raw.append(pitch_acceleration_raw_)
        yaw_acceleration_ = self.yaw_acceleration
        if yaw_acceleration_ is not None:
            mask |= 32
            if not -13106.8 <= yaw_acceleration_ <= 13106.8: raise rt.Reject
            near = yaw_acceleration_ * 163845.0001144444 + 2147483647.9999998
            yaw_acceleration_raw_ = int(near)
            if not 1.52587890625e-05 < near - yaw_acceleration_raw_ < 0.9999847412109375: yaw_acceleration_raw_ = rt.exact_raw(yaw_acceleration_, _R_8)
            raw.append(yaw_acceleration_raw_)
        return _M_SetVelocityCommandExt_pack[mask & 0x3F].pack(0x4416, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetVelocityCommandExt = rt.Masks("3x", ((0, "B"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I")))
_E_SetVelocityCommandExt_CommandType = rt.members(SetVelocityCommandExt.CommandType)
_R_3 = rt.Scaling(-327.68, 327.67, 4294967295)
_R_4 = rt.Scaling(-32.768, 32.767, 4294967295)
_M_SetVelocityCommandExt_pack = rt.Masks("HB", ((0, "B"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I")))
_E_SetAccelerationLimit_CommandType = rt.members(SetAccelerationLimit.CommandType)
_R_7 = rt.Scaling(-1310.68, 1310.68, 4294967295)
_R_8 = rt.Scaling(-13106.8, 13106.8, 4294967295)
_S_H2B = rt.Packer("<H2B")
_E_ReportVelocityCommandExt_CommandType = rt.members(ReportVelocityCommandExt.CommandType)
_E_ReportAccelerationLimit_CommandType = rt.members(ReportAccelerationLimit.CommandType)
QueryVelocityCommand.REPORT = ReportVelocityCommand
QueryVelocityCommandExt.REPORT = ReportVelocityCommandExt
QueryAccelerationLimit.REPORT = ReportAccelerationLimit
