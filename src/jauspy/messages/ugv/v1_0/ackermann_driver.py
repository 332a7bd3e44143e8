"""urn:jaus:jss:ugv:AckermannDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:AckermannDriver", "1.0")


@jd.message(_SERVICE, 0x0500, presence="B", command=True)
class SetAckermannConfiguration(jd.Message):
    """SetAckermannConfiguration (0x0500): Sets throttle, brake and steering.

    steering_angle: -1.57079632679..1.57079632679 radian. Angle of the steered wheels, in radians; positive turns right
    throttle_effort: 0..100. Throttle, in percent of the maximum
    brake_effort: 0..100. Brake, in percent of the maximum
    max_steering_rate: 0..32.767 radian per second, optional. Largest rate of the steering angle, in radians per second
    max_steering_torque: 0..500 newton meter, optional. Largest torque on the steering, in newton metres
    """
    steering_angle: float = jd.field("SteeringAngle", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"))
    throttle_effort: float = jd.field("ThrottleEffort", jd.real("H", 0.0, 100.0))
    brake_effort: float = jd.field("BrakeEffort", jd.real("H", 0.0, 100.0))
    max_steering_rate: float | None = jd.field("MaxSteeringRate", jd.real("H", 0.0, 32.767, "radian per second"), default=None)
    max_steering_torque: float | None = jd.field("MaxSteeringTorque", jd.real("H", 0.0, 500.0, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4500, presence="B")
class ReportAckermannConfiguration(jd.Message):
    """ReportAckermannConfiguration (0x4500): Tells throttle, brake and steering.

    steering_angle: -1.57079632679..1.57079632679 radian. Angle of the steered wheels, in radians; positive turns right
    throttle_effort: 0..100. Throttle, in percent of the maximum
    brake_effort: 0..100. Brake, in percent of the maximum
    steering_rate: -32.767..32.768 radian per second, optional. Rate of the steering angle, in radians per second
    steering_torque: -500..500 newton meter, optional. Torque on the steering, in newton metres
    """
    steering_angle: float = jd.field("SteeringAngle", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"))
    throttle_effort: float = jd.field("ThrottleEffort", jd.real("H", 0.0, 100.0))
    brake_effort: float = jd.field("BrakeEffort", jd.real("H", 0.0, 100.0))
    steering_rate: float | None = jd.field("SteeringRate", jd.real("H", -32.767, 32.768, "radian per second"), default=None)
    steering_torque: float | None = jd.field("SteeringTorque", jd.real("H", -500.0, 500.0, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2500, query=True)
class QueryAckermannConfiguration(jd.Message):
    """QueryAckermannConfiguration (0x2500): Asks for throttle, brake and steering."""
    REPORT = ReportAckermannConfiguration
