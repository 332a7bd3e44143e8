"""`house`: a door with a handle, a latch and a spring; rooms, a narrow corridor, stairs, furniture; no ceiling."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from .scene import Part, Scene
from .shapes import Vector, box, cylinder, foliage, lathe, picture, sheet, tube, wall, wall_pieces
from .solids import block, solid, union

ABOUT: Final = """
    A house, metres. The robot starts on the path before its door, at x = 1.7, which opens inward: press the handle down
    (0.5 rad), push, and a spring closes it again. Behind the hall is a corridor of 0.86 m between two rooms; at its
    end are stairs of 0.18 m / 0.28 m to a landing. Table, chairs, sofa, cartons, pot and bin move.
    Made by tools/make_worlds.
  """
HEIGHT: Final = 2.4
WEST, EAST, SOUTH, NORTH = 1.6, 8.8, -4.3, 4.3
STEPS: Final = 10
RISE, RUN = 0.18, 0.28
Hole = tuple[float, float, float, float]


def house() -> Scene:
    """The whole house."""
    scene = Scene("house", ABOUT, middle=(4.5, 0.0, 1.0), extent=6.0)
    for name, rgba, shine in (
        ("door_paint", "0.16 0.27 0.30 1", "0.4"),
        ("brass", "0.78 0.62 0.28 1", "0.8"),
        ("sofa_cloth", "0.42 0.20 0.17 1", "0.02"),
        ("cushion", "0.75 0.62 0.35 1", "0.02"),
        ("leaves", "0.16 0.34 0.12 1", "0.1"),
        ("clay", "0.62 0.33 0.20 1", "0.1"),
        ("rug", "0.30 0.14 0.15 1", "0.0"),
        ("rug_light", "0.72 0.62 0.47 1", "0.0"),
        ("pane", "0.50 0.60 0.66 0.22", "0.95"),
        ("lamp", "1.0 0.96 0.86 1", "0.5"),
        ("screen", "0.02 0.02 0.025 1", "0.9"),
    ):
        scene.asset("material", name=name, rgba=rgba, specular=shine, shininess=shine)
    bolt = [(0.010, y, z) for y in (-0.03, 0.014) for z in (-0.012, 0.012)]
    bolt += [(-0.010, y, z) for y in (-0.03, 0.0) for z in (-0.012, 0.012)]
    scene.asset("mesh", name="house/bolt", vertex=" ".join(f"{value:g}" for point in bolt for value in point))
    world = scene.world
    world.add("geom", name="ground", class_="solid", type="plane", size=[0, 0, 1])
    for x, y in ((3.2, 2.6), (3.6, -2.4), (7.6, 1.0)):
        world.add(
            "light",
            pos=[x, y, 2.6],
            dir=[0, 0, -1],
            diffuse=[0.30, 0.27, 0.22],
            specular=[0, 0, 0],
            attenuation=[1, 0.1, 0.12],
            cutoff=85.0,
            castshadow="false",
        )
    _outside(world)
    _walls(world)
    _stairs(world)
    _rooms(world)
    _door(scene)
    return scene


def _outside(world: Part) -> None:
    world.see("grass_uv", sheet(40.0, 40.0, 4.0).at(4.0, 0.0, -0.012))
    world.see("paving_uv", sheet(3.05, 1.5, 0.5).at(0.075, 0.0, 0.0), sheet(1.5, 8.0, 1.0).at(-2.2, 0.0, 0.0))
    random = np.random.default_rng(3)
    for x, y in ((0.6, 1.25), (0.6, -1.25)):
        world.see(
            "clay",
            lathe([(0.0, 0.0), (0.15, 0.0), (0.2, 0.32), (0.22, 0.32), (0.22, 0.36), (0.19, 0.36), (0.0, 0.33)]).at(
                x, y
            ),
        )
        bush = union(
            *(
                block((0.3, 0.3, 0.3), 0.14, (0.13 * math.cos(a), 0.13 * math.sin(a), 0.52 + 0.1 * math.sin(3 * a)))
                for a in np.arange(0.0, 6.0, 1.05)
            )
        )
        world.see("leaves", solid(bush, (-0.35, -0.35, 0.3), (0.35, 0.35, 0.85), 0.06, 260).at(x, y))
        world.see("leaves", foliage(random, 260, 0.11).scaled(0.32, 0.32, 0.26).at(x, y, 0.55))
        world.cylinder(0.22, (x, y, 0.0), (x, y, 0.5))


def _wall(
    world: Part, start: tuple[float, float], length: float, along_y: bool, holes: list[Hole], *, outer: bool = False
) -> None:
    """An inner wall of 0.1 m, or an outer one of 0.2 m with bricks on the side of its right hand."""
    yaw = math.pi / 2.0 if along_y else 0.0
    x, y = start
    thick = 0.2 if outer else 0.1
    if outer:
        world.see("brick_uv", wall(length, HEIGHT, 0.12, holes).at(0.0, -0.04).at(x, y, rpy=(0.0, 0.0, yaw)))
        world.see("plaster_uv", wall(length, HEIGHT, 0.08, holes).at(0.0, 0.06).at(x, y, rpy=(0.0, 0.0, yaw)))
    else:
        world.see("plaster_uv", wall(length, HEIGHT, thick, holes).at(x, y, rpy=(0.0, 0.0, yaw)))
    for left, right, low, high in wall_pieces(length, HEIGHT, holes):
        middle, size = ((left + right) / 2.0, (low + high) / 2.0), (right - left, thick, high - low)
        at = (x, y + middle[0], middle[1]) if along_y else (x + middle[0], y, middle[1])
        world.box((size[1], size[0], size[2]) if along_y else size, at)
        if low == 0.0:
            skirting = box(right - left, thick + 0.024, 0.09, 0.006).at(middle[0], 0.0, 0.045)
            world.see("paint_white", skirting.at(x, y, rpy=(0.0, 0.0, yaw)))
    for left, right, low, high in holes:
        width, tall, middle = right - left, high - low, ((left + right) / 2.0, (low + high) / 2.0)
        frame = [box(0.06, thick + 0.04, tall).at(s * (width / 2.0 - 0.005), 0.0, 0.0) for s in (-1.0, 1.0)]
        frame.append(box(width + 0.1, thick + 0.04, 0.06).at(0.0, 0.0, tall / 2.0))
        if low > 0.0:
            frame += [
                box(width + 0.1, thick + 0.10, 0.05).at(0.0, 0.0, -tall / 2.0),
                box(0.05, 0.05, tall),
                box(width, 0.045, 0.04).at(0.0, 0.0, tall * 0.15),
            ]
            pane = box(width, 0.01, tall).at(middle[0], 0.0, middle[1])
            world.see("pane", pane.at(x, y, rpy=(0.0, 0.0, yaw)))
            size = (thick, width, tall) if along_y else (width, thick, tall)
            world.box(size, (x, y + middle[0], middle[1]) if along_y else (x + middle[0], y, middle[1]))
        world.see("paint_white", *(part.at(middle[0], 0.0, middle[1]).at(x, y, rpy=(0.0, 0.0, yaw)) for part in frame))


def _walls(world: Part) -> None:
    window = (0.9, 2.1)
    _wall(world, (EAST, SOUTH), NORTH - SOUTH, True, [(5.2, 6.8, *window)])
    _wall(
        world,
        (WEST + 0.1, SOUTH),
        NORTH - SOUTH,
        True,
        [(0.9, 2.5, *window), (3.84, 4.76, 0.0, 2.05), (6.1, 7.7, *window)],
    )
    _wall(world, (WEST + 0.1, NORTH), EAST - WEST, False, [(1.2, 2.8, *window), (4.6, 6.2, *window)])
    _wall(world, (WEST + 0.1, SOUTH), EAST - WEST, False, [(1.6, 3.2, *window)])
    for x, length in ((WEST - 0.02, NORTH - SOUTH),):  # bricks outside, around door and windows
        holes = [(0.9, 2.5, *window), (3.80, 4.80, 0.0, 2.08), (6.1, 7.7, *window)]
        world.see("brick_uv", wall(length, HEIGHT, 0.14, holes).at(x, SOUTH, rpy=(0.0, 0.0, math.pi / 2.0)))
        for left, right, low, high in wall_pieces(length, HEIGHT, holes):
            world.box((0.14, right - left, high - low), (x, SOUTH + (left + right) / 2.0, (low + high) / 2.0))
    _wall(world, (3.6, 0.48), 3.2, False, [])
    _wall(world, (3.6, 0.48), NORTH - 0.48, True, [(0.9, 1.85, 0.0, 2.05)])
    _wall(world, (WEST + 0.15, -0.48), 5.05, False, [(0.55, 1.5, 0.0, 2.05)])
    _wall(world, (6.8, SOUTH), -0.48 - SOUTH, True, [])
    world.see("tiles_uv", sheet(2.0, 8.5, 0.5).at(2.65, 0.0, 0.002), sheet(5.2, 0.96, 0.5).at(6.2, 0.0, 0.002))
    world.see("planks_uv", sheet(5.2, 3.8, 0.5).at(6.2, 2.4, 0.003), sheet(5.0, 3.8, 0.5).at(4.25, -2.4, 0.004))
    world.see("carpet_uv", sheet(2.0, 3.8, 0.5).at(7.8, -2.4, 0.003))


def _stairs(world: Part) -> None:
    """Ten steps along -y, a landing, a hand rail."""
    x, y0, width = 8.2, -0.55, 1.1
    for number in range(STEPS):
        y, top = y0 - RUN * number, RISE * (number + 1)
        depth = RUN if number < STEPS - 1 else -y - 0.0 + SOUTH + 0.05
        depth = abs(depth) if number < STEPS - 1 else y - SOUTH - 0.05
        world.see("wood_uv", box(width, depth + 0.025, 0.035, 0.008).at(x, y - depth / 2.0 + 0.0125, top - 0.0175))
        world.see("paint_white", box(width - 0.02, 0.02, RISE - 0.03).at(x, y - 0.012, top - RISE / 2.0 - 0.015))
        world.box((width, y - SOUTH, RISE), (x, (y + SOUTH) / 2.0, top - RISE / 2.0))
    for number in range(0, STEPS, 1):
        y, top = y0 - RUN * (number + 0.5), RISE * (number + 1)
        world.see("paint_white", box(0.03, 0.03, 0.86).at(x - 0.53, y, top + 0.43))
    end = (x - 0.53, y0 - RUN * (STEPS - 0.5), RISE * STEPS + 0.88)
    world.see(
        "wood_uv", tube([(x - 0.53, y0 - 0.1, RISE + 0.85), end, (x - 0.53, SOUTH + 0.1, RISE * STEPS + 0.88)], 0.03, 8)
    )
    world.see("wood_uv", box(0.09, 0.09, 1.1, 0.012).at(x - 0.53, y0 + 0.0, 0.55))
    world.box((0.05, 0.09, 1.1), (x - 0.53, y0, 0.55))
    side = np.array([(y0, 0.0), (y0 - RUN * STEPS, RISE * STEPS)])
    world.see(
        "paint_white",
        box(0.03, float(np.hypot(*(side[1] - side[0]))) + 0.1, 0.26).at(
            x - 0.555,
            (side[0, 0] + side[1, 0]) / 2.0,
            RISE * STEPS / 2.0 - 0.02,
            rpy=(-math.atan2(RISE, RUN), 0.0, 0.0),
        ),
    )


def _rooms(world: Part) -> None:
    _table(world, (5.3, 2.6, 0.0))
    for number, (x, y, yaw) in enumerate(
        ((4.75, 1.95, 90.0), (5.85, 1.95, 90.0), (4.75, 3.25, -90.0), (5.85, 3.25, -90.0), (4.2, -3.35, -80.0))
    ):
        _chair(world, f"chair_{number + 1}", (x, y, 0.0), yaw)
    _sofa(world, (7.6, 3.55, 0.0))
    world.see("rug", sheet(2.2, 1.5).at(7.4, 2.0, 0.008))
    world.see("rug_light", *(sheet(2.2, 0.08).at(7.4, 2.0 + dy, 0.009) for dy in (-0.62, -0.45, 0.45, 0.62)))
    # a shelf with books, a desk with a screen, pictures, lamps
    boards = [box(0.30, 1.6, 0.03, 0.004).at(8.5, 1.6, 0.05 + 0.42 * n) for n in range(5)] + [
        box(0.30, 0.03, 1.75, 0.004).at(8.5, 1.6 + s * 0.8, 0.9) for s in (-1, 1)
    ]
    world.see("wood_uv", *boards)
    world.box((0.32, 1.66, 1.8), (8.5, 1.6, 0.9))
    random = np.random.default_rng(4)
    for level in range(4):
        y = 0.9
        while y < 2.25:
            thick, tall = random.uniform(0.025, 0.06), random.uniform(0.2, 0.32)
            material = str(
                random.choice(["paint_red", "paint_blue", "paint_green", "paint_white", "cushion", "plastic"])
            )
            world.see(material, box(0.2, thick - 0.003, tall).at(8.48, y + thick / 2, 0.066 + 0.42 * level + tall / 2))
            y += thick if random.uniform() > 0.06 else 0.22
    world.see(
        "wood_uv",
        box(1.4, 0.65, 0.035, 0.005).at(4.2, -3.8, 0.74),
        *(box(0.05, 0.6, 0.72).at(4.2 + s * 0.66, -3.8, 0.36) for s in (-1, 1)),
    )
    world.box((1.4, 0.65, 0.04), (4.2, -3.8, 0.74))
    for s in (-1, 1):
        world.box((0.05, 0.6, 0.72), (4.2 + s * 0.66, -3.8, 0.36))
    world.see(
        "screen",
        box(0.6, 0.02, 0.36, 0.004).at(4.2, -3.98, 1.02),
        box(0.22, 0.16, 0.015).at(4.2, -3.98, 0.765),
        box(0.05, 0.03, 0.12).at(4.2, -3.98, 0.8),
        box(0.42, 0.15, 0.02, 0.004).at(4.2, -3.68, 0.765),
    )
    for x, y, yaw in ((5.0, 0.54, 0.0), (6.2, 0.54, 0.0)):
        world.see("plastic", box(0.62, 0.03, 0.46, 0.006).at(x, y, 1.5, rpy=(0.0, 0.0, yaw)))
        world.see("cushion", picture(0.54, 0.38).at(x, y + 0.017, 1.5, rpy=(0.0, 0.0, math.pi)))
    bed = [box(2.0, 1.4, 0.22, 0.03).at(5.6, -1.35, 0.16), box(0.06, 1.45, 0.75, 0.01).at(6.66, -1.35, 0.4)]
    world.see("wood_uv", *bed)
    world.see(
        "paint_white",
        solid(block((1.95, 1.36, 0.22), 0.07, (0.0, 0.0, 0.0)), (-1.0, -0.7, -0.15), (1.0, 0.7, 0.15), 0.05, 500).at(
            5.6, -1.35, 0.36
        ),
        solid(block((0.4, 0.7, 0.16), 0.07), (-0.25, -0.4, -0.1), (0.25, 0.4, 0.1), 0.03, 300).at(6.35, -1.35, 0.52),
    )
    world.see(
        "paint_blue",
        solid(block((1.3, 1.42, 0.12), 0.05), (-0.7, -0.75, -0.1), (0.7, 0.75, 0.1), 0.05, 400).at(5.25, -1.35, 0.44),
    )
    world.box((2.05, 1.4, 0.5), (5.62, -1.35, 0.25))
    for number, (size, at, mass) in enumerate(
        (
            ((0.45, 0.35, 0.32), (2.5, -3.6, 0.161), 2.5),
            ((0.36, 0.30, 0.26), (2.52, -3.62, 0.452), 1.5),
            ((0.38, 0.38, 0.3), (2.6, 3.3, 0.151), 2.0),
        )
    ):
        carton = world.body(f"carton_{number + 1}", at, euler=(0.0, 0.0, 12.0 * number))
        carton.add("geom", type="box", size=np.array(size) / 2.0, mass=mass, material="cardboard")
    pot = world.body("pot", (4.05, 3.9, 0.001))
    pot.see(
        "clay", lathe([(0.0, 0.0), (0.11, 0.0), (0.15, 0.26), (0.165, 0.26), (0.165, 0.3), (0.14, 0.3), (0.0, 0.27)])
    )
    leaves = [
        box(0.015, 0.11, 0.5, 0.005).at(0.0, 0.0, 0.3).at(0.0, 0.0, 0.25, rpy=(0.5 * math.cos(a), 0.5 * math.sin(a), a))
        for a in np.arange(0.0, 6.2, 0.7)
    ]
    pot.see("leaves", *leaves)
    pot.cylinder(0.15, (0.0, 0.0, 0.0), (0.0, 0.0, 0.3), mass=5.0)
    basket = world.body("waste_bin", (3.1, -3.8, 0.001))
    basket.see("plastic", lathe([(0.0, 0.0), (0.11, 0.0), (0.14, 0.3), (0.13, 0.3), (0.10, 0.02), (0.0, 0.02)]))
    basket.cylinder(0.125, (0.0, 0.0, 0.0), (0.0, 0.0, 0.3), mass=0.8)


def _table(world: Part, at: Vector) -> None:
    x, y, z = at
    table = world.body("table", (x, y, z + 0.001))
    table.see(
        "wood_uv",
        box(1.6, 0.85, 0.035, 0.008).at(0.0, 0.0, 0.735),
        *(box(0.06, 0.06, 0.72, 0.006).at(sx * 0.72, sy * 0.35, 0.36) for sx in (-1, 1) for sy in (-1, 1)),
        *(box(1.4, 0.025, 0.09).at(0.0, s * 0.36, 0.67) for s in (-1, 1)),
    )
    table.box((1.6, 0.85, 0.035), (0.0, 0.0, 0.735), mass=14.0)
    for sx in (-1.0, 1.0):
        for sy in (-1.0, 1.0):
            table.box((0.06, 0.06, 0.72), (sx * 0.72, sy * 0.35, 0.36), mass=1.0, friction=[0.5, 0.005, 0.0001])


def _chair(world: Part, name: str, at: Vector, yaw: float) -> None:
    """A chair of 4 kg that looks along its x axis."""
    x, y, z = at
    chair = world.body(name, (x, y, z + 0.001), euler=(0.0, 0.0, yaw))
    legs = [tube([(0.19, s * 0.19, 0.0), (0.17, s * 0.18, 0.44)], 0.018, 8) for s in (-1, 1)]
    legs += [tube([(-0.21, s * 0.19, 0.0), (-0.18, s * 0.18, 0.45), (-0.23, s * 0.17, 0.9)], 0.018, 8) for s in (-1, 1)]
    back = [box(0.02, 0.36, 0.07, 0.006).at(-0.19 - 0.1 * (h - 0.5), 0.0, h) for h in (0.6, 0.73, 0.86)]
    chair.see("wood_uv", *legs, *back, box(0.42, 0.42, 0.03, 0.01).at(0.0, 0.0, 0.455))
    chair.box((0.42, 0.42, 0.03), (0.0, 0.0, 0.455), mass=1.6)
    chair.box((0.03, 0.38, 0.42), (-0.21, 0.0, 0.69), mass=0.8)
    for s in (-1.0, 1.0):
        for lx in (-0.2, 0.185):
            chair.box((0.034, 0.034, 0.44), (lx, s * 0.19, 0.22), mass=0.4, friction=[0.5, 0.005, 0.0001])


def _sofa(world: Part, at: Vector) -> None:
    x, y, z = at
    sofa = world.body("sofa", (x, y, z + 0.001))
    frame = union(
        block((1.9, 0.85, 0.26), 0.05, (0.0, 0.0, 0.23)),
        block((1.9, 0.22, 0.55), 0.08, (0.0, 0.33, 0.55)),
        *(block((0.2, 0.85, 0.42), 0.08, (s * 0.86, 0.0, 0.42)) for s in (-1, 1)),
        soft=0.02,
    )
    seats = [
        solid(block((0.74, 0.62, 0.18), 0.06), (-0.4, -0.35, -0.1), (0.4, 0.35, 0.1), 0.035, 420).at(
            s * 0.38, -0.08, 0.42
        )
        for s in (-1, 1)
    ]
    sofa.see("sofa_cloth", solid(frame, (-1.0, -0.5, 0.05), (1.0, 0.5, 0.9), 0.035, 1600), *seats)
    sofa.see(
        "cushion",
        *(
            solid(block((0.4, 0.13, 0.38), 0.06), (-0.25, -0.1, -0.25), (0.25, 0.1, 0.25), 0.03, 260).at(
                s * 0.55, 0.14, 0.66, rpy=(-0.25, 0.0, 0.15 * s)
            )
            for s in (-1, 1)
        ),
    )
    sofa.see(
        "plastic", *(cylinder(0.0, 0.1, 0.025, 0.0, 10).at(sx * 0.85, sy * 0.36) for sx in (-1, 1) for sy in (-1, 1))
    )
    sofa.box((1.9, 0.85, 0.42), (0.0, 0.0, 0.29), mass=34.0)
    sofa.box((1.9, 0.22, 0.4), (0.0, 0.33, 0.65), mass=6.0)
    for sx in (-1.0, 1.0):
        for sy in (-1.0, 1.0):
            sofa.box((0.05, 0.05, 0.1), (sx * 0.85, sy * 0.36, 0.05), mass=0.2, friction=[0.4, 0.005, 0.0001])


def _door(scene: Scene) -> None:
    """The door: hinge with a spring, lever with a spring, latch bolt with a bevel, and its strike plate."""
    world = scene.world
    x, hinge, width = 1.7, -0.45, 0.90
    world.see(
        "paint_white",
        *(box(0.24, 0.06, 2.06).at(x - 0.04, s * 0.485, 1.03) for s in (-1, 1)),
        box(0.24, 1.03, 0.06).at(x - 0.04, 0.0, 2.06),
    )
    world.see("concrete_uv", box(0.3, 1.0, 0.01, 0.003).at(x - 0.05, 0.0, 0.003))
    world.add(
        "geom",
        name="strike_plate",
        class_="solid",
        type="box",
        size=[0.008, 0.02, 0.05],
        pos=[x + 0.0195, 0.477, 1.0],
        solref=[0.004, 1.0],
    )
    leaf = world.body("door", (x, hinge, 0.0), free=False)
    leaf.add(
        "joint",
        name="door",
        type="hinge",
        axis=[0, 0, -1],
        range_=[0, 100],
        stiffness=3.5,
        springref=-90.0,
        damping=4.0,
    )
    panels = [
        box(0.05, 0.34, tall, 0.012).at(0.0, y, z) for y in (0.25, 0.65) for tall, z in ((0.55, 0.45), (0.75, 1.5))
    ]
    leaf.see("door_paint", box(0.04, width - 0.012, 2.02, 0.003).at(0.0, width / 2.0, 1.02), *panels)
    leaf.see(
        "steel",
        *(cylinder(-0.05, 0.05, 0.009, 0.0, 10).at(0.022, 0.0, z) for z in (0.25, 1.02, 1.8)),
        box(0.001, 0.8, 0.18).at(-0.0205, width / 2.0, 0.14),
    )
    leaf.box((0.04, width - 0.045, 2.0), (0.0, 0.035 + (width - 0.045) / 2.0 - 0.002, 1.02), mass=18.0)
    lever = leaf.body("door_handle", (0.0, width - 0.08, 1.0), free=False)
    lever.add(
        "joint",
        name="door_handle",
        type="hinge",
        axis=[1, 0, 0],
        range_=[0, 45],
        stiffness=1.2,
        springref=-30.0,
        damping=0.05,
        armature=0.002,
    )
    for side in (-1.0, 1.0):
        lever.see(
            "brass",
            cylinder(0.02, 0.028, 0.028, 0.003, 18).at(rpy=(0.0, side * math.pi / 2.0, 0.0)),
            tube(
                [
                    (side * 0.02, 0.0, 0.0),
                    (side * 0.062, 0.0, 0.0),
                    (side * 0.07, -0.012, 0.0),
                    (side * 0.07, -0.13, 0.0),
                ],
                0.010,
                8,
            ),
        )
        lever.capsule(
            0.011, (side * 0.07, 0.0, 0.0), (side * 0.07, -0.12, 0.0), mass=0.12, friction=[1.0, 0.005, 0.0001]
        )
    bolt = leaf.body("door_bolt", (0.0, width, 1.0), free=False)
    bolt.add(
        "joint",
        name="door_bolt",
        type="slide",
        axis=[0, 1, 0],
        range_=[-0.017, 0],
        stiffness=150.0,
        springref=0.02,
        damping=3.0,
        armature=0.05,
    )
    bolt.add(
        "geom",
        class_="solid",
        type="mesh",
        mesh="house/bolt",
        mass=0.15,
        condim=1.0,
        friction=[0.05, 0.005, 0.0001],
        solref=[0.004, 1.0],
        priority="2",
    )
    bolt.see("steel", box(0.02, 0.04, 0.024, 0.002).at(0.0, -0.012, 0.0))
    tendon = scene.section("tendon")
    rod = Part(tendon, "tendon").add("fixed", name="door_latch", limited="true", range_=[-1, 0])
    pull = Part(rod, "rod")
    pull.add("joint", joint="door_bolt", coef=1.0)
    pull.add("joint", joint="door_handle", coef=0.027)
