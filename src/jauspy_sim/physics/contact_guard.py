"""A joint group that ends its motion when it meets something in its way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from jauspy.geometry.urdf import Joint
from jauspy.platform.joint_contact import Array, JointContactObserver
from jauspy.platform.joint_control import FedForwardController
from jauspy.platform.joints import ContactReaction, ControlMode, JointContact
from jauspy_sim.physics.dynamics import Dynamics

OBSERVED_EVERY: Final = 2
INERTIA_EVERY: Final = 10
"""Control cycles from one update of the observer, and one computation of the joints' inertia, to the next."""
WATCHED: Final = 0.05
"""Seconds after the setpoints have stopped in which a contact still ends the motion."""
FOLLOWING: Final = 0.1
"""Seconds after a contact in which the joints are held where they are at each moment, so that the effort falls."""
YIELDING: Final = 0.5
"""Seconds in which they give way, if they are to."""
YIELD_SPEED: Final = 0.4
"""Speed (rad/s or m/s) at which a joint gives way to an effort at the threshold, and at most."""
SATURATED: Final = 0.95
"""Part of its largest effort from which on a motor may be too weak for its setpoint."""
BEHIND: Final = 0.5
"""Seconds in which a joint then catches up."""
RESTS: Final = 0.3
"""Part of the threshold up to which a joint does not give way."""


class ContactGuard:
    """Watches the motions of one group, and makes its controllers stop or give way."""

    def __init__(
        self,
        reaction: ContactReaction,
        joints: Sequence[Joint],
        controllers: Sequence[FedForwardController],
        dynamics: Dynamics,
        dt: float,
    ) -> None:
        self.contact: JointContact | None = None
        """The last contact."""
        self._reaction, self._joints, self._controllers, self._dynamics = reaction, joints, controllers, dynamics
        self._dt = dt
        self._observer = JointContactObserver([joint.effort for joint in joints])
        self._damping = [joint.damping for joint in joints]
        self._inertia = np.zeros((len(joints), len(joints)))
        self._cycles = 0
        self._velocities: list[float] = []
        """Those at the end of the last cycle."""
        self._start = np.zeros(len(joints))
        """Those at the last update of the observer, and since then the sums over the cycles:"""
        self._beyond = [0.0] * len(joints)
        self._accelerations = [0.0] * len(joints)
        self._rest = WATCHED
        """Seconds since the setpoints have stopped."""
        self._left = 0.0
        """Seconds that the reaction to a contact still takes."""
        self._limits = [SATURATED * joint.effort for joint in joints]
        self._behind = 0.0
        """Seconds for which a joint may still be behind its setpoint, since its motor was too weak for it."""
        self._held = np.zeros(len(joints))

    def suspects(self, *, load_known: bool) -> bool:
        """True if there may be a contact, so that loads are not learned."""
        return self._left > 0.0 or self._observer.suspects(certain=load_known and self._behind <= 0.0)

    def command(self) -> None:
        """A new command ends the reaction to a contact."""
        self._left = 0.0

    def step(
        self,
        measured: Sequence[tuple[float, float]],
        setpoints: Sequence[tuple[float, float]],
        efforts: Sequence[float],
        needed: Sequence[float],
        *,
        load_known: bool,
    ) -> None:
        """Take in a control cycle, and react.

        `measured`: positions and velocities at its end; `setpoints`: velocities and accelerations; `efforts` of the
        motors, as measured, where the model had said `needed`.
        """
        before, self._velocities = self._velocities, [velocity for _, velocity in measured]
        if not before:
            self._start = np.array(self._velocities)
            return
        # single numbers, since arrays of six take longer
        rows = zip(self._beyond, efforts, needed, self._damping, before, strict=True)
        self._beyond = [total + effort - need - damping * rate for total, effort, need, damping, rate in rows]
        self._accelerations = [a + b for a, (_, b) in zip(self._accelerations, setpoints, strict=True)]
        self._rest = 0.0 if self._moves(setpoints) else self._rest + self._dt
        weak = any(abs(need) > limit for need, limit in zip(needed, self._limits, strict=True))
        self._behind = BEHIND if weak else self._behind - self._dt
        self._cycles += 1
        if not self._cycles % OBSERVED_EVERY:
            self._observe()
            if self._left <= 0.0 and self._rest < WATCHED:
                self._look(measured, load_known=load_known)
        if self._left > 0.0:
            self._react(np.array([position for position, _ in measured]))

    def _observe(self) -> None:
        """Give the observer the cycles since its last update."""
        if not self._cycles % INERTIA_EVERY:
            self._inertia = self._dynamics.inertia()
        velocities = np.array(self._velocities)
        self._observer.update(
            self._inertia,
            velocities - self._start,
            np.array(self._accelerations) / OBSERVED_EVERY,
            np.array(self._beyond) / OBSERVED_EVERY,
            OBSERVED_EVERY * self._dt,
        )
        self._start = velocities
        self._beyond, self._accelerations = [0.0] * len(self._joints), [0.0] * len(self._joints)

    def _look(self, measured: Sequence[tuple[float, float]], *, load_known: bool) -> None:
        """Begin to react if something is in the way."""
        touched = self._observer.touched(certain=load_known and self._behind <= 0.0)
        if not touched:
            return
        number = 1 if self.contact is None else self.contact.number + 1
        found = {self._joints[joint].name: float(self._observer.external[joint]) for joint in touched}
        self.contact = JointContact(number, found, gives_way=self._reaction is ContactReaction.YIELD)
        self._left = YIELDING if self.contact.gives_way else FOLLOWING
        self._held = np.array([position for position, _ in measured])

    def _moves(self, setpoints: Sequence[tuple[float, float]]) -> bool:
        """True while all joints follow positions or velocities, and one is to move; efforts are meant to push."""
        if not any(velocity for velocity, _ in setpoints):
            return False
        return all(controller.mode is not ControlMode.EFFORT for controller in self._controllers)

    def _react(self, positions: Array) -> None:
        """Hold the joints where they are, or where something pushes them."""
        self._left -= self._dt
        if self._reaction is ContactReaction.YIELD:
            pushed = self._observer.external / self._observer.thresholds
            speeds = np.where(np.abs(pushed) > RESTS, YIELD_SPEED * np.clip(pushed, -1.0, 1.0), 0.0)
            self._held = self._held + self._dt * speeds
        else:
            self._held = positions
        for controller, position in zip(self._controllers, self._held.tolist(), strict=True):
            controller.hold_at(position, 0.0)
