"""The units of a drive (counts, counts per second, thousandths of the rated torque) and those of its joint (SI)."""

from __future__ import annotations

import math
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.servo_drives import STOP_TIME, DriveSetup, VelocityUnit

MAX_INT32: Final = 2**31 - 1
THOUSANDTHS: Final = 1000
"""Torques are in thousandths of the rated one (6071h, 6077h)."""
MAX_TORQUE: Final = 2**15 - 1


class DriveUnits:
    """Converts between a drive and the joint that it moves. The only place that knows gear, encoder and sign."""

    def __init__(self, setup: DriveSetup, joint: Joint) -> None:
        turns = joint.kind is not JointKind.PRISMATIC
        if not turns and setup.travel is None:
            raise ConfigError(
                f"can.drives.{setup.name}.travel: is missing; {joint.name!r} is prismatic: give the metres that it "
                "moves for one turn of the gear's output"
            )
        per_turn = math.tau if turns else float(setup.travel or 0.0)
        self._scale = setup.sign * setup.encoder_counts * setup.gear_ratio / per_turn
        self._zero = setup.zero
        self._rpm = setup.velocity_unit is VelocityUnit.RPM
        self._counts_per_turn = setup.encoder_counts
        self._sign = setup.sign
        self.rated_effort = setup.rated_effort or joint.effort
        """Newton metres or newtons."""
        self.stop_deceleration = setup.stop_deceleration or joint.velocity / STOP_TIME
        """rad/s^2 or m/s^2."""
        if not self.rated_effort:
            raise ConfigError(
                f"can.drives.{setup.name}.rated_effort: is missing, and the URDF gives {joint.name!r} no effort"
            )

    @property
    def resolution(self) -> float:
        """Radians or metres of one count."""
        return 1.0 / abs(self._scale)

    def counts(self, position: float) -> int:
        """The count of the encoder at a position of the joint, radians or metres."""
        return _limited(self._zero + position * self._scale, MAX_INT32)

    def position_counts(self, position: float) -> int:
        """Count of an endless encoder at a position; for simulated drives, which wrap it."""
        return round(self._zero + position * self._scale)

    def position(self, counts: float) -> float:
        """The joint's position in radians or metres."""
        return (counts - self._zero) / self._scale

    def distance_counts(self, distance: float) -> int:
        """Counts of a distance, always positive; of limits."""
        return _limited(abs(distance * self._scale), MAX_INT32)

    def velocity_counts(self, velocity: float) -> int:
        """A velocity in the drive's unit."""
        counts = velocity * self._scale
        return _limited(counts * 60.0 / self._counts_per_turn if self._rpm else counts, MAX_INT32)

    def velocity(self, counts: float) -> float:
        """The joint's velocity in rad/s or m/s."""
        return (counts * self._counts_per_turn / 60.0 if self._rpm else counts) / self._scale

    def torque(self, effort: float) -> int:
        """Thousandths of the rated torque."""
        return _limited(self._sign * effort * THOUSANDTHS / self.rated_effort, MAX_TORQUE)

    def effort(self, torque: float) -> float:
        """Newton metres or newtons of the joint."""
        return self._sign * torque * self.rated_effort / THOUSANDTHS


def _limited(value: float, limit: int) -> int:
    return round(min(limit, max(-limit, value))) if math.isfinite(value) else 0


def unwrapped(counts: int, before: int) -> int:
    """Continue a 32-bit encoder beyond its ends: `counts` as read now, `before` as unwrapped last."""
    return before + ((counts - before + 2**31) & 0xFFFFFFFF) - 2**31
