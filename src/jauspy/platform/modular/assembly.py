"""An arm as it is assembled: its chain, its servo modules with their limits, and its model."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import IDENTITY, Pose, Transform
from jauspy.platform.modular.contact import ContactObserver
from jauspy.platform.modular.control_laws import JointMeasurements, smooth_step
from jauspy.platform.modular.dynamics import ArmModel, PayloadEstimator
from jauspy.platform.modular.graph import ArmChain, Attachment, find_chain
from jauspy.platform.modular.parts import CellSetup, ServoData
from jauspy.platform.modular.servo import ServoDrive, ServoReading
from jauspy.platform.modular.trajectory import Limits, Setpoint

Array = NDArray[np.float64]

SPEED_RESERVE: Final = 0.8
"""Fraction of a module's speed that planned motions use; beyond, the voltage limits its torque."""

TORQUE_RESERVE: Final = 0.9
"""Fraction of a module's torque that planned motions use; the rest is for control."""

ACCELERATION: Final = 25.0
"""rad/s^2: the largest acceleration of a planned motion; torque usually allows less."""

JERK_TIME: Final = 0.12
"""Seconds in which a planned motion builds up its full acceleration."""

SHARING_TIME: Final = 0.4
"""Seconds in which a second base takes over half of the arm's weight."""


class ArmAssembly:
    """One assembly of an arm. Vectors are in the order of its chain; when attachments change, another one replaces it.

    `base_pose` returns the pose of a base in the world, given its name. `connected` are the attachments that the chain
    was found by: if they have it carried by a second base, too, that base takes over half of its weight.
    """

    def __init__(
        self,
        cell: CellSetup,
        chain: ArmChain,
        servos: Mapping[str, ServoDrive],
        base_pose: Callable[[str], Pose],
        connected: Iterable[Attachment] = (),
    ) -> None:
        self.chain = chain
        self.drives = [servos[name] for name in chain.joints]
        self.servo_data = [_servo_data(cell, name) for name in chain.joints]
        self.limits = motion_limits(self.servo_data)
        """Limits of planned motions."""
        self.torque_limits = np.array([data.max_torque for data in self.servo_data])
        """Largest torque of each module, N m."""
        self._rotor_inertias = np.array([data.rotor_inertia for data in self.servo_data])
        self._dampings = np.array([data.damping for data in self.servo_data])
        self._frictions = np.array([data.friction for data in self.servo_data])
        self.model = ArmModel(cell, chain, {name: servos[name].read().position for name in chain.side_joints})
        self.base = Transform.from_pose(base_pose(chain.ground)) if chain.ground else IDENTITY
        """Frame of the base in the world; it turns gravity in the frame of the model."""
        self.model.set_base(self.base)
        self.contact = ContactObserver(self.model, self.torque_limits, on_wheels=not _stands_still(cell, chain))
        """External torques on the joints."""
        self._payload = PayloadEstimator(self.model, len(chain.joints)) if self.model.has_load else None
        self._second_base = _find_second_base(cell, chain, tuple(connected), base_pose)

    def read(self) -> list[ServoReading]:
        """Readings of all servo modules."""
        return [drive.read() for drive in self.drives]

    def tip_pose(self, positions: Array) -> Pose:
        """Pose of the tip in the world at these positions of the joints (rad); the origin without a tip."""
        if self.chain.tip_body is None:
            return Pose()
        return (self.base @ self.model.tip_pose(positions)).to_pose()

    def motor_torques(self, setpoint: Setpoint) -> Array:
        """The torques (N m) that a setpoint demands of the motors."""
        links = self.model.inverse_dynamics(setpoint.q, setpoint.v, setpoint.a)
        rotors = self._rotor_inertias * setpoint.a + self._dampings * setpoint.v
        found: Array = links + rotors + self._frictions * np.sign(setpoint.v)
        return found

    @property
    def planned_torques(self) -> Array:
        """Largest torques (N m) that planned motions may demand of the motors."""
        found: Array = TORQUE_RESERVE * self.torque_limits
        return found

    def torque_ratio(self, setpoint: Setpoint) -> float:
        """The largest torque that a setpoint demands of a motor, as a fraction of what planned motions may use."""
        return float(np.max(np.abs(self.motor_torques(setpoint)) / self.planned_torques, initial=0.0))

    def update_load(self, measured: JointMeasurements, dt: float) -> None:
        """Estimate the mass of a box at the tip, and take it into the model, unless something may be in the way."""
        if self._payload is not None and not self.contact.suspects:
            self.model.set_load(self._payload.update(measured.q, measured.v, measured.spring, dt))

    def shared_load(self, q: Array, dt: float) -> Array:
        """Torques (N m) to add so that each of two bases carries half of the arm: then either may let go."""
        if self._second_base is None:
            return np.zeros(len(q))
        return self._second_base.relief(self.model, q, dt)


class _SecondBase:
    """A second base that an arm holds on to, and the model of the arm as if that one carried it alone."""

    def __init__(self, model: ArmModel, indices: Sequence[int]) -> None:
        """`indices` are those of the joints of `model` in the chain from the first base."""
        self._model = model
        self._indices = list(indices)
        self._elapsed = 0.0

    def relief(self, model: ArmModel, q: Array, dt: float) -> Array:
        """Half of the difference between the torques of both models at rest, N m; it grows within `SHARING_TIME`."""
        self._elapsed = min(1.0, self._elapsed + dt / SHARING_TIME)
        carried = np.empty_like(q)
        carried[self._indices] = self._model.gravity(q[self._indices])
        return 0.5 * smooth_step(self._elapsed) * (carried - model.gravity(q))


def carried_over(before: Sequence[str], after: Sequence[str], values: Array, initial: Sequence[float] | Array) -> Array:
    """Values of the joints `before`, for the joints `after`: those that are new have theirs of `initial`."""
    rows = {name: index for index, name in enumerate(before)}
    return np.array(
        [float(values[rows[name]]) if name in rows else value for name, value in zip(after, initial, strict=True)],
        dtype=float,
    )


def _find_second_base(
    cell: CellSetup, chain: ArmChain, connected: tuple[Attachment, ...], base_pose: Callable[[str], Pose]
) -> _SecondBase | None:
    for connection in chain.held_by:
        other = find_chain(cell, connected, connection)
        if other.base == connection and set(other.joints) == set(chain.joints):
            model = ArmModel(cell, other)
            model.set_base(Transform.from_pose(base_pose(other.ground)))
            return _SecondBase(model, [chain.joints.index(name) for name in other.joints])
    return None


def _stands_still(cell: CellSetup, chain: ArmChain) -> bool:
    """True if the base of a chain is bolted down."""
    return any(part.fixed and part.name == chain.ground for part in cell.parts)


def _servo_data(cell: CellSetup, name: str) -> ServoData:
    servo = cell.type_of(name).servo
    assert servo is not None
    return servo


def motion_limits(servos: Sequence[ServoData]) -> Limits:
    """Limits of planned motions of an arm with these servo modules."""
    count = len(servos)
    speeds = tuple(SPEED_RESERVE * servo.max_speed for servo in servos)
    return Limits(speeds, (ACCELERATION,) * count, (ACCELERATION / JERK_TIME,) * count)
