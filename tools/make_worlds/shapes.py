"""Meshes of simple shapes: boxes with bevels, turned profiles, extruded outlines, tubes along a path."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Indices: TypeAlias = NDArray[np.int64]
Vector: TypeAlias = tuple[float, float, float]
Point: TypeAlias = tuple[float, float]

SEGMENTS: Final = 20


@dataclass(frozen=True)
class Mesh:
    """Triangles, counterclockwise from outside. Vertices that triangles share are shaded smoothly.

    `uv` has the texture coordinates of each corner of each triangle, shape (triangles, 3, 2); without it they are made
    when the mesh is written, in metres, from the two axes along which each triangle is widest.
    """

    vertices: Array
    triangles: Indices
    uv: Array | None = None

    def at(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, *, rpy: Vector = (0.0, 0.0, 0.0)) -> Mesh:
        """The mesh, turned by roll, pitch and yaw (rad), and then moved."""
        return replace(self, vertices=self.vertices @ rotation(*rpy).T + (x, y, z))

    def scaled(self, x: float, y: float, z: float) -> Mesh:
        """The mesh, stretched; a factor may mirror it."""
        flipped = self.triangles[:, ::-1] if x * y * z < 0.0 else self.triangles
        uv = self.uv[:, ::-1] if self.uv is not None and x * y * z < 0.0 else self.uv
        return Mesh(self.vertices * (x, y, z), flipped, uv)

    def mapped(self, *, turned: bool = False) -> Mesh:
        """The mesh with its texture fixed to it where it is now; `turned`: by a right angle."""
        uv = box_map(self)
        return replace(self, uv=uv[..., ::-1] if turned else uv)

    def flat(self) -> Mesh:
        """The mesh with no shared vertices, so that each triangle is shaded on its own."""
        return Mesh(self.vertices[self.triangles.ravel()], np.arange(3 * len(self.triangles)).reshape(-1, 3), self.uv)


def rotation(roll: float, pitch: float, yaw: float) -> Array:
    """The matrix of fixed-axis angles (REP-103)."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a), math.sin(a)) for a in (roll, pitch, yaw))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def normals(mesh: Mesh) -> Array:
    """The normal of each triangle, as long as twice its area."""
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)


def box_map(mesh: Mesh) -> Array:
    """Texture coordinates in metres, for each corner of each triangle."""
    widest = np.argmax(np.abs(normals(mesh)), axis=1)
    axes = np.array([(1, 2), (0, 2), (0, 1)])[widest]
    corners = mesh.vertices[mesh.triangles]
    mapped: Array = np.take_along_axis(corners, np.repeat(axes[:, None, :], 3, axis=1), axis=2)
    return mapped


def joined(meshes: Iterable[Mesh]) -> Mesh:
    """Several meshes as one."""
    parts = list(meshes)
    offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return Mesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.triangles + offset for part, offset in zip(parts, offsets, strict=False)]),
        np.concatenate([box_map(part) if part.uv is None else part.uv for part in parts]),
    )


def quads(grid: Array) -> Mesh:
    """A surface through a grid of points, shape (rows, columns, 3)."""
    rows, columns = grid.shape[:2]
    number = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (each.ravel() for each in (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return Mesh(grid.reshape(-1, 3), triangles)


def sheet(x: float, y: float, step: float = 1e9) -> Mesh:
    """A rectangle that looks up, its middle at the origin, divided into squares of about `step` metres."""
    across, along = (max(1, round(side / step)) + 1 for side in (x, y))
    u, v = np.meshgrid(np.linspace(-x / 2.0, x / 2.0, across), np.linspace(-y / 2.0, y / 2.0, along))
    return quads(np.stack([u, v, np.zeros_like(u)], axis=-1))


def picture(width: float, height: float) -> Mesh:
    """A rectangle in the x-z plane that looks to -y and shows a texture once."""
    w, h = width / 2.0, height / 2.0
    corners = np.array([(-w, 0.0, -h), (w, 0.0, -h), (w, 0.0, h), (-w, 0.0, h)])
    uv = np.array([[(0, 0), (1, 0), (1, 1)], [(0, 0), (1, 1), (0, 1)]], np.float64)
    return Mesh(corners, np.array([(0, 1, 2), (0, 2, 3)]), uv)


def box(x: float, y: float, z: float, bevel: float = 0.0) -> Mesh:
    """A cuboid, its middle at the origin, with flat bevels."""
    half, parts = np.array([x, y, z]) / 2.0, []
    inner = half - bevel
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for side in (1.0, -1.0):
            corners = np.zeros((4, 3))
            corners[:, axis] = side * half[axis]
            corners[:, first] = np.array([-1, 1, 1, -1]) * inner[first]
            corners[:, second] = np.array([-1, -1, 1, 1]) * inner[second]
            parts.append(_polygon(corners if side > 0.0 else corners[::-1]))
    if bevel > 0.0:
        for axis in range(3):
            first, second = (axis + 1) % 3, (axis + 2) % 3
            for su in (1.0, -1.0):
                for sv in (1.0, -1.0):
                    corners = np.zeros((4, 3))
                    corners[:, axis] = np.array([-1, 1, 1, -1]) * inner[axis]
                    corners[:, first] = su * np.array([half[first]] * 2 + [inner[first]] * 2)
                    corners[:, second] = sv * np.array([inner[second]] * 2 + [half[second]] * 2)
                    parts.append(_polygon(corners[::-1] if su * sv > 0.0 else corners))
        for sx in (1.0, -1.0):
            for sy in (1.0, -1.0):
                for sz in (1.0, -1.0):
                    sign = np.array([sx, sy, sz])
                    corners = np.stack([sign * np.where(np.eye(3)[axis] > 0.0, half, inner) for axis in range(3)])
                    parts.append(_polygon(corners if sx * sy * sz > 0.0 else corners[::-1]))
    return joined(parts)


def _polygon(corners: Array) -> Mesh:
    """A convex polygon as a fan."""
    count = len(corners)
    return Mesh(corners, np.array([(0, at, at + 1) for at in range(1, count - 1)]))


def lathe(profile: Sequence[Point], segments: int = SEGMENTS) -> Mesh:
    """Radii and heights, from the bottom outward and up, turned about z. Edges over 40 degrees stay sharp."""
    turns = np.linspace(0.0, math.tau, segments, endpoint=False)
    circle = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    points = [np.array(point) for number, point in enumerate(profile) if not number or point != profile[number - 1]]
    vertices: list[Array] = []
    triangles: list[tuple[int, int, int]] = []
    before: Array | None = None
    for low, high in itertools.pairwise(points):
        edge = (high - low) / np.linalg.norm(high - low)
        if before is None or float(before @ edge) < math.cos(math.radians(40.0)):
            vertices.append(np.column_stack([circle * low[0], np.full(segments, low[1])]))
        vertices.append(np.column_stack([circle * high[0], np.full(segments, high[1])]))
        below, above = (len(vertices) - 2) * segments, (len(vertices) - 1) * segments
        for at in range(segments):
            after = (at + 1) % segments
            if low[0] > 0.0:
                triangles.append((below + at, below + after, above + after))
            if high[0] > 0.0:
                triangles.append((below + at, above + after, above + at))
        before = edge
    return Mesh(np.concatenate(vertices), np.array(triangles))


def cylinder(low: float, high: float, radius: float, bevel: float = 0.0, segments: int = SEGMENTS) -> Mesh:
    """A cylinder along z with bevelled ends."""
    if bevel <= 0.0:
        return lathe([(0.0, low), (radius, low), (radius, high), (0.0, high)], segments)
    inner = radius - bevel
    profile = [(0.0, low), (inner, low), (radius, low + bevel), (radius, high - bevel), (inner, high), (0.0, high)]
    return lathe(profile, segments)


def ring(radius: float, thickness: float, around: int = 24, across: int = 8, arc: float = math.tau) -> Mesh:
    """A torus about z, or a part of one from the x axis on."""
    closed = arc >= math.tau - 1e-9
    turns = np.linspace(0.0, arc, around + 1)
    path = np.stack([radius * np.cos(turns), radius * np.sin(turns), np.zeros_like(turns)], axis=1)
    return tube(path[:-1] if closed else path, thickness, across, closed=closed)


def tube(path: Sequence[Vector] | Array, radius: float, segments: int = 8, *, closed: bool = False) -> Mesh:
    """A round bar along points of a path."""
    points = np.asarray(path, np.float64)
    count = len(points)
    ahead = np.roll(points, -1, axis=0) - points
    behind = points - np.roll(points, 1, axis=0)
    if not closed:
        ahead[-1], behind[0] = behind[-1], ahead[0]
    along = ahead / np.linalg.norm(ahead, axis=1)[:, None] + behind / np.linalg.norm(behind, axis=1)[:, None]
    along /= np.linalg.norm(along, axis=1)[:, None]
    side = np.cross(along[0], (0.0, 0.0, 1.0) if abs(along[0][2]) < 0.9 else (1.0, 0.0, 0.0))
    turns = np.linspace(0.0, math.tau, segments, endpoint=False)
    rings = []
    for point, direction in zip(points, along, strict=True):
        side = side - direction * float(side @ direction)
        side /= np.linalg.norm(side)
        up = np.cross(direction, side)
        rings.append(point + radius * (np.cos(turns)[:, None] * side + np.sin(turns)[:, None] * up))
    vertices = np.concatenate(rings)
    triangles = []
    for number in range(count if closed else count - 1):
        a, b = number * segments, (number + 1) % count * segments
        for at in range(segments):
            after = (at + 1) % segments
            triangles += [(a + at, a + after, b + after), (a + at, b + after, b + at)]
    body = Mesh(vertices, np.array(triangles))
    if closed:
        return body
    caps = [_polygon(rings[0][::-1]), _polygon(rings[-1])]
    return joined([body, *caps])


def prism(outline: Sequence[Point], low: float, high: float) -> Mesh:
    """A convex or star-shaped outline (counterclockwise, around its mean) extruded along z, with flat sides."""
    points = np.array(outline, np.float64)
    count, middle = len(points), np.mean(points, axis=0)
    parts = []
    for level, order in ((high, 1), (low, -1)):
        corners = np.column_stack([points, np.full(count, level)])
        fan = np.array([(count, at, (at + 1) % count)[::order] for at in range(count)])
        parts.append(Mesh(np.vstack([corners, (*middle, level)]), fan))
    for at in range(count):
        (ax, ay), (bx, by) = points[at], points[(at + 1) % count]
        parts.append(_polygon(np.array([(ax, ay, low), (bx, by, low), (bx, by, high), (ax, ay, high)])))
    return joined(parts)


def foliage(random: np.random.Generator, count: int, size: float) -> Mesh:
    """Leaves in the outer part of a ball of radius 1, diamonds of about `size`, which look outward."""
    out = random.normal(size=(count, 3))
    out /= np.linalg.norm(out, axis=1)[:, None]
    middles = out * random.uniform(0.45, 1.0, count)[:, None] ** 0.5
    facing = out + 0.45 * random.normal(size=(count, 3))
    facing /= np.linalg.norm(facing, axis=1)[:, None]
    along = np.cross(facing, random.normal(size=(count, 3)))
    along /= np.linalg.norm(along, axis=1)[:, None]
    across, lengths = np.cross(facing, along), size * random.uniform(0.7, 1.3, (count, 1))
    corners = [
        middles - along * lengths,
        middles - across * 0.6 * lengths,
        middles + along * lengths,
        middles + across * 0.6 * lengths,
    ]
    first = 4 * np.arange(count)
    triangles = np.concatenate([np.stack([first, first + 2, first + 1], 1), np.stack([first, first + 3, first + 2], 1)])
    made = Mesh(np.stack(corners, axis=1).reshape(-1, 3), triangles)
    inward = np.einsum("ij,ij->i", normals(made), np.tile(facing, (2, 1))) < 0.0
    return Mesh(made.vertices, np.where(inward[:, None], triangles[:, ::-1], triangles)).flat()


def wall(length: float, height: float, thickness: float, holes: Sequence[tuple[float, float, float, float]]) -> Mesh:
    """A wall along x from the origin, its middle at y = 0, with rectangular holes (left, right, low, high)."""
    return joined(
        box(x1 - x0, thickness, z1 - z0).at((x0 + x1) / 2.0, 0.0, (z0 + z1) / 2.0)
        for x0, x1, z0, z1 in wall_pieces(length, height, holes)
    )


def wall_pieces(
    length: float, height: float, holes: Sequence[tuple[float, float, float, float]]
) -> list[tuple[float, float, float, float]]:
    """The rectangles (left, right, low, high) of a wall around its holes, which must not overlap along x."""
    pieces, at = [], 0.0
    for left, right, low, high in sorted(holes):
        if left > at:
            pieces.append((at, left, 0.0, height))
        if low > 0.0:
            pieces.append((left, right, 0.0, low))
        if high < height:
            pieces.append((left, right, high, height))
        at = right
    if at < length:
        pieces.append((at, length, 0.0, height))
    return pieces
