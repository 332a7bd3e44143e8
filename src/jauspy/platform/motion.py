"""The motion of a set point: towards a position or at a velocity, within the limits of its joint."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.joints import ControlMode, Target

ACCELERATION_TIME: Final = 0.25
"""Seconds in which a joint gains its full speed, unless a command says otherwise."""


class Motion:
    """Where a joint is to be, and how fast, at any time: a trapezoid of speed that ends at the target.

    With the mode EFFORT it stands still.
    """

    def __init__(self, joint: Joint, position: float) -> None:
        self.joint = joint
        self.hold(position)

    @property
    def target(self) -> Target:
        """What the joint is to do."""
        return self._target

    @target.setter
    def target(self, target: Target) -> None:
        joint, usual = self.joint, self.joint.velocity / ACCELERATION_TIME
        self._target = target
        self._goal = min(joint.upper, max(joint.lower, target.value))
        self._cruising = min(joint.velocity, max(-joint.velocity, target.value))
        self._fastest = min(joint.velocity, target.speed or math.inf)
        self._acceleration = target.acceleration or usual
        self._deceleration = target.deceleration or usual

    def hold(self, position: float) -> None:
        """Stand at a position."""
        self.start(position, 0.0)
        self.target = Target(ControlMode.POSITION, position)

    def start(self, position: float, velocity: float) -> None:
        """Go on from here."""
        self.position = position
        self.velocity = velocity

    def advance(self, dt: float) -> None:
        """Let `dt` seconds pass."""
        mode = self._target.mode
        if mode is ControlMode.POSITION:
            left = self._goal - self.position
            if left or self.velocity:
                self._approach(left, dt)
        elif mode is ControlMode.VELOCITY:
            self._cruise(dt)
        else:
            self.velocity = 0.0

    def _approach(self, left: float, dt: float) -> None:
        change = self._deceleration * dt
        # steps of dt are no smooth ramp: half a step is lost
        braking = math.sqrt(change * change / 4.0 + 2.0 * self._deceleration * abs(left)) - change / 2.0
        self._change_speed(math.copysign(min(self._fastest, braking), left), dt)
        if abs(left) <= change * dt and abs(self.velocity) <= 2.0 * change:
            self.start(self._goal, 0.0)
        else:
            self.position += self.velocity * dt

    def _cruise(self, dt: float) -> None:
        self._change_speed(self._cruising, dt)
        position = self.position + self.velocity * dt
        self.position = min(self.joint.upper, max(self.joint.lower, position))
        if self.position != position:
            self.velocity = 0.0

    def _change_speed(self, wanted: float, dt: float) -> None:
        present = self.velocity
        if wanted == present:
            return
        slower = abs(wanted) < abs(present) or wanted * present < 0.0
        most = (self._deceleration if slower else self._acceleration) * dt
        self.velocity = present + min(most, max(-most, wanted - present))
