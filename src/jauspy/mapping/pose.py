"""Poses on a plane."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Points: TypeAlias = NDArray[np.float64]
"""Rows of x, y in metres."""


class PlanarPose(NamedTuple):
    """Where something is on a plane: metres, and radians counterclockwise from x."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0

    def apply(self, points: Points) -> Points:
        """Points of this frame, in the outer one."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        moved: Points = points @ np.array([[c, s], [-s, c]]) + (self.x, self.y)
        return moved

    def then(self, inner: PlanarPose) -> PlanarPose:
        """A pose of this frame, in the outer one."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        yaw = math.remainder(self.yaw + inner.yaw, math.tau)
        return PlanarPose(self.x + c * inner.x - s * inner.y, self.y + s * inner.x + c * inner.y, yaw)

    def inverse(self) -> PlanarPose:
        """The outer frame, in this one."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(-c * self.x - s * self.y, s * self.x - c * self.y, -self.yaw)

    def since(self, before: PlanarPose) -> PlanarPose:
        """How it got here from `before`, as seen from there."""
        return before.inverse().then(self)
