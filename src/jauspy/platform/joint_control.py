"""The controller of one joint: effort, velocity or position, switched at run time."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.description import Gains, JointGains
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.setpoint import SetpointGenerator

BRAKE_TIME: Final = 0.1
"""Seconds that a joint that is to hold brakes first: long enough for those beside it to come to rest, too."""

ROTOR_ACCELERATION: Final = 50.0
"""Acceleration of a joint that moves nothing but its own rotor with full effort, rad/s^2 or m/s^2.

So effort / (LIVELIEST * dt) stops within a step at the soonest, and does not shake.
"""


class JointController:
    """Turns what a joint is to do into an effort, at each step of its control loop."""

    def __init__(self, joint: Joint, gains: JointGains, position: float) -> None:
        self._joint = joint
        self._setpoint = SetpointGenerator(joint, position)
        self._position_pid = Pid(gains.position, joint.effort)
        self._velocity_pid = Pid(gains.velocity, joint.effort)
        self._holding = True
        self._braking = 0.0

    @property
    def mode(self) -> ControlMode:
        """Which controller acts."""
        return self._setpoint.target.mode

    def follow(self, target: Target, position: float, velocity: float) -> None:
        """From now on; the joint is at `position` and moves at `velocity`, so that switching does not jerk."""
        if target.mode is not self.mode:
            self._reset()
            self._setpoint.start(position, velocity)
        self._setpoint.target = target
        self._holding, self._braking = False, 0.0

    def hold(self, position: float) -> None:
        """Brake, and stay where the joint comes to rest. Again changes nothing: it would follow a joint that sags."""
        if self._holding:
            return
        self._reset()
        self._setpoint.hold(position)
        self._holding, self._braking = True, BRAKE_TIME

    def effort(self, position: float, velocity: float, dt: float, feed_forward: float = 0.0) -> float:
        """The effort for the next `dt` seconds; `feed_forward` is what the joint needs anyhow, against gravity."""
        joint, setpoint = self._joint, self._setpoint
        if self._braking > 0.0:
            return self._brake(position, velocity, dt, feed_forward)
        mode = setpoint.target.mode
        if mode is ControlMode.EFFORT:
            return self._limited(setpoint.target.value)
        setpoint.advance(dt)
        wanted = setpoint.velocity
        help_along = feed_forward + joint.damping * wanted
        if mode is ControlMode.POSITION:
            return self._position_pid.update(setpoint.position - position, wanted - velocity, dt, help_along)
        setpoint.position = position  # the limits stop where the joint is, not where it would be
        return self._velocity_pid.update(wanted - velocity, 0.0, dt, help_along)

    def _brake(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        """Against the motion, with all there is; the position PID alone would let the joint run on and pull it back."""
        self._braking -= dt
        self._setpoint.hold(position)
        return self._limited(feed_forward - self._joint.effort * velocity / (ROTOR_ACCELERATION * dt))

    def _limited(self, effort: float) -> float:
        return min(self._joint.effort, max(-self._joint.effort, effort))

    def _reset(self) -> None:
        self._position_pid.reset()
        self._velocity_pid.reset()


class Pid:
    """The output stays within `limit` either way; what the limit cuts off is not integrated (anti-windup)."""

    def __init__(self, gains: Gains, limit: float) -> None:
        self.gains = gains
        self.limit = limit
        self._integral = 0.0

    def reset(self) -> None:
        """Forget what was integrated."""
        self._integral = 0.0

    def update(self, error: float, rate: float, dt: float, feed_forward: float = 0.0) -> float:
        """The effort for an error that changes by `rate` per second, after `dt` seconds, on top of `feed_forward`."""
        gains, integral, limit = self.gains, self._integral, self.limit
        wanted = feed_forward + gains.p * error + gains.d * rate + integral
        within = -limit <= wanted <= limit
        if within or error * wanted < 0.0:
            integral, most = integral + gains.i * error * dt, gains.i_limit
            self._integral = integral if -most <= integral <= most else math.copysign(most, integral)
        return wanted if within else math.copysign(limit, wanted)
