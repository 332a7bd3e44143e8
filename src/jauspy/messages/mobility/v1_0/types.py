"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

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

    class ZPositionChoice(IntEnum):
        """Values of ZPositionChoice."""

        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    choice: ZPosition.ZPositionChoice | int
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
            rt.Values(ZPosition.ZPositionChoice),
        )


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
