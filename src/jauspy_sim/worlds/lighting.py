"""Sky, sun and endless floor, for worlds whose files have none; and how endless floors are drawn."""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np

from jauspy_sim.models.groups import COLLISION, SOLID, VISUAL

HORIZON: Final = (1.0, 1.0, 0.94)
ZENITH: Final = (0.36, 0.56, 0.82)
HAZE: Final = (0.72, 0.8, 0.88, 1.0)

FLOOR_MESH: Final = "endless floor"
FLOOR_SIZE: Final = 400.0
"""Metres from the middle of a floor that is drawn as a mesh to its edges; GL's far plane is nearer in most worlds."""


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
    light = spec.worldbody.add_light(name="sun", pos=[50.0 * coordinate for coordinate in towards])
    light.type = mujoco.mjtLightType.mjLIGHT_DIRECTIONAL
    light.dir = [-coordinate for coordinate in towards]
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


def draw_floors_as_meshes(spec: mujoco.MjSpec) -> None:
    """Show meshes in place of the endless planes of a world, which still collide.

    With llvmpipe, MuJoCo takes three times as long for a pixel of a plane: a third of the whole picture.
    """
    sides = np.concatenate([np.arange(0.0, 24.0, 4.0), np.geomspace(24.0, FLOOR_SIZE, 8)])
    steps = np.concatenate([-sides[:0:-1], sides])
    x, y = (axis.ravel() for axis in np.meshgrid(steps, steps))
    count = len(steps)
    first = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    corners = (first, first + 1, first + count + 1, first + count)
    faces = np.stack([corners[corner] for corner in (0, 1, 2, 0, 2, 3)], axis=1)
    for geom in list(spec.geoms):
        if geom.type != mujoco.mjtGeom.mjGEOM_PLANE or geom.size[:2].any() or geom.group >= COLLISION:
            continue
        if FLOOR_MESH not in {mesh.name for mesh in spec.meshes}:
            mesh = spec.add_mesh(name=FLOOR_MESH, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
            mesh.uservert = np.stack([x, y, np.zeros_like(x)], axis=1).ravel()
            mesh.userface = faces.ravel()
            # as MuJoCo lays textures on planes: a texture that repeats once covers two metres
            mesh.usertexcoord = np.stack([x / 2.0, y / 2.0], axis=1).ravel()
            mesh.userfacetexcoord = faces.ravel()
        drawn = geom.parent.add_geom(
            type=mujoco.mjtGeom.mjGEOM_MESH, meshname=FLOOR_MESH, contype=0, conaffinity=0, mass=0.0, group=VISUAL
        )
        drawn.pos, drawn.quat, drawn.alt, drawn.rgba = geom.pos, geom.quat, geom.alt, geom.rgba
        drawn.material = _with_own_coordinates(spec, geom.material)
        geom.group = SOLID


def _with_own_coordinates(spec: mujoco.MjSpec, name: str) -> str:
    """The material without `texuniform`, with which MuJoCo multiplies the texture coordinates of a mesh by its size."""
    if not name or not spec.material(name).texuniform:
        return name
    found, floor_name = spec.material(name), f"{name} of the floor"
    if spec.material(floor_name) is None:
        spec.add_material(
            name=floor_name,
            textures=found.textures,
            rgba=found.rgba,
            texrepeat=found.texrepeat,
            emission=found.emission,
            specular=found.specular,
            shininess=found.shininess,
            reflectance=0.0,
        )
    return floor_name
