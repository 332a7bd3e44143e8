"""Worlds of one's own: MJCF, SDF, and lists of objects in TOML."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

pytest.importorskip("mujoco")

import mujoco
import numpy as np
from PIL import Image

from jauspy.errors import ConfigError
from jauspy.robot import robot_files
from jauspy_sim.assembly import build
from jauspy_sim.models.mesh_files import read_mesh
from jauspy_sim.models.slabs import convex_pieces
from jauspy_sim.worlds.model_paths import ModelPaths
from jauspy_sim.worlds.world_files import world_spec


def opened(path: Path, *model_path: Path) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = world_spec(str(path), [str(each) for each in model_path]).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def settled(path: Path, *model_path: Path, seconds: float = 1.0) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model, data = opened(path, *model_path)
    mujoco.mj_step(model, data, round(seconds / model.opt.timestep))
    return model, data


def written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


# MJCF


@pytest.mark.slow
def test_mjcf_with_include_and_a_robot(tmp_path: Path) -> None:
    written(tmp_path, "things/box.xml", '<mujoco><asset><material name="red" rgba="1 0 0 1"/></asset></mujoco>')
    path = written(
        tmp_path,
        "it.xml",
        """<mujoco><include file="things/box.xml"/><worldbody><geom type="plane" size="5 5 1"/>
        <body name="box" pos="2 0 1"><freejoint/><geom size=".1 .1 .1" type="box" material="red" group="2"/></body>
        </worldbody><keyframe><key qpos="2 0 1 1 0 0 0"/></keyframe></mujoco>""",
    )
    model = build(robot_files.robot_model(robot_files.load("inc1")), str(path))
    assert model.geom_group[model.body("box").geomadr[0]] == 0  # drawn, and hit by lidars
    assert model.nkey == 0


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        (
            "it.xml",
            "<mujoco><worldbody><geom type='bal'/></worldbody></mujoco>",
            r"it\.xml: MuJoCo cannot read it: .*bal",
        ),
        ("it.xml", "<sdf version='1.6'><world name='w'/></sdf>", r"it\.xml: .*SDF worlds have the suffix \.sdf"),
        ("none.sdf", None, r"none\.sdf: there is no such file"),
        ("it.obj/", None, r"is not a regular file|there is no such file"),
        ("./it.dae", "x", r"its name must end in one of: \.xml"),
        ("it.sdf", "<sdf version='1.6'>\n<world>", r"it\.sdf:2: is not XML"),
        ("it.sdf", "<robot/>", r"it\.sdf:1: begins with <robot>, not with <sdf>"),
    ],
)
def test_wrong_files_are_named(tmp_path: Path, name: str, text: str | None, said: str) -> None:
    if text is not None:
        written(tmp_path, name, text)
    with pytest.raises(ConfigError, match=said) as caught:
        world_spec(f"{tmp_path}/{name}")
    assert "\n" not in str(caught.value)


def test_unknown_name_lists_worlds_and_kinds_of_files() -> None:
    with pytest.raises(ConfigError, match=r"no world 'moon'; it has: .*empty.*; or give the path of a file: \.xml"):
        world_spec("moon")


# SDF

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


def sdf(models: str, version: str = "1.9") -> str:
    ground = """<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane>
    <normal>0 0 1</normal><size>9 9</size></plane></geometry></collision></link></model>"""
    return f'<sdf version="{version}"><world name="w">\n{ground}\n{models}\n</world></sdf>'


def test_sdf_poses_are_relative_to_what_they_name(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        "it.sdf",
        sdf(f"""<frame name="corner"><pose>1 2 0 0 0 0</pose></frame>
        <model name="m"><static>1</static><pose relative_to="corner" degrees="true">0 0 1 0 0 90</pose>
        <frame name="f" attached_to="a"><pose>0 0 2 0 0 0</pose></frame>
        <link name="a"><pose>1 0 0 0 0 0</pose></link>
        <link name="b"><pose relative_to="f" rotation_format="quat_xyzw">0 1 0  0 0 0 1</pose>
        <collision name="c">{BOX}</collision></link></model>"""),
    )
    model, data = opened(path)
    geom = model.body("m").geomadr[0]
    assert data.geom_xpos[geom] == pytest.approx((1.0 - 1.0, 2.0 + 1.0, 3.0))


def test_sdf_model_with_joints_falls_and_swings(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        "it.sdf",
        sdf(f"""<model name="box"><pose>0 0 2 0 0 0</pose><link name="l"><inertial><mass>3</mass></inertial>
        <collision name="c">{BOX}<surface><friction><ode><mu>0.3</mu></ode></friction></surface>
        </collision></link></model>
        <model name="door"><pose>3 0 1 0 0 0</pose>
        <link name="leaf"><pose>0.4 0 0 0 0 0</pose><inertial><mass>10</mass><inertia><ixx>1</ixx><iyy>1</iyy>
        <izz>1</izz></inertia></inertial>
        <visual name="v"><geometry><box><size>0.8 0.04 2</size></box></geometry></visual></link>
        <joint name="hinge" type="revolute"><pose>-0.4 0 0 0 0 0</pose><parent>world</parent><child>leaf</child>
        <axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>1.5</upper></limit><dynamics><damping>2</damping></dynamics>
        </axis>
        </joint></model>"""),
    )
    model, data = settled(path, seconds=2.0)
    assert data.body("box/l").xpos == pytest.approx((0.0, 0.0, 0.5), abs=0.01)
    assert model.body("box/l").mass[0] == pytest.approx(3.0)
    assert model.geom_friction[model.body("box/l").geomadr[0]][0] == pytest.approx(0.3)
    assert model.jnt_range[model.joint("door/hinge").id] == pytest.approx((0.0, 1.5))
    data.joint("door/hinge").qpos[0] = math.pi / 2.0
    mujoco.mj_forward(model, data)
    assert data.body("door/leaf").xpos == pytest.approx((3.0, 0.4, 1.0), abs=0.02)


def test_sdf_includes_models_from_search_paths(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for place, size in (("shop", 0.1), ("home", 0.2)):
        model = (
            f'<sdf version="1.6"><model name="can"><link name="l"><collision name="c"><geometry><sphere><radius>{size}'
        )
        text = f"{model}</radius></sphere></geometry></collision></link></model></sdf>"
        written(tmp_path, f"{place}/can/new.sdf", text)
        written(tmp_path, f"{place}/can/model.sdf", "<sdf/>")
        config = '<model><sdf version="1.4">model.sdf</sdf><sdf version="1.6">new.sdf</sdf></model>'
        written(tmp_path, f"{place}/can/model.config", config)
    include = "<include><uri>model://can</uri><pose>{} 0 0 0 0 0</pose></include>"
    path = written(tmp_path, "world/it.sdf", sdf(include.format(1) + include.format(2)))
    with pytest.raises(ConfigError, match=r"it\.sdf:4: <include>: model://can: is not found; --model-path"):
        world_spec(str(path))
    monkeypatch.setenv("GZ_SIM_RESOURCE_PATH", f"/none:{tmp_path / 'shop'}")
    model, data = opened(path)
    assert data.body("can_2/l").xpos[0] == 2.0
    assert model.geom_size[model.body("can/l").geomadr[0]][0] == 0.1
    model, _ = opened(path, tmp_path / "home")
    assert model.geom_size[model.body("can/l").geomadr[0]][0] == 0.2


@pytest.mark.parametrize(("first", "second"), [("a", "a"), ("b", "a")])
def test_a_model_that_includes_itself_is_named(tmp_path: Path, first: str, second: str) -> None:
    for name, other in (("a", first), ("b", second)):
        model = f'<sdf version="1.6"><model name="{name}">\n<include><uri>model://{other}</uri></include></model></sdf>'
        written(tmp_path, f"models/{name}/model.sdf", model)
    path = written(tmp_path, "it.sdf", sdf("<include><uri>model://a</uri></include>"))
    with pytest.raises(
        ConfigError, match=rf"models/{first}/model\.sdf:2: <include>: .*models/a/model\.sdf includes itself"
    ):
        world_spec(str(path))


TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
MESH = (
    "<model name='m'><static>1</static><link name='l'><visual name='v'><geometry><mesh><uri>{}</uri></mesh></geometry>"
    "</visual></link></model>"
)
MANIFEST = "<package><name>arena</name><export><gazebo_ros {}/></export></package>"


@pytest.mark.parametrize(
    ("place", "uri"),
    [
        ("arenas/worlds/wall.obj", "file://wall.obj"),
        ("arenas/worlds/parts/wall.obj", "file://parts/wall.obj"),
        ("arenas/worlds/Media/models/wall.obj", "file://wall.obj"),
        ("arenas/meshes/wall.obj", "file://../meshes/wall.obj"),
        ("elements/Media/models/wall.obj", "file://wall.obj"),
        ("elements/wall/mesh.obj", "model://wall/mesh.obj"),
    ],
)
def test_files_of_a_world_are_relative_to_it_or_in_packages_beside_it(tmp_path: Path, place: str, uri: str) -> None:
    """As in the arenas of hector_nist_arenas_gazebo."""
    written(tmp_path, place, TETRAHEDRON)
    written(tmp_path, "arenas/package.xml", MANIFEST.format(""))
    written(tmp_path, "elements/package.xml", MANIFEST.format('gazebo_media_path="${prefix}"'))
    written(tmp_path, "broken/package.xml", "<package>")
    model, _ = opened(written(tmp_path, "arenas/worlds/it.world", sdf(MESH.format(uri))))
    assert model.nmesh == 1


def test_a_package_exports_directories_of_its_own_only(tmp_path: Path) -> None:
    written(tmp_path, "secret/wall.obj", TETRAHEDRON)
    written(tmp_path, "a/package.xml", MANIFEST.format('gazebo_media_path="${prefix}/../secret"'))
    written(tmp_path, "b/package.xml", MANIFEST.format(f'gazebo_model_path="{tmp_path}/secret"'))
    path = written(tmp_path, "arenas/it.world", sdf(MESH.format("file://wall.obj")))
    with pytest.raises(ConfigError, match=r"it\.world:\d+: <mesh>: file://wall\.obj: is not found"):
        world_spec(str(path))


def test_models_are_not_left_by_dots(tmp_path: Path) -> None:
    written(tmp_path, "models/can/model.sdf", "")
    written(tmp_path, "secret.txt", "")
    with pytest.raises(ConfigError, match="leads out of the model 'can'"):
        ModelPaths((tmp_path / "models",), {}).file("model://can/../../secret.txt", tmp_path / "it.sdf")


def test_what_sdf_has_besides_is_named_once_with_lines(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    plugins = "<plugin name='a' filename='b'/>\n" * 6
    path = written(
        tmp_path, "it.sdf", sdf(f"{plugins}<actor name='x'/><include><uri>https://fuel/tree</uri></include><gui/>")
    )
    opened(path)
    (record,) = caplog.records
    assert record.getMessage().endswith(
        "it.sdf: not understood and skipped: <plugin> (line 4, line 5, line 6, line 7 and 2 more); "
        "<actor> (line 10); <include> of https://fuel/tree (line 10)"
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<pose>0 0 x 0 0 0</pose>", r"it\.sdf:\d+: <pose>0 0 x 0 0 0</pose>: is not 6 numbers"),
        ("<pose relative_to='nowhere'>0 0 0 0 0 0</pose>", r"it\.sdf:\d+: there is no frame 'nowhere'; there are: .*m"),
        ("<pose relative_to='m'>0 0 0 0 0 0</pose>", r"it\.sdf:\d+: the pose of 'm' is relative to itself"),
        ("<link name='l'><inertial><mass>-1</mass></inertial></link>", r"it\.sdf:4: link 'l': a mass of -1 kg"),
        (
            "<link name='l'><collision name='c'><geometry><mesh><uri>no.stl</uri></mesh></geometry></collision></link>",
            r"it\.sdf:4: <mesh>: no\.stl: there is no such file",
        ),
        (
            "<link name='l'><collision name='c'><geometry><box><size>1 0 1</size></box></geometry></collision></link>",
            r"it\.sdf:4: <size>: a size must be above zero",
        ),
        (
            "<link name='l'/><joint name='j' type='fixed'><parent>l</parent><child>no</child></joint>",
            r"it\.sdf:4: .*there is no frame 'no'",
        ),
    ],
)
def test_mistakes_in_sdf_name_file_and_line(tmp_path: Path, text: str, said: str) -> None:
    path = written(tmp_path, "it.sdf", sdf(f"<model name='m'>{text}</model>"))
    with pytest.raises(ConfigError, match=said) as caught:
        world_spec(str(path))
    assert "\n" not in str(caught.value)


def test_entities_are_not_expanded(tmp_path: Path) -> None:
    bomb = "<!DOCTYPE sdf [<!ENTITY a 'aaaaaaaaaa'>" + "".join(
        f"<!ENTITY {chr(98 + n)} '{f'&{chr(97 + n)};' * 10}'>" for n in range(9)
    )
    path = written(
        tmp_path, "it.sdf", bomb + "]><sdf version='1.6'><world name='w'><gravity>&j;</gravity></world></sdf>"
    )
    with pytest.raises(ConfigError):
        world_spec(str(path))


ROOM = (
    "".join(
        f"v {x} {y} {z}\n"
        for x, y, z in ((0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (0, 0, 2), (4, 0, 2), (4, 4, 2), (0, 4, 2))
    )
    + "f 1 2 3 4\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
)
"""A room without a ceiling, whose faces look inwards."""


def test_static_mesh_collides_with_its_surface_and_not_with_its_hull(tmp_path: Path) -> None:
    written(tmp_path, "room.obj", ROOM)
    mesh = "<geometry><mesh><uri>room.obj</uri></mesh></geometry>"
    path = written(
        tmp_path,
        "it.sdf",
        f"""<sdf version="1.6"><world name="w">
        <model name="room"><static>1</static><pose>-2 -2 5 0 0 0</pose><link name="l">
        <collision name="c">{mesh}</collision><visual name="v">{mesh}</visual></link></model>
        <model name="ball"><pose>0 0 6.5 0 0 0</pose><link name="l"><collision name="c">
        <geometry><sphere><radius>0.3</radius></sphere></geometry></collision></link></model></world></sdf>""",
    )
    _, data = settled(path)
    assert data.body("ball/l").xpos[2] == pytest.approx(5.3, abs=0.02)


def test_pieces_of_a_mesh() -> None:
    cube = np.array([(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    faces = np.array(
        [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4)],
        np.int32,
    )
    two = np.concatenate([cube, cube + 3.0])
    pieces = convex_pieces(two, np.concatenate([faces, faces + 8]), 10)
    assert pieces is not None
    assert [len(piece) for piece in pieces] == [8, 8]
    assert convex_pieces(two, np.concatenate([faces, faces + 8]), 1) is None


def test_faces_without_an_area_count_for_nothing() -> None:
    """Many published meshes have some; a slab behind one has no direction."""
    vertices = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 0, 0)], float)
    faces = np.array([(0, 1, 2), (0, 1, 3), (1, 1, 2), (0, 1, 4)], np.int32)
    pieces = convex_pieces(vertices, faces, 10)
    assert pieces is not None
    assert len(pieces) == 2
    assert all(np.isfinite(piece).all() for piece in pieces)
    assert convex_pieces(vertices, faces[2:], 10) == []


# TOML


def image(path: Path) -> Path:
    """A slope up along x, 0..1, which a 16-bit image has."""
    row = np.linspace(0.0, 65535.0, 33).astype(np.uint16)
    Image.fromarray(np.tile(row, (33, 1))).save(path)
    return path


def test_objects_on_a_height_map(tmp_path: Path) -> None:
    image(tmp_path / "hill.png")
    written(tmp_path, "room.obj", ROOM)
    path = written(
        tmp_path,
        "it.toml",
        """
[ground]
height_map = "hill.png"
size = [20.0, 10.0]
height = 2.0
[sun]
elevation = 30.0
shadows = false
[[objects]]
name = "crate"
shape = "box"
size = [0.4, 0.4, 0.4]
pose = [5.0, 0.0, 2.0, 0.0, 0.0, 30.0]
mass = 4.0
friction = 2.0
colour = [1.0, 0.0, 0.0]
[[objects]]
name = "pen"
shape = "mesh"
file = "room.obj"
scale = 0.5
pose = [0, 3, 1]
""",
    )
    model, data = settled(path)
    ground = mujoco.mj_ray(model, data, (0.0, 0.0, 5.0), (0.0, 0.0, -1.0), None, 1, -1, np.zeros(1, np.int32))
    assert ground == pytest.approx(5.0, abs=0.02)  # the middle of the height map is at z = 0
    assert data.body("crate").xpos == pytest.approx((5.0, 0.0, 0.5 + 0.2), abs=0.05)
    assert model.body("crate").mass[0] == pytest.approx(4.0)
    assert model.body("pen").dofnum[0] == 0
    assert tuple(model.geom_rgba[model.body("crate").geomadr[0]]) == (1.0, 0.0, 0.0, 1.0)
    assert not model.light("sun").castshadow[0]


def test_texture_on_a_plane_and_on_a_box(tmp_path: Path) -> None:
    Image.new("RGB", (8, 4), (10, 200, 30)).save(tmp_path / "grass.png")
    path = written(
        tmp_path,
        "it.toml",
        """
[ground]
texture = "grass.png"
texture_size = 3.0
[[objects]]
name = "box"
shape = "box"
size = [1, 1, 1]
texture = "grass.png"
""",
    )
    model, _ = opened(path)
    assert model.geom_matid[model.geom("floor").id] >= 0
    assert sorted(model.tex_type.tolist()) == [0, 1, 2]  # of the plane, of the box, of the sky


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "[[objects]]\nname = 'a'\nshape = 'boks'",
            r"it\.toml: line 3: objects\[0\]\.shape = 'boks': .*'box', 'sphere'",
        ),
        ("[[objects]]\nname = 'a'\nshape = 'box'", r"size: a box needs size"),
        ("[[objects]]\nname = 'a'\nshape = 'sphere'\nradius = 1\nsize = [1, 1, 1]", r"size: a sphere has no size"),
        ("[[objects]]\nname = 'a'\nshape = 'sphere'\nradius = -1", r"objects\[0\]\.radius = -1: .*greater than 0"),
        ("[[objects]]\nname = 'a'\nshape = 'mesh'\nfile = 'no.stl'", r"objects\[0\]: .*no\.stl: cannot be read"),
        ("[[objects]]\nname='a'\nshape='sphere'\nradius=1\npose=[1, 2]", r"pose = \[1, 2\]: write x, y, z in metres"),
        ("[[objects]]\nname='a'\nshape='sphere'\nradius=1\n" * 2, r"objects: a is there twice"),
        ("[ground]\nheight_map = 'no.png'", r"ground: .*no\.png: there is no such file"),
        ("[ground]\nheight_map = 'it.toml'", r"ground: .*it\.toml: is not an image"),
        ("[grund]", r"grund = \{\}: there is no such key; known here are: ground, objects, sky, sun"),
    ],
)
def test_mistakes_in_toml_name_the_key(tmp_path: Path, text: str, said: str) -> None:
    path = written(tmp_path, "it.toml", text)
    with pytest.raises(ConfigError, match=said) as caught:
        world_spec(str(path))
    assert "\n" not in str(caught.value)


# the robot's file


def test_world_of_a_robots_file_is_relative_to_it(tmp_path: Path) -> None:
    path = written(tmp_path, "it.toml", "extends = 'inc1'\nworld = 'worlds/it.sdf'\nmodel_path = ['models']\n")
    config = robot_files.load(path)
    assert (config.world, config.model_path) == (str(tmp_path / "worlds/it.sdf"), (str(tmp_path / "models"),))


def test_meshes_name_textures_in_gazebos_folders(tmp_path: Path) -> None:
    (tmp_path / "materials" / "textures").mkdir(parents=True)
    Image.new("RGB", (4, 4), (200, 0, 0)).save(tmp_path / "materials" / "textures" / "red.png")
    written(tmp_path, "meshes/it.mtl", "newmtl red\nmap_Kd red.png\n")
    obj = "mtllib it.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
    path = written(tmp_path, "meshes/it.obj", obj + "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\n")
    (part,) = read_mesh(path)
    assert part.texture is not None
    assert part.texture.pixels[0, 0].tolist() == [200, 0, 0]
