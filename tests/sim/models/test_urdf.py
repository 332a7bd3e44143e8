"""URDFs of others in the physics: meshes and where they are."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

pytest.importorskip("mujoco")

from jauspy.errors import ConfigError
from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files
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


ASCII_STL = (
    "solid it\n"
    + "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*(0.1 * x for x in CORNERS[corner])) for corner in face)
        + "endloop\nendfacet\n"
        for face in FACES
    )
    + "endsolid it\n"
)
OBJ = "".join(f"v {x * 0.1} {y * 0.1} {z * 0.1}\n" for x, y, z in CORNERS) + "".join(
    "f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in FACES
)
DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="decimetre" meter="0.1"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<diffuse><color>1 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="f" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>
<accessor source="#f" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4" material="m"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""
MESHES = {
    "ascii.stl": ASCII_STL.encode(),
    "binary.STL": binary_stl(0.1),
    "it.obj": OBJ.encode(),
    "it.dae": DAE.encode(),
}


@pytest.mark.parametrize("name", MESHES)
def test_formats_of_meshes_give_the_same_shape(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(MESHES[name])
    built = build(model(tmp_path, name, name), "empty")
    visual, collision = (
        next(n for n in range(built.ngeom) if built.geom_dataid[n] >= 0 and built.geom_group[n] == group)
        for group in (1, 3)
    )
    assert built.geom_rbound[collision] == pytest.approx(2.0 * built.geom_rbound[visual], rel=0.05)
    assert built.geom_rbound[visual] == pytest.approx(0.117, abs=0.003)
    if name == "it.dae":
        assert tuple(built.geom_rgba[visual]) == (1.0, 0.0, 0.0, 1.0)


def test_flat_mesh_collides(tmp_path: Path) -> None:
    (tmp_path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    assert build(model(tmp_path, "flat.obj", "flat.obj"), "empty").nmesh == 2


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("arm.obj", "leg.obj", r"it\.urdf:3: <mesh>: leg\.obj: there is no such file"),
        ('<mass value="1"/>', '<mass value="-1"/>', r"it\.urdf:2: link 'arm': a mass of -1 kg is negative"),
        ('ixx="1"', 'ixx="-1"', r"it\.urdf:2: link 'arm': <inertia ixx=\"-1\">: is negative"),
        ('ixx="1"', 'ixx="heavy"', r"it\.urdf:2: <inertia ixx='heavy'>: 'heavy' is not 1 finite number"),
        ('effort="10"', 'effort="0"', r"groups\.arm\.joints\[0\]\.name: the joint 'joint' needs .*it\.urdf:5"),
        ('effort="10"', 'effort="-1"', r"it\.urdf:5: joint 'joint': <limit effort=\"-1\">: is negative"),
        ('lower="-1"', 'lower="7"', r"it\.urdf:5: joint 'joint': <limit>: lower 7 is above upper 1"),
        ("arm.obj", "it.urdf", r"it\.urdf:3: <mesh>: .*it\.urdf: is not a mesh that can be read; known are: stl"),
        ("arm.obj", "bad.stl", r"it\.urdf:3: <mesh>: .*bad\.stl: "),
        ("arm.obj", "bad.dae", r"it\.urdf:3: <mesh>: .*bad\.dae: is not read as a mesh: .*XML"),
        ("arm.obj", "bomb.dae", r"it\.urdf:3: <mesh>: .*bomb\.dae: has <!ENTITY"),
        ('scale="2 2 2"', 'scale="2 0 2"', r"it\.urdf:4: <mesh scale=\"2 0 2\">: must not be zero"),
        ('<mesh filename="arm.obj"/>', "<torus/>", r"it\.urdf:3: <torus> is not a shape that is read; known are: box"),
        ('<mesh filename="arm.obj"/>', '<sphere radius="-1"/>', r"it\.urdf:3: <sphere radius=\"-1\">: a size is neg"),
    ],
)
def test_mistakes_are_one_sentence_with_file_line_and_key(tmp_path: Path, old: str, new: str, said: str) -> None:
    for name, data in (("arm", OBJ.encode()), ("bad", b"nothing"), ("bomb", b"<!DOCTYPE d [<!ENTITY a 'b'>]><d/>")):
        for kind in ("obj", "stl", "dae"):
            (tmp_path / f"{name}.{kind}").write_bytes(data)
    parts = (tmp_path, "arm.obj", "arm.obj")
    model(*parts)
    urdf = (tmp_path / "it.urdf").read_text()
    assert old in urdf
    (tmp_path / "it.urdf").write_text(urdf.replace(old, new, 1))
    with pytest.raises(ConfigError, match=said) as caught:
        build(robot_files.robot_model(robot_files.load(tmp_path / "it.toml")), "empty")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("inertia", [(5.0, 1.0, 1.0), (0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (1.0, 0.0, 0.0)])
def test_an_inertia_that_no_body_has_is_mended(
    tmp_path: Path, inertia: tuple[float, ...], caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "arm.obj").write_text(OBJ)
    model(tmp_path, "arm.obj", "arm.obj")
    urdf = (tmp_path / "it.urdf").read_text()
    for key, value in zip(("ixx", "iyy", "izz"), inertia, strict=True):
        urdf = urdf.replace(f'{key}="1"', f'{key}="{value}"')
    (tmp_path / "it.urdf").write_text(urdf)
    built = build(robot_files.robot_model(robot_files.load(tmp_path / "it.toml")), "empty")
    least, middle, most = sorted(built.body("it/arm").inertia)
    assert least > 0.0
    assert least + middle >= most * (1.0 - 1e-6)
    assert ("no body has this inertia" in caplog.text) is any(inertia)


def test_link_named_world_and_link_without_mass(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    (tmp_path / "arm.obj").write_text(OBJ)
    model(tmp_path, "arm.obj", "arm.obj")
    urdf = (tmp_path / "it.urdf").read_text().replace('"base"', '"world"').replace('<mass value="1"/>', "")
    (tmp_path / "it.urdf").write_text(urdf)
    (tmp_path / "it.toml").write_text(TOML.replace('"base"', '"world"'))
    built = build(robot_files.robot_model(robot_files.load(tmp_path / "it.toml")), "empty")
    assert built.body("it/arm").mass[0] == pytest.approx(1000.0 * 0.2**3 / 6.0, rel=0.01)
    assert "joints move 1 links without a mass, which get 1000 kg/m^3 of their collision shapes: arm" in caplog.text
