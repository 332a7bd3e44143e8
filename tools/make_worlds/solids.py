"""Meshes of smooth solids: the zero surface of a distance function, by surface nets, decimated."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import fast_simplification
import numpy as np
from numpy.typing import NDArray

from .shapes import Array, Mesh, Vector

Field: TypeAlias = Callable[[Array, Array, Array], Array]
"""Metres to the surface of a solid at points x, y, z; negative inside."""


def block(size: Vector, radius: float, at: Vector = (0.0, 0.0, 0.0)) -> Field:
    """A cuboid with round edges."""
    half = np.array(size) / 2.0 - radius

    def field(x: Array, y: Array, z: Array) -> Array:
        px, py, pz = (np.abs(c - o) - h for c, o, h in zip((x, y, z), at, half, strict=True))
        outside = np.sqrt(np.maximum(px, 0.0) ** 2 + np.maximum(py, 0.0) ** 2 + np.maximum(pz, 0.0) ** 2)
        distance: Array = outside + np.minimum(np.maximum(px, np.maximum(py, pz)), 0.0) - radius
        return distance

    return field


def capsule(start: Vector, end: Vector, radius: float) -> Field:
    """A bar with round ends."""
    a, axis = np.array(start), np.array(end) - np.array(start)

    def field(x: Array, y: Array, z: Array) -> Array:
        p = np.stack([x - a[0], y - a[1], z - a[2]], axis=-1)
        t = np.clip(p @ axis / float(axis @ axis), 0.0, 1.0)
        distance: Array = np.linalg.norm(p - t[..., None] * axis, axis=-1) - radius
        return distance

    return field


def union(*fields: Field, soft: float = 0.0) -> Field:
    """Where any of the solids is; edges between them filled with a radius of about `soft`."""

    def field(x: Array, y: Array, z: Array) -> Array:
        made = fields[0](x, y, z)
        for each in fields[1:]:
            made = smooth_min(made, each(x, y, z), soft)
        return made

    return field


def smooth_min(a: Array, b: Array, radius: float) -> Array:
    """The smaller of two distances, rounded where they are alike."""
    if radius <= 0.0:
        return np.minimum(a, b)
    mix = np.clip(0.5 + 0.5 * (b - a) / radius, 0.0, 1.0)
    rounded: Array = b + (a - b) * mix - radius * mix * (1.0 - mix)
    return rounded


def smooth_max(a: Array, b: Array, radius: float) -> Array:
    """The larger of two distances, rounded where they are alike."""
    return -smooth_min(-a, -b, radius)


def outline(points: Array, x: Array, z: Array) -> Array:
    """Distance to a polygon in a plane; negative inside."""
    nearest = np.full(x.shape, np.inf)
    inside = np.zeros(x.shape, bool)
    for (ax, az), (bx, bz) in zip(points, np.roll(points, -1, axis=0), strict=True):
        dx, dz = bx - ax, bz - az
        t = np.clip(((x - ax) * dx + (z - az) * dz) / (dx * dx + dz * dz), 0.0, 1.0)
        nearest = np.minimum(nearest, np.hypot(x - ax - t * dx, z - az - t * dz))
        crosses = (az > z) != (bz > z)
        with np.errstate(divide="ignore", invalid="ignore"):
            inside ^= crosses & (x < (bx - ax) * (z - az) / (bz - az) + ax)
    return np.where(inside, -nearest, nearest)


def solid(field: Field, low: Vector, high: Vector, step: float, triangles: int = 0) -> Mesh:
    """The surface of a solid within a box, sampled every `step` metres; at most `triangles` of them, if given."""
    axes = [np.arange(a - 1.5 * step, b + 2.5 * step, step) for a, b in zip(low, high, strict=True)]
    values = field(*np.meshgrid(*axes, indexing="ij"))
    mesh = surface(values, np.array([axis[0] for axis in axes]), step)
    if triangles and len(mesh.triangles) > triangles:
        points, faces = fast_simplification.simplify(
            mesh.vertices.astype(np.float32), mesh.triangles.astype(np.int32), target_count=triangles, agg=4.0
        )
        mesh = Mesh(np.asarray(points, np.float64), np.asarray(faces, np.int64))
    return mesh


def surface(values: NDArray[np.float64], origin: Array, step: float) -> Mesh:
    """Surface nets: a vertex in each cell that the surface crosses, a square for each edge that it crosses."""
    inside = values < 0.0
    cells = tuple(size - 1 for size in values.shape)
    total, count = np.zeros((*cells, 3)), np.zeros(cells)
    for axis in range(3):
        low = [slice(None)] * 3
        high = [slice(None)] * 3
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        a, b = values[tuple(low)], values[tuple(high)]
        crossed = (a < 0.0) != (b < 0.0)
        part = np.where(crossed, a / np.where(crossed, a - b, 1.0), 0.0)
        others = [other for other in range(3) if other != axis]
        for du in (0, 1):
            for dv in (0, 1):
                cut = [slice(None)] * 3
                cut[others[0]] = slice(du, du + cells[others[0]])
                cut[others[1]] = slice(dv, dv + cells[others[1]])
                here = crossed[tuple(cut)]
                total[..., axis] += np.where(here, part[tuple(cut)], 0.0)
                total[..., others[0]] += du * here
                total[..., others[1]] += dv * here
                count += here
    used = count > 0
    index = np.full(cells, -1)
    index[used] = np.arange(int(used.sum()))
    where = np.argwhere(used)
    vertices = origin + step * (where + total[used] / count[used][:, None])
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        low, high = [slice(None)] * 3, [slice(None)] * 3
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        rising = inside[tuple(low)] & ~inside[tuple(high)]
        falling = ~inside[tuple(low)] & inside[tuple(high)]
        for edges, order in ((rising, 1), (falling, -1)):
            at = np.argwhere(edges)
            at = at[(at[:, u] > 0) & (at[:, v] > 0) & (at[:, u] < cells[u]) & (at[:, v] < cells[v])]
            eu, ev = np.eye(3, dtype=np.int64)[u], np.eye(3, dtype=np.int64)[v]
            corners = [index[tuple((at - d).T)] for d in (eu + ev, ev, np.zeros(3, np.int64), eu)]
            a, b, c, d = corners[::order]
            faces += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
    return Mesh(vertices, np.concatenate(faces))
