"""Paint on the robot: name, emblem and warning stripes, a fifth of a millimetre thick."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
import shapely

from mesh_shapes import Array, Mesh, Point, extruded, joined
from robot_parts.dimensions import Look

THICKNESS: Final = 0.0006

STROKES: Final[dict[str, tuple[tuple[Point, ...], ...]]] = {
    "I": (((0.2, 0.0), (0.2, 1.0)),),
    "N": (((0.0, 0.0), (0.0, 1.0), (0.6, 0.0), (0.6, 1.0)),),
    "C": (((0.6, 0.82), (0.42, 1.0), (0.18, 1.0), (0.0, 0.82), (0.0, 0.18), (0.18, 0.0), (0.42, 0.0), (0.6, 0.18)),),
    "1": (((0.02, 0.74), (0.28, 1.0), (0.28, 0.0)), ((0.02, 0.0), (0.54, 0.0))),
}
"""Lines of letters of height 1."""
WIDTHS: Final = {"I": 0.4, "N": 0.6, "C": 0.6, "1": 0.54, " ": 0.25}

LEFT: Final = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""Turns what one reads along x, y up, to the left side of the robot."""
RIGHT: Final = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def _mesh(shape: shapely.Geometry) -> Mesh:
    """Polygons with a thickness, from z = 0."""
    parts = getattr(shape, "geoms", [shape])
    return joined(extruded(shapely.geometry.polygon.orient(part), 0.0, THICKNESS) for part in parts)


def lettering(text: str, height: float) -> tuple[Mesh, float]:
    """The text from x = 0 on the line y = 0, and its width."""
    x, lines = 0.0, []
    for letter in text:
        for points in STROKES.get(letter, ()):
            line = shapely.LineString([(x + px, py) for px, py in points])
            lines.append(line.buffer(0.085, cap_style="flat", join_style="mitre", mitre_limit=1.5))
        x += WIDTHS[letter] + 0.34
    shape = shapely.affinity.scale(shapely.unary_union(lines), height, height, origin=(0.0, 0.0))
    return _mesh(shape), height * (x - 0.34)


def emblem(radius: float) -> Mesh:
    """A track link with an arrowhead in it: the emblem of jauspy's robots."""
    corners = [(radius * math.cos(a), radius * math.sin(a)) for a in np.radians(range(0, 360, 60))]
    ring = shapely.Polygon(corners).difference(shapely.affinity.scale(shapely.Polygon(corners), 0.78, 0.78))
    arrow = shapely.LineString([(-0.30, -0.42), (0.22, 0.0), (-0.30, 0.42)]).buffer(
        0.13, cap_style="flat", join_style="mitre"
    )
    return _mesh(shapely.unary_union([ring, shapely.affinity.scale(arrow, radius, radius, origin=(0.0, 0.0))]))


def stripes(width: float, height: float) -> Look:
    """A band of slanting stripes around the origin."""
    frame = shapely.box(-width / 2.0, -height / 2.0, width / 2.0, height / 2.0)
    step = 0.030
    slanted = [
        shapely.Polygon(
            [(-width, y), (width, y + 2.0 * width), (width, y + 2.0 * width + step / 2.0), (-width, y + step / 2.0)]
        )
        for y in np.arange(-height / 2.0 - 3.0 * width, height / 2.0 + width, step)
    ]
    bright = frame.intersection(shapely.unary_union(slanted))
    return {"amber": _mesh(bright), "black": _mesh(frame.difference(bright))}


def side(turn: Array, length: float, height: float) -> Look:
    """The paint on a plate of that size, around the origin; `turn` is LEFT or RIGHT."""
    text, wide = lettering("INC 1", 0.034)
    badge, gap = 0.021, 0.014
    start = -(wide + gap + 2.0 * badge) / 2.0
    marks = joined([emblem(badge).at(start + badge), text.at(start + 2.0 * badge + gap, -0.017)])
    band = stripes(0.036, height - 0.012)
    ends = {name: joined([mesh.at(-length / 2.0), mesh.at(length / 2.0)]) for name, mesh in band.items()}
    return {name: mesh.at(turn=turn) for name, mesh in {"marking": marks, **ends}.items()}
