"""The setpoint of a joint: a trapezoidal motion to a position, or at a velocity, within the limits of the joint."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.joints import ControlMode, Target

ACCELERATION_TIME: Final = 0.25
"""Seconds to full speed, unless a command sets an acceleration."""


class SetpointGenerator:
    """Position and velocity of a joint's setpoint; the speed is a trapezoid that ends at the target.

    In the mode EFFORT the setpoint stands still.
    """

    def __init__(self, joint: Joint, position: float) -> None:
        self.joint = joint
        self.hold(position)

    @property
    def target(self) -> Target:
        """The present command."""
        return self._target

    @target.setter
    def target(self, target: Target) -> None:
        joint, default = self.joint, self.joint.velocity / ACCELERATION_TIME
        self._target = target
        self._goal = min(joint.upper, max(joint.lower, target.value))
        self._cruise_velocity = min(joint.velocity, max(-joint.velocity, target.value))
        self._max_speed = min(joint.velocity, target.speed or math.inf)
        self._acceleration = target.acceleration or default
        self._deceleration = target.deceleration or default

    def hold(self, position: float) -> None:
        """Stand still at a position."""
        self.start(position, 0.0)
        self.target = Target(ControlMode.POSITION, position)

    def start(self, position: float, velocity: float) -> None:
        """Set the present position and velocity."""
        self.position = position
        self.velocity = velocity

    def advance(self, dt: float) -> None:
        """Advance by `dt` seconds."""
        mode = self._target.mode
        if mode is ControlMode.POSITION:
            distance = self._goal - self.position
            if distance or self.velocity:
                self._approach(distance, dt)
        elif mode is ControlMode.VELOCITY:
            self._cruise(dt)
        else:
            self.velocity = 0.0

    def _approach(self, distance: float, dt: float) -> None:
        change = self._deceleration * dt
        # steps of dt delay the ramp by half a step
        braking = math.sqrt(change * change / 4.0 + 2.0 * self._deceleration * abs(distance)) - change / 2.0
        self._change_speed(math.copysign(min(self._max_speed, braking), distance), dt)
        if abs(distance) <= change * dt and abs(self.velocity) <= 2.0 * change:
            self.start(self._goal, 0.0)
        else:
            self.position += self.velocity * dt

    def _cruise(self, dt: float) -> None:
        self._change_speed(self._cruise_velocity, dt)
        position = self.position + self.velocity * dt
        self.position = min(self.joint.upper, max(self.joint.lower, position))
        if self.position != position:
            self.velocity = 0.0

    def _change_speed(self, wanted: float, dt: float) -> None:
        present = self.velocity
        if wanted == present:
            return
        slower = abs(wanted) < abs(present) or wanted * present < 0.0
        limit = (self._deceleration if slower else self._acceleration) * dt
        self.velocity = present + min(limit, max(-limit, wanted - present))
