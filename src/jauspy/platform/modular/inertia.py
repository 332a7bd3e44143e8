"""Mass, centre of mass and moments of inertia of parts, computed from their solids."""

from __future__ import annotations

from collections.abc import Iterable

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import Vector, add, difference, dot, product, scaled, transposed
from jauspy.platform.modular.parts import Inertia, PartType, Shape, Solid

Moments = tuple[Vector, Vector, Vector]

_NONE: Moments = ((0.0, 0.0, 0.0),) * 3


def inertia(solids: Iterable[Solid]) -> Inertia:
    """The inertia of solids together, in the frame that their poses are given in; zero mass without solids."""
    return combined((_of_solid(solid), solid.pose) for solid in solids)


def combined(bodies: Iterable[tuple[Inertia, Transform]]) -> Inertia:
    """The inertia of rigidly connected bodies; with each, the pose of its frame in the common one."""
    rows = [(body, pose.apply(body.center), pose) for body, pose in bodies]
    mass = sum(body.mass for body, _, _ in rows)
    if mass <= 0.0:
        return Inertia(0.0, (0.0, 0.0, 0.0), _NONE)
    center: Vector = (0.0, 0.0, 0.0)
    for body, middle, _ in rows:
        center = add(center, scaled(middle, body.mass / mass))
    moments = _NONE
    for body, middle, pose in rows:
        own = product(product(pose.rotation, body.moments), transposed(pose.rotation))
        moments = _sum(_sum(moments, own), _of_point(body.mass, difference(middle, center)))
    return Inertia(mass, center, moments)


def body_inertia(part: PartType) -> Inertia:
    """Of a part; of a servo, its housing without the output link."""
    return inertia(part.solids)


def output_inertia(part: PartType) -> Inertia:
    """Of the output link of a servo, in its frame, without the rotor; zero for other parts."""
    return inertia(part.servo.output if part.servo is not None else ())


def _of_solid(solid: Solid) -> Inertia:
    x, y, z = solid.size
    if solid.shape is Shape.CUBOID:
        squares = (y * y + z * z) / 12.0, (x * x + z * z) / 12.0, (x * x + y * y) / 12.0
    else:
        across = (3.0 * x * x + z * z) / 12.0
        squares = across, across, x * x / 2.0
    a, b, c = scaled(squares, solid.mass)
    return Inertia(solid.mass, IDENTITY.position, ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c)))


def _of_point(mass: float, at: Vector) -> Moments:
    """Of a point mass: m (r.r I - r r^T)."""
    square = dot(at, at)
    x, y, z = at
    return (
        (mass * (square - x * x), -mass * x * y, -mass * x * z),
        (-mass * x * y, mass * (square - y * y), -mass * y * z),
        (-mass * x * z, -mass * y * z, mass * (square - z * z)),
    )


def _sum(a: Moments, b: Moments) -> Moments:
    return add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2])
