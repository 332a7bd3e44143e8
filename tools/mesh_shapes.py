"""Shapes of which the meshes of robots are made: turned, rounded, extruded and swept, with normals; metres."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Final, NamedTuple, TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.polygon import orient

Array: TypeAlias = NDArray[np.float64]
Vector: TypeAlias = tuple[float, float, float]
Point: TypeAlias = tuple[float, float]
Profile: TypeAlias = Sequence[Point]
"""Radius and height, from the bottom outward and up."""

SEGMENTS = 24
SMOOTH = math.cos(math.radians(40.0))
"""Edges that turn by less are smooth."""

X_UP = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
"""Turns z to x."""
Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Turns z to y."""
FLIP: Final = np.diag([1.0, -1.0, -1.0])
"""Half a turn about x: z downward."""


class Mesh(NamedTuple):
    """Triangles with a normal for each vertex."""

    vertices: Array
    normals: Array
    triangles: NDArray[np.int64]

    def at(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, turn: Array | None = None) -> Mesh:
        """The mesh, turned and then moved."""
        rotation = np.eye(3) if turn is None else turn
        return Mesh(self.vertices @ rotation.T + (x, y, z), self.normals @ rotation.T, self.triangles)


def joined(meshes: Iterable[Mesh]) -> Mesh:
    """Several meshes as one."""
    parts = list(meshes)
    offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return Mesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.triangles + offset for part, offset in zip(parts, offsets, strict=False)]),
    )


def lathe(profile: Profile, segments: int = SEGMENTS) -> Mesh:
    """A profile turned about z. Sharp edges of the profile stay sharp."""
    points = np.array(
        [at for number, at in enumerate(profile) if not number or math.dist(at, profile[number - 1]) > 1e-9]
    )
    edges = np.diff(points, axis=0)
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.hypot(edges[:, 0], edges[:, 1])[:, None]
    angles = np.linspace(0.0, 2.0 * math.pi, segments + 1)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    rings: list[tuple[Array, Array]] = []
    for number, normal in enumerate(normals):
        for end, other in ((number, number - 1), (number + 1, number + 1)):
            meets = 0 <= other < len(normals) and float(normal @ normals[other]) > SMOOTH
            smooth = normal + normals[other] if meets else normal
            rings.append((points[end], smooth / np.linalg.norm(smooth)))
    vertices = np.concatenate([np.column_stack([circle * r, np.full(segments + 1, z)]) for (r, z), _ in rings])
    directions = np.concatenate([np.column_stack([circle * r, np.full(segments + 1, z)]) for _, (r, z) in rings])
    triangles = []
    for number in range(0, len(rings), 2):
        low, high = number * (segments + 1), (number + 1) * (segments + 1)
        for at in range(segments):
            if rings[number][0][0] > 0.0:
                triangles.append((low + at, low + at + 1, high + at + 1))
            if rings[number + 1][0][0] > 0.0:
                triangles.append((low + at, high + at + 1, high + at))
    return Mesh(vertices, directions, np.array(triangles))


def rounded(low: float, high: float, radius: float, edge: float, steps: int = 2) -> list[tuple[float, float]]:
    """The profile of a cylinder with rounded edges."""
    arc = [math.pi / 2.0 * step / steps for step in range(steps + 1)]
    below = [(radius - edge + edge * math.sin(a), low + edge - edge * math.cos(a)) for a in arc]
    above = [(radius - edge + edge * math.cos(a), high - edge + edge * math.sin(a)) for a in arc]
    return [(0.0, low), *below, *above, (0.0, high)]


def cylinder(low: float, high: float, radius: float, edge: float = 0.0015, segments: int = SEGMENTS) -> Mesh:
    """A cylinder along z with rounded edges."""
    return lathe(rounded(low, high, radius, edge), segments)


def box(size: Vector, radius: float = 0.004, steps: int = 1) -> Mesh:
    """A cuboid with rounded edges, its middle at the origin."""
    half = np.array(size) / 2.0 - radius
    ramp = np.tan(np.linspace(0.0, math.pi / 4.0, steps + 1))
    at = np.concatenate([-ramp[::-1], ramp])
    sign = np.concatenate([-np.ones(steps + 1), np.ones(steps + 1)])
    count = len(at)
    u, v = np.meshgrid(at, at, indexing="ij")
    su, sv = np.meshgrid(sign, sign, indexing="ij")
    grid = np.arange(count * count).reshape(count, count)
    a, b, c, d = (each.ravel() for each in (grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    sides = []
    for axis in range(3):
        for side in (1.0, -1.0):
            first, second = (axis + 1) % 3, (axis + 2) % 3
            direction, corner = np.zeros((count * count, 3)), np.zeros((count * count, 3))
            direction[:, axis] = corner[:, axis] = side
            direction[:, first], direction[:, second] = u.ravel(), v.ravel()
            corner[:, first], corner[:, second] = su.ravel(), sv.ravel()
            direction /= np.linalg.norm(direction, axis=1)[:, None]
            sides.append(Mesh(corner * half + radius * direction, direction, faces if side > 0.0 else faces[:, ::-1]))
    return joined(sides)


def block(size: Vector) -> Mesh:
    """A cuboid with sharp edges, its middle at the origin."""
    return box(size, 0.0, 0)


def bolts(count: int, circle: float, z: float, radius: float = 0.0024, height: float = 0.0016) -> Mesh:
    """Heads of bolts on a circle about z."""
    head = lathe(
        [(0.0, height * 0.4), (radius * 0.55, height * 0.4), (radius * 0.55, height), (radius, height * 0.9)],
        6,
    )
    side = lathe([(radius, 0.0), (radius, height * 0.9)], 6)
    flipped = Mesh(head.vertices, -head.normals, head.triangles[:, ::-1])
    one = joined([flipped, side])
    angles = [2.0 * math.pi * (number + 0.5) / count for number in range(count)]
    return joined(one.at(circle * math.cos(a), circle * math.sin(a), z) for a in angles)


def turned(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Array:
    """The matrix of turns about x, then y, then z: radians."""
    (a, b), (c, d), (e, f) = ((math.cos(each), math.sin(each)) for each in (x, y, z))
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, a, -b], [0.0, b, a]])
    about_y = np.array([[c, 0.0, d], [0.0, 1.0, 0.0], [-d, 0.0, c]])
    about_z = np.array([[e, -f, 0.0], [f, e, 0.0], [0.0, 0.0, 1.0]])
    matrix: Array = about_z @ about_y @ about_x
    return matrix


def mirrored(mesh: Mesh) -> Mesh:
    """Left and right exchanged."""
    other = np.array([1.0, -1.0, 1.0])
    return Mesh(mesh.vertices * other, mesh.normals * other, mesh.triangles[:, ::-1])


def both_sides(mesh: Mesh) -> Mesh:
    """A mesh and its mirror image on the other side."""
    return joined([mesh, mirrored(mesh)])


def shaded(vertices: Array, triangles: NDArray[np.int64], smooth: float = SMOOTH) -> Mesh:
    """A mesh with normals: edges that turn by less than `smooth` (a cosine) are smooth."""
    corners = vertices[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    kept = np.linalg.norm(faces, axis=1) > 1e-14
    triangles, faces = triangles[kept], faces[kept]
    units = faces / np.linalg.norm(faces, axis=1)[:, None]
    around: list[list[int]] = [[] for _ in range(len(vertices))]
    for number, triangle in enumerate(triangles):
        for corner in triangle:
            around[corner].append(number)
    normals = np.empty((len(triangles), 3, 3))
    for number, triangle in enumerate(triangles):
        for place, corner in enumerate(triangle):
            near = [other for other in around[corner] if float(units[other] @ units[number]) >= smooth]
            total = faces[near].sum(axis=0)
            normals[number, place] = total / np.linalg.norm(total)
    points = vertices[triangles].reshape(-1, 3)
    return merged(Mesh(points, normals.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)))


def merged(mesh: Mesh) -> Mesh:
    """The mesh with each vertex once."""
    rows = np.round(np.hstack([mesh.vertices * 1e5, mesh.normals * 1e3])).astype(np.int64)
    _, first, back = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return Mesh(mesh.vertices[first], mesh.normals[first], back.reshape(-1)[mesh.triangles])


def _offset(ring: Array, by: float) -> Array:
    """A closed ring moved inward (to the left of its direction), corner by corner."""
    ahead = np.roll(ring, -1, axis=0) - ring
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    inward = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    before = np.roll(inward, 1, axis=0)
    bisector = inward + before
    scale = np.maximum(1.0 + np.sum(inward * before, axis=1), 0.2)[:, None]
    moved: Array = ring + by * bisector / scale
    return moved


def extruded(outline: shapely.Polygon | Sequence[Point], low: float, high: float, bevel: float = 0.0) -> Mesh:
    """A polygon, with holes if it has any, from z = low to high; its edges are bevelled."""
    polygon = orient(outline if isinstance(outline, shapely.Polygon) else shapely.Polygon(outline))
    rings = [np.array(ring.coords)[:-1] for ring in (polygon.exterior, *polygon.interiors)]
    inner = [_offset(ring, bevel) for ring in rings] if bevel else rings
    vertices: list[Array] = []
    triangles: list[NDArray[np.int64]] = []
    count = 0
    layers = [(inner, low), (rings, low + bevel), (rings, high - bevel), (inner, high)]
    steps = layers if bevel else [(rings, low), (rings, high)]
    for number in range(len(rings)):
        size = len(rings[number])
        for loops, z in steps:
            vertices.append(np.column_stack([loops[number], np.full(size, z)]))
        at = np.arange(size)
        after = (at + 1) % size
        for layer in range(len(steps) - 1):
            a, b = count + layer * size, count + (layer + 1) * size
            triangles.append(np.stack([a + at, a + after, b + after], axis=1))
            triangles.append(np.stack([a + at, b + after, b + at], axis=1))
        count += size * len(steps)
    cap = shapely.Polygon(inner[0], inner[1:])
    for z, up in ((low, False), (high, True)):
        for piece in shapely.constrained_delaunay_triangles(cap).geoms:
            ring = np.array(orient(piece).exterior.coords)[:3]
            vertices.append(np.column_stack([ring, np.full(3, z)]))
            triangles.append(np.array([[count, count + 1, count + 2] if up else [count, count + 2, count + 1]]))
            count += 3
    points, faces = welded(np.concatenate(vertices), np.concatenate(triangles))
    return shaded(points, faces)


def welded(vertices: Array, triangles: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
    """Vertices at the same place become one."""
    _, first, back = np.unique(
        np.round(vertices * 1e6).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    faces = back.reshape(-1)[triangles]
    differ = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])
    return vertices[first], faces[differ]


def across(mesh: Mesh) -> Mesh:
    """What was extruded in x and y along z becomes a profile in x and z that extends along y, from -high to -low."""
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    return mesh.at(turn=turn)


def round_rectangle(length: float, width: float, radius: float, steps: int = 3) -> list[Point]:
    """The outline of a rectangle with rounded corners around the origin."""
    found = []
    for number, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        x, y = sx * (length / 2.0 - radius), sy * (width / 2.0 - radius)
        for step in range(steps + 1):
            angle = math.pi / 2.0 * (number + step / steps)
            found.append((x + radius * math.cos(angle), y + radius * math.sin(angle)))
    return found


def circle(radius: float, x: float = 0.0, y: float = 0.0, segments: int = SEGMENTS) -> list[Point]:
    """The outline of a disc."""
    return [
        (x + radius * math.cos(a), y + radius * math.sin(a))
        for a in (2.0 * math.pi * number / segments for number in range(segments))
    ]


def slot(length: float, radius: float, steps: int = 8) -> list[Point]:
    """The outline of a slot along x: two half discs whose centres are `length` apart."""
    return [
        (side * length / 2.0 + radius * math.cos(a), radius * math.sin(a))
        for side, start in ((1.0, -math.pi / 2.0), (-1.0, math.pi / 2.0))
        for a in (start + math.pi * step / steps for step in range(steps + 1))
    ]


def swept(points: Sequence[Vector], radius: float, segments: int = 6, steps: int = 4) -> Mesh:
    """A cable or a bent tube through points, with round ends."""
    path = _smooth(np.array(points), steps)
    tangents = np.gradient(path, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    side = np.cross(tangents[0], [0.0, 0.0, 1.0] if abs(tangents[0][2]) < 0.9 else [1.0, 0.0, 0.0])
    rings = []
    angles = np.linspace(0.0, 2.0 * math.pi, segments, endpoint=False)
    for point, tangent in zip(path, tangents, strict=True):
        side = side - tangent * float(side @ tangent)
        side /= np.linalg.norm(side)
        other = np.cross(tangent, side)
        rings.append(point + radius * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * other))
    vertices = np.concatenate(
        [*rings, path[:1] - tangents[:1] * radius * 0.5, path[-1:] + tangents[-1:] * radius * 0.5]
    )
    at = np.arange(segments)
    after = (at + 1) % segments
    triangles = []
    for number in range(len(rings) - 1):
        a, b = number * segments, (number + 1) * segments
        triangles += [np.stack([a + at, a + after, b + after], axis=1), np.stack([a + at, b + after, b + at], axis=1)]
    last, first_pole = (len(rings) - 1) * segments, len(rings) * segments
    triangles.append(np.stack([np.full(segments, first_pole), after, at], axis=1))
    triangles.append(np.stack([np.full(segments, first_pole + 1), last + at, last + after], axis=1))
    return shaded(vertices, np.concatenate(triangles), math.cos(math.radians(75.0)))


def _smooth(points: Array, steps: int) -> Array:
    """Points on a Catmull-Rom spline."""
    if len(points) < 3:
        return points
    ends = np.concatenate([[2.0 * points[0] - points[1]], points, [2.0 * points[-1] - points[-2]]])
    t = np.linspace(0.0, 1.0, steps, endpoint=False)[:, None]
    pieces = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:], strict=False):
        pieces.append(
            0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t**2 + (3.0 * (b - c) + d - a) * t**3)
        )
    return np.concatenate([*pieces, points[-1:]])


def pin(low: float, high: float, radius: float, segments: int = 14) -> Mesh:
    """A cylinder along z with sharp edges, of few triangles."""
    return lathe([(0.0, low), (radius, low), (radius, high), (0.0, high)], segments)


def screws(places: Iterable[Vector], radius: float = 0.0035, height: float = 0.0022) -> Mesh:
    """Heads of screws that stand on z."""
    head = lathe([(radius, 0.0), (radius * 0.8, height), (0.0, height)], 8)
    return joined([head.at(*place) for place in places])


def hexagons(count: int, circle: float, z: float, radius: float, height: float) -> Mesh:
    """Heads of hexagonal bolts on a circle about z."""
    angles = [2.0 * math.pi * (number + 0.5) / count for number in range(count)]
    head = lathe([(radius, 0.0), (radius, height), (0.0, height)], 6)
    return joined([head.at(circle * math.cos(a), circle * math.sin(a), z) for a in angles])
