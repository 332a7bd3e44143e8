"""`jauspy scene`: what it prints and writes, and what it says about wrong input."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.cli.scene import _lines

REPORT = {
    "robot": "inc1",
    "frame": "base_link",
    "voxel_size": 0.04,
    "voxels": 2419,
    "extent": {"low": (0.8, -2.12, 0.0), "high": (2.92, 1.28, 0.48)},
    "ages": (0.0, 0.1, 12.34),
    "unknown": 4696,
    "primitives": 2,
    "sensors": [{"sensor": "lidar", "frame": "lidar", "used": 27, "latency": 0.0431}],
    "unread_meshes": ["wrist.dae"],
    "not_used": {"malformed cloud": 0, "cloud in an unknown frame": 3},
}


def test_the_lines_name_voxels_sensors_and_what_was_not_used() -> None:
    assert _lines(REPORT) == [
        "inc1: 2419 voxels of 0.04 m in base_link: x 0.80..2.92  y -2.12..1.28  z 0.00..0.48 m",
        "last seen 0.0 to 12.3 s ago, half of them at most 0.1 s",
        "unknown space is forbidden: 4696 voxels at its surface",
        "primitives: 2",
        "lidar                    in lidar                   27 used, seen 43 ms later",
        "not filtered out, as their meshes cannot be read: wrist.dae",
        "not used: 3 cloud in an unknown frame",
    ]
    silent = REPORT | {"voxels": 0, "extent": None, "ages": None, "unknown": None, "primitives": 0, "sensors": []}
    assert _lines(silent)[1].startswith("no sensor measured anything: does the robot publish clouds (--cloud)")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--output", "scene.obj"], "scene.obj: scenes are written as .ply, .json or .png"),
        (["--primitives", "none.toml"], "none.toml: cannot be read"),
        (["--voxel", "0.005"], "there may be 16,000,000"),
    ],
)
def test_wrong_arguments_are_told_before_the_robot_is_looked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(app, ["scene", "101", *arguments])
    assert result.exit_code == 1
    assert said in result.output.replace("\n", " ")
