"""A chassis on wheels without a physics engine, on an endless flat floor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.wheels import WheelDrive, WheelSetup

RESPONSE: Final = 0.15
"""Seconds, the time constant with which a wheel follows its effort."""
FRICTION: Final = 0.2
"""m/s^2, the deceleration by friction in the drive."""
BRAKE: Final = 4.0
"""m/s^2 that the brake adds at zero effort."""


class KinematicWheels(WheelDrive):
    """A `DriveBase`; its wheels never slip, but for those that skid."""

    def __init__(self, wheels: WheelSetup) -> None:
        super().__init__(wheels)
        self._efforts = (0.0,) * len(wheels.wheels)
        self._speeds = [0.0] * len(wheels.wheels)
        self._angle = self._wanted_angle = 0.0
        self._x = self._y = self._yaw = 0.0

    def set_wheel_efforts(self, efforts: tuple[float, ...], steering: float | None) -> None:
        """Drive the wheels and steer."""
        self._efforts = efforts
        self._wanted_angle = self._wanted_angle if steering is None else steering

    def pose(self) -> Pose:
        """Pose on the floor; the yaw is within -pi..pi."""
        return Pose(x=self._x, y=self._y, yaw=math.remainder(self._yaw, math.tau))

    def twist(self) -> Twist:
        """As the wheels roll."""
        vx, vy, wz = self.odometry()
        return Twist(vx=vx, vy=vy, wz=wz)

    def rim_speeds(self) -> Sequence[float]:
        """m/s, positive forward."""
        return self._speeds

    @property
    def steering(self) -> float:
        """To the left."""
        return self._angle

    def step(self, dt: float) -> None:
        """Move for `dt` seconds."""
        before = self.twist()
        braking = not any(self._efforts)
        for number, (wheel, effort) in enumerate(zip(self.wheels.wheels, self._efforts, strict=True)):
            self._speeds[number] = _speed_after(self._speeds[number], effort * wheel.speed, dt, braking=braking)
        if self.wheels.steering:
            change = min(each.joint.velocity for each in self.wheels.steering) * dt
            self._angle += min(change, max(-change, self._wanted_angle - self._angle))
        after = self.twist()
        vx, vy, wz = ((b + a) / 2.0 for b, a in ((before.vx, after.vx), (before.vy, after.vy), (before.wz, after.wz)))
        heading = self._yaw + wz * dt / 2.0
        self._x += (vx * math.cos(heading) - vy * math.sin(heading)) * dt
        self._y += (vx * math.sin(heading) + vy * math.cos(heading)) * dt
        self._yaw += wz * dt


def _speed_after(speed: float, free: float, dt: float, *, braking: bool) -> float:
    """The speed of a rim, m/s, that would reach `free` without resistance; friction never reverses it."""
    driven = speed + (free - speed) * (1.0 - math.exp(-dt / RESPONSE))
    resistance = (FRICTION + (BRAKE if braking else 0.0)) * dt
    return math.copysign(max(0.0, abs(driven) - resistance), driven)
