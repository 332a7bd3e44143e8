"""Trees and bushes: a trunk with branches, and leaves of two greens around a rough core."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial import ConvexHull

from .shapes import Mesh, Vector, foliage, joined, tube


def tree(at: Vector, seed: int, *, finer: float = 1.0) -> tuple[dict[str, Mesh], float]:
    """What is seen of a tree, by its materials, and the height of its trunk above `at`, m; leaves may be `finer`."""
    x, y, z = at
    random = np.random.default_rng(seed)
    height = random.uniform(2.5, 3.0)
    wood = [tube([(x, y, z - 0.1), (x + 0.02, y, z + 1.2), (x - 0.04, y + 0.03, z + height)], 0.11, 10)]
    for turn in random.uniform(0.0, math.tau, 5):
        tip = (x + 0.9 * math.cos(turn), y + 0.9 * math.sin(turn), z + height + random.uniform(0.3, 1.0))
        wood.append(tube([(x, y, z + height - random.uniform(0.1, 0.9)), tip], 0.035, 6))
    middle = (x, y, z + height + 0.75)
    core = [_leafage(random).scaled(0.75, 0.75, 0.6).at(*middle, rpy=tuple(random.uniform(0, 6, 3))) for _ in range(4)]
    look = {
        "bark": joined(wood),
        "leaves": joined(
            [*core, foliage(random, round(420 * finer**2), 0.13 / finer).scaled(1.3, 1.3, 1.1).at(*middle)]
        ),
        "leaves_light": foliage(random, round(260 * finer**2), 0.13 / finer).scaled(1.35, 1.35, 1.15).at(*middle),
    }
    return look, height


def bush(seed: int, size: Vector) -> dict[str, Mesh]:
    """A bush on z = 0 of about that length, width and height."""
    random = np.random.default_rng(seed)
    x, y, z = size[0] / 2.0, size[1] / 2.0, size[2] / 2.0
    core = [_leafage(random).scaled(0.75 * x, 0.75 * y, 0.8 * z).at(0.0, 0.0, 0.9 * z) for _ in range(2)]
    return {
        "leaves": joined([*core, foliage(random, 170, 0.09 / max(x, z)).scaled(x, y, z).at(0.0, 0.0, z)]),
        "leaves_light": foliage(random, 110, 0.09 / max(x, z)).scaled(1.04 * x, 1.04 * y, 1.04 * z).at(0.0, 0.0, z),
    }


def _leafage(random: np.random.Generator) -> Mesh:
    """A rough ball of 80 triangles, shaded flat."""
    golden = (1 + math.sqrt(5)) / 2
    points = np.array([(s * 1.0, t * golden, 0.0) for s in (-1, 1) for t in (-1, 1)])
    points = np.concatenate([points, np.roll(points, 1, axis=1), np.roll(points, 2, axis=1)])
    points /= np.linalg.norm(points, axis=1)[:, None]
    points *= random.uniform(0.7, 1.25, len(points))[:, None]
    hull = ConvexHull(points)
    faces = []
    for simplex, equation in zip(hull.simplices, hull.equations, strict=True):
        a, b, c = points[simplex]
        flip = float(np.cross(b - a, c - a) @ equation[:3]) < 0.0
        faces.append(simplex[::-1] if flip else simplex)
    return Mesh(points, np.array(faces)).flat()
