"""Vectors of three numbers, and rigid transforms."""

from __future__ import annotations

import math
from typing import Final, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Rotation: TypeAlias = tuple[Vector, Vector, Vector]
"""Rows of a rotation matrix."""

X: Final[Vector] = (1.0, 0.0, 0.0)
Y: Final[Vector] = (0.0, 1.0, 0.0)
Z: Final[Vector] = (0.0, 0.0, 1.0)


def add(a: Vector, b: Vector) -> Vector:
    """A + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """A vector that is so much longer."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def difference(a: Vector, b: Vector) -> Vector:
    """From b to a."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def rotated(rotation_from_quaternion: Rotation, a: Vector) -> Vector:
    """A vector after a rotation."""
    return dot(rotation_from_quaternion[0], a), dot(rotation_from_quaternion[1], a), dot(rotation_from_quaternion[2], a)


def transposed(rotation_from_quaternion: Rotation) -> Rotation:
    """The inverse of a rotation; columns as rows."""
    a, b, c = rotation_from_quaternion
    return (a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2])


def rotation_about(axis: Vector, angle: float) -> Rotation:
    """The rotation about an axis of unit length, in radians."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    t = 1.0 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def quaternion(rotation_from_quaternion: Rotation) -> tuple[float, float, float, float]:
    """d, a, b, c of a rotation; d is not negative."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation_from_quaternion
    # four times the squares of d, a, b, c; the largest is the safest to divide by
    squares = (1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz)
    rows = (
        (squares[0], zy - yz, xz - zx, yx - xy),
        (zy - yz, squares[1], yx + xy, xz + zx),
        (xz - zx, yx + xy, squares[2], zy + yz),
        (yx - xy, xz + zx, zy + yz, squares[3]),
    )
    row = rows[squares.index(max(squares))]
    length = math.copysign(math.hypot(*row), row[0] or 1.0)
    d, a, b, c = (part / length for part in row)
    return d, a, b, c


def rotation_from_quaternion(d: float, a: float, b: float, c: float) -> Rotation:
    """The rotation of a quaternion, which need not be of unit length; zero is no rotation."""
    square = d * d + a * a + b * b + c * c
    s = 2.0 / square if square else 0.0
    columns = (
        (1.0 - s * (b * b + c * c), s * (a * b + c * d), s * (a * c - b * d)),
        (s * (a * b - c * d), 1.0 - s * (a * a + c * c), s * (b * c + a * d)),
        (s * (a * c + b * d), s * (b * c - a * d), 1.0 - s * (a * a + b * b)),
    )
    return transposed(columns)
