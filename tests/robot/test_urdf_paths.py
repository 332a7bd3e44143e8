"""Finding the files that a URDF names."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.robot.urdf_paths import PackagePaths


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    """The URDF of a package `arm_description`, whose directory has another name, beside the package `tools`."""
    for folder, name in (("arm", "arm_description"), ("tools", "tools")):
        (tmp_path / "ws" / folder / "meshes").mkdir(parents=True)
        (tmp_path / "ws" / folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
        (tmp_path / "ws" / folder / "meshes" / "it.stl").write_text(name)
    urdf = tmp_path / "ws" / "arm" / "urdf" / "arm.urdf"
    urdf.parent.mkdir()
    urdf.touch()
    return urdf


NO_ROS = PackagePaths((), {})


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("../meshes/it.stl", "arm_description"),
        ("package://arm_description/meshes/it.stl", "arm_description"),
        ("package://tools/meshes/it.stl", "tools"),
        ("file://{}/tools/meshes/it.stl", "tools"),
        ("file:///{}/tools/meshes/it.stl", "tools"),
        ("{}/tools/meshes/it.stl", "tools"),
    ],
)
def test_relative_absolute_and_package_paths(arm: Path, name: str, content: str) -> None:
    found = NO_ROS.file(name.format(arm.parents[2]), arm)
    assert found.read_text() == content


@pytest.mark.parametrize("variable", ["given", "ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"])
def test_packages_are_searched_in_the_given_paths_and_those_of_ros(arm: Path, tmp_path: Path, variable: str) -> None:
    place = tmp_path / "opt" / ("share" if variable == "AMENT_PREFIX_PATH" else "src")
    wheels = place / "group" / "wheels"
    wheels.mkdir(parents=True)
    (wheels / "package.xml").write_text("<package><name>wheels</name></package>")
    (wheels / "wheel.obj").touch()
    root = place.parent if variable == "AMENT_PREFIX_PATH" else place
    paths = PackagePaths((place,), {}) if variable == "given" else PackagePaths((), {variable: f"/none:{root}"})
    assert paths.file("package://wheels/wheel.obj", arm) == wheels / "wheel.obj"


def test_an_installed_package_may_be_links_to_its_sources(arm: Path, tmp_path: Path) -> None:
    """As `colcon build --symlink-install` makes them."""
    share = tmp_path / "install" / "share" / "wheels"
    share.mkdir(parents=True)
    (share / "package.xml").symlink_to(arm.parents[1] / "package.xml")
    (share / "meshes").symlink_to(arm.parents[1] / "meshes")
    found = PackagePaths((), {"AMENT_PREFIX_PATH": str(share.parents[1])}).file("package://wheels/meshes/it.stl", arm)
    assert found.read_text() == "arm_description"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("it.stl", r"it\.stl: there is no such file"),
        ("package://tools/meshes/no.stl", r"package://tools/meshes/no\.stl: there is no such file"),
        ("package://nowhere/it.stl", "package 'nowhere' is not found; package_path"),
        ("package://tools/../arm/meshes/it.stl", "leads out of the package 'tools'"),
        ("http://host/it.stl", "http:// is not read"),
    ],
)
def test_what_is_not_found_is_named(arm: Path, name: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        NO_ROS.file(name, arm)
