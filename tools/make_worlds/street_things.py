"""Things of `street` that a robot may move: rucksack, pipe, bin, cartons, a bag, cones."""

from __future__ import annotations

import math

import numpy as np

from .scene import Part
from .shapes import Mesh, Vector, box, cylinder, lathe, tube
from .solids import block, solid, union


def add_rucksack(world: Part, at: Vector) -> None:
    """A rucksack of 2 kg that stands; its grab strap hinges, and a gripper can lift it by that."""
    x, y, z = at
    sack = world.body("rucksack", (x, y, z + 0.004))
    bag = union(
        block((0.20, 0.30, 0.44), 0.075, (0.0, 0.0, 0.22)),
        block((0.11, 0.22, 0.22), 0.05, (-0.11, 0.0, 0.14)),
        block((0.20, 0.07, 0.18), 0.03, (0.0, 0.16, 0.12)),
        block((0.20, 0.07, 0.18), 0.03, (0.0, -0.16, 0.12)),
        block((0.21, 0.29, 0.09), 0.04, (-0.02, 0.0, 0.41)),
        soft=0.02,
    )
    sack.see("canvas", solid(bag, (-0.2, -0.22, 0.0), (0.13, 0.22, 0.5), 0.014, 2600))
    straps = []
    for side in (-0.09, 0.09):
        straps.append(
            _strap(
                [
                    (0.09, side, 0.40),
                    (0.14, side, 0.38),
                    (0.165, side * 1.15, 0.28),
                    (0.155, side * 1.2, 0.16),
                    (0.10, side * 1.25, 0.05),
                ],
                0.05,
            )
        )
        straps.append(_strap([(-0.115, side, 0.44), (-0.135, side, 0.36), (-0.168, side, 0.27)], 0.025))
    seams = [tube([(-0.170, s * 0.10, 0.06), (-0.170, s * 0.10, 0.22)], 0.004, 4) for s in (-1, 1)]
    seams.append(tube([(-0.162, -0.10, 0.225), (-0.168, 0.0, 0.235), (-0.162, 0.10, 0.225)], 0.006, 5))
    sack.see("canvas_dark", *straps, *seams)
    sack.see("steel", *(box(0.008, 0.034, 0.022, 0.003).at(-0.165, s, 0.285) for s in (-0.09, 0.09)))
    sack.box((0.20, 0.30, 0.42), (0.0, 0.0, 0.212), mass=1.8, friction=[0.9, 0.005, 0.0001])
    sack.box((0.10, 0.20, 0.20), (-0.11, 0.0, 0.13), mass=0.1)
    strap = sack.body("rucksack_strap", (0.02, 0.0, 0.435), free=False)
    strap.add(
        "joint",
        name="rucksack_strap",
        type="hinge",
        axis=[0, 1, 0],
        range_=[-70, 70],
        stiffness=0.05,
        damping=0.01,
        armature=0.0005,
    )
    bow = [(0.0, 0.07 * math.cos(a), 0.075 * math.sin(a)) for a in np.linspace(0.0, math.pi, 11)]
    bow = [(0.0, 0.07, -0.02), *((px, py, pz + 0.01) for px, py, pz in bow), (0.0, -0.07, -0.02)]
    strap.see("canvas_dark", _strap(bow, 0.028, across=(1.0, 0.0, 0.0)))
    for start, end in (
        ((0.0, 0.068, 0.0), (0.0, 0.045, 0.075)),
        ((0.0, 0.045, 0.075), (0.0, -0.045, 0.075)),
        ((0.0, -0.045, 0.075), (0.0, -0.068, 0.0)),
    ):
        strap.capsule(0.008, start, end, mass=0.02, friction=[1.2, 0.01, 0.001], condim=4.0, solref=[0.005, 1.0])


def _strap(path: list[Vector], width: float, thickness: float = 0.006, across: Vector = (0.0, 1.0, 0.0)) -> Mesh:
    """A flat band along a path; `across` is its width."""
    points = np.array(path)
    along = np.gradient(points, axis=0)
    side = np.array(across)
    up = np.cross(along, side)
    up /= np.linalg.norm(up, axis=1)[:, None]
    rows = []
    for point, normal in zip(points, up, strict=True):
        w, t = side * width / 2.0, normal * thickness / 2.0
        rows.append([point - w - t, point + w - t, point + w + t, point - w + t, point - w - t])
    grid = np.array(rows)
    number = np.arange(grid.shape[0] * 5).reshape(-1, 5)
    a, b, c, d = (part.ravel() for part in (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]))
    return Mesh(grid.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


def add_pipe(world: Part, at: Vector) -> None:
    """A capped steel pipe of 1 kg along x, painted red, with a timer, a battery and wires."""
    x, y, z = at
    pipe = world.body("pipe_device", (x, y, z + 0.031), euler=(0.0, 0.0, 12.0))
    turn = (0.0, math.pi / 2, 0.0)
    cap = lathe([(0.0, 0.0), (0.029, 0.0), (0.031, 0.003), (0.031, 0.038), (0.027, 0.040), (0.0, 0.040)], 8)
    pipe.see("paint_red", cylinder(-0.13, 0.13, 0.024, 0.0, 22).at(rpy=turn))
    pipe.see("rust_uv", cap.at(0.125, rpy=turn), cap.at(-0.125, rpy=(0.0, -math.pi / 2, 0.0)))
    tape = [cylinder(-0.012, 0.012, 0.0255, 0.0, 20).at(dx, rpy=turn) for dx in (-0.075, 0.075)]
    pipe.see(
        "trim",
        *tape,
        box(0.075, 0.04, 0.022, 0.004).at(-0.05, 0.0, 0.035),
        box(0.05, 0.026, 0.018, 0.003).at(0.055, 0.0, 0.033),
    )
    pipe.see("lamp", box(0.045, 0.022, 0.002).at(-0.055, 0.0, 0.0465))
    pipe.see("copper", box(0.008, 0.026, 0.018, 0.002).at(0.083, 0.0, 0.033))
    pipe.see(
        "wire_red",
        tube(
            [
                (-0.02, 0.012, 0.04),
                (0.0, 0.022, 0.056),
                (0.03, 0.02, 0.05),
                (0.08, 0.008, 0.046),
                (0.11, 0.006, 0.05),
                (0.135, 0.0, 0.03),
                (0.165, 0.004, 0.012),
            ],
            0.0022,
            5,
        ),
    )
    pipe.see(
        "wire_yellow",
        tube([(-0.02, -0.012, 0.04), (0.005, -0.02, 0.052), (0.04, -0.022, 0.046), (0.085, -0.008, 0.044)], 0.0022, 5),
    )
    pipe.see(
        "paint_blue",
        tube([(-0.085, 0.008, 0.04), (-0.11, 0.012, 0.052), (-0.14, 0.006, 0.04), (-0.166, 0.0, 0.01)], 0.0022, 5),
    )
    pipe.cylinder(0.024, (-0.125, 0.0, 0.0), (0.125, 0.0, 0.0), mass=0.7, friction=[1.0, 0.01, 0.004], condim=6.0)
    for sign in (-1.0, 1.0):
        pipe.box((0.04, 0.05, 0.06), (sign * 0.145, 0.0, 0.0), mass=0.15, friction=[0.9, 0.01, 0.004])
    pipe.box((0.14, 0.04, 0.022), (0.0, 0.0, 0.035), mass=0.05)


def add_bin(world: Part, at: Vector) -> None:
    """A bin on two wheels, 11 kg, with a lid that opens; it tips over."""
    x, y, z = at
    tub = world.body("bin", (x, y, z + 0.002), euler=(0.0, 0.0, 90.0))

    def taper(low: float, high: float, z0: float, z1: float, wall_: float) -> Mesh:
        grid = []
        for level, half in ((z0, low), (z1, high), (z1, high - wall_), (z0 + 0.02, low - wall_)):
            grid.append(
                [(sx * half * 1.15, sy * half, level) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
            )
        rows = np.array(grid)
        number = np.arange(20).reshape(4, 5)
        a, b, c, d = (part.ravel() for part in (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]))
        return Mesh(
            rows.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
        ).flat()

    ribs = [box(0.02, 0.40, 0.03, 0.006).at(sx * 0.29, 0.0, 0.78) for sx in (-1, 1)] + [
        box(0.60, 0.03, 0.05, 0.01).at(0.0, sy * 0.285, 0.93) for sy in (-1, 1)
    ]
    ribs += [box(0.03, 0.54, 0.05, 0.01).at(sx * 0.325, 0.0, 0.93) for sx in (-1, 1)]
    tub.see("bin_green", taper(0.21, 0.275, 0.06, 0.96, 0.012), box(0.44, 0.38, 0.03).at(0.0, 0.0, 0.08), *ribs)
    tub.see(
        "rubber",
        *(
            lathe(
                [(0.03, -0.022), (0.095, -0.022), (0.10, -0.012), (0.10, 0.012), (0.095, 0.022), (0.03, 0.022)], 18
            ).at(-0.24, s * 0.24, 0.10, rpy=(math.pi / 2, 0.0, 0.0))
            for s in (-1, 1)
        ),
    )
    tub.see(
        "plastic",
        *(
            cylinder(-0.015, 0.015, 0.06, 0.0, 14).at(-0.24, s * 0.255, 0.10, rpy=(math.pi / 2, 0.0, 0.0))
            for s in (-1, 1)
        ),
        tube([(-0.33, -0.2, 0.95), (-0.40, -0.2, 0.98), (-0.40, 0.2, 0.98), (-0.33, 0.2, 0.95)], 0.016, 6),
    )
    tub.box((0.50, 0.42, 0.30), (0.0, 0.0, 0.19), mass=4.0)
    for sx in (-1.0, 1.0):
        tub.box((0.03, 0.52, 0.62), (sx * 0.29, 0.0, 0.65), mass=1.2)
        tub.box((0.58, 0.03, 0.62), (0.0, sx * 0.25, 0.65), mass=1.2)
        tub.cylinder(0.10, (-0.24, sx * 0.22, 0.10), (-0.24, sx * 0.26, 0.10), mass=0.4)
    tub.box((0.06, 0.36, 0.06), (0.22, 0.0, 0.03), mass=0.1)
    lid = tub.body("bin_lid", (-0.31, 0.0, 0.965), free=False)
    lid.add("joint", name="bin_lid", type="hinge", axis=[0, -1, 0], range_=[0, 200], damping=0.1, frictionloss=0.05)
    lid.see(
        "bin_green",
        box(0.68, 0.58, 0.022, 0.01).at(0.33, 0.0, 0.018),
        box(0.56, 0.46, 0.03, 0.014).at(0.33, 0.0, 0.035),
        box(0.03, 0.30, 0.03, 0.01).at(0.68, 0.0, 0.015),
    )
    lid.box((0.66, 0.56, 0.03), (0.34, 0.0, 0.02), mass=1.5)


def add_cartons(world: Part, ground: float) -> None:
    """Three cartons and a plastic bag."""
    for number, (size, at, yaw, mass) in enumerate(
        (
            ((0.45, 0.35, 0.30), (4.72, 2.35, ground + 0.151), 8.0, 2.0),
            ((0.34, 0.28, 0.24), (4.75, 2.38, ground + 0.422), -14.0, 1.2),
            ((0.38, 0.30, 0.26), (4.70, 1.85, ground + 0.131), 30.0, 1.0),
        )
    ):
        carton = world.body(f"carton_{number + 1}", at, euler=(0.0, 0.0, yaw))
        carton.add("geom", type="box", size=np.array(size) / 2.0, mass=mass, material="cardboard")
    bag = world.body("bag", (4.45, -0.95, ground + 0.002))
    random = np.random.default_rng(3)
    lumps = [
        block(
            (0.16, 0.16, 0.16),
            0.07,
            (random.uniform(-0.09, 0.09), random.uniform(-0.08, 0.08), random.uniform(0.08, 0.18)),
        )
        for _ in range(9)
    ]
    lumps += [
        block((0.05, 0.09, 0.14), 0.02, (0.02, 0.01, 0.28)),
        block((0.03, 0.11, 0.06), 0.012, (0.02, 0.0, 0.36)),
        block((0.05, 0.05, 0.05), 0.02, (0.0, 0.05, 0.33)),
    ]
    bag.see("bag", solid(union(*lumps, soft=0.035), (-0.2, -0.2, 0.0), (0.2, 0.2, 0.45), 0.018, 1100))
    bag.add("geom", class_="solid", type="ellipsoid", size=[0.15, 0.14, 0.13], pos=[0, 0, 0.13], mass=0.6)
    bag.box((0.16, 0.16, 0.03), (0.0, 0.0, 0.015), mass=0.2)


def add_cone(world: Part, name: str, at: Vector) -> None:
    """A traffic cone."""
    x, y, z = at
    cone = world.body(name, (x, y, z + 0.001))
    bands = [
        (0.0, 0.025, 0.135, 0.105),
        (0.105, 0.19, 0.105, 0.075),
        (0.19, 0.30, 0.075, 0.055),
        (0.30, 0.38, 0.055, 0.04),
        (0.38, 0.48, 0.04, 0.024),
    ]
    for number, (z0, z1, r0, r1) in enumerate(bands):
        profile = [(r0, z0 or 0.025), (r1, z1 if number else 0.105)] + ([(0.0, z1)] if number == 4 else [])
        cone.see("orange" if number in (0, 2, 4) else "paint_white", lathe(profile, 20))
    cone.see("trim", box(0.36, 0.36, 0.03, 0.01).at(z=0.015))
    cone.box((0.36, 0.36, 0.03), (0.0, 0.0, 0.015), mass=1.1)
    cone.cylinder(0.06, (0.0, 0.0, 0.03), (0.0, 0.0, 0.45), mass=0.5)
