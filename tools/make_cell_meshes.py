"""Make the visual meshes of the factory cell: rounded housings, flanges, bolts, covers of the robot.

    python tools/make_cell_meshes.py [FILE]

writes `src/jauspy_sim/cell/meshes.npz`, or FILE. Each mesh is named LOOK.MATERIAL, as in `x5_inline.housing`, and has
three arrays: vertices (m), normals, and triangles. Frames are those of the parts (`platform/modular/parts.py`), of the
output links of servo modules, and of the links of `ur10.urdf.xacro`. Collision shapes are elsewhere: `Solid`.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mesh_shapes import X_UP, Y_UP, Mesh, bolts, box, cylinder, joined, lathe, rounded

TARGET = Path(__file__).parents[1] / "src" / "jauspy_sim" / "cell" / "meshes.npz"


def flange(low: float, high: float, radius: float = 0.03) -> Mesh:
    """A plate with a groove around it."""
    edge, middle = 0.001, (low + high) / 2.0
    groove = [(radius, middle - 0.0012), (radius - 0.0015, middle), (radius, middle + 0.0012)]
    profile = rounded(low, high, radius, edge)
    cut = len(profile) // 2
    return lathe([*profile[:cut], *groove, *profile[cut:]])


def lip(z: float, radius: float = 0.029) -> Mesh:
    """The rubber lip of a vacuum plate, which ends at height z."""
    inner = radius - 0.005
    profile = [(inner - 0.001, z - 0.003), (inner, z - 0.006), (radius, z - 0.006), (radius + 0.001, z - 0.002)]
    return lathe([*profile, (radius - 0.001, z), (inner + 0.001, z), (inner - 0.001, z - 0.003)])


def vacuum_plate(low: float, high: float, radius: float = 0.03) -> dict[str, Mesh]:
    """A connector: metal, lip and inlet."""
    metal = joined([flange(low, high - 0.003, radius), cylinder(low, high - 0.002, 0.008)])
    return {"metal": metal, "rubber": lip(high, radius - 0.001), "dark": bolts(6, radius - 0.0115, high - 0.003)}


def on_sides(mesh: Mesh, x: float, ys: Sequence[float], zs: Sequence[float]) -> Mesh:
    """A mesh that stands on z, on both faces that look along x."""
    back = np.diag([-1.0, 1.0, -1.0]) @ X_UP
    return joined([mesh.at(x, y, z, X_UP) for y in ys for z in zs] + [mesh.at(-x, y, z, back) for y in ys for z in zs])


# --- parts -----------------------------------------------------------------------------------------------------------


def inline_servo(accent: str) -> dict[str, Mesh]:
    """A module whose output turns about the axis of its input."""
    head = bolts(1, 0.0, 0.0)
    ribs = [box((0.05, 0.0525, 0.003), 0.001).at(z=0.030 + 0.007 * number) for number in range(4)]
    return {
        "metal": joined([flange(0.0, 0.010), cylinder(0.008, 0.016, 0.024), cylinder(0.084, 0.090, 0.027)]),
        "housing": joined([box((0.064, 0.05, 0.072), 0.009, 2).at(z=0.050), *ribs]),
        accent: joined(
            [box((0.0646, 0.0506, 0.005), 0.0045).at(z=0.068), box((0.03, 0.052, 0.010), 0.002).at(z=0.077)]
        ),
        "dark": joined([on_sides(head, 0.032, (-0.019, 0.019), (0.022, 0.080)), bolts(6, 0.0265, 0.0095, 0.0018)]),
        "rubber": cylinder(0.0, 0.0008, 0.016, 0.0004).at(0.0318, 0.0, 0.045, X_UP),
    }


def inline_output() -> dict[str, Mesh]:
    """Its output link."""
    return vacuum_plate(0.002, 0.030)


def elbow_servo(accent: str, x: float, y: float, joint: float, height: float) -> dict[str, Mesh]:
    """A module whose axis is across, at height `joint`; x, y and `height` are those of the housing."""
    head = bolts(1, 0.0, 0.0)
    radius = height - joint
    body = joint - 0.012
    barrel = cylinder(-y / 2.0, y / 2.0, radius + 0.002, 0.003).at(z=joint, turn=Y_UP)
    ring = cylinder(-y / 2.0 - 0.0008, y / 2.0 + 0.0008, radius - 0.004, 0.001).at(z=joint, turn=Y_UP)
    ribs = [box((x - 0.016, y + 0.002, 0.003), 0.001).at(z=0.024 + 0.007 * number) for number in range(3)]
    return {
        "metal": joined([flange(0.0, 0.010), cylinder(0.008, 0.016, 0.024)]),
        "housing": joined([box((x, y, body), 0.008, 2).at(z=0.012 + body / 2.0), barrel, *ribs]),
        accent: joined([box((x + 0.0006, y + 0.0006, 0.005), 0.004).at(z=0.056), ring]),
        "dark": joined([on_sides(head, x / 2.0, (-0.019, 0.019), (0.022, 0.064)), bolts(6, 0.0265, 0.0095, 0.0018)]),
        "rubber": cylinder(0.0, 0.0008, 0.016, 0.0004).at(x / 2.0 - 0.0002, 0.0, 0.045, X_UP),
    }


def elbow_output(y: float) -> dict[str, Mesh]:
    """A fork around a housing of width y, with the plate."""
    found = vacuum_plate(0.058, 0.075)
    at = y / 2.0 + 0.0045
    arms, caps = [], []
    for side in (1.0, -1.0):
        hub = cylinder(-0.003, 0.003, 0.021, 0.0015).at(y=side * at, turn=Y_UP)
        arms += [hub, box((0.034, 0.006, 0.056), 0.0015).at(0.0, side * at, 0.030)]
        turn = Y_UP if side > 0.0 else np.diag([1.0, -1.0, -1.0]) @ Y_UP
        caps += [bolts(6, 0.014, 0.003).at(y=side * at, turn=turn)]
    bridge = box((0.044, 2.0 * at + 0.006, 0.010), 0.003).at(z=0.054)
    found["metal"] = joined([found["metal"], bridge, *arms])
    found["dark"] = joined([found["dark"], *caps])
    return found


def tube(length: float) -> dict[str, Mesh]:
    """A carbon tube with collars and a clamp that the gripper holds."""
    collars = [
        flange(0.0, 0.010),
        cylinder(0.009, 0.022, 0.0245, 0.002),
        cylinder(length - 0.022, length - 0.012, 0.0245),
    ]
    plate = vacuum_plate(length - 0.013, length)
    clamp = box((0.05, 0.046, 0.046), 0.006, 2).at(z=length / 2.0)
    return {
        "carbon": cylinder(0.012, length - 0.012, 0.0205, 0.0005),
        "metal": joined([*collars, plate["metal"]]),
        "accent": clamp,
        "dark": joined(
            [
                plate["dark"],
                on_sides(bolts(1, 0.0, 0.0), 0.025, (-0.017, 0.017), (length / 2.0 - 0.017, length / 2.0 + 0.017)),
            ]
        ),
        "rubber": joined([plate["rubber"], cylinder(0.0, 0.0008, 0.015, 0.0004).at(0.0248, 0.0, length / 2.0, X_UP)]),
    }


def straight_bracket() -> dict[str, Mesh]:
    """A short block."""
    plate = vacuum_plate(0.047, 0.06)
    return {
        "metal": joined([flange(0.0, 0.010), plate["metal"]]),
        "accent": box((0.05, 0.05, 0.036), 0.005, 2).at(z=0.029),
        "housing": joined([box((0.03, 0.052, 0.022), 0.003).at(z=0.029)]),
        "dark": joined([plate["dark"], on_sides(bolts(1, 0.0, 0.0), 0.025, (-0.018, 0.018), (0.018, 0.040))]),
        "rubber": joined([plate["rubber"], cylinder(0.0, 0.0008, 0.014, 0.0004).at(0.0248, 0.0, 0.03, X_UP)]),
    }


def angled_bracket() -> dict[str, Mesh]:
    """A block whose plate looks along x."""
    plate = {name: mesh.at(0.0, 0.0, 0.03, X_UP) for name, mesh in vacuum_plate(0.017, 0.03).items()}
    return {
        "metal": joined([flange(0.0, 0.010), plate["metal"]]),
        "accent": joined([box((0.044, 0.05, 0.050), 0.006, 2).at(-0.004, 0.0, 0.034)]),
        "dark": plate["dark"],
        "rubber": joined([plate["rubber"], cylinder(0.0, 0.0008, 0.014, 0.0004).at(0.0, 0.0248, 0.03, Y_UP)]),
    }


def wheel() -> dict[str, Mesh]:
    """A tyre with treads on a rim."""
    grooves = []
    for number in range(5):
        low = 0.006 + 0.0058 * number
        grooves += [(0.065, low), (0.065, low + 0.004), (0.0625, low + 0.0045), (0.0625, low + 0.0054)]
    tyre = [(0.044, 0.002), (0.056, 0.002), (0.062, 0.004), *grooves, (0.062, 0.037), (0.056, 0.038), (0.044, 0.038)]
    rim = [(0.0, 0.0), (0.03, 0.0), (0.03, 0.006), (0.036, 0.012), (0.044, 0.003), (0.0455, 0.003), (0.0455, 0.037)]
    face = [(0.044, 0.037), (0.038, 0.028), (0.026, 0.030), (0.022, 0.0395), (0.0, 0.0395)]
    return {
        "rubber": lathe(tyre, 40),
        "accent": lathe([*rim, *face], 40),
        "dark": joined([bolts(6, 0.032, 0.0285, 0.003), cylinder(0.039, 0.040, 0.012, 0.0005)]),
    }


def chassis() -> dict[str, Mesh]:
    """The car's body, with plates on its sides and on top."""
    sides = []
    for x in (-0.12, 0.12):
        for side in (1.0, -1.0):
            turn = Y_UP if side > 0.0 else np.diag([1.0, -1.0, -1.0]) @ Y_UP
            sides.append(
                {name: mesh.at(x, side * 0.096, 0.045, turn) for name, mesh in vacuum_plate(0.0, 0.014).items()}
            )
    top = vacuum_plate(0.078, 0.09, 0.036)
    lamps = [cylinder(0.0, 0.004, 0.011).at(0.178, y, 0.045, X_UP) for y in (-0.07, 0.07)]
    bumpers = [box((0.014, 0.19, 0.022), 0.005).at(x, 0.0, 0.030) for x in (-0.176, 0.176)]
    return {
        "white": joined([box((0.35, 0.200, 0.056), 0.014, 2).at(z=0.044)]),
        "accent": joined(
            [box((0.352, 0.2015, 0.008), 0.003).at(z=0.058), box((0.1, 0.12, 0.003), 0.001).at(-0.1, 0.0, 0.0815)]
        ),
        "metal": joined(
            [box((0.31, 0.170, 0.014), 0.004).at(z=0.075), top["metal"], *(each["metal"] for each in sides)]
        ),
        "dark": joined(
            [*bumpers, top["dark"], box((0.30, 0.15, 0.012), 0.003).at(z=0.008), *(each["dark"] for each in sides)]
        ),
        "rubber": joined([top["rubber"], *(each["rubber"] for each in sides)]),
        "lamp": joined(lamps),
    }


def platform() -> dict[str, Mesh]:
    """A column with a plate on top."""
    plate = vacuum_plate(0.188, 0.2, 0.036)
    feet = [cylinder(0.0, 0.004, 0.006, 0.001).at(x, y, 0.012) for x in (-0.075, 0.075) for y in (-0.075, 0.075)]
    return {
        "frame": joined([box((0.18, 0.18, 0.012), 0.002).at(z=0.006), box((0.12, 0.12, 0.165), 0.012, 2).at(z=0.093)]),
        "metal": joined([box((0.18, 0.18, 0.014), 0.003).at(z=0.181), plate["metal"]]),
        "warning": box((0.1215, 0.1215, 0.018), 0.006).at(z=0.155),
        "dark": joined([plate["dark"], *feet, bolts(8, 0.082, 0.188, 0.004, 0.003)]),
        "rubber": plate["rubber"],
        "lamp": cylinder(0.0, 0.002, 0.006).at(0.06, 0.0, 0.1, X_UP),
    }


def parcel() -> dict[str, Mesh]:
    """A cardboard box with tape and a label."""
    down = [box((0.001, 0.032, 0.03), 0.0004).at(x, 0.0, 0.085) for x in (-0.0801, 0.0801)]
    return {
        "cardboard": box((0.16, 0.12, 0.1), 0.0025).at(z=0.05),
        "tape": joined([box((0.1606, 0.032, 0.001), 0.0004).at(z=0.1001), *down]),
        "white": box((0.05, 0.0008, 0.035), 0.0003).at(0.03, -0.0601, 0.06),
        "dark": joined([box((0.002, 0.001, 0.016), 0.0002).at(0.012 + 0.004 * n, -0.0602, 0.066) for n in range(9)]),
    }


# --- the robot: frames of the links of ur10.urdf.xacro --------------------------------------------------------------


def cap(low: float, high: float, radius: float) -> Mesh:
    """A domed cover over the end of a joint."""
    height = high - low
    dome = [
        (radius * math.cos(a), high - 0.5 * height + 0.5 * height * math.sin(a))
        for a in np.linspace(0.0, math.pi / 2.0, 7)
    ]
    return lathe([(0.0, low), (radius, low), *[(max(r, 0.0), z) for r, z in dome[:-1]], (0.0, high)], 40)


def barrel(start: float, end: float, radius: float, edge: float = 0.006) -> Mesh:
    """A cylinder along z with widely rounded edges."""
    return cylinder(start, end, radius, edge, 36)


def along_y(mesh: Mesh, z: float = 0.0, y: float = 0.0, *, back: bool = False) -> Mesh:
    """A mesh that stands on z, turned to y, or to -y."""
    turn = np.diag([1.0, -1.0, -1.0]) @ Y_UP if back else Y_UP
    return mesh.at(0.0, y, z, turn)


def link_tube(low: float, high: float, first: float, last: float) -> Mesh:
    """A tapered tube along z with collars."""
    collar = 0.012
    profile = [(0.0, low), (first + 0.004, low), (first + 0.004, low + collar), (first, low + collar + 0.004)]
    profile += [(last, high - collar - 0.004), (last + 0.004, high - collar), (last + 0.004, high), (0.0, high)]
    return lathe(profile, 48)


def robot() -> dict[str, dict[str, Mesh]]:
    """Covers of the robot and its gripper, by link."""
    flip = np.diag([1.0, -1.0, -1.0])
    return {
        "base_link": {
            "silver": lathe(
                [(0.0, 0.0), (0.095, 0.0), (0.095, 0.016), (0.09, 0.022), (0.078, 0.034), (0.075, 0.038), (0.0, 0.038)],
                40,
            ),
            "dark": joined([bolts(4, 0.086, 0.0185, 0.006, 0.005), cylinder(0.036, 0.041, 0.073, 0.001)]),
        },
        "shoulder_link": {
            "silver": joined([barrel(-0.087, 0.062, 0.075, 0.02), along_y(barrel(-0.06, 0.137, 0.068))]),
            "dark": along_y(barrel(0.136, 0.141, 0.064, 0.001)),
            "blue": joined([along_y(cap(0.058, 0.088, 0.066), back=True), cap(0.058, 0.083, 0.062)]),
        },
        "upper_arm_link": {
            "silver": joined(
                [
                    along_y(barrel(-0.079, 0.07, 0.068)),
                    link_tube(0.05, 0.565, 0.058, 0.050),
                    along_y(barrel(-0.094, 0.055, 0.058), 0.612),
                ]
            ),
            "dark": along_y(barrel(-0.098, -0.093, 0.052, 0.001), 0.612),
            "blue": joined([along_y(cap(0.066, 0.096, 0.066)), along_y(cap(0.052, 0.080, 0.056), 0.612)]),
        },
        "forearm_link": {
            "silver": joined(
                [
                    along_y(barrel(-0.055, 0.072, 0.056)),
                    link_tube(0.045, 0.535, 0.045, 0.038),
                    along_y(barrel(-0.048, 0.052, 0.045), 0.5723),
                ]
            ),
            "dark": along_y(barrel(0.051, 0.056, 0.041, 0.001), 0.5723),
            "blue": joined(
                [along_y(cap(0.052, 0.078, 0.054), back=True), along_y(cap(0.045, 0.066, 0.043), 0.5723, back=True)]
            ),
        },
        "wrist_1_link": {
            "silver": joined([along_y(barrel(0.057, 0.115, 0.044)), barrel(-0.048, 0.052, 0.045).at(y=0.1149)]),
            "dark": barrel(0.051, 0.056, 0.041, 0.001).at(y=0.1149),
            "blue": joined(
                [cap(0.045, 0.066, 0.043).at(y=0.1149, turn=flip), along_y(cap(0.040, 0.062, 0.0425), 0.0, 0.1149)]
            ),
        },
        "wrist_2_link": {
            "silver": joined([barrel(0.057, 0.1157, 0.044), along_y(barrel(-0.048, 0.05, 0.045), 0.1157)]),
            "dark": along_y(barrel(0.049, 0.054, 0.04, 0.001), 0.1157),
            "blue": joined(
                [along_y(cap(0.045, 0.066, 0.043), 0.1157, back=True), cap(0.040, 0.062, 0.0425).at(z=0.1157)]
            ),
        },
        "wrist_3_link": {
            "silver": along_y(barrel(0.0545, 0.0922, 0.0375, 0.003)),
            "dark": along_y(bolts(4, 0.028, 0.092)),
        },
        "gripper": {
            "metal": joined([barrel(-0.120, -0.108, 0.037, 0.002), barrel(-0.046, -0.014, 0.017, 0.002)]),
            "housing": barrel(-0.108, -0.046, 0.031, 0.006),
            "accent": barrel(-0.084, -0.074, 0.0316, 0.001),
            "dark": joined(
                [
                    lathe(
                        [
                            (0.012, -0.014),
                            (0.02, -0.012),
                            (0.014, -0.009),
                            (0.021, -0.007),
                            (0.015, -0.004),
                            (0.022, -0.001),
                            (0.022, 0.0),
                            (0.0, 0.0),
                        ],
                        36,
                    ),
                    bolts(6, 0.0325, -0.1085),
                ]
            ),
        },
    }


def everything() -> dict[str, Mesh]:
    """All meshes, by name."""
    looks: dict[str, dict[str, Mesh]] = {
        "inline_output": inline_output(),
        "x5_inline": inline_servo("accent"),
        "x5_elbow": elbow_servo("accent", 0.064, 0.05, 0.08, 0.105),
        "x5_elbow_output": elbow_output(0.05),
        "x8_elbow": elbow_servo("red", 0.068, 0.056, 0.085, 0.11),
        "x8_elbow_output": elbow_output(0.056),
        "tube_short": tube(0.15),
        "tube_long": tube(0.2),
        "bracket_straight": straight_bracket(),
        "bracket_angled": angled_bracket(),
        "wheel": wheel(),
        "chassis": chassis(),
        "platform": platform(),
        "box": parcel(),
        **robot(),
    }
    return {f"{look}.{material}": mesh for look, parts in looks.items() for material, mesh in parts.items()}


def main() -> None:
    """Write the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", type=Path, default=TARGET)
    target = parser.parse_args().file
    arrays: dict[str, NDArray[np.generic]] = {}
    meshes = everything()
    for name, mesh in meshes.items():
        arrays[f"{name}/vertices"] = mesh.vertices.astype(np.float32)
        arrays[f"{name}/normals"] = mesh.normals.astype(np.float16)
        arrays[f"{name}/triangles"] = mesh.triangles.astype(np.uint16)
    np.savez_compressed(target, **arrays)  # type: ignore[arg-type]  # numpy declares only one keyword
    triangles = sum(len(mesh.triangles) for mesh in meshes.values())
    print(f"{target}: {len(meshes)} meshes, {triangles} triangles, {target.stat().st_size // 1024} KiB")


if __name__ == "__main__":
    main()
