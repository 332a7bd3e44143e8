"""Joints of which some count the other way round than their description does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from jauspy.geometry.denavit_hartenberg import reversed_joint
from jauspy.platform.joints import JointGroup, JointState, Target


class TurnedJoints:
    """A `JointGroup` over another one. `turned`: for each joint that moves, whether its axis points the other way."""

    def __init__(self, group: JointGroup, turned: Sequence[bool]) -> None:
        self._group = group
        self._signs = tuple(-1.0 if each else 1.0 for each in turned)
        names = {joint.name for joint, each in zip(group.joints, turned, strict=True) if each}
        self.joints = tuple(reversed_joint(joint) if joint.name in names else joint for joint in group.joints)
        """The joints that move, base to tip."""
        self.chain = tuple(reversed_joint(joint) if joint.name in names else joint for joint in group.chain)
        """All joints from base to tip, fixed ones included."""

    def command(self, targets: Sequence[Target | None]) -> None:
        """What each joint is to do from now on, base to tip; None leaves a joint at what it does."""
        rows = zip(targets, self._signs, strict=True)
        self._group.command([target and replace(target, value=sign * target.value) for target, sign in rows])

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        self._group.hold()

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        state = self._group.state()
        return JointState(*(self._signed(values) for values in (state.positions, state.velocities, state.efforts)))

    def _signed(self, values: tuple[float, ...]) -> tuple[float, ...]:
        return tuple(sign * value for sign, value in zip(self._signs, values, strict=True))
