"""Lidars of several layers, which cast rays through MuJoCo's world.

A scan of many thousands of rays would stop the robot's thread for up to 30 ms. It is cast in parts, between the steps
of physics, from where the lidar was when the scan began: so that points are not distorted by the robot's motion.
"""

from __future__ import annotations

import math
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.ranging import LidarSetup, RangeScan, Scanner, ScanSettings, nearest_layer
from jauspy_sim.sensors import cast_rays

RAYS_AT_ONCE: Final = 512
"""Rays of one part: 0.2 to 1 ms on a small machine."""


class LayeredLidar(Scanner):
    """A `RangeFinder`, with normally distributed errors."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, body: Any, setup: LidarSetup) -> None:
        super().__init__(setup)
        self._model, self._data, self._body = model, data, body
        self._random = np.random.default_rng(setup.seed)
        self._inclinations = setup.inclinations()
        self._directions = self._unit_vectors()
        self._pending: _Pending | None = None

    def configure(self, settings: ScanSettings) -> None:
        """As `Scanner.configure`; what is not complete is discarded."""
        super().configure(settings)
        self._pending = None
        self._directions = self._unit_vectors()

    def step(self, now: float) -> None:
        """Cast the next part of the scan, and begin one that is due."""
        if self._pending is not None:
            self._cast(RAYS_AT_ONCE)
        super().step(now)

    def _begin(self, now: float) -> None:
        if self._pending is not None:
            self._cast(len(self._directions))
        mujoco.mj_kinematics(self._model, self._data)  # after a step, frames are those of its start
        rays = self._directions @ self._body.xmat.reshape(3, 3).T
        self._pending = _Pending(now, self._body.xpos.copy(), rays)
        self._cast(len(rays) if self._scan is None else RAYS_AT_ONCE)

    def _cast(self, count: int) -> None:
        pending = self._pending
        if pending is None:
            return
        rays = pending.rays[pending.done : pending.done + count]
        if len(rays):
            found = cast_rays(self._model, self._data, pending.start, rays)
            pending.distances[pending.done : pending.done + count] = found
        pending.done += count
        if pending.done >= len(pending.rays):
            self._pending = None
            self._scan = self._completed(pending)

    def _completed(self, pending: _Pending) -> RangeScan:
        settings, setup = self._settings, self._setup
        distances = pending.distances + self._random.normal(0.0, setup.noise, len(pending.distances))
        distances[distances < settings.min_range] = -math.inf
        distances[distances > settings.max_range] = math.inf
        image = distances.astype(np.float32).reshape(len(self._inclinations), -1)
        row = tuple(image[nearest_layer(self._inclinations)].tolist())
        return RangeScan(pending.time, setup.link, self._angles, row, self._inclinations, image.tobytes())

    def _unit_vectors(self) -> NDArray[np.float64]:
        """Shape (layers * angles, 3): in the link's frame, layer by layer."""
        up, at = np.meshgrid(np.array(self._inclinations), np.array(self._angles), indexing="ij")
        rays = np.stack([np.cos(up) * np.cos(at), np.cos(up) * np.sin(at), np.sin(up)], axis=-1)
        return np.ascontiguousarray(rays.reshape(-1, 3))


class _Pending:
    """A scan that is being cast."""

    def __init__(self, time: float, start: NDArray[np.float64], rays: NDArray[np.float64]) -> None:
        self.time, self.start, self.rays = time, start, rays
        self.distances = np.full(len(rays), math.inf)
        self.done = 0
