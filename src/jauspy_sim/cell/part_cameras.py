"""3D cameras in MuJoCo that see parts: field of view, reach, and what hides the parts, by rays."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.platform.modular.parts import PartCamera, PartSolid, PartType, Shape
from jauspy_sim.models.groups import COLLISION, SOLID

Array = NDArray[np.float64]

SAMPLES: Final = ((0.0, 0.0, 0.0), (0.35, 0.35, 0.0), (-0.35, -0.35, 0.0), (0.0, 0.35, 0.35), (0.0, -0.35, -0.35))
"""Points in a solid that rays are sent to, in parts of its size from its middle."""

ENOUGH: Final = 0.25
"""Fraction of a part's points that must be seen: less does not suffice to fit the part's model."""


HIDING: Final = np.isin(np.arange(mujoco.mjNGROUP), (0, COLLISION, SOLID)).astype(np.uint8)
"""Groups of shapes that hide parts: those that collide. Meshes that are only drawn take ten times as long."""


class Sight(NamedTuple):
    """The view of a part by the nearest camera that sees it."""

    camera: PartCamera
    frame: Transform
    """Frame of the camera in the world."""
    distance: float
    """Metres along the direction of view."""


class PartCameras:
    """The cameras of a part sensor, and the parts that they look for."""

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        setups: Sequence[PartCamera],
        parts: Sequence[tuple[str, PartType]],
    ) -> None:
        """Look for parts of a model, by name with their types."""
        self._model, self._data, self._setups = model, data, setups
        self._frames = [Transform.from_pose(setup.pose) for setup in setups]
        self._eyes = np.array([frame.position for frame in self._frames]).reshape(-1, 1, 3)
        self._rotations = np.array([frame.rotation for frame in self._frames]).reshape(-1, 3, 3)
        self._tangents = np.array([setup.size for setup in setups]).reshape(-1, 1, 2)
        self._tangents /= 2.0 * np.array([setup.focal for setup in setups]).reshape(-1, 1, 1)
        """Tangents of half the angles of view, horizontal and vertical."""
        self._reach = np.array([setup.reach for setup in setups])
        solids = [
            (number, int(model.body(body).id), _points(shapes))
            for number, (name, kind) in enumerate(parts)
            for body, shapes in _bodies(name, kind)
        ]
        self._bodies = np.concatenate([np.full(len(points), body) for _, body, points in solids])
        self._local = np.concatenate([points for _, _, points in solids])
        self._part = np.concatenate([np.full(len(points), number) for number, _, points in solids])
        self._first = np.searchsorted(self._part, np.arange(len(parts)))
        self._count = np.bincount(self._part, minlength=len(parts))
        self._needed = ENOUGH * self._count
        self._trees = model.body_treeid[self._bodies]
        self._trees_of_geoms = model.body_treeid[model.geom_bodyid]

    def sights(self) -> list[Sight | None]:
        """Views of the parts, in their order; None for a part of which no camera sees enough."""
        data = self._data
        points = data.xpos[self._bodies]
        points += np.einsum("nij,nj->ni", data.xmat[self._bodies].reshape(-1, 3, 3), self._local)
        local = (points - self._eyes) @ self._rotations
        depths = local[:, :, 0]
        distances = np.add.reduceat(depths, self._first, axis=1) / self._count
        across = np.abs(local[:, :, 1:]) <= depths[:, :, np.newaxis] * self._tangents
        inside = across.all(axis=2) & (depths > 0.0)
        near = (distances > 0.0) & (distances <= self._reach[:, np.newaxis])
        rays = inside & near[:, self._part]
        seen = np.array([self._count_seen(camera, points, row) for camera, row in enumerate(rays)])
        distances[seen < self._needed] = math.inf
        nearest = distances.argmin(axis=0)
        return [
            Sight(self._setups[camera], self._frames[camera], distance) if distance < math.inf else None
            for camera, distance in zip(nearest.tolist(), distances.min(axis=0).tolist(), strict=True)
        ]

    def _count_seen(self, camera: int, points: Array, inside: NDArray[np.bool_]) -> NDArray[np.int64]:
        """The number of points of each part on which rays from a camera end, of those inside its field of view."""
        rays = np.flatnonzero(inside)
        count = len(rays)
        geoms, distances = np.full(count, -1, np.int32), np.empty(count)
        if count:
            model, eye, most = self._model, self._eyes[camera, 0], mujoco.mjMAXVAL
            directions = (points[rays] - eye).ravel()
            mujoco.mj_multiRay(
                model, self._data, eye, directions, HIDING, True, -1, geoms, distances, None, count, most
            )
        ends = (geoms >= 0) & (self._trees_of_geoms[geoms] == self._trees[rays])
        return np.bincount(self._part[rays[ends]], minlength=len(self._first))


def _bodies(name: str, kind: PartType) -> Iterator[tuple[str, Sequence[PartSolid]]]:
    """Bodies of a part in MuJoCo, with their solids."""
    yield name, kind.solids
    if kind.servo is not None and kind.servo.output:
        yield f"{name}.output", kind.servo.output


def _points(solids: Sequence[PartSolid]) -> Array:
    rows = []
    for solid in solids:
        x, y, z = solid.size
        widths = (2.0 * x, 2.0 * y, z) if solid.shape is Shape.CYLINDER else (x, y, z)
        for a, b, c in SAMPLES:
            rows.append(solid.pose.apply((a * widths[0], b * widths[1], c * widths[2])))
    return np.array(rows)
