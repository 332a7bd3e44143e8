"""Forward and inverse kinematics of a fixed arm, such as the UR10, from its URDF; positions as the URDF counts them.

Closed-form postures of Universal Robots' arms are the starts of the exact solution: Hawkins, "Analytic Inverse
Kinematics for the Universal Robots UR-5/UR-10 Arms", Georgia Tech, 2013.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, offset_between, shifted, turned
from jauspy.errors import ConfigError

MAX_ITERATIONS: Final = 25
"""Newton steps of one attempt; from a start on the right branch six to ten suffice."""
TOLERANCE: Final = 1e-6
"""Metres and radians."""
DAMPING: Final = 1e-6
MAX_JOINT_STEP: Final = 0.6
"""Radians that one Newton step may move a joint."""
MIN_CONDITION: Final = 0.04
"""Smallest singular value of the Jacobian (m and rad per rad) of postures that are used: near a singularity, small
corrections of the tool need large motions of joints."""
FRAME_TOLERANCE: Final = 0.02
"""Metres and radians by which a URDF may differ from the published arm for its closed-form postures to be starts."""
_BRANCHES: Final = tuple(itertools.product((0.0, math.pi), (1.0, -1.0), (1.0, -1.0)))
"""Starts of the search for other arms: the direction of the upper arm, and the signs of elbow and wrist."""


@dataclass(frozen=True, slots=True)
class URParameters:
    """Denavit-Hartenberg parameters as the maker publishes them, in metres."""

    d1: float
    a2: float
    a3: float
    d4: float
    d5: float
    d6: float


UR10: Final = URParameters(d1=0.1273, a2=-0.612, a3=-0.5723, d4=0.163941, d5=0.1157, d6=0.0922)
_TWISTS: Final = (math.pi / 2.0, 0.0, 0.0, math.pi / 2.0, -math.pi / 2.0, 0.0)


def _link(angle: float, offset: float, length: float, twist: float) -> pin.SE3:
    c, s, ct, st = math.cos(angle), math.sin(angle), math.cos(twist), math.sin(twist)
    rotation = np.array([[c, -s * ct, s * st], [s, c * ct, -c * st], [0.0, st, ct]])
    return pin.SE3(rotation, np.array([length * c, length * s, offset]))


def forward(parameters: URParameters, q: Array) -> pin.SE3:
    """The flange in the base frame of the maker's convention."""
    p = parameters
    offsets, lengths = (p.d1, 0.0, 0.0, p.d4, p.d5, p.d6), (0.0, p.a2, p.a3, 0.0, 0.0, 0.0)
    frame = pin.SE3.Identity()
    for angle, offset, length, twist in zip(q, offsets, lengths, _TWISTS, strict=True):
        frame = frame * _link(float(angle), offset, length, twist)
    return frame


def inverse(parameters: URParameters, flange: pin.SE3) -> list[Array]:
    """Up to eight postures that have the flange there, angles in -pi..pi."""
    p = parameters
    x, y, _ = flange.translation
    wrist = flange.translation - p.d6 * flange.rotation[:, 2]
    reach = math.hypot(wrist[0], wrist[1])
    if reach < p.d4:
        return []
    psi, phi = math.atan2(wrist[1], wrist[0]), math.acos(p.d4 / reach)
    found = []
    for shoulder, flip in itertools.product((phi, -phi), (1.0, -1.0)):
        q1 = psi + shoulder + math.pi / 2.0
        s1, c1 = math.sin(q1), math.cos(q1)
        cosine = (x * s1 - y * c1 - p.d4) / p.d6
        if abs(cosine) > 1.0:
            continue
        q5 = flip * math.acos(cosine)
        q6 = _sixth(flange, s1, c1, math.sin(q5))
        middle = _link(q1, p.d1, 0.0, _TWISTS[0]).actInv(flange)
        outer = _link(q5, p.d5, 0.0, _TWISTS[4]) * _link(q6, p.d6, 0.0, _TWISTS[5])
        fourth = middle * outer.inverse()
        elbow = fourth.act(np.array([0.0, -p.d4, 0.0]))
        found += [np.array([q1, *bend, q5, q6]) for bend in _elbows(p, elbow, fourth)]
    return [np.mod(q + math.pi, math.tau) - math.pi for q in found]


def _sixth(flange: pin.SE3, s1: float, c1: float, s5: float) -> float:
    if abs(s5) < 1e-6:
        return 0.0
    back = flange.rotation.T
    return math.atan2(
        (-back[1, 0] * s1 + back[1, 1] * c1) / s5,
        (back[0, 0] * s1 - back[0, 1] * c1) / s5,
    )


def _elbows(p: URParameters, elbow: Array, fourth: pin.SE3) -> list[tuple[float, float, float]]:
    far = float(np.linalg.norm(elbow))
    cosine = (far * far - p.a2 * p.a2 - p.a3 * p.a3) / (2.0 * p.a2 * p.a3)
    if abs(cosine) > 1.0 or far < 1e-6:
        return []
    found = []
    for q3 in (math.acos(cosine), -math.acos(cosine)):
        sine = min(1.0, max(-1.0, p.a3 * math.sin(q3) / far))
        q2 = -math.atan2(elbow[1], -elbow[0]) + math.asin(sine)
        inner = _link(q2, 0.0, p.a2, 0.0) * _link(q3, 0.0, p.a3, 0.0)
        last = inner.actInv(fourth).rotation
        found.append((q2, q3, math.atan2(last[1, 0], last[0, 0])))
    return found


@dataclass(frozen=True, slots=True)
class URFrames:
    """The maker's frames in a URDF: of the base in the world, and of the tool on the flange."""

    parameters: URParameters
    base: pin.SE3
    tool: pin.SE3

    def starts(self, goal: pin.SE3) -> list[Array]:
        """Postures that have the tool close to `goal`."""
        return inverse(self.parameters, self.base.actInv(goal) * self.tool.inverse())


@dataclass(frozen=True, slots=True)
class Posture:
    """A solution: joint positions (rad), and the smallest singular value of the Jacobian there."""

    positions: Array
    condition: float


class ArmKinematics:
    """An arm with six revolute joints, whose base stands in the world as the URDF's root does."""

    def __init__(self, urdf: str, joints: Sequence[str], tool: str) -> None:
        whole = pin.buildModelFromXML(urdf)
        for name in joints:
            if not whole.existJointName(name):
                raise ConfigError(f"the URDF has no joint {name!r}; it has: {', '.join(list(whole.names)[1:])}")
        others = [whole.getJointId(name) for name in list(whole.names)[1:] if name not in joints]
        self.model = pin.buildReducedModel(whole, others, pin.neutral(whole)) if others else whole
        if list(self.model.names)[1:] != list(joints):
            raise ConfigError(f"the joints of an arm are given from its base to its tip, not as {', '.join(joints)}")
        if not self.model.existFrame(tool):
            raise ConfigError(f"the URDF has no link {tool!r}")
        self.tool = self.model.getFrameId(tool)
        """The frame of the tool."""
        self.data = self.model.createData()
        self.lower = np.array(self.model.lowerPositionLimit)
        self.upper = np.array(self.model.upperPositionLimit)
        self.speeds = np.array(self.model.velocityLimit)
        self._published = self._find_published()

    def forward(self, positions: Array) -> pin.SE3:
        """The pose of the tool in the world."""
        pin.framesForwardKinematics(self.model, self.data, positions)
        return self.data.oMf[self.tool].copy()

    def jacobian(self, positions: Array) -> Array:
        """Linear and angular velocity of the tool in the world by those of the joints, shape (6, joints)."""
        axes = pin.LOCAL_WORLD_ALIGNED
        return np.asarray(pin.computeFrameJacobian(self.model, self.data, positions, self.tool, axes))

    def condition(self, positions: Array) -> float:
        """The smallest singular value of the Jacobian; 0 in a singularity."""
        jacobian = pin.computeFrameJacobian(self.model, self.data, positions, self.tool, pin.LOCAL)
        return float(np.linalg.svd(jacobian, compute_uv=False)[-1])

    def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
        """The posture near `start` that has the tool at `goal`; None if the search does not converge."""
        model, data, tool = self.model, self.data, self.tool
        q = np.array(start)
        for _ in range(MAX_ITERATIONS):
            pin.framesForwardKinematics(model, data, q)
            error = pin.log6(data.oMf[tool].actInv(goal)).vector
            if np.max(np.abs(error)) < TOLERANCE:
                return q
            jacobian = pin.computeFrameJacobian(model, data, q, tool, pin.LOCAL)
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + DAMPING * np.eye(6), error)
            q += step * min(1.0, MAX_JOINT_STEP / max(float(np.max(np.abs(step))), 1e-12))
        return None

    def solve(self, goal: pin.SE3, near: Array, *, condition: float = MIN_CONDITION) -> list[Posture]:
        """All postures that are found for a pose of the tool, the closest to `near` first.

        Joints that may turn more than once are turned as close to `near` as their limits allow.
        """
        found: list[Posture] = []
        for start in self._starts(goal, near):
            q = self.solve_from(goal, start)
            if q is None:
                continue
            q = self.unwound(q, near)
            if q is None or any(np.max(np.abs(q - solution.positions)) < 1e-3 for solution in found):
                continue
            value = self.condition(q)
            if value >= condition:
                found.append(Posture(q, value))
        found.sort(key=lambda solution: self.distance(solution.positions, near))
        return found

    def distance(self, a: Array, b: Array) -> float:
        """The time of a motion at full speed, in seconds: what the slowest joint needs."""
        return float(np.max(np.abs(a - b) / self.speeds))

    def unwound(self, positions: Array, near: Array) -> Array | None:
        """The same posture with each joint turned by whole turns towards `near`, within limits; None without one."""
        turns = np.round((near - positions) / math.tau)
        q = positions + turns * math.tau
        q = np.where(q > self.upper, q - math.tau, np.where(q < self.lower, q + math.tau, q))
        return None if np.any(q > self.upper) or np.any(q < self.lower) else q

    def _find_published(self) -> URFrames | None:
        """The published arm whose kinematics this is, up to the frames of base and tool."""
        rng = np.random.default_rng(1)
        samples = [rng.uniform(-2.0, 2.0, self.model.nq) for _ in range(4)]
        if self.model.nq != 6:
            return None
        for angle in (0.0, math.pi):
            base = self.model.jointPlacements[1] * shifted(z=-UR10.d1) * turned("z", angle)
            tools = [(base * forward(UR10, q)).actInv(self.forward(q)) for q in samples]
            if all(max(offset_between(tool, tools[0])) < FRAME_TOLERANCE for tool in tools):
                return URFrames(UR10, base, tools[0])
        return None

    def _starts(self, goal: pin.SE3, near: Array) -> Iterable[Array]:
        if self._published is not None:
            yield from self._published.starts(goal)
            return
        yield near
        x, y, _ = goal.translation
        bearing = math.atan2(y - float(self.model.jointPlacements[1].translation[1]), x)
        for back, elbow, wrist in _BRANCHES:
            for lift in (-0.9, -1.7):
                start = np.array([bearing + back, lift, 1.6 * elbow, -1.2 * elbow, 1.5 * wrist, 0.0])
                yield start
                yield start + np.array([math.pi, 0, 0, 0, 0, 0])
