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

    In the mode EFFORT the setpoint stands still, unless gravity is compensated: then it moves at the share of the speed
    limit that the effort is of the greatest effort.
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
        self._max_speed = min(joint.velocity, target.speed or math.inf)
        self._cruises = target.mode is ControlMode.VELOCITY or target.compensated
        wanted = target.value
        if target.mode is ControlMode.EFFORT:
            wanted *= self._max_speed / joint.effort if joint.effort else 0.0
        self._cruise_velocity = min(joint.velocity, max(-joint.velocity, wanted))
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
        elif self._cruises:
            self._cruise(dt)
        else:
            self.velocity = 0.0

    def _approach(self, distance: float, dt: float) -> None:
        change = self._deceleration * dt
        self._change_speed(math.copysign(min(self._max_speed, self._braking_speed(abs(distance), dt)), distance), dt)
        if abs(distance) <= change * dt and abs(self.velocity) <= 2.0 * change:
            self.start(self._goal, 0.0)
        else:
            self.position += self.velocity * dt

    def _cruise(self, dt: float) -> None:
        wanted = self._cruise_velocity
        room = abs((self.joint.upper if wanted > 0.0 else self.joint.lower) - self.position)
        self._change_speed(math.copysign(min(abs(wanted), self._braking_speed(room, dt)), wanted), dt)
        position = self.position + self.velocity * dt
        beyond = position > self.joint.upper if self.velocity > 0.0 else position < self.joint.lower
        if beyond and self.velocity:
            position, self.velocity = min(self.joint.upper, max(self.joint.lower, position)), 0.0
        self.position = position

    def fastest(self, room: float, dt: float) -> float:
        """The speed at which the joint may move towards an end that is `room` away."""
        return min(self._max_speed, self._braking_speed(max(0.0, room), dt))

    def _braking_speed(self, distance: float, dt: float) -> float:
        """The speed from which the setpoint stops within a distance."""
        change = self._deceleration * dt
        # steps of dt delay the ramp by half a step
        return math.sqrt(change * change / 4.0 + 2.0 * self._deceleration * distance) - change / 2.0

    def _change_speed(self, wanted: float, dt: float) -> None:
        present = self.velocity
        if wanted == present:
            return
        slower = abs(wanted) < abs(present) or wanted * present < 0.0
        limit = (self._deceleration if slower else self._acceleration) * dt
        self.velocity = present + min(limit, max(-limit, wanted - present))
