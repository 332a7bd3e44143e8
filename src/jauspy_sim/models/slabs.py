"""Divides a mesh that does not move into convex pieces, so that a room does not collide as one solid block."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]

SLAB: Final = 0.02
"""Metres: thickness of the slabs behind the faces of a piece that is not convex."""

CONVEX: Final = 0.002
"""Metres by which a vertex may be above a face of a piece that counts as convex."""

LEAST_AREA: Final = 1e-12
"""Square metres of a face, doubled; smaller ones have no direction."""

MAX_CHECKS: Final = 4_000_000
"""Pairs of faces and vertices that are compared at once."""


def convex_pieces(vertices: Points, faces: NDArray[np.int32], most: int) -> list[Points] | None:
    """The corners of convex pieces: connected parts that are convex, and slabs behind the faces of others.

    None if there would be more than `most`. Faces without an area count for nothing.
    """
    _, first, welded = np.unique(np.round(vertices, 6), axis=0, return_index=True, return_inverse=True)
    welded_faces = first[welded.reshape(-1)[faces]]
    welded_faces = welded_faces[np.linalg.norm(_doubled_areas(vertices, welded_faces), axis=1) > LEAST_AREA]
    if not len(welded_faces):
        return []
    labels = _components(welded_faces)
    pieces: list[Points] = []
    for label in np.unique(labels):
        part = welded_faces[labels == label]
        corners = vertices[np.unique(part)]
        if _is_convex(vertices, part, corners):
            pieces.append(corners)
        elif len(pieces) + len(part) // 2 > most:
            return None
        else:
            pieces += _slabs(vertices, part)
        if len(pieces) > most:
            return None
    return pieces


def _components(faces: NDArray[np.int64]) -> NDArray[np.int64]:
    """A label for each face; faces that share vertices, directly or by others, have the same."""
    labels = np.arange(int(faces.max()) + 1)
    while True:
        least = labels[faces].min(axis=1)
        before = labels.copy()
        for corner in range(3):
            np.minimum.at(labels, faces[:, corner], least)
        labels = labels[labels]
        if (labels == before).all():
            found: NDArray[np.int64] = labels[faces[:, 0]]
            return found


def _is_convex(vertices: Points, faces: NDArray[np.int32], corners: Points) -> bool:
    if len(faces) * len(corners) > MAX_CHECKS:
        return False
    a, normals = vertices[faces[:, 0]], _normals(vertices, faces)
    heights = corners @ normals.T - np.sum(a * normals, axis=1)
    inside_out = heights.min() > -CONVEX and _is_closed(faces)  # an open one is a room, seen from inside
    return bool(heights.max() < CONVEX or inside_out)


def _is_closed(faces: NDArray[np.int32]) -> bool:
    edges = np.concatenate([faces[:, (0, 1)], faces[:, (1, 2)], faces[:, (2, 0)]])
    _, counts = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    return bool((counts > 1).all())


def _normals(vertices: Points, faces: NDArray[np.int32]) -> Points:
    areas = _doubled_areas(vertices, faces)
    found: Points = areas / np.linalg.norm(areas, axis=1, keepdims=True)
    return found


def _doubled_areas(vertices: Points, faces: NDArray[np.integer[Any]]) -> Points:
    """Vectors along the normals of the faces, whose lengths are twice their areas, m^2."""
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    found: Points = np.cross(b - a, c - a)
    return found


def _slabs(vertices: Points, faces: NDArray[np.int32]) -> Iterator[Points]:
    """The corners of a slab behind each face; two triangles that make a flat convex quadrilateral have one."""
    normals = _normals(vertices, faces)
    beside: dict[tuple[int, int], int] = {}
    for number, face in enumerate(faces.tolist()):
        for one, other in ((0, 1), (1, 2), (2, 0)):
            beside[face[one], face[other]] = number
    used = np.zeros(len(faces), bool)
    for number, face in enumerate(faces.tolist()):
        if used[number]:
            continue
        used[number] = True
        candidates = [(beside.get((face[(edge + 1) % 3], face[edge])), edge) for edge in range(3)]
        flat = [
            (other, edge)
            for other, edge in candidates
            if other is not None and not used[other] and normals[other] @ normals[number] > 0.9999
        ]
        outline = face
        for other, edge in flat:
            if (wider := _with_neighbour(vertices, faces[other].tolist(), face, edge, normals[number])) is not None:
                outline, used[other] = wider, True
                break
        corners = vertices[outline]
        yield np.concatenate([corners, corners - SLAB * normals[number]])


def _with_neighbour(vertices: Points, other: list[int], face: list[int], at: int, normal: Points) -> list[int] | None:
    """The outline of a face and of one beside it, at the edge that begins at corner `at`; None if it is not convex."""
    one, two, three = face[at], face[(at + 1) % 3], face[(at + 2) % 3]
    apex = [corner for corner in other if corner not in (one, two)]
    if len(apex) != 1:
        return None
    outline = [one, apex[0], two, three]
    return outline if _turns_one_way(vertices[outline], normal) else None


def _turns_one_way(outline: Points, normal: Points) -> bool:
    edges = np.roll(outline, -1, axis=0) - outline
    turns = np.cross(edges, np.roll(edges, -1, axis=0)) @ normal
    return bool((turns > 0.0).all() or (turns < 0.0).all())
