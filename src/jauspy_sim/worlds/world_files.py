"""Loads worlds: included ones, MJCF, SDF and lists of objects."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.resources import as_file, files
from pathlib import Path
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.platform.description import WORLD_SUFFIXES, is_world_file
from jauspy.user_files import read_file
from jauspy_sim.models.groups import COLLISION, HEIGHT_FIELDS, RAY_MESHES
from jauspy_sim.worlds.mjcf_files import check_costs, check_files
from jauspy_sim.worlds.model_paths import ModelPaths
from jauspy_sim.worlds.sdf import sdf_world
from jauspy_sim.worlds.world_objects import objects_world

MAX_ITERATIONS: Final = 1000
"""Most iterations of a solver in each step."""
MAX_SIDE, MAX_SAMPLES, MAX_SLICES = 8192, 16, 128
"""Bounds of what MuJoCo draws: pixels of a side, samples of a pixel, slices of a sphere."""

SHOWN: Final = (0, 1, 2)
"""Groups of geometries that MuJoCo draws."""


def known_worlds() -> list[str]:
    """Names of the included worlds, sorted."""
    folder = files("jauspy_sim") / "worlds"
    return sorted(entry.name.removesuffix(".xml") for entry in folder.iterdir() if entry.name.endswith(".xml"))


def world_spec(name_or_path: str, model_path: Sequence[str] = ()) -> mujoco.MjSpec:
    """An included world, or that of a file. Raises `ConfigError`, which lists the worlds there are.

    `model_path` has the directories in which SDF's `model://` is searched first.
    """
    if is_world_file(name_or_path):
        spec = _of_file(Path(name_or_path), ModelPaths(tuple(map(Path, model_path))))
    else:
        spec = _included(name_or_path)
    add_ray_meshes(spec)
    return spec


def _included(name: str) -> mujoco.MjSpec:
    names = known_worlds()
    if name not in names:
        raise ConfigError(
            f"the backend 'sim' has no world {name!r}; it has: {', '.join(names)}; or give the path of a file: "
            f"{', '.join(WORLD_SUFFIXES)}"
        )
    with as_file(files("jauspy_sim") / "worlds" / f"{name}.xml") as path:
        return mujoco.MjSpec.from_file(str(path))


def _of_file(path: Path, paths: ModelPaths) -> mujoco.MjSpec:
    if not path.is_file():
        raise ConfigError(f"world: {path}: " + ("is not a regular file" if path.exists() else "there is no such file"))
    try:
        match path.suffix.lower():
            case ".sdf" | ".world":
                return sdf_world(path, paths)
            case ".toml":
                return objects_world(path)
            case ".xml" | ".mjcf":
                return _mjcf(path, paths)
    except ConfigError as error:
        raise ConfigError(f"world: {error}") from error
    raise ConfigError(f"world: {path}: its name must end in one of: {', '.join(WORLD_SUFFIXES)}")


def _mjcf(path: Path, paths: ModelPaths) -> mujoco.MjSpec:
    """A world in MJCF; included files are relative to it."""
    data = read_file(path)
    check_files(path, paths)
    try:
        check_costs(path)
        spec = mujoco.MjSpec.from_file(str(path))
    except (ConfigError, ValueError, FileNotFoundError) as error:
        reason = " ".join(str(error).split())
        hint = "; SDF worlds have the suffix .sdf or .world" if b"<sdf" in data[:1000] else ""
        raise ConfigError(f"{reason}{hint}") from error
    for name in ("iterations", "ls_iterations", "noslip_iterations", "ccd_iterations", "sdf_iterations"):
        setattr(spec.option, name, min(getattr(spec.option, name), MAX_ITERATIONS))
    quality, screen = spec.visual.quality, spec.visual.global_
    quality.shadowsize, quality.offsamples = min(quality.shadowsize, MAX_SIDE), min(quality.offsamples, MAX_SAMPLES)
    screen.offwidth, screen.offheight = min(screen.offwidth, MAX_SIDE), min(screen.offheight, MAX_SIDE)
    for name in ("numslices", "numstacks", "numquads"):
        setattr(quality, name, min(getattr(quality, name), MAX_SLICES))
    for key in list(spec.keys):
        spec.delete(key)  # they have no positions for the robot
    for geom in spec.geoms:
        geom.group = 0 if geom.group in SHOWN else COLLISION
    return spec


def add_ray_meshes(world: mujoco.MjSpec) -> None:
    """Give each height field of a world a mesh with the same surface: a ray through it costs a tenth."""
    fields = [geom for geom in world.geoms if geom.type == mujoco.mjtGeom.mjGEOM_HFIELD]
    if not fields:
        return
    model = world.compile()
    for number, geom in enumerate(fields):
        points, triangles = _surface(model, model.hfield(geom.hfieldname).id)
        name = f"ray_mesh_{number}"
        mesh = world.add_mesh(name=name, uservert=points.ravel().tolist(), userface=triangles.ravel().tolist())
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        ray_mesh = geom.parent.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, pos=geom.pos, quat=geom.quat)
        ray_mesh.contype = ray_mesh.conaffinity = 0
        ray_mesh.rgba, ray_mesh.material = geom.rgba, geom.material
        geom.group, ray_mesh.group = HEIGHT_FIELDS, RAY_MESHES


def _surface(model: mujoco.MjModel, field: int) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Vertices and triangles of a height field, with the same triangles as MuJoCo's."""
    rows, columns, begin = model.hfield_nrow[field], model.hfield_ncol[field], model.hfield_adr[field]
    width, depth, height, _ = model.hfield_size[field]
    heights = height * model.hfield_data[begin : begin + rows * columns]
    x, y = np.meshgrid(np.linspace(-width, width, columns), np.linspace(-depth, depth, rows))
    corners = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (corners[:-1, :-1], corners[:-1, 1:], corners[1:, :-1], corners[1:, 1:]))
    triangles = np.concatenate([np.stack((a, b, d), axis=1), np.stack((a, d, c), axis=1)])
    return np.stack((x.ravel(), y.ravel(), heights), axis=1), triangles
