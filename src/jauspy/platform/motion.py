"""The motion of a set point: towards a position or at a velocity, within the limits of its joint."""

from __future__ import annotations

import math
from typing import Final

from jauspy.platform.description import Joint
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
        match self.target.mode:
            case ControlMode.POSITION:
                self._approach(min(self.joint.upper, max(self.joint.lower, self.target.value)), dt)
            case ControlMode.VELOCITY:
                self._cruise(dt)
            case ControlMode.EFFORT:
                self.velocity = 0.0

    def _approach(self, goal: float, dt: float) -> None:
        left = goal - self.position
        if not left and not self.velocity:
            return
        fastest = min(self.joint.velocity, self.target.speed or math.inf)
        change = self._deceleration * dt
        # steps of dt are no smooth ramp: half a step is lost
        braking = math.sqrt(change * change / 4.0 + 2.0 * self._deceleration * abs(left)) - change / 2.0
        self._change_speed(math.copysign(min(fastest, braking), left), dt)
        if abs(left) <= change * dt and abs(self.velocity) <= 2.0 * change:
            self.start(goal, 0.0)
        else:
            self.position += self.velocity * dt

    def _cruise(self, dt: float) -> None:
        fastest = self.joint.velocity
        self._change_speed(min(fastest, max(-fastest, self.target.value)), dt)
        position = self.position + self.velocity * dt
        self.position = min(self.joint.upper, max(self.joint.lower, position))
        if self.position != position:
            self.velocity = 0.0

    def _change_speed(self, wanted: float, dt: float) -> None:
        slower = abs(wanted) < abs(self.velocity) or wanted * self.velocity < 0.0
        most = (self._deceleration if slower else self._acceleration) * dt
        self.velocity += min(most, max(-most, wanted - self.velocity))

    @property
    def _acceleration(self) -> float:
        return self.target.acceleration or self.joint.velocity / ACCELERATION_TIME

    @property
    def _deceleration(self) -> float:
        return self.target.deceleration or self.joint.velocity / ACCELERATION_TIME
