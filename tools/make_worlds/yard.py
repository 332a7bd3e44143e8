"""`yard`: where a bomb disposal unit trains: walls, a workshop, ramps, stairs, a table with a can."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from .plants import bush, tree
from .scene import Part, Scene
from .shapes import Mesh, Vector, box, cylinder, prism, sheet
from .yard_things import (
    UPRIGHT,
    add_barrier,
    add_cable_drum,
    add_container,
    add_digit,
    add_drums,
    add_sandbags,
    add_tyres,
    lamp_post,
    loop,
    railing,
)
from .yard_walls import AHEAD, BACK, LEFT, RIGHT, add_fence, add_gate, add_walls, add_workshop

ABOUT: Final = """
    A training yard, metres. Around the start it is free from (-2.5, -2.5) to (3, 0.7).
    To the left stands a table, 0.35 m high, with a can of 1 kg and two blocks on it; stairs of four steps are
    behind to the right.
    Ahead, a ramp of 12 degrees leads to a deck 0.4 m high; a steeper one (20 degrees) is to the right.
    Boxes with a free joint can be pushed. Walls and a gate are behind and to the left, a workshop is 12 m ahead,
    a fence 9 m to the right, open to the right of the start. Made by tools/make_worlds.
  """


def yard() -> Scene:
    """The whole yard."""
    scene = Scene("yard", ABOUT, middle=(1.0, 0.0, 0.5), extent=6.0)
    for name, rgba, shine in (
        ("grip", "0.22 0.22 0.225 1", "0.1"),
        ("iron", "0.16 0.155 0.15 1", "0.4"),
        ("dark", "0.05 0.05 0.055 1", "0.2"),
        ("lamp", "0.93 0.94 0.90 1", "0.8"),
        ("window_dark", "0.13 0.17 0.21 1", "0.9"),
        ("gate_green", "0.10 0.22 0.16 1", "0.3"),
        ("drum_blue", "0.09 0.22 0.42 1", "0.5"),
        ("drum_green", "0.16 0.26 0.17 1", "0.4"),
        ("leaves", "0.16 0.30 0.10 1", "0.05"),
        ("leaves_light", "0.24 0.40 0.14 1", "0.05"),
        ("bark", "0.25 0.19 0.14 1", "0.05"),
    ):
        scene.asset("material", name=name, rgba=rgba, specular=shine, shininess=shine)
    for name, texture, repeat, rgba in (
        ("container_uv", "metal", "0.7 0.7", "0.16 0.33 0.36 1"),
        ("container_frame_uv", "metal", "0.7 0.7", "0.12 0.26 0.29 1"),
        ("cladding_uv", "metal", "0.4 0.4", "0.72 0.74 0.72 1"),
        ("shutter_uv", "metal", "0.5 0.5", "0.50 0.55 0.58 1"),
        ("fascia_uv", "metal", "0.5 0.5", "0.16 0.24 0.30 1"),
        ("patch_uv", "asphalt", "0.5 0.5", "0.74 0.74 0.76 1"),
        ("sandbag_uv", "fabric", "5 5", "0.66 0.58 0.42 1"),
        ("sandbag_dark_uv", "fabric", "5 5", "0.56 0.50 0.37 1"),
    ):
        scene.asset(
            "material", name=name, texture=texture, texrepeat=repeat, rgba=rgba, specular="0.15", shininess="0.2"
        )
    world = scene.world
    _ground(world)
    add_walls(world.region("walls"))
    add_gate(world.region("gate"))
    add_fence(world.region("fence"))
    add_workshop(world.region("workshop"))
    ramps = world.region("ramps")
    _ramp(ramps, "", 0.0, angle=math.radians(12.0), length=1.92388, half=0.75, deck=1.6)
    _ramp(ramps, "steep_", -2.0, angle=math.radians(20.0), length=0.87714, half=0.6, deck=0.8)
    _stairs(world.region("steps"))
    _block(world)
    _table(world)
    _movable(world)
    add_container(world.region("container"), (6.8, -7.2, 0.0), 0.0)
    add_drums(world.region("drums"), (2.5, -7.7, 0.0))
    add_tyres(world.region("tyres"), (-2.5, 3.5, 0.0), 4)
    add_tyres(world.region("tyres_ahead"), (11.4, -4.7, 0.0), 3, 2)
    add_sandbags(world.region("sandbags"), (9.6, 0.9, 0.0), 7, 6)
    barriers = world.region("barriers")
    add_barrier(barriers, (6.4, -3.7, 0.0), 2.0)
    add_barrier(barriers, (8.5, -3.7, 0.0), 2.0)
    add_cable_drum(world.region("cable_drum"), (1.4, 3.62, 0.0))
    _plants(scene)
    return scene


def _ground(world: Part) -> None:
    """Asphalt, in which the floor is endless; lawns around; paint, drains, patches."""
    world.add("geom", name="floor", type="plane", size=[0, 0, 0.1], material="asphalt")
    far = 80.0
    for x0, x1, y0, y1 in (
        (-far, far, LEFT, far),
        (-far, BACK, -far, LEFT),
        (BACK, -1.3, -far, RIGHT - 0.1),
        (1.9, far, -far, RIGHT - 0.1),
        (AHEAD + 0.2, far, RIGHT - 0.1, LEFT),
    ):
        world.add(
            "geom",
            type="box",
            material="grass",
            contype=0,
            conaffinity=0,
            group=1,
            mass=0,
            pos=[(x0 + x1) / 2, (y0 + y1) / 2, -0.005],
            size=[(x1 - x0) / 2, (y1 - y0) / 2, 0.01],
        )
    line = 0.08
    white: list[Mesh] = []

    def bar(x: float, y: float, length: float, width: float, yaw: float = 0.0) -> None:
        white.append(box(length, width, 0.004).at(x, y, 0.002, rpy=(0.0, 0.0, yaw)))

    for y, half, start in ((0.0, 0.79, 1.0), (-2.0, 0.64, 1.6)):  # lanes to the ramps, with an arrow each
        for side in (-half, half):
            bar((start + 3.45) / 2, y + side, 3.45 - start, line)
        for side in (-1.0, 1.0):
            bar(3.22, y + side * 0.13, 0.36, 0.09, side * -0.80)
    add_digit(white, "1", 2.5, 0.0, 0.0)
    add_digit(white, "2", 2.5, -2.0, 0.0)
    for side in (-0.6, 0.6):  # the lane to the stairs
        bar(0.35, -3.2 + side, 1.8, line)
    add_digit(white, "3", 0.55, -3.2, math.pi)
    for x, y, sx, sy in ((0.62, 0.42, -1, -1), (0.62, -0.42, -1, 1), (-0.72, 0.42, 1, -1), (-0.72, -0.42, 1, 1)):
        bar(x + sx * 0.09, y, 0.26, line)  # where robots start
        bar(x, y + sy * 0.13, line, 0.18)
    for y in np.arange(-5.0, 3.9, 2.2):  # bays before the workshop
        bar(10.9, float(y), 2.0, line)
    world.see("marking_uv", *white)
    hatch = [box(3.3, 0.09, 0.004).at(5.05, y, 0.002) for y in (2.35, 3.85)]
    hatch += [box(0.09, 1.5, 0.004).at(x, 3.1, 0.002) for x in (3.45, 6.65)]
    hatch += [box(0.09, 1.75, 0.004).at(x, 3.1, 0.002, rpy=(0.0, 0.0, -0.62)) for x in np.arange(4.1, 6.2, 0.62)]
    world.see("marking_yellow_uv", *hatch)
    # a drain along the yard, a manhole, repairs
    y = -4.75
    world.see("concrete_uv", *(sheet(14.4, 0.07, 2.0).at(4.6, y + side, 0.003) for side in (-0.11, 0.11)))
    world.see("dark", box(14.4, 0.15, 0.004).at(4.6, y, 0.0))
    bars = [box(0.03, 0.15, 0.006).at(x, y, 0.002) for x in np.arange(-2.55, 11.8, 0.09)]
    lid = [cylinder(-0.01, 0.005, 0.27, 0.003, 28).at(-1.35, -1.55)]
    lid += [
        box(0.05, 0.05, 0.006).at(-1.35 + 0.09 * i, -1.55 + 0.09 * j, 0.004)
        for i in range(-2, 3)
        for j in range(-2, 3)
        if i * i + j * j < 7
    ]
    world.see("rust_uv", *bars)
    world.see("iron", *lid)
    world.see(
        "patch_uv",
        sheet(1.5, 0.9).at(0.4, 1.75, 0.003),
        sheet(0.6, 3.4).at(7.6, -5.4, 0.003),
        cylinder(-0.01, 0.003, 0.36, 0.0, 24).at(-1.35, -1.55),
        sheet(2.2, 1.2).at(-1.5, -6.7, 0.003),
    )


def _ramp(
    world: Part, name: str, y: float, *, angle: float, length: float, half: float, deck: float, x: float = 3.5
) -> None:
    """A ramp of concrete; its upper face starts at (x, y, 0) and is 2 * `half` wide, `deck` metres of deck follow."""
    run, high = length * math.cos(angle), length * math.sin(angle)
    body = world.body(f"{name}ramp", (x, y, 0.0), free=False, euler=(0.0, -math.degrees(angle), 0.0))
    body.box((length, 2 * half, 0.1), (length / 2, 0.0, -0.05), name=f"{name}ramp", material="concrete")
    end = x + run
    world.box(
        (deck, 2 * half, round(high, 2)),
        (end + deck / 2, y, round(high, 2) / 2),
        name=f"{name}deck",
        material="concrete",
    )
    start = 0.6  # from here on there is something below the slab, which has a thickness
    under = start * high - 0.1 / math.cos(angle)
    world.box(((1.0 - start) * run, 2 * half, under), (x + (1.0 + start) / 2 * run, y, under / 2), material="concrete")
    wedge = [(x, 0.0), (end, 0.0), (end, high), (x, 0.0005)]
    surface = prism(wedge, -half, half).at(rpy=UPRIGHT).at(0.0, y)
    world.see("concrete_uv", surface.flat(), box(deck, 2 * half, high, 0.012).at(end + deck / 2, y, high / 2))
    tilt = (0.0, -angle, 0.0)

    def on(along: float, side: float, mesh: Mesh) -> Mesh:
        return mesh.at(rpy=tilt).at(x + along * math.cos(angle), y + side, along * math.sin(angle))

    edges = [on(length / 2, side, box(length, 0.05, 0.004)) for side in (-half + 0.025, half - 0.025)]
    edges += [box(deck, 0.05, 0.004).at(end + deck / 2, y + side, high) for side in (-half + 0.025, half - 0.025)]
    world.see("marking_yellow_uv", *edges)
    strips = [on(float(at), 0.0, box(0.035, 2 * half - 0.24, 0.003)) for at in np.arange(0.16, length - 0.05, 0.12)]
    world.see("grip", *strips)
    for side in (-half - 0.003, half + 0.003):  # angle irons and anchors on the cheeks
        iron = box(length, 0.006, 0.05).at(length / 2, 0.0, -0.026)
        world.see(
            "rust_uv",
            iron.at(rpy=tilt).at(x, y + side, 0.0),
            box(deck, 0.006, 0.05).at(end + deck / 2, y + side, high - 0.026),
        )
    world.see("stripes_uv", box(0.006, 2 * half, 0.12).at(end + deck + 0.002, y, high - 0.07))


def _stairs(world: Part) -> None:
    """Steps of 18 cm with treads of 28 cm between handrails; the first begins at x = -0.6."""
    y, rise = -3.2, 0.18
    for number in range(4):
        start = -0.6 - 0.28 * number
        length = start + 3.2
        middle, low = start - length / 2, number * rise
        world.box((length, 1.0, rise), (middle, y, low + rise / 2), name=f"step_{number + 1}", material="concrete")
        world.see("concrete_uv", box(length, 1.0, rise, 0.008).at(middle, y, low + rise / 2).flat())
        world.see("stripes_uv", box(0.05, 0.98, 0.003).at(start - 0.033, y, low + rise))
        world.see("dark", box(0.003, 0.98, 0.03).at(start, y, low + rise - 0.03))
    for side in (-0.56, 0.56):
        outline = [(-3.2, 0.0), (-0.5, 0.0), (-0.5, 0.13), (-1.44, 0.76), (-3.2, 0.76)]
        cheek = prism(outline, -0.05, 0.05).at(rpy=UPRIGHT).at(0.0, y + side)
        world.see("concrete_uv", cheek.flat())
        world.box((1.76, 0.1, 0.76), (-2.32, y + side, 0.38), material="concrete")
        world.box((0.60, 0.1, 0.36), (-1.14, y + side, 0.18), material="concrete")
        posts: list[Vector] = [(-0.62, y + side, 0.21), (-1.44, y + side, 0.76), (-2.98, y + side, 0.76)]
        world.see("paint_yellow", *railing(posts, 0.9))
        for post in posts:
            world.cylinder(0.02, post, (post[0], post[1], post[2] + 0.9), material="paint_yellow")


def _block(world: Part) -> None:
    """A block of concrete with lifting loops, to drive around."""
    x, y = 2.2, -3.2
    world.box((0.8, 0.5, 0.5), (x, y, 0.25), name="block", material="concrete")
    world.see("concrete_uv", box(0.8, 0.5, 0.5, 0.02).at(x, y, 0.25).flat())
    bands = [box(0.12, 0.502, 0.40).at(x + dx, y, 0.25) for dx in (-0.28, 0.28)]
    bands += [box(0.12, 0.40, 0.502).at(x + dx, y, 0.25) for dx in (-0.28, 0.28)]
    world.see("stripes_uv", *bands, box(0.802, 0.34, 0.12).at(x, y, 0.25))
    world.see("rust_uv", *(loop(0.045).at(x + dx, y, 0.495) for dx in (-0.14, 0.14)))


def _table(world: Part) -> None:
    """A low bench of wood; what lies on it is in `_movable`."""
    table = world.body("table", (2.0, 1.05, 0.0), free=False)
    table.box((0.8, 0.5, 0.03), (0.0, 0.0, 0.335), name="table_top", material="wood")
    table.see("wood_uv", *(box(0.8, 0.121, 0.03, 0.003).at(0.0, y, 0.335) for y in (-0.189, -0.063, 0.063, 0.189)))
    for side, name in ((-0.37, "table_left"), (0.37, "table_right")):
        table.box((0.04, 0.46, 0.32), (side, 0.0, 0.16), name=name, material="wood")
        table.see("wood_uv", box(0.04, 0.46, 0.32, 0.004).at(side, 0.0, 0.16))
    table.see(
        "planks_uv",
        box(0.70, 0.03, 0.09, 0.004).at(0.0, 0.0, 0.25),
        box(0.70, 0.03, 0.05, 0.004).at(0.0, 0.17, 0.295),
        box(0.70, 0.03, 0.05, 0.004).at(0.0, -0.17, 0.295),
    )
    heads = [
        cylinder(-0.002, 0.0012, 0.007, 0.0, 8).at(x, y, 0.35)
        for x in (-0.37, 0.37)
        for y in (-0.19, -0.063, 0.063, 0.19)
    ]
    irons = [box(0.004, 0.05, 0.30).at(side * 0.392, y, 0.165) for side in (-1, 1) for y in (-0.17, 0.17)]
    table.see("steel", *heads, *irons)


def _movable(world: Part) -> None:
    """A can and blocks on the table, cartons, a crate."""
    can = world.body("can", (2.0, 0.9, 0.41))
    can.add("geom", name="can", type="cylinder", size=[0.025, 0.06], mass=1, friction=0.9, material="tin")
    for z in (-0.0573, 0.0573):
        can.add(
            "geom",
            type="cylinder",
            pos=[0, 0, z],
            size=[0.0253, 0.003],
            material="steel",
            contype=0,
            conaffinity=0,
            group=1,
            mass=0,
        )
    for name, at, size, mass, material in (
        ("block_small", (1.75, 1.05, 0.375), (0.025, 0.025, 0.025), 0.1, "wood_cube"),
        ("block_large", (2.25, 1.05, 0.39), (0.03, 0.03, 0.04), 0.3, "paint_blue"),
        ("carton_1", (3.4, 2.2, 0.15), (0.2, 0.15, 0.15), 1.5, "cardboard"),
        ("carton_2", (3.4, 2.2, 0.42), (0.15, 0.12, 0.12), 0.8, "cardboard"),
    ):
        world.body(name, at).add("geom", type="box", size=size, mass=mass, material=material)
    crate = world.body("crate", (-1.6, 3.2, 0.2), euler=(0.0, 0.0, 25.0))
    crate.add("geom", type="box", size=[0.3, 0.2, 0.2], mass=6, material="crate")


def _plants(scene: Scene) -> None:
    """Trees and bushes behind the walls, lamp posts; the same meshes in several places."""
    world = scene.world

    def put(meshes: dict[str, str], x: float, y: float, yaw: float = 0.0) -> None:
        for material, mesh in meshes.items():
            world.add("geom", class_="seen", mesh=mesh, material=material, pos=[x, y, 0.0], euler=[0.0, 0.0, yaw])

    def shapes(name: str, look: dict[str, Mesh], scale: float = 1.0) -> dict[str, str]:
        return {
            material: scene.shape(f"{name}.{material.removesuffix('_uv')}", mesh.scaled(scale, scale, scale))
            for material, mesh in look.items()
        }

    large, small = (
        shapes("tree", tree((0.0, 0.0, 0.0), 7, finer=1.15)[0], 1.45),
        shapes("young_tree", tree((0.0, 0.0, 0.0), 9)[0]),
    )
    shrub = shapes("bush", bush(3, (1.6, 1.1, 1.2)))
    for x, y, yaw in (
        (-0.6, 9.5, 0),
        (4.9, 8.2, 70),
        (10.2, 8.6, 200),
        (-8.6, 1.4, 130),
        (-7.2, 9.0, 20),
        (5.5, -13.5, 160),
        (-6.5, -13.0, 250),
        (20.0, 7.5, 110),
    ):
        put(large, x, y, yaw)
    for x, y, yaw in (
        (2.4, 6.4, 0),
        (-4.6, 5.6, 90),
        (-5.4, -2.2, 200),
        (8.2, 6.2, 300),
        (10.6, -11.2, 30),
        (3.9, -11.0, 140),
    ):
        put(small, x, y, yaw)
    for x, y, yaw in (
        (-1.9, 5.1, 0),
        (0.4, 5.2, 60),
        (-4.3, 1.6, 90),
        (-4.4, -0.2, 250),
        (7.4, 5.2, 180),
        (9.0, 5.3, 30),
        (-4.2, -5.0, 120),
        (-2.9, -10.1, 200),
        (2.6, -10.2, 330),
    ):
        put(shrub, x, y, yaw)
    lamp = shapes("lamp_post", lamp_post(5.2, 0.0))
    for x, y, yaw in ((3.1, 4.65, -60), (-3.7, -7.6, 20), (11.5, -9.5, 130)):
        put(lamp, x, y, yaw)
