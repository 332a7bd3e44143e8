"""`street`: a road with a parked car, a kerb, a pavement and a shop; somebody left a rucksack and a pipe with wires."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from .car import add_car
from .plants import tree
from .scene import Part, Scene
from .shapes import Mesh, Vector, box, cylinder, lathe, picture, prism, ring, sheet, tube, wall_pieces
from .solids import Field, block, solid, union
from .street_things import add_bin, add_cartons, add_cone, add_pipe, add_rucksack

ABOUT: Final = """
    A street along y, metres. The robot starts on the road, which is flat, and looks along x to a kerb of 0.1 m at
    x = 2; at y = -5 to -3 the kerb is lowered to 0.025 m. Behind the pavement, at x = 5.2, are a shop and a brick wall.
    To the left a car is parked with its driver's door open. On the pavement: a rucksack, a pipe with wires, cartons,
    a bag, a bin on wheels, cones. All these, and the doors of car and bin, move. Made by tools/make_worlds.
  """
KERB: Final = 0.10
LOWERED: Final = 0.025
EDGE: Final = 2.0
FRONT: Final = 5.2
"""x of the walls of the shop."""
HALF: Final = 26.0
"""Metres to the ends of the street, from the start."""


def street() -> Scene:
    """The whole street."""
    scene = Scene("street", ABOUT, middle=(1.0, 0.0, 1.0), extent=9.0)
    for name, rgba, shine in (
        ("lamp", "0.93 0.94 0.90 1", "0.8"),
        ("trim", "0.04 0.04 0.045 1", "0.5"),
        ("plate", "0.88 0.89 0.86 1", "0.3"),
        ("soot", "0.17 0.17 0.175 1", "0.1"),
        ("orange", "0.90 0.30 0.05 1", "0.2"),
        ("leaves", "0.16 0.30 0.10 1", "0.05"),
        ("leaves_light", "0.24 0.40 0.14 1", "0.05"),
        ("bark", "0.25 0.19 0.14 1", "0.05"),
        ("awning", "0.52 0.08 0.09 1", "0.1"),
        ("shop_wood", "0.10 0.20 0.17 1", "0.4"),
        ("canvas", "0.23 0.27 0.20 1", "0.02"),
        ("canvas_dark", "0.12 0.13 0.11 1", "0.05"),
        ("bag", "0.88 0.88 0.90 1", "0.6"),
        ("bin_green", "0.10 0.24 0.16 1", "0.3"),
        ("roof", "0.36 0.17 0.12 1", "0.05"),
        ("window_dark", "0.13 0.17 0.21 1", "0.9"),
        ("shop_sign", "0.90 0.84 0.62 1", "0.2"),
        ("pane", "0.30 0.38 0.42 0.30", "0.95"),
        ("wire_red", "0.75 0.06 0.05 1", "0.4"),
        ("wire_yellow", "0.90 0.72 0.08 1", "0.4"),
    ):
        scene.asset("material", name=name, rgba=rgba, specular=shine, shininess=shine)
    scene.asset(
        "material", name="patch_uv", texture="asphalt", texrepeat="0.5 0.5", rgba="0.68 0.68 0.7 1", specular="0.1"
    )
    world = scene.world
    _ground(world)
    _houses(world)
    _shop(world)
    _furniture(world)
    _far_side(world)
    add_car(world, (0.85, 4.9, 0.0), 90.0, 58.0)
    add_rucksack(world, (3.55, 0.75, KERB))
    add_pipe(world, (3.35, -0.55, KERB))
    add_bin(world, (4.75, -1.75, KERB))
    add_cartons(world, KERB)
    for number, (x, y) in enumerate(((-0.9, 1.6), (-1.3, 7.9), (1.2, 8.2))):
        add_cone(world, f"cone_{number + 1}", (x, y, 0.0))
    return scene


def _ground(world: Part) -> None:
    world.add("geom", name="road", class_="solid", type="plane", size=[0, 0, 1])
    world.see("asphalt_uv", sheet(7.0, 2 * HALF, 2.0).at(EDGE - 3.5))
    for near, far, spans in (
        (EDGE + 0.15, FRONT + 0.02, [(-HALF, -5.6), (-2.4, HALF)]),  # from the back of the kerb
        (-7.55, -5.15, [(-HALF, HALF)]),
    ):
        for low, high in spans:
            paving = sheet(far - near, high - low, 2.0)
            world.see("paving_uv", paving.at((near + far) / 2.0, (low + high) / 2.0, KERB))
    # mortar in the joints of the kerbs and behind their bevelled edges, where one would see through the ground
    for low, high in ((-HALF, -5.6), (-2.4, HALF)):
        world.see("concrete_uv", box(0.4, high - low, 0.1).at(EDGE + 0.212, (low + high) / 2.0, KERB - 0.064))
    world.see("concrete_uv", box(0.4, 2 * HALF, 0.1).at(-5.212, 0.0, KERB - 0.064))
    # below the joints of the lowered kerb
    world.see("concrete_uv", box(0.4, 3.2, 0.1).at(EDGE + 0.27, -4.0, LOWERED - 0.06))
    left, right = EDGE + 0.15, FRONT
    # the lowered kerb: the pavement falls towards it, and at both ends
    ys, heights = (-5.6, -5.0, -3.0, -2.4), (KERB, LOWERED, LOWERED, KERB)
    grid = np.array(
        [[(x, y, h if x < 3.3 else KERB) for x in (left, 3.3, right)] for y, h in zip(ys, heights, strict=True)]
    )
    number = np.arange(12).reshape(4, 3)
    triangles = [
        t
        for r in range(3)
        for c in range(2)
        for t in (
            (number[r, c], number[r, c + 1], number[r + 1, c + 1]),
            (number[r, c], number[r + 1, c + 1], number[r + 1, c]),
        )
    ]
    world.see("paving_uv", Mesh(grid.reshape(-1, 3), np.array(triangles)))
    stones = []
    step = 1.0
    for at in np.arange(-HALF, HALF, step):
        low, high = (np.interp([at, at + step], ys, heights)) if -6.0 <= at <= -2.0 else (KERB, KERB)
        stone = box(0.15, step - 0.012, 0.3, 0.012)
        lift = stone.vertices.copy()
        lift[:, 2] += (low + high) / 2.0 - 0.15 + (high - low) / step * lift[:, 1]
        stones.append(Mesh(lift, stone.triangles, stone.uv).at(EDGE + 0.075, at + step / 2.0))
        stones.append(box(0.15, step - 0.012, 0.3, 0.012).at(-5.075, at + step / 2.0, KERB - 0.15))
    world.see("concrete_uv", *stones)
    for low, high in ((-HALF, -5.6), (-2.4, HALF)):
        world.box((10.0, high - low, 0.3), (EDGE + 5.0, (low + high) / 2.0, KERB - 0.15))
    world.box((10.0, 2 * HALF, 0.3), (-10.0, 0.0, KERB - 0.15))
    world.box((6.7, 3.3, 0.3), (3.3 + 3.35, -4.0, KERB - 0.15))
    slope = math.atan2(KERB - LOWERED, 1.3)
    world.add(
        "geom",
        class_="solid",
        type="box",
        size=[0.66, 1.0, 0.05],
        pos=[2.65 + 0.05 * math.sin(slope), -4.0, 0.0625 - 0.05 * math.cos(slope)],
        euler=[0.0, -math.degrees(slope), 0.0],
    )
    for y, sign in ((-5.3, 1.0), (-2.7, -1.0)):  # the ends of it, a little below what is seen
        world.add(
            "geom",
            class_="solid",
            type="box",
            size=[0.66, 0.3, 0.05],
            pos=[2.66, y, 0.045 - 0.02],
            euler=[sign * -6.5, -1.6, 0.0],
        )
    # markings, a drain in the gutter, a manhole, patches
    line = [
        box(0.12, 1.5, 0.004).at(EDGE - 3.5, y, 0.002) for y in np.arange(-HALF + 1.0, HALF, 3.5) if abs(y + 4.0) > 2.5
    ]
    zebra = [box(0.5, 3.0, 0.004).at(x, -4.0, 0.002) for x in np.arange(-4.55, 2.0, 1.0)]
    bay = [box(0.10, 0.9, 0.004).at(-0.35, y, 0.002) for y in np.arange(2.0, 8.0, 1.5)]
    bay += [box(2.3, 0.10, 0.004).at(0.85, y, 0.002) for y in (1.9, 7.85)]
    world.see("marking_uv", *line, *zebra, *bay)
    world.see("concrete_uv", sheet(0.34, 2 * HALF, 2.0).at(EDGE - 0.17, 0.0, 0.002))
    bars = [box(0.34, 0.018, 0.012, 0.002).at(EDGE - 0.2, 1.05 + 0.045 * n, 0.006) for n in range(11)]
    bars += [box(0.03, 0.50, 0.012).at(EDGE - 0.2 + dx, 1.275, 0.006) for dx in (-0.17, 0.0, 0.17)]
    world.see(
        "rust_uv",
        *bars,
        cylinder(-0.01, 0.006, 0.33, 0.003, 28).at(-2.2, 0.6),
        ring(0.36, 0.012, 28, 6).at(-2.2, 0.6, 0.0),
    )
    world.see(
        "soot",
        box(0.36, 0.52, 0.006).at(EDGE - 0.2, 1.275, 0.001),
    )
    world.see("patch_uv", box(1.6, 2.4, 0.003).at(-3.2, 3.2, 0.001), sheet(0.5, 0.9).at(0.7, -1.7, 0.003))


def _window(world: Part, at: Vector, width: float, height: float, *, side: float = 1.0) -> None:
    """A window: frame, pane, sill; `side` is 1 on walls that look to -x."""
    x, y, z = at
    frame = 0.07
    bars = [
        box(0.08, width, frame).at(0.0, 0.0, height / 2),
        box(0.08, width, frame).at(0.0, 0.0, -height / 2),
        box(0.08, frame, height).at(0.0, width / 2, 0.0),
        box(0.08, frame, height).at(0.0, -width / 2, 0.0),
        box(0.06, 0.05, height),
        box(0.06, width, 0.04).at(0.0, 0.0, height * 0.18),
    ]
    world.see("paint_white", *(bar.at(x, y, z) for bar in bars))
    world.see("window_dark", box(0.02, width, height).at(x + 0.01 * side, y, z))
    world.see(
        "concrete_uv",
        box(0.22, width + 0.25, 0.08, 0.01).at(x - 0.07 * side, y, z - height / 2 - 0.07),
        box(0.16, width + 0.3, 0.16, 0.01).at(x - 0.01 * side, y, z + height / 2 + 0.1),
    )


def _houses(world: Part) -> None:
    """The row behind the pavement: brick with windows above, a cornice; the shop's opening is left out."""
    top, thick = 6.4, 0.4
    openings = [(HALF - 3.4, HALF + 3.3, 0.0, 3.0)]
    for y0, y1, z0, z1 in wall_pieces(2 * HALF, top, openings):
        world.see("brick_uv", box(thick, y1 - y0, z1 - z0).at(FRONT + thick / 2, (y0 + y1) / 2 - HALF, (z0 + z1) / 2))
        world.box((thick, y1 - y0, z1 - z0), (FRONT + thick / 2, (y0 + y1) / 2 - HALF, (z0 + z1) / 2))
    world.see(
        "concrete_uv",
        box(0.14, 2 * HALF, 0.22, 0.02).at(FRONT - 0.03, 0.0, 3.25),
        box(0.3, 2 * HALF, 0.3, 0.03).at(FRONT, 0.0, top),
    )
    for low, high in ((-HALF, -3.4), (3.3, HALF)):
        world.see("concrete_uv", box(0.10, high - low, 0.55, 0.01).at(FRONT, (low + high) / 2, 0.27))
    for y in np.arange(-23.0, 24.0, 2.6):
        _window(world, (FRONT - 0.01, float(y), 4.7), 1.1, 1.7)
        if abs(y) > 5.5:
            _window(world, (FRONT - 0.01, float(y), 1.75), 1.1, 1.5)
    pipe = [tube([(FRONT - 0.09, y, 0.15), (FRONT - 0.09, y, top - 0.1)], 0.05, 8) for y in (-9.4, 9.0)]
    world.see("metal_uv", *pipe)


def _shop(world: Part) -> None:
    """A shop with two large windows, a door set back between them, and an awning."""
    x = FRONT + 0.05
    wood = [box(0.14, 6.7, 0.5, 0.02).at(x, -0.05, KERB + 0.25), box(0.22, 6.9, 0.62, 0.03).at(x - 0.06, -0.05, 2.72)]
    wood += [box(0.16, 0.16, 2.4, 0.02).at(x, y, 1.4) for y in (-3.3, -2.0, -0.65, 0.65, 2.0, 3.2)]
    door = [box(0.06, 0.10, 2.2, 0.01).at(x + 0.03, y, 1.2) for y in (-0.52, 0.52)]
    door += [box(0.06, 1.1, 0.28, 0.01).at(x + 0.03, 0.0, 0.30), box(0.06, 1.1, 0.12, 0.01).at(x + 0.03, 0.0, 2.25)]
    world.see("shop_wood", *wood, *door)
    world.see(
        "steel",
        tube([(x - 0.05, 0.42, 0.9), (x - 0.09, 0.42, 0.95), (x - 0.09, 0.42, 1.35), (x - 0.05, 0.42, 1.4)], 0.014, 6),
    )
    world.see("pane", sheet(6.6, 2.0).at(x + 0.02, -0.05, 1.45, rpy=(math.pi / 2, 0.0, -math.pi / 2)))
    world.see(
        "plaster_uv",
        sheet(7.0, 2.8).at(FRONT + 2.2, 0.0, 1.5, rpy=(math.pi / 2, 0.0, -math.pi / 2)),
        sheet(2.2, 2.9).at(FRONT + 1.1, -3.38, 1.4, rpy=(math.pi / 2, 0.0, math.pi)),
        sheet(2.2, 2.9).at(FRONT + 1.1, 3.28, 1.4, rpy=(math.pi / 2, 0.0, 0.0)),
        sheet(2.4, 6.8).at(FRONT + 1.1, -0.05, 2.88, rpy=(math.pi, 0.0, 0.0)),
    )
    world.see("planks_uv", sheet(2.2, 6.7).at(FRONT + 1.1, -0.05, 0.12))
    shelves = [box(0.35, 5.6, 0.03).at(FRONT + 1.9, 0.0, z) for z in (0.7, 1.2, 1.7)]
    shelves += [box(0.5, 2.1, 0.5).at(FRONT + 0.5, y, 0.35) for y in (-2.0, 2.0)]
    world.see("wood_uv", *shelves)
    random = np.random.default_rng(5)
    goods: dict[str, list[Mesh]] = {"paint_red": [], "paint_yellow": [], "paint_white": [], "paint_green": []}
    for z in (0.715, 1.215, 1.715):
        for y in np.arange(-2.6, 2.7, 0.2):
            h, w = random.uniform(0.12, 0.34), random.uniform(0.08, 0.17)
            name = str(random.choice(list(goods)))
            goods[name].append(box(0.16, w, h).at(FRONT + 1.85, float(y), z + h / 2))
    for y in (-2.5, -2.0, -1.5, 1.5, 2.0, 2.5):
        goods["paint_white"].append(cylinder(0.6, 0.9, 0.1, 0.02, 12).at(FRONT + 0.4, y))
    for name, meshes in goods.items():
        world.see(name, *meshes)
    cloth: list[Mesh] = []
    red = True
    for y in np.arange(-3.4, 3.4, 0.4):
        (cloth if red else []).append(_stripe(float(y)))
        if not red:
            world.see("paint_white", _stripe(float(y)))
        red = not red
    world.see("awning", *cloth)
    world.see(
        "steel",
        tube([(FRONT - 1.05, -3.4, 2.32), (FRONT - 1.05, 3.4, 2.32)], 0.02, 6),
        *(tube([(FRONT, y, 2.5), (FRONT - 1.05, y, 2.32)], 0.014, 6) for y in (-3.3, 3.3)),
    )
    world.box((0.15, 6.7, 2.9), (x + 0.02, 0.0, 1.55))
    letters = picture(2.4, 0.3).at(FRONT - 0.125, -0.05, 2.77, rpy=(0.0, 0.0, -math.pi / 2))
    world.see("shop_sign", letters)


def _stripe(y: float) -> Mesh:
    """A stripe of the awning, with a scalloped end."""
    points = [(FRONT - 0.02, 2.98), (FRONT - 0.55, 2.68), (FRONT - 1.08, 2.36), (FRONT - 1.09, 2.20)]
    upper = np.array([[(x, y, z), (x, y + 0.4, z)] for x, z in points])
    rows = np.concatenate([upper, upper[::-1] - (0.0, 0.0, 0.012)])
    number = np.arange(len(rows) * 2).reshape(-1, 2)
    triangles = [
        t
        for r in range(len(rows) - 1)
        for t in ((number[r, 0], number[r + 1, 0], number[r + 1, 1]), (number[r, 0], number[r + 1, 1], number[r, 1]))
    ]
    return Mesh(rows.reshape(-1, 3), np.array(triangles)[:, ::-1]).flat()


def _furniture(world: Part) -> None:
    """What stands on the pavement and does not move: lamp, bollards, bench, a tree, a sign."""
    x, y = 2.45, -6.6
    post = [cylinder(KERB, 1.0, 0.09, 0.01), lathe([(0.06, 1.0), (0.055, 1.4), (0.045, 4.6), (0.0, 4.6)], 14)]
    arm = [(0.0, 0.0, 4.5), (-0.02, 0.0, 4.8), (-0.2, 0.0, 5.05), (-0.6, 0.0, 5.15), (-1.2, 0.0, 5.2)]
    for py in (y, 10.4):
        world.see("metal_uv", *(mesh.at(x, py) for mesh in (*post, tube(arm, 0.035, 8))))
        world.see("plastic", box(0.55, 0.22, 0.09, 0.03).at(x - 1.35, py, 5.2))
        world.see("lamp", box(0.42, 0.16, 0.03).at(x - 1.37, py, 5.15))
        world.cylinder(0.09, (x, py, 0.0), (x, py, 4.6))
    for by in (-2.3, -1.5, 1.6, 2.4, 3.2, 4.0):
        world.see(
            "metal_uv",
            lathe(
                [
                    (0.085, KERB),
                    (0.085, 0.16),
                    (0.055, 0.19),
                    (0.05, 0.85),
                    (0.06, 0.86),
                    (0.06, 0.92),
                    (0.04, 0.98),
                    (0.0, 1.0),
                ],
                14,
            ).at(2.4, by),
        )
        world.see("paint_white", cylinder(0.72, 0.80, 0.0535, 0.0, 14).at(2.4, by))
        world.cylinder(0.055, (2.4, by, KERB), (2.4, by, 1.0))
    slats = [box(0.07, 1.6, 0.035, 0.008).at(4.45 + 0.09 * n, 4.4, 0.55) for n in range(5)]
    slats += [box(0.03, 1.6, 0.08, 0.008).at(4.90 + 0.02 * n, 4.4, 0.70 + 0.12 * n) for n in range(3)]
    world.see("planks_uv", *(slat.mapped(turned=True) for slat in slats))
    for by in (3.75, 5.05):
        world.see(
            "rust_uv",
            tube([(4.42, by, 0.1), (4.45, by, 0.52), (4.85, by, 0.52), (4.97, by, 1.0)], 0.022, 6),
            tube([(4.85, by, 0.52), (4.92, by, 0.1)], 0.022, 6),
        )
    world.box((0.5, 1.6, 0.47), (4.65, 4.4, 0.335))
    world.box((0.08, 1.6, 0.45), (4.93, 4.4, 0.8))
    _tree(world, (2.9, 7.4, KERB), 7)
    _tree(world, (-6.4, 10.5, KERB), 8)
    _tree(world, (-6.2, -4.5, KERB), 9)
    _tree(world, (-6.2, 15.0, KERB), 10)
    _tree(world, (2.9, -13.0, KERB), 11)
    sx, sy = 2.5, 2.05
    world.see("metal_uv", cylinder(KERB, 2.55, 0.03, 0.0, 10).at(sx, sy))
    face = lathe([(0.0, -0.01), (0.26, -0.01), (0.26, 0.01), (0.0, 0.01)], 28)
    turn = (0.0, -math.pi / 2, 0.0)
    world.see("paint_red", face.at(sx - 0.04, sy, 2.3, rpy=turn))
    world.see("paint_blue", face.scaled(0.8, 0.8, 1.0).at(sx - 0.048, sy, 2.3, rpy=turn))
    world.see("paint_red", box(0.006, 0.42, 0.055).at(sx - 0.06, sy, 2.3, rpy=(math.pi / 4, 0.0, 0.0)))
    world.cylinder(0.03, (sx, sy, KERB), (sx, sy, 2.5))
    world.see(
        "rust_uv",
        cylinder(0.0, 0.10, 0.30, 0.01, 24).at(3.9, -2.9, KERB - 0.098),
        cylinder(0.10, 0.104, 0.26, 0.0, 24).at(3.9, -2.9, KERB - 0.098),
    )


def _tree(world: Part, at: Vector, seed: int) -> None:
    look, height = tree(at, seed)
    for material, mesh in look.items():
        world.see(material, mesh)
    world.cylinder(0.11, at, (at[0], at[1], at[2] + height))


def _far_side(world: Part) -> None:
    """The other side: a low wall, a lawn, houses farther away, and the ends of the street."""
    world.see("grass_uv", sheet(16.0, 2 * HALF, 4.0).at(-15.9, 0.0, KERB + 0.02))
    world.see("brick_uv", box(0.25, 2 * HALF, 0.7).at(-7.7, 0.0, KERB + 0.35))
    world.see("concrete_uv", box(0.34, 2 * HALF, 0.08, 0.02).at(-7.7, 0.0, KERB + 0.74))
    world.box((0.3, 2 * HALF, 0.9), (-7.7, 0.0, 0.45))
    for y in np.arange(-22.0, 23.0, 11.0):
        world.see("plaster_uv", box(7.0, 8.6, 5.4).at(-19.0, float(y), 2.7))
        roof = prism([(-4.0, 0.0), (4.0, 0.0), (0.0, 2.8)], -4.6, 4.6).at(rpy=(math.pi / 2, 0.0, 0.0))
        world.see("roof", roof.at(-19.0, float(y), 5.4))
        for dy in (-2.6, 0.0, 2.6):
            for z in (1.6, 4.1):
                if (dy, z) != (0.0, 1.6):
                    _window(world, (-15.49, float(y) + dy, z), 1.1, 1.4, side=-1.0)
        world.see("shop_wood", box(0.08, 1.0, 2.1, 0.02).at(-15.48, float(y), 1.05 + KERB))
    for y in (-HALF, HALF):
        world.see("grass_uv", sheet(60.0, 30.0, 5.0).at(-5.0, y + math.copysign(15.0, y), -0.02))
    world.see("grass_uv", sheet(60.0, 110.0, 10.0).at(40.0 + FRONT - 10, 0.0, -0.03))
    hedge = solid(_hedge(12), (-6.0, -0.8, 0.0), (6.0, 0.8, 2.4), 0.28, 900).flat()
    for y in (-HALF - 3.0, HALF + 3.0):
        world.see("leaves", hedge.at(-1.5, y))
        world.box((14.0, 1.0, 2.0), (-1.5, y, 1.0))


def _hedge(seed: int) -> Field:
    random = np.random.default_rng(seed)
    return union(
        *(
            block((1.2, 1.2, 1.6), 0.5, (x, random.uniform(-0.2, 0.2), random.uniform(0.7, 1.2)))
            for x in np.arange(-5.6, 6.0, 0.75)
        )
    )
