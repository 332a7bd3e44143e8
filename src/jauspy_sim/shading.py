"""How bright and of what colour things are without GL, by the lights and materials that GL would take."""

from __future__ import annotations

from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

PERIOD: Final = 2.0
"""Metres after which a pattern repeats on a floor, when its material says once for each unit."""


class Shading:
    """Of a model's shapes. Lights are directional ones and the camera's own; nothing casts a shadow."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._plain = 255.0 * np.array([_plain(model, geom) for geom in range(model.ngeom)])
        self._patterns = {
            int(geom): pattern
            for geom in np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE)
            if (pattern := _pattern(model, int(geom))) is not None
        }

    def colours(
        self, data: mujoco.MjData, hit: NDArray[np.int32], points: NDArray[np.float64], widths: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Of the shapes that were hit, at these points of the world; dots that are too wide for a pattern blur it."""
        colours: NDArray[np.float64] = self._plain[hit]
        for geom, pattern in self._patterns.items():
            on = hit == geom
            local = (points[on] - data.geom_xpos[geom]) @ data.geom_xmat[geom].reshape(3, 3)
            size = np.array(pattern.shape[:2])
            at = np.floor(local[:, 1::-1] / [-PERIOD, PERIOD] % 1.0 * size).astype(np.int64) % size
            blur = np.clip(2.0 * widths[on] / PERIOD, 0.0, 1.0)[:, None]
            colours[on] *= (1.0 - blur) * pattern[at[:, 0], at[:, 1]] + blur * pattern.mean(axis=(0, 1))
        return colours

    def light(
        self, data: mujoco.MjData, facing: NDArray[np.float64], normals: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """What falls on surfaces with these normals, which face the camera so much (0..1): red, green, blue."""
        model, own = self._model, self._model.vis.headlight
        light = np.asarray(own.ambient) + facing[:, None] * np.asarray(own.diffuse)
        for number in np.flatnonzero(model.light_type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL):
            sun = np.clip(-(normals @ data.light_xdir[number]), 0.0, 1.0)[:, None]
            light = light + model.light_ambient[number] + sun * model.light_diffuse[number]
        return np.asarray(light)


def _plain(model: mujoco.MjModel, geom: int) -> NDArray[np.float64]:
    """Its colour, 0..1. Patterns are drawn on floors; elsewhere they count with their mean."""
    material = int(model.geom_matid[geom])
    if material < 0:
        return np.array(model.geom_rgba[geom][:3])
    pattern = _pattern(model, geom)
    is_floor = model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE
    mean = 1.0 if pattern is None or is_floor else pattern.mean(axis=(0, 1))
    return np.array(model.mat_rgba[material][:3]) * mean


def _pattern(model: mujoco.MjModel, geom: int) -> NDArray[np.float64] | None:
    """The texture of its material as rows of pixels, 0..1."""
    material = int(model.geom_matid[geom])
    textures = [int(each) for each in np.ravel(model.mat_texid[material]) if each >= 0] if material >= 0 else []
    if not textures:
        return None
    rows, columns = int(model.tex_height[textures[0]]), int(model.tex_width[textures[0]])
    channels, begin = int(model.tex_nchannel[textures[0]]), int(model.tex_adr[textures[0]])
    pixels = model.tex_data[begin : begin + rows * columns * channels].reshape(rows, columns, channels)
    return np.array(pixels[..., :3], np.float64) / 255.0
