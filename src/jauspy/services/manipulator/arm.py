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
from jauspy.platform.joints import ControlMode, JointContact, JointGroup, JointState, Target
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.manipulator.blocked_joints import LEAST_SHORT, SLOW, BlockedJoint, StandstillWatch
from jauspy.services.manipulator.stability_guard import ArmStability

_LOG: Final = get_logger("jauspy.manipulator")

POSITION_TOLERANCE: Final = 0.01
"""Radians or metres from a position up to which it is reached."""

CHECK_PERIOD: Final = 0.05
"""Seconds from a command to the first check whether its motion has ended, and between two checks."""

AT_REST: Final = 1e-3
"""rad/s or m/s below which a joint counts as at rest."""

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

    def __init__(self, joints: JointGroup, stability: ArmStability | None = None) -> None:
        """`stability`: keeps its motions from tipping the robot over."""
        self.joints = joints
        self._stability = stability
        self._targets: Sequence[Target] = ()
        """The last command, before it was slowed down."""
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
        """The joints that kept the last command from being carried out."""
        self._contacts = 0
        """Number of the last contact that was noticed."""

    def state(self) -> JointState:
        """Positions, velocities and efforts of the joints after the last step; angles within `REPORTED_ANGLES`."""
        state = self.joints.state()
        rows = zip(self.geometry.from_urdf(state.positions), self.geometry.links, strict=True)
        positions = tuple(_wrapped(position) if _is_endless(link.joint) else position for position, link in rows)
        return replace(state, positions=positions)

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
        self.notice_contact()  # of the motion before
        before, self.driver = self.driver, driver
        self.blocked, self._contacts = (), _number(self.joints.state().contact)
        if before is not None and before is not driver:
            before.on_preempted()
        self._targets = targets
        self._command()
        if self._stability is not None:
            self._stability.watch(
                driver.host,
                driver.urn,
                moves=lambda: self.driver is driver,
                rests=lambda: max(map(abs, self.joints.state().velocities)) < AT_REST,
                slow=self._command,
                stop=self.stop,
            )

    def _command(self) -> None:
        present = self.joints.state().positions
        targets = [_native(*row) for row in zip(self._targets, self.geometry.links, present, strict=True)]
        if self._stability is not None:
            targets = self._stability.limited(targets, self.joints.joints, present)
        self.joints.command(targets)

    def to_positions(
        self, driver: ArmDriver, positions: Sequence[float], profiles: Sequence[MotionProfile] | None = None
    ) -> None:
        """Move to positions within the motion profile, or within these limits."""
        rows = zip(positions, self.profiles if profiles is None else profiles, strict=True)
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
        """Stop pushing if a joint has met something, or stands still short of these positions."""
        if self.stop_if_touched(positions):
            return True
        found = watch.blocked(now, self.joints.state(), self._ways(positions))
        if found:
            self.stop()
            self.blocked = found
        return bool(found)

    def stop_if_touched(self, positions: Sequence[float] | None = None) -> bool:
        """End the command if the joints have met something in their way, on which they hold or give way by themselves.

        `positions`: those of the command, if it has some.
        """
        contact = self.joints.state().contact
        if contact is None or contact.number == self._contacts:
            return False
        ways = [0.0] * len(self.joints.joints) if positions is None else self._ways(positions)
        joints = {joint.name: (joint, way) for joint, way in zip(self.joints.joints, ways, strict=True)}
        self.stop()
        self._contacts = contact.number
        self.blocked = tuple(
            BlockedJoint(joints[name][0], effort, joints[name][1]) for name, effort in contact.efforts.items()
        )
        return True

    def notice_contact(self) -> None:
        """End the last command, count and log it, if the joints have met something since it was last looked for."""
        if self.driver is not None:
            self.driver.stops_if_touched()

    def _ways(self, positions: Sequence[float]) -> list[float]:
        """Radians or metres from the present to these positions, as the joints' description counts them."""
        present = self.state()
        rows = zip(self.limited(positions), present.positions, self.geometry.links, self.joints.joints, strict=True)
        return [
            _way(link.joint, position, goal) * (1.0 if link.joint.axis == joint.axis else -1.0)
            for goal, position, link, joint in rows
        ]

    def stop(self) -> None:
        """Hold the present positions, whichever service moves the joints. May be called twice."""
        before, self.driver = self.driver, None
        if before is not None:
            before.on_preempted()
        self.joints.hold()


def _number(contact: JointContact | None) -> int:
    return 0 if contact is None else contact.number


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
        """Stop pushing, and count and log it, if a joint has met something, or stands still short of its position."""
        found = self.arm.stop_if_blocked(watch, self.host.now, positions)
        if found:
            self._tell_blocked()
        return found

    def stops_if_touched(self, positions: Sequence[float] | None = None) -> bool:
        """The same if a joint has met something; `positions`: those of the command, if it has some."""
        found = self.arm.stop_if_touched(positions)
        if found:
            self._tell_blocked()
        return found

    def _tell_blocked(self) -> None:
        text, contact = "; ".join(map(str, self.arm.blocked)), self.arm.joints.state().contact
        self.host.count("blocked", text)
        does = "gives way" if contact is not None and contact.gives_way else "holds"
        _LOG.warning("%s: blocked: %s; the arm %s", self.host.id, text, does)

    def on_endless_motion(self) -> None:
        """Hold unless the client sends a further command in time, and when something is in the way."""
        self.expect_next_command(lambda: self.arm.stop() if self.is_moving else None)
        self.host.set_timer(("contact", self.urn), self.host.now + CHECK_PERIOD, self._watch_contact)

    def _watch_contact(self) -> None:
        if self.is_moving and not self.stops_if_touched():
            self.host.set_timer(("contact", self.urn), self.host.now + CHECK_PERIOD, self._watch_contact)

    def stop_motion(self) -> None:
        """Stop when Ready is left; an action of most drivers' JSIDL."""
        self.arm.stop()

    def control_lost(self) -> None:
        """Stop: the next client must not inherit a motion."""
        super().control_lost()
        self.arm.stop()
