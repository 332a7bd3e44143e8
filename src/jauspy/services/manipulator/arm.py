"""The arm: joints, geometry, limits and motion profile, which the manipulator services of a component share.

Positions of joints are in the convention of AS6057 (`jauspy.geometry.denavit_hartenberg`), radians or metres, base to
tip.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.geometry.denavit_hartenberg import DHLink, manipulator_geometry
from jauspy.geometry.kinematics import KinematicState, forward_kinematics
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.logs import get_logger
from jauspy.platform.joint_control import ACCELERATION_TIME
from jauspy.platform.joints import ControlMode, JointGroup, JointState, Target
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.manipulator.blocked_joints import LEAST_SHORT, SLOW, BlockedJoint, StandstillWatch

_LOG: Final = get_logger("jauspy.manipulator")

POSITION_TOLERANCE: Final = 0.01
"""Radians or metres from a position up to which it is reached."""

REPORTED_ANGLES: Final = 16.0 * math.pi
"""Radians that the field of an angle spans (-8 pi..8 pi, AS6057): a joint that turned further is reported within it."""


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
        self.is_coupled = any(joint.mimics is not None for joint in joints.chain)
        """True if joints between base and tip mimic others; `geometry` then only converts positions."""
        self.geometry = manipulator_geometry([_as_fixed(joint) if joint.mimics else joint for joint in joints.chain])
        self.tool = self.geometry.tool
        """The tool point in the last joint's frame, metres."""
        self.limits = tuple(
            (link.joint.lower + link.zero_position, link.joint.upper + link.zero_position)
            for link in self.geometry.links
        )
        """The lower and upper limit of each joint; infinite for one that turns without end."""
        self.profiles = tuple(MotionProfile.of(joint) for joint in joints.joints)
        self.driver: ArmDriver | None = None
        """The service whose command is carried out; None while the joints hold."""
        self.blocked: tuple[BlockedJoint, ...] = ()
        """The joints that kept the last command to positions from being carried out."""

    def state(self) -> JointState:
        """Positions, velocities and efforts of the joints after the last step; angles within `REPORTED_ANGLES`."""
        state = self.joints.state()
        rows = zip(self.geometry.from_urdf(state.positions), self.geometry.links, strict=True)
        positions = tuple(_wrapped(position) if _is_endless(link.joint) else position for position, link in rows)
        return JointState(positions, state.velocities, state.efforts, state.overloads)

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
        self.blocked = ()
        if before is not None and before is not driver:
            before.on_preempted()
        present = self.joints.state().positions
        self.joints.command([_native(*row) for row in zip(targets, self.geometry.links, present, strict=True)])

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

    def is_at(self, positions: Sequence[float], tolerance: float = POSITION_TOLERANCE) -> bool:
        """True if all joints are at these positions, or at their limits; `tolerance` in radians or metres."""
        rows = zip(self.limited(positions), self.state().positions, self.geometry.links, strict=True)
        return all(abs(_way(link.joint, position, goal)) <= tolerance for goal, position, link in rows)

    def rests_near(self, positions: Sequence[float]) -> bool:
        """True if all joints (almost) stand, as near to these positions as one that counts as not blocked."""
        speeds = zip(self.state().velocities, self.profiles, strict=True)
        return self.is_at(positions, LEAST_SHORT) and all(abs(v) <= SLOW * profile.speed for v, profile in speeds)

    def watch(self) -> StandstillWatch:
        """Watch the joints during a command to positions within the present motion profile."""
        limits = [(profile.speed, min(profile.acceleration, profile.deceleration)) for profile in self.profiles]
        return StandstillWatch(self.joints.joints, limits)

    def stop_if_blocked(self, watch: StandstillWatch, now: float, positions: Sequence[float]) -> bool:
        """Stop pushing if a joint stands still short of these positions."""
        present = self.state()
        rows = zip(self.limited(positions), present.positions, self.geometry.links, self.joints.joints, strict=True)
        ways = [
            _way(link.joint, position, goal) * (1.0 if link.joint.axis == joint.axis else -1.0)
            for goal, position, link, joint in rows
        ]
        found = watch.blocked(now, self.joints.state(), ways)
        if found:
            self.stop()
            self.blocked = found
        return bool(found)

    def stop(self) -> None:
        """Hold the present positions, whichever service moves the joints. May be called twice."""
        before, self.driver = self.driver, None
        if before is not None:
            before.on_preempted()
        self.joints.hold()


def _native(target: Target, link: DHLink, present: float) -> Target:
    """The target in the URDF's terms; of a joint that turns without end, the nearest position that is reported so."""
    if target.mode is not ControlMode.POSITION:
        return target
    value = target.value - link.zero_position
    return replace(target, value=present + _way(link.joint, present, value) if _is_endless(link.joint) else value)


def _is_endless(joint: Joint) -> bool:
    return joint.kind is JointKind.CONTINUOUS


def _wrapped(angle: float) -> float:
    return math.remainder(angle, REPORTED_ANGLES)


def _way(joint: Joint, start: float, end: float) -> float:
    return _wrapped(end - start) if _is_endless(joint) else end - start


def _as_fixed(joint: Joint) -> Joint:
    return replace(joint, kind=JointKind.FIXED, mimics=None)


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

    def stops_if_blocked(self, watch: StandstillWatch, positions: Sequence[float]) -> bool:
        """Stop pushing, and count and log it, if a joint stands still short of these positions."""
        if not self.arm.stop_if_blocked(watch, self.host.now, positions):
            return False
        text = "; ".join(map(str, self.arm.blocked))
        self.host.count("blocked", text)
        _LOG.warning("%s: blocked: %s; the arm holds", self.host.id, text)
        return True

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
