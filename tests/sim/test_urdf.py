"""URDFs of others in the physics: meshes and where they are."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

pytest.importorskip("mujoco")

from jauspy.modules import robot_files
from jauspy.platform.description import RobotModel
from jauspy_sim.assembly import build

CORNERS = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))


def binary_stl(size: float) -> bytes:
    """A tetrahedron."""
    triangles = [
        struct.pack("<12fH", 0, 0, 0, *(size * x for corner in face for x in CORNERS[corner]), 0) for face in FACES
    ]
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(triangles)


TOML = """
name = "it"
urdf = "it.urdf"
subsystem = 7
node = 1
[[modules]]
type = "CM-MAN"
component = 2
[groups.arm]
base = "base"
tip = "arm"
joints = [{ name = "joint", position = { p = 10, d = 1 }, velocity = { p = 1 } }]
"""
LIMIT = '<limit lower="-1" upper="1" effort="10" velocity="1"/>'


def model(folder: Path, visual: str, collision: str, joint: str = LIMIT) -> RobotModel:
    (folder / "it.toml").write_text(TOML)
    (folder / "it.urdf").write_text(
        f"""<robot name="it"><link name="base"/><link name="arm">
        <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
        <visual><geometry><mesh filename="{visual}"/></geometry></visual>
        <collision><geometry><mesh filename="{collision}" scale="2 2 2"/></geometry></collision></link>
        <joint name="joint" type="revolute"><parent link="base"/><child link="arm"/>{joint}</joint></robot>"""
    )
    return robot_files.robot_model(robot_files.load(folder / "it.toml"))


def test_meshes_of_one_name_in_two_directories_are_two(tmp_path: Path) -> None:
    for name, size in (("visual", 0.1), ("collision", 0.2)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "arm.stl").write_bytes(binary_stl(size))
    built = build(model(tmp_path, "visual/arm.stl", "collision/arm.stl"), "empty")
    extents = sorted(round(float(built.geom_rbound[n]), 3) for n in range(built.ngeom) if built.geom_dataid[n] >= 0)
    assert len(extents) == 2
    assert extents[1] / extents[0] == pytest.approx(4.0, rel=0.01)  # twice the size, scaled by two
