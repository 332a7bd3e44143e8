"""Lidars, which cast rays through MuJoCo's world, and its sensors of force and torque at the joint above a link."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector
from jauspy.platform.force_torque import ForceTorqueSetup, SampledForceTorque
from jauspy.platform.ranging import LidarSetup, RangeScan, Scanner, ScanSettings, nearest_layer
from jauspy_sim.assembly import view
from jauspy_sim.models.groups import COLLISION, HEIGHT_FIELDS, SOLID, VISUAL

_IGNORED: Final = (VISUAL, COLLISION, HEIGHT_FIELDS)
RAY_GROUPS: Final = np.array([group not in _IGNORED for group in range(mujoco.mjNGROUP)], np.uint8)
"""Geometry groups that rays hit: all but robots, and height fields, which have ray meshes."""

_NO_SHAPES: Final = np.empty(0, np.int64)

RAYS_AT_ONCE: Final = 512
"""Rays of one part: 0.2 to 1 ms on a small machine."""

ERRORS_AT_ONCE: Final = 100
"""Measurements of force and torque for which errors are drawn at once."""

NO_NORMALS: Final[dict[str, Any]] = {"normal": None} if "normal" in (mujoco.mj_multiRay.__doc__ or "") else {}
"""True if MuJoCo can return normals (version 4)."""


def cast_rays(
    model: mujoco.MjModel, data: mujoco.MjData, start: NDArray[np.float64], rays: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Distances from a point along unit vectors, in metres; inf without a hit."""
    count = len(rays)
    found, distances = np.empty(count, np.int32), np.empty(count)
    mujoco.mj_multiRay(
        m=model,
        d=data,
        pnt=start,
        vec=rays.ravel(),
        geomgroup=RAY_GROUPS,
        flg_static=True,
        bodyexclude=-1,
        geomid=found,
        dist=distances,
        nray=count,
        cutoff=mujoco.mjMAXVAL,
        **NO_NORMALS,
    )
    return np.where(distances < 0.0, math.inf, distances)


def shapes_of(model: mujoco.MjModel, prefixes: Sequence[str]) -> NDArray[np.int64]:
    """The shapes that collide of the robots with these prefixes of names."""
    names = [str(model.body(number).name) for number in range(model.nbody)]
    theirs = np.array([name.startswith(tuple(prefixes)) for name in names], np.bool_)
    return np.flatnonzero(theirs[model.geom_bodyid] & ((model.geom_contype | model.geom_conaffinity) != 0))


class SimulatedLidar(Scanner):
    """A `RangeFinder` of one layer or several, with normally distributed errors.

    A scan of many thousands of rays would stop the robot's thread for up to 30 ms. It is cast in parts, between the
    steps of physics, from where the lidar was when the scan began: so that points are not distorted by the robot's
    motion. A scan of one layer is complete at once.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        body: Any,
        setup: LidarSetup,
        others: NDArray[np.int64] = _NO_SHAPES,
    ) -> None:
        """`others` are shapes of other robots, which it sees though it does not see its own."""
        super().__init__(setup)
        self._others = others
        self._model, self._data, self._body = model, data, body
        self._random = np.random.default_rng(setup.seed)
        self._inclinations = setup.inclinations()
        self._directions = self._unit_vectors()
        self._pending: _Pending | None = None

    def configure(self, settings: ScanSettings) -> None:
        """Same as `Scanner.configure`; an incomplete scan is discarded."""
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
        self._cast(len(rays) if self._scan is None or self._setup.layers == 1 else RAYS_AT_ONCE)

    def _cast(self, count: int) -> None:
        pending = self._pending
        if pending is None:
            return
        rays = pending.rays[pending.done : pending.done + count]
        if len(rays):
            found = self._distances(pending.start, rays)
            pending.distances[pending.done : pending.done + count] = found
        pending.done += count
        if pending.done >= len(pending.rays):
            self._pending = None
            self._scan = self._completed(pending)

    def _distances(self, start: NDArray[np.float64], rays: NDArray[np.float64]) -> NDArray[np.float64]:
        groups, others = self._model.geom_group, self._others
        if not others.size:
            return cast_rays(self._model, self._data, start, rays)
        own = groups[others]
        groups[others] = SOLID
        try:
            return cast_rays(self._model, self._data, start, rays)
        finally:
            groups[others] = own

    def _completed(self, pending: _Pending) -> RangeScan:
        settings, setup = self._settings, self._setup
        distances = pending.distances + self._random.normal(0.0, setup.noise, len(pending.distances))
        distances[distances < settings.min_range] = -math.inf
        distances[distances > settings.max_range] = math.inf
        if setup.layers == 1:
            return RangeScan(pending.time, setup.link, self._angles, tuple(distances.tolist()))
        image = distances.astype(np.float32).reshape(len(self._inclinations), -1)
        row = tuple(image[nearest_layer(self._inclinations)].tolist())
        return RangeScan(
            time=pending.time,
            frame=setup.link,
            angles=self._angles,
            ranges=row,
            inclinations=self._inclinations,
            layers=image.tobytes(),
        )

    def _unit_vectors(self) -> NDArray[np.float64]:
        """Shape (layers * angles, 3): in the link's frame, layer by layer."""
        up, bearing = np.meshgrid(np.array(self._inclinations), np.array(self._angles), indexing="ij")
        rays = np.stack([np.cos(up) * np.cos(bearing), np.cos(up) * np.sin(bearing), np.sin(up)], axis=-1)
        return np.ascontiguousarray(rays.reshape(-1, 3))


class _Pending:
    """A scan that is being cast."""

    def __init__(self, time: float, start: NDArray[np.float64], rays: NDArray[np.float64]) -> None:
        self.time, self.start, self.rays = time, start, rays
        self.distances = np.full(len(rays), math.inf)
        self.done = 0


def simulated_force_torque(data: mujoco.MjData, prefix: str, setup: ForceTorqueSetup) -> SampledForceTorque:
    """The sensor of that robot, with normally distributed errors."""
    force, torque = (view(data.sensor(f"{prefix}{setup.name}_{kind}").data) for kind in ("force", "torque"))
    errors = _errors(setup)

    def measure() -> tuple[Vector, Vector]:
        u, v, w, a, b, c = next(errors)
        (x, y, z), (p, q, r) = force, torque  # the action of the carrier on the link
        return (u - x, v - y, w - z), (a - p, b - q, c - r)

    return SampledForceTorque(setup, measure)


def _errors(setup: ForceTorqueSetup) -> Iterator[list[float]]:
    """Errors of force and torque, for one measurement after the other."""
    random = np.random.default_rng(setup.seed)
    deviations = np.repeat(setup.noise, 3)
    while True:
        yield from (deviations * random.standard_normal((ERRORS_AT_ONCE, 6))).tolist()
