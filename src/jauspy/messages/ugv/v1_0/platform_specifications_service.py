"""urn:jaus:jss:ugv:PlatformSpecifications 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryPlatformSpecifications(rt.Message):
    """QueryPlatformSpecifications (0x2502): Asks for size, mass and limits of the platform."""

    CODE = 0x2502
    NAME = "QueryPlatformSpecifications"
    SERVICE = "urn:jaus:jss:ugv:PlatformSpecifications"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPlatformSpecifications]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2502)


@dataclass(slots=True, repr=False)
class ReportPlatformSpecifications(rt.Message):
    """ReportPlatformSpecifications (0x4502): Tells size, mass and limits of the platform.

    platform_specifics: How the platform steers
    """

    CODE = 0x4502
    NAME = "ReportPlatformSpecifications"
    SERVICE = "urn:jaus:jss:ugv:PlatformSpecifications"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class Skidsteer(rt.Struct):
        """Skidsteer.

        track_separation: 0..30 meter, optional. Distance from left to right track, in metres
        drive_wheel_radius: 0..10 meter, optional. Radius of the driven wheels, in metres
        """

        track_separation: float | None = None
        drive_wheel_radius: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("TrackSeparation", rt.real("H", 0.0, 30.0, "meter"), True),
                ("DriveWheelRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPlatformSpecifications_Skidsteer_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.track_separation = raw() * 0.00045777065690089265 if mask & 1 else None
            self.drive_wheel_radius = raw() * 0.00015259021896696422 if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            track_separation_ = self.track_separation
            if track_separation_ is not None:
                mask |= 1
                if not 0.0 <= track_separation_ <= 30.0: raise rt.Reject
                near = track_separation_ * 2184.5 + 0.5
                track_separation_raw_ = int(near)
                if not 1.52587890625e-05 < near - track_separation_raw_ < 0.9999847412109375: track_separation_raw_ = rt.exact_raw(track_separation_, _R_2)
                raw.append(track_separation_raw_)
            drive_wheel_radius_ = self.drive_wheel_radius
            if drive_wheel_radius_ is not None:
                mask |= 2
                if not 0.0 <= drive_wheel_radius_ <= 10.0: raise rt.Reject
                near = drive_wheel_radius_ * 6553.5 + 0.5
                drive_wheel_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - drive_wheel_radius_raw_ < 0.9999847412109375: drive_wheel_radius_raw_ = rt.exact_raw(drive_wheel_radius_, _R_3)
                raw.append(drive_wheel_radius_raw_)
            out += _M_ReportPlatformSpecifications_Skidsteer_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class Ackermann(rt.Struct):
        """Ackermann.

        steering_angle_range: -1.57079632679..1.57079632679 radian, optional. Largest steering angle, in radians
        min_turn_radius: 0..25 meter, optional. Smallest radius of turn, in metres
        wheel_separation: 0..30 meter, optional. Distance from left to right wheels, in metres
        drive_wheel_radius: 0..10 meter, optional. Radius of the driven wheels, in metres
        """

        steering_angle_range: float | None = None
        min_turn_radius: float | None = None
        wheel_separation: float | None = None
        drive_wheel_radius: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SteeringAngleRange", rt.real("H", -1.5707963267948966, 1.5707963267948966, "radian"), True),
                ("MinTurnRadius", rt.real("H", 0.0, 25.0, "meter"), True),
                ("WheelSeparation", rt.real("H", 0.0, 30.0, "meter"), True),
                ("DriveWheelRadius", rt.real("H", 0.0, 10.0, "meter"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPlatformSpecifications_Ackermann_0[mask & 0xF]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.steering_angle_range = -1.5707963267948966 + raw() * 4.793763109162727e-05 if mask & 1 else None
            self.min_turn_radius = raw() * 0.00038147554741741054 if mask & 2 else None
            self.wheel_separation = raw() * 0.00045777065690089265 if mask & 4 else None
            self.drive_wheel_radius = raw() * 0.00015259021896696422 if mask & 8 else None
            self.reserved_presence = mask & 0xF0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0xF: raise rt.Reject
            raw: list[int | float | bytes] = []
            steering_angle_range_ = self.steering_angle_range
            if steering_angle_range_ is not None:
                mask |= 1
                if not -1.5707963267948966 <= steering_angle_range_ <= 1.5707963267948966: raise rt.Reject
                near = steering_angle_range_ * 20860.438391054722 + 32768.0
                steering_angle_range_raw_ = int(near)
                if not 1.52587890625e-05 < near - steering_angle_range_raw_ < 0.9999847412109375: steering_angle_range_raw_ = rt.exact_raw(steering_angle_range_, _R_6)
                raw.append(steering_angle_range_raw_)
            min_turn_radius_ = self.min_turn_radius
            if min_turn_radius_ is not None:
                mask |= 2
                if not 0.0 <= min_turn_radius_ <= 25.0: raise rt.Reject
                near = min_turn_radius_ * 2621.4 + 0.5
                min_turn_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - min_turn_radius_raw_ < 0.9999847412109375: min_turn_radius_raw_ = rt.exact_raw(min_turn_radius_, _R_7)
                raw.append(min_turn_radius_raw_)
            wheel_separation_ = self.wheel_separation
            if wheel_separation_ is not None:
                mask |= 4
                if not 0.0 <= wheel_separation_ <= 30.0: raise rt.Reject
                near = wheel_separation_ * 2184.5 + 0.5
                wheel_separation_raw_ = int(near)
                if not 1.52587890625e-05 < near - wheel_separation_raw_ < 0.9999847412109375: wheel_separation_raw_ = rt.exact_raw(wheel_separation_, _R_2)
                raw.append(wheel_separation_raw_)
            drive_wheel_radius_ = self.drive_wheel_radius
            if drive_wheel_radius_ is not None:
                mask |= 8
                if not 0.0 <= drive_wheel_radius_ <= 10.0: raise rt.Reject
                near = drive_wheel_radius_ * 6553.5 + 0.5
                drive_wheel_radius_raw_ = int(near)
                if not 1.52587890625e-05 < near - drive_wheel_radius_raw_ < 0.9999847412109375: drive_wheel_radius_raw_ = rt.exact_raw(drive_wheel_radius_, _R_3)
                raw.append(drive_wheel_radius_raw_)
            out += _M_ReportPlatformSpecifications_Ackermann_0[mask & 0xF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PlatformInertial(rt.Struct):
        """PlatformInertial.

        maximum_forward_speed: 0..90 meter per second, optional. Largest speed forward, in metres per second
        maximum_reverse_speed: 0..90 meter per second, optional. Largest speed backward, in metres per second
        maximum_rotational_speed: 0..6.28 radian per second, optional. Largest angular velocity about Z, in radians per second
        maximum_forward_acceleration: 0..40 meter per second squared, optional. Largest acceleration forward, in metres per second squared
        maximum_reverse_acceleration: 0..40 meter per second squared, optional. Largest acceleration backward, in metres per second squared
        maximum_forward_deceleration: 0..40 meter per second squared, optional. Largest deceleration driving forward, in metres per second squared
        maximum_reverse_deceleration: 0..40 meter per second squared, optional. Largest deceleration driving backward, in metres per second squared
        """

        maximum_forward_speed: float | None = None
        maximum_reverse_speed: float | None = None
        maximum_rotational_speed: float | None = None
        maximum_forward_acceleration: float | None = None
        maximum_reverse_acceleration: float | None = None
        maximum_forward_deceleration: float | None = None
        maximum_reverse_deceleration: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("MaximumForwardSpeed", rt.real("H", 0.0, 90.0, "meter per second"), True),
                ("MaximumReverseSpeed", rt.real("H", 0.0, 90.0, "meter per second"), True),
                ("MaximumRotationalSpeed", rt.real("H", 0.0, 6.28, "radian per second"), True),
                ("MaximumForwardAcceleration", rt.real("B", 0.0, 40.0, "meter per second squared"), True),
                ("MaximumReverseAcceleration", rt.real("B", 0.0, 40.0, "meter per second squared"), True),
                ("MaximumForwardDeceleration", rt.real("B", 0.0, 40.0, "meter per second squared"), True),
                ("MaximumReverseDeceleration", rt.real("B", 0.0, 40.0, "meter per second squared"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportPlatformSpecifications_PlatformInertial_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.maximum_forward_speed = raw() * 0.001373311970702678 if mask & 1 else None
            self.maximum_reverse_speed = raw() * 0.001373311970702678 if mask & 2 else None
            self.maximum_rotational_speed = raw() * 9.582665751125353e-05 if mask & 4 else None
            self.maximum_forward_acceleration = raw() * 0.1568627450980392 if mask & 8 else None
            self.maximum_reverse_acceleration = raw() * 0.1568627450980392 if mask & 16 else None
            self.maximum_forward_deceleration = raw() * 0.1568627450980392 if mask & 32 else None
            self.maximum_reverse_deceleration = raw() * 0.1568627450980392 if mask & 64 else None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            maximum_forward_speed_ = self.maximum_forward_speed
            if maximum_forward_speed_ is not None:
                mask |= 1
                if not 0.0 <= maximum_forward_speed_ <= 90.0: raise rt.Reject
                near = maximum_forward_speed_ * 728.1666666666666 + 0.5
                maximum_forward_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_forward_speed_raw_ < 0.9999847412109375: maximum_forward_speed_raw_ = rt.exact_raw(maximum_forward_speed_, _R_9)
                raw.append(maximum_forward_speed_raw_)
            maximum_reverse_speed_ = self.maximum_reverse_speed
            if maximum_reverse_speed_ is not None:
                mask |= 2
                if not 0.0 <= maximum_reverse_speed_ <= 90.0: raise rt.Reject
                near = maximum_reverse_speed_ * 728.1666666666666 + 0.5
                maximum_reverse_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_reverse_speed_raw_ < 0.9999847412109375: maximum_reverse_speed_raw_ = rt.exact_raw(maximum_reverse_speed_, _R_9)
                raw.append(maximum_reverse_speed_raw_)
            maximum_rotational_speed_ = self.maximum_rotational_speed
            if maximum_rotational_speed_ is not None:
                mask |= 4
                if not 0.0 <= maximum_rotational_speed_ <= 6.28: raise rt.Reject
                near = maximum_rotational_speed_ * 10435.509554140128 + 0.5
                maximum_rotational_speed_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_rotational_speed_raw_ < 0.9999847412109375: maximum_rotational_speed_raw_ = rt.exact_raw(maximum_rotational_speed_, _R_10)
                raw.append(maximum_rotational_speed_raw_)
            maximum_forward_acceleration_ = self.maximum_forward_acceleration
            if maximum_forward_acceleration_ is not None:
                mask |= 8
                if not 0.0 <= maximum_forward_acceleration_ <= 40.0: raise rt.Reject
                near = maximum_forward_acceleration_ * 6.375 + 0.5
                maximum_forward_acceleration_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_forward_acceleration_raw_ < 0.9999847412109375: maximum_forward_acceleration_raw_ = rt.exact_raw(maximum_forward_acceleration_, _R_11)
                raw.append(maximum_forward_acceleration_raw_)
            maximum_reverse_acceleration_ = self.maximum_reverse_acceleration
            if maximum_reverse_acceleration_ is not None:
                mask |= 16
                if not 0.0 <= maximum_reverse_acceleration_ <= 40.0: raise rt.Reject
                near = maximum_reverse_acceleration_ * 6.375 + 0.5
                maximum_reverse_acceleration_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_reverse_acceleration_raw_ < 0.9999847412109375: maximum_reverse_acceleration_raw_ = rt.exact_raw(maximum_reverse_acceleration_, _R_11)
                raw.append(maximum_reverse_acceleration_raw_)
            maximum_forward_deceleration_ = self.maximum_forward_deceleration
            if maximum_forward_deceleration_ is not None:
                mask |= 32
                if not 0.0 <= maximum_forward_deceleration_ <= 40.0: raise rt.Reject
                near = maximum_forward_deceleration_ * 6.375 + 0.5
                maximum_forward_deceleration_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_forward_deceleration_raw_ < 0.9999847412109375: maximum_forward_deceleration_raw_ = rt.exact_raw(maximum_forward_deceleration_, _R_11)
                raw.append(maximum_forward_deceleration_raw_)
            maximum_reverse_deceleration_ = self.maximum_reverse_deceleration
            if maximum_reverse_deceleration_ is not None:
                mask |= 64
                if not 0.0 <= maximum_reverse_deceleration_ <= 40.0: raise rt.Reject
                near = maximum_reverse_deceleration_ * 6.375 + 0.5
                maximum_reverse_deceleration_raw_ = int(near)
                if not 1.52587890625e-05 < near - maximum_reverse_deceleration_raw_ < 0.9999847412109375: maximum_reverse_deceleration_raw_ = rt.exact_raw(maximum_reverse_deceleration_, _R_11)
                raw.append(maximum_reverse_deceleration_raw_)
            out += _M_ReportPlatformSpecifications_PlatformInertial_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class PlatformSpec(rt.Struct):
        """PlatformSpec.

        mobility_platform_name: up to 255 characters. Name of the platform, for people
        front: 0..30 meter, optional. Distance from the origin to the front, in metres
        back: 0..30 meter, optional. Distance from the origin to the back, in metres
        right: 0..30 meter, optional. Distance from the origin to the right, in metres
        left: 0..30 meter, optional. Distance from the origin to the left, in metres
        bottom: 0..30 meter, optional. Distance from the origin to the bottom, in metres
        top: 0..30 meter, optional. Distance from the origin to the top, in metres
        xcg: -30..30 meter, optional. Position of the centre of gravity along X, in metres
        ycg: -30..30 meter, optional. Position of the centre of gravity along Y, in metres
        zcg: -30..30 meter, optional. Position of the centre of gravity along Z, in metres
        wheel_base: 0..60 meter, optional. Distance from front to rear axle, in metres
        static_pitch_over: -3.14159265359..3.14159265359 radian, optional. Pitch at which the platform tips, in radians
        static_roll_over: -3.14159265359..3.14159265359 radian, optional. Roll at which the platform tips, in radians
        vehicle_weight: 0..1000000 kilogram, optional. Mass, in kilograms
        approach_angle: 0..1.57079632679 radian, optional. Steepest slope that can be driven onto, in radians
        departure_angle: 0..1.57079632679 radian, optional. Steepest slope that can be driven off, in radians
        break_over_angle: 0..1.57079632679 radian, optional. Sharpest crest that can be driven over, in radians
        """

        mobility_platform_name: str
        front: float | None = None
        back: float | None = None
        right: float | None = None
        left: float | None = None
        bottom: float | None = None
        top: float | None = None
        xcg: float | None = None
        ycg: float | None = None
        zcg: float | None = None
        wheel_base: float | None = None
        static_pitch_over: float | None = None
        static_roll_over: float | None = None
        vehicle_weight: float | None = None
        approach_angle: float | None = None
        departure_angle: float | None = None
        break_over_angle: float | None = None

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "H",
                ("MobilityPlatformName", rt.Text(count=rt.Count("B", 0, 255))),
                ("Front", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Back", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Right", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Left", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Bottom", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Top", rt.real("H", 0.0, 30.0, "meter"), True),
                ("Xcg", rt.real("H", -30.0, 30.0, "meter"), True),
                ("Ycg", rt.real("H", -30.0, 30.0, "meter"), True),
                ("Zcg", rt.real("H", -30.0, 30.0, "meter"), True),
                ("WheelBase", rt.real("H", 0.0, 60.0, "meter"), True),
                ("StaticPitchOver", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("StaticRollOver", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
                ("VehicleWeight", rt.real("I", 0.0, 1000000.0, "kilogram"), True),
                ("ApproachAngle", rt.real("H", 0.0, 1.5707963267948966, "radian"), True),
                ("DepartureAngle", rt.real("H", 0.0, 1.5707963267948966, "radian"), True),
                ("BreakOverAngle", rt.real("H", 0.0, 1.5707963267948966, "radian"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (mask,) = _S_H.unpack_from(data, at)
            mobility_platform_name_end_ = at + 3 + data[at + 2]
            self.mobility_platform_name = data[at + 3:mobility_platform_name_end_].decode("latin-1")
            packer = _M_ReportPlatformSpecifications_PlatformSpec_1[mask & 0xFFFF]
            raw = iter(packer.unpack_from(data, mobility_platform_name_end_)).__next__
            at = mobility_platform_name_end_ + packer.size
            self.front = raw() * 0.00045777065690089265 if mask & 1 else None
            self.back = raw() * 0.00045777065690089265 if mask & 2 else None
            self.right = raw() * 0.00045777065690089265 if mask & 4 else None
            self.left = raw() * 0.00045777065690089265 if mask & 8 else None
            self.bottom = raw() * 0.00045777065690089265 if mask & 16 else None
            self.top = raw() * 0.00045777065690089265 if mask & 32 else None
            self.xcg = -30.0 + raw() * 0.0009155413138017853 if mask & 64 else None
            self.ycg = -30.0 + raw() * 0.0009155413138017853 if mask & 128 else None
            self.zcg = -30.0 + raw() * 0.0009155413138017853 if mask & 256 else None
            self.wheel_base = raw() * 0.0009155413138017853 if mask & 512 else None
            self.static_pitch_over = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
            self.static_roll_over = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2048 else None
            self.vehicle_weight = raw() * 0.00023283064370807974 if mask & 4096 else None
            self.approach_angle = raw() * 2.3968815545813636e-05 if mask & 8192 else None
            self.departure_angle = raw() * 2.3968815545813636e-05 if mask & 16384 else None
            self.break_over_angle = raw() * 2.3968815545813636e-05 if mask & 32768 else None
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0\0"
            mask = 0
            mobility_platform_name_raw_ = self.mobility_platform_name.encode("latin-1")
            out.append(len(mobility_platform_name_raw_))
            out += mobility_platform_name_raw_
            raw: list[int | float | bytes] = []
            front_ = self.front
            if front_ is not None:
                mask |= 1
                if not 0.0 <= front_ <= 30.0: raise rt.Reject
                near = front_ * 2184.5 + 0.5
                front_raw_ = int(near)
                if not 1.52587890625e-05 < near - front_raw_ < 0.9999847412109375: front_raw_ = rt.exact_raw(front_, _R_2)
                raw.append(front_raw_)
            back_ = self.back
            if back_ is not None:
                mask |= 2
                if not 0.0 <= back_ <= 30.0: raise rt.Reject
                near = back_ * 2184.5 + 0.5
                back_raw_ = int(near)
                if not 1.52587890625e-05 < near - back_raw_ < 0.9999847412109375: back_raw_ = rt.exact_raw(back_, _R_2)
                raw.append(back_raw_)
            right_ = self.right
            if right_ is not None:
                mask |= 4
                if not 0.0 <= right_ <= 30.0: raise rt.Reject
                near = right_ * 2184.5 + 0.5
                right_raw_ = int(near)
                if not 1.52587890625e-05 < near - right_raw_ < 0.9999847412109375: right_raw_ = rt.exact_raw(right_, _R_2)
                raw.append(right_raw_)
            left_ = self.left
            if left_ is not None:
                mask |= 8
                if not 0.0 <= left_ <= 30.0: raise rt.Reject
                near = left_ * 2184.5 + 0.5
                left_raw_ = int(near)
                if not 1.52587890625e-05 < near - left_raw_ < 0.9999847412109375: left_raw_ = rt.exact_raw(left_, _R_2)
                raw.append(left_raw_)
            bottom_ = self.bottom
            if bottom_ is not None:
                mask |= 16
                if not 0.0 <= bottom_ <= 30.0: raise rt.Reject
                near = bottom_ * 2184.5 + 0.5
                bottom_raw_ = int(near)
                if not 1.52587890625e-05 < near - bottom_raw_ < 0.9999847412109375: bottom_raw_ = rt.exact_raw(bottom_, _R_2)
                raw.append(bottom_raw_)
            top_ = self.top
            if top_ is not None:
                mask |= 32
                if not 0.0 <= top_ <= 30.0: raise rt.Reject
                near = top_ * 2184.5 + 0.5
                top_raw_ = int(near)
                if not 1.52587890625e-05 < near - top_raw_ < 0.9999847412109375: top_raw_ = rt.exact_raw(top_, _R_2)
                raw.append(top_raw_)
            xcg_ = self.xcg
            if xcg_ is not None:
                mask |= 64
                if not -30.0 <= xcg_ <= 30.0: raise rt.Reject
                near = xcg_ * 1092.25 + 32768.0
                xcg_raw_ = int(near)
                if not 1.52587890625e-05 < near - xcg_raw_ < 0.9999847412109375: xcg_raw_ = rt.exact_raw(xcg_, _R_13)
                raw.append(xcg_raw_)
            ycg_ = self.ycg
            if ycg_ is not None:
                mask |= 128
                if not -30.0 <= ycg_ <= 30.0: raise rt.Reject
                near = ycg_ * 1092.25 + 32768.0
                ycg_raw_ = int(near)
                if not 1.52587890625e-05 < near - ycg_raw_ < 0.9999847412109375: ycg_raw_ = rt.exact_raw(ycg_, _R_13)
                raw.append(ycg_raw_)
            zcg_ = self.zcg
            if zcg_ is not None:
                mask |= 256
                if not -30.0 <= zcg_ <= 30.0: raise rt.Reject
                near = zcg_ * 1092.25 + 32768.0
                zcg_raw_ = int(near)
                if not 1.52587890625e-05 < near - zcg_raw_ < 0.9999847412109375: zcg_raw_ = rt.exact_raw(zcg_, _R_13)
                raw.append(zcg_raw_)
            wheel_base_ = self.wheel_base
            if wheel_base_ is not None:
                mask |= 512
                if not 0.0 <= wheel_base_ <= 60.0: raise rt.Reject
                near = wheel_base_ * 1092.25 + 0.5
                wheel_base_raw_ = int(near)
                if not 1.52587890625e-05 < near - wheel_base_raw_ < 0.9999847412109375: wheel_base_raw_ = rt.exact_raw(wheel_base_, _R_14)
                raw.append(wheel_base_raw_)
            static_pitch_over_ = self.static_pitch_over
            if static_pitch_over_ is not None:
                mask |= 1024
                if not -3.141592653589793 <= static_pitch_over_ <= 3.141592653589793: raise rt.Reject
                near = static_pitch_over_ * 10430.219195527361 + 32768.0
                static_pitch_over_raw_ = int(near)
                if not 1.52587890625e-05 < near - static_pitch_over_raw_ < 0.9999847412109375: static_pitch_over_raw_ = rt.exact_raw(static_pitch_over_, _R_15)
                raw.append(static_pitch_over_raw_)
            static_roll_over_ = self.static_roll_over
            if static_roll_over_ is not None:
                mask |= 2048
                if not -3.141592653589793 <= static_roll_over_ <= 3.141592653589793: raise rt.Reject
                near = static_roll_over_ * 10430.219195527361 + 32768.0
                static_roll_over_raw_ = int(near)
                if not 1.52587890625e-05 < near - static_roll_over_raw_ < 0.9999847412109375: static_roll_over_raw_ = rt.exact_raw(static_roll_over_, _R_15)
                raw.append(static_roll_over_raw_)
            vehicle_weight_ = self.vehicle_weight
            if vehicle_weight_ is not None:
                mask |= 4096
                if not 0.0 <= vehicle_weight_ <= 1000000.0: raise rt.Reject
                near = vehicle_weight_ * 4294.967295 + 0.5
                vehicle_weight_raw_ = int(near)
                if not 1.52587890625e-05 < near - vehicle_weight_raw_ < 0.9999847412109375: vehicle_weight_raw_ = rt.exact_raw(vehicle_weight_, _R_16)
                raw.append(vehicle_weight_raw_)
            approach_angle_ = self.approach_angle
            if approach_angle_ is not None:
                mask |= 8192
                if not 0.0 <= approach_angle_ <= 1.5707963267948966: raise rt.Reject
                near = approach_angle_ * 41720.876782109444 + 0.5
                approach_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - approach_angle_raw_ < 0.9999847412109375: approach_angle_raw_ = rt.exact_raw(approach_angle_, _R_17)
                raw.append(approach_angle_raw_)
            departure_angle_ = self.departure_angle
            if departure_angle_ is not None:
                mask |= 16384
                if not 0.0 <= departure_angle_ <= 1.5707963267948966: raise rt.Reject
                near = departure_angle_ * 41720.876782109444 + 0.5
                departure_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - departure_angle_raw_ < 0.9999847412109375: departure_angle_raw_ = rt.exact_raw(departure_angle_, _R_17)
                raw.append(departure_angle_raw_)
            break_over_angle_ = self.break_over_angle
            if break_over_angle_ is not None:
                mask |= 32768
                if not 0.0 <= break_over_angle_ <= 1.5707963267948966: raise rt.Reject
                near = break_over_angle_ * 41720.876782109444 + 0.5
                break_over_angle_raw_ = int(near)
                if not 1.52587890625e-05 < near - break_over_angle_raw_ < 0.9999847412109375: break_over_angle_raw_ = rt.exact_raw(break_over_angle_, _R_17)
                raw.append(break_over_angle_raw_)
            out += _M_ReportPlatformSpecifications_PlatformSpec_1[mask & 0xFFFF].pack(*raw)
            _S_H.pack_into(out, start, mask)

    platform_specifics: ReportPlatformSpecifications.Skidsteer | ReportPlatformSpecifications.Ackermann
    platform_inertial: ReportPlatformSpecifications.PlatformInertial
    platform_spec: ReportPlatformSpecifications.PlatformSpec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("platformSpecifics", rt.Union.of("B", skidsteer=ReportPlatformSpecifications.Skidsteer, ackermann=ReportPlatformSpecifications.Ackermann)),
            ("platformInertial", ReportPlatformSpecifications.PlatformInertial.layout()),
            ("platformSpec", ReportPlatformSpecifications.PlatformSpec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        tag = data[2]
        at = 3
        self.platform_specifics, at = _U_18[tag]._read(data, at, nesting)
        self.platform_inertial, at = ReportPlatformSpecifications.PlatformInertial._read(data, at, nesting)
        self.platform_spec, at = ReportPlatformSpecifications.PlatformSpec._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x45")
        platform_specifics_ = self.platform_specifics
        out.append(_T_19[type(platform_specifics_)])
        platform_specifics_._write(out)
        platform_inertial_ = self.platform_inertial
        if type(platform_inertial_) is not ReportPlatformSpecifications.PlatformInertial: raise rt.Reject
        platform_inertial_._write(out)
        platform_spec_ = self.platform_spec
        if type(platform_spec_) is not ReportPlatformSpecifications.PlatformSpec: raise rt.Reject
        platform_spec_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_M_ReportPlatformSpecifications_Skidsteer_0 = rt.Masks("", ((1, "H"), (2, "H")))
_R_2 = rt.Scaling(0.0, 30.0, 65535)
_R_3 = rt.Scaling(0.0, 10.0, 65535)
_S_B = rt.Packer("<B")
_M_ReportPlatformSpecifications_Ackermann_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H")))
_R_6 = rt.Scaling(-1.5707963267948966, 1.5707963267948966, 65535)
_R_7 = rt.Scaling(0.0, 25.0, 65535)
_M_ReportPlatformSpecifications_PlatformInertial_0 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "B"), (16, "B"), (32, "B"), (64, "B")))
_R_9 = rt.Scaling(0.0, 90.0, 65535)
_R_10 = rt.Scaling(0.0, 6.28, 65535)
_R_11 = rt.Scaling(0.0, 40.0, 255)
_M_ReportPlatformSpecifications_PlatformSpec_1 = rt.Masks("", ((1, "H"), (2, "H"), (4, "H"), (8, "H"), (16, "H"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "I"), (8192, "H"), (16384, "H"), (32768, "H")))
_R_13 = rt.Scaling(-30.0, 30.0, 65535)
_R_14 = rt.Scaling(0.0, 60.0, 65535)
_R_15 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_16 = rt.Scaling(0.0, 1000000.0, 4294967295)
_R_17 = rt.Scaling(0.0, 1.5707963267948966, 65535)
_U_18: tuple[type[ReportPlatformSpecifications.Skidsteer] | type[ReportPlatformSpecifications.Ackermann], ...] = (ReportPlatformSpecifications.Skidsteer, ReportPlatformSpecifications.Ackermann)
_T_19: dict[type[rt.Struct], int] = {ReportPlatformSpecifications.Skidsteer: 0, ReportPlatformSpecifications.Ackermann: 1}
QueryPlatformSpecifications.REPORT = ReportPlatformSpecifications
