"""What the manipulator services of a component share: the joints, their geometry, their limits, and who moves them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from jauspy.geometry.denavit_hartenberg import DHLink, manipulator_geometry
from jauspy.geometry.kinematics import KinematicState, forward_kinematics
from jauspy.geometry.urdf import Joint
from jauspy.platform.joint_control import ACCELERATION_TIME
from jauspy.platform.joints import ControlMode, JointGroup, JointState, Target

if TYPE_CHECKING:
    from jauspy.services.manipulator.driver import ArmDriver

NEAR: Final = 0.01
"""Radians or metres from a position at which it counts as reached."""


@dataclass(frozen=True, slots=True)
class Profile:
    """How fast a joint may be moved: rad/s or m/s, and rad/s^2 or m/s^2."""

    speed: float
    acceleration: float
    deceleration: float

    @classmethod
    def of(cls, joint: Joint) -> Profile:
        """What the joint itself allows."""
        acceleration = joint.velocity / ACCELERATION_TIME
        return cls(joint.velocity, acceleration, acceleration)


class Arm:
    """One manipulator, as one component sees it. Positions are the standard's: see `denavit_hartenberg`."""

    def __init__(self, joints: JointGroup) -> None:
        self.joints = joints
        self.geometry = manipulator_geometry(joints.chain)
        self.tool = self.geometry.tool
        """The tool point in the last joint's frame, metres."""
        self.limits = tuple(
            (link.joint.lower + link.zero_position, link.joint.upper + link.zero_position)
            for link in self.geometry.links
        )
        """The least and the greatest position of each joint, in the standard's terms."""
        self.profiles = tuple(Profile.of(joint) for joint in joints.joints)
        self.driver: ArmDriver | None = None
        """Whose command the joints follow; None while they just hold."""

    def state(self) -> JointState:
        """The joints after the last step; positions in the standard's terms."""
        state = self.joints.state()
        return JointState(self.geometry.from_urdf(state.positions), state.velocities, state.efforts)

    def kinematic_state(self) -> KinematicState:
        """The tool, and how the joints move it, after the last step."""
        return forward_kinematics(self.geometry.links, self.state().positions, self.tool)

    def take(self, driver: ArmDriver) -> None:
        """Follow this driver from now on; hold until it says what to do, unless it is the one that says so already."""
        if self.driver is not driver:
            self.stop()
            self.driver = driver

    def move(self, driver: ArmDriver, targets: Sequence[Target]) -> None:
        """Do as a driver says, base to tip; positions in the standard's terms. The newest command counts."""
        before, self.driver = self.driver, driver
        if before is not None and before is not driver:
            before.taken_over()
        self.joints.command([self._native(*row) for row in zip(targets, self.geometry.links, strict=True)])

    def to_positions(self, driver: ArmDriver, positions: Sequence[float]) -> None:
        """Go to positions within the motion profile."""
        rows = zip(positions, self.profiles, strict=True)
        self.move(driver, [_within(Target(ControlMode.POSITION, value), profile) for value, profile in rows])

    def at_velocities(self, driver: ArmDriver, velocities: Sequence[float]) -> None:
        """Move at velocities within the motion profile."""
        rows = zip(velocities, self.profiles, strict=True)
        self.move(driver, [_within(Target(ControlMode.VELOCITY, value), profile) for value, profile in rows])

    def limited(self, positions: Sequence[float]) -> list[float]:
        """The positions nearest to these that the joints can have."""
        return [min(high, max(low, p)) for p, (low, high) in zip(positions, self.limits, strict=True)]

    def is_at(self, positions: Sequence[float]) -> bool:
        """True when all joints are there, or as near as their limits let them."""
        rows = zip(self.limited(positions), self.state().positions, strict=True)
        return all(abs(goal - position) <= NEAR for goal, position in rows)

    def stop(self) -> None:
        """Hold the present positions, whoever moves the joints. Twice is fine."""
        before, self.driver = self.driver, None
        if before is not None:
            before.taken_over()
        self.joints.hold()

    @staticmethod
    def _native(target: Target, link: DHLink) -> Target:
        return (
            replace(target, value=target.value - link.zero_position) if target.mode is ControlMode.POSITION else target
        )


def _within(target: Target, profile: Profile) -> Target:
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
