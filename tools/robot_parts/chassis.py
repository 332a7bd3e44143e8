"""The hull: housings, hatches, handles, lamps, connectors, antennas, and the masts of lidar and camera."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely

from mesh_shapes import (
    X_UP,
    Mesh,
    Point,
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
    swept,
    turned,
)
from robot_parts.dimensions import Dimensions, Look
from robot_parts.tracks import OUTWARD, merge, moved

REARWARD = turned(y=-math.pi / 2.0)
"""Turns what stands on z to the rear."""
HALF_HULL = 0.158
WHIP_FOOT = 0.018
"""Height of an antenna's spring above what its foot stands on."""


class Whip(NamedTuple):
    """An antenna that swings about its foot."""

    look: Look
    """On z = 0."""
    foot: tuple[float, float, float]
    """In the frame of the link."""
    length: float
    frequency: float
    """Hz, of its natural oscillation."""


LOW = 0.050
"""From the axes of the idlers down to the hull's bottom."""


def ends(size: Dimensions) -> Point:
    """Rear and front of the hull."""
    return size.track_x - size.half_hull, size.track_x + size.half_hull


def hull(size: Dimensions) -> Look:
    """The welded housing with its front plates, and the bolted deck."""
    low, top = size.idler_z - LOW, size.deck - 0.018
    rear_x, front_x = ends(size)
    side: list[Point] = [
        (rear_x + 0.047, low),
        (front_x - 0.083, low),
        (front_x, low + 0.055),
        (front_x, low + 0.085),
        (front_x - 0.056, top),
        (rear_x + 0.022, top),
        (rear_x, top - 0.022),
        (rear_x, low + 0.045),
    ]
    body = across(extruded(side, -HALF_HULL, HALF_HULL, 0.006))
    behind, ahead = rear_x + 0.022, front_x - 0.064
    plate = round_rectangle(ahead - behind, 0.300, 0.018)
    deck = extruded(plate, top - 0.002, size.deck, 0.0025).at((ahead + behind) / 2.0)
    edge = [(x, y, size.deck) for x in np.linspace(behind + 0.014, ahead - 0.014, 7) for y in (-0.139, 0.139)]
    heads = screws([(float(x), y, z) for x, y, z in edge], 0.0042, 0.0028)
    skirts = both_sides(
        across(extruded(round_rectangle(0.40, 0.030, 0.006), 0.0, 0.006, 0.0015)).at(
            size.track_x, HALF_HULL + 0.005, top - 0.024
        )
    )
    rows = [(float(x), 0.024 - top, 0.0) for x in np.linspace(-0.18, 0.18, 6)]
    skirt_heads = both_sides(
        screws([(x, y, 0.0) for x, y, _ in rows], 0.0036, 0.0025).at(size.track_x, HALF_HULL + 0.005, 0.0, OUTWARD)
    )
    return {"olive": joined([body, skirts]), "dark": deck, "black": joined([heads, skirt_heads])}


def hatch(length: float, width: float) -> Look:
    """A lid on z = 0 with a raised rim, four turn locks and a recessed handle."""
    lid = extruded(round_rectangle(length, width, 0.010), 0.0, 0.009, 0.003)
    panel = extruded(round_rectangle(length - 0.030, width - 0.030, 0.007), 0.009, 0.0115, 0.0012)
    corners = [(sx * (length / 2.0 - 0.010), sy * (width / 2.0 - 0.010), 0.009) for sx in (-1, 1) for sy in (-1, 1)]
    locks = joined(pin(0.0, 0.003, 0.0062, 12).at(*corner) for corner in corners)
    slits = joined(box((0.009, 0.0018, 0.0012), 0.0004).at(x, y, z + 0.003, turned(z=0.7)) for x, y, z in corners)
    return {"olive": joined([lid, panel]), "steel": locks, "black": slits}


def handle(length: float, height: float, radius: float = 0.006) -> Look:
    """A carrying handle along x on z = 0."""
    half = length / 2.0
    bow = swept(
        [
            (-half, 0.0, 0.0),
            (-half, 0.0, height * 0.6),
            (-half * 0.82, 0.0, height),
            (half * 0.82, 0.0, height),
            (half, 0.0, height * 0.6),
            (half, 0.0, 0.0),
        ],
        radius,
        10,
    )
    grip = cylinder(-length * 0.30, length * 0.30, radius * 1.5, 0.002, 12).at(0.0, 0.0, height, X_UP)
    feet = joined(pin(0.0, 0.004, radius * 1.9, 14).at(x) for x in (-half, half))
    return {"black": joined([bow, feet]), "rubber": grip}


def lamp(radius: float) -> Look:
    """A head lamp that looks along z."""
    shell = lathe(
        [
            (0.0, -0.022),
            (radius * 0.7, -0.022),
            (radius, -0.014),
            (radius, 0.006),
            (radius - 0.002, 0.008),
            (radius - 0.004, 0.004),
        ],
        20,
    )
    fins = joined(
        lathe([(radius, z), (radius + 0.003, z + 0.0008), (radius + 0.003, z + 0.002), (radius, z + 0.0028)], 24)
        for z in (-0.012, -0.006)
    )
    glass = lathe([(radius - 0.0035, 0.004), (radius * 0.6, 0.0065), (0.0, 0.0075)], 24)
    return {"dark": joined([shell, fins]), "lamp": glass}


def gland(radius: float = 0.007) -> Mesh:
    """A cable gland on z = 0."""
    return lathe(
        [
            (radius * 1.35, 0.0),
            (radius * 1.35, radius * 0.9),
            (radius, radius * 1.1),
            (radius * 0.95, radius * 2.0),
            (radius * 0.6, radius * 2.3),
            (0.0, radius * 2.3),
        ],
        8,
    )


def connector(radius: float) -> Look:
    """A round connector with a cap on z = 0."""
    plate = extruded(round_rectangle(radius * 2.9, radius * 2.9, radius * 0.5), 0.0, 0.003, 0.0008)
    body = lathe(
        [
            (radius * 1.2, 0.003),
            (radius * 1.2, 0.007),
            (radius, 0.008),
            (radius, 0.014),
            (radius * 0.9, 0.016),
            (0.0, 0.016),
        ],
        16,
    )
    at = radius * 1.15
    heads = screws([(sx * at, sy * at, 0.003) for sx in (-1, 1) for sy in (-1, 1)], radius * 0.2, 0.0015)
    return {"steel": plate, "dark": body, "black": heads}


def stop_button() -> Look:
    """The emergency stop: a red mushroom on a yellow box."""
    mushroom = lathe(
        [
            (0.008, 0.024),
            (0.008, 0.032),
            (0.017, 0.033),
            (0.0185, 0.037),
            (0.016, 0.043),
            (0.008, 0.0455),
            (0.0, 0.046),
        ],
        20,
    )
    return {
        "amber": extruded(round_rectangle(0.052, 0.052, 0.006), 0.0, 0.024, 0.003),
        "red": mushroom,
        "black": pin(0.0235, 0.026, 0.014),
    }


def antenna_foot() -> Look:
    """What an antenna stands on, on z = 0."""
    return {"dark": lathe([(0.015, 0.0), (0.015, 0.010), (0.011, 0.016), (0.008, WHIP_FOOT)], 18)}


def antenna(height: float) -> Look:
    """A whip on its spring, which begins at z = 0; `height` is that of its end above the foot's."""
    turns = [(0.0062 * math.cos(a), 0.0062 * math.sin(a), 0.024 * a / 31.4) for a in np.linspace(0.0, 31.4, 40)]
    spring = swept([(float(x), float(y), float(z)) for x, y, z in turns], 0.0016, 4, 1)
    whip = lathe(
        [
            (0.006, 0.042 - WHIP_FOOT),
            (0.006, 0.060 - WHIP_FOOT),
            (0.0034, 0.064 - WHIP_FOOT),
            (0.0026, height - 0.004 - WHIP_FOOT),
            (0.0042, height - 0.004 - WHIP_FOOT),
            (0.0042, height + 0.004 - WHIP_FOOT),
            (0.0, height + 0.004 - WHIP_FOOT),
        ],
        8,
    )
    return {"steel": spring, "black": whip}


def antennas(size: Dimensions) -> dict[str, Whip]:
    """The antennas at the back of the deck; the longer one swings more slowly."""
    x, z = ends(size)[0] + 0.056, size.deck + 0.042 + WHIP_FOOT
    return {
        f"antenna_{side}": Whip(antenna(height), (x, y, z), height - WHIP_FOOT, frequency)
        for side, y, height, frequency in (("left", 0.105, 0.36, 3.1), ("right", -0.105, 0.30, 3.9))
    }


def electronics(size: Dimensions) -> Look:
    """The finned box at the rear of the deck, with connectors, cables and labels."""
    length, width, height = 0.125, 0.262, 0.042
    shell = extruded(round_rectangle(length, width, 0.012), 0.0, height, 0.004)
    fins = joined(
        block((length - 0.034, 0.0035, 0.010)).at(0.0, float(y), height + 0.004) for y in np.linspace(-0.105, 0.105, 15)
    )
    corners = screws(
        [(sx * (length / 2.0 - 0.011), sy * (width / 2.0 - 0.011), height) for sx in (-1, 1) for sy in (-1, 1)],
        0.004,
        0.0028,
    )
    front = merge(*(moved(connector(0.0085), 0.0, y, 0.0) for y in (-0.09, -0.055, 0.055, 0.09)))
    look = merge({"dark": joined([shell, fins]), "black": corners}, moved(front, length / 2.0, 0.0, 0.021, X_UP))
    cables = [
        swept(
            [
                (0.078, -0.09, 0.021),
                (0.105, -0.09, 0.02),
                (0.135, -0.115, 0.006),
                (0.20, -0.12, 0.005),
                (0.30, -0.105, 0.005),
            ],
            0.0042,
        ),
        swept([(0.078, -0.055, 0.021), (0.11, -0.055, 0.018), (0.15, -0.05, 0.006), (0.21, -0.03, 0.006)], 0.0042),
        swept([(0.078, 0.055, 0.021), (0.11, 0.055, 0.02), (0.15, 0.06, 0.006), (0.215, 0.035, 0.006)], 0.0055),
        swept(
            [
                (0.078, 0.09, 0.021),
                (0.105, 0.09, 0.02),
                (0.14, 0.118, 0.006),
                (0.22, 0.122, 0.005),
                (0.31, 0.112, 0.005),
            ],
            0.0042,
        ),
    ]
    return moved(merge(look, {"rubber": joined(cables)}), ends(size)[0] + 0.100, 0.0, size.deck)


def rear(size: Dimensions) -> Look:
    """Connectors, tail lamps and a tow eye at the back."""
    low = size.idler_z - LOW
    z = low + 0.086
    lamps = merge(
        *(
            moved({"red": lamp(0.012)["lamp"], "dark": lamp(0.012)["dark"]}, -0.312, y, z, REARWARD)
            for y in (-0.125, 0.125)
        )
    )
    plugs = merge(*(moved(connector(0.009), -0.312, y, z, REARWARD) for y in (-0.07, -0.035)))
    eye = swept(
        [
            (-0.308, -0.016, low + 0.05),
            (-0.340, -0.014, low + 0.05),
            (-0.346, 0.0, low + 0.05),
            (-0.340, 0.014, low + 0.05),
            (-0.308, 0.016, low + 0.05),
        ],
        0.0055,
        10,
    )
    pads = box((0.006, 0.06, 0.026), 0.002).at(-0.312, 0.0, low + 0.05)
    carry = moved(handle(0.11, 0.030), -0.312, 0.065, z + 0.004, REARWARD @ turned(z=math.pi / 2.0))
    look = merge(lamps, plugs, {"steel": joined([eye, pads])}, carry)
    return moved(look, ends(size)[0] + 0.312)


def front(size: Dimensions) -> Look:
    """Head lamps, tow eyes and the bracket of the camera."""
    low = size.idler_z - LOW
    z = low + 0.070
    lamps = merge(*(moved(lamp(0.019), 0.324, y, z, X_UP) for y in (-0.085, 0.085)))
    guards = []
    for y in (-0.085, 0.085):
        hoop = swept(
            [
                (0.316, y - 0.026, z),
                (0.345, y - 0.026, z),
                (0.352, y - 0.018, z),
                (0.352, y + 0.018, z),
                (0.345, y + 0.026, z),
                (0.316, y + 0.026, z),
            ],
            0.0032,
        )
        guards += [hoop.at(z=0.012), hoop.at(z=-0.012)]
    hooks = [
        swept(
            [(0.285, y, low + 0.022), (0.318, y, low + 0.020), (0.330, y, low + 0.032), (0.318, y, low + 0.044)],
            0.005,
            8,
        )
        for y in (-0.04, 0.04)
    ]
    look = merge(lamps, {"black": joined(guards), "steel": joined(hooks)})
    return moved(look, ends(size)[1] - 0.318)


def camera_bracket(size: Dimensions) -> Look:
    """What carries the pan axis."""
    x, _, z = size.camera
    low, high = size.idler_z + 0.030, z - 0.018
    nose = ends(size)[1] - 0.004
    foot = box((x - nose, 0.060, 0.022), 0.004).at((x + nose) / 2.0 - 0.006, 0.0, low)
    post = box((0.022, 0.040, high - low), 0.004).at(x - 0.016, 0.0, (low + high) / 2.0)
    table = extruded(round_rectangle(0.056, 0.056, 0.012), z - 0.022, z - 0.017, 0.0012).at(x)
    ring = pin(z - 0.030, z - 0.021, 0.020).at(x)
    return {"dark": joined([foot, post, table, ring])}


def lidar_mast(size: Dimensions) -> Look:
    """The mast and the lidar."""
    x, y, z = size.lidar
    foot = extruded(round_rectangle(0.058, 0.058, 0.010), size.deck, size.deck + 0.007, 0.0015)
    tube = pin(size.deck + 0.005, z - 0.038, 0.0115, 18)
    collar = lathe(
        [
            (0.0115, size.deck + 0.007),
            (0.019, size.deck + 0.008),
            (0.019, size.deck + 0.024),
            (0.0115, size.deck + 0.030),
        ],
        20,
    )
    table = pin(z - 0.041, z - 0.036, 0.036, 20)
    base = lathe([(0.0, z - 0.036), (0.034, z - 0.036), (0.036, z - 0.033), (0.036, z - 0.016), (0.034, z - 0.014)], 24)
    window = lathe([(0.0335, z - 0.0145), (0.0335, z + 0.0145)], 24)
    cap = lathe(
        [
            (0.034, z + 0.014),
            (0.036, z + 0.016),
            (0.036, z + 0.024),
            (0.031, z + 0.030),
            (0.012, z + 0.032),
            (0.0, z + 0.032),
        ],
        24,
    )
    ribs = joined(
        box((0.003, 0.0735, 0.012), 0.0008).at(0.0, 0.0, z - 0.026, turned(z=math.pi * n / 8.0)) for n in range(8)
    )
    heads = screws([(sx * 0.021, sy * 0.021, size.deck + 0.007) for sx in (-1, 1) for sy in (-1, 1)], 0.0038, 0.0028)
    cable = swept(
        [
            (0.034, 0.0, z - 0.028),
            (0.048, 0.0, z - 0.034),
            (0.030, 0.004, z - 0.075),
            (0.017, 0.008, z - 0.13),
            (0.017, 0.009, size.deck + 0.07),
            (0.030, 0.02, size.deck + 0.006),
        ],
        0.0032,
    )
    look: Look = {
        "dark": joined([foot, collar, base, cap, ribs]),
        "steel": joined([tube, table]),
        "lens": window,
        "black": heads,
        "rubber": cable,
    }
    return moved(look, x, y)


def body(size: Dimensions) -> Look:
    """All of the hull but what depends on the arm."""
    stowage = moved(hatch(0.115, 0.110), ends(size)[0] + 0.245, 0.0, size.deck)
    battery = merge(*(moved(hatch(0.150, 0.060), ends(size)[0] + 0.255, y, size.deck) for y in (-0.100, 0.100)))
    sides = merge(
        *(
            moved(antenna_foot(), whip.foot[0], whip.foot[1], whip.foot[2] - WHIP_FOOT)
            for whip in antennas(size).values()
        )
    )
    carry = merge(*(moved(handle(0.12, 0.026), ends(size)[1] - 0.133, y, size.deck) for y in (-0.118, 0.118)))
    button = moved(stop_button(), ends(size)[1] - 0.245, 0.112, size.deck)
    return merge(hull(size), stowage, battery, sides, carry, button, electronics(size), rear(size), front(size))


def pan_head() -> Look:
    """The turning base of the camera, in the frame of its link: its yoke carries the tilt axis 35 mm above."""
    base = lathe([(0.0, -0.017), (0.024, -0.017), (0.026, -0.014), (0.026, -0.002), (0.022, 0.002), (0.0, 0.002)], 20)
    ring = lathe([(0.0265, -0.010), (0.0275, -0.009), (0.0275, -0.007), (0.0265, -0.006)], 20)
    cheek = shapely.unary_union(
        [shapely.box(-0.013, 0.0, 0.013, 0.035), shapely.Point(0.0, 0.035).buffer(0.013, quad_segs=6)]
    )
    yoke = both_sides(across(extruded(cheek, 0.0, 0.005, 0.001)).at(y=0.0465))
    bridge = box((0.026, 0.093, 0.006), 0.0018).at(z=0.001)
    caps = both_sides(
        joined([pin(0.0, 0.004, 0.010, 18), hexagons(3, 0.006, 0.004, 0.0016, 0.0014)]).at(0.0, 0.0465, 0.035, OUTWARD)
    )
    return {"dark": joined([base, yoke, bridge]), "amber": ring, "steel": caps}


def camera_head(width: float = 0.076, height: float = 0.052, depth: float = 0.058, glass: float = 0.026) -> Look:
    """A camera that looks along x, with lenses, lamps around them, and a sunshade; `glass`: x of its front."""
    back = glass - depth
    profile: list[Point] = [
        (back, -height / 2.0 + 0.006),
        (back + 0.006, -height / 2.0),
        (glass - 0.004, -height / 2.0),
        (glass - 0.004, height / 2.0),
        (back + 0.012, height / 2.0),
        (back, height / 2.0 - 0.012),
    ]
    shell = across(extruded(profile, -width / 2.0, width / 2.0, 0.003))
    face = extruded(round_rectangle(height - 0.006, width - 0.006, 0.005), 0.0, 0.003, 0.0008).at(
        glass - 0.0045, 0.0, 0.0, X_UP
    )
    shade_outline: list[Point] = [
        (glass - 0.030, height / 2.0 + 0.002),
        (glass + 0.016, height / 2.0 + 0.005),
        (glass + 0.016, height / 2.0 + 0.007),
        (glass - 0.030, height / 2.0 + 0.004),
    ]
    shade = joined([across(extruded(shade_outline, -width / 2.0 - 0.004, width / 2.0 + 0.004, 0.0006))])
    wing: list[Point] = [
        (glass - 0.018, height / 2.0 + 0.003),
        (glass - 0.010, height / 2.0 - 0.012),
        (glass + 0.013, height / 2.0 - 0.004),
        (glass + 0.015, height / 2.0 + 0.005),
    ]
    wings = both_sides(across(extruded(wing, 0.0, 0.002)).at(y=width / 2.0 + 0.004))

    def lens(radius: float, y: float, z: float) -> Look:
        barrel = lathe([(radius + 0.004, 0.0), (radius + 0.004, 0.005), (radius + 0.002, 0.0065), (radius, 0.0045)], 18)
        front = lathe([(radius, 0.0040), (radius * 0.7, 0.0052), (0.0, 0.0060)], 22)
        pupil = lathe([(radius * 0.45, 0.0056), (0.0, 0.0066)], 16)
        return moved({"black": joined([barrel, pupil]), "lens": front}, glass - 0.0015, y, z, X_UP)

    def light(y: float, z: float) -> Look:
        return moved(
            {"lamp": lathe([(0.0036, 0.0), (0.0036, 0.0012), (0.0022, 0.0028), (0.0, 0.0032)], 12)},
            glass - 0.0015,
            y,
            z,
            X_UP,
        )

    second = width * 0.30
    lights = merge(*(light(y, z) for y in (-second - 0.004, second + 0.006) for z in (-0.017, 0.017)))
    ribs = joined(
        box((0.0025, width - 0.016, 0.004), 0.0008).at(back + 0.020 + 0.006 * n, 0.0, height / 2.0 + 0.0005)
        for n in range(2)
    )
    heads = screws(
        [
            (y, z, 0.0)
            for y in (-width / 2 + 0.006, width / 2 - 0.006)
            for z in (-height / 2 + 0.006, height / 2 - 0.006)
        ],
        0.0022,
        0.0014,
    )
    on_face = heads.at(glass - 0.0016, 0.0, 0.0, X_UP @ turned(z=math.pi / 2.0))
    plug = joined([gland(0.006).at(back, 0.012, -0.006, REARWARD)])
    return merge(
        {"olive": joined([shell, shade, wings]), "dark": joined([face, ribs, plug]), "black": on_face},
        lens(0.0125, -0.002, 0.0),
        lens(0.0065, second, 0.0),
        lens(0.0065, -second - 0.002, 0.0),
        lights,
    )
