"""`rubble`: a height map with broken slabs, bent bars, beams, the rest of a wall, and loose stones."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, TypeAlias

import mujoco
import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter, map_coordinates
from scipy.spatial import ConvexHull

from .scene import WORLDS, Part, Scene, numbers, obj
from .shapes import Array, Mesh, box, joined, prism, tube

ABOUT: Final = """
    Rubble, metres: a height map of 16 x 16, up to 0.8 high, flat around the start. Broken slabs, the rest of a wall and
    bars of steel stand fast; stones of 0.3 to 25 kg and beams of wood are loose. Made by tools/make_worlds.
  """
SIDE: Final = 8.0
CELLS: Final = 97
TOP: Final = 0.8
STONES: Final = 28
Level: TypeAlias = Callable[[float, float], float]


def heights() -> Array:
    """Heights on the grid, rows along y."""
    random = np.random.default_rng(17)
    coarse = gaussian_filter(random.normal(size=(CELLS, CELLS)), 8.0)
    fine = gaussian_filter(random.normal(size=(CELLS, CELLS)), 2.2)
    made = 0.5 + 0.23 * coarse / coarse.std() + 0.05 * fine / fine.std()
    x, y = np.meshgrid(np.linspace(-SIDE, SIDE, CELLS), np.linspace(-SIDE, SIDE, CELLS))
    flat = np.clip((np.hypot(x, y) - 1.25) / 2.2, 0.0, 1.0)
    lane = np.clip((np.abs(y - 0.5 * np.sin(x)) - 0.5) / 1.6, 0.0, 1.0) ** 0.8  # a way ahead that a robot can take
    ahead = np.where(x > 0.0, 0.35 + 0.65 * lane, 1.0)
    made = np.clip(made, 0.02, 1.0) * flat**1.3 * ahead
    return np.asarray(np.round(np.clip(made, 0.0, 1.0) * 255.0) / 255.0 * TOP)


def rubble() -> Scene:
    """The whole site."""
    scene = Scene("rubble", ABOUT, middle=(1.0, 0.0, 0.5), extent=7.0)
    for name, rgba, shine in (("dust", "0.55 0.52 0.47 1", "0.02"), ("rock", "0.47 0.45 0.42 1", "0.05")):
        scene.asset("material", name=name, rgba=rgba, specular=shine, shininess=shine)
    ground = heights()
    folder = WORLDS / "assets" / "rubble"
    folder.mkdir(parents=True, exist_ok=True)
    Image.fromarray(np.rint(ground[::-1] / TOP * 255.0).astype(np.uint8)).save(folder / "ground.png", optimize=True)
    scene.asset("hfield", name="ground", file="assets/rubble/ground.png", size=f"{SIDE} {SIDE} {ground.max():.5g} 0.1")
    world = scene.world
    world.add("geom", name="ground", type="hfield", hfield="ground", material="soil", friction=[0.9, 0.005, 0.0001])
    world.see("soil_uv", *_border())

    def level(x: float, y: float) -> float:
        place = [[(y + SIDE) / (2 * SIDE) * (CELLS - 1)], [(x + SIDE) / (2 * SIDE) * (CELLS - 1)]]
        return float(map_coordinates(ground, place, order=1)[0])

    random = np.random.default_rng(23)
    _pebbles(world, random, level)
    _slabs(scene, random, level)
    _wall(world, level)
    _bars(world, random, level)
    _beams(world, level)
    shapes = [_stone(random) for _ in range(6)]
    for number, shape in enumerate(shapes):
        scene.files[f"stone_{number}.obj"] = obj(shape)
    places: list[tuple[float, float, float]] = []
    while len(places) < STONES:
        x, y = random.uniform(-4.5, 6.5), random.uniform(-4.5, 4.5)
        radius = float(random.choice([0.045, 0.06, 0.08, 0.11, 0.16], p=[0.28, 0.27, 0.22, 0.15, 0.08]))
        clear = all(math.hypot(x - px, y - py) > radius + pr + 0.06 for px, py, pr in places)
        if clear and math.hypot(x, y) > 1.35 and not (4.0 < x < 6.6 and abs(y) > 2.2):
            places.append((x, y, radius))
    for number, (x, y, radius) in enumerate(places):
        kind, name = number % len(shapes), f"stone_{number + 1}"
        scene.asset(
            "mesh", name=name, file=f"assets/rubble/stone_{kind}.obj", scale=f"{radius} {radius} {radius * 0.8:.4g}"
        )
        stone = world.body(
            name,
            (x, y, max(level(x + a, y + b) for a in (-0.05, 0, 0.05) for b in (-0.05, 0, 0.05)) + 0.55 * radius),
            free=False,
        )
        volume = ConvexHull(shapes[kind].vertices).volume * radius**3 * 0.8
        stone.add("joint", type="free", damping=0.4 * 2300.0 * volume)  # dust and splinters: it rocks little
        stone.add(
            "geom",
            type="mesh",
            mesh=name,
            material="rock" if number % 3 else "dust",
            mass=2300.0 * volume,
            friction=[0.8, 0.02, 0.01],
            condim=6.0,
        )
    _settle(scene)
    return scene


def _settle(scene: Scene) -> None:
    """Put the loose bodies where they come to rest."""
    scene.write()
    model = mujoco.MjModel.from_xml_path(str(WORLDS / "rubble.xml"))
    model.opt.timestep, model.opt.cone, model.opt.impratio = 0.002, mujoco.mjtCone.mjCONE_ELLIPTIC, 10.0
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 8000)
    for part in scene.world.parts:
        body = data.body(part.name)
        part.element.set("pos", numbers(body.xpos))
        part.element.set("quat", numbers(body.xquat))
        if "euler" in part.element.attrib:
            del part.element.attrib["euler"]
    scene.forget_meshes()


def _stone(random: np.random.Generator) -> Mesh:
    """A convex stone of radius 1: a block with its corners knocked off."""
    points = random.normal(size=(26, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    points *= random.uniform(0.82, 1.1, (26, 1)) * np.array([1.15, 0.95, 0.85])
    return hull(points)


def hull(points: Array) -> Mesh:
    """The convex hull of points, shaded flat."""
    made = ConvexHull(points)
    faces = []
    for simplex, equation in zip(made.simplices, made.equations, strict=True):
        a, b, c = points[simplex]
        flip = float(np.cross(b - a, c - a) @ equation[:3]) < 0.0
        faces.append(simplex[::-1] if flip else simplex)
    return Mesh(points, np.array(faces)).flat()


def _border() -> list[Mesh]:
    """Flat ground around the height map, so that it does not end in the air."""
    far = 40.0
    strip = box(2 * far, far - SIDE, 0.02)
    middle = (far + SIDE) / 2.0
    side = box(far - SIDE, 2 * SIDE, 0.02)
    return [
        strip.at(0.0, middle, -0.01),
        strip.at(0.0, -middle, -0.01),
        side.at(middle, 0.0, -0.01),
        side.at(-middle, 0.0, -0.01),
    ]


def _pebbles(world: Part, random: np.random.Generator, level: Level) -> None:
    shapes = [_stone(random) for _ in range(4)]
    made: dict[str, list[Mesh]] = {"dust": [], "rock": [], "brick_uv": []}
    for number in range(420):
        x, y = random.uniform(-7.5, 7.5, 2)
        if math.hypot(x, y) < 0.9:
            continue
        size = random.uniform(0.012, 0.045)
        if number % 4 == 0:
            piece = box(0.11 * random.uniform(0.5, 1.0), 0.10, 0.06, 0.008)
            made["brick_uv"].append(
                piece.at(
                    x,
                    y,
                    level(x, y) + 0.01,
                    rpy=(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0, 3)),
                )
            )
        else:
            made["dust" if number % 2 else "rock"].append(
                shapes[number % 4]
                .scaled(size, size, size * 0.7)
                .at(x, y, level(x, y) + size * 0.2, rpy=(0.0, 0.0, random.uniform(0, 6)))
            )
    for material, meshes in made.items():
        world.see(material, *meshes)


def _slabs(scene: Scene, random: np.random.Generator, level: Level) -> None:
    """Broken slabs of concrete, which lie tilted; bars stick out of their edges."""
    placed = (
        (3.3, 1.7, 0.9, 0.10, 0.05, 0.4),
        (3.0, -1.9, 1.1, -0.22, 0.16, 1.9),
        (5.2, 0.4, 1.2, 0.06, -0.20, 0.9),
        (-2.8, 2.2, 1.0, 0.30, 0.12, 2.2),
        (-3.0, -2.4, 1.3, -0.12, 0.25, 0.2),
        (0.6, -3.2, 1.0, 0.35, -0.1, 1.2),
        (1.2, 3.3, 1.2, -0.3, 0.1, 2.9),
    )
    for number, (x, y, size, roll, pitch, yaw) in enumerate(placed):
        turns = np.sort(random.uniform(0.0, math.tau, 7) * 0.25 + np.arange(7) * math.tau / 7)
        reach = size * random.uniform(0.6, 0.8, 7)
        outline = np.column_stack([reach * np.cos(turns), reach * 0.8 * np.sin(turns)])
        thick = 0.14
        convex = outline[ConvexHull(outline).vertices]
        slab = prism([(float(a), float(b)) for a, b in convex], -thick / 2, thick / 2)
        z = level(x, y) + 0.02 + 0.25 * size * abs(math.sin(pitch)) + 0.2 * size * abs(math.sin(roll))
        placed_slab = slab.at(x, y, z, rpy=(roll, pitch, yaw))
        scene.files[f"slab_{number}.obj"] = obj(placed_slab)
        scene.asset("mesh", name=f"slab_{number}", file=f"assets/rubble/slab_{number}.obj")
        scene.world.add(
            "geom", type="mesh", mesh=f"slab_{number}", material="concrete_uv", friction=[0.9, 0.005, 0.0001]
        )
        bars = []
        for corner in convex[::2]:
            direction = corner / np.linalg.norm(corner)
            path = [(*(corner * 0.7), 0.0), (*(corner + 0.06 * direction), 0.0)]
            path += [
                (
                    *(corner + (0.14 + 0.1 * t) * direction + 0.05 * t * random.normal(size=2)),
                    0.06 * t * random.uniform(0.0, 1.0),
                )
                for t in (1, 2, 3)
            ]
            bars.append(tube(path, 0.007, 6).at(x, y, z, rpy=(roll, pitch, yaw)))
        scene.world.see("rust_uv", joined(bars))


def _wall(world: Part, level: Level) -> None:
    """The rest of a brick wall, broken down in steps, with the hole of a window."""
    x0, y = 4.2, 3.4
    columns = (1.9, 1.75, 1.5, 1.62, 1.2, 0.95, 0.7, 0.55, 0.3)
    for number, height in enumerate(columns):
        x, z = x0 + 0.26 * number, level(x0 + 0.26 * number, y) - 0.1
        pieces = [(0.0, height)] if number not in (2, 3) else [(0.0, 0.8), (1.35, height)]
        for low, high in pieces:
            world.see("brick_uv", box(0.26, 0.24, high - low).at(x, y, z + (low + high) / 2))
            world.box((0.26, 0.24, high - low), (x, y, z + (low + high) / 2))
    world.see("concrete_uv", box(0.6, 0.3, 0.1, 0.01).at(x0 + 0.65, y, level(x0, y) + 0.72))


def _bars(world: Part, random: np.random.Generator, level: Level) -> None:
    """Bent bars of steel that stick out of the ground, and a steel beam."""
    for x, y in ((2.4, -1.0), (2.5, -1.12), (4.4, -1.3), (4.1, 1.9), (-2.0, 1.2), (-1.9, -2.0)):
        z, turn = level(x, y), random.uniform(0, math.tau)
        dx, dy = math.cos(turn), math.sin(turn)
        path = [
            (x, y, z - 0.1),
            (x, y, z + 0.18),
            (x + 0.05 * dx, y + 0.05 * dy, z + 0.32),
            (x + 0.2 * dx, y + 0.2 * dy, z + 0.42),
            (x + 0.42 * dx, y + 0.42 * dy, z + 0.40),
        ]
        world.see("rust_uv", tube(path, 0.008, 7))
        for start, end in ((0, 1), (1, 3), (3, 4)):
            world.capsule(0.008, path[start], path[end])
    beam = [box(3.0, 0.14, 0.012).at(0.0, 0.0, s * 0.094) for s in (-1, 1)] + [box(3.0, 0.01, 0.18)]
    place, tilt = (-3.2, 0.4, level(-3.2, 0.4) + 0.22), (0.15, -0.09, 1.2)
    world.see("rust_uv", *(part.at(*place, rpy=tilt) for part in beam))
    world.add("geom", class_="solid", type="box", size=[1.5, 0.07, 0.1], pos=place, euler=np.degrees(tilt))


def _beams(world: Part, level: Level) -> None:
    """Beams of wood, loose."""
    for number, (x, y, length, yaw) in enumerate(
        ((1.9, -1.9, 1.3, 70.0), (2.75, 0.55, 1.4, 10.0), (-1.3, -1.5, 1.2, -30.0))
    ):
        a = math.radians(yaw)
        ends = [(x + s * length / 2.0 * math.cos(a), y + s * length / 2.0 * math.sin(a)) for s in (-1, -0.5, 0, 0.5, 1)]
        beam = world.body(
            f"beam_{number + 1}", (x, y, max(level(*end) for end in ends) + 0.06), free=False, euler=(0.0, 0.0, yaw)
        )
        beam.add("joint", type="free", damping=1.5)
        beam.see("planks_uv", box(length, 0.10, 0.08, 0.006))
        beam.box((length, 0.10, 0.08), (0.0, 0.0, 0.0), mass=600.0 * length * 0.008, friction=[0.8, 0.005, 0.0001])
