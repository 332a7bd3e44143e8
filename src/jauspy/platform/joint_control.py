"""The controller of one joint (effort, velocity or position, switched at run time), its set point and its PID."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.description import Gains, JointGains
from jauspy.platform.joints import ControlMode, Target

ACCELERATION_TIME: Final = 0.25
"""Seconds in which a joint gains its full speed, unless a command says otherwise."""

BRAKING: Final = 0.1
"""Seconds that a joint that is to hold brakes first: long enough for those beside it to come to rest, too."""

LIVELIEST: Final = 50.0
"""Acceleration of a joint that moves nothing but its own rotor with full effort, rad/s^2 or m/s^2.

So effort / (LIVELIEST * dt) stops within a step at the soonest, and does not shake.
"""


class JointController:
    """Turns what a joint is to do into an effort, at each step of its control loop."""

    def __init__(self, joint: Joint, gains: JointGains, position: float) -> None:
        self._joint = joint
        self._motion = Motion(joint, position)
        self._position_pid = Pid(gains.position, joint.effort)
        self._velocity_pid = Pid(gains.velocity, joint.effort)
        self._holding = True
        self._braking = 0.0

    @property
    def mode(self) -> ControlMode:
        """Which controller acts."""
        return self._motion.target.mode

    def follow(self, target: Target, position: float, velocity: float) -> None:
        """From now on; the joint is at `position` and moves at `velocity`, so that switching does not jerk."""
        if target.mode is not self.mode:
            self._reset()
            self._motion.start(position, velocity)
        self._motion.target = target
        self._holding, self._braking = False, 0.0

    def hold(self, position: float) -> None:
        """Brake, and stay where the joint comes to rest. Again changes nothing: it would follow a joint that sags."""
        if self._holding:
            return
        self._reset()
        self._motion.hold(position)
        self._holding, self._braking = True, BRAKING

    def effort(self, position: float, velocity: float, dt: float, feed_forward: float = 0.0) -> float:
        """The effort for the next `dt` seconds; `feed_forward` is what the joint needs anyhow, against gravity."""
        joint, motion = self._joint, self._motion
        if self._braking > 0.0:
            return self._brake(position, velocity, dt, feed_forward)
        mode = motion.target.mode
        if mode is ControlMode.EFFORT:
            return self._limited(motion.target.value)
        motion.advance(dt)
        wanted = motion.velocity
        help_along = feed_forward + joint.damping * wanted
        if mode is ControlMode.POSITION:
            return self._position_pid.update(motion.position - position, wanted - velocity, dt, help_along)
        motion.position = position  # the limits stop where the joint is, not where it would be
        return self._velocity_pid.update(wanted - velocity, 0.0, dt, help_along)

    def _brake(self, position: float, velocity: float, dt: float, feed_forward: float) -> float:
        """Against the motion, with all there is; the position PID alone would let the joint run on and pull it back."""
        self._braking -= dt
        self._motion.hold(position)
        return self._limited(feed_forward - self._joint.effort * velocity / (LIVELIEST * dt))

    def _limited(self, effort: float) -> float:
        return min(self._joint.effort, max(-self._joint.effort, effort))

    def _reset(self) -> None:
        self._position_pid.reset()
        self._velocity_pid.reset()


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
