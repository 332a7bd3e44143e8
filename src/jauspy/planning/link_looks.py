"""Space that the looks of a robot's links fill: their meshes, as grids of small cells. A camera sees these.

Collision shapes are simpler and often smaller: of inc1, whose wrist looks 14 cm beyond its box.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import numbers, origin, parse_tree
from jauspy.user_files import read_file

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

CELL: Final = 0.02
"""Edge of a cell, metres."""
MAX_CELLS: Final = 4_000_000
"""Cells of a link's grid; a larger link gets larger cells."""
MAX_TRIANGLES: Final = 300_000
"""Triangles of a mesh."""
_STL_HEADER: Final = 84
_STL_TRIANGLE: Final = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


@dataclass(frozen=True, slots=True)
class LinkLook:
    """The cells that are at most a margin away from the surface of a link; in the frame of the link."""

    link: str
    low: Array
    """Corner of the first cell, metres."""
    cell: float
    filled: Flags

    @classmethod
    def of(cls, link: str, triangles: Array, margin: float) -> LinkLook:
        """The look with these triangles, shape (n, 3, 3), metres."""
        low, high = triangles.min(axis=(0, 1)) - margin, triangles.max(axis=(0, 1)) + margin
        cell = max(CELL, float(np.cbrt(np.prod(high - low + CELL) / MAX_CELLS)))
        low = low - 2.0 * cell
        filled = np.zeros(np.ceil((high - low) / cell).astype(np.int64) + 3, np.bool_)
        filled[tuple(np.floor((_surface(triangles, cell) - low) / cell).astype(np.int64).T)] = True
        return cls(link, low, cell, distance_transform_edt(~filled) * cell <= margin + cell)

    def contains(self, points: Array) -> Flags:
        """For each point in the frame of the link, shape (n, 3): True if it is in a cell."""
        inside: Flags = np.zeros(len(points), np.bool_)
        size = np.array(self.filled.shape)
        near = np.flatnonzero(((points >= self.low) & (points < self.low + size * self.cell)).all(axis=1))
        x, y, z = np.minimum(((points[near] - self.low) / self.cell).astype(np.int64), size - 1).T
        inside[near] = self.filled[x, y, z]
        return inside


def link_looks(urdf: str, margin: float) -> tuple[list[LinkLook], list[str]]:
    """The looks of the links with meshes of a URDF, whose paths are those of files; and meshes that cannot be read."""
    found: dict[str, list[Array]] = defaultdict(list)
    unread: list[str] = []
    for link in parse_tree(urdf).findall("link"):
        for visual in link.findall("visual"):
            mesh = visual.find("geometry/mesh")
            if mesh is None:
                continue
            path = str(mesh.get("filename")).removeprefix("file://")
            triangles = _triangles(Path(path))
            if triangles is None or not len(triangles):
                unread.append(path)
                continue
            frame = Transform.from_pose(origin(visual))
            scaled = triangles * np.array(numbers(mesh, "scale", 3, "1 1 1"))
            found[str(link.get("name"))].append(scaled @ np.array(frame.rotation).T + np.array(frame.position))
    return [LinkLook.of(link, np.concatenate(parts), margin) for link, parts in found.items()], unread


def _triangles(path: Path) -> Array | None:
    """Triangles of a file, shape (n, 3, 3); None for one that cannot be read, or is neither OBJ nor binary STL."""
    try:
        data = read_file(path)
        found = {".obj": _obj, ".stl": _stl}.get(path.suffix.lower(), lambda _: None)(data)
    except (ConfigError, ValueError, IndexError):
        return None
    if found is None or len(found) > MAX_TRIANGLES or not (np.abs(found) < 1e6).all():
        return None
    return found


def _obj(data: bytes) -> Array:
    corners: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    for line in data.decode(errors="replace").splitlines():
        kind, *values = line.split() or [""]
        if kind == "v":
            corners.append([float(value) for value in values[:3]])
        elif kind == "f":
            numbered = [int(value.partition("/")[0]) for value in values]
            indices = [number - 1 if number > 0 else len(corners) + number for number in numbered]
            faces += [(indices[0], one, other) for one, other in pairwise(indices[1:])]
    return np.array(corners, np.float64).reshape(-1, 3)[np.array(faces, np.int64).reshape(-1, 3)]


def _stl(data: bytes) -> Array:
    count = int.from_bytes(data[_STL_HEADER - 4 : _STL_HEADER], "little")
    found = np.frombuffer(data, _STL_TRIANGLE, min(count, MAX_TRIANGLES + 1), _STL_HEADER)
    return found["corners"].astype(np.float64)


def _surface(triangles: Array, spacing: float) -> Array:
    """Points on triangles, about `spacing` apart, shape (n, 3)."""
    edges = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
    steps = np.clip(np.ceil(edges / spacing), 1, 1000).astype(np.int64)
    found = []
    for count in np.unique(steps).tolist():
        part = triangles[steps == count]
        u, v = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
        inner = u + v <= count
        weights = np.stack((u[inner], v[inner], count - u[inner] - v[inner]), axis=1) / count
        found.append(np.einsum("wk,tki->twi", weights, part).reshape(-1, 3))
    return np.concatenate(found)
