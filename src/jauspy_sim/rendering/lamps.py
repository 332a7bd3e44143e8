"""The light of lamps in the dark, computed for the pixels of a picture from their depths.

MuJoCo's renderer lights the corners of triangles, so a lamp's cone would not show on a floor of few triangles. In the
dark, pictures are therefore rendered in even light, and lamps are added here: per pixel, with shadows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

import cv2
import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.lights import DAYLIGHT, LampSetup, TimeOfDay
from jauspy_sim.models.urdf import body_name

if TYPE_CHECKING:
    from jauspy_sim.rendering.renderer import Renderer

Floats: TypeAlias = NDArray[np.float32]
Vectors: TypeAlias = NDArray[np.float64]

EVEN_LIGHT: Final = (0.75, 0.25)
"""Ambient light, and that from the camera, in which pictures for the dark are rendered."""

EDGE: Final = 0.15
"""Part of a cone, from its edge inwards, in which the light fades out."""

SHADOW_SIZE: Final = 256
"""Side of a lamp's shadow map, in pixels."""
SHADOW_MARGIN: Final = 1.02
SHADOW_BIAS: Final = (0.02, 0.005)
"""Metres, and metres per metre of distance, by which a lit surface may be behind the shadow map."""
MAX_STEEPNESS: Final = 25.0
"""Largest factor by which that is increased where light falls flat on a surface."""
MAX_SHADOW_ANGLE: Final = math.radians(75.0)
"""Largest angle from the axis at which shadows are computed."""

MIN_DISTANCE: Final = 0.05
"""Metres; closer surfaces get the light of this distance."""

DEFAULT_INTENSITY: Final = 800.0
"""Candela of a light of a world, of colour 1, whose intensity is not given."""


@dataclass(frozen=True, slots=True)
class _Beam:
    """A lamp in the model."""

    body: int
    position: Vectors
    rotation: Vectors
    """Axes of the lamp (x ahead, y left, z up) in the frame of the body, as columns."""
    intensity: float
    """Candela."""
    half_angle: float
    casts_shadow: bool

    def pose(self, data: mujoco.MjData) -> tuple[Vectors, Vectors]:
        """Position and axes in the world."""
        turn = data.xmat[self.body].reshape(3, 3)
        return data.xpos[self.body] + turn @ self.position, turn @ self.rotation


class Darkness:
    """The light of a world by dusk or night: of the sky, of the world's own lamps, and of those of its robots.

    `lamps` are those of the robots, each with the prefix of its robot's names.
    """

    def __init__(self, model: mujoco.MjModel, lamps: Sequence[tuple[str, LampSetup]], time_of_day: TimeOfDay) -> None:
        self._sky = time_of_day.sky
        self._beams = [_beam(model, prefix, lamp) for prefix, lamp in lamps]
        self._fixed = _lights_of_world(model)

    def light(
        self,
        data: mujoco.MjData,
        camera: int,
        distances: Floats,
        spread: float,
        *,
        levels: Sequence[float],
        source: Renderer,
        coarse: bool,
    ) -> Floats:
        """The light on each pixel as a fraction of daylight; `levels` are those of the robots' lamps.

        `spread` is half of the picture's width at a distance of one. Coarsely the light is computed for each fourth
        pixel, and interpolated between them.
        """
        size = distances.shape[::-1]
        if coarse:
            distances = np.ascontiguousarray(distances[::2, ::2])
        made = np.full(distances.shape, self._sky, np.float32)
        lit = [(beam, level) for beam, level in zip(self._beams, levels, strict=True) if level > 0.0]
        lit += [(beam, 1.0) for beam in self._fixed]
        if not lit:
            return np.full(size[::-1], self._sky, np.float32)
        surface = Surface(distances, spread)
        eye, axes = data.cam_xpos[camera], data.cam_xmat[camera].reshape(3, 3)
        for beam, level in lit:
            position, rotation = beam.pose(data)
            shadow = None
            wide = math.tan(min(beam.half_angle * SHADOW_MARGIN, MAX_SHADOW_ANGLE))
            if beam.casts_shadow:
                shadow = source.depths_from(data, position, rotation, wide, SHADOW_SIZE)
            # From the camera's frame, here x right, y up, z ahead, to the lamp's.
            to_camera = axes.T * np.array([[1.0], [1.0], [-1.0]])
            made += surface.lit(
                (to_camera @ (position - eye)).astype(np.float32),
                (to_camera @ rotation).astype(np.float32),
                np.float32(beam.intensity * level / DAYLIGHT),
                beam.half_angle,
                None if shadow is None else (shadow, wide),
            )
        return np.asarray(cv2.resize(made, size), np.float32) if coarse else made


class Surface:
    """The visible surface of a picture, in the camera's frame: x right, y up, z ahead."""

    def __init__(self, distances: Floats, spread: float) -> None:
        height, width = distances.shape
        pixel = np.float32(2.0 * spread / width)
        self._x = (pixel * (np.arange(width, dtype=np.float32) - np.float32((width - 1) / 2.0)))[None, :]
        self._y = (-pixel * (np.arange(height, dtype=np.float32) - np.float32((height - 1) / 2.0)))[:, None]
        self._z = np.minimum(distances, np.float32(1e4))
        # The inverse depth of a plane changes evenly over a picture, and its gradient is the plane's normal.
        inverse: Floats = np.reciprocal(self._z)
        self._nx = _gradient(inverse, 1) / pixel
        self._ny = _gradient(inverse, 0) / -pixel
        self._nz = inverse - self._x * self._nx - self._y * self._ny
        self._length = np.sqrt(self._nx**2 + self._ny**2 + self._nz**2)

    def seen_from(self, place: Floats, axes: Floats) -> tuple[Floats, Floats, Floats]:
        """The pixels' coordinates ahead, to the left and up of a place with those axes, as columns."""
        found = []
        for axis in range(3):
            a = axes[:, axis]
            found.append((a[0] * self._x + (a[1] * self._y + a[2])) * self._z - np.float32(a @ place))
        return found[0], found[1], found[2]

    def facing(self, direction: Floats) -> Floats:
        """The cosine of the angle at which light in that direction falls on the surface; 0 from behind."""
        towards = self._nx * direction[0] + self._ny * direction[1] + self._nz * direction[2]
        made: Floats = np.maximum(towards / self._length, np.float32(0.0))
        return made

    def lit(
        self, lamp: Floats, axes: Floats, intensity: np.float32, half_angle: float, shadow: tuple[Floats, float] | None
    ) -> Floats:
        """The light of a lamp at that place, with those axes (x ahead, y left, z up) as columns."""
        ahead, left, up = self.seen_from(lamp, axes)
        squared = np.maximum(ahead**2 + left**2 + up**2, np.float32(MIN_DISTANCE**2))
        distance = np.sqrt(squared)
        facing = 1.0 - (self._nx * lamp[0] + self._ny * lamp[1] + self._nz * lamp[2])
        facing = np.maximum(facing / (self._length * distance), np.float32(0.0))
        edge, inner = math.cos(half_angle), math.cos(half_angle * (1.0 - EDGE))
        cone = np.clip((ahead / distance - np.float32(edge)) / np.float32(inner - edge), 0.0, 1.0)
        made: Floats = (intensity * cone * facing / squared).astype(np.float32)
        if shadow is not None:
            made *= _seen(ahead, left, up, facing, shadow)
        return made


def _gradient(values: Floats, axis: int) -> Floats:
    """Differences from pixel to pixel; beside an edge that of the smooth side."""
    steps = np.diff(values, axis=axis)
    first = np.take(steps, [0], axis=axis)
    last = np.take(steps, [-1], axis=axis)
    ahead, behind = np.concatenate([steps, last], axis=axis), np.concatenate([first, steps], axis=axis)
    return np.where(np.abs(ahead) < np.abs(behind), ahead, behind)


def _seen(ahead: Floats, left: Floats, up: Floats, facing: Floats, shadow: tuple[Floats, float]) -> Floats:
    """1 where the lamp sees the surface, 0 in the shadow, and between at the edge."""
    depths, spread = shadow
    size = depths.shape[0]
    scale = np.float32(size / 2.0 / spread)
    forward = np.maximum(ahead, np.float32(1e-3))
    middle = np.float32((size - 1) / 2.0)
    found = cv2.remap(
        depths, middle - left / forward * scale, middle - up / forward * scale, cv2.INTER_NEAREST, borderValue=1e4
    )
    fixed, relative = SHADOW_BIAS
    # Within one pixel of what the lamp sees, depths differ the more the flatter the light falls on the surface.
    steep = np.minimum(np.float32(1.0) / np.maximum(facing, np.float32(0.02)), np.float32(MAX_STEEPNESS))
    allowed = np.float32(fixed) + ahead * (np.float32(relative) + np.float32(2.0 * spread / size) * steep)
    is_seen = (np.asarray(found) + allowed >= ahead).astype(np.float32)
    return np.asarray(cv2.blur(is_seen, (3, 3)), np.float32)


def _beam(model: mujoco.MjModel, prefix: str, lamp: LampSetup) -> _Beam:
    down = lamp.tilt
    turn = np.array([[math.cos(down), 0.0, math.sin(down)], [0.0, 1.0, 0.0], [-math.sin(down), 0.0, math.cos(down)]])
    body = int(model.body(f"{prefix}{body_name(lamp.link)}").id)
    return _Beam(body, np.array(lamp.position), turn, lamp.intensity, lamp.cone / 2.0, casts_shadow=True)


def _lights_of_world(model: mujoco.MjModel) -> list[_Beam]:
    """The lamps of a world, which are on in the dark: lights at a place; they cast no shadows."""
    found = []
    for number in range(model.nlight):
        kind = model.light_type[number]
        if kind not in (mujoco.mjtLightType.mjLIGHT_SPOT, mujoco.mjtLightType.mjLIGHT_POINT):
            continue
        is_spot = kind == mujoco.mjtLightType.mjLIGHT_SPOT
        half_angle = math.radians(min(float(model.light_cutoff[number]), 90.0)) if is_spot else math.pi
        intensity = float(model.light_intensity[number]) or DEFAULT_INTENSITY * float(
            model.light_diffuse[number].mean()
        )
        axes = axes_along(model.light_dir[number])
        body = int(model.light_bodyid[number])
        found.append(_Beam(body, model.light_pos[number].copy(), axes, intensity, half_angle, casts_shadow=False))
    return found


def axes_along(direction: Vectors) -> Vectors:
    """Axes (x ahead, y left, z up) with that x axis, as columns."""
    ahead = direction / np.linalg.norm(direction)
    left = np.cross((0.0, 0.0, 1.0) if abs(ahead[2]) < 0.9 else (1.0, 0.0, 0.0), ahead)
    left /= np.linalg.norm(left)
    return np.stack([ahead, left, np.cross(ahead, left)], axis=1)


def light_evenly(model: mujoco.MjModel) -> None:
    """Switch the lights of a model off, and light everything evenly."""
    model.light_active[:] = 0
    ambient, diffuse = EVEN_LIGHT
    model.vis.headlight.active = 1
    model.vis.headlight.ambient[:] = ambient
    model.vis.headlight.diffuse[:] = diffuse
    model.vis.headlight.specular[:] = 0.0
