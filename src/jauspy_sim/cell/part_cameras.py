"""3D cameras in MuJoCo that see parts: field of view, reach, and what hides the parts, by rays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.platform.modular.parts import PartCamera, PartSolid, PartType, Shape

Array = NDArray[np.float64]

SAMPLES: Final = ((0.0, 0.0, 0.0), (0.35, 0.35, 0.0), (-0.35, -0.35, 0.0), (0.0, 0.35, 0.35), (0.0, -0.35, -0.35))
"""Points in a solid that rays are sent to, in parts of its size from its middle."""

ENOUGH: Final = 0.25
"""Fraction of a part's points that must be seen: less does not suffice to fit the part's model."""


class SoughtPart(NamedTuple):
    """A part that cameras look for."""

    tree: int
    """Its kinematic tree in MuJoCo: a ray that ends on it sees the part."""
    points: tuple[tuple[int, Array], ...]
    """Bodies with the points in their frames, shape (n, 3), m."""


class Sight(NamedTuple):
    """The view of a part by the nearest camera that sees it."""

    camera: PartCamera
    frame: Transform
    """Frame of the camera in the world."""
    distance: float
    """Metres along the direction of view."""


class PartCameras:
    """The cameras of a part sensor."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, setups: Sequence[PartCamera]) -> None:
        self._model, self._data, self._setups = model, data, setups
        self._frames = [Transform.from_pose(setup.pose) for setup in setups]
        self._eyes = np.array([frame.position for frame in self._frames])[:, np.newaxis]
        self._rotations = np.array([frame.rotation for frame in self._frames])
        self._tangents = np.array([np.array(setup.size) / (2.0 * setup.focal) for setup in setups])[:, np.newaxis]
        """Tangents of half the angles of view, horizontal and vertical."""
        self._hit = np.full(1, -1, np.int32)

    def target(self, name: str, kind: PartType) -> SoughtPart:
        """What to look for."""
        body = int(self._model.body(name).id)
        points = [(body, _points(kind.solids))]
        if kind.servo is not None and kind.servo.output:
            points.append((int(self._model.body(f"{name}.output").id), _points(kind.servo.output)))
        return SoughtPart(int(self._model.body_treeid[body]), tuple(points))

    def sight(self, target: SoughtPart) -> Sight | None:
        """The view of a part; None if no camera sees enough of it."""
        data = self._data
        points = np.concatenate(
            [data.xpos[body] + local @ data.xmat[body].reshape(3, 3).T for body, local in target.points]
        )
        local = (points - self._eyes) @ self._rotations
        depths = local[:, :, 0]
        distances = depths.mean(axis=1)
        across = np.abs(local[:, :, 1:]) <= depths[:, :, np.newaxis] * self._tangents
        inside = across.all(axis=2) & (depths > 0.0)
        needed = ENOUGH * len(points)
        for number in np.argsort(distances).tolist():
            setup, distance = self._setups[number], float(distances[number])
            if 0.0 < distance <= setup.reach:
                eye = self._eyes[number, 0]
                if self._sees(target.tree, eye, points[inside[number]], needed):
                    return Sight(setup, self._frames[number], distance)
        return None

    def _sees(self, tree: int, eye: Array, points: Array, needed: float) -> bool:
        """True if rays from a camera end on a part at so many of these points."""
        seen = 0
        for left, point in zip(range(len(points), 0, -1), points, strict=True):
            if seen + left < needed:
                return False
            mujoco.mj_ray(self._model, self._data, eye, point - eye, None, 1, -1, self._hit)
            geom = int(self._hit[0])
            if geom >= 0 and self._model.body_treeid[self._model.geom_bodyid[geom]] == tree:
                seen += 1
                if seen >= needed:
                    return True
        return False


def _points(solids: Sequence[PartSolid]) -> Array:
    rows = []
    for solid in solids:
        x, y, z = solid.size
        widths = (2.0 * x, 2.0 * y, z) if solid.shape is Shape.CYLINDER else (x, y, z)
        for a, b, c in SAMPLES:
            rows.append(solid.pose.apply((a * widths[0], b * widths[1], c * widths[2])))
    return np.array(rows)
