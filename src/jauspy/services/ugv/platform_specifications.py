"""PlatformSpecifications: size, mass and limits of the platform (AS6091)."""

from __future__ import annotations

import math

from jauspy.messages.ugv import ReportPlatformSpecifications
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service


class PlatformSpecifications(Service, urn="urn:jaus:jss:ugv:PlatformSpecifications"):
    """What the chassis is like, in the platform's frame: x forward, y right, z down, from the base's origin."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle

    def send_report_platform_specifications(self) -> ReportPlatformSpecifications:
        """Everything that is known; the roll at which it tips follows from the centre of gravity."""
        chassis = self._vehicle.chassis
        return ReportPlatformSpecifications(
            platform_specifics=ReportPlatformSpecifications.Skidsteer(track_separation=chassis.track_separation),
            platform_inertial=_inertial(chassis),
            platform_spec=_spec(self._vehicle.name, chassis),
        )


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
        xcg=x,
        ycg=-y,
        zcg=-z,
        static_roll_over=math.atan2(chassis.track_separation / 2.0 - abs(y), z),
        vehicle_weight=chassis.mass,
    )
