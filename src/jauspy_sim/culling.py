"""Hides the shapes that a camera, a lamp or the sun cannot see. MuJoCo's renderer sends all shapes to GL.

Without a GPU the corners of what is outside of a picture take as long as those inside. Of the 60,000 triangles of
inc1, its own cameras see a third.
"""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

Vectors = NDArray[np.float64]

HIDDEN: Final = 5
"""A group of shapes that is not drawn."""
SMALLEST: Final = 0.012
"""Metres: the radius below which a shape casts no shadow that shows."""
FLAT: Final = 0.03
"""Metres: a fixed shape of at most this height, at most `LOW` above the ground, counts as ground."""
LOW: Final = 0.15


class Culling:
    """Visibility of a model's shapes, by their bounding spheres."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._groups = model.geom_group.copy()
        self._middles = model.geom_aabb[:, :3].copy()
        self._radii = np.linalg.norm(model.geom_aabb[:, 3:], axis=1)
        is_plane = model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
        self._radii[is_plane] = math.inf
        alpha = model.geom_rgba[:, 3].copy()
        has_material = model.geom_matid >= 0
        if has_material.any():
            alpha[has_material] = np.minimum(alpha, model.mat_rgba[model.geom_matid, 3])[has_material]
        self._casts = (alpha >= 1.0) & (self._radii > SMALLEST) & ~_grounds(model)

    def hide_unseen(
        self,
        data: mujoco.MjData,
        position: Vectors,
        rotation: Vectors,
        half: tuple[float, float],
        *,
        parallel: bool = False,
    ) -> None:
        """Hide shapes that are outside of a picture; `show_all` shows them again.

        `rotation` has the columns ahead, left, up; `half` are half of the picture's width and height at a distance of
        one, or in a `parallel` projection anywhere.
        """
        turned = (data.geom_xmat.reshape(-1, 3, 3) @ self._middles[:, :, None])[:, :, 0]
        away = (data.geom_xpos + turned - position) @ rotation
        ahead, sides = away[:, 0], np.abs(away[:, 1:])
        radii = self._radii
        if parallel:
            seen = (sides <= np.array(half) + radii[:, None]).all(axis=1)
        else:
            width = np.array(half)
            slant = np.hypot(1.0, width)
            seen = (sides <= width * ahead[:, None] + slant * radii[:, None]).all(axis=1)
        self._model.geom_group[:] = np.where(seen & (ahead > -radii), self._groups, HIDDEN)

    def hide_shadowless(self) -> None:
        """Hide also shapes that cast no shadow."""
        self._model.geom_group[~self._casts] = HIDDEN

    def show_all(self) -> None:
        """Undo `hide_unseen`."""
        self._model.geom_group[:] = self._groups


def _grounds(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """The shapes with nothing below them, so that their shadow falls on nothing."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    down = data.geom_xmat.reshape(-1, 3, 3)[:, 2]
    half = (np.abs(down) * model.geom_aabb[:, 3:]).sum(axis=1)
    top = data.geom_xpos[:, 2] + (down * model.geom_aabb[:, :3]).sum(axis=1) + half
    rests = model.body_weldid[model.geom_bodyid] == 0
    is_plane = model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
    return np.asarray(is_plane | (rests & (2.0 * half <= FLAT) & (top <= LOW)))
