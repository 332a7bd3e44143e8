"""The controller of one joint: effort, velocity or position, switched at run time."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.description import Gains, JointGains
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.setpoint import SetpointGenerator

BRAKE_TIME: Final = 0.1
"""Seconds that a joint brakes before it holds its position; adjacent joints come to rest meanwhile."""

ROTOR_ACCELERATION: Final = 50.0
"""Acceleration of a joint that moves only its own rotor with full effort, rad/s^2 or m/s^2.

A braking gain of effort / (ROTOR_ACCELERATION * dt) stops within one step at the soonest, so it does not
oscillate.
"""


class JointController:
    """Computes the effort of a joint at each step of its control loop (N m or N)."""

    def __init__(self, joint: Joint, gains: JointGains, position: float) -> None:
        self._joint = joint
        self._setpoint = SetpointGenerator(joint, position)
        self._position_pid = Pid(gains.position, joint.effort)
        self._velocity_pid = Pid(gains.velocity, joint.effort)
        self._holding = True
        self._braking = 0.0

    @property
    def mode(self) -> ControlMode:
        """The active controller."""
        return self._setpoint.target.mode

    def set_gains(self, gains: JointGains) -> None:
        """Set the gains; what is integrated is kept."""
        self._position_pid.gains, self._velocity_pid.gains = gains.position, gains.velocity

    def follow(self, target: Target, position: float, velocity: float) -> None:
        """Follow a target; a change of mode starts at the present `position` and `velocity`, without a jerk."""
        if target.mode is not self.mode:
            self._reset()
            self._setpoint.start(position, velocity)
        self._setpoint.target = target
        self._holding, self._braking = False, 0.0

    def hold(self, position: float) -> None:
        """Brake, and hold the position where the joint comes to rest. Has no effect on a joint that holds already."""
        if self._holding:
            return
        self._reset()
        self._setpoint.hold(position)
        self._holding, self._braking = True, BRAKE_TIME

    def effort(self, position: float, velocity: float, dt: float, feed_forward: float = 0.0) -> float:
        """Return the effort for the next `dt` seconds; `feed_forward` compensates gravity."""
        joint, setpoint = self._joint, self._setpoint
        if self._braking > 0.0:
            return self._brake(position, velocity, dt, feed_forward)
        mode = setpoint.target.mode
        if mode is ControlMode.EFFORT:
            return self._limited(setpoint.target.value)
        setpoint.advance(dt)
        desired_velocity = setpoint.velocity
        feed_forward += joint.damping * desired_velocity
        if mode is ControlMode.POSITION:
            return self._position_pid.update(
                setpoint.position - position, desired_velocity - velocity, dt, feed_forward
            )
        setpoint.position = position  # the limits apply to the present position, not to the commanded one
        return self._velocity_pid.update(desired_velocity - velocity, 0.0, dt, feed_forward)

    def _brake(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        """Return an effort against the motion, up to the limit; the position PID alone would overshoot."""
        self._braking -= dt
        self._setpoint.hold(position)
        return self._limited(feed_forward - self._joint.effort * velocity / (ROTOR_ACCELERATION * dt))

    def _limited(self, effort: float) -> float:
        return min(self._joint.effort, max(-self._joint.effort, effort))

    def _reset(self) -> None:
        self._position_pid.reset()
        self._velocity_pid.reset()


class Pid:
    """A PID controller with outputs within -limit..limit; it does not integrate beyond the limit (anti-windup)."""

    def __init__(self, gains: Gains, limit: float) -> None:
        self.gains = gains
        self.limit = limit
        self._integral = 0.0

    def reset(self, integral: float = 0.0) -> None:
        """Set the integral part of the output, within its limit."""
        self._integral = min(self.gains.i_limit, max(-self.gains.i_limit, integral))

    def update(self, error: float, rate: float, dt: float, feed_forward: float = 0.0) -> float:
        """Return the effort for an error with the derivative `rate` (1/s), `dt` seconds after the last one."""
        gains, integral, limit = self.gains, self._integral, self.limit
        output = feed_forward + gains.p * error + gains.d * rate + integral
        in_range = -limit <= output <= limit
        if in_range or error * output < 0.0:
            integral, i_limit = integral + gains.i * error * dt, gains.i_limit
            self._integral = integral if -i_limit <= integral <= i_limit else math.copysign(i_limit, integral)
        return output if in_range else math.copysign(limit, output)
