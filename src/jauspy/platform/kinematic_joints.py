"""Joints by arithmetic alone: they do what they are told, without weight or load."""

from __future__ import annotations

import math
from collections.abc import Sequence

from jauspy.geometry.urdf import Joint, RobotDescription
from jauspy.platform.description import GroupSetup
from jauspy.platform.joints import ControlMode, JointState, Target
from jauspy.platform.setpoint import SetpointGenerator


class KinematicJoints:
    """A `JointGroup` of joints that follow their set points exactly.

    Commanded by effort, a joint moves as if its damping were all that resists: full effort is full speed.
    """

    def __init__(self, description: RobotDescription, setup: GroupSetup) -> None:
        self._joints = tuple(description.joint(name) for name in setup.joints)
        self._chain = description.chain(setup.base, setup.tip)
        self._setpoints = [
            SetpointGenerator(joint, start) for joint, start in zip(self._joints, setup.start, strict=True)
        ]
        self._efforts = [0.0] * len(self._joints)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """What each joint is to do from now on, base to tip; None leaves a joint at what it does."""
        for number, (setpoint, target) in enumerate(zip(self._setpoints, targets, strict=True)):
            if target is None:
                continue
            most = setpoint.joint.effort
            by_effort = target.mode is ControlMode.EFFORT
            self._efforts[number] = min(most, max(-most, target.value)) if by_effort else 0.0
            setpoint.target = _as_speed(setpoint.joint, target) if by_effort else target

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        for setpoint in self._setpoints:
            setpoint.hold(setpoint.position)
        self._efforts = [0.0] * len(self._joints)

    def state(self) -> JointState:
        """Positions and velocities after the last step; efforts as commanded."""
        positions, velocities = zip(
            *((setpoint.position, setpoint.velocity) for setpoint in self._setpoints), strict=True
        )
        return JointState(positions, velocities, tuple(self._efforts))

    def step(self, dt: float) -> None:
        """Move for `dt` seconds."""
        for setpoint in self._setpoints:
            setpoint.advance(dt)


def _as_speed(joint: Joint, target: Target) -> Target:
    share = target.value / joint.effort if joint.effort else 0.0
    speed = joint.velocity * min(1.0, max(-1.0, share)) if math.isfinite(share) else 0.0
    return Target(ControlMode.VELOCITY, speed, acceleration=target.acceleration)
