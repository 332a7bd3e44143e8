"""A file author names files of his victim, whose content the robot would report to clients: they are not read."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

import pytest

from jauspy.errors import ConfigError
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.robot_files import load, robot_model
from jauspy.robot.urdf_files import read_urdf
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.robot.xacro_files import expand

HEAD: Final = '<robot name="it" xmlns:xacro="http://www.ros.org/wiki/xacro">'
SECRET: Final = "s3cr3t"
NO_ROS: Final = PackagePaths((), {})
LENIENT: Final = MissingPolicy(skip_packages=True, placeholder_meshes=True)


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A robot's file in `home/Downloads/robot`, beside secrets in `home`."""
    home = tmp_path / "home"
    folder = home / "Downloads" / "robot"
    folder.mkdir(parents=True)
    (home / ".ssh").mkdir()
    (home / "private").mkdir()
    for place in (home / ".ssh" / "key", home / "private" / "key", home / "key", tmp_path / "key", folder / ".key"):
        place.write_text(f"key: {SECRET}")
        place.with_suffix(".xml").write_text(f'<robot><link name="{SECRET}"/></robot>')
    (folder / "link").symlink_to(home / "private" / "key")
    (folder / "link.xml").symlink_to(home / "private" / "key.xml")
    (folder / "folder").symlink_to(home / "private")
    monkeypatch.setenv("HOME", str(home))
    return folder / "it.urdf.xacro"


PLACES: Final = {
    "absolute": "{home}/private/key",
    "beside": "../../private/key",
    "link": "link",
    "link of a folder": "folder/key",
    "hidden": ".key",
    "hidden in a package that is none": "$(find home)/.ssh/key",
    "a folder above as package": "$(find home)/private/key",
    "a folder beside as package": "$(find private)/key",
    "a hidden folder as package": "$(find .ssh)/key",
    "above": "{home}/../key",
}


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
@pytest.mark.parametrize("has_package_path", [False, True])
@pytest.mark.parametrize(
    "use",
    ["<link name=\"${{xacro.load_yaml('{}')['key']}}\"/>", '<xacro:include filename="{}.xml"/>'],
    ids=["YAML", "XML"],
)
def test_xacro_reads_only_its_own_files(robot: Path, place: str, use: str, has_package_path: bool) -> None:
    paths = PackagePaths((Path.home().parent, Path.home()), {}) if has_package_path else NO_ROS
    name = place.format(home=Path.home())
    robot.write_text(f"{HEAD}{use.format(name)}</robot>")
    with pytest.raises(ConfigError) as caught:
        expand(str(robot), paths)
    assert "is not read, because" in str(caught.value)
    assert SECRET not in str(caught.value)


def test_a_pattern_lists_no_directory_of_others(robot: Path) -> None:
    for pattern in ("../../private/k*.xml", "/*/*/*", "folder/*.xml"):
        robot.write_text(f'{HEAD}<xacro:include filename="{pattern}"/></robot>')
        with pytest.raises(ConfigError, match="is not read, because"):
            expand(str(robot), NO_ROS)


def test_a_pattern_finds_files_of_the_robot(robot: Path) -> None:
    (robot.parent / "parts").mkdir()
    for name in ("a1", "a2", "b1"):
        (robot.parent / "parts" / f"{name}.xml").write_text(f'<robot><link name="{name}"/></robot>')
    robot.write_text(f'{HEAD}<xacro:include filename="parts/a*.xml"/></robot>')
    text = expand(str(robot), NO_ROS)
    assert "a1" in text
    assert "a2" in text
    assert "b1" not in text


@pytest.mark.parametrize("scheme", ["", "file://"])
@pytest.mark.parametrize("tag", ["mesh", "texture"])
def test_meshes_and_textures_are_the_robots_own(robot: Path, tag: str, scheme: str) -> None:
    for name in (f"{scheme}{Path.home()}/private/key", "link", ".key"):
        element = f'<{tag} filename="{name}"/>'
        visual = f"<geometry>{element}</geometry>" if tag == "mesh" else f'<material name="m">{element}</material>'
        robot.write_text(f'<robot name="it"><link name="l"><visual>{visual}</visual></link></robot>')
        with pytest.raises(ConfigError, match=r"is not read, because|: there is no such file"):
            read_urdf(str(robot), NO_ROS)


def test_the_home_directory_is_no_package(robot: Path) -> None:
    """Even if files of the robot were unpacked there."""
    (Path.home() / "package.xml").write_text("<package><name>home</name></package>")
    robot.write_text(f"{HEAD}<link name=\"${{xacro.load_yaml('$(find home)/private/key')['key']}}\"/></robot>")
    with pytest.raises(ConfigError, match="is not read, because"):
        expand(str(robot), NO_ROS)


def test_files_of_the_robot_and_of_packages_are_read(robot: Path, tmp_path: Path) -> None:
    """Also by links, as packages are installed."""
    package = tmp_path / "opt" / "wheels"
    (package / "config").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>wheels</name></package>")
    (package / "config" / "it.yaml").write_text("key: wheel")
    (robot.parent / "own.yaml").write_text("key: own")
    (robot.parent / "linked.yaml").symlink_to(package / "config" / "it.yaml")
    names = ("own.yaml", "linked.yaml", "$(find wheels)/config/it.yaml", str(package / "config" / "it.yaml"))
    links = "".join(f"<link name=\"${{xacro.load_yaml('{name}')['key']}}\"/>" for name in names)
    robot.write_text(f"{HEAD}{links}</robot>")
    text = expand(str(robot), PackagePaths((tmp_path / "opt",), {}))
    assert text.count('name="own"') == 1
    assert text.count('name="wheel"') == 3


def test_an_optional_file_may_be_missing(robot: Path) -> None:
    robot.write_text(f'{HEAD}<xacro:include filename="no.xml" optional="true"/><link name="l"/></robot>')
    assert 'name="l"' in expand(str(robot), NO_ROS)


def test_a_robot_file_is_refused_as_a_whole(robot: Path) -> None:
    robot.write_text(f"{HEAD}<link name=\"${{xacro.load_yaml('{os.devnull}')}}\"/></robot>")
    toml = robot.with_name("it.toml")
    toml.write_text(f'extends = "inc1"\nurdf = "{robot.name}"\npackage_path = ["/", "{Path.home()}"]\n')
    with pytest.raises(ConfigError, match="is not read, because"):
        robot_model(load(toml))


@pytest.mark.parametrize("place", [place for place in PLACES.values() if "find" not in place])
@pytest.mark.parametrize(
    "use",
    [
        '<xacro:include filename="{}.xml"/>',
        "<link name=\"${{xacro.load_yaml('{}')['key']}}\"/>",
        '<link name="l"><visual><geometry><mesh filename="{}"/></geometry></visual></link>',
        '<link name="l"><visual><geometry><mesh filename="file://{}"/></geometry></visual></link>',
    ],
)
def test_a_robot_that_does_without_what_is_missing_reads_no_more(robot: Path, place: str, use: str) -> None:
    robot.write_text(f"{HEAD}{use.format(place.format(home=Path.home()))}</robot>")
    told: list[str] = []
    try:
        text = read_urdf(str(robot), NO_ROS, None, LENIENT, tell=told.append).urdf
    except ConfigError as error:
        text = str(error)
        assert "is not read, because" in text
    else:
        assert use.endswith('file://{}"/></geometry></visual></link>')  # which is relative to no directory
        assert "<box" in text
    assert SECRET not in text + "".join(told)


@pytest.mark.parametrize("rest", ["/../../private/key", "/../../../private/key.xml", "/.key"])
@pytest.mark.parametrize("name", ["nowhere", "..", "../..", ".ssh", "no/where"])
def test_a_missing_package_leads_nowhere(robot: Path, name: str, rest: str) -> None:
    for use in (
        f'<xacro:include filename="$(find {name}){rest}"/>',
        f"<link name=\"${{xacro.load_yaml('$(find {name}){rest}')['key']}}\"/>",
        f'<link name="m"><visual><geometry><mesh filename="$(find {name}){rest}"/></geometry></visual></link>',
    ):
        robot.write_text(f'{HEAD}<link name="l"/>{use}</robot>')
        told: list[str] = []
        try:
            text = read_urdf(str(robot), NO_ROS, None, LENIENT, tell=told.append).urdf
        except ConfigError as error:
            text = str(error)
        assert SECRET not in text + "".join(told)


def test_names_of_missing_files_make_no_lines_of_their_own(robot: Path) -> None:
    meshes = "".join(f'<mesh filename="a{number}&#10;Error: \u202egnp.it&#9;"/>' for number in range(3))
    robot.write_text(f'<robot name="it"><link name="l"><visual><geometry>{meshes}</geometry></visual></link></robot>')
    with pytest.raises(ConfigError) as caught:
        read_urdf(str(robot), NO_ROS)
    lines = str(caught.value).split("\n")
    assert len(lines) == 1 + 3 + 1
    assert all(line.isprintable() for line in lines)
    told: list[str] = []
    read_urdf(str(robot), NO_ROS, None, LENIENT, tell=told.append)
    assert told[0].isprintable()
