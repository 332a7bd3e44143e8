"""The parked car of `street`: a hatchback, hollow, with a door that swings. Frame: x forward, y left, on the ground."""

from __future__ import annotations

import itertools
import math
from functools import cache
from typing import Final

import numpy as np

from .scene import Part
from .shapes import Array, Mesh, Vector, box, cylinder, joined, lathe, picture, ring, tube
from .solids import Field, block, outline, smooth_max, smooth_min, solid, union

STEP: Final = 0.017
"""Metres between samples."""
SHELL: Final = 0.065
"""Metres: how thick the body is."""

SILHOUETTE: Final = np.array(
    [
        (2.00, 0.24),
        (2.05, 0.40),
        (2.03, 0.56),
        (1.90, 0.70),
        (1.55, 0.82),
        (1.02, 0.93),
        (0.35, 1.37),
        (0.05, 1.45),
        (-0.55, 1.475),
        (-1.20, 1.43),
        (-1.55, 1.36),
        (-1.86, 0.98),
        (-1.97, 0.90),
        (-2.01, 0.62),
        (-1.98, 0.30),
        (-1.85, 0.22),
        (-0.4, 0.19),
        (1.8, 0.19),
    ]
)
FRONT_WINDOW: Final = np.array([(0.78, 0.955), (0.27, 1.272), (0.03, 1.332), (-0.22, 1.345), (-0.23, 0.955)])
REAR_WINDOW: Final = np.array(
    [(-0.33, 0.955), (-0.33, 1.345), (-0.75, 1.35), (-1.12, 1.315), (-1.34, 1.10), (-1.28, 0.97)]
)
DOOR: Final = np.array([(0.90, 0.31), (0.93, 0.90), (0.30, 1.315), (0.03, 1.375), (-0.27, 1.39), (-0.28, 0.31)])
REAR_DOOR: Final = np.array(
    [(-0.29, 0.31), (-0.28, 1.39), (-0.75, 1.395), (-1.18, 1.35), (-1.39, 1.09), (-1.08, 0.72), (-0.92, 0.30)]
)
WHEELS: Final = (1.24, -1.24)
RADIUS: Final = 0.30
HINGE: Final[Vector] = (0.90, 0.78, 0.0)


def _half_width(x: Array, z: Array) -> Array:
    """Half the width of the body at a height, less towards the ends and the roof."""
    sides = 0.855 - 0.30 * np.clip((z - 0.86) / 0.60, 0.0, 1.0) ** 1.1 - 0.05 * np.clip((0.45 - z) / 0.25, 0.0, 1.0)
    ends = 0.17 * np.clip((np.abs(x) - 1.15) / 0.9, 0.0, 1.3) ** 2.2
    shoulder = 0.018 * np.exp(-(((z - 0.80) / 0.07) ** 2))
    return sides - ends + shoulder


def _hull(x: Array, y: Array, z: Array, shrink: float = 0.0) -> Array:
    return smooth_max(outline(SILHOUETTE, x, z) + shrink, np.abs(y) - _half_width(x, z) + shrink, 0.10)


def _windows(x: Array, y: Array, z: Array) -> Array:
    """Where there is glass instead of sheet metal, as a region of space."""
    sides = np.maximum(np.minimum(outline(FRONT_WINDOW, x, z), outline(REAR_WINDOW, x, z)) - 0.01, 0.40 - np.abs(y))
    across = _half_width(x, z) - 0.105
    front = np.maximum(np.maximum(np.abs(y) - across, 0.30 - x), np.maximum(0.975 - z, z - 1.375))
    back = np.maximum(np.maximum(np.abs(y) - across, x + 1.50), np.maximum(1.03 - z, z - 1.33))
    return np.minimum(sides, np.minimum(front, back))


def _shell(x: Array, y: Array, z: Array) -> Array:
    hollow = np.maximum(_hull(x, y, z, SHELL), np.maximum(0.36 - z, np.maximum(x - 0.98, -1.80 - x)))
    made = smooth_max(_hull(x, y, z), -hollow, 0.01)
    made = np.maximum(made, -_windows(x, y, z))
    for at in WHEELS:
        arch = np.maximum(np.hypot(x - at, z - RADIUS) - 0.375, 0.56 - np.abs(y))
        made = smooth_max(made, -arch, 0.02)
    return made


def _door_region(x: Array, y: Array, z: Array) -> Array:
    return np.maximum(outline(DOOR, x, z), _half_width(x, z) - 0.095 - y)


def _body(x: Array, y: Array, z: Array) -> Array:
    return np.maximum(_shell(x, y, z), -_door_region(x, y, z))


def _door(x: Array, y: Array, z: Array) -> Array:
    return np.maximum(np.maximum(_shell(x, y, z), _door_region(x, y, z) + 0.007), _hull(x, y, z, 0.0) - 1.0)


def _on_side(x: float, z: float) -> float:
    """The y of the left side there."""
    low, high = 0.2, 1.0
    for _ in range(30):
        middle = (low + high) / 2.0
        inside = _hull(np.array(x), np.array(middle), np.array(z)) < 0.0
        low, high = (middle, high) if inside else (low, middle)
    return low


def _seam(points: Array, *, side: float) -> Mesh:
    """A dark line on the side of the body along an open polygon."""
    path = []
    for (ax, az), (bx, bz) in itertools.pairwise(points):
        for t in np.arange(0.0, 1.0, 0.05 / math.hypot(bx - ax, bz - az)):
            x, z = ax + t * (bx - ax), az + t * (bz - az)
            path.append((x, side * (_on_side(x, z) - 0.002), z))
    return tube(path, 0.005, 4)


def _glass(region: Field) -> Mesh:
    """The outer sheet of the windows in a region, just inside of the body."""

    def thick(x: Array, y: Array, z: Array) -> Array:
        inside = np.maximum(_hull(x, y, z, 0.015), -_hull(x, y, z, 0.06))
        return np.maximum(np.maximum(inside, _windows(x, y, z) - 0.012), region(x, y, z))

    mesh = solid(thick, (-2.1, -0.9, 0.9), (2.1, 0.9, 1.5), 0.02, 1600)
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    across, middle = np.cross(b - a, c - a), (a + b + c) / 3.0
    outer = np.abs(_hull(middle[:, 0], middle[:, 1], middle[:, 2], 0.015)) < 0.012
    steep = np.linalg.norm(across, axis=1) > 0.0
    return Mesh(mesh.vertices, mesh.triangles[outer & steep])


def wheel() -> dict[str, Mesh]:
    """A wheel about y, its outer side to the left."""
    w = 0.095
    tyre = lathe(
        [
            (0.20, -w),
            (0.275, -w),
            (0.296, -w * 0.8),
            (RADIUS, -w * 0.5),
            (RADIUS, w * 0.5),
            (0.296, w * 0.8),
            (0.275, w),
            (0.215, w),
            (0.205, w - 0.02),
        ],
        28,
    )
    dish = lathe([(0.205, w - 0.02), (0.19, w - 0.03), (0.165, w - 0.05), (0.0, w - 0.05)], 28)
    spokes = []
    for number in range(5):
        turn = math.tau * number / 5.0
        spoke = box(0.155, 0.045, 0.02, 0.006).at(0.105, 0.0, w - 0.028)
        spokes.append(spoke.at(rpy=(0.0, 0.0, turn)))
    hub = cylinder(w - 0.05, w - 0.012, 0.035, 0.006, 14)
    rim = lathe([(0.205, w - 0.02), (0.208, w - 0.008), (0.198, w - 0.006), (0.185, w - 0.03)], 28)
    turned = {"rubber": tyre, "plastic": dish, "steel": joined([*spokes, hub, rim])}
    return {material: mesh.at(rpy=(-math.pi / 2.0, 0.0, 0.0)) for material, mesh in turned.items()}


def seat(width: float) -> Mesh:
    """A seat with a head rest, its middle on the floor."""
    cushion = block((0.50, width, 0.16), 0.06, (0.0, 0.0, 0.22))
    back = block((0.15, width - 0.02, 0.60), 0.06, (0.0, 0.0, 0.0))

    def tilted(x: Array, y: Array, z: Array) -> Array:
        c, s = math.cos(0.30), math.sin(0.30)
        dx, dz = x + 0.31, z - 0.52
        return smooth_min(back(c * dx + s * dz, y, -s * dx + c * dz), head(c * dx + s * dz, y, -s * dx + c * dz), 0.0)

    head = block((0.09, min(width, 0.26), 0.16), 0.045, (0.0, 0.0, 0.40))
    return solid(union(cushion, tilted, soft=0.05), (-0.65, -width / 2.0, 0.1), (0.3, width / 2.0, 1.05), 0.03, 700)


@cache
def meshes() -> tuple[dict[str, Mesh], dict[str, Mesh]]:
    """Of the body and of the door, by material; the door's in the frame of the car."""
    low, high = (-2.1, -0.95, 0.1), (2.15, 0.95, 1.55)
    everywhere: Field = lambda x, y, z: -_door_region(x, y, z) + 0.004  # noqa: E731 - a field like any other
    body = {"paint_blue": solid(_body, low, high, STEP, 9000), "glass": _glass(everywhere)}
    door = {"paint_blue": solid(_door, (-0.4, 0.4, 0.2), (1.0, 0.95, 1.5), STEP, 1600), "glass": _glass(_door_region)}

    wheels: dict[str, list[Mesh]] = {"rubber": [], "plastic": [], "steel": []}
    for x in WHEELS:
        for side in (1.0, -1.0):
            for material, mesh in wheel().items():
                turned = mesh if side > 0.0 else mesh.at(rpy=(0.0, 0.0, math.pi))
                wheels[material].append(turned.at(x, side * 0.735, RADIUS))
    arches = []
    for x in WHEELS:
        turns = np.linspace(-0.12, math.pi + 0.12, 16)
        for side in (1.0, -1.0):
            path = [
                (x + 0.38 * math.cos(a), side * (_on_side(x, 0.6) - 0.012), RADIUS + 0.38 * math.sin(a)) for a in turns
            ]
            arches.append(tube(path, 0.017, 6))
    seams = [_seam(np.vstack([DOOR, DOOR[:1]]), side=-1.0)]
    seams += [_seam(np.vstack([REAR_DOOR, REAR_DOOR[:1]]), side=side) for side in (1.0, -1.0)]
    bumpers = [
        solid(
            lambda x, y, z: np.maximum(
                _hull(x, y, z, -0.012), np.maximum(np.maximum(1.86 - np.abs(x), z - 0.46), 0.26 - z)
            ),
            (-2.1, -0.9, 0.2),
            (2.15, 0.9, 0.55),
            STEP,
            900,
        ),
        box(0.05, 1.0, 0.09, 0.01).at(2.015, 0.0, 0.62),
        box(2.1, 1.3, 0.08).at(0.0, 0.0, 0.22),
    ]
    inside = [
        seat(0.50).at(0.02, 0.36, 0.30),
        seat(0.50).at(0.02, -0.36, 0.30),
        seat(1.22).at(-0.95, 0.0, 0.32),
    ]
    dash = solid(block((0.42, 1.36, 0.26), 0.10, (0.78, 0.0, 0.80)), (0.5, -0.75, 0.6), (1.05, 0.75, 1.0), 0.03, 300)
    lining = [
        dash,
        ring(0.175, 0.015, 20, 6).at(0.50, 0.36, 0.86, rpy=(0.0, -1.15, 0.0)),
        box(0.34, 0.03, 0.05, 0.01).at(0.50, 0.36, 0.86, rpy=(math.pi / 2.0, -1.15, 0.0)),
        box(0.08, 0.07, 0.05, 0.01).at(0.56, 0.36, 0.83, rpy=(0.0, -1.15, 0.0)),
        box(0.70, 0.22, 0.26, 0.03).at(0.20, 0.0, 0.45),
        tube([(0.25, 0.0, 0.56), (0.23, 0.0, 0.70)], 0.018, 6),
        box(2.70, 1.30, 0.02).at(-0.42, 0.0, 0.365),
    ]
    mirror = solid(
        block((0.11, 0.19, 0.13), 0.045, (0.62, 0.0, 0.0)), (0.5, -0.12, -0.1), (0.75, 0.12, 0.1), 0.016, 220
    )
    handles = [
        box(0.16, 0.03, 0.028, 0.008).at(-0.82, side * (_on_side(-0.82, 0.84) + 0.006), 0.84) for side in (1.0, -1.0)
    ]
    handles.append(box(0.16, 0.03, 0.028, 0.008).at(-0.16, -_on_side(-0.16, 0.84) - 0.006, 0.84))
    lamp = block((0.34, 0.30, 0.15), 0.06)
    front_lamp = solid(
        lambda x, y, z: smooth_max(lamp(x - 1.88, np.abs(y) - 0.58, z - 0.655), _hull(x, y, z, -0.006), 0.01),
        (1.6, -0.85, 0.5),
        (2.1, 0.85, 0.8),
        0.018,
        500,
    )
    tail = block((0.22, 0.16, 0.30), 0.05)
    rear_lamp = solid(
        lambda x, y, z: smooth_max(tail(x + 1.93, np.abs(y) - 0.66, z - 0.82), _hull(x, y, z, -0.008), 0.01),
        (-2.1, -0.85, 0.6),
        (-1.7, 0.85, 1.0),
        0.018,
        500,
    )
    body |= {
        "rubber": joined([*wheels["rubber"], *arches, *seams]),
        "plastic": joined([*wheels["plastic"], *bumpers, *lining, mirror.at(0.05, -0.90, 0.98)]),
        "steel": joined(wheels["steel"]),
        "fabric_uv": joined(inside),
        "lamp": front_lamp,
        "paint_red": rear_lamp,
        "trim": joined(handles),
        "plate": joined(
            [
                picture(0.52, 0.11).at(2.062, 0.0, 0.40, rpy=(0.0, 0.0, math.pi / 2.0)),
                picture(0.52, 0.11).at(-2.022, 0.0, 0.66, rpy=(0.0, 0.0, -math.pi / 2.0)),
            ]
        ),
    }
    inner = solid(
        lambda x, y, z: np.maximum(
            np.maximum(_hull(x, y, z, SHELL - 0.006), 0.36 - z),
            np.maximum(z - 0.93, np.maximum(np.abs(x - 0.31) - 0.54, 0.66 - y)),
        ),
        (-0.3, 0.5, 0.3),
        (0.95, 0.95, 1.0),
        0.02,
        300,
    )
    door |= {
        "plastic": joined([inner, mirror.at(0.05, 0.90, 0.98), box(0.30, 0.05, 0.04, 0.01).at(0.20, 0.69, 0.70)]),
        "trim": box(0.16, 0.03, 0.028, 0.008).at(-0.16, _on_side(-0.16, 0.84) + 0.006, 0.84),
    }
    return body, door


def add_car(world: Part, at: Vector, yaw: float, opened: float) -> None:
    """A car that does not move, and its driver's door, `opened` so far (degrees)."""
    body, door = meshes()
    car = world.body("car", at, free=False, euler=(0.0, 0.0, yaw))
    for material, mesh in body.items():
        car.see(material, mesh)
    for size, where in (
        ((0.95, 1.55, 0.44), (1.47, 0.0, 0.56)),  # engine
        ((0.12, 1.45, 0.50), (1.97, 0.0, 0.44)),
        ((2.75, 1.40, 0.16), (-0.40, 0.0, 0.28)),  # floor
        ((0.40, 1.60, 0.62), (-1.78, 0.0, 0.60)),  # tail
        ((1.60, 1.06, 0.05), (-0.60, 0.0, 1.44)),  # roof
        ((0.40, 1.36, 0.26), (0.78, 0.0, 0.80)),  # dash board
        ((1.45, 0.10, 0.60), (-1.00, 0.78, 0.62)),  # rear doors
        ((2.40, 0.10, 0.60), (-0.30, -0.78, 0.62)),
        ((0.50, 0.50, 0.18), (0.02, 0.36, 0.50)),  # seats
        ((0.50, 0.50, 0.18), (0.02, -0.36, 0.50)),
        ((0.50, 1.22, 0.18), (-0.95, 0.0, 0.52)),
        ((0.14, 0.46, 0.70), (-0.32, 0.36, 0.86)),
        ((0.14, 0.46, 0.70), (-0.32, -0.36, 0.86)),
        ((0.14, 1.20, 0.60), (-1.30, 0.0, 0.85)),
    ):
        car.box(size, where)
    for side in (1.0, -1.0):
        car.capsule(0.04, (0.92, side * 0.74, 0.95), (0.30, side * 0.62, 1.38))
        car.capsule(0.04, (-0.30, side * 0.78, 0.92), (-0.30, side * 0.60, 1.40))
        car.capsule(0.05, (-1.75, side * 0.68, 0.95), (-1.40, side * 0.56, 1.38))
        for x in WHEELS:
            car.cylinder(RADIUS, (x, side * 0.64, RADIUS), (x, side * 0.83, RADIUS))
    leaf = car.body("car_door", HINGE, free=False, euler=(0.0, 0.0, -opened))
    leaf.add(
        "joint",
        name="car_door",
        type="hinge",
        axis=[0, 0, -1],
        range_=[-opened, 68.0 - opened],
        damping=3.0,
        frictionloss=2.0,
        armature=0.1,
    )
    hx, hy, _ = HINGE
    for material, mesh in door.items():
        leaf.see(material, mesh.at(-hx, -hy))
    leaf.box((1.10, 0.09, 0.62), (-0.57, 0.0, 0.62), mass=22.0)
    leaf.capsule(0.02, (-1.14, -0.02, 0.92), (-1.16, -0.16, 1.38), mass=1.0)
    leaf.capsule(0.02, (-0.02, -0.02, 0.92), (-0.58, -0.13, 1.34), mass=1.0)
    leaf.box((0.11, 0.19, 0.13), (-0.23, 0.13, 0.98), mass=1.0)
