"""Make the visual meshes of inc1 and inc1_pprm, and the xacro macros that place them.

    python tools/make_robot_meshes.py [-o FOLDER]

writes `meshes/LINK.MATERIAL.obj` and `looks.xacro` to `src/jauspy/robots/urdf`, or to FOLDER. The shapes are in
`tools/robot_parts`; dimensions come from the properties of `chassis.xacro`. For each link there is a macro with its
visuals, as in `<xacro:look_gripper_link/>`; colours are those of `shapes.xacro`. Collision shapes are apart: in the
other files. The right side mirrors the meshes of the left.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from string import digits

import numpy as np

from mesh_shapes import Mesh, merged, mirrored
from robot_parts import arms, chassis, decals, gripper, payload, tracks
from robot_parts.dimensions import URDF, Dimensions, Look, read
from robot_parts.tracks import Running

HEADER = """<?xml version="1.0"?>
<!-- What the links look like: written by tools/make_robot_meshes.py, as are the meshes. -->
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="look" params="link material scale:='1 1 1'">
    <visual>
      <geometry><mesh filename="meshes/${link}.${material}.obj" scale="${scale}"/></geometry>
      <material name="${material}"/>
    </visual>
  </xacro:macro>
"""

MIRRORED = {"left_track": "right_track", "left_flipper": "right_flipper", "left_finger": "right_finger"}
"""The other sides of these."""


def looks(size: Dimensions) -> dict[str, Look]:
    """The looks of links, in their frames."""
    left = tracks.moved(tracks.suspension(size), size.track_x, size.gauge / 2.0)
    right = {name: mirrored(mesh) for name, mesh in left.items()}
    flipper_belt = tracks.belt(tracks.flipper_loop(size), size.flipper_width)
    flipper = tracks.merge({"rubber": flipper_belt}, tracks.flipper_frame(size))
    return {
        "base_link": tracks.merge(
            chassis.body(size),
            left,
            right,
            *(tracks.plate_paint(size, turn) for turn in (decals.LEFT, decals.RIGHT)),
            chassis.camera_bracket(size),
            chassis.lidar_mast(size),
            payload.payload(size),
        ),
        "left_track": tracks.merge(
            {"rubber": tracks.belt(tracks.track_loop(size), size.belt_width)}, tracks.running_gear(size)
        ),
        "left_flipper": flipper,
        "flippers": tracks.flipper_shaft(size),
        "pan_link": chassis.pan_head(),
        "tilt_link": chassis.camera_head(),
        "gripper_link": gripper.palm(),
        "left_finger": gripper.jaw(),
        "turret": arms.turret(),
        "upper_arm": arms.upper_arm(),
        "forearm": arms.forearm(),
        "wrist": arms.wrist(),
        "roll": arms.roll(),
        "mast": arms.mast(),
        "carriage": arms.carriage(),
        "telescope": arms.telescope(),
        "turning_wrist": arms.turning_wrist(),
    }


def moving(size: Dimensions) -> dict[str, dict[str, Running]]:
    """What moves with the belts, by their links."""
    return {
        "left_track": tracks.track(size),
        "left_flipper": tracks.treads(tracks.flipper_loop(size), size.flipper_width),
    }


def obj(mesh: Mesh) -> str:
    """A mesh as Wavefront OBJ: hundredths of millimetres, hundredths of unit normals."""
    mesh = merged(mesh)
    points, point = np.unique(np.round(mesh.vertices, 5), axis=0, return_inverse=True)
    normals, normal = np.unique(np.round(mesh.normals, 2) + 0.0, axis=0, return_inverse=True)
    lines = [f"v {x:.5g} {y:.5g} {z:.5g}" for x, y, z in points + 0.0]
    lines += [f"vn {x:.2g} {y:.2g} {z:.2g}" for x, y, z in normals]
    corners = np.stack([point.reshape(-1)[mesh.triangles], normal.reshape(-1)[mesh.triangles]], axis=-1) + 1
    for a, b, c in corners.tolist():
        if len({a[0], b[0], c[0]}) == 3:
            lines.append(f"f {a[0]}//{a[1]} {b[0]}//{b[1]} {c[0]}//{c[1]}")
    return "\n".join(lines) + "\n"


def _mesh(link: str, part: str) -> str:
    return f"{link}_{part.rstrip(digits)}"


def running(link: str, name: str, part: Running, scale: str) -> list[str]:
    """The lines of visuals that move with a belt; `jauspy_sim/models/track_visuals.py` reads their attributes.

    Parts whose names differ by a number at the end have the same meshes.
    """
    attributes = {
        "pitch": f"{part.pitch:.5g}" if part.pitch else "",
        "radius": f"{part.radius:.5g}" if part.radius else "",
        "way": "backward" if part.backward else "forward",
    }
    given = "".join(f' belt_{key}="{value}"' for key, value in attributes.items() if value)
    origin = " ".join(f"{each:.5g}" for each in part.origin)
    mesh = _mesh(link, name)
    return [
        f'    <visual{given}><origin xyz="{origin}"/><geometry><mesh filename="meshes/{mesh}.{material}.obj" '
        f'scale="{scale}"/></geometry><material name="{material}"/></visual>'
        for material in part.look
    ]


def swinging(link: str, name: str, whip: chassis.Whip) -> list[str]:
    """The lines of visuals that swing; `jauspy_sim/models/whips.py` reads their attributes."""
    origin = " ".join(f"{each:.5g}" for each in whip.foot)
    return [
        f'    <visual whip_frequency="{whip.frequency:.5g}" whip_length="{whip.length:.5g}"><origin xyz="{origin}"/>'
        f'<geometry><mesh filename="meshes/{_mesh(link, name)}.{material}.obj"/></geometry>'
        f'<material name="{material}"/></visual>'
        for material in whip.look
    ]


def macros(
    made: dict[str, Look], belts: dict[str, dict[str, Running]], whips: dict[str, dict[str, chassis.Whip]]
) -> str:
    """The text of `looks.xacro`."""
    lines = [HEADER]
    for link, look in made.items():
        for name, scale in ((link, ""), (MIRRORED.get(link, ""), ' scale="1 -1 1"')):
            if name:
                lines.append(f'  <xacro:macro name="look_{name}">')
                lines += [f'    <xacro:look link="{link}" material="{material}"{scale}/>' for material in look]
                for part in belts.get(link, {}).items():
                    lines += running(link, *part, "1 -1 1" if scale else "1 1 1")
                for antenna in whips.get(link, {}).items():
                    lines += swinging(link, *antenna)
                lines.append("  </xacro:macro>\n")
    return "\n".join([*lines[:-1], "  </xacro:macro>\n</robot>\n"])


def main() -> None:
    """Write the files."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=URDF, metavar="FOLDER")
    folder = parser.parse_args().output
    (folder / "meshes").mkdir(parents=True, exist_ok=True)
    size = read()
    made, belts, whips = looks(size), moving(size), {"base_link": chassis.antennas(size)}
    for old in (folder / "meshes").glob("*.obj"):
        old.unlink()
    sizes = []
    parts = {
        _mesh(link, name): part.look
        for links in (belts, whips)
        for link, found in links.items()
        for name, part in found.items()
    }
    for link, look in {**made, **parts}.items():
        for material, mesh in look.items():
            file = folder / "meshes" / f"{link}.{material}.obj"
            file.write_text(obj(mesh))
            sizes.append(file.stat().st_size)
        print(f"{link:20} {sum(len(mesh.triangles) for mesh in look.values()):6} triangles")
    (folder / "looks.xacro").write_text(macros(made, belts, whips))
    print(f"{len(sizes)} meshes, {sum(sizes) / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
