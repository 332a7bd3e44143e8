"""The shadows of the sun, computed for the pixels of a picture from their depths.

MuJoCo's own shadows triple the time of a picture without a GPU: it draws everything once more for each light that casts
them. Here one depth picture of the vicinity is drawn from the sun.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import cv2
import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.rendering.lamps import Floats, Surface, axes_along

if TYPE_CHECKING:
    from jauspy_sim.rendering.renderer import Renderer

RADIUS: Final = 4.5
"""Metres around a point before the camera in which things cast shadows."""
AHEAD: Final = 2.8
"""Metres from the camera to that point."""
SIZE: Final = 512
"""Side of the shadow map, in pixels; smaller in smaller pictures."""
AWAY: Final = 20.0
"""Metres from that point to the sun's camera."""
BIAS: Final = 0.01
"""Metres by which a lit surface may be behind the shadow map."""
STILL: Final = 1e-4
"""Metres of motion below which the shadow map is not redrawn."""
STEEPEST: Final = 6.0
"""Largest factor by which the size of a pixel is added to that where the sun shines flat on a surface."""


class SunShadow:
    """The first directional light of a model that casts shadows, and the light inside the shadows."""

    def __init__(self, model: mujoco.MjModel) -> None:
        is_sun = (model.light_type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL) & (model.light_active != 0)
        suns = np.flatnonzero(is_sun & (model.light_castshadow != 0))
        self._sun = int(suns[0]) if len(suns) else None
        others = np.setdiff1d(np.flatnonzero(is_sun), suns[:1])
        headlight = model.vis.headlight
        self._fill = float(np.mean(headlight.ambient) + 0.5 * np.mean(headlight.diffuse))
        self._fill += float(
            model.light_ambient.mean(axis=1).sum() + 0.5 * model.light_diffuse[others].mean(axis=1).sum()
        )
        self._last: tuple[NDArray[np.float64], Floats] | None = None
        """The last shadow map, and the poses for which it was drawn."""
        self._strength = 0.0 if self._sun is None else float(model.light_diffuse[self._sun].mean())

    @property
    def is_cast(self) -> bool:
        """False in a world without a sun."""
        return self._sun is not None

    def light(
        self,
        data: mujoco.MjData,
        camera: int,
        distances: Floats,
        spread: float,
        *,
        levels: Sequence[float],  # noqa: ARG002 - in daylight, lamps make no difference
        source: Renderer,
        coarse: bool,
    ) -> Floats | float:
        """The light on each pixel as a fraction of that without shadows; parameters as for `Darkness.light`."""
        if self._sun is None:
            return 1.0
        axes = data.cam_xmat[camera].reshape(3, 3)
        direction = data.light_xdir[self._sun]
        rotation = axes_along(direction)
        centre = data.cam_xpos[camera] - AHEAD * axes[:, 2]
        eye = centre - AWAY * direction
        depths = self._seen(data, eye, rotation, source)
        if depths is None:
            return 1.0
        size = distances.shape[::-1]
        surface = Surface(np.ascontiguousarray(distances[::2, ::2]) if coarse else distances, spread)
        to_camera = axes.T * np.array([[1.0], [1.0], [-1.0]])
        turned = (to_camera @ rotation).astype(np.float32)
        ahead, left, up = surface.seen_from((to_camera @ (eye - data.cam_xpos[camera])).astype(np.float32), turned)
        facing = surface.facing(turned[:, 0])
        pixels = depths.shape[0]
        scale, middle = np.float32(pixels / 2.0 / RADIUS), np.float32((pixels - 1) / 2.0)
        found = np.asarray(
            cv2.remap(depths, middle - left * scale, middle - up * scale, cv2.INTER_NEAREST, borderValue=1e4)
        )
        steep = np.minimum(np.float32(1.0) / np.maximum(facing, np.float32(0.05)), np.float32(STEEPEST))
        is_dark = (found + np.float32(BIAS) + np.float32(2.0 * RADIUS / pixels) * steep < ahead).astype(np.float32)
        lost = np.float32(self._strength) * facing
        shaded = np.float32(1.0) - cv2.blur(is_dark, (3, 3)) * (lost / (np.float32(self._fill) + lost))
        # Pixels are the root of light.
        made = np.asarray(shaded * shaded, np.float32)
        return np.asarray(cv2.resize(made, size), np.float32) if coarse else made

    def _seen(
        self, data: mujoco.MjData, at: NDArray[np.float64], rotation: NDArray[np.float64], source: Renderer
    ) -> Floats | None:
        """The depths from the sun; the last ones if nothing has moved since."""
        places = np.concatenate([at, data.geom_xpos.ravel(), data.geom_xmat.ravel()])
        if self._last is not None and np.abs(places - self._last[0]).max() < STILL:
            return self._last[1]
        depths = source.depths_from(data, at, rotation, RADIUS, SIZE, parallel=True)
        self._last = None if depths is None else (places, depths)
        return depths
