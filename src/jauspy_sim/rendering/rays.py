"""A renderer without GL: it casts rays with MuJoCo, and applies the sky, lights and colours of the model."""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy_sim.models.groups import RAY_MESHES, SOLID, VISUAL

DEFAULT_SKY_COLOUR: Final = (150, 190, 230)
"""Red, green, blue of the sky of a world without a sky box."""

PATTERN_PERIOD: Final = 2.0
"""Metres after which the pattern of a floor repeats, if its material has one repetition per unit."""

MAX_RAYS: Final = 160 * 120
"""Maximal number of rays of one picture: 11 ms on a small machine."""

MAX_RAYS_OF_STILL: Final = 480 * 360
"""Maximal number of rays of a still image, which may take half a second."""

MAX_DISTANCE: Final = 40.0
"""Maximal distance of a hit, in metres."""


_VISIBLE: Final = (0, VISUAL, RAY_MESHES, SOLID)  # rays hit simple shapes where GL draws meshes
_VISIBLE_GROUPS: Final = np.array([group in _VISIBLE for group in range(mujoco.mjNGROUP)], np.uint8)

_GIVES_NORMALS: Final = "normal" in (mujoco.mj_multiRay.__doc__ or "")  # since MuJoCo 3.5


class RayRenderer:
    """Renders images of a camera of the model; `fov` is its horizontal field of view in radians."""

    description: Final = (
        "no GL here (libegl1 or libosmesa6, and MUJOCO_GL not set otherwise): casts rays, at a reduced size"
    )

    def __init__(self, model: mujoco.MjModel, camera: int, fov: float) -> None:
        self._model, self._camera = model, camera
        self._spread = math.tan(fov / 2.0)
        self._sky, self._shading = SkyBox(model), Shading(model)

    simplifications: Final = 0

    def simplify(self, steps: int) -> None:
        """Change nothing: rays are few already."""

    def release(self) -> None:
        """Change nothing: any thread may call."""

    def zoom(self, fov: float) -> None:
        """Take this horizontal field of view, in radians."""
        self._spread = math.tan(fov / 2.0)

    def paint(self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False) -> NDArray[np.uint8]:
        """Return an image of shape (height, width, 3), enlarged from fewer rays; `thoroughly` casts more."""
        columns, rows = _grid_size(width, height, MAX_RAYS_OF_STILL if thoroughly else MAX_RAYS)
        dots, _ = self._cast(data, self._rays(columns, rows), self._dot(columns))
        dots = dots.reshape(rows, columns, 3)
        down = np.arange(height) * rows // height
        column_of = np.arange(width) * columns // width
        return np.ascontiguousarray(dots[down][:, column_of])

    def measure(
        self, data: mujoco.MjData, width: int, height: int, *, thoroughly: bool = False
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Return an image of shape (rows, columns, 3) and the depths along the camera's axis, in metres."""
        columns, rows = _grid_size(width, height, MAX_RAYS_OF_STILL if thoroughly else MAX_RAYS)
        rays = self._rays(columns, rows)
        dots, far = self._cast(data, rays, self._dot(columns))
        depth = (far * -rays[:, 2]).astype(np.float32)
        return dots.reshape(rows, columns, 3), depth.reshape(rows, columns)

    def depths_from(
        self,
        data: mujoco.MjData,  # noqa: ARG002
        position: NDArray[np.float64],  # noqa: ARG002
        rotation: NDArray[np.float64],  # noqa: ARG002
        spread: float,  # noqa: ARG002
        size: int,  # noqa: ARG002
        *,
        parallel: bool = False,  # noqa: ARG002
    ) -> NDArray[np.float32] | None:
        """Return None: lamps cast no shadows here, since rays for them would take as long as those for the picture."""
        return None

    def close(self) -> None:
        """Does nothing: it holds no resources."""

    def _rays(self, columns: int, rows: int) -> NDArray[np.float64]:
        """Return unit vectors through the centres of pixels, shape (rays, 3); the camera looks along -z with y up."""
        dot = self._dot(columns)
        x, y = np.meshgrid(
            dot * (np.arange(columns) - (columns - 1) / 2.0), -dot * (np.arange(rows) - (rows - 1) / 2.0)
        )
        rays = np.stack((x, y, -np.ones_like(x)), axis=-1).reshape(-1, 3)
        units: NDArray[np.float64] = rays / np.linalg.norm(rays, axis=1, keepdims=True)
        return units

    def _dot(self, columns: int) -> float:
        """Return the width of a pixel at a distance of one metre."""
        return 2.0 * self._spread / columns

    def _cast(
        self, data: mujoco.MjData, rays: NDArray[np.float64], dot: float
    ) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
        """Return colours of shape (rays, 3) and distances of shape (rays,), inf without a hit."""
        directions = rays @ data.cam_xmat[self._camera].reshape(3, 3).T
        count = len(directions)
        hit, far = np.empty(count, np.int32), np.empty(count)
        normals = np.tile(-directions, 1)
        mujoco.mj_multiRay(
            self._model,
            data,
            pnt=data.cam_xpos[self._camera],
            vec=directions.ravel(),
            geomgroup=_VISIBLE_GROUPS,
            flg_static=True,
            bodyexclude=-1,
            geomid=hit,
            dist=far,
            nray=count,
            cutoff=MAX_DISTANCE,
            **({"normal": normals.reshape(-1)} if _GIVES_NORMALS else {}),
        )
        painted = self._sky.colours(directions)
        seen = hit >= 0
        points = data.cam_xpos[self._camera] + directions[seen] * far[seen, None]
        facing = np.clip(-np.sum(directions[seen] * normals[seen], axis=1), 1e-6, 1.0)
        light = self._shading.light(data, facing, normals[seen])
        painted[seen] = self._shading.colours(data, hit[seen], points, dot * far[seen] / facing) * light
        return np.clip(painted, 0.0, 255.0).astype(np.uint8), np.where(seen, far, math.inf)


def _grid_size(width: int, height: int, max_rays: int) -> tuple[int, int]:
    """Number of columns and rows of rays for a picture of that shape."""
    shrink = max(1.0, math.sqrt(width * height / max_rays))
    return round(width / shrink), round(height / shrink)


class SkyBox:
    """Colours of the sky, from the world's sky box."""

    def __init__(self, model: mujoco.MjModel) -> None:
        boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX)
        one = np.full((6, 1, 1, 3), DEFAULT_SKY_COLOUR, np.uint8)
        self._faces = _faces(model, int(boxes[0])) if len(boxes) else one

    def colours(self, directions: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the colours in directions (unit vectors, z up) of shape (n, 3): red, green, blue, 0..255."""
        x, y, z = directions.T
        sizes = np.abs(directions)
        axis, most = sizes.argmax(axis=1), sizes.max(axis=1)
        positive = np.take_along_axis(directions, axis[:, None], axis=1)[:, 0] > 0.0
        face = np.choose(axis, [0, 5, 2]) + np.choose(axis, [1, -1, 1]) * ~positive
        horizontal = np.choose(face, [y, -y, x, x, x, -x]) / most
        down = np.choose(face, [-z, -z, -y, y, -z, -z]) / most
        size = self._faces.shape[1]
        column, row = (
            np.minimum(((part + 1.0) / 2.0 * size).astype(np.int64), size - 1) for part in (horizontal, down)
        )
        seen: NDArray[np.float64] = self._faces[face, row, column].astype(np.float64)
        return seen


def _faces(model: mujoco.MjModel, texture: int) -> NDArray[np.uint8]:
    """The faces of the box, as rows of pixels: towards x, -x, z, -z, -y, y. One with a single face repeats it."""
    size, begin = int(model.tex_width[texture]), int(model.tex_adr[texture])
    channels, rows = int(model.tex_nchannel[texture]), int(model.tex_height[texture])
    pixels = model.tex_data[begin : begin + size * rows * channels].reshape(-1, size, size, channels)
    return np.resize(pixels[..., :3], (6, size, size, 3))


class Shading:
    """Computes the colours of a model's shapes, with directional lights and the camera's own, without shadows."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._base_colour = 255.0 * np.array([_base_colour(model, geom) for geom in range(model.ngeom)])
        self._patterns = {
            int(geom): pattern
            for geom in np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE)
            if (pattern := _pattern(model, int(geom))) is not None
        }

    def colours(
        self, data: mujoco.MjData, hit: NDArray[np.int32], points: NDArray[np.float64], widths: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Colours of shapes at points of the world; a pattern finer than a dot is averaged."""
        colours: NDArray[np.float64] = self._base_colour[hit]
        for geom, pattern in self._patterns.items():
            struck = hit == geom
            local = (points[struck] - data.geom_xpos[geom]) @ data.geom_xmat[geom].reshape(3, 3)
            size = np.array(pattern.shape[:2])
            texel = np.floor(local[:, 1::-1] / [-PATTERN_PERIOD, PATTERN_PERIOD] % 1.0 * size).astype(np.int64) % size
            blur = np.clip(2.0 * widths[struck] / PATTERN_PERIOD, 0.0, 1.0)[:, None]
            colours[struck] *= (1.0 - blur) * pattern[texel[:, 0], texel[:, 1]] + blur * pattern.mean(axis=(0, 1))
        return colours

    def light(
        self, data: mujoco.MjData, facing: NDArray[np.float64], normals: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Light (red, green, blue) on surfaces; `facing` is the cosine of the angle to the camera."""
        model, headlight = self._model, self._model.vis.headlight
        light = np.asarray(headlight.ambient) + facing[:, None] * np.asarray(headlight.diffuse)
        for number in np.flatnonzero(model.light_type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL):
            sun = np.clip(-(normals @ data.light_xdir[number]), 0.0, 1.0)[:, None]
            light = light + model.light_ambient[number] + sun * model.light_diffuse[number]
        seen: NDArray[np.float64] = np.minimum(light, 1.0)  # as GL
        return seen


def _base_colour(model: mujoco.MjModel, geom: int) -> NDArray[np.float64]:
    """Base colour of a shape, 0..1. Patterns are drawn on floors only; elsewhere their mean is used."""
    material = int(model.geom_matid[geom])
    if material < 0:
        return np.array(model.geom_rgba[geom][:3])
    pattern = _pattern(model, geom)
    is_floor = model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE
    mean = 1.0 if pattern is None or is_floor else pattern.mean(axis=(0, 1))
    return np.array(model.mat_rgba[material][:3]) * mean


def _pattern(model: mujoco.MjModel, geom: int) -> NDArray[np.float64] | None:
    """The texture of a shape's material as rows of pixels, 0..1."""
    material = int(model.geom_matid[geom])
    textures = (
        [int(texture) for texture in np.ravel(model.mat_texid[material]) if texture >= 0] if material >= 0 else []
    )
    if not textures:
        return None
    rows, columns = int(model.tex_height[textures[0]]), int(model.tex_width[textures[0]])
    channels, begin = int(model.tex_nchannel[textures[0]]), int(model.tex_adr[textures[0]])
    pixels = model.tex_data[begin : begin + rows * columns * channels].reshape(rows, columns, channels)
    return np.array(pixels[..., :3], np.float64) / 255.0
