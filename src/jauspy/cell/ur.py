"""Closed-form inverse kinematics of Universal Robots' arms, as starts for the exact solution on a given URDF.

Hawkins, "Analytic Inverse Kinematics for the Universal Robots UR-5/UR-10 Arms", Georgia Tech, 2013.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array


@dataclass(frozen=True, slots=True)
class URParameters:
    """Denavit-Hartenberg parameters as the maker publishes them, in metres."""

    d1: float
    a2: float
    a3: float
    d4: float
    d5: float
    d6: float


UR10: Final = URParameters(0.1273, -0.612, -0.5723, 0.163941, 0.1157, 0.0922)
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
    """Where the maker's frames are in a URDF: of the base in the world, and of the tool on the flange."""

    parameters: URParameters
    base: pin.SE3
    tool: pin.SE3

    def starts(self, goal: pin.SE3) -> list[Array]:
        """Postures that have the tool close to `goal`."""
        return inverse(self.parameters, self.base.actInv(goal) * self.tool.inverse())
