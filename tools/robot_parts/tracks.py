"""Belts with treads, and what they run around: sprocket, idler, road wheels, and the plates that carry these."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from mesh_shapes import (
    FLIP,
    Y_UP,
    Array,
    Mesh,
    Point,
    Vector,
    across,
    circle,
    extruded,
    hexagons,
    joined,
    lathe,
    mirrored,
    pin,
    round_rectangle,
    screws,
    shaded,
    slot,
)
from robot_parts import decals
from robot_parts.dimensions import Dimensions, Look

TREAD = 0.007
"""Height of the treads."""
BELT = 0.006
"""Thickness of a belt without them."""
PITCH = 0.038
"""From tread to tread, about."""
ROAD_WHEEL = 0.030
OUTWARD = Y_UP
"""Turns what stands on z to the left side of the robot."""


PARTS = "lower", "front", "upper", "rear"
"""Of a loop."""


@dataclass(frozen=True)
class Running:
    """What moves with a belt: along x, or around a wheel whose middle is its origin."""

    look: Look
    origin: Vector
    """In the frame of the link."""
    pitch: float
    """Metres from tread to tread; 0 for what does not repeat."""
    radius: float
    """Of the belt around the wheel; 0 where it is straight."""
    backward: bool = False
    """Whether it moves backward when the robot drives forward."""


class Loop:
    """The closed way of a belt around two wheels, in x and z; it begins below the rear one and runs forward."""

    def __init__(self, rear: Point, front: Point, rear_radius: float, front_radius: float) -> None:
        self._rear, self._front = np.array(rear), np.array(front)
        self._radii = rear_radius, front_radius
        apart = self._front - self._rear
        distance = float(np.hypot(*apart))
        self._tilt = math.atan2(apart[1], apart[0])
        self._lean = math.acos((rear_radius - front_radius) / distance)
        straight = distance * math.sin(self._lean)
        self._parts = np.cumsum([0.0, straight, 2.0 * self._lean * front_radius, straight])
        self.length = float(self._parts[-1]) + 2.0 * (math.pi - self._lean) * rear_radius
        self.pitch = self.length / round(self.length / PITCH)

    def part(self, way: float) -> int:
        """The index in `PARTS` of where a way is."""
        return int(np.searchsorted(self._parts, way % self.length, side="right")) - 1

    def running(self, part: int, look: Look, pitch: float = 0.0) -> Running:
        """What moves with the belt on a part of it; around a wheel, in the frame of its middle."""
        straight = part % 2 == 0
        x, z = (0.0, 0.0) if straight else (self._front if part == 1 else self._rear).tolist()
        around = {name: mesh.at(-x, 0.0, -z) for name, mesh in look.items()}
        radius = 0.0 if straight else self._radii[part == 1]
        return Running(around, (x, 0.0, z), pitch, radius, backward=part == 0)

    def corners(self) -> Array:
        """Ways at which a strip needs edges: along the arcs each 15 degrees, and where these end."""
        (_, a, b, c), end = self._parts, self.length
        arcs = [np.linspace(start, stop, 13) for start, stop in ((a, b), (c, end))]
        found: Array = np.concatenate([[0.0], arcs[0], arcs[1][:-1]])
        return found

    def at(self, way: Array, height: Array) -> tuple[Array, Array]:
        """Points (x, z) at ways along the belt and heights above its line, and outward unit vectors there."""
        way = np.asarray(way) % self.length
        part = np.clip(np.searchsorted(self._parts, way, side="right") - 1, 0, 3)
        along = way - self._parts[part]
        rear, front = self._radii
        low, up = self._tilt - self._lean, self._tilt + self._lean
        angle = np.choose(part, [np.full_like(way, low), low + along / front, np.full_like(way, up), up + along / rear])
        outward = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        ahead = np.stack([-outward[:, 1], outward[:, 0]], axis=1)
        centre = np.where(((part == 0) | (part == 3))[:, None], self._rear, self._front)
        radius = np.where((part == 0) | (part == 3), rear, front)
        straight = np.where((part == 0) | (part == 2), along, 0.0)
        points = centre + outward * (radius + height)[:, None] + ahead * straight[:, None]
        return points, outward

    def bent(self, mesh: Mesh) -> Mesh:
        """A mesh along x, its outside up, laid around the loop."""
        points, outward = self.at(mesh.vertices[:, 0], mesh.vertices[:, 2])
        vertices = np.column_stack([points[:, 0], mesh.vertices[:, 1], points[:, 1]])
        ahead = np.stack([-outward[:, 1], outward[:, 0]], axis=1)
        normals = mesh.normals[:, [0]] * ahead + mesh.normals[:, [2]] * outward
        return Mesh(vertices, np.column_stack([normals[:, 0], mesh.normals[:, 1], normals[:, 1]]), mesh.triangles)


def strip(loop: Loop, section: Sequence[Point]) -> Mesh:
    """A closed strip along a loop; its section (y, height) runs around it counterclockwise, seen along x."""
    corners, count = loop.corners(), len(section)
    rings = []
    for y, height in section:
        points, _ = loop.at(corners, np.full(len(corners), height))
        rings.append(np.column_stack([points[:, 0], np.full(len(corners), y), points[:, 1]]))
    vertices = np.stack(rings, axis=1).reshape(-1, 3)
    triangles = []
    for number in range(len(corners)):
        after = (number + 1) % len(corners)
        for place in range(count):
            beside = (place + 1) % count
            a, b, c, d = number * count + place, number * count + beside, after * count + beside, after * count + place
            triangles += [(a, c, b), (a, d, c)]
    return shaded(vertices, np.array(triangles))


def lug(length: float, width: float, height: float, taper: float = 0.7, skew: float = 0.0) -> Mesh:
    """A block on a belt: `length` along it; its top is narrower; `skew` moves its outer end along the belt."""
    x, y = length / 2.0, width / 2.0
    low = [(-x - skew, -y, 0.0), (x - skew, -y, 0.0), (x + skew, y, 0.0), (-x + skew, y, 0.0)]
    top = [
        ((px + (skew if py < 0 else -skew)) * taper - (skew if py < 0 else -skew), py * 0.94, height)
        for px, py, _ in low
    ]
    vertices = np.array([*low, *top])
    sides = [(n, (n + 1) % 4, 4 + (n + 1) % 4) for n in range(4)] + [(n, 4 + (n + 1) % 4, 4 + n) for n in range(4)]
    return shaded(vertices, np.array([*sides, (4, 5, 6), (4, 6, 7)]))


def treads(loop: Loop, width: float) -> dict[str, Running]:
    """Lugs on both sides of a belt, bars outside, teeth inside: by the part of the loop on which they move."""
    bar, pitch = width / 3.0 - 0.002, loop.pitch
    sides = joined(
        [
            lug(0.016, bar, TREAD, 0.62, -0.004).at(0.0, bar + 0.002),
            lug(0.016, bar, TREAD, 0.62, 0.004).at(0.0, -bar - 0.002),
        ]
    )
    middle = joined(
        [lug(0.014, bar, TREAD, 0.62), lug(0.013, 0.014, 0.009, 0.6).at(0.0, 0.0, -BELT, FLIP)],
    )
    parts: list[list[Mesh]] = [[] for _ in PARTS]
    for number in range(2 * round(loop.length / pitch)):
        way = number * pitch / 2.0
        parts[loop.part(way)].append(loop.bent((middle if number % 2 else sides).at(way)))
    return {
        name: loop.running(part, {"rubber": joined(lugs)}, pitch)
        for part, (name, lugs) in enumerate(zip(PARTS, parts, strict=True))
    }


def belt(loop: Loop, width: float) -> Mesh:
    """A belt without treads, whose outside is the loop."""
    y, edge = width / 2.0, 0.0015
    section = [
        (-y, -BELT + edge),
        (-y + edge, -BELT),
        (y - edge, -BELT),
        (y, -BELT + edge),
        (y, -edge),
        (y - edge, 0.0),
    ]
    return strip(loop, [*section, (-y + edge, 0.0), (-y, -edge)])


def track_loop(size: Dimensions) -> Loop:
    """The loop of a main track, in the frame of its link."""
    radius = size.idler_radius - TREAD
    return Loop((-size.idler_x, size.idler_z), (size.idler_x, size.idler_z), radius, radius)


def windowed(radius: float, hub: float, windows: int, size: float, teeth: int = 0) -> shapely.Polygon:
    """A disc with round windows between its rim and its hub, and teeth."""
    outline = circle(radius, segments=32)
    if teeth:
        ring = [2.0 * math.pi * (n + d) / teeth for n in range(teeth) for d in (-0.22, -0.12, 0.12, 0.22)]
        deep = [radius - 0.006 * (place % 4 in (0, 3)) for place in range(len(ring))]
        outline = [(r * math.cos(a), r * math.sin(a)) for a, r in zip(ring, deep, strict=True)]
    at = (radius + hub) / 2.0 - 0.002
    angles = [2.0 * math.pi * n / windows for n in range(windows)]
    holes = [circle(size, at * math.cos(a), at * math.sin(a), 10) for a in angles]
    return shapely.Polygon(outline, [hole[::-1] for hole in holes])


def sprocket(radius: float, width: float) -> Look:
    """The driven wheel, its axis along z, its outer face at the top: two toothed discs on a hub."""
    disc = extruded(windowed(radius, 0.026, 7, 0.0125, 14), -0.0035, 0.0035)
    inner = pin(-0.0035, 0.0035, radius - 0.003, 24)
    top = width / 2.0
    cap = lathe(
        [
            (0.030, top - 0.012),
            (0.030, top - 0.004),
            (0.026, top),
            (0.012, top),
            (0.010, top + 0.003),
            (0.0, top + 0.003),
        ]
    )
    return {
        "steel": joined([disc.at(z=0.022), inner.at(z=-0.022), cap]),
        "dark": joined([pin(-top, top - 0.010, 0.026), hexagons(6, 0.021, top, 0.0032, 0.0025)]),
    }


def idler(radius: float, width: float) -> Look:
    """The front wheel: two spoked discs with rubber tyres, around the shaft of the flippers."""
    spokes = extruded(windowed(radius - 0.008, 0.030, 5, 0.0155), -0.0045, 0.0045)
    inner = pin(-0.0045, 0.0045, radius - 0.008, 24)
    top = width / 2.0
    tyre = lathe(
        [
            (radius - 0.009, -0.008),
            (radius - 0.001, -0.008),
            (radius, -0.006),
            (radius, 0.006),
            (radius - 0.001, 0.008),
            (radius - 0.009, 0.008),
        ],
        28,
    )
    hub = lathe([(0.034, top - 0.022), (0.034, top - 0.006), (0.031, top - 0.002), (0.024, top), (0.0, top)])
    return {
        "steel": joined([spokes.at(z=0.026), inner.at(z=-0.026)]),
        "rubber": joined([tyre.at(z=0.026), tyre.at(z=-0.026)]),
        "dark": joined([pin(-top, top - 0.020, 0.024), hub]),
        "black": hexagons(8, 0.028, top - 0.0045, 0.0026, 0.003),
    }


def road_wheel(width: float) -> Look:
    """A small wheel on the flat part, without its bolts."""
    r, top = ROAD_WHEEL, width / 2.0 - 0.016
    tyre = lathe(
        [(r - 0.007, -top), (r - 0.002, -top), (r, -top + 0.003), (r, top - 0.003), (r - 0.002, top), (r - 0.007, top)],
        20,
    )
    hub = lathe(
        [
            (r - 0.007, top - 0.001),
            (r - 0.011, top - 0.006),
            (0.011, top - 0.006),
            (0.009, top + 0.003),
            (0.0, top + 0.003),
        ],
        20,
    )
    return {"rubber": tyre, "steel": hub}


def road_wheel_bolts(width: float) -> Look:
    """Those of a road wheel, of which nothing else is seen to turn."""
    return {"black": hexagons(5, 0.0145, width / 2.0 - 0.022, 0.0022, 0.002)}


def road_wheels(size: Dimensions) -> list[tuple[float, float, float]]:
    """Middles of the road wheels of the left track, in the frame of its link."""
    radius = size.idler_radius - TREAD - BELT
    far = size.idler_x - radius - ROAD_WHEEL - 0.008
    return [(float(x), 0.0, size.idler_z - radius + ROAD_WHEEL) for x in np.linspace(-far, far, 4)]


def merge(*looks: Look) -> Look:
    """Looks together."""
    names = dict.fromkeys(name for look in looks for name in look)
    return {name: joined([look[name] for look in looks if name in look]) for name in names}


def moved(look: Look, x: float = 0.0, y: float = 0.0, z: float = 0.0, turn: Array | None = None) -> Look:
    """A look, turned and then moved."""
    return {name: mesh.at(x, y, z, turn) for name, mesh in look.items()}


def track(size: Dimensions) -> dict[str, Running]:
    """What moves with the belt of the left track."""
    loop, width = track_loop(size), size.belt_width
    radius = size.idler_radius - TREAD - BELT
    driven = moved(sprocket(radius, width), -size.idler_x, 0.0, size.idler_z, OUTWARD)
    front = moved(idler(radius, width), size.idler_x, 0.0, size.idler_z, OUTWARD)
    bolts = moved(road_wheel_bolts(width), turn=OUTWARD)
    return {
        **treads(loop, width),
        "sprocket": loop.running(3, driven),
        "idler": loop.running(1, front),
        **{
            f"road_wheel{number}": Running(bolts, middle, 0.0, ROAD_WHEEL)
            for number, middle in enumerate(road_wheels(size))
        },
    }


def running_gear(size: Dimensions) -> Look:
    """The small wheels inside the left track, in the frame of its link."""
    radius = size.idler_radius - TREAD - BELT
    rollers = pin(-size.belt_width / 2.0 + 0.018, size.belt_width / 2.0 - 0.018, 0.014, 16)
    high = size.idler_z + radius - 0.014
    return merge(
        *(moved(road_wheel(size.belt_width), *middle, OUTWARD) for middle in road_wheels(size)),
        *(moved({"rubber": rollers}, x, 0.0, high, OUTWARD) for x in (-0.085, 0.085)),
    )


def suspension(size: Dimensions) -> Look:
    """The plates between the wheels of the left track, with slots, screws and arms to the road wheels."""
    radius = size.idler_radius - TREAD - BELT
    long, y = 2.0 * (size.idler_x - 0.052), size.belt_width / 2.0
    low, high = size.idler_z - radius + ROAD_WHEEL + 0.012, size.idler_z + radius - 0.034
    middle, height = (low + high) / 2.0, high - low
    outline = shapely.Polygon(round_rectangle(long, height, 0.014))
    holes = [shapely.affinity.translate(shapely.Polygon(slot(0.07, height * 0.18)), x, 0.0) for x in (-0.145, 0.145)]
    plate = extruded(outline.difference(shapely.unary_union(holes)), 0.0, 0.008, 0.0016)
    standing = across(plate)  # in x and z, from y = -0.008 to 0
    backing = across(extruded(round_rectangle(long - 0.01, height - 0.012, 0.01), 0.0, 0.006))
    web = across(extruded(round_rectangle(long - 0.03, 0.022, 0.004), 0.0, size.belt_width - 0.012, 0.002))
    on_face = screws(
        [
            (x, -(s * (height / 2.0 - 0.008)), 0.0)
            for x in (-long / 2 + 0.018, -0.06, 0.06, long / 2 - 0.018)
            for s in (-1, 1)
        ],
        0.0042,
        0.003,
    )
    below = size.idler_z - radius + ROAD_WHEEL
    xs = np.linspace(-size.idler_x + radius + ROAD_WHEEL + 0.008, size.idler_x - radius - ROAD_WHEEL - 0.008, 4)
    arms = []
    for x in xs:
        lean = shapely.LineString([(float(x), below), (float(x) - 0.022, middle - 0.004)]).buffer(0.0085, quad_segs=4)
        arms.append(across(extruded(lean, 0.0, 0.006, 0.0012)).at(y=y - 0.004))
    return {
        "olive": standing.at(y=y, z=middle),
        "black": joined(
            [backing.at(y=y - 0.009, z=middle), web.at(y=y - 0.010, z=middle), on_face.at(y=y, z=middle, turn=OUTWARD)]
        ),
        "dark": joined(arms),
    }


def plate_paint(size: Dimensions, turn: Array) -> Look:
    """Paint on the plates of `suspension`, around the middle of their outer face."""
    radius = size.idler_radius - TREAD - BELT
    low, high = size.idler_z - radius + ROAD_WHEEL + 0.012, size.idler_z + radius - 0.034
    side = 1.0 if turn is decals.LEFT else -1.0
    y = side * (size.gauge + size.belt_width) / 2.0
    painted = decals.side(turn, 2.0 * (size.idler_x - 0.052) - 0.086, high - low)
    return moved(painted, size.track_x, y, (low + high) / 2.0)


def flipper_loop(size: Dimensions) -> Loop:
    """The loop of a flipper, in the frame of its link."""
    radius = size.flipper_radius - TREAD
    return Loop((0.0, 0.0), (size.flipper_length, 0.0), radius, radius)


def flipper_frame(size: Dimensions) -> Look:
    """What carries the left flipper's belt: two wheels, an arm with windows, screws."""
    radius, top = size.flipper_radius - TREAD - BELT, size.flipper_width / 2.0
    long = size.flipper_length
    arm = shapely.LineString([(0.0, 0.0), (long, 0.0)]).buffer(radius * 0.62, quad_segs=6)
    holes = [shapely.Polygon(circle(radius * 0.36, x, 0.0, 16)) for x in np.linspace(0.075, long - 0.07, 3)]
    plate = across(extruded(arm.difference(shapely.unary_union(holes)), 0.0, 0.006, 0.0015))
    wheel = extruded(windowed(radius, 0.012, 5, radius * 0.2), -top + 0.004, top - 0.009)
    ends = joined(wheel.at(x, 0.0, 0.0, OUTWARD) for x in (0.0, long))
    cap = lathe([(0.020, 0.0), (0.020, 0.005), (0.016, 0.009), (0.0, 0.009)])
    heads = joined([screws([(x, 0.0, 0.0)], 0.004, 0.003) for x in (0.045, long - 0.04)])
    return {
        "dark": ends,
        "olive": plate.at(y=top + 0.001),
        "steel": joined([cap.at(0.0, top + 0.001, 0.0, OUTWARD), cap.at(long, top - 0.002, 0.0, OUTWARD)]),
        "black": joined(
            [
                hexagons(6, 0.013, 0.0085, 0.0024, 0.002).at(0.0, top + 0.001, 0.0, OUTWARD),
                heads.at(0.0, top + 0.001, 0.0, OUTWARD),
            ]
        ),
    }


def flipper_shaft(size: Dimensions) -> Look:
    """The shaft through both front idlers, with clutches outside of the belts."""
    half = size.flipper_y - size.flipper_width / 2.0
    inner = size.gauge / 2.0 + size.belt_width / 2.0
    shaft = pin(-half, half, 0.013, 18).at(turn=OUTWARD)
    clutch = lathe(
        [
            (0.013, inner + 0.001),
            (0.024, inner + 0.002),
            (0.024, half - 0.006),
            (0.019, half - 0.002),
            (0.013, half - 0.002),
        ],
        24,
    )
    return {"steel": shaft, "dark": joined([clutch.at(turn=OUTWARD), mirrored(clutch.at(turn=OUTWARD))])}
