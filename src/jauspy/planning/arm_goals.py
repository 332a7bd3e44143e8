"""Inverse kinematics for planners: postures that reach a goal, from many starts at once, of arms of any joints."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Final

import numpy as np

from jauspy.geometry.kinematics import ATTITUDE_TOLERANCE, POSITION_TOLERANCE
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.motion import PoseGoal, RegionGoal
from jauspy.planning.obstacles import Array

STARTS: Final = 48
"""Postures from which descents begin at once."""
STEPS: Final = 16
"""Steps of a descent."""
MAX_STEP: Final = 0.6
"""Radians or metres by which a step changes a joint at most."""
DAMPING: Final = 1e-4
ATTITUDE_WEIGHT: Final = 0.3
"""Metres that a radian of attitude counts as."""
SAME: Final = 0.05
"""Radians or metres up to which two postures count as one."""
MOST: Final = 24
"""Postures that are returned at most."""


@dataclass(frozen=True, slots=True)
class Reached:
    """The postures that reach a goal, the nearest to the start first, and how near the best try came."""

    postures: Array
    """Shape (n, joints)."""
    distance: float
    """Metres from the goal to the tool point of the try that came nearest."""


class PostureSearch:
    """Searches postures that have the tool in a goal, by damped least squares within the joints' limits."""

    def __init__(self, arm: ArmModel, goal: PoseGoal | RegionGoal, start: Array, seed: int) -> None:
        self._arm, self._start = arm, start
        self._rng = np.random.default_rng(seed)
        self._turn, self._place = np.array(goal.pose.rotation), np.array(goal.pose.position)
        if isinstance(goal, RegionGoal):
            self._half, self._angle = np.array(goal.size) / 2.0, goal.angle
        else:
            self._half, self._angle = np.zeros(3), 0.0 if goal.attitude else math.tau

    def run(self, starts: int = STARTS) -> Reached:
        """The postures that descents from the start, and from random ones, lead to."""
        arm = self._arm
        q = self._rng.uniform(arm.lower, arm.upper, (starts, len(arm.joints)))
        q[0] = self._start
        near = slice(1, starts // 4)
        q[near] = np.clip(self._start + self._rng.normal(0.0, 0.5, q[near].shape), arm.lower, arm.upper)
        spread = self._rng.uniform(-1.0, 1.0, (starts, 3)) * self._half  # of goals within a region
        for _ in range(STEPS):
            error, jacobian = self._errors(q, spread)
            if (np.abs(error) < 1e-7).all():
                break
            square = jacobian @ jacobian.transpose(0, 2, 1) + DAMPING * np.eye(6)
            step = (jacobian.transpose(0, 2, 1) @ np.linalg.solve(square, error[..., None]))[..., 0]
            step *= np.minimum(1.0, MAX_STEP / np.maximum(np.abs(step).max(axis=1), 1e-12))[:, None]
            q = np.clip(q + step, arm.lower, arm.upper)
        distance, angle = self._remaining(q)
        good = (distance <= POSITION_TOLERANCE) & (angle <= ATTITUDE_TOLERANCE)
        return Reached(self._distinct(q[good]), float(distance.min()))

    def angle(self, postures: Array) -> float:
        """The least angle, in radians, from the goal's attitudes to those of the tool in these postures."""
        _, angles = self._rotations(self._arm.tool(self._arm.frames(postures)))
        return float(max(0.0, angles.min() - self._angle))

    def _errors(self, q: Array, spread: Array) -> tuple[Array, Array]:
        """What is left to each goal, and its Jacobian, both with weights."""
        frames = self._arm.frames(q)
        tool = self._arm.tool(frames)
        points = tool[:, :3, 3]
        turn, angle = self._rotations(tool)
        keep = np.maximum(angle - 0.9 * self._angle, 0.0) / np.maximum(angle, 1e-9)
        weight = 0.0 if self._angle >= math.pi else ATTITUDE_WEIGHT
        linear = self._place + spread @ self._turn.T - points
        error = np.concatenate([linear, weight * turn * keep[:, None]], axis=1)
        jacobian = self._arm.jacobian(frames, points)
        jacobian[:, 3:] *= weight * (keep > 0.0)[:, None, None]
        return error, jacobian

    def _rotations(self, tool: Array) -> tuple[Array, Array]:
        """Rotation vectors from the tools' attitudes to the goal's, and their angles."""
        between = self._turn @ tool[:, :3, :3].transpose(0, 2, 1)
        skew = np.stack(
            [
                between[:, 2, 1] - between[:, 1, 2],
                between[:, 0, 2] - between[:, 2, 0],
                between[:, 1, 0] - between[:, 0, 1],
            ],
            axis=1,
        )
        sine = np.sqrt((skew * skew).sum(axis=1)) / 2.0
        angle = np.arctan2(sine, (np.trace(between, axis1=1, axis2=2) - 1.0) / 2.0)
        return skew / 2.0 * (angle / np.maximum(sine, 1e-9))[:, None], angle

    def _remaining(self, q: Array) -> tuple[Array, Array]:
        """Metres and radians outside of the goal."""
        tool = self._arm.tool(self._arm.frames(q))
        inside = (tool[:, :3, 3] - self._place) @ self._turn
        outside = np.maximum(np.abs(inside) - self._half, 0.0)
        _, angle = self._rotations(tool)
        return np.sqrt((outside * outside).sum(axis=1)), np.maximum(angle - self._angle, 0.0)

    def _distinct(self, q: Array) -> Array:
        """Postures that differ, with whole turns of joints that can make them, the nearest to the start first."""
        arm = self._arm
        every = q
        if len(q) and (arm.upper - arm.lower > math.tau).any():
            choices = [
                (-math.tau, 0.0, math.tau) if wide else (0.0,) for wide in (arm.upper - arm.lower > math.tau).tolist()
            ]
            nearest = q + math.tau * np.round((self._start - q) / math.tau) * (arm.upper - arm.lower > math.tau)
            every = nearest
            if ((nearest < arm.lower) | (nearest > arm.upper)).any():
                turned = nearest[:, None] + np.array(list(product(*choices)))[None]
                fits = ((turned >= arm.lower) & (turned <= arm.upper)).all(axis=2)
                length = np.where(fits, self._lengths(turned), np.inf)
                every = turned[np.arange(len(q)), length.argmin(axis=1)]
        order = np.argsort(self._lengths(every))
        found: list[Array] = []
        for number in order.tolist():
            if all(np.abs(every[number] - other).max() > SAME for other in found):
                found.append(every[number])
            if len(found) == MOST:
                break
        return np.array(found).reshape(-1, len(arm.joints))

    def _lengths(self, q: Array) -> Array:
        ways = (q - self._start) * self._arm.scales
        found: Array = np.sqrt((ways * ways).sum(axis=-1))
        return found
