"""Sky, sun and endless floor, for worlds whose files have none."""

from __future__ import annotations

import math
from typing import Final

import mujoco

HORIZON: Final = (1.0, 1.0, 0.94)
ZENITH: Final = (0.36, 0.56, 0.82)
HAZE: Final = (0.72, 0.8, 0.88, 1.0)


def add_sky(
    spec: mujoco.MjSpec,
    zenith: tuple[float, float, float] = ZENITH,
    horizon: tuple[float, float, float] = HORIZON,
) -> None:
    """Add a sky, and the light of all of it."""
    spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=zenith,
        rgb2=horizon,
        width=256,
        height=1536,
    )
    spec.visual.headlight.ambient = (0.34, 0.35, 0.37)
    spec.visual.headlight.diffuse = (0.15, 0.15, 0.15)
    spec.visual.headlight.specular = (0.0, 0.0, 0.0)
    spec.visual.rgba.haze = HAZE


def add_sun(
    spec: mujoco.MjSpec,
    elevation: float = 60.0,
    azimuth: float = 30.0,
    brightness: float = 0.7,
    *,
    shadows: bool = True,
) -> None:
    """Add a sun; angles in degrees, the azimuth from x towards y."""
    up, around = math.radians(elevation), math.radians(azimuth)
    towards = (math.cos(up) * math.cos(around), math.cos(up) * math.sin(around), math.sin(up))
    light = spec.worldbody.add_light(name="sun", pos=[50.0 * each for each in towards])
    light.type = mujoco.mjtLightType.mjLIGHT_DIRECTIONAL
    light.dir = [-each for each in towards]
    light.castshadow = shadows
    light.diffuse = (brightness,) * 3
    light.ambient = (0.0,) * 3
    light.specular = (0.2,) * 3


def add_floor(spec: mujoco.MjSpec) -> mujoco.MjsGeom:
    """Add an endless floor with a faint pattern."""
    spec.add_texture(
        name="floor",
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
        rgb1=(0.55, 0.56, 0.58),
        rgb2=(0.48, 0.49, 0.51),
        width=256,
        height=256,
    )
    material = spec.add_material(name="floor", texuniform=True, texrepeat=(1.0, 1.0))
    textures = list(material.textures)
    textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = "floor"
    material.textures = textures
    return spec.worldbody.add_geom(
        name="floor", type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0.0, 0.0, 0.1), material="floor"
    )
