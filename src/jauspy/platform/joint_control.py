"""The controller of one joint: effort, velocity or position, switched at run time."""

from __future__ import annotations

from jauspy.platform.description import Joint, JointGains
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.motion import Motion
from jauspy.platform.pid import Pid


class JointController:
    """Turns what a joint is to do into an effort, at each step of its control loop."""

    def __init__(self, joint: Joint, gains: JointGains, position: float) -> None:
        self._joint = joint
        self._motion = Motion(joint, position)
        self._position_pid = Pid(gains.position, joint.effort)
        self._velocity_pid = Pid(gains.velocity, joint.effort)

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

    def hold(self, position: float) -> None:
        """Stay where the joint is."""
        self._reset()
        self._motion.hold(position)

    def effort(self, position: float, velocity: float, dt: float, feed_forward: float = 0.0) -> float:
        """The effort for the next `dt` seconds; `feed_forward` is what the joint needs anyhow, against gravity."""
        joint, motion = self._joint, self._motion
        if self.mode is ControlMode.EFFORT:
            return min(joint.effort, max(-joint.effort, motion.target.value))
        motion.advance(dt)
        help_along = feed_forward + joint.damping * motion.velocity
        if self.mode is ControlMode.POSITION:
            return self._position_pid.update(motion.position - position, motion.velocity - velocity, dt, help_along)
        motion.position = position  # the limits stop where the joint is, not where it would be
        return self._velocity_pid.update(motion.velocity - velocity, 0.0, dt, help_along)

    def _reset(self) -> None:
        self._position_pid.reset()
        self._velocity_pid.reset()
