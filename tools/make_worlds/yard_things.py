"""What stands around in the yard: container, drums, tyres, sandbags, barriers, a drum of cable, lamps."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from .scene import Part
from .shapes import Array, Mesh, Vector, box, cylinder, joined, lathe, prism, quads, ring, tube

UPRIGHT: Final = (math.pi / 2, 0.0, 0.0)
"""Turns a prism's outline into the x-z plane, and its length along -y."""

_TOP, _MIDDLE, _BOTTOM = ((at, 0.0, 0.085, 0.445) for at in (0.35, 0.0, -0.35))
_RIGHT, _LOWER_RIGHT, _LOWER_LEFT = (
    (at, left, 0.245, 0.085) for at, left in ((0.175, -0.18), (-0.175, -0.18), (-0.175, 0.18))
)
DIGITS: Final = {
    "1": (
        (0.0, 0.0, 0.785, 0.085),
        (0.35, 0.09, 0.085, 0.085),
        (-0.35, 0.11, 0.085, 0.115),
        (-0.35, -0.11, 0.085, 0.115),
    ),
    "2": (_TOP, _RIGHT, _MIDDLE, _LOWER_LEFT, _BOTTOM),
    "3": (_TOP, _RIGHT, _MIDDLE, _LOWER_RIGHT, _BOTTOM),
}
"""Bars of digits: how far ahead and to the left of the middle, length along the way, and width; metres."""


def add_digit(white: list[Mesh], digit: str, x: float, y: float, yaw: float) -> None:
    """A digit of paint, 0.8 m high, read by who drives along `yaw`."""
    for ahead, left, length, width in DIGITS[digit]:
        white.append(box(length, width, 0.004).at(ahead, left, 0.002).at(x, y, rpy=(0.0, 0.0, yaw)))


def corrugated(width: float, height: float, pitch: float, depth: float) -> Mesh:
    """A sheet in the x-z plane with upright ridges that looks to -y, its lower left corner at the origin."""
    count = max(1, round(width / pitch))
    steps = np.array([0.0, 0.38, 0.5, 0.88])
    x = np.append((np.arange(count)[:, None] + steps).ravel(), count) * width / count
    y = np.append(np.tile([-depth, -depth, 0.0, 0.0], count), -depth)
    rows = [np.stack([x, y, np.full_like(x, z)], axis=1) for z in (0.0, height)]
    return quads(np.stack(rows)).flat()


def shutter(width: float, height: float, slat: float, depth: float) -> Mesh:
    """A roller shutter in the x-z plane that looks to -y, its lower left corner at the origin."""
    count = max(1, round(height / slat))
    steps = np.array([0.0, 0.12, 0.2, 0.8])
    z = np.append((np.arange(count)[:, None] + steps).ravel(), count) * height / count
    y = np.append(np.tile([0.0, 0.0, -depth, -depth], count), 0.0)
    rows = [np.stack([np.full_like(z, x), y, z], axis=1) for x in (0.0, width)]
    return quads(np.stack(rows, axis=1)).flat()


def add_container(world: Part, at: Vector, yaw: float) -> None:
    """A container of 20 feet along x; its doors are at -x."""
    length, width, height = 6.06, 2.44, 2.59
    half, side = length / 2.0, width / 2.0

    def place(mesh: Mesh) -> Mesh:
        return mesh.at(*at, rpy=(0.0, 0.0, yaw))

    walls = [
        corrugated(length - 0.3, height - 0.32, 0.28, 0.036).at(-half + 0.15, -side + 0.06, 0.16),
        corrugated(length - 0.3, height - 0.32, 0.28, 0.036).at(half - 0.15, side - 0.06, 0.16, rpy=(0, 0, math.pi)),
        corrugated(width - 0.3, height - 0.32, 0.28, 0.036).at(
            half - 0.06, -side + 0.15, 0.16, rpy=(0, 0, math.pi / 2)
        ),
        box(length - 0.1, width - 0.1, 0.02).at(0.0, 0.0, height - 0.03),
    ]
    frame = [box(0.15, 0.15, height, 0.012).at(x, y, height / 2) for x in (-half + 0.075, half - 0.075)
             for y in (-side + 0.075, side - 0.075)]  # fmt: skip
    frame += [box(length, 0.10, 0.14, 0.012).at(0.0, y, z) for y in (-side + 0.05, side - 0.05)
              for z in (0.11, height - 0.07)]  # fmt: skip
    frame += [box(0.10, width, 0.14, 0.012).at(x, 0.0, z) for x in (-half + 0.05, half - 0.05)
              for z in (0.11, height - 0.07)]  # fmt: skip
    doors = [box(0.05, width / 2 - 0.17, height - 0.34, 0.012).at(-half + 0.06, y, height / 2) for y in (-0.535, 0.535)]
    ribs = [box(0.02, width / 2 - 0.3, 0.10, 0.008).at(-half + 0.03, y, z) for y in (-0.535, 0.535)
            for z in np.linspace(0.5, height - 0.5, 5)]  # fmt: skip
    rods = [tube([(-half, y, 0.14), (-half, y, height - 0.14)], 0.017, 6) for y in (-0.85, -0.28, 0.28, 0.85)]
    rods += [box(0.05, 0.22, 0.04, 0.006).at(-half - 0.01, y, 1.05) for y in (-0.75, -0.18, 0.38, 0.95)]
    rods += [box(0.03, 0.09, 0.06).at(-half + 0.01, y, z) for y in (-0.85, -0.28, 0.28, 0.85) for z in (0.3, 2.3)]
    castings = [box(0.18, 0.17, 0.12, 0.01).at(x, y, z) for x in (-half + 0.08, half - 0.08)
                for y in (-side + 0.08, side - 0.08) for z in (0.06, height - 0.055)]  # fmt: skip
    plate = [box(0.9, 0.012, 0.34).at(1.75, side - 0.012, 2.05), box(0.5, 0.012, 0.1).at(1.95, side - 0.012, 1.75)]
    world.see("container_uv", *(place(mesh) for mesh in (*walls, *doors, *ribs)))
    world.see("container_frame_uv", *(place(mesh) for mesh in frame))
    world.see("steel", *(place(mesh) for mesh in rods))
    world.see("plastic", *(place(mesh) for mesh in castings))
    world.see("paint_white", *(place(mesh) for mesh in plate))
    c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
    world.box(
        (length * c + width * s, length * s + width * c, height),
        (at[0], at[1], at[2] + height / 2),
        material="container_uv",
    )


def pallet() -> tuple[Mesh, ...]:
    """A pallet of 1.2 m x 0.8 m on z = 0, 0.144 m high."""
    boards = [box(1.2, 0.1, 0.022).at(0.0, y, 0.133) for y in np.linspace(-0.35, 0.35, 5)]
    boards += [box(0.1, 0.8, 0.022).at(x, 0.0, 0.111) for x in (-0.55, 0.0, 0.55)]
    blocks = [box(0.1, 0.1, 0.078).at(x, y, 0.061) for x in (-0.55, 0.0, 0.55) for y in (-0.35, 0.0, 0.35)]
    feet = [box(1.2, 0.1, 0.022).at(0.0, y, 0.011) for y in (-0.35, 0.0, 0.35)]
    return (*boards, *blocks, *feet)


def drum() -> tuple[Mesh, Mesh]:
    """A steel drum of 200 litres on z = 0, 0.88 m high: its shell, and the plugs on it."""
    radius = 0.285
    profile = [
        (0.0, 0.012),
        (radius - 0.012, 0.012),
        (radius - 0.01, 0.0),
        (radius + 0.008, 0.0),
        (radius + 0.008, 0.02),
    ]
    for middle in (0.30, 0.58):
        profile += [(radius, middle - 0.02), (radius + 0.012, middle), (radius, middle + 0.02)]
    profile += [(radius, 0.86), (radius + 0.008, 0.86), (radius + 0.008, 0.88), (radius - 0.012, 0.88)]
    profile += [(radius - 0.014, 0.865), (0.0, 0.865)]
    plugs = [
        cylinder(0.865, 0.878, 0.035, 0.003, 10).at(0.16, 0.1),
        cylinder(0.865, 0.875, 0.02, 0.003, 8).at(-0.18, 0.0),
    ]
    return lathe(profile, 18), joined(plugs)


def add_drums(world: Part, at: Vector) -> None:
    """Four drums on a pallet, and one beside it."""
    x, y, z = at
    wood = (mesh.at(x, y + dy, z) for mesh in pallet() for dy in (-0.3, 0.3))
    world.see("planks_uv", *wood)
    shell, plugs = drum()
    for number, (dx, dy, up) in enumerate(
        ((-0.3, -0.3, 0.144), (0.3, -0.3, 0.144), (-0.3, 0.31, 0.144), (0.31, 0.3, 0.144), (-1.0, 0.2, 0.0))
    ):
        world.see(
            ("drum_blue", "drum_blue", "drum_green", "drum_blue", "paint_yellow")[number],
            shell.at(x + dx, y + dy, z + up),
        )
        world.see("steel", plugs.at(x + dx, y + dy, z + up))
    world.box((1.2, 1.4, 1.024), (x, y, z + 0.512), material="drum_blue")
    world.cylinder(0.29, (x - 1.0, y + 0.2, z), (x - 1.0, y + 0.2, z + 0.88), material="paint_yellow")


def tyre() -> Mesh:
    """A tyre on z = 0, 0.2 m wide, of radius 0.32 m, with a groove around its tread."""
    rim, outer, width = 0.19, 0.32, 0.2
    profile = [(rim, 0.018), (rim + 0.03, 0.0), (outer - 0.05, 0.006), (outer - 0.008, 0.03), (outer, 0.05)]
    profile += [(outer, 0.085), (outer - 0.015, 0.088), (outer - 0.015, 0.112), (outer, 0.115), (outer, width - 0.05)]
    profile += [(outer - 0.008, width - 0.03), (outer - 0.05, width - 0.006), (rim + 0.03, width), (rim, width - 0.018)]
    return lathe(profile, 18)


def add_tyres(world: Part, at: Vector, count: int, seed: int = 1) -> None:
    """A stack of tyres."""
    random = np.random.default_rng(seed)
    x, y, z = at
    for number in range(count):
        dx, dy = random.uniform(-0.018, 0.018, 2)
        world.see("rubber", tyre().at(x + dx, y + dy, z + 0.2 * number))
    world.cylinder(0.33, (x, y, z), (x, y, z + 0.2 * count), material="rubber")


def sandbag(random: np.random.Generator) -> Mesh:
    """A filled bag of about 0.5 m x 0.27 m x 0.15 m, its middle at the origin."""
    turns, rises = np.linspace(0.0, math.tau, 11), np.linspace(-math.pi / 2, math.pi / 2, 5)

    def power(value: Array, exponent: float) -> Array:
        made: Array = np.sign(value) * np.abs(value) ** exponent
        return made

    u, v = np.meshgrid(turns, rises)
    half = np.array([0.255, 0.14, 0.082]) * random.uniform(0.96, 1.05, 3)
    points = np.stack(
        [
            half[0] * power(np.cos(v), 0.6) * power(np.cos(u), 0.55),
            half[1] * power(np.cos(v), 0.6) * power(np.sin(u), 0.6),
            half[2] * power(np.sin(v), 0.75),
        ],
        axis=-1,
    )
    sag = 0.012 * np.cos(points[..., 0] / half[0] * math.pi / 1.4)
    points[..., 2] += sag
    points[:, -1] = points[:, 0]
    return quads(points)


def add_sandbags(world: Part, at: Vector, across: int, rows: int) -> None:
    """A wall of sandbags along y, two bags thick at its foot."""
    random = np.random.default_rng(4)
    x, y, z = at
    for row in range(rows):
        shift, count = (0.25, across - 1) if row % 2 else (0.0, across)
        for number in range(count):
            py = y + shift + 0.5 * (number - (across - 1) / 2.0)
            for px in (x - 0.13, x + 0.13) if row < 2 else (x,):
                turn = math.pi / 2 + random.uniform(-0.05, 0.05)
                bag = sandbag(random).at(
                    px + random.uniform(-0.012, 0.012), py, z + 0.078 + 0.142 * row, rpy=(0.0, 0.0, turn)
                )
                world.see("sandbag_uv" if (row + number) % 3 else "sandbag_dark_uv", bag)
    world.box((0.4, 0.5 * across - 0.25, 0.142 * rows), (x, y, z + 0.071 * rows), material="sandbag_uv")


def add_barrier(world: Part, at: Vector, length: float) -> None:
    """A barrier of concrete along x, as beside motorways."""
    outline = [(-0.3, 0.0), (0.3, 0.0), (0.3, 0.07), (0.15, 0.27), (0.09, 0.78), (0.07, 0.81), (-0.07, 0.81),
               (-0.09, 0.78), (-0.15, 0.27), (-0.3, 0.07)]  # fmt: skip
    body = prism(outline, -length / 2, length / 2).at(rpy=(math.pi / 2, 0.0, 0.0)).at(*at, rpy=(0.0, 0.0, math.pi / 2))
    world.see("concrete_uv", body.flat())
    x, y, z = at
    bands = [box(0.18, 0.004, 0.30).at(x + dx, y + s * 0.123, z + 0.52, rpy=(s * 0.117, 0.0, 0.0))
             for dx in (-length / 2 + 0.2, length / 2 - 0.2) for s in (-1.0, 1.0)]  # fmt: skip
    world.see("stripes_uv", *bands)
    world.box((length, 0.26, 0.81), (x, y, z + 0.405), material="concrete")


def add_cable_drum(world: Part, at: Vector) -> None:
    """A wooden drum of cable that stands on its rims, its axis along y."""
    x, y, z = at
    radius, width = 0.46, 0.5
    turn = (math.pi / 2, 0.0, 0.0)
    rims = [
        cylinder(-0.022, 0.022, radius, 0.006, 28).at(x, y + dy, z + radius, rpy=turn) for dy in (-width / 2, width / 2)
    ]
    world.see("planks_uv", *rims)
    coils = [(0.30, -0.21)]
    for dy in np.linspace(-0.19, 0.19, 9):
        coils += [(0.315, dy - 0.02), (0.335, dy)]
    world.see("rubber", lathe([*coils, (0.30, 0.21)], 26).at(x, y, z + radius, rpy=turn))
    hubs = [
        cylinder(-0.03, 0.03, 0.06, 0.006, 14).at(x, y + dy, z + radius, rpy=turn) for dy in (-width / 2, width / 2)
    ]
    bolts = [
        cylinder(-0.03, 0.03, 0.014, 0.0, 6).at(x + 0.2 * math.cos(a), y + dy, z + radius + 0.2 * math.sin(a), rpy=turn)
        for dy in (-width / 2, width / 2)
        for a in np.linspace(0.3, math.tau + 0.3, 6, endpoint=False)
    ]
    end = [(x + 0.3, y - 0.1, z + 0.3), (x + 0.42, y - 0.12, z + 0.06), (x + 0.6, y - 0.2, z + 0.015),
           (x + 0.9, y - 0.1, z + 0.015), (x + 1.0, y + 0.1, z + 0.015)]  # fmt: skip
    world.see("steel", *hubs, *bolts)
    world.see("rubber", tube(end, 0.014, 6))
    world.cylinder(
        radius, (x, y - width / 2 - 0.02, z + radius), (x, y + width / 2 + 0.02, z + radius), material="planks_uv"
    )


def lamp_post(height: float, yaw: float) -> dict[str, Mesh]:
    """A mast on z = 0 with two flood lights that look along x, turned by `yaw`."""
    mast = [
        cylinder(0.0, 0.02, 0.16, 0.0, 14),
        lathe([(0.09, 0.0), (0.085, 1.0), (0.06, 1.06), (0.045, height), (0.0, height)], 12),
    ]
    arm = [box(0.06, 1.3, 0.06, 0.01).at(0.0, 0.0, height - 0.05), box(0.012, 0.14, 0.3).at(0.085, 0.0, 0.75)]
    tilt = (0.0, 0.55, 0.0)
    heads = [box(0.14, 0.42, 0.34, 0.02).at(0.16, y, height + 0.02, rpy=tilt) for y in (-0.42, 0.42)]
    heads += [box(0.05, 0.36, 0.03).at(0.06, y, height + 0.02) for y in (-0.42, 0.42)]
    glass = [box(0.02, 0.36, 0.28).at(0.227, y, height - 0.015, rpy=tilt) for y in (-0.42, 0.42)]
    turn = (0.0, 0.0, yaw)
    return {
        "metal_uv": joined(mesh.at(rpy=turn) for mesh in (*mast, *arm)),
        "plastic": joined(mesh.at(rpy=turn) for mesh in heads),
        "lamp": joined(mesh.at(rpy=turn) for mesh in glass),
    }


def railing(points: list[Vector], height: float) -> list[Mesh]:
    """A handrail of tubes along points on the ground, with a post at each."""
    top = [(x, y, z + height) for x, y, z in points]
    middle = [(x, y, z + height * 0.52) for x, y, z in points]
    posts = [tube([point, (point[0], point[1], point[2] + height)], 0.019, 8) for point in points]
    feet = [cylinder(0.0, 0.012, 0.05, 0.002, 10).at(*point) for point in points]
    return [*posts, *feet, tube(top, 0.021, 8), tube(middle, 0.015, 6)]


def loop(radius: float) -> Mesh:
    """A lifting loop that stands on z = 0, across x."""
    return ring(radius, radius * 0.22, 10, 6, math.pi).at(rpy=(math.pi / 2, 0.0, 0.0))
