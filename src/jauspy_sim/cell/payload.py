"""What the cell's robot holds, as its controllers find it out: by the efforts of its motors while it moves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from jauspy.geometry.urdf import Joint
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.joints import JointSensors
from jauspy.platform.payload import MEMORY, NOTHING, Payload, PayloadIdentifier
from jauspy_sim.cell.connectors import SimulatedConnector
from jauspy_sim.physics.dynamics import Dynamics

AVERAGED: Final = 5
"""Control cycles of which the efforts are averaged to one measurement."""
MOVING: Final = 0.03
"""rad/s of a setpoint from which on the direction of its joint's friction is known."""
FREE: Final = 0.1
"""rad/s of the fastest joint from which on the robot moves freely, and carries all that it holds."""
STEADY: Final = 2.0
"""rad/s^2 of the fastest changing setpoint at which deviations count twice: accelerations are not quite those."""
KNOWN: Final = 0.2
"""Kilograms, as standard deviation, from which on the mass of what is held counts as known."""
SETTLED: Final = 0.3
"""Seconds after which the controllers no longer carry a part of a load that is known."""
MODEL_ERROR: Final = 0.001
"""Fraction of the greatest effort by which the model of the robot may be wrong in steady motion: an assumption."""


class HeldPayload:
    """What hangs on the gripper; the feed-forward of the robot's joints carries it.

    It is forgotten when the gripper takes or releases something, and learned while the robot moves. In slow motions and
    at rest something else may carry it in part: then it counts up to the force that the gripper measures.
    """

    def __init__(
        self,
        dynamics: Dynamics,
        joints: Sequence[Joint],
        sensors: JointSensors | None,
        dt: float,
        gripper: SimulatedConnector,
    ) -> None:
        self._dynamics, self._gripper = dynamics, gripper
        noise = sensors.effort_noise if sensors is not None else 0.0
        share = math.hypot(noise / math.sqrt(AVERAGED), MODEL_ERROR)
        self._deviations = np.array([share * joint.effort for joint in joints])
        self._damping = np.array([joint.damping for joint in joints])
        self._dt = AVERAGED * dt
        # at rest, friction is anywhere within its limits, and the same in all measurements that are remembered
        self._unknown = dynamics.friction * math.sqrt(MEMORY / self._dt / 3.0)
        self._identifier = PayloadIdentifier()
        self._held = ""
        self._count, self._beyond = 0, np.zeros(len(joints))
        self.found = NOTHING
        self._known_for = 0.0
        """Seconds since when the mass is known."""

    @property
    def known(self) -> bool:
        """True if nothing is held, or its mass has been fed forward long enough to tell its weight from a contact."""
        return not self._held or self._known_for >= SETTLED

    def prepare(self, setpoints: Sequence[tuple[float, float]]) -> bool:
        """Set the load for the next step; `setpoints`: velocities and accelerations of the joints.

        True to learn from this step.
        """
        held = self._gripper.attached_to
        if held != self._held:
            self._held, self._known_for = held, 0.0
            self._identifier.reset()
            self._set(NOTHING)
        if not held:
            return False
        self._known_for = self._known_for + self._dt / AVERAGED if self.found.mass_deviation < KNOWN else 0.0
        moves, found = any(abs(velocity) > FREE for velocity, _ in setpoints), self.found
        if not moves:
            self._count, self._beyond = 0, np.zeros(len(setpoints))
        if found.mass:
            share = 1.0 if moves else min(1.0, self._gripper.load[0] / (found.mass * GRAVITY))
            self._dynamics.carry(share * found.mass, found.center)
        return moves

    def learn(
        self, setpoints: Sequence[tuple[float, float]], efforts: Sequence[float], needed: Sequence[float]
    ) -> None:
        """Learn from the efforts of the step, as measured, where the model of robot and load had said `needed`."""
        velocities, accelerations = np.array(setpoints).T
        self._beyond = self._beyond + efforts - needed - self._damping * velocities
        self._count += 1
        if self._count < AVERAGED:
            return
        rows, carried = self._dynamics.load_rows()
        friction = np.where(np.abs(velocities) > MOVING, 0.0, self._unknown)
        deviations = np.hypot(self._deviations, friction) * (1.0 + np.abs(accelerations).max() / STEADY)
        self._set(self._identifier.add(rows, self._beyond / AVERAGED + carried, deviations, self._dt))
        self._count, self._beyond = 0, np.zeros(len(setpoints))

    def _set(self, payload: Payload) -> None:
        self.found = payload
        self._dynamics.carry(payload.mass, payload.center)
        self._gripper.payload = payload
