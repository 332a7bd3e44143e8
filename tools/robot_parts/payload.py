"""What is carried above the tracks: batteries and a spool of fibre on the left; a computer and a disruptor."""

from __future__ import annotations

import math

import numpy as np
import shapely

from mesh_shapes import (
    X_UP,
    Mesh,
    across,
    block,
    box,
    circle,
    cylinder,
    extruded,
    hexagons,
    joined,
    lathe,
    mirrored,
    pin,
    round_rectangle,
    screws,
    swept,
    turned,
)
from robot_parts.chassis import REARWARD, connector
from robot_parts.dimensions import Dimensions, Look
from robot_parts.tracks import OUTWARD, merge, moved, windowed

LENGTH = 0.40
WIDTH = 0.112
ABOVE = 0.012
"""From the deck, which is as high as the treads, to the trays."""
HEIGHT = 0.052
"""Of the boxes on the trays."""
REAR = -0.255
"""From the middle of the tracks to the rear ends of the trays."""


def tray() -> Look:
    """A shelf over the left track, on two brackets that are bolted to the deck; in the frame of the shelf's middle."""
    shelf = extruded(round_rectangle(LENGTH, WIDTH, 0.008), 0.0, 0.004, 0.001)
    lip = block((LENGTH - 0.02, 0.004, 0.016)).at(0.0, WIDTH / 2.0 - 0.002, 0.010)
    places = (-0.13, 0.13)
    arms = joined(
        block(extent).at(x, y, z)
        for x in places
        for extent, y, z in (
            ((0.030, 0.040, 0.004), -0.096, 0.002 - ABOVE),
            ((0.030, 0.004, ABOVE), -0.078, -ABOVE / 2.0),
            ((0.030, 0.090, 0.004), -0.035, -0.002),
        )
    )
    bolts = screws([(x + dx, -0.098, 0.004 - ABOVE) for x in places for dx in (-0.008, 0.008)], 0.0042, 0.003)
    return {"dark": joined([shelf, lip, arms]), "black": bolts}


def latch() -> Look:
    """A draw latch that stands on z, its hook towards +y."""
    plate = block((0.017, 0.024, 0.0022)).at(0.0, -0.004, 0.001)
    lever = box((0.012, 0.020, 0.0035), 0.0012).at(0.0, -0.005, 0.0045)
    hook = block((0.012, 0.008, 0.005)).at(0.0, 0.014, 0.0025)
    wire = swept(
        [(-0.004, 0.004, 0.005), (-0.004, 0.013, 0.0052), (0.004, 0.013, 0.0052), (0.004, 0.004, 0.005)], 0.0012, 4, 2
    )
    rivets = screws([(-0.006, -0.013, 0.002), (0.006, -0.013, 0.002)], 0.0016, 0.001)
    return {"steel": joined([plate, lever, hook, wire]), "black": rivets}


def case(length: float, width: float, height: float) -> tuple[Mesh, Mesh]:
    """A box with a lid on z = 0 and ribs on its left, and the seal between them."""
    body = extruded(round_rectangle(length, width, 0.010), 0.0, height - 0.014, 0.0035)
    lid = extruded(round_rectangle(length + 0.003, width + 0.003, 0.011), height - 0.0118, height, 0.0045)
    panel = extruded(round_rectangle(length - 0.034, width - 0.034, 0.008), height - 0.001, height + 0.0024, 0.0016)
    seal = extruded(round_rectangle(length - 0.004, width - 0.004, 0.008), height - 0.0145, height - 0.0115)
    ribs = joined(
        box((0.007, 0.005, height - 0.024), 0.0018).at(float(x), width / 2.0, (height - 0.012) / 2.0)
        for x in np.linspace(-length / 2.0 + 0.026, length / 2.0 - 0.026, max(3, round(length / 0.036)))
    )
    return joined([body, lid, panel, ribs]), seal


def battery() -> Look:
    """A battery pack with a handle to pull it out, a latch on either side of it, and lamps of its charge."""
    length = LENGTH / 2.0 - 0.012
    shell, seal = case(length, WIDTH - 0.018, HEIGHT)
    face = (WIDTH - 0.018) / 2.0
    outward = OUTWARD
    latches = merge(*(moved(latch(), x, face + 0.001, HEIGHT - 0.022, outward) for x in (-0.060, 0.060)))
    pull = swept(
        [(-0.026, face, 0.020), (-0.026, face + 0.011, 0.020), (0.026, face + 0.011, 0.020), (0.026, face, 0.020)],
        0.0034,
        8,
    )
    grip = cylinder(-0.019, 0.019, 0.0052, 0.0015, 12).at(0.0, face + 0.0115, 0.020, X_UP)
    top = HEIGHT + 0.0024
    strap = box((0.020, WIDTH - 0.060, 0.0026), 0.001).at(0.052, 0.0, top + 0.0008)
    plate = block((0.044, 0.030, 0.0014)).at(-0.020, 0.010, top)
    bars = joined(block((0.0035, 0.010, 0.0014)).at(-0.030 + 0.006 * n, -0.022, top) for n in range(4))
    heads = screws(
        [(sx * (length / 2 - 0.010), sy * (face - 0.010), HEIGHT) for sx in (-1, 1) for sy in (-1, 1)], 0.0034, 0.002
    )
    return merge(
        {
            "olive": shell,
            "black": joined([seal, pull, heads]),
            "rubber": grip,
            "amber": strap,
            "marking": plate,
            "lamp": bars,
        },
        latches,
    )


def spool() -> Look:
    """A spool of optical fibre between two cheeks, its axis along y, on z = 0; the fibre leaves to the rear."""
    radius, half, axis = 0.047, 0.026, 0.055
    flange = extruded(windowed(radius, 0.012, 6, 0.0095), -0.0012, 0.0012)
    sides = joined(flange.at(0.0, y, axis, OUTWARD) for y in (-half, half))
    winding = lathe(
        [(0.010, -half), (0.036, -half), (0.038, -half * 0.4), (0.037, half * 0.4), (0.035, half), (0.010, half)], 24
    )
    hub = joined([pin(-half - 0.012, half + 0.012, 0.008, 16), hexagons(1, 0.0, half + 0.012, 0.006, 0.003)])
    cheek = shapely.unary_union(
        [
            shapely.Polygon([(-0.030, 0.0), (0.030, 0.0), (0.012, axis), (-0.012, axis)]),
            shapely.Point(0.0, axis).buffer(0.013, quad_segs=6),
        ]
    )
    cheek = cheek.difference(shapely.Polygon([(-0.014, 0.010), (0.014, 0.010), (0.006, 0.034), (-0.006, 0.034)]))
    plates = joined(
        across(extruded(cheek, -0.002, 0.002, 0.0006)).at(0.0, y, 0.0) for y in (-half - 0.008, half + 0.008)
    )
    foot = extruded(round_rectangle(0.074, 2.0 * half + 0.032, 0.006), -0.001, 0.003, 0.001)
    bolts = screws([(sx * 0.031, sy * (half + 0.008), 0.003) for sx in (-1, 1) for sy in (-1, 1)], 0.003, 0.002)
    fibre = swept(
        [
            (-0.010, 0.004, axis + 0.036),
            (-0.050, 0.004, axis + 0.020),
            (-0.070, 0.002, axis - 0.004),
            (-0.082, 0.0, axis - 0.012),
        ],
        0.0011,
        5,
    )
    guide = lathe([(0.0055, 0.0), (0.004, 0.004), (0.0032, 0.012), (0.0032, 0.018)], 12).at(
        -0.078, 0.0, axis - 0.010, REARWARD
    )
    arm = swept([(-0.030, 0.0, 0.004), (-0.060, 0.0, 0.012), (-0.074, 0.0, axis - 0.016)], 0.0028, 8)
    return {
        "alloy": sides,
        "amber": joined([winding.at(0.0, 0.0, axis, OUTWARD), fibre]),
        "steel": joined([hub.at(0.0, 0.0, axis, OUTWARD), guide]),
        "dark": joined([plates, foot, arm]),
        "black": bolts,
    }


def fan(radius: float) -> Look:
    """A fan behind its guard, on z = 0."""
    frame = shapely.Polygon(
        round_rectangle(2.0 * radius + 0.006, 2.0 * radius + 0.006, 0.004), [circle(radius, segments=20)[::-1]]
    )
    rim = extruded(frame, 0.0, 0.0035, 0.0008)
    blades = joined(
        block((radius * 0.72, radius * 0.42, 0.0008))
        .at(radius * 0.58, 0.0, 0.0, turned(x=0.55))
        .at(0.0, 0.0, 0.0006, turned(z=2.0 * math.pi * n / 7.0))
        for n in range(7)
    )
    hub = pin(-0.001, 0.0022, radius * 0.34, 14)
    guard = joined(
        [lathe([(r - 0.0007, 0.0035), (r, 0.0046), (r + 0.0007, 0.0035)], 20) for r in (radius * 0.45, radius * 0.72)]
        + [block((2.0 * radius, 0.0013, 0.0011)).at(0.0, 0.0, 0.0038, turned(z=a)) for a in (math.pi / 4, -math.pi / 4)]
    )
    heads = screws([(sx * radius * 0.9, sy * radius * 0.9, 0.0035) for sx in (-1, 1) for sy in (-1, 1)], 0.0019, 0.0012)
    return {
        "dark": joined([rim, blades, hub]),
        "steel": guard,
        "black": joined([heads, pin(-0.001, 0.0001, radius, 18)]),
    }


def computer() -> Look:
    """A sealed box of electronics with fans, fins and plugs, as if on the left."""
    length, width = LENGTH - 0.022, WIDTH - 0.018
    shell, seal = case(length, width, HEIGHT)
    face = width / 2.0
    fans = merge(*(moved(fan(0.0165), x, face + 0.0022, 0.020, OUTWARD) for x in (-0.145, -0.100)))
    latches = merge(*(moved(latch(), x, face + 0.001, HEIGHT - 0.022, OUTWARD) for x in (-0.055, 0.045, 0.150)))
    plugs = merge(*(moved(connector(0.0085), length / 2.0, y, 0.022, X_UP) for y in (-0.022, 0.014)))
    behind = moved(connector(0.0095), -length / 2.0, 0.012, 0.022, REARWARD)
    plate = block((0.060, 0.0016, 0.016)).at(-0.005, face + 0.0022, 0.016)
    slits = joined(block((0.003, 0.003, 0.018)).at(0.075 + 0.008 * n, face + 0.0006, 0.018) for n in range(7))
    cable = swept(
        [
            (length / 2 + 0.014, 0.0, 0.022),
            (length / 2 + 0.030, -0.004, 0.020),
            (length / 2 + 0.034, -0.040, 0.000),
            (length / 2 + 0.020, -0.080, -0.008),
        ],
        0.004,
    )
    return merge(
        {"olive": shell, "black": joined([seal, slits]), "marking": plate, "rubber": cable},
        fans,
        latches,
        plugs,
        behind,
    )


def disruptor() -> Look:
    """A disruptor in its clamps, along x on z = 0: it shoots water into a device."""
    axis, front, rear = 0.030, 0.205, -0.150
    barrel = lathe(
        [
            (0.0095, rear),
            (0.0165, rear),
            (0.0165, 0.10),
            (0.0135, 0.106),
            (0.0135, front - 0.022),
            (0.0165, front - 0.020),
            (0.0165, front - 0.002),
            (0.0150, front),
            (0.0100, front),
            (0.0095, front - 0.010),
            (0.0, front - 0.012),
        ],
        22,
    )
    breech = lathe(
        [
            (0.0, rear - 0.044),
            (0.012, rear - 0.044),
            (0.015, rear - 0.040),
            (0.0205, rear - 0.036),
            (0.0205, rear - 0.010),
            (0.0185, rear - 0.006),
            (0.0185, rear + 0.016),
            (0.0165, rear + 0.018),
        ],
        22,
    )
    bore = lathe([(0.0096, front - 0.0095), (0.0, front - 0.0095)], 22)
    knurls = joined(
        block((0.0022, 0.0022, 0.022)).at(0.0202 * math.cos(a), 0.0202 * math.sin(a), rear - 0.023)
        for a in np.linspace(0.0, 2.0 * math.pi, 16, endpoint=False)
    )
    rings = joined(
        lathe([(0.0165, z), (0.0185, z + 0.001), (0.0185, z + 0.007), (0.0165, z + 0.008)], 22) for z in (-0.03, 0.03)
    )
    saddle = shapely.Polygon([(-0.026, 0.0), (0.026, 0.0), (0.024, axis), (-0.024, axis)]).union(
        shapely.Point(0.0, axis).buffer(0.024, quad_segs=5)
    )
    saddle = saddle.difference(shapely.Point(0.0, axis).buffer(0.0163, quad_segs=5))
    clamp = extruded(saddle, -0.009, 0.009, 0.0012).at(turn=X_UP @ turned(z=math.pi / 2.0))
    knob = joined(
        [
            pin(0.0, 0.010, 0.004, 10),
            lathe([(0.009, 0.010), (0.010, 0.012), (0.010, 0.019), (0.008, 0.021), (0.0, 0.021)], 10),
        ]
    )
    places = (-0.100, 0.075)
    cable = swept(
        [
            (rear - 0.042, 0.0, axis),
            (rear - 0.062, 0.004, axis - 0.004),
            (rear - 0.060, 0.016, 0.012),
            (rear - 0.030, 0.024, 0.004),
            (rear + 0.02, 0.026, 0.003),
        ],
        0.0026,
    )
    return {
        "alloy": barrel.at(0.0, 0.0, axis, X_UP),
        "dark": joined(
            [breech.at(0.0, 0.0, axis, X_UP), knurls.at(0.0, 0.0, axis, X_UP), *(clamp.at(x) for x in places)]
        ),
        "black": joined(
            [joined([rings, bore]).at(0.0, 0.0, axis, X_UP), *(knob.at(x, 0.0, axis + 0.022) for x in places)]
        ),
        "amber": cable,
    }


def payload(size: Dimensions) -> Look:
    """All of it, in the frame of base_link."""
    x, y, z = size.track_x + REAR + LENGTH / 2.0, (size.gauge + 0.004) / 2.0, size.deck + ABOVE
    on = 0.004
    shelf = tray()
    quarter = LENGTH / 4.0
    left = merge(
        shelf,
        *(moved(battery(), side * quarter, 0.0, on) for side in (-1.0, 1.0)),
        moved(spool(), -quarter - 0.010, 0.0, on + HEIGHT + 0.0024),
    )
    right = merge(shelf, moved(computer(), 0.0, 0.0, on), moved(disruptor(), 0.020, -0.004, on + HEIGHT + 0.002))
    return merge(moved(left, x, y, z), moved({name: mirrored(mesh) for name, mesh in right.items()}, x, -y, z))
