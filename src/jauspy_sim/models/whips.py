"""Antennas that swing, in every picture of the robot.

The physics has no joints for them. A visual shape swings about the origin of its element in the URDF, where it stands
along z, if the element has these attributes (other programs ignore them):

- `whip_frequency`, in Hz, of its natural oscillation;
- `whip_length`, in metres, from there to its end.

The end is a mass on a damped spring to where it is at rest. Between two pictures the velocity of that point is taken
as constant; the oscillation is then exact.
"""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Element, numbers, origin, place

DAMPING: Final = 0.1
"""Fraction of the critical damping: the amplitude halves with each oscillation."""
MAX_SWING: Final = 0.3
"""Greatest way of the end from its place at rest, as a fraction of the length."""
MAX_PAUSE: Final = 0.5
"""Seconds without a picture after which an antenna is at rest."""
WHIP: Final = -1.0
"""First number of the user data of a shape that swings; that of one that moves with belts is positive."""

Floats = NDArray[np.float64]


def mark_whip(geom: mujoco.MjsGeom, visual: Element) -> None:
    """Mark the shape of a visual element to swing, if it has the attributes.

    Raises `ConfigError` for invalid values.
    """
    if visual.get("whip_frequency") is None and visual.get("whip_length") is None:
        return
    frequency, length = (numbers(visual, f"whip_{key}", 1, "0")[0] for key in ("frequency", "length"))
    if not (0.1 <= frequency <= 20.0 and 0.01 <= length <= 10.0):
        raise ConfigError(f"{place(visual)}: whip_frequency and whip_length: must be 0.1..20 Hz and 0.01..10 m")
    foot = Transform.from_pose(origin(visual))
    up = foot.rotate((0.0, 0.0, 1.0))
    geom.userdata = [WHIP, frequency, *foot.position, *(length * coordinate for coordinate in up)]


class Whips:
    """The shapes of a model that were marked."""

    def __init__(self, model: mujoco.MjModel) -> None:
        user = model.geom_user
        self._geoms = np.flatnonzero(user[:, 0] == WHIP) if user.shape[1] else np.empty(0, np.int64)
        if not self._geoms.size:
            return
        self._bodies = model.geom_bodyid[self._geoms]
        self._rates = 2.0 * math.pi * user[self._geoms, 1][:, None]
        self._feet, self._ways = user[self._geoms, 2:5], user[self._geoms, 5:8]
        self._lengths = np.linalg.norm(self._ways, axis=1)[:, None]
        self._last = -math.inf
        self._ends = self._velocity = self._swing = self._speed = np.zeros_like(self._feet)

    def place(self, data: mujoco.MjData, now: float) -> None:
        """Turn the shapes that `mj_kinematics` has placed; `now` is the time of the picture, in seconds."""
        if not self._geoms.size:
            return
        frames = data.xmat[self._bodies].reshape(-1, 3, 3)
        feet = data.xpos[self._bodies] + _applied(frames, self._feet)
        ways = _applied(frames, self._ways)
        self._oscillate(feet + ways, now)
        turns = _turns(ways, ways + self._across(ways))
        arms = data.geom_xpos[self._geoms] - feet
        data.geom_xpos[self._geoms] = feet + _applied(turns, arms)
        data.geom_xmat[self._geoms] = (turns @ data.geom_xmat[self._geoms].reshape(-1, 3, 3)).reshape(-1, 9)

    def _oscillate(self, ends: Floats, now: float) -> None:
        """Advance the swing, from the place at rest in the world, to `now`."""
        elapsed, before = now - self._last, self._ends
        if elapsed <= 0.0:
            return
        self._last, self._ends = now, ends
        if elapsed > MAX_PAUSE:
            self._velocity = self._swing = self._speed = np.zeros_like(ends)
            return
        velocity = (ends - before) / elapsed
        speed = self._speed + self._velocity - velocity
        self._velocity = velocity
        # x'' = -w^2 x - 2 d w x' has, with v = w sqrt(1 - d^2), the solution
        # x(t) = exp(-d w t) (x cos(v t) + (x' + d w x) / v sin(v t))
        decay, ringing = DAMPING * self._rates, self._rates * math.sqrt(1.0 - DAMPING**2)
        fading, cos, sin = np.exp(-decay * elapsed), np.cos(ringing * elapsed), np.sin(ringing * elapsed)
        slope = (speed + decay * self._swing) / ringing
        swing = fading * (self._swing * cos + slope * sin)
        self._speed = fading * ringing * (slope * cos - self._swing * sin) - decay * swing
        self._swing = swing

    def _across(self, ways: Floats) -> Floats:
        """The part of the swing across the antennas, bounded."""
        units = ways / self._lengths
        swing = self._swing - (self._swing * units).sum(axis=1)[:, None] * units
        far = np.linalg.norm(swing, axis=1)[:, None]
        return np.asarray(swing * np.minimum(1.0, MAX_SWING * self._lengths / np.maximum(far, 1e-9)))


def _applied(rotations: Floats, vectors: Floats) -> Floats:
    """Each vector in the frame of its rotation, shape (n, 3)."""
    return np.asarray((rotations @ vectors[:, :, None])[:, :, 0])


def _turns(first: Floats, second: Floats) -> Floats:
    """The smallest rotations from the directions of the first vectors to those of the second ones, shape (n, 3, 3)."""
    a, b = (side / np.linalg.norm(side, axis=1)[:, None] for side in (first, second))
    x, y, z = np.cross(a, b).T
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    cosine = (a * b).sum(axis=1)[:, None, None]
    return np.asarray(np.eye(3) + cross + cross @ cross / (1.0 + cosine))
