"""PlatformSpecifications and SkidSteerDriver: size and limits of a chassis, efforts of its tracks (AS6091)."""

from __future__ import annotations

import math
from typing import Final

from jauspy.messages.ugv import (
    ReportAckermannConfiguration,
    ReportPlatformSpecifications,
    ReportSkidSteerEffort,
    SetAckermannConfiguration,
    SetSkidSteerEffort,
)
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.units import effort_or_zero


class PlatformSpecifications(Service, urn="urn:jaus:jss:ugv:PlatformSpecifications"):
    """Size and limits of the chassis in the platform's frame: x forward, y right, z down, from the base's origin."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle

    def send_report_platform_specifications(self) -> ReportPlatformSpecifications:
        """Report all known values; the roll at which the platform tips follows from the centre of gravity."""
        chassis = self._vehicle.chassis
        return ReportPlatformSpecifications(
            platform_specifics=_specifics(chassis),
            platform_inertial=_inertial(chassis),
            platform_spec=_spec(self._vehicle.name, chassis),
        )


def _specifics(
    chassis: Chassis,
) -> ReportPlatformSpecifications.Skidsteer | ReportPlatformSpecifications.Ackermann:
    """The standard knows chassis that skid and chassis that steer; mecanum wheels are reported as the former."""
    radius = chassis.wheel_radius or None
    if chassis.min_turn_radius:
        return ReportPlatformSpecifications.Ackermann(
            steering_angle_range=chassis.steering_angle,
            min_turn_radius=chassis.min_turn_radius,
            wheel_separation=chassis.track_separation,
            drive_wheel_radius=radius,
        )
    return ReportPlatformSpecifications.Skidsteer(track_separation=chassis.track_separation, drive_wheel_radius=radius)


def _inertial(chassis: Chassis) -> ReportPlatformSpecifications.PlatformInertial:
    return ReportPlatformSpecifications.PlatformInertial(
        maximum_forward_speed=chassis.max_speed,
        maximum_reverse_speed=chassis.max_speed,
        maximum_rotational_speed=chassis.max_turn_rate,
        maximum_forward_acceleration=chassis.acceleration,
        maximum_reverse_acceleration=chassis.acceleration,
        maximum_forward_deceleration=chassis.deceleration,
        maximum_reverse_deceleration=chassis.deceleration,
    )


def _spec(name: str, chassis: Chassis) -> ReportPlatformSpecifications.PlatformSpec:
    x, y, z = chassis.centre_of_gravity
    return ReportPlatformSpecifications.PlatformSpec(
        mobility_platform_name=name,
        front=chassis.front,
        back=chassis.back,
        right=chassis.right,
        left=chassis.left,
        bottom=chassis.bottom,
        top=chassis.top,
        wheel_base=chassis.wheel_base or None,
        xcg=x,
        ycg=-y,
        zcg=-z,
        static_roll_over=math.atan2(chassis.track_separation / 2.0 - abs(y), z),
        vehicle_weight=chassis.mass,
    )


class AckermannDriver(Driver, urn="urn:jaus:jss:ugv:AckermannDriver"):
    """Steering angle, in radians to the right, and throttle, in percent, of a chassis that steers.

    The standard's throttle drives forward only. The brake is either released or, above zero percent, full. Limits of
    the steering's rate and torque are ignored: they are those of its motors.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._angle = self._throttle = self._brake = 0.0

    def set_ackermann_configuration(self, msg: SetAckermannConfiguration) -> None:
        """Steer and drive until the next command."""
        limit = self.vehicle.chassis.steering_angle
        self._angle = min(limit, max(-limit, msg.steering_angle))
        self._brake = msg.brake_effort
        self._throttle = 0.0 if self._brake > MIN_BRAKE else msg.throttle_effort
        self.vehicle.pilot.set_effort(self, forward=self._throttle / 100.0, right=self._angle / limit)

    def stop_motion(self) -> None:
        """Runs when Ready is left, for whatever reason."""
        self.vehicle.pilot.stop()

    def on_preempted(self) -> None:
        """The throttle is closed."""
        self._throttle = 0.0

    def send_report_ackermann_configuration(self) -> ReportAckermannConfiguration:
        """Report the commanded steering and throttle; throttle zero after a stop, or while another service drives."""
        return ReportAckermannConfiguration(self._angle, self._throttle, self._brake)


MIN_BRAKE: Final = 0.01
"""Percent; the zero of the field is less."""


class SkidSteerDriver(Driver, urn="urn:jaus:jss:ugv:SkidSteerDriver"):
    """Percent of the full effort of each side, positive forward; shares the chassis with the drivers of mobility."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._left = self._right = 0.0

    def set_skid_steer_effort(self, msg: SetSkidSteerEffort) -> None:
        """Reached only in Ready, from the controlling client."""
        self._left = effort_or_zero(msg.left_side_propulsive_effort)
        self._right = effort_or_zero(msg.right_side_propulsive_effort)
        forward, right = (self._left + self._right) / 200.0, (self._left - self._right) / 200.0
        self.vehicle.pilot.set_effort(self, forward=forward, right=right)

    def stop_motion(self) -> None:
        """Runs when Ready is left, for whatever reason."""
        self.vehicle.pilot.stop()

    def on_preempted(self) -> None:
        """The efforts end."""
        self._left = self._right = 0.0

    def send_report_skid_steer_effort(self) -> ReportSkidSteerEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service drives."""
        return ReportSkidSteerEffort(left_side_propulsive_effort=self._left, right_side_propulsive_effort=self._right)
