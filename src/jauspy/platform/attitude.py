"""Attitude from an inertial measurement unit: the gyroscope is integrated, gravity corrects roll and pitch.

A complementary filter on quaternions, after Mahony, Hamel and Pflimlin (2008).
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.vectors import Quaternion, Vector
from jauspy.platform.motion_sensors import GRAVITY

GRAVITY_TIME: Final = 3.0
"""Seconds in which gravity corrects roll and pitch to a part of 1/e."""
MAX_SHOCK: Final = 2.0
"""m/s^2 between the measured force and gravity above which it corrects nothing."""


class AttitudeFilter:
    """The attitude of the base in a frame with z up. Starts with roll and pitch by the force at rest, and a yaw."""

    def __init__(self, force: Vector, yaw: float) -> None:
        x, y, z = force
        self.quaternion = _from_angles(math.atan2(y, z), math.atan2(-x, math.hypot(y, z)), yaw)

    def up(self) -> Vector:
        """The vertical, in the frame of the base."""
        w, x, y, z = self.quaternion
        return 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)

    def forward(self) -> Vector:
        """The x axis of the base, in the outer frame."""
        w, x, y, z = self.quaternion
        return 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)

    def angles(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw, radians."""
        w, x, y, z = self.quaternion
        roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
        pitch = math.asin(min(1.0, max(-1.0, 2.0 * (w * y - z * x))))
        return roll, pitch, math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))

    def turn(self, rates: Vector, force: Vector, dt: float) -> None:
        """Turn at `rates` (rad/s) for `dt` seconds; `force` (m/s^2) is what holds against gravity alone."""
        wx, wy, wz = rates
        fx, fy, fz = force
        length = math.sqrt(fx * fx + fy * fy + fz * fz)
        if abs(length - GRAVITY) < MAX_SHOCK:
            ux, uy, uz = self.up()
            gain = 1.0 / (GRAVITY_TIME * length)
            wx += gain * (fy * uz - fz * uy)
            wy += gain * (fz * ux - fx * uz)
            wz += gain * (fx * uy - fy * ux)
        self.quaternion = _turned(self.quaternion, (wx * dt, wy * dt, wz * dt))


def _turned(quaternion: Quaternion, turn: Vector) -> Quaternion:
    """The attitude after a turn in its own frame; of unit length."""
    w, x, y, z = quaternion
    a, b, c = turn
    angle = math.sqrt(a * a + b * b + c * c)
    factor = math.sin(angle / 2.0) / angle if angle > 1e-12 else 0.5
    d, a, b, c = math.cos(angle / 2.0), a * factor, b * factor, c * factor
    w, x, y, z = (
        w * d - x * a - y * b - z * c,
        w * a + x * d + y * c - z * b,
        w * b - x * c + y * d + z * a,
        w * c + x * b - y * a + z * d,
    )
    scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
    return w * scale, x * scale, y * scale, z * scale


def _from_angles(roll: float, pitch: float, yaw: float) -> Quaternion:
    cr, sr = math.cos(roll / 2.0), math.sin(roll / 2.0)
    cp, sp = math.cos(pitch / 2.0), math.sin(pitch / 2.0)
    cy, sy = math.cos(yaw / 2.0), math.sin(yaw / 2.0)
    return (
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    )
