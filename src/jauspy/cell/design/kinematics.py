"""Forward and inverse kinematics of chains of modules, with matrices."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Final

import numpy as np

from jauspy.cell.design.tasks import Goal
from jauspy.geometry.poses import Transform
from jauspy.platform.modular.parts import PartType

MAX_BEND: Final = 2.0
"""Radians to which an elbow bends: further, what is mounted on it comes near the housing. Inline modules turn once."""
ITERATIONS: Final = 60
ORIENTATION_LENGTH: Final = 0.2
"""Metres that one radian counts in inverse kinematics."""


class ChainKinematics:
    """A chain on a connector at `mount`; with each part, its frame in that of the connector that carries it."""

    def __init__(self, mount: Transform, parts: Iterable[tuple[Transform, PartType]]) -> None:
        self._fixed: list[Any] = []
        self._axes: list[Any] = []
        self.bounds: list[float] = []
        self.mount = mount
        """The connector that carries it, in the world."""
        frame = mount
        for offset, part in parts:
            frame = frame @ offset
            if part.servo is not None:
                self._fixed.append(_matrix(frame @ part.servo.joint))
                self._axes.append(np.array(part.servo.axis))
                self.bounds.append(math.pi if abs(part.servo.axis[2]) > 0.9 else MAX_BEND)
                frame = Transform()
            frame = frame @ next(iter(part.connectors.values()))
        self._tip = _matrix(frame)

    def solve(self, goal: Goal, start: Any) -> Any:
        """Joint positions that meet a goal, by damped least squares from `start`, or None."""
        target, q = _matrix(goal.pose), np.array(start, dtype=float)
        oriented = "Theta_R" in goal.tolerances
        for _ in range(ITERATIONS):
            tip, jacobian = self._forward(q)
            if goal.met(_transform(tip)):
                return q
            error = target[:3, 3] - tip[:3, 3]
            if oriented:
                turn = sum(np.cross(tip[:3, axis], target[:3, axis]) for axis in range(3)) / 2.0
                error = np.concatenate([error, ORIENTATION_LENGTH * turn])
            else:
                jacobian = jacobian[:3]
            square = jacobian @ jacobian.T + 1e-4 * np.eye(len(error))
            step = jacobian.T @ np.linalg.solve(square, error)
            q = np.clip(q + step * min(1.0, 0.5 / max(float(np.abs(step).max()), 1e-9)), *self._range())
        return None

    def axes(self) -> Any:
        """Directions of the joints' axes in the world with all joints at zero; shape (joints, 3)."""
        return self._forward(np.zeros(len(self.bounds)))[1][3:].T / ORIENTATION_LENGTH

    def _range(self) -> tuple[Any, Any]:
        high = np.array(self.bounds)
        return -high, high

    def _forward(self, q: Any) -> tuple[Any, Any]:
        frame, joints = np.eye(4), []
        for fixed, axis, angle in zip(self._fixed, self._axes, q, strict=True):
            frame = frame @ fixed
            joints.append((frame[:3, 3], frame[:3, :3] @ axis))
            frame = frame @ _rotation(axis, angle)
        tip = frame @ self._tip
        columns = [[*np.cross(axis, tip[:3, 3] - origin), *(ORIENTATION_LENGTH * axis)] for origin, axis in joints]
        return tip, np.array(columns).T


def _rotation(axis: Any, angle: float) -> Any:
    x, y, z = axis
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * skew + (1.0 - math.cos(angle)) * skew @ skew
    return matrix


def _matrix(frame: Transform) -> Any:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.rotation, frame.position
    return matrix


def _transform(matrix: Any) -> Transform:
    a, b, c, _ = matrix.tolist()
    return Transform((tuple(a[:3]), tuple(b[:3]), tuple(c[:3])), (a[3], b[3], c[3]))
