"""Unit quaternions as JAUS writes them: a scalar d, and a vector a, b, c."""

from __future__ import annotations

import math

from jauspy.geometry.vectors import Rotation, transposed


def quaternion(rotation: Rotation) -> tuple[float, float, float, float]:
    """d, a, b, c of a rotation; d is not negative."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
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


def rotation(d: float, a: float, b: float, c: float) -> Rotation:
    """The rotation of a quaternion, which need not be of unit length; zero is no rotation."""
    square = d * d + a * a + b * b + c * c
    s = 2.0 / square if square else 0.0
    columns = (
        (1.0 - s * (b * b + c * c), s * (a * b + c * d), s * (a * c - b * d)),
        (s * (a * b - c * d), 1.0 - s * (a * a + c * c), s * (b * c + a * d)),
        (s * (a * c + b * d), s * (b * c - a * d), 1.0 - s * (a * a + b * b)),
    )
    return transposed(columns)
