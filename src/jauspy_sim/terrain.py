"""Twins of height fields for rays: a ray through a mesh is ten times cheaper than one through a height field."""

from __future__ import annotations

from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

DRAWN: Final = 2
"""Group of height fields, which collide and are drawn."""

FELT: Final = 4
"""Group of their twins, which only rays meet."""


def add_twins(world: mujoco.MjSpec) -> None:
    """Gives each height field of a world a mesh with the same surface."""
    fields = [geom for geom in world.geoms if geom.type == mujoco.mjtGeom.mjGEOM_HFIELD]
    if not fields:
        return
    model = world.compile()
    for number, geom in enumerate(fields):
        points, triangles = _surface(model, model.hfield(geom.hfieldname).id)
        name = f"twin_{number}"
        mesh = world.add_mesh(name=name, uservert=points.ravel().tolist(), userface=triangles.ravel().tolist())
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        twin = geom.parent.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, pos=geom.pos, quat=geom.quat)
        twin.contype = twin.conaffinity = 0
        twin.rgba, twin.material = geom.rgba, geom.material
        geom.group, twin.group = DRAWN, FELT


def _surface(model: mujoco.MjModel, field: int) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Corners, and the triangles that MuJoCo, too, makes of each cell."""
    rows, columns, begin = model.hfield_nrow[field], model.hfield_ncol[field], model.hfield_adr[field]
    width, depth, height, _ = model.hfield_size[field]
    heights = height * model.hfield_data[begin : begin + rows * columns]
    x, y = np.meshgrid(np.linspace(-width, width, columns), np.linspace(-depth, depth, rows))
    corners = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (corners[:-1, :-1], corners[:-1, 1:], corners[1:, :-1], corners[1:, 1:]))
    triangles = np.concatenate([np.stack((a, b, d), axis=1), np.stack((a, d, c), axis=1)])
    return np.stack((x.ravel(), y.ravel(), heights), axis=1), triangles
