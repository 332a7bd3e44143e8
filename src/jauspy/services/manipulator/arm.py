"""The arm: joints, geometry, limits and motion profile, which the manipulator services of a component share.

Positions of joints are as AS6057 counts them (`jauspy.geometry.denavit_hartenberg`), radians or metres, base to tip.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.geometry.denavit_hartenberg import DHLink, manipulator_geometry
from jauspy.geometry.kinematics import KinematicState, forward_kinematics
from jauspy.geometry.urdf import Joint
from jauspy.platform.joints import ControlMode, JointGroup, JointState, Target
from jauspy.platform.setpoint import ACCELERATION_TIME
from jauspy.services.command_timeout import ContinuousCommands

POSITION_TOLERANCE: Final = 0.01
"""Radians or metres from a position up to which it is reached."""


@dataclass(frozen=True, slots=True)
class MotionProfile:
    """Limits of a joint's motion: rad/s and rad/s^2, or m/s and m/s^2."""

    speed: float
    acceleration: float
    deceleration: float

    @classmethod
    def of(cls, joint: Joint) -> MotionProfile:
        """The limits of the joint itself."""
        acceleration = joint.velocity / ACCELERATION_TIME
        return cls(joint.velocity, acceleration, acceleration)


class Arm:
    """One manipulator; the newest command of a driver preempts the others."""

    def __init__(self, joints: JointGroup) -> None:
        self.joints = joints
        self.geometry = manipulator_geometry(joints.chain)
        self.tool = self.geometry.tool
        """The tool point in the last joint's frame, metres."""
        self.limits = tuple(
            (link.joint.lower + link.zero_position, link.joint.upper + link.zero_position)
            for link in self.geometry.links
        )
        """The lower and upper limit of each joint."""
        self.profiles = tuple(MotionProfile.of(joint) for joint in joints.joints)
        self.driver: ArmDriver | None = None
        """The service whose command is carried out; None while the joints hold."""

    def state(self) -> JointState:
        """Positions, velocities and efforts of the joints after the last step."""
        state = self.joints.state()
        return JointState(self.geometry.from_urdf(state.positions), state.velocities, state.efforts)

    def kinematic_state(self) -> KinematicState:
        """Pose and Jacobian of the tool after the last step."""
        return forward_kinematics(self.geometry.links, self.state().positions, self.tool)

    def preempt_for(self, driver: ArmDriver) -> None:
        """Hold until this driver commands the joints, unless it already does."""
        if self.driver is not driver:
            self.stop()
            self.driver = driver

    def move(self, driver: ArmDriver, targets: Sequence[Target]) -> None:
        """Command each joint, base to tip."""
        before, self.driver = self.driver, driver
        if before is not None and before is not driver:
            before.on_preempted()
        self.joints.command([self._native(*row) for row in zip(targets, self.geometry.links, strict=True)])

    def to_positions(self, driver: ArmDriver, positions: Sequence[float]) -> None:
        """Move to positions within the motion profile."""
        rows = zip(positions, self.profiles, strict=True)
        self.move(driver, [_limited_target(Target(ControlMode.POSITION, value), profile) for value, profile in rows])

    def at_velocities(self, driver: ArmDriver, velocities: Sequence[float]) -> None:
        """Move at velocities within the motion profile."""
        rows = zip(velocities, self.profiles, strict=True)
        self.move(driver, [_limited_target(Target(ControlMode.VELOCITY, value), profile) for value, profile in rows])

    def limited(self, positions: Sequence[float]) -> list[float]:
        """The positions, within the joints' limits."""
        return [min(high, max(low, p)) for p, (low, high) in zip(positions, self.limits, strict=True)]

    def is_at(self, positions: Sequence[float]) -> bool:
        """True if all joints are at these positions, or at their limits."""
        rows = zip(self.limited(positions), self.state().positions, strict=True)
        return all(abs(goal - position) <= POSITION_TOLERANCE for goal, position in rows)

    def stop(self) -> None:
        """Hold the present positions, whichever service moves the joints. May be called twice."""
        before, self.driver = self.driver, None
        if before is not None:
            before.on_preempted()
        self.joints.hold()

    @staticmethod
    def _native(target: Target, link: DHLink) -> Target:
        return (
            replace(target, value=target.value - link.zero_position) if target.mode is ControlMode.POSITION else target
        )


def _limited_target(target: Target, profile: MotionProfile) -> Target:
    value = target.value
    if target.mode is ControlMode.VELOCITY:
        value = min(profile.speed, max(-profile.speed, value))
    return replace(
        target,
        value=value,
        speed=profile.speed,
        acceleration=profile.acceleration,
        deceleration=profile.deceleration,
    )


class ArmDriver(ContinuousCommands):
    """The base of the services that move the joints."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm

    @property
    def is_moving(self) -> bool:
        """True while the joints carry out a command of this service."""
        return self.arm.driver is self

    def motion_profile_exists(self) -> bool:
        """Always True: without a command the limits of the joints apply."""
        return True

    def on_preempted(self) -> None:
        """Called when another service's command, or a stop, ends this service's motion."""

    def on_endless_motion(self) -> None:
        """Hold unless the client sends a further command in time."""
        self.expect_next_command(lambda: self.arm.stop() if self.is_moving else None)

    def stop_motion(self) -> None:
        """Stop when Ready is left; an action of most drivers' JSIDL."""
        self.arm.stop()

    def control_lost(self) -> None:
        """Stop: the next client must not inherit a motion."""
        super().control_lost()
        self.arm.stop()
