"""Models of the sensors that measure a robot's motion: encoders, inertial measurement unit, satellite navigation.

They take the truth from a simulation. Errors are normally distributed, and come from a generator with a seed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random
from typing import TypeAlias

from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.vectors import GRAVITY, Rotation, Vector, add, rotated, transposed
from jauspy.platform.localization import GnssSetup, ImuSetup, OdometrySetup

PlanarSpeeds: TypeAlias = tuple[float, float, float]
"""m/s forward and to the left, rad/s to the left."""


@dataclass(frozen=True, slots=True)
class Travel:
    """Distance by encoders: metres forward and to the left, and radians to the left, in the frame of the base."""

    forward: float
    left: float
    turn: float


def generator(seed: int, sensor: str) -> Random:
    """A generator of errors for each sensor, so that one does not change those of another."""
    return Random(f"{seed} {sensor}")  # noqa: S311 - errors, not secrets


class Encoders:
    """Integrate the speed at which tracks or wheels turn."""

    def __init__(self, setup: OdometrySetup, random: Random) -> None:
        self._setup = setup
        self._random = random
        self._scale = 1.0 + random.gauss(0.0, setup.scale_error)
        self._forward = self._left = self._turn = 0.0
        self._rest = (0.0, 0.0)
        """Metres that were not enough for a count."""

    def count(self, speeds: PlanarSpeeds, dt: float) -> None:
        """The chassis would have moved at these speeds for `dt` seconds if nothing slipped."""
        vx, vy, wz = speeds
        self._forward += vx * dt
        self._left += vy * dt
        self._turn += wz * dt

    def read(self) -> Travel:
        """Distance since the last call."""
        way = math.hypot(self._forward, self._left)
        scale = self._scale + (self._random.gauss(0.0, self._setup.noise) / math.sqrt(way) if way else 0.0)
        forward, left = scale * self._forward + self._rest[0], scale * self._left + self._rest[1]
        step = self._setup.resolution
        travel = Travel(step * round(forward / step), step * round(left / step), self._scale * self._turn)
        self._rest = (forward - travel.forward, left - travel.left)
        self._forward = self._left = self._turn = 0.0
        return travel


class InertialSensor:
    """Measures rates and specific force, as means over an interval, in the frame of the base."""

    def __init__(self, setup: ImuSetup, random: Random, pose: Pose, twist: Twist) -> None:
        self._setup = setup
        self._random = random
        self._rate_bias = _three(random, setup.gyro_bias)
        self._force_bias = _three(random, setup.acceleration_bias)
        self._scales = add((1.0, 1.0, 1.0), _three(random, setup.gyro_scale_error))
        self._attitude = _rotation(pose)
        self._velocity = rotated(self._attitude, (twist.vx, twist.vy, twist.vz))

    def align(self) -> tuple[Vector, Vector]:
        """Mean rates and force of `setup.alignment` seconds at rest, which show the biases of the rates."""
        self._walk(self._setup.alignment)
        force = rotated(transposed(self._attitude), (0.0, 0.0, GRAVITY))
        return self._noisy((0.0, 0.0, 0.0), force, self._setup.alignment)

    def measure(self, pose: Pose, twist: Twist, dt: float) -> tuple[Vector, Vector]:
        """Mean rates (rad/s) and force (m/s^2) over the last `dt` seconds, at whose end the motion is this."""
        # written out, since it runs fifty times a second
        before, attitude = self._attitude, _rotation(pose)
        (ux, uy, uz), (vx, vy, vz) = self._velocity, rotated(attitude, (twist.vx, twist.vy, twist.vz))
        self._attitude, self._velocity = attitude, (vx, vy, vz)
        force = rotated(transposed(attitude), ((vx - ux) / dt, (vy - uy) / dt, (vz - uz) / dt + GRAVITY))
        x, y, z = _turn(before, attitude)
        a, b, c = self._scales
        self._walk(dt)
        return self._noisy((x * a / dt, y * b / dt, z * c / dt), force, dt)

    def _walk(self, dt: float) -> None:
        x, y, z = self._rate_bias
        dx, dy, dz = _three(self._random, self._setup.gyro_bias_walk * math.sqrt(dt))
        self._rate_bias = (x + dx, y + dy, z + dz)

    def _noisy(self, rates: Vector, force: Vector, dt: float) -> tuple[Vector, Vector]:
        width = 1.0 / math.sqrt(dt)
        rates = add(add(rates, self._rate_bias), _three(self._random, self._setup.gyro_noise * width))
        force = add(add(force, self._force_bias), _three(self._random, self._setup.acceleration_noise * width))
        return rates, force


class GnssReceiver:
    """Measures the position in the world."""

    def __init__(self, setup: GnssSetup, random: Random) -> None:
        self._setup = setup
        self._random = random
        self._scales = (1.0, 1.0, setup.vertical)
        self._drift = [random.gauss(0.0, setup.drift * scale) for scale in self._scales]
        self._time = 0.0
        self.heading_error = random.gauss(0.0, setup.heading_error)
        """Radians, of the compass at the start."""

    def fix(self, pose: Pose, now: float) -> Vector:
        """The position of a pose, at a time in seconds."""
        setup, gauss = self._setup, self._random.gauss
        kept = math.exp((self._time - now) / setup.drift_time)
        fresh = setup.drift * math.sqrt(1.0 - kept * kept)
        self._time = now
        self._drift = [
            kept * drift + gauss(0.0, fresh * scale) for drift, scale in zip(self._drift, self._scales, strict=True)
        ]
        x, y, z = (
            true + drift + gauss(0.0, setup.noise * scale)
            for true, drift, scale in zip((pose.x, pose.y, pose.z), self._drift, self._scales, strict=True)
        )
        return x, y, z


def _three(random: Random, deviation: float) -> Vector:
    return random.gauss(0.0, deviation), random.gauss(0.0, deviation), random.gauss(0.0, deviation)


def _rotation(pose: Pose) -> Rotation:
    """The attitude of a pose, as `Transform.from_pose` has it."""
    cr, sr, cp, sp = math.cos(pose.roll), math.sin(pose.roll), math.cos(pose.pitch), math.sin(pose.pitch)
    cy, sy = math.cos(pose.yaw), math.sin(pose.yaw)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def _turn(start: Rotation, end: Rotation) -> Vector:
    """The rotation vector, in the moving frame, from one attitude to another, less than a right angle away."""
    # half the difference of the product's elements beside its diagonal: the sum of the vector products of the rows
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = start
    (ux, uy, uz), (vx, vy, vz), (wx, wy, wz) = end
    x = (uy * az - uz * ay + vy * bz - vz * by + wy * cz - wz * cy) / 2.0
    y = (uz * ax - ux * az + vz * bx - vx * bz + wz * cx - wx * cz) / 2.0
    z = (ux * ay - uy * ax + vx * by - vy * bx + wx * cy - wy * cx) / 2.0
    sine = min(1.0, math.sqrt(x * x + y * y + z * z))
    factor = math.asin(sine) / sine if sine > 1e-9 else 1.0
    return x * factor, y * factor, z * factor
