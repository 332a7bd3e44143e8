"""A URDF names packages, includes and meshes that are not installed: all are listed, or left out and replaced."""

from __future__ import annotations

import logging
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import RobotDescription
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.robot_files import load, robot_model
from jauspy.robot.urdf_files import STRICT, expand_urdf, read_urdf
from jauspy.robot.urdf_paths import PackagePaths

HEAD = '<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
BODY = """
<xacro:include filename="$(find lidar_description)/lidar.xacro"/>
<xacro:include filename="$(find rover)/urdf/mount.xacro"/>
<link name="base"><visual><geometry><mesh filename="package://rover/meshes/base.stl"/></geometry></visual>
<collision><geometry><mesh filename="package://camera/lens.dae" scale="2 2 2"/></geometry></collision></link>
<xacro:mount name="mast"/>
<xacro:lidar parent="mast"/>
<joint name="lidar_to_cap" type="fixed"><parent link="lidar_link"/><child link="cap"/></joint>
<link name="cap"/>
<link name="cover"/>
<joint name="cap_to_cover" type="fixed"><parent link="cap"/><child link="cover"/></joint>
<joint name="base_to_lidar" type="fixed"><parent link="base"/><child link="lidar_link"/></joint>
"""
MOUNT = """
<xacro:include filename="no_such_file.xacro"/>
<xacro:include filename="$(find optional_things)/it.xacro"/>
<xacro:macro name="mount" params="name"><link name="${name}">
<visual><geometry><mesh filename="file://$(find mount_description)/plate.stl"/></geometry>
<material name="m"><texture filename="wood.png"/></material></visual></link>
<joint name="base_to_${name}" type="fixed"><parent link="base"/><child link="${name}"/></joint></xacro:macro>
"""
SKIP, BOXES = MissingPolicy(skip_packages=True), MissingPolicy(placeholder_meshes=True)
BOTH = MissingPolicy(skip_packages=True, placeholder_meshes=True)


Read = Callable[..., RobotDescription]


@pytest.fixture
def urdf(tmp_path: Path) -> Path:
    """A rover whose lidar, camera, and some files are missing."""
    folder = tmp_path / "rover" / "urdf"
    folder.mkdir(parents=True)
    (tmp_path / "rover" / "package.xml").write_text("<package><name>rover</name></package>")
    (folder / "mount.xacro").write_text(f"{HEAD}{MOUNT}</robot>")
    (folder / "rover.urdf.xacro").write_text(f"{HEAD}{BODY}</robot>")
    return folder / "rover.urdf.xacro"


def read(urdf: Path, policy: MissingPolicy = STRICT, told: list[str] | None = None) -> RobotDescription:
    told = [] if told is None else told
    return read_urdf(str(urdf), PackagePaths((), {}), None, policy, tell=told.append)


def refusal(urdf: Path, policy: MissingPolicy = STRICT) -> list[str]:
    """The lines of the error."""
    with pytest.raises(ConfigError) as caught:
        read(urdf, policy)
    return str(caught.value).split("\n")


def test_everything_that_is_missing_is_listed_at_once_with_its_place(urdf: Path) -> None:
    base = urdf.parents[1] / "meshes" / "base.stl"
    first, *lines = refusal(urdf)
    *parts, packages, hint = map(str.strip, lines)
    assert first == f"urdf: {urdf}: 7 parts are missing:"
    assert parts == [
        "rover.urdf.xacro:3: <xacro:include>: package://lidar_description/lidar.xacro",
        f"mount.xacro:3: <xacro:include>: {urdf.parent}/no_such_file.xacro: there is no such file",
        "mount.xacro:4: <xacro:include>: package://optional_things/it.xacro",
        f"rover.urdf.xacro:5: <mesh>: package://rover/meshes/base.stl: there is no such file ({base})",
        "rover.urdf.xacro:6: <mesh>: package://camera/lens.dae",
        "mount.xacro:6: <mesh>: package://mount_description/plate.stl",
        f"mount.xacro:7: <texture>: wood.png: there is no such file ({urdf.parent}/wood.png)",
    ]
    assert packages.startswith(
        "packages that are not found: lidar_description, optional_things, camera, mount_description; package_path in"
    )
    assert "--skip-missing-packages (skip_missing_packages = true) leaves out what needs them" in hint
    assert "--placeholder-meshes (placeholder_meshes = true) puts a box of 0.1 m in place of each mesh" in hint


def test_one_option_leaves_the_errors_of_the_other(urdf: Path) -> None:
    first, *_, hint = refusal(urdf, SKIP)
    assert first.endswith("4 parts are missing:")
    assert "--skip-missing-packages" not in hint
    first, *_, hint = refusal(urdf, BOXES)
    assert first.endswith("3 parts are missing:")
    assert "--placeholder-meshes" not in hint


def test_what_is_missing_is_left_out_with_all_that_needs_it(urdf: Path) -> None:
    told: list[str] = []
    rover = read(urdf, BOTH, told)
    assert rover.links() == {"base", "mast"}
    assert set(rover.joints) == {"base_to_mast"}
    assert told == [
        f"{urdf.name}: {text}"
        for text in (
            "packages that are not found: lidar_description, optional_things, mount_description, camera",
            (
                "left out includes: package://lidar_description/lidar.xacro (rover.urdf.xacro:3), no_such_file.xacro "
                "(mount.xacro:3), package://optional_things/it.xacro (mount.xacro:4)"
            ),
            "left out macros: lidar (rover.urdf.xacro:8)",
            "left out joints: lidar_to_cap, base_to_lidar, cap_to_cover",
            "left out links: cap, cover",
            (
                "missing, and replaced by a box of 0.1 m (a texture by none): package://rover/meshes/base.stl "
                "(rover.urdf.xacro:5), package://camera/lens.dae (rover.urdf.xacro:6), "
                "package://mount_description/plate.stl (mount.xacro:6), wood.png (mount.xacro:7)"
            ),
        )
    ]


def test_long_lists_are_told_in_lines_of_the_log(tmp_path: Path) -> None:
    path = tmp_path / "it.urdf"
    meshes = "".join(f'<mesh filename="{"x" * 100}{number}.stl"/>' for number in range(100))
    path.write_text(f'<robot name="it"><link name="a"><visual><geometry>{meshes}</geometry></visual></link></robot>')
    told: list[str] = []
    read(path, BOXES, told)
    assert all(len(line) < 1000 for line in told)
    assert "x49.stl" in told[-1]
    assert told[-1].endswith(", and more")


def test_a_box_takes_the_place_of_each_missing_mesh(urdf: Path) -> None:
    (urdf.parents[1] / "meshes").mkdir()
    (urdf.parents[1] / "meshes" / "base.stl").touch()
    text = read(urdf, BOTH).urdf
    assert text.count('<box size="0.1 0.1 0.1"') == 2
    assert f'<mesh filename="{urdf.parents[1]}/meshes/base.stl"' in text
    assert "texture" not in text


def test_what_is_installed_later_is_used(urdf: Path, tmp_path: Path) -> None:
    lidar = tmp_path / "lidar_description"
    lidar.mkdir()
    (lidar / "package.xml").write_text("<package><name>lidar_description</name></package>")
    (lidar / "lidar.xacro").write_text(
        f'{HEAD}<xacro:macro name="lidar" params="parent"><link name="lidar_link"/></xacro:macro></robot>'
    )
    assert read(urdf, BOTH).links() == {"base", "mast", "lidar_link", "cap", "cover"}


def test_nothing_is_left_out_where_nothing_is_missing(tmp_path: Path) -> None:
    """A loose link is a mistake then, and an unknown macro, too."""
    path = tmp_path / "it.xacro"
    path.write_text(f'{HEAD}<link name="a"/><link name="b"/></robot>')
    assert "must have one root link; it has: a, b" in refusal(path, BOTH)[0]
    path.write_text(f'{HEAD}<link name="a"/><xacro:nobody/></robot>')
    assert "it.xacro:2: unknown macro name: xacro:nobody" in refusal(path, BOTH)[0]


@pytest.mark.parametrize(
    ("element", "said"),
    [
        (
            '<xacro:include filename="$(find lidar)/it.xacro"/>',
            r"xacro cannot expand it: it.xacro:2: <xacro:include>: the package 'lidar' is not found; package_path in",
        ),
        (
            '<xacro:include filename="lidar.xacro"/>',
            r"it.xacro:2: <xacro:include>: .*lidar.xacro: there is no such file",
        ),
        ("<gazebo><p>$(find lidar)/it.yaml</p></gazebo>", r"it.xacro:2: <p>: the package 'lidar' is not found"),
        ("<xacro:if value=\"${'$(find lidar)' == ''}\"/>", r"\$\(find lidar\): the package 'lidar' is not found"),
        ("${xacro.load_yaml('$(find lidar)/it.yaml')}", r"the package 'lidar' is not found; package_path in"),
    ],
    ids=["package", "file", "text", "condition", "YAML"],
)
def test_one_missing_part_is_one_sentence(tmp_path: Path, element: str, said: str) -> None:
    path = tmp_path / "it.xacro"
    path.write_text(f'{HEAD}{element}<link name="a"/></robot>')
    with pytest.raises(ConfigError, match=said):
        read(path)


def test_texts_that_name_missing_packages_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "it.xacro"
    path.write_text(f'{HEAD}<gazebo><p>$(find lidar)/it.yaml</p></gazebo><link name="a"/></robot>')
    told: list[str] = []
    assert "<p" in read(path, SKIP, told).urdf
    assert told == ["it.xacro: packages that are not found: lidar"]


def test_where_reading_stops_is_said(tmp_path: Path) -> None:
    """What a missing file defines may be used elsewhere."""
    path = tmp_path / "it.xacro"
    path.write_text(f'{HEAD}<xacro:include filename="$(find lidar)/it.xacro"/>\n<link name="${{height}}"/></robot>')
    _, include, stop, *_ = refusal(path)
    assert "it.xacro:2: <xacro:include>: package://lidar/it.xacro" in include
    assert "perhaps more, since it could be read to here only: it.xacro:3: 'height' is not defined" in stop
    first, _, left_out = refusal(path, SKIP)
    assert "'height' is not defined" in first
    assert left_out.strip() == "it.xacro: left out includes: package://lidar/it.xacro (it.xacro:2)"


def test_macros_by_name_and_in_namespaces(tmp_path: Path) -> None:
    path = tmp_path / "it.xacro"
    path.write_text(
        f'{HEAD}<xacro:include filename="none.xacro" ns="parts"/><xacro:call macro="lidar"/><xacro:parts.lidar/>'
        '<link name="a"/></robot>'
    )
    told: list[str] = []
    read(path, SKIP, told)
    assert told == [
        "it.xacro: left out includes: none.xacro (it.xacro:2)",
        "it.xacro: left out macros: lidar (it.xacro:2), parts.lidar (it.xacro:2)",
    ]


def test_the_choice_is_in_the_robots_file(urdf: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    path = tmp_path / "rover.toml"
    text = 'name = "rover"\nurdf = "rover/urdf/rover.urdf.xacro"\nsubsystem = 7\nnode = 1\n'
    text += '[[modules]]\ntype = "CM-SEN"\ncomponent = 102\n'
    path.write_text(text)
    with pytest.raises(ConfigError, match="7 parts are missing"):
        robot_model(load(path))
    path.write_text(f"skip_missing_packages = true\nplaceholder_meshes = true\n{text}")
    with caplog.at_level(logging.WARNING):
        assert robot_model(load(path)).description.links() == {"base", "mast"}
    assert {record.levelname for record in caplog.records} == {"WARNING"}
    assert "rover.urdf.xacro: left out macros: lidar (rover.urdf.xacro:8)" in caplog.messages


def test_expanded_urdf(urdf: Path, tmp_path: Path) -> None:
    (urdf.parent / "own.xacro").write_text(
        f'{HEAD}<link name="a"><visual><geometry><mesh filename="../meshes/ä.stl"/></geometry></visual></link></robot>'
    )
    own = expand_urdf(str(urdf.parent / "own.xacro"), PackagePaths((), {}), {}, STRICT, tmp_path)
    assert b'<mesh filename="rover/meshes/&#228;.stl"/>' in own
    assert b"jauspy" not in own
    with pytest.raises(ConfigError, match="3 parts are missing"):
        expand_urdf(str(urdf), PackagePaths((), {}), {}, STRICT, tmp_path)
    text = expand_urdf(str(urdf), PackagePaths((), {}), {}, SKIP, tmp_path, tell=lambda _: None).decode()
    assert '<mesh filename="package://rover/meshes/base.stl"/>' in text
    assert "xacro" not in text
    text = expand_urdf(str(urdf), PackagePaths((), {}), {}, BOTH, tmp_path, tell=lambda _: None).decode()
    assert text.count('<box size="0.1 0.1 0.1"/>') == 3
