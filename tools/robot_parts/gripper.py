"""The parallel gripper: a palm with guide rods and a screw, and two jaws with ridged pads."""

from __future__ import annotations

import numpy as np
import shapely

from mesh_shapes import (
    X_UP,
    Mesh,
    Point,
    both_sides,
    box,
    extruded,
    hexagons,
    joined,
    lathe,
    pin,
    round_rectangle,
    screws,
    swept,
)
from robot_parts.dimensions import Look
from robot_parts.tracks import OUTWARD

ROD_X = 0.056
"""Where the rods are, in the frame of gripper_link."""


def palm() -> Look:
    """The housing, and what the jaws slide on."""
    shell = extruded(round_rectangle(0.044, 0.124, 0.010), -0.025, 0.025, 0.004).at(0.026)
    neck = pin(-0.002, 0.010, 0.030, 20).at(turn=X_UP)
    plates = both_sides(box((0.040, 0.008, 0.044), 0.002).at(0.044, 0.0640, 0.0))
    rods = joined(pin(-0.0675, 0.0675, 0.0042, 14).at(ROD_X, 0.0, z, OUTWARD) for z in (-0.0155, 0.0155))
    thread: list[Point] = [(0.0042 - 0.0008 * (n % 2), -0.060 + n * 0.0024) for n in range(51)]
    screw = lathe(thread, 12).at(ROD_X, 0.0, 0.0, OUTWARD)
    cover = extruded(round_rectangle(0.030, 0.090, 0.006), 0.0, 0.0025, 0.001).at(0.025, 0.0, 0.0245)
    heads = screws([(0.025 + sx * 0.011, sy * 0.040, 0.027) for sx in (-1, 1) for sy in (-1, 1)], 0.0022, 0.0016)
    ends = both_sides(screws([(0.036, z, 0.0) for z in (-0.014, 0.014)], 0.003, 0.002).at(0.0, 0.0678, 0.0, OUTWARD))
    caps = both_sides(hexagons(3, 0.004, 0.0, 0.0014, 0.0014).at(ROD_X, 0.0685, 0.0, OUTWARD))
    stripes = joined(box((0.0465, 0.008, 0.030), 0.002).at(0.026, float(y), 0.0).at(z=0.0) for y in (-0.052, 0.052))
    lamp = lathe([(0.005, 0.0), (0.005, 0.002), (0.003, 0.004), (0.0, 0.0045)], 14)
    shells = lathe([(0.0075, 0.0), (0.0075, 0.004), (0.006, 0.0055), (0.005, 0.003)], 16)
    lights = joined(lamp.at(0.0475, y, 0.0, X_UP) for y in (-0.022, 0.022))
    around = joined(shells.at(0.0475, y, 0.0, X_UP) for y in (-0.022, 0.022))
    cable = swept(
        [(0.006, 0.030, 0.016), (0.010, 0.045, 0.028), (0.020, 0.050, 0.029), (0.028, 0.048, 0.026)], 0.0026, 6
    )
    return {
        "olive": shell,
        "dark": joined([neck, plates, cover, around]),
        "steel": joined([rods]),
        "brass": screw,
        "black": joined([heads, ends, caps]),
        "amber": stripes,
        "lamp": lights,
        "rubber": cable,
    }


def jaw() -> Look:
    """The left jaw in the frame of left_finger: it closes towards y = 0."""
    carriage = extruded(round_rectangle(0.018, 0.026, 0.003), -0.022, 0.022, 0.0015).at(0.003, 0.014)
    outline: list[Point] = [
        (-0.004, 0.005),
        (0.062, 0.0045),
        (0.092, 0.0045),
        (0.092, 0.0075),
        (0.070, 0.0135),
        (0.040, 0.019),
        (0.012, 0.027),
        (-0.004, 0.027),
    ]
    holes: list[list[Point]] = [
        [(0.016, 0.009), (0.034, 0.009), (0.034, 0.0165), (0.016, 0.0215)],
        [(0.041, 0.0085), (0.060, 0.0080), (0.060, 0.0120), (0.041, 0.0155)],
    ]
    web = extruded(shapely.Polygon(outline, [hole[::-1] for hole in holes]), -0.013, 0.013, 0.0015)
    plate = box((0.062, 0.003, 0.030), 0.0008).at(0.060, 0.0055, 0.0)
    ridges = joined(_ridge().at(0.034 + 0.0052 * n) for n in range(11))
    back = box((0.060, 0.0024, 0.029), 0.0006).at(0.060, 0.0034, 0.0)
    tip = box((0.008, 0.0046, 0.020), 0.001).at(0.0915, 0.0048, 0.0)
    sides = [
        screws(
            [(x, y, 0.013) for x, y in ((0.010, 0.022), (0.010, 0.009), (0.037, 0.0115), (0.066, 0.0095))],
            0.0024,
            0.0018,
        )
    ]
    sides.append(sides[0].at(turn=np.diag([1.0, 1.0, -1.0])))
    under = sides[1]
    sides[1] = Mesh(under.vertices, under.normals, under.triangles[:, ::-1])
    bushing = joined(
        lathe([(0.0065, -0.0135), (0.0075, -0.0125), (0.0075, 0.0125), (0.0065, 0.0135)], 16).at(
            0.001, 0.014, z, OUTWARD
        )
        for z in (-0.0155, 0.0155)
    )
    return {
        "steel": joined([carriage, plate]),
        "dark": web,
        "rubber": joined([ridges, back]),
        "amber": tip,
        "black": joined(sides),
        "brass": bushing,
    }


def _ridge() -> Mesh:
    """A ridge of a pad, along z."""
    return extruded([(-0.0024, 0.0026), (-0.0012, 0.0002), (0.0012, 0.0002), (0.0024, 0.0026)], -0.0145, 0.0145)
