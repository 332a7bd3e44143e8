"""A depth camera of a robot by rays, with noise: without GL, and on virtual time, which the camera's process lacks."""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.physics.sensors import NO_NORMALS, RAY_GROUPS

FIELD: Final = math.radians(80.0)
"""Horizontal field of view, radians."""
SIZE: Final = (100, 64)
"""Rays across and down."""
NEAR, FAR = 0.2, 6.0
"""Metres between which it measures."""
NOISE: Final = 0.005
"""Standard deviation of a distance, metres."""


class DepthRays:
    """The camera at a link, x forward. Equal seeds give equal noise."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str, link: str, seed: int) -> None:
        self._model, self._data = model, data
        self._rng = np.random.default_rng(seed)
        self._body = model.body(f"{name_prefix}{link}").id
        self._own = np.array([model.body(body).name.startswith(name_prefix) for body in model.geom_bodyid.tolist()])
        wide = math.tan(FIELD / 2.0)
        across, down = (np.linspace(-1.0, 1.0, count) for count in SIZE)
        y, z = np.meshgrid(wide * across, wide * down * SIZE[1] / SIZE[0])
        rays = np.stack([np.ones_like(y), y, z], axis=-1).reshape(-1, 3)
        self._rays = rays / np.linalg.norm(rays, axis=1)[:, None]

    def look(self) -> NDArray[np.float32]:
        """Points in the frame of the link, metres, shape (n, 3), in single precision."""
        model, data, count = self._model, self._data, len(self._rays)
        rotation, place = data.xmat[self._body].reshape(3, 3), data.xpos[self._body].copy()
        hit, far = np.zeros(count, np.int32), np.zeros(count)
        rays = np.ascontiguousarray(self._rays @ rotation.T)
        mujoco.mj_multiRay(
            m=model,
            d=data,
            pnt=place,
            vec=rays.ravel(),
            geomgroup=RAY_GROUPS,
            flg_static=True,
            bodyexclude=self._body,
            geomid=hit,
            dist=far,
            nray=count,
            cutoff=FAR,
            **NO_NORMALS,
        )
        seen = (hit >= 0) & (far > NEAR) & (far < FAR) & ~self._own[np.maximum(hit, 0)]
        noisy = far[seen] + self._rng.normal(0.0, NOISE, int(seen.sum()))
        return np.asarray(self._rays[seen] * noisy[:, None], np.float32)
