"""Kinematic calibration of a modular arm from measured poses of its tip, by least squares over pinocchio's kinematics.

What is found: an offset of each joint's zero, the pose of each part on its connector (modules that sit off a little or
by 1.5 degrees, or turned by a quarter), and how far all connectors give way under moments.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin
from scipy.optimize import least_squares

from jauspy.cell.frames import Array, se3
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.dynamics import joint_axis, solid_inertia
from jauspy.platform.modular.graph import ArmChain
from jauspy.platform.modular.parts import CellSetup

ANGLE_WEIGHT: Final = 0.2
"""Metres: an error of one radian weighs like one of this length."""

TRANSLATION_PRIOR, ROTATION_PRIOR, OFFSET_PRIOR = 0.01, 0.1, 0.1
"""Metres and radians: expected size of errors. They decide what measured poses leave open, as of parallel axes."""

COMPLIANCE_PRIOR: Final = 0.003
"""Radians per newton metre."""

NOISE: Final = 2e-5
"""Metres: expected error of measured poses; it scales the priors."""

QUARTERS: Final = (0.0, math.pi / 2.0, math.pi, -math.pi / 2.0)

AXES: Final = ("PX", "PY", "PZ", "RX", "RY", "RZ")


@dataclass(frozen=True, slots=True)
class Parameters:
    """The errors of an arm of n joints and m connectors, as calibration finds them."""

    offsets: Array
    """Shape (n,): offsets of the joints' zeros, base to tip, rad."""
    connectors: Array
    """Shape (m, 6): translation (m) and rotation vector (rad) of the part on each connector, base to tip."""
    quarters: Array
    """Shape (m,): rotation about each connector's normal by whole quarters of a turn, rad; before the above."""
    compliance: float = 0.0
    """Radians per newton metre that each connector gives way."""


class ArmGeometry:
    """Kinematics of an arm as it is assembled, with parameters of its errors; `q` in rad, base to tip."""

    def __init__(self, cell: CellSetup, chain: ArmChain, base: pin.SE3) -> None:
        self.joints = chain.joints
        self._base = base
        self._model, self._tip_joint, self._tip = pin.Model(), 0, pin.SE3.Identity()
        self._model.gravity.linear = base.rotation.T @ np.array([0.0, 0.0, -GRAVITY])
        self._servo: list[int] = []
        self._connector: list[int] = []
        frames = {}
        assert chain.root is not None
        frames[chain.root] = self._add_connector(0, se3(chain.mount)), pin.SE3.Identity()
        for link in chain.links:
            joint, placement = frames[link.parent]
            placement = placement * se3(link.joint_pose)
            if link.joint:
                axis = np.array(joint_axis(cell, link))
                joint = self._model.addJoint(joint, pin.JointModelRevoluteUnaligned(axis), placement, link.joint)
                self._servo.append(self._model.joints[joint].idx_q)
                frames[link.body] = joint, se3(link.body_pose)
            else:
                frames[link.body] = self._add_connector(joint, placement * se3(link.body_pose)), pin.SE3.Identity()
        for body, (joint, pose) in frames.items():
            kind = cell.type_of(body.part)
            for solid in kind.servo.output if body.output and kind.servo is not None else kind.solids:
                self._model.appendBodyToJoint(joint, solid_inertia(solid), pose)
        assert chain.tip_body is not None
        self._tip_joint, pose = frames[chain.tip_body]
        self._tip = pose * se3(chain.tip_pose)
        self._data = self._model.createData()
        self.nominal = Parameters(
            np.zeros(len(self._servo)), np.zeros((len(self._connector), 6)), np.zeros(len(self._connector))
        )

    def _add_connector(self, joint: int, placement: pin.SE3) -> int:
        """Six small joints, and before them one for whole quarters: returns the last."""
        number = len(self._connector)
        joint = self._model.addJoint(joint, pin.JointModelRZ(), placement, f"connector_{number}.quarter")
        self._connector.append(self._model.joints[joint].idx_q)
        for axis in AXES:
            kind = getattr(pin, f"JointModel{axis}")()
            joint = self._model.addJoint(joint, kind, pin.SE3.Identity(), f"connector_{number}.{axis}")
        return int(joint)

    def tip(self, q: Array, parameters: Parameters) -> pin.SE3:
        """The pose of the tip in the world."""
        whole = np.zeros(self._model.nq)
        whole[self._servo] = q + parameters.offsets
        for at, errors, quarter in zip(self._connector, parameters.connectors, parameters.quarters, strict=True):
            whole[at] = quarter
            whole[at + 1 : at + 7] = errors
        if parameters.compliance:
            moments = pin.computeGeneralizedGravity(self._model, self._data, whole)
            for at in self._connector:
                whole[at + 4 : at + 7] -= parameters.compliance * moments[at + 4 : at + 7]
        pin.forwardKinematics(self._model, self._data, whole)
        return self._base * self._data.oMi[self._tip_joint] * self._tip

    def solve(self, goal: pin.SE3, start: Array, parameters: Parameters) -> Array:
        """The positions near `start` that bring the tip to `goal`: the place exactly, attitude as far as it goes."""

        def residual(q: Array) -> Array:
            return _difference(self.tip(q, parameters), goal, 0.02)

        found: Array = least_squares(residual, start, method="trf", x_scale=0.1, xtol=1e-12, ftol=1e-14).x
        # attitude and place compete if there are less than six joints: the place counts
        for _ in range(20):
            error = self.tip(found, parameters).translation - goal.translation
            if float(np.linalg.norm(error)) < 1e-7:
                break
            jacobian = (
                np.array(
                    [
                        (
                            self.tip(found + step, parameters).translation
                            - self.tip(found - step, parameters).translation
                        )
                        for step in 1e-6 * np.eye(len(found))
                    ]
                ).T
                / 2e-6
            )
            found = found - np.linalg.lstsq(jacobian, error, rcond=1e-3)[0]
        return found

    def calibrate(self, positions: Sequence[Array], poses: Sequence[pin.SE3]) -> Parameters:
        """The parameters that explain measured poses of the tip best; modules turned by quarters are found first."""
        quarters = self._find_quarters(positions, poses)
        return self._fit(positions, poses, quarters)

    def _find_quarters(self, positions: Sequence[Array], poses: Sequence[pin.SE3]) -> Array:
        best, cost = self.nominal.quarters, self._cost(self.nominal, positions, poses)
        for _ in self._connector:
            trials = []
            for number in range(len(self._connector)):
                for quarter in QUARTERS:
                    turned = best.copy()
                    turned[number] = quarter
                    trial = Parameters(self.nominal.offsets, self.nominal.connectors, turned)
                    trials.append((self._cost(trial, positions, poses), number, quarter, turned))
            found = min(trials, key=lambda trial: trial[:3])
            if found[0] >= 0.8 * cost:
                break
            cost, best = found[0], found[3]
        return best

    def _cost(self, parameters: Parameters, positions: Sequence[Array], poses: Sequence[pin.SE3]) -> float:
        return sum(
            float(np.sum(_difference(self.tip(q, parameters), pose, ANGLE_WEIGHT) ** 2))
            for q, pose in zip(positions, poses, strict=True)
        )

    def _fit(self, positions: Sequence[Array], poses: Sequence[pin.SE3], quarters: Array) -> Parameters:
        joints, connectors = len(self._servo), len(self._connector)
        scale = np.concatenate(
            [
                np.full(joints, OFFSET_PRIOR),
                np.tile([TRANSLATION_PRIOR] * 3 + [ROTATION_PRIOR] * 3, connectors),
                [COMPLIANCE_PRIOR],
            ]
        )

        def unpack(x: Array) -> Parameters:
            values = x * scale
            return Parameters(values[:joints], values[joints:-1].reshape(connectors, 6), quarters, float(values[-1]))

        def residual(x: Array) -> Array:
            parameters = unpack(x)
            rows = [
                _difference(self.tip(q, parameters), pose, ANGLE_WEIGHT)
                for q, pose in zip(positions, poses, strict=True)
            ]
            return np.concatenate([*rows, NOISE * x])

        return unpack(least_squares(residual, np.zeros(len(scale)), method="trf", x_scale="jac", max_nfev=15).x)


def _difference(found: pin.SE3, wanted: pin.SE3, angle_weight: float) -> Array:
    """Position error (m), and attitude error times a weight."""
    rotation = pin.log3(wanted.rotation.T @ found.rotation)
    return np.concatenate([found.translation - wanted.translation, angle_weight * rotation])
