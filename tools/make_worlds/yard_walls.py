"""What encloses the yard: walls of brick with a gate, a fence of concrete, a workshop."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from .scene import Part
from .shapes import Mesh, box, cylinder, picture, prism, tube
from .yard_things import UPRIGHT, add_digit, corrugated, shutter

BACK: Final = -3.2
"""x of the outer face of the wall behind."""
LEFT: Final = 4.2
"""y of the outer face of the wall to the left."""
RIGHT: Final = -9.0
"""y of the fence to the right."""
AHEAD: Final = 12.0
"""x of the front of the workshop."""
HIGH: Final = 1.8
"""Metres; height of the walls of brick."""
THICK: Final = 0.2
INTO_YARD: Final = (0.0, 0.0, -math.pi / 2)
"""Turns what looks to -y to -x: the front of the workshop."""


def _brick_wall(world: Part, start: float, length: float, piers: tuple[float, ...], *, yaw: float, at: float) -> None:
    """A wall of brick along x from `start`, its inner face at y = 0; turned by `yaw`, and moved by `at` outward."""

    def place(mesh: Mesh) -> Mesh:
        return mesh.at(0.0, at, 0.0) if yaw == 0.0 else mesh.at(rpy=(0.0, 0.0, yaw)).at(at, 0.0, 0.0)

    middle = start + length / 2
    saddle = [(-0.15, 0.0), (0.15, 0.0), (0.15, 0.035), (0.0, 0.085), (-0.15, 0.035)]
    lead = (
        prism(saddle, -length / 2, length / 2)
        .at(rpy=UPRIGHT)
        .at(rpy=(0.0, 0.0, math.pi / 2))
        .at(middle, THICK / 2, HIGH)
    )
    world.see("brick_uv", place(box(length, THICK, HIGH).at(middle, THICK / 2, HIGH / 2)))
    caps: list[Mesh] = []
    for x in piers:
        world.see("brick_uv", place(box(0.36, THICK + 0.1, HIGH + 0.12).at(x, THICK / 2, HIGH / 2 + 0.06)))
        caps.append(box(0.46, THICK + 0.2, 0.06, 0.01).at(x, THICK / 2, HIGH + 0.15))
        caps.append(box(0.34, THICK + 0.08, 0.05, 0.02).at(x, THICK / 2, HIGH + 0.2))
    foot = box(length, 0.02, 0.24, 0.008).at(middle, -0.005, 0.12)
    joints = [
        box(0.012, 0.302, 0.04).at(x, THICK / 2, HIGH + 0.016) for x in np.arange(start + 1.0, start + length, 1.0)
    ]
    world.see("concrete_uv", *(place(mesh.flat()) for mesh in (lead, foot, *caps)))
    world.see("dark", *(place(mesh) for mesh in joints))


def add_walls(world: Part) -> None:
    """The walls behind and to the left, signs and a cable on them."""
    inner = BACK + THICK
    _brick_wall(world, RIGHT, LEFT - RIGHT, (-8.82, -6.4, -4.2, -1.4, 1.4, 4.0), yaw=math.pi / 2, at=inner)
    world.box(
        (THICK, LEFT - RIGHT, HIGH),
        (BACK + THICK / 2, (LEFT + RIGHT) / 2, HIGH / 2),
        name="wall_back",
        material="brick",
    )
    _brick_wall(world, BACK, 6.4, (-1.2, 1.0, 3.1), yaw=0.0, at=LEFT - THICK)
    world.box((6.5, THICK, HIGH), (0.05, LEFT - THICK / 2, HIGH / 2), name="wall_left", material="brick")
    _brick_wall(world, 6.9, AHEAD - 6.9, (7.0, 9.4), yaw=0.0, at=LEFT - THICK)
    world.box(
        (AHEAD - 6.84, THICK, HIGH),
        ((AHEAD + 6.84) / 2, LEFT - THICK / 2, HIGH / 2),
        name="wall_left_ahead",
        material="brick",
    )
    for x in (0.0, 8.2):
        world.see("sign", picture(0.8, 0.56).at(x, LEFT - THICK - 0.016, 1.2))
        world.see("steel", box(0.84, 0.012, 0.60).at(x, LEFT - THICK - 0.008, 1.2))
    world.see("hazard", picture(0.42, 0.42).at(-2.98, 0.35, 1.3, rpy=(0.0, 0.0, math.pi / 2)))
    # a tap, a cable along the wall with its box
    x = LEFT - THICK - 0.03
    world.see("plastic", tube([(-2.2, x, 0.9), (-1.5, x, 0.9), (-1.0, x, 0.9), (2.9, x, 0.9)], 0.014, 6))
    world.see("metal_uv", box(0.32, 0.14, 0.42, 0.015).at(2.2, x - 0.03, 0.95))
    world.see("paint_yellow", box(0.12, 0.006, 0.12).at(2.2, x - 0.104, 1.0))


def add_gate(world: Part) -> None:
    """Two leaves of steel pales, closed."""
    y, low, high = LEFT - THICK / 2, 3.38, 6.78
    posts = [box(0.16, 0.16, 2.1, 0.012).at(x, y, 1.05) for x in (low, high)]
    frame: list[Mesh] = []
    for left, right in ((low + 0.12, 5.06), (5.1, high - 0.12)):
        middle, width = (left + right) / 2, right - left
        frame += [box(width, 0.05, 0.06, 0.006).at(middle, y, z) for z in (0.13, 1.05, 1.84)]
        frame += [box(0.06, 0.05, 1.75, 0.006).at(x, y, 0.98) for x in (left + 0.03, right - 0.03)]
        frame += [box(0.028, 0.028, 1.98).at(float(x), y, 1.02) for x in np.linspace(left + 0.14, right - 0.14, 12)]
        frame.append(box(width - 0.1, 0.02, 0.5).at(middle, y, 0.4))
    world.see("gate_green", *posts, *frame)
    world.see(
        "steel",
        box(0.26, 0.08, 0.1, 0.01).at(5.08, y - 0.03, 1.05),
        *(cylinder(0.0, 0.12, 0.03, 0.0, 10).at(x, y, z) for x in (low + 0.1, high - 0.1) for z in (0.4, 1.5)),
    )
    world.see("hazard", picture(0.36, 0.36).at(4.25, y - 0.032, 1.32))
    world.box((high - low + 0.16, 0.08, 1.95), ((low + high) / 2, y, 0.975), name="gate", material="gate_green")


def add_fence(world: Part) -> None:
    """Panels of concrete between posts; an opening to the right of the start, its gate open."""
    panels: list[Mesh] = []
    for left, right in ((BACK + 0.2, -1.3), (1.9, AHEAD + 0.2)):
        count = max(1, round((right - left) / 2.2))
        step = (right - left) / count
        for number in range(count):
            x = left + (number + 0.5) * step
            panels += [box(step - 0.02, 0.06, 0.49, 0.008).at(x, RIGHT, 0.25 + 0.5 * row) for row in range(4)]
        panels += [box(0.15, 0.14, 2.1, 0.012).at(left + number * step, RIGHT, 1.05) for number in range(count + 1)]
        world.box((right - left + 0.14, 0.08, 2.0), ((left + right) / 2, RIGHT, 1.0), material="concrete")
    x = AHEAD + 0.2
    for y0, y1 in ((RIGHT, -5.3),):
        panels += [
            box(0.06, (y1 - y0) / 2 - 0.02, 0.49, 0.008).at(x, y0 + (y1 - y0) * part, 0.25 + 0.5 * row)
            for part in (0.25, 0.75)
            for row in range(4)
        ]
        panels.append(box(0.14, 0.15, 2.1, 0.012).at(x, (y0 + y1) / 2, 1.05))
        world.box((0.08, y1 - y0, 2.0), (x, (y0 + y1) / 2, 1.0), material="concrete")
    world.see("concrete_uv", *panels)
    leaves: list[Mesh] = []
    for x, way in ((-1.3, -1.0), (1.9, 1.0)):
        leaves.append(box(0.14, 0.14, 2.2, 0.012).at(x, RIGHT, 1.1))
        ends = (RIGHT - 0.1, RIGHT - 1.6)
        leaves += [box(0.05, 1.5, 0.06).at(x + way * 0.05, sum(ends) / 2, z) for z in (0.13, 1.05, 1.84)]
        leaves += [box(0.028, 0.028, 1.9).at(x + way * 0.05, float(y), 1.0) for y in np.linspace(*ends, 12)]
    world.see("gate_green", *leaves)


def add_workshop(world: Part) -> None:
    """A workshop of metal sheets on a foot of brick, with two shutters, a door and a window."""
    low, high, top, foot = -5.3, LEFT, 4.2, 0.9
    openings = ((-4.4, -1.4, 3.0), (-0.6, 2.4, 3.0), (2.95, 3.85, 2.1))  # left, right, height
    world.box((5.0, high - low, top), (AHEAD + 2.5, (low + high) / 2, top / 2), name="workshop", material="cladding_uv")
    edges = [low, *(y for left, right, _ in openings for y in (left, right)), high]
    for left, right in zip(edges[::2], edges[1::2], strict=True):
        world.see("brick_uv", box(0.12, right - left, foot).at(AHEAD + 0.06, (left + right) / 2, foot / 2))
        world.see("concrete_uv", box(0.16, right - left, 0.06, 0.01).at(AHEAD + 0.06, (left + right) / 2, foot + 0.03))

    def front(mesh: Mesh, y: float, z: float, depth: float = 0.08) -> Mesh:
        """What was made in the x-z plane, x to the right of who looks at the front."""
        return mesh.at(rpy=INTO_YARD).at(AHEAD + depth, y, z)

    sheets = [front(corrugated(high - low, top - 3.0, 0.25, 0.035), high, 3.0)]
    for left, right in zip(edges[::2], edges[1::2], strict=True):
        sheets.append(front(corrugated(right - left, 3.0 - foot - 0.06, 0.25, 0.035), right, foot + 0.06))
    sheets.append(front(corrugated(0.9, 0.9, 0.25, 0.035), 3.85, 2.1))
    sheets += [box(5.0, 0.1, top).at(AHEAD + 2.55, y, top / 2) for y in (low + 0.05, high - 0.05)]
    world.see("cladding_uv", *sheets)
    world.see(
        "fascia_uv",
        box(5.3, high - low + 0.3, 0.34, 0.02).at(AHEAD + 2.5, (low + high) / 2, top + 0.1),
        *(box(0.1, 0.12, top, 0.01).at(AHEAD + 0.02, y, top / 2) for y in (low + 0.04, high - 0.04)),
    )
    for number, (left, right, height) in enumerate(openings):
        middle, width = (left + right) / 2, right - left
        sides = [box(0.16, 0.1, height, 0.01).at(AHEAD + 0.06, y, height / 2) for y in (left, right)]
        world.see("fascia_uv", *sides, box(0.16, width + 0.1, 0.12, 0.01).at(AHEAD + 0.06, middle, height))
        if number < 2:
            world.see("shutter_uv", front(shutter(width, height, 0.15, 0.018), right, 0.0, 0.12))
            world.see("dark", box(0.04, width - 0.1, 0.09, 0.01).at(AHEAD + 0.09, middle, 0.05))
            white: list[Mesh] = []
            add_digit(white, str(number + 1), 0.0, 0.0, math.pi / 2)
            upright = (mesh.at(rpy=UPRIGHT) for mesh in white)
            world.see("paint_white", *(front(mesh, middle, 3.58, -0.005) for mesh in upright))
            world.see("fascia_uv", box(0.04, 0.8, 0.94, 0.01).at(AHEAD + 0.02, middle, 3.58))
            world.see(
                "stripes_uv", *(box(0.18, 0.16, 0.9, 0.01).at(AHEAD - 0.02, y, 0.45) for y in (left - 0.1, right + 0.1))
            )
        else:
            world.see("fascia_uv", box(0.05, width, height, 0.01).at(AHEAD + 0.1, middle, height / 2))
            world.see("window_dark", box(0.02, 0.5, 0.6).at(AHEAD + 0.07, middle, 1.55))
            world.see("steel", box(0.06, 0.14, 0.03).at(AHEAD + 0.05, middle + 0.32, 1.05))
    world.see("plastic", *(tube([(AHEAD - 0.02, y, 0.1), (AHEAD - 0.02, y, top)], 0.05, 8) for y in (-0.98,)))
    for y in (-2.9, 0.9):
        world.see("plastic", box(0.3, 0.3, 0.1, 0.02).at(AHEAD - 0.2, y, 4.02, rpy=(0.0, -0.3, 0.0)))
        world.see("lamp", box(0.2, 0.22, 0.02).at(AHEAD - 0.21, y, 3.96, rpy=(0.0, -0.3, 0.0)))
