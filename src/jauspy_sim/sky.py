"""The sky of a world without GL: its colours by elevation, read from the world's sky box."""

from __future__ import annotations

from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

PLAIN: Final = (150, 190, 230)
"""Of a world without a sky box."""

UP: Final = 90
"""Degrees; the colours go from -90 to 90."""

_SIDE, _TOP, _BOTTOM = 0, 2, 3
"""Faces of the box, as MuJoCo stacks them: right, left, up, down, front, back."""


class Sky:
    """Skies that look the same in all directions, as gradients do."""

    def __init__(self, model: mujoco.MjModel) -> None:
        boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX)
        elevations = np.radians(np.arange(-UP, UP + 1))
        self._colours = (
            np.array([_colour(_faces(model, int(boxes[0])), elevation) for elevation in elevations])
            if len(boxes)
            else np.tile(np.array(PLAIN, np.float64), (2 * UP + 1, 1))
        )

    def colours(self, directions: NDArray[np.float64]) -> NDArray[np.float64]:
        """What is seen in each direction (unit vectors, z up): red, green, blue, 0..255."""
        degrees = np.degrees(np.arcsin(np.clip(directions[:, 2], -1.0, 1.0)))
        seen: NDArray[np.float64] = self._colours[np.rint(degrees).astype(np.int64) + UP]
        return seen


def _faces(model: mujoco.MjModel, texture: int) -> NDArray[np.uint8]:
    """The faces of the box, each as rows of pixels, outermost first; one that has a single face has it six times."""
    size, begin = int(model.tex_width[texture]), int(model.tex_adr[texture])
    channels, rows = int(model.tex_nchannel[texture]), int(model.tex_height[texture])
    pixels = model.tex_data[begin : begin + size * rows * channels].reshape(-1, size, size, channels)
    return np.resize(pixels[..., :3], (6, size, size, 3))


def _colour(faces: NDArray[np.uint8], elevation: float) -> NDArray[np.float64]:
    """In the middle of a side, or from the middle of the top or the bottom outwards."""
    last = faces.shape[1] - 1
    if abs(elevation) <= np.pi / 4.0:
        row = round((1.0 - np.tan(elevation)) / 2.0 * last)
        return np.array(faces[_SIDE, row, last // 2], np.float64)
    row = round((1.0 + 1.0 / np.tan(abs(elevation))) / 2.0 * last)
    return np.array(faces[_TOP if elevation > 0.0 else _BOTTOM, row, last // 2], np.float64)
