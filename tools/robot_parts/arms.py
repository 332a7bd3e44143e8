"""Both arms: that of revolute joints, and the mast with a telescope; the gripper is elsewhere."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from mesh_shapes import (
    FLIP,
    X_UP,
    Array,
    Mesh,
    Point,
    Vector,
    across,
    block,
    both_sides,
    box,
    cylinder,
    extruded,
    hexagons,
    joined,
    lathe,
    pin,
    round_rectangle,
    screws,
    slot,
    swept,
    turned,
)
from robot_parts.chassis import camera_head, gland
from robot_parts.dimensions import Look
from robot_parts.tracks import OUTWARD, merge, moved

RIGHTWARD = FLIP @ OUTWARD
"""Turns what stands on z to the right side."""


def tube(low: float, high: float, height: float, width: float, radius: float = 0.010) -> Mesh:
    """A rectangular tube along x."""
    return extruded(round_rectangle(height, width, radius), low, high, 0.002).at(turn=X_UP)


def actuator(radius: float, width: float, accent: bool = True) -> Look:
    """A joint's housing along y: a barrel with ribs, and covers with screws on both ends."""
    half = width / 2.0
    barrel = cylinder(-half, half, radius, 0.003, 24)
    rib = [(radius, -0.0018), (radius + 0.0016, -0.0010), (radius + 0.0016, 0.0010), (radius, 0.0018)]
    ribs = joined(lathe(rib, 24).at(z=float(z)) for z in np.linspace(-half * 0.35, half * 0.35, 3))
    cap = lathe(
        [
            (radius * 0.86, half),
            (radius * 0.86, half + 0.004),
            (radius * 0.80, half + 0.006),
            (radius * 0.35, half + 0.006),
            (radius * 0.30, half + 0.004),
            (0.0, half + 0.004),
        ],
        24,
    )
    heads = hexagons(6, radius * 0.62, half + 0.006, radius * 0.07, 0.0018)
    look: Look = {
        "dark": joined([barrel, ribs]).at(turn=OUTWARD),
        "steel": joined([cap.at(turn=OUTWARD), cap.at(turn=RIGHTWARD)]),
        "black": joined([heads.at(turn=OUTWARD), heads.at(turn=RIGHTWARD)]),
    }
    if accent:
        ring = lathe(
            [
                (radius * 0.93, half - 0.001),
                (radius * 0.96, half),
                (radius * 0.96, half + 0.0025),
                (radius * 0.9, half + 0.0035),
            ],
            24,
        )
        look["amber"] = joined([ring.at(turn=OUTWARD), ring.at(turn=RIGHTWARD)])
    return look


def fork(ends: Point, radius: float, inside: float, thick: float, root: float) -> Look:
    """Two cheeks between `ends` (x), `root` high at the first, around an axis at the second, `inside` apart."""
    start, end = ends
    outline = shapely.MultiPoint(
        shapely.GeometryCollection(
            [
                shapely.Point(end, 0.0).buffer(radius, quad_segs=6),
                shapely.box(start, -root / 2.0, start + 0.01, root / 2.0),
            ]
        ).convex_hull.exterior.coords
    ).convex_hull
    hole = shapely.affinity.scale(shapely.Polygon(slot(max(end - start - 0.075, 0.004), root * 0.16)), 1.0, 1.0)
    middle = start + (end - radius - start) / 2.0 + 0.004
    cheek = across(extruded(outline.difference(shapely.affinity.translate(hole, middle, 0.0)), 0.0, thick, 0.0015))
    cover = lathe([(radius * 0.72, 0.0), (radius * 0.72, 0.004), (radius * 0.64, 0.006), (0.0, 0.006)], 20)
    heads = hexagons(6, radius * 0.50, 0.006, radius * 0.075, 0.0018)
    at = inside / 2.0 + thick
    return {
        "olive": both_sides(cheek.at(y=at)),
        "steel": both_sides(cover.at(end, at, 0.0, OUTWARD)),
        "black": both_sides(heads.at(end, at, 0.0, OUTWARD)),
    }


def clips(xs: Sequence[float], y: float, z: float, radius: float) -> Mesh:
    """Clamps that hold a cable along x on the side of a tube."""
    return joined(box((0.010, 0.004, 4.2 * radius), 0.001).at(x, y + radius * 0.9, z) for x in xs)


def turret() -> Look:
    """The first link: a turntable, the shoulder's fork, and motors."""
    base = lathe(
        [
            (0.0, 0.0),
            (0.074, 0.0),
            (0.078, 0.003),
            (0.078, 0.014),
            (0.072, 0.018),
            (0.070, 0.022),
            (0.070, 0.034),
            (0.066, 0.038),
            (0.0, 0.038),
        ],
        32,
    )
    ring = lathe([(0.0705, 0.024), (0.0715, 0.025), (0.0715, 0.030), (0.0705, 0.031)], 32)
    outline = shapely.GeometryCollection(
        [shapely.Point(0.0, 0.080).buffer(0.043, quad_segs=8), shapely.box(-0.052, 0.034, 0.052, 0.040)]
    ).convex_hull
    cheek = across(extruded(shapely.Polygon(outline.exterior.coords), 0.0, 0.010, 0.002))
    cover = lathe([(0.033, 0.0), (0.033, 0.005), (0.029, 0.008), (0.012, 0.008), (0.010, 0.006), (0.0, 0.006)], 24)
    heads = hexagons(8, 0.021, 0.008, 0.0028, 0.002)
    motor = lathe([(0.024, -0.040), (0.026, -0.037), (0.026, 0.018), (0.022, 0.022), (0.0, 0.022)], 20)
    foot = screws(
        [
            (0.0745 * math.cos(a), 0.0745 * math.sin(a), 0.0155)
            for a in np.linspace(0.2, 0.2 + 2.0 * math.pi, 12, endpoint=False)
        ],
        0.0032,
        0.002,
    )
    return {
        "dark": joined([base, motor.at(-0.030, 0.0, 0.058, turned(y=math.pi / 2.0))]),
        "amber": ring,
        "olive": both_sides(cheek.at(y=0.062)),
        "steel": both_sides(cover.at(0.0, 0.062, 0.080, OUTWARD)),
        "black": joined([both_sides(heads.at(0.0, 0.062, 0.080, OUTWARD)), foot]),
        "rubber": swept(
            [(-0.052, 0.02, 0.050), (-0.075, 0.028, 0.048), (-0.085, 0.03, 0.025), (-0.082, 0.03, 0.004)], 0.005
        ),
    }


def upper_arm(length: float = 0.40) -> Look:
    """From shoulder to elbow."""
    main = tube(0.030, length - 0.075, 0.058, 0.048)
    collar = joined([tube(x, x + 0.016, 0.064, 0.054, 0.011) for x in (0.048, length - 0.098)])
    pads = both_sides(
        across(extruded(round_rectangle(0.150, 0.022, 0.006), 0.0, 0.003, 0.001)).at(length / 2.0 - 0.01, 0.0265, 0.0)
    )
    cable = swept(
        [
            (0.0, 0.050, 0.034),
            (0.035, 0.036, 0.034),
            (0.075, 0.029, 0.020),
            (0.20, 0.029, 0.020),
            (length - 0.10, 0.029, 0.020),
            (length - 0.055, 0.040, 0.030),
            (length - 0.005, 0.056, 0.036),
        ],
        0.0042,
    )
    heads = both_sides(
        screws([(x, -z, 0.0) for x in (0.056, length - 0.090) for z in (-0.022, 0.022)], 0.0034, 0.0024).at(
            0.0, 0.027, 0.0, OUTWARD
        )
    )
    return merge(
        actuator(0.041, 0.098, accent=False),
        fork((length - 0.090, length), 0.041, 0.080, 0.008, 0.056),
        {
            "olive": main,
            "dark": joined([collar, pads]),
            "rubber": cable,
            "black": joined([heads, clips((0.10, 0.18, 0.26), 0.024, 0.020, 0.0042)]),
        },
    )


def forearm(length: float = 0.34) -> Look:
    """From elbow to wrist."""
    main = tube(0.026, length - 0.062, 0.048, 0.040, 0.009)
    collar = joined([tube(x, x + 0.014, 0.053, 0.045, 0.010) for x in (0.044, length - 0.082)])
    cable = swept(
        [
            (0.004, -0.046, 0.030),
            (0.040, -0.034, 0.030),
            (0.075, -0.0245, 0.016),
            (0.17, -0.0245, 0.016),
            (length - 0.085, -0.0245, 0.016),
            (length - 0.045, -0.034, 0.026),
            (length, -0.044, 0.034),
        ],
        0.0038,
    )
    heads = both_sides(
        screws([(x, -z, 0.0) for x in (0.051, length - 0.075) for z in (-0.018, 0.018)], 0.003, 0.002).at(
            0.0, 0.0225, 0.0, OUTWARD
        )
    )
    label = box((0.085, 0.0012, 0.020), 0.0004).at(0.155, 0.0202, 0.0)
    return merge(
        actuator(0.037, 0.074),
        fork((length - 0.076, length), 0.034, 0.062, 0.007, 0.046),
        {
            "olive": main,
            "dark": collar,
            "rubber": cable,
            "amber": label,
            "black": joined([heads, clips((0.11, 0.20), -0.0245 - 0.0075, 0.016, 0.0038)]),
        },
    )


def camera_post(x: float, start: float, camera: Vector, pitch: float) -> Look:
    """A camera on a bent post that begins at x and z = start; the camera's frame is at `camera`, nods by `pitch`."""
    cx, cy, cz = camera
    back = 0.024
    neck = (
        cx - back * math.cos(pitch) - 0.022 * math.sin(pitch),
        cy,
        cz + back * math.sin(pitch) - 0.022 * math.cos(pitch),
    )
    tubes = both_sides(
        swept(
            [
                (x, 0.011, start),
                (x - 0.006, 0.011, start + 0.035),
                (neck[0] - 0.004, 0.011, neck[2] - 0.022),
                (neck[0], 0.011, neck[2]),
            ],
            0.0042,
            8,
        )
    )
    foot = box((0.030, 0.042, 0.006), 0.0015).at(x, 0.0, start + 0.001)
    heads = screws([(x + sx * 0.010, sy * 0.017, start + 0.004) for sx in (-1, 1) for sy in (-1, 1)], 0.0026, 0.0018)
    brace = box((0.008, 0.032, 0.010), 0.002).at((x + neck[0]) / 2.0 - 0.005, 0.0, (start + neck[2]) / 2.0)
    cable = swept(
        [
            (cx - 0.050 * math.cos(pitch), 0.012, cz + 0.008),
            (cx - 0.075, 0.014, cz - 0.010),
            (x - 0.030, 0.016, (start + cz) / 2.0),
            (x - 0.016, 0.014, start + 0.008),
        ],
        0.0028,
        6,
    )
    head = moved(camera_head(0.064, 0.044, 0.052, 0.0), cx, cy, cz, turned(y=pitch))
    return merge(head, {"steel": tubes, "dark": joined([foot, brace]), "black": heads, "rubber": cable})


def wrist(reach: float = 0.11) -> Look:
    """The fourth link, which nods, with the arm's camera on its post."""
    body = tube(0.018, reach - 0.016, 0.048, 0.046, 0.010)
    flange = pin(reach - 0.018, reach - 0.004, 0.031, 20).at(turn=X_UP)
    sides = both_sides(across(extruded(round_rectangle(0.044, 0.026, 0.006), 0.0, 0.003, 0.001)).at(0.058, 0.0255, 0.0))
    return merge(
        actuator(0.030, 0.058, accent=False),
        {
            "olive": body,
            "dark": joined([flange, sides]),
            "steel": hexagons(8, 0.0265, reach - 0.0045, 0.0022, 0.0016).at(turn=X_UP),
        },
        camera_post(0.038, 0.024, (0.05, 0.0, 0.14), 0.35),
    )


def roll() -> Look:
    """The last link, which turns about x: a gear with a slip ring."""
    profile: list[Point] = [
        (0.0, -0.004),
        (0.029, -0.004),
        (0.032, 0.0),
        (0.032, 0.012),
        (0.030, 0.014),
        (0.030, 0.018),
        (0.032, 0.020),
        (0.032, 0.036),
        (0.028, 0.042),
        (0.0, 0.042),
    ]
    ring = lathe([(0.0305, 0.0135), (0.0322, 0.0145), (0.0322, 0.0175), (0.0305, 0.0185)], 26)
    plate = pin(0.040, 0.052, 0.026, 20)
    return {
        "dark": lathe(profile, 26).at(turn=X_UP),
        "amber": ring.at(turn=X_UP),
        "steel": plate.at(turn=X_UP),
        "black": hexagons(6, 0.029, 0.0385, 0.0022, 0.002).at(turn=X_UP),
        "rubber": swept(
            [(-0.004, 0.020, 0.018), (0.010, 0.036, 0.022), (0.030, 0.038, 0.024), (0.048, 0.034, 0.020)], 0.0028, 6
        ),
    }


# --- the mast and the telescope of inc1_pprm -------------------------------------------------------------------------


def mast(height: float = 0.75) -> Look:
    """Two rails with a screw between them, and a chain for cables."""
    rail = shapely.Polygon(round_rectangle(0.030, 0.022, 0.003))
    grooves = [
        shapely.box(-0.004, 0.006, 0.004, 0.02),
        shapely.box(-0.004, -0.02, 0.004, -0.006),
        shapely.box(0.009, -0.003, 0.02, 0.003),
        shapely.box(-0.02, -0.003, -0.009, 0.003),
    ]
    profile = extruded(rail.difference(shapely.unary_union(grooves)), 0.008, height, 0.0)
    foot = extruded(round_rectangle(0.110, 0.180, 0.012), 0.0, 0.010, 0.002)
    ribs = [
        across(extruded([(-0.045, 0.008), (-0.015, 0.008), (-0.015, 0.060)], -0.003, 0.003, 0.0008)).at(y=y)
        for y in (-0.05, 0.05)
    ]
    top = box((0.056, 0.150, 0.028), 0.004).at(0.0, 0.0, height)
    motor = joined(
        [
            cylinder(height + 0.014, height + 0.062, 0.023, 0.003, 20),
            pin(height + 0.060, height + 0.066, 0.014, 20),
        ]
    )
    screw = [(0.0075 - 0.0014 * (n % 2), 0.012 + n * 0.008) for n in range(int((height - 0.03) / 0.008))]
    heads = screws([(x, y, 0.010) for x in (-0.043, 0.043) for y in (-0.076, 0.076)], 0.005, 0.0035)
    caps = screws([(x, y, height + 0.014) for x in (-0.016, 0.016) for y in (-0.062, 0.062)], 0.0036, 0.0025)
    links = joined(
        box((0.016, 0.026, 0.014), 0.002).at(-0.026, 0.0, 0.03 + 0.0162 * n)
        for n in range(int((height - 0.08) / 0.0162))
    )
    return {
        "alloy": joined([profile.at(y=0.05), profile.at(y=-0.05)]),
        "steel": lathe(screw, 8),
        "olive": joined([foot, top, *ribs]),
        "dark": motor,
        "black": joined([heads, caps, links]),
        "amber": joined([pin(height + 0.030, height + 0.034, 0.0235, 20)]),
    }


def carriage() -> Look:
    """What runs on the mast, and carries the telescope's sleeve; its frame is 80 mm before the mast."""
    back = box((0.014, 0.150, 0.120), 0.004).at(-0.056)
    blocks = joined(box((0.040, 0.030, 0.034), 0.004).at(-0.078, y, z) for y in (-0.05, 0.05) for z in (-0.040, 0.040))
    sleeve = shapely.Polygon(round_rectangle(0.098, 0.098, 0.014)).difference(
        shapely.Polygon(round_rectangle(0.056, 0.056, 0.006))
    )
    shell = extruded(sleeve, -0.050, 0.050, 0.004).at(turn=X_UP)
    collar = extruded(
        shapely.Polygon(round_rectangle(0.104, 0.104, 0.016)).difference(
            shapely.Polygon(round_rectangle(0.057, 0.057, 0.006))
        ),
        0.036,
        0.050,
        0.002,
    ).at(turn=X_UP)
    motor = joined(
        [
            cylinder(-0.045, 0.030, 0.022, 0.003, 20).at(0.004, 0.0, 0.070, X_UP),
            box((0.050, 0.030, 0.02), 0.004).at(0.0, 0.0, 0.052),
        ]
    )
    heads = joined(
        [
            screws([(y, -z, 0.0) for y in (-0.042, 0.042) for z in (-0.042, 0.042)], 0.004, 0.003).at(
                0.050, 0.0, 0.0, X_UP @ turned(z=math.pi / 2.0)
            ),
            both_sides(
                screws([(x, z, 0.0) for x in (-0.03, 0.02) for z in (-0.03, 0.03)], 0.0036, 0.0025).at(
                    0.0, 0.049, 0.0, OUTWARD
                )
            ),
        ]
    )
    return {
        "olive": shell,
        "dark": joined([back, motor, collar]),
        "steel": blocks,
        "black": heads,
        "rubber": swept([(-0.07, 0.02, 0.07), (-0.06, 0.024, 0.085), (-0.04, 0.02, 0.078)], 0.004),
    }


def telescope() -> Look:
    """A boom that slides in the sleeve, with a rack below."""
    boom = tube(-0.170, 0.286, 0.050, 0.050, 0.005)
    rack = joined(block((0.0035, 0.014, 0.004)).at(-0.160 + 0.0075 * n, 0.0, -0.0262) for n in range(56))
    end = tube(0.270, 0.300, 0.060, 0.060, 0.008)
    cheeks = joined(extruded(slot_plate(0.048, 0.030), z, z + 0.009, 0.002).at(0.306) for z in (-0.050, 0.041))
    web = box((0.014, 0.052, 0.096), 0.003).at(0.289)
    ends = tube(-0.174, -0.166, 0.054, 0.054, 0.006)
    grooves = both_sides(box((0.40, 0.0012, 0.008), 0.0004).at(0.05, 0.0251, 0.0))
    heads = screws([(0.33, 0.0, 0.050)], 0.012, 0.004)
    below = screws([(0.33, 0.0, 0.0)], 0.012, 0.004).at(0.0, 0.0, -0.050, FLIP)
    return {
        "alloy": boom,
        "dark": joined([rack, grooves, ends]),
        "olive": joined([end, cheeks, web]),
        "black": joined([heads, below]),
    }


def slot_plate(length: float, radius: float) -> list[Point]:
    """A plate from x = -20 mm around an axis at x = length / 2."""
    return [
        (-0.020, -radius),
        *(
            (length / 2.0 + radius * math.cos(a), radius * math.sin(a))
            for a in np.linspace(-math.pi / 2.0, math.pi / 2.0, 13)
        ),
        (-0.020, radius),
    ]


def turning_wrist() -> Look:
    """The wrist of the telescope, which turns about z, with the camera."""
    hub = lathe([(0.0, -0.040), (0.032, -0.040), (0.035, -0.037), (0.035, 0.037), (0.032, 0.040), (0.0, 0.040)], 24)
    ring = lathe([(0.0352, -0.003), (0.0362, -0.002), (0.0362, 0.002), (0.0352, 0.003)], 24)
    body = tube(0.024, 0.104, 0.050, 0.046, 0.010)
    flange = pin(0.100, 0.116, 0.031, 20).at(turn=X_UP)
    sides = both_sides(across(extruded(round_rectangle(0.044, 0.026, 0.006), 0.0, 0.003, 0.001)).at(0.068, 0.0255, 0.0))
    plug: Array = turned(y=-math.pi / 2.0)
    return merge(
        {
            "dark": joined([hub, flange, sides, gland(0.006).at(-0.034, 0.0, 0.02, plug)]),
            "amber": ring,
            "olive": body,
            "steel": hexagons(8, 0.0265, 0.1155, 0.0022, 0.0016).at(turn=X_UP),
        },
        camera_post(0.048, 0.025, (0.06, 0.0, 0.14), 0.35),
    )
