"""urn:jaus:jss:ugv:PlatformSpecifications 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:PlatformSpecifications", "1.0")


@jd.message(_SERVICE, 0x4502)
class ReportPlatformSpecifications(jd.Message):
    """ReportPlatformSpecifications (0x4502): Tells size, mass and limits of the platform.

    platform_specifics: How the platform steers
    """

    @jd.record("B")
    class Skidsteer(jd.Struct):
        """track_separation: 0..30 meter, optional. Distance from left to right track, in metres
        drive_wheel_radius: 0..10 meter, optional. Radius of the driven wheels, in metres
        """
        track_separation: float | None = jd.field("TrackSeparation", jd.real("H", 0.0, 30.0, "meter"), default=None)
        drive_wheel_radius: float | None = jd.field("DriveWheelRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class Ackermann(jd.Struct):
        """steering_angle_range: -1.57079632679..1.57079632679 radian, optional. Largest steering angle, in radians
        min_turn_radius: 0..25 meter, optional. Smallest radius of turn, in metres
        wheel_separation: 0..30 meter, optional. Distance from left to right wheels, in metres
        drive_wheel_radius: 0..10 meter, optional. Radius of the driven wheels, in metres
        """
        steering_angle_range: float | None = jd.field("SteeringAngleRange", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"), default=None)
        min_turn_radius: float | None = jd.field("MinTurnRadius", jd.real("H", 0.0, 25.0, "meter"), default=None)
        wheel_separation: float | None = jd.field("WheelSeparation", jd.real("H", 0.0, 30.0, "meter"), default=None)
        drive_wheel_radius: float | None = jd.field("DriveWheelRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class PlatformInertial(jd.Struct):
        """maximum_forward_speed: 0..90 meter per second, optional. Largest speed forward, in metres per second
        maximum_reverse_speed: 0..90 meter per second, optional. Largest speed backward, in metres per second
        maximum_rotational_speed: 0..6.28 radian per second, optional. Largest angular velocity about Z, in radians per second
        maximum_forward_acceleration: 0..40 meter per second squared, optional. Largest acceleration forward, in metres per second squared
        maximum_reverse_acceleration: 0..40 meter per second squared, optional. Largest acceleration backward, in metres per second squared
        maximum_forward_deceleration: 0..40 meter per second squared, optional. Largest deceleration driving forward, in metres per second squared
        maximum_reverse_deceleration: 0..40 meter per second squared, optional. Largest deceleration driving backward, in metres per second squared
        """
        maximum_forward_speed: float | None = jd.field("MaximumForwardSpeed", jd.real("H", 0.0, 90.0, "meter per second"), default=None)
        maximum_reverse_speed: float | None = jd.field("MaximumReverseSpeed", jd.real("H", 0.0, 90.0, "meter per second"), default=None)
        maximum_rotational_speed: float | None = jd.field("MaximumRotationalSpeed", jd.real("H", 0.0, 6.28, "radian per second"), default=None)
        maximum_forward_acceleration: float | None = jd.field("MaximumForwardAcceleration", jd.real("B", 0.0, 40.0, "meter per second squared"), default=None)
        maximum_reverse_acceleration: float | None = jd.field("MaximumReverseAcceleration", jd.real("B", 0.0, 40.0, "meter per second squared"), default=None)
        maximum_forward_deceleration: float | None = jd.field("MaximumForwardDeceleration", jd.real("B", 0.0, 40.0, "meter per second squared"), default=None)
        maximum_reverse_deceleration: float | None = jd.field("MaximumReverseDeceleration", jd.real("B", 0.0, 40.0, "meter per second squared"), default=None)
        reserved_presence: int = 0

    @jd.record("H")
    class PlatformSpec(jd.Struct):
        """mobility_platform_name: up to 255 characters. Name of the platform, for people
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
        mobility_platform_name: str = jd.field("MobilityPlatformName", jd.Text(count=jd.Count("B", 0, 255)))
        front: float | None = jd.field("Front", jd.real("H", 0.0, 30.0, "meter"), default=None)
        back: float | None = jd.field("Back", jd.real("H", 0.0, 30.0, "meter"), default=None)
        right: float | None = jd.field("Right", jd.real("H", 0.0, 30.0, "meter"), default=None)
        left: float | None = jd.field("Left", jd.real("H", 0.0, 30.0, "meter"), default=None)
        bottom: float | None = jd.field("Bottom", jd.real("H", 0.0, 30.0, "meter"), default=None)
        top: float | None = jd.field("Top", jd.real("H", 0.0, 30.0, "meter"), default=None)
        xcg: float | None = jd.field("Xcg", jd.real("H", -30.0, 30.0, "meter"), default=None)
        ycg: float | None = jd.field("Ycg", jd.real("H", -30.0, 30.0, "meter"), default=None)
        zcg: float | None = jd.field("Zcg", jd.real("H", -30.0, 30.0, "meter"), default=None)
        wheel_base: float | None = jd.field("WheelBase", jd.real("H", 0.0, 60.0, "meter"), default=None)
        static_pitch_over: float | None = jd.field("StaticPitchOver", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        static_roll_over: float | None = jd.field("StaticRollOver", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vehicle_weight: float | None = jd.field("VehicleWeight", jd.real("I", 0.0, 1000000.0, "kilogram"), default=None)
        approach_angle: float | None = jd.field("ApproachAngle", jd.real("H", 0.0, 1.5707963267948966, "radian"), default=None)
        departure_angle: float | None = jd.field("DepartureAngle", jd.real("H", 0.0, 1.5707963267948966, "radian"), default=None)
        break_over_angle: float | None = jd.field("BreakOverAngle", jd.real("H", 0.0, 1.5707963267948966, "radian"), default=None)

    platform_specifics: ReportPlatformSpecifications.Skidsteer | ReportPlatformSpecifications.Ackermann = jd.field("platformSpecifics", lambda: jd.Union.of("B", skidsteer=ReportPlatformSpecifications.Skidsteer, ackermann=ReportPlatformSpecifications.Ackermann))
    platform_inertial: ReportPlatformSpecifications.PlatformInertial = jd.field("platformInertial", lambda: ReportPlatformSpecifications.PlatformInertial.layout())
    platform_spec: ReportPlatformSpecifications.PlatformSpec = jd.field("platformSpec", lambda: ReportPlatformSpecifications.PlatformSpec.layout())


@jd.message(_SERVICE, 0x2502, query=True)
class QueryPlatformSpecifications(jd.Message):
    """QueryPlatformSpecifications (0x2502): Asks for size, mass and limits of the platform."""
    REPORT = ReportPlatformSpecifications
