"""Kinematics of an arm of modules, as a client sees it: from the parts, and from what their connectors report."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3
from jauspy.cell.scene import LinkPiece, Piece, pieces_of
from jauspy.errors import ConfigError
from jauspy.platform.modular.parts import PartType

MAX_ITERATIONS: Final = 60
TOLERANCE: Final = 1e-5
"""Metres and radians."""
LEANING: Final = 0.02
"""Radians by which the tip may lean: four joints cannot also make up for parts that sit askew."""
LEAN_WEIGHT: Final = 0.03
"""Metres of the tip's place that count as much as a radian of its direction."""
DAMPING: Final = 1e-7
MAX_STEP: Final = 0.4
BENDS: Final = (-1.9, -1.1, -0.4, 0.4, 1.1, 1.9)
"""Starts of the joints in the middle, in radians."""


@dataclass(frozen=True, slots=True)
class Member:
    """One part of a chain."""

    name: str
    type: PartType
    offset: pin.SE3
    """Its frame in that of the connector that holds it."""
    connector: str
    """Its connector that holds the next part, or is the tip."""


class Chain:
    """An arm that stands on a connector; joints are in the order base to tip."""

    def __init__(self, base: pin.SE3, members: Iterable[Member]) -> None:
        self.members = tuple(members)
        self.model = pin.Model()
        self.joints: list[str] = []
        self.links: list[LinkPiece] = []
        """Their shapes, each with the number of the joint that moves it."""
        joint, frame = self._build(base)
        self.tool = self.model.addFrame(pin.Frame("tip", joint, 0, frame, pin.FrameType.OP_FRAME))
        self.data = self.model.createData()
        fastest = {each.name: each.type.servo.max_speed for each in self.members if each.type.servo is not None}
        self.speeds = np.array([fastest[name] for name in self.joints])
        self.lower, self.upper = np.full(len(fastest), -math.tau), np.full(len(fastest), math.tau)

    def _build(self, base: pin.SE3) -> tuple[int, pin.SE3]:
        """Make the model; returns the last joint, and the frame of the tip after it."""
        joint, frame = 0, base
        for member in self.members:
            frame = frame * member.offset
            self._add_links(member.name, pieces_of(member.type.solids, frame), joint)
            if member.type.servo is not None:
                servo = member.type.servo
                placement = frame * se3(servo.joint)
                axis = se3(servo.joint).rotation.T @ np.array(servo.axis)
                joint = self.model.addJoint(joint, pin.JointModelRevoluteUnaligned(axis), placement, member.name)
                self.joints.append(member.name)
                self._add_links(member.name, pieces_of(servo.output), joint)
                frame = pin.SE3.Identity()
            if member.connector not in member.type.connectors:
                raise ConfigError(f"{member.name} has no connector {member.connector!r}")
            frame = frame * se3(member.type.connectors[member.connector])
        return joint, frame

    def _add_links(self, name: str, pieces: Iterable[Piece], joint: int) -> None:
        self.links += [LinkPiece(name, piece, joint) for piece in pieces]

    def forward(self, positions: Array) -> pin.SE3:
        """The frame of the tip in the world."""
        pin.framesForwardKinematics(self.model, self.data, positions)
        return self.data.oMf[self.tool].copy()

    @property
    def root(self) -> Array:
        """Where the first joint is, in the world."""
        return np.array(self.model.jointPlacements[1].translation)

    def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
        """The posture near `start` with the tip at the place of `goal` and its z along that of `goal`."""
        return self._solve(goal.translation, goal.rotation[:, 2], start)

    def solve_down(self, point: Sequence[float], start: Array) -> Array | None:
        """The posture near `start` with the tip at a point, pointing down; None without one."""
        return self._solve(np.array(point), np.array([0.0, 0.0, -1.0]), start)

    def velocity(self, positions: Array, velocities: Array) -> Array:
        """Linear velocity of the tip in the world, m/s."""
        jacobian = pin.computeFrameJacobian(self.model, self.data, positions, self.tool, pin.LOCAL_WORLD_ALIGNED)
        return np.asarray(jacobian[:3] @ velocities)

    def pointing(
        self, position: Array, direction: Array, near: Array, *, bends: Sequence[float] = BENDS
    ) -> list[Array]:
        """Postures with the tip at a point and its z along a direction, in the world; closest to `near` first."""
        found: list[Array] = []
        for start in self._starts(position, near, bends):
            q = self._solve(position, direction, start)
            if q is None:
                continue
            q = near + np.mod(q - near + math.pi, math.tau) - math.pi
            if all(np.max(np.abs(q - each)) > 1e-2 for each in found):
                found.append(q)
        return sorted(found, key=lambda each: float(np.max(np.abs(each - near))))

    def _starts(self, position: Array, near: Array, bends: Sequence[float]) -> Iterable[Array]:
        yield near
        count = self.model.nq
        if count < 3:
            return
        first = pin.SE3(self.model.jointPlacements[1])
        local = first.actInv(np.asarray(position))
        yaw = math.atan2(local[1], local[0])
        for turn in (yaw, yaw + math.pi, -yaw, math.pi - yaw):  # the axis may point either way
            for bend in itertools.product(bends, repeat=min(2, count - 2)):
                start = np.zeros(count)
                start[0] = turn
                start[1 : 1 + len(bend)] = bend
                yield start

    def _solve(self, position: Array, direction: Array, start: Array) -> Array | None:
        q = np.array(start)
        for _ in range(MAX_ITERATIONS):
            tip = self.forward(q)
            off = np.concatenate([position - tip.translation, np.cross(tip.rotation[:, 2], direction)])
            facing = float(tip.rotation[:, 2] @ direction)
            if np.max(np.abs(off)) < TOLERANCE:
                return q if facing > 0.0 else None
            off[3:] *= LEAN_WEIGHT
            jacobian = pin.computeFrameJacobian(self.model, self.data, q, self.tool, pin.LOCAL_WORLD_ALIGNED)
            # of the rotation only what turns the z axis counts
            axis = tip.rotation[:, 2]
            across = np.eye(3) - np.outer(axis, axis)
            rows = np.vstack([jacobian[:3], LEAN_WEIGHT * across @ jacobian[3:]])
            step = rows.T @ np.linalg.solve(rows @ rows.T + DAMPING * np.eye(6), off)
            far = float(np.max(np.abs(step)))
            if far < TOLERANCE and np.max(np.abs(off[:3])) < 20.0 * TOLERANCE:
                return q if facing > math.cos(LEANING) else None
            q = q + step * min(1.0, MAX_STEP / max(far, 1e-12))
        return None


class HangingChain(Chain):
    """An arm that stands on its last connector, whose frame in the world is `base`; the first part is free.

    The joints are in the order from there, and their positions are those of the servo modules, as before. The tip is
    the input flange of the first part.
    """

    def _build(self, base: pin.SE3) -> tuple[int, pin.SE3]:
        joint, frame = 0, base
        for member in reversed(self.members):
            frame = frame * se3(member.type.connectors[member.connector]).inverse()
            if member.type.servo is not None:
                servo = member.type.servo
                self._add_links(member.name, pieces_of(servo.output, frame), joint)
                axis = se3(servo.joint).rotation.T @ np.array(servo.axis)
                joint = self.model.addJoint(joint, pin.JointModelRevoluteUnaligned(-axis), frame, member.name)
                self.joints.append(member.name)
                frame = se3(servo.joint).inverse()
            self._add_links(member.name, pieces_of(member.type.solids, frame), joint)
            frame = frame * member.offset.inverse()
        return joint, frame
