"""Vectors of three numbers, rotation matrices, and unit quaternions."""

from __future__ import annotations

import math
from typing import Final, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Rotation: TypeAlias = tuple[Vector, Vector, Vector]
"""The rows of a 3 x 3 rotation matrix."""
Quaternion: TypeAlias = tuple[float, float, float, float]
"""Quaternion as JAUS writes it: scalar d, then the vector a, b, c."""

X: Final[Vector] = (1.0, 0.0, 0.0)
Y: Final[Vector] = (0.0, 1.0, 0.0)
Z: Final[Vector] = (0.0, 0.0, 1.0)

GRAVITY: Final = 9.81
"""Acceleration of gravity, m/s^2; that of the simulator too."""


def add(a: Vector, b: Vector) -> Vector:
    """`a + b`."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def difference(a: Vector, b: Vector) -> Vector:
    """`a - b`."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """`a * factor`."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def rotated(rotation: Rotation, a: Vector) -> Vector:
    """Matrix times vector."""
    # written out, as in `product`, since both run thousands of times a second
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    x, y, z = a
    return xx * x + xy * y + xz * z, yx * x + yy * y + yz * z, zx * x + zy * y + zz * z


def product(a: Rotation, b: Rotation) -> Rotation:
    """Matrix times matrix."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = b
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = a
    return (
        (ax * xx + ay * yx + az * zx, ax * xy + ay * yy + az * zy, ax * xz + ay * yz + az * zz),
        (bx * xx + by * yx + bz * zx, bx * xy + by * yy + bz * zy, bx * xz + by * yz + bz * zz),
        (cx * xx + cy * yx + cz * zx, cx * xy + cy * yy + cz * zy, cx * xz + cy * yz + cz * zz),
    )


def transposed(rotation: Rotation) -> Rotation:
    """The transpose, which is the inverse of a rotation."""
    a, b, c = rotation
    return (a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2])


def rotation_about(axis: Vector, angle: float) -> Rotation:
    """The rotation by an angle in radians about an axis of unit length."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    t = 1.0 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def quaternion(rotation: Rotation) -> Quaternion:
    """The unit quaternion of a rotation; d is not negative."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    # four times the squares of d, a, b, c; dividing by the largest loses the fewest digits
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
    """The rotation of a quaternion, which need not be of unit length; zero gives the identity."""
    square = d * d + a * a + b * b + c * c
    s = 2.0 / square if square else 0.0
    columns = (
        (1.0 - s * (b * b + c * c), s * (a * b + c * d), s * (a * c - b * d)),
        (s * (a * b - c * d), 1.0 - s * (a * a + c * c), s * (b * c + a * d)),
        (s * (a * c + b * d), s * (b * c - a * d), 1.0 - s * (a * a + b * b)),
    )
    return transposed(columns)
