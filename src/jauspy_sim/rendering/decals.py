"""Places a robot's contact shadow and the marks of its tracks on the ground, in the processes of cameras.

Physics has neither: the shapes are in the model that is drawn (`jauspy_sim.models.decals`), and each camera remembers
the marks of the time in which it looked.
"""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np

from jauspy_sim.models.decals import MARK, MARK_LENGTH, MARKS, SHADOW, Floats, Footprint, opacities
from jauspy_sim.physics.sensors import cast_rays

STILL: Final = 1e-4
"""Metres or sines by which a robot must have moved until the ground below it is measured again."""
HEIGHT: Final = 0.2
"""Metres above the base from which the ground is measured."""
UNEVEN: Final = 0.06
"""Metres from the plane through the ground below, at which the shadow has vanished."""
RAISED: Final = 0.2
"""Metres from the ground at which a robot's contact shadow has vanished."""
MARK_LAYER: Final = 0.0042
"""Metres above the ground, above the paint on it."""
SHADOW_LAYER: Final = 0.0062
LAYERS: Final = 1e-5
"""Metres between marks, which lie over each other."""

ROLLED: Final = 0.06
"""Opacity of a mark where a track has rolled."""
SCUFFED: Final = 0.13
"""Where it has slid sideways."""
STRAIGHT: Final = 0.3
"""Sine of the angle between a track and the way of its end, below which the leading end leaves no marks."""
PATCHY: Final = (0.5, 1.4)
"""Factors of the opacity, by chance: no ground is alike everywhere."""
FADING: Final = 8
"""The oldest marks, which fade."""
GAP: Final = 0.8
"""Metres between two pictures from which on no marks are between them."""


class Decals:
    """The shadow and the marks of one robot."""

    def __init__(self, model: mujoco.MjModel, base: int, footprint: Footprint, *, marks: bool = True) -> None:
        """`base` is the body of the robot's base. The model has the shapes of `add_decals`.

        Without `marks` tracks leave none: a camera on the robot hardly sees them, and they take time.
        """
        self._model, self._base = model, base
        self._opacities = np.array(opacities())
        ring = model.geom(f"{SHADOW} 0").id
        self._shadow = slice(ring, ring + len(self._opacities))
        first = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, f"{MARK} 0") if marks else -1
        back, front, right, left = footprint.body
        ends = [(x, y) for x in (back, front) for y in (right, left)]
        self._corners = np.array([*((x, y, 0.0) for x, y in ends), ((back + front) / 2, (right + left) / 2, 0.0)])
        self._marks = None if first < 0 else _Marks(model, first, footprint)
        self._pose = np.full(12, math.inf)
        self._frame, self._place = np.eye(3), np.zeros(3)

    def place(self, data: mujoco.MjData) -> None:
        """Place the shapes below the robot's present pose, which `mj_kinematics` has computed."""
        position, axes = data.xpos[self._base], data.xmat[self._base].reshape(3, 3)
        pose = np.concatenate([position, axes.ravel()])
        if np.abs(pose - self._pose).max() > STILL:
            self._pose = pose
            self._follow(data, position, axes)
        _put(self._model, data, self._shadow, self._place, self._frame)
        if self._marks is not None:
            self._marks.place(data)

    def _follow(self, data: mujoco.MjData, position: Floats, axes: Floats) -> None:
        ground = self._ground(data, position, axes)
        if ground is None:
            self._model.geom_rgba[self._shadow, 3] = 0.0
            return
        normal, point, strength = ground
        self._model.geom_rgba[self._shadow, 3] = strength * self._opacities
        self._frame = _frame(axes[:, 0], normal)
        self._place = position - ((position - point) @ normal - SHADOW_LAYER) * normal
        if self._marks is not None:
            self._marks.add(position, axes, normal, point, strength)

    def _ground(self, data: mujoco.MjData, position: Floats, axes: Floats) -> tuple[Floats, Floats, float] | None:
        """Normal and a point of the plane below the robot, and how well the robot stands on it, 0 to 1; or None."""
        if axes[2, 2] < 0.3:
            return None
        start = position + HEIGHT * axes[:, 2]
        rays = self._corners @ axes.T - HEIGHT * axes[:, 2]
        lengths = np.linalg.norm(rays, axis=1)
        found = cast_rays(self._model, data, start, rays / lengths[:, None]) / lengths
        if not np.isfinite(found).all() or found.max() > 4.0:
            return None
        points = start + rays * found[:, None]
        middle = points.mean(axis=0)
        normal = np.linalg.svd(points - middle)[2][2]
        normal *= np.sign(normal[2]) or 1.0
        uneven = float(np.abs((points - middle) @ normal).max())
        above = float(np.clip((position + self._corners @ axes.T - middle) @ normal, 0.0, None).mean())
        return normal, middle, max(0.0, 1.0 - uneven / UNEVEN) * max(0.0, 1.0 - above / RAISED)


class _Marks:
    """The marks of the front and the rear end of each track, the oldest of which are used again."""

    def __init__(self, model: mujoco.MjModel, first: int, footprint: Footprint) -> None:
        ends = [(x, (foot.right + foot.left) / 2) for foot in footprint.feet for x in (foot.back, foot.front)]
        self._model, self._first, self._count = model, first, MARKS * len(ends)
        middle = (footprint.feet[0].back + footprint.feet[0].front) / 2
        self._leads = np.array([np.copysign(1.0, x - middle) for x, _ in ends])
        """1.0 for a front end, -1.0 for a rear one."""
        self._ends = np.array([(x, y, 0.0) for x, y in ends])
        self._last: Floats | None = None
        self._places = np.zeros((MARKS, len(ends), 3))
        self._axes = np.tile(np.eye(3).ravel(), (MARKS, len(ends), 1))
        self._opacity = np.zeros((MARKS, len(ends)))
        self._turns = np.zeros(len(ends), np.int64)
        self._patches = np.random.default_rng(1).uniform(*PATCHY, (MARKS, len(ends)))

    def add(self, position: Floats, axes: Floats, normal: Floats, point: Floats, strength: float) -> None:
        """Add the marks from the last pose to this one."""
        ends = position + self._ends @ axes.T
        ends -= ((ends - point) @ normal)[:, None] * normal
        if self._last is None:
            self._last = ends
        for number, end in enumerate(ends):
            way = end - self._last[number]
            far = float(np.linalg.norm(way))
            if far > GAP or strength < 0.5:
                self._last[number] = end
                continue
            count = int(far / MARK_LENGTH)
            if not count:
                continue
            frame = _frame(way, normal)
            sideways, ahead = abs(float(frame[:, 0] @ axes[:, 1])), float(frame[:, 0] @ axes[:, 0])
            if sideways < STRAIGHT and ahead * self._leads[number] > 0.0:
                self._last[number] = end
                continue
            opacity = ROLLED + (SCUFFED - ROLLED) * sideways
            for _ in range(count):
                slot = self._turns[number] % MARKS
                lift = MARK_LAYER + LAYERS * (slot * len(ends) + number)
                self._places[slot, number] = self._last[number] + 0.5 * MARK_LENGTH * frame[:, 0] + lift * normal
                self._axes[slot, number] = frame.ravel()
                self._opacity[slot, number] = opacity * self._patches[slot, number]
                self._turns[number] += 1
                self._last[number] = self._last[number] + MARK_LENGTH * frame[:, 0]

    def place(self, data: mujoco.MjData) -> None:
        """Place all marks."""
        shown = slice(self._first, self._first + self._count)
        age = (self._turns - 1 - np.arange(MARKS)[:, None]) % MARKS
        fresh = np.clip((MARKS - age) / FADING, 0.0, 1.0)
        self._model.geom_rgba[shown, 3] = (self._opacity * fresh).ravel()
        _put(self._model, data, shown, self._places.reshape(-1, 3), self._axes.reshape(-1, 3, 3))


def _frame(ahead: Floats, normal: Floats) -> Floats:
    """The frame whose z axis is the normal, and whose x axis is ahead along the plane; its columns are the axes."""
    x = ahead - (ahead @ normal) * normal
    x = x / (np.linalg.norm(x) or 1.0)
    return np.stack([x, np.cross(normal, x), normal], axis=1)


def _put(model: mujoco.MjModel, data: mujoco.MjData, geoms: slice, positions: Floats, frames: Floats) -> None:
    """Place meshes, whose own frames MuJoCo has turned to their axes of inertia."""
    data.geom_xpos[geoms] = positions + (frames @ model.geom_pos[geoms][:, :, None])[:, :, 0]
    own_frames = np.empty((geoms.stop - geoms.start, 9))
    for row, quaternion in zip(own_frames, model.geom_quat[geoms], strict=True):
        mujoco.mju_quat2Mat(row, quaternion)
    data.geom_xmat[geoms] = (frames @ own_frames.reshape(-1, 3, 3)).reshape(-1, 9)
