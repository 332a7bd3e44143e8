"""The rigid-body model of an arm as it is assembled, by pinocchio, and the load that it feels. SI units."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY, Vector, rotated, rotation_about, scaled, transposed
from jauspy.platform.modular.graph import ArmChain, Body, Link
from jauspy.platform.modular.parts import CellSetup, PartSolid, Shape

Array = NDArray[np.float64]

SMOOTHING: Final = 0.02
"""Seconds over which torques and accelerations are averaged, both in the same way."""

MEMORY: Final = 0.25
"""Seconds after which a measurement has lost most of its weight."""

LARGEST: Final = 20.0
"""Kilograms: no estimate is larger."""


class ArmModel:
    """Kinematics and dynamics of a chain, with what hangs on it, in the frame of its base."""

    def __init__(self, cell: CellSetup, chain: ArmChain, side_positions: Mapping[str, float] | None = None) -> None:
        """Build it; `side_positions` (rad) are those of servo modules in branches, which count as rigid."""
        self.chain = chain
        self._model, self._frames = _build(cell, chain, side_positions or {})
        self._data = self._model.createData()
        self._load_mass, self._load_joint = 0.0, 0
        self._load = pin.Inertia.Zero()
        tip = chain.tip_body
        self._tip_joint, self._tip_pose = 0, pin.SE3.Identity()
        if tip is not None:
            joint, pose = self._frames[tip]
            self._tip_joint, self._tip_pose = joint, pose * se3(chain.tip_pose)
        if chain.load_at_tip:
            self._load_joint, pose = self._frames[Body(chain.load_at_tip)]
            self._load = pose.act(_unit_inertia(cell.type_of(chain.load_at_tip).solids))
        self._without_load = pin.Inertia(self._model.inertias[self._load_joint])
        self._empty = self._unit = self._model
        self._empty_data = self._unit_data = self._data
        if self.has_load:
            self._empty, self._unit = self._model.copy(), self._model.copy()
            self._empty_data, self._unit_data = self._empty.createData(), self._unit.createData()
            self._unit.inertias[self._load_joint] = self._without_load + self._load

    @property
    def has_load(self) -> bool:
        """True if there is a box at the tip that joints carry."""
        return self._load_joint > 0

    @property
    def load_mass(self) -> float:
        """Mass of the box at the tip in the model, in kilograms."""
        return self._load_mass

    def set_load(self, mass: float) -> None:
        """Set the mass of the box at the tip (kg); its shape is that of its type. Without a box it has no effect."""
        if self.has_load:
            self._load_mass = mass
            load = pin.Inertia(self._load.mass * mass, self._load.lever, self._load.inertia * mass)
            self._model.inertias[self._load_joint] = self._without_load + load

    def set_base(self, base: Transform) -> None:
        """Set where the base is in the world, which turns gravity in its frame."""
        down = rotated(transposed(base.rotation), (0.0, 0.0, -GRAVITY))
        for model in (self._model, self._empty, self._unit):
            model.gravity.linear = np.array(down)

    def inverse_dynamics(self, q: Array, v: Array, a: Array) -> Array:
        """Torques (N m) at the outputs for accelerations `a`."""
        found: Array = pin.rnea(self._model, self._data, q, v, a)
        return found

    def gravity(self, q: Array) -> Array:
        """Torques (N m) that hold the arm at rest."""
        found: Array = pin.computeGeneralizedGravity(self._model, self._data, q)
        return found

    def mass_matrix(self, q: Array) -> Array:
        """The mass matrix (kg m^2), symmetric."""
        found: Array = pin.crba(self._model, self._data, q)
        return found

    def momentum(self, q: Array, v: Array) -> tuple[Array, Array]:
        """The generalized momentum (N m s), and its rate (N m) without torques at the joints: C^T v - g."""
        momentum: Array = pin.crba(self._model, self._data, q) @ v
        coriolis: Array = pin.computeCoriolisMatrix(self._model, self._data, q, v)
        rate: Array = coriolis.T @ v - pin.computeGeneralizedGravity(self._model, self._data, q)
        return momentum, rate

    def load_torques(self, q: Array, v: Array, a: Array) -> tuple[Array, Array]:
        """Torques (N m) without the box at the tip, and those for each kilogram of it."""
        without: Array = pin.rnea(self._empty, self._empty_data, q, v, a)
        with_load: Array = pin.rnea(self._unit, self._unit_data, q, v, a)
        return without, with_load - without

    def tip_pose(self, q: Array) -> Transform:
        """The tip's frame in the frame of the base."""
        pin.forwardKinematics(self._model, self._data, q)
        return transform(self._data.oMi[self._tip_joint] * self._tip_pose)


class PayloadEstimator:
    """Least squares with fading memory: spring torques less those of the arm alone, over those of each kilogram.

    The springs are behind the gears, so friction does not disturb. A box that still rests on something counts only by
    what the arm carries of it.
    """

    def __init__(self, model: ArmModel, joints: int) -> None:
        self._model = model
        self._last: Array | None = None
        self._acceleration, self._torque = np.zeros(joints), np.zeros(joints)
        self._product = self._square = 0.0

    def update(self, q: Array, v: Array, spring: Array, dt: float) -> float:
        """The mass (kg) after another `dt` seconds."""
        if self._last is None:
            self._last, self._torque = v, spring
            return 0.0
        part = min(1.0, dt / SMOOTHING)
        self._acceleration = self._acceleration + part * ((v - self._last) / dt - self._acceleration)
        self._torque = self._torque + part * (spring - self._torque)
        self._last = v
        without, per_kilogram = self._model.load_torques(q, v, self._acceleration)
        keep = 1.0 - dt / MEMORY
        self._product = keep * self._product + float(per_kilogram @ (self._torque - without))
        self._square = keep * self._square + float(per_kilogram @ per_kilogram)
        return min(LARGEST, max(0.0, self._product / self._square)) if self._square > 1e-9 else 0.0


def _build(
    cell: CellSetup, chain: ArmChain, side_positions: Mapping[str, float]
) -> tuple[Any, dict[Body, tuple[int, Any]]]:
    """The model, and for each body the joint that moves it and its frame in that joint's frame."""
    model = pin.Model()
    model.gravity.linear = np.array((0.0, 0.0, -GRAVITY))
    frames: dict[Body, tuple[int, Any]] = {}
    if chain.root is not None:
        frames[chain.root] = (0, se3(chain.mount))
    for link in chain.links:
        joint, parent = frames[link.parent]
        placement = parent * se3(link.joint_pose)
        if link.joint and link.joint not in chain.side_joints:
            axis = np.array(joint_axis(cell, link))
            joint = model.addJoint(joint, pin.JointModelRevoluteUnaligned(axis), placement, link.joint)
            placement = pin.SE3.Identity()
        elif link.joint:
            turned = rotation_about(joint_axis(cell, link), side_positions.get(link.joint, 0.0))
            placement *= se3(Transform(turned))
        frames[link.body] = (joint, placement * se3(link.body_pose))
    for body, (joint, pose) in frames.items():
        if body.part != chain.load_at_tip and joint:
            for solid in _solids(cell, body):
                model.appendBodyToJoint(joint, solid_inertia(solid), pose)
    return model, frames


def _solids(cell: CellSetup, body: Body) -> Iterable[PartSolid]:
    kind = cell.type_of(body.part)
    return kind.servo.output if body.output and kind.servo is not None else kind.solids


def _unit_inertia(solids: Iterable[PartSolid]) -> Any:
    """The inertia of a box of one kilogram."""
    inertia = sum((solid_inertia(solid) for solid in solids), pin.Inertia.Zero())
    return pin.Inertia(1.0, inertia.lever, inertia.inertia / inertia.mass) if inertia.mass else pin.Inertia.Zero()


def joint_axis(cell: CellSetup, link: Link) -> Vector:
    """The axis of a link's joint, in the frame at `joint_pose`, that turns the link by plus the servo's position."""
    servo = cell.type_of(link.joint).servo
    assert servo is not None
    axis = rotated(transposed(servo.joint.rotation), servo.axis)
    return scaled(axis, -1.0) if link.reversed else axis


def solid_inertia(solid: PartSolid) -> Any:
    """The inertia of a homogeneous primitive as pinocchio's `Inertia`, in the frame in which its pose is given."""
    x, y, z = solid.size
    if solid.shape is Shape.CYLINDER:
        inertia = pin.Inertia.FromCylinder(solid.mass, x, z)
    else:
        inertia = pin.Inertia.FromBox(solid.mass, x, y, z)
    return se3(solid.pose).act(inertia)


def se3(frame: Transform) -> Any:
    """The same transform as pinocchio's `SE3`."""
    return pin.SE3(np.array(frame.rotation), np.array(frame.position))


def transform(frame: Any) -> Transform:
    """The same transform as jauspy has it."""
    a, b, c = (tuple(row) for row in frame.rotation.tolist())
    return Transform((a, b, c), tuple(frame.translation.tolist()))
