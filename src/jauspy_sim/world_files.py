"""The worlds that a robot can be in."""

from __future__ import annotations

from importlib.resources import as_file, files

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy_sim.groups import HEIGHT_FIELDS, RAY_MESHES


def known_worlds() -> list[str]:
    """Names of the included worlds, sorted."""
    folder = files("jauspy_sim") / "worlds"
    return sorted(entry.name.removesuffix(".xml") for entry in folder.iterdir() if entry.name.endswith(".xml"))


def world_spec(name: str) -> mujoco.MjSpec:
    """An included world; `ConfigError` lists the worlds there are."""
    names = known_worlds()
    if name not in names:
        raise ConfigError(f"the backend 'sim' has no world {name!r}; it has: {', '.join(names)}")
    with as_file(files("jauspy_sim") / "worlds" / f"{name}.xml") as path:
        spec = mujoco.MjSpec.from_file(str(path))
    add_ray_meshes(spec)
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
