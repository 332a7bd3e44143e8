"""A camera without GL: a ray for every pixel, by MuJoCo, with the sky, lights and colours that GL would take."""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.assembly import FELT, SEEN
from jauspy_sim.shading import Shading
from jauspy_sim.sky import Sky

PIXELS: Final = 160 * 120
"""Rays of one picture, at most: 11 ms on a small machine."""

THOROUGH: Final = 480 * 360
"""The same for one that may take half a second."""

FAR: Final = 40.0
"""Metres beyond which nothing is seen."""

_SEEN: Final = np.array([group in (0, SEEN, FELT) for group in range(mujoco.mjNGROUP)], np.uint8)
_HAS_NORMALS: Final = "normal" in (mujoco.mj_multiRay.__doc__ or "")  # since MuJoCo 3.5


class RayPainter:
    """Paints what a camera of the model sees; it is told the horizontal field of view in radians."""

    description: Final = (
        "no GL here (libegl1 or libosmesa6, and MUJOCO_GL not set otherwise): casts rays, at a reduced size"
    )

    def __init__(self, model: mujoco.MjModel, camera: int, fov: float) -> None:
        self._model, self._camera = model, camera
        self._spread = math.tan(fov / 2.0)
        self._sky, self._shading = Sky(model), Shading(model)

    def paint(self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False) -> NDArray[np.uint8]:
        """A picture of that size, made of fewer and larger dots; of more when there is time."""
        columns, rows = _affordable(width, height, THOROUGH if thoroughly else PIXELS)
        dots, _ = self._cast(data, self._rays(columns, rows), self._dot(columns))
        dots = dots.reshape(rows, columns, 3)
        down = np.arange(height) * rows // height
        across = np.arange(width) * columns // width
        return np.ascontiguousarray(dots[down][:, across])

    def measure(self, data: mujoco.MjData, width: int, height: int) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """The dots, and how far each is along the camera's axis."""
        columns, rows = _affordable(width, height, PIXELS)
        rays = self._rays(columns, rows)
        dots, far = self._cast(data, rays, self._dot(columns))
        along = (far * -rays[:, 2]).astype(np.float32)
        return dots.reshape(rows, columns, 3), along.reshape(rows, columns)

    def close(self) -> None:
        """Nothing to give back."""

    def _rays(self, columns: int, rows: int) -> NDArray[np.float64]:
        """Directions through the middles of pixels in the camera's frame, which looks along -z with y up."""
        dot = self._dot(columns)
        x, y = np.meshgrid(
            dot * (np.arange(columns) - (columns - 1) / 2.0), -dot * (np.arange(rows) - (rows - 1) / 2.0)
        )
        rays = np.stack((x, y, -np.ones_like(x)), axis=-1).reshape(-1, 3)
        units: NDArray[np.float64] = rays / np.linalg.norm(rays, axis=1, keepdims=True)
        return units

    def _dot(self, columns: int) -> float:
        """How wide a dot is at a distance of one."""
        return 2.0 * self._spread / columns

    def _cast(
        self, data: mujoco.MjData, rays: NDArray[np.float64], dot: float
    ) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
        """What the rays hit: colours and distances."""
        directions = rays @ data.cam_xmat[self._camera].reshape(3, 3).T
        count = len(directions)
        hit, far = np.empty(count, np.int32), np.empty(count)
        normals = np.tile(-directions, 1)
        mujoco.mj_multiRay(
            self._model,
            data,
            pnt=data.cam_xpos[self._camera],
            vec=directions.ravel(),
            geomgroup=_SEEN,
            flg_static=True,
            bodyexclude=-1,
            geomid=hit,
            dist=far,
            nray=count,
            cutoff=FAR,
            **({"normal": normals.reshape(-1)} if _HAS_NORMALS else {}),
        )
        painted = self._sky.colours(directions)
        seen = hit >= 0
        points = data.cam_xpos[self._camera] + directions[seen] * far[seen, None]
        facing = np.clip(-np.sum(directions[seen] * normals[seen], axis=1), 1e-6, 1.0)
        light = self._shading.light(data, facing, normals[seen])
        painted[seen] = self._shading.colours(data, hit[seen], points, dot * far[seen] / facing) * light
        return np.clip(painted, 0.0, 255.0).astype(np.uint8), np.where(seen, far, math.inf)


def _affordable(width: int, height: int, most: int) -> tuple[int, int]:
    """Columns and rows of a picture of that shape, in rays."""
    shrink = max(1.0, math.sqrt(width * height / most))
    return round(width / shrink), round(height / shrink)
