"""Primitives from files, and scenes as files."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.planning.obstacles import Box, Cylinder, Obstacles, Sphere
from jauspy.planning.scene import Scene
from jauspy.planning.scene_files import put_primitives, save_obstacles

TABLE = """
[[boxes]]
name = "table"
position = [1.2, 0.0, 0.7]
rotation = [0.0, 0.0, 90.0]
size = [0.6, 1.2, 0.05]

[[spheres]]
name = "lamp"
frame = "base"
position = [0.0, 0.0, 0.9]
radius = 0.1

[[cylinders]]
name = "post"
position = [2.0, 1.0, 0.5]
radius = 0.05
length = 1.0
"""
SEEN = Obstacles(
    (
        Box(Transform(position=(1.0, 0.0, 0.5)), (0.2, 0.3, 0.4), "crate"),
        Sphere(Transform(), 0.1),
        Cylinder(Transform(), 0.1, 1.0),
    ),
    np.array([[1.0, 0.0, 0.1], [1.04, 0.0, 0.5]]),
    0.04,
)


def write(folder: Path, text: str, name: str = "scene.toml") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def test_primitives_of_a_file_are_in_the_scene(tmp_path: Path) -> None:
    scene = Scene()
    assert put_primitives(scene, write(tmp_path, TABLE)) == 3
    table, lamp, post = scene.obstacles().primitives
    assert isinstance(table, Box)
    assert table.size == (0.6, 1.2, 0.05)
    assert table.pose.apply((1.0, 0.0, 0.0)) == pytest.approx((1.2, 1.0, 0.7))
    assert isinstance(lamp, Sphere)
    assert isinstance(post, Cylinder)
    same = {"spheres": [{"name": "lamp", "position": [1, 2, 3], "radius": 0.5}]}
    put_primitives(scene, write(tmp_path, json.dumps(same), "scene.json"))
    assert [each.pose.position for each in scene.obstacles().primitives if each.name == "lamp"] == [(1, 2, 3)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (TABLE.replace("0.05]", "-1]"), r"boxes\[0\]\.size\[2\] = -1: input should be greater than 0"),
        (TABLE.replace("size =", "sise ="), r"boxes\[0\]\.size: is missing"),
        (TABLE.replace('"base"', '"moon"'), r"spheres\[0\]\.frame = 'moon': input should be 'local' or 'base'"),
        (TABLE.replace("radius = 0.1", "radius = nan"), r"spheres\[0\]\.radius"),
        (TABLE.replace('"lamp"', '"post"'), "'post' is there twice"),
        ("[[boxes", "is not TOML"),
    ],
)
def test_mistakes_in_a_file_are_named(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        put_primitives(Scene(), write(tmp_path, text))


@pytest.mark.parametrize("text", ["[1]", "{", "[" * 100_000])
def test_json_that_is_no_table_is_named(tmp_path: Path, text: str) -> None:
    with pytest.raises(ConfigError, match=r"scene\.json: is not"):
        put_primitives(Scene(), write(tmp_path, text, "scene.json"))


def test_obstacles_are_written_as_json_that_can_be_read_again(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    save_obstacles(SEEN, path, "base_link")
    found = json.loads(path.read_text())
    assert (found["frame"], found["voxel_size"], found["voxels"]) == ("base_link", 0.04, SEEN.voxels.tolist())
    assert found["boxes"] == [
        {"name": "crate", "position": [1.0, 0.0, 0.5], "rotation": [0.0, 0.0, 0.0], "size": [0.2, 0.3, 0.4]}
    ]
    primitives = {kind: found[kind] for kind in ("boxes", "spheres", "cylinders")}
    scene = Scene()
    assert put_primitives(scene, write(tmp_path, json.dumps(primitives), "again.json")) == 3
    assert {each.name for each in scene.obstacles().primitives} == {"crate", "sphere", "cylinder"}


def test_obstacles_are_written_as_ply_and_as_a_picture(tmp_path: Path) -> None:
    save_obstacles(SEEN, tmp_path / "scene.ply", "base_link")
    assert b"comment frame base_link\nelement vertex 2\n" in (tmp_path / "scene.ply").read_bytes()
    with pytest.raises(ConfigError, match=r"\.ply, \.json or \.png"):
        save_obstacles(SEEN, tmp_path / "scene.obj", "base_link")
    with pytest.raises(ConfigError, match="cannot be written"):
        save_obstacles(SEEN, tmp_path / "none" / "scene.json", "base_link")
    if find_spec("matplotlib") is not None:
        save_obstacles(SEEN, tmp_path / "scene.png", "base_link")
        assert (tmp_path / "scene.png").read_bytes().startswith(b"\x89PNG")
