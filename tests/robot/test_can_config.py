"""Mistakes in the tables `[can]` and `[can.drives.NAME]`: one sentence with file, key and what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.backends import find
from jauspy.errors import ConfigError
from jauspy.robot.robot_files import load, robot_model

DRIVES = """
left_track = { node = 1, track = "left", encoder_counts = 4096, travel = 0.4 }
right_track = { node = 2, track = "right", encoder_counts = 4096, travel = 0.4 }
"""


def robot_file(folder: Path, can: str) -> Path:
    file = folder / "robot.toml"
    file.write_text(f'extends = "inc1"\nname = "mine"\n{can}')
    return file


@pytest.mark.parametrize(
    ("can", "said"),
    [
        ("[can]\nbus = 'x:y'", r"can\.drives: is missing"),
        ("[can.drives.a]\nnode = 300", r"can\.drives\.a\.node = 300: input should be less than or equal to 127"),
        ("[can.drives.a]\nnode = 1\njoint = 'x'", r"can\.drives\.a\.encoder_counts: is missing"),
        ("[can.drives.a]\nnode = 1\nencoder_counts = 1", "give either the joint that the drive moves or its track"),
        (
            f"[can]\nnode = 2\n[can.drives]\n{DRIVES}",
            r"drives\.right_track\.node = 2: another drive or the robot has it",
        ),
        (f"[can]\nheartbeat = 0.15\n[can.drives]\n{DRIVES}", "must be less than half of heartbeat_timeout"),
    ],
)
def test_mistakes_in_the_tables(tmp_path: Path, can: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said) as caught:
        load(robot_file(tmp_path, can))
    assert "robot.toml" in str(caught.value)


@pytest.mark.parametrize(
    ("drives", "said"),
    [
        (DRIVES, r"can\.drives: no drive moves the joint 'base_link_to_arm_link_1'; add a table"),
        ("a = { node = 1, joint = 'elbow', encoder_counts = 1 }", r"can\.drives\.a\.joint = 'elbow': is in no group"),
        (
            f"{DRIVES}\nb = {{ node = 5, track = 'left', encoder_counts = 1 }}",
            "'left_track' moves the left track already",
        ),
        ("a = { node = 1, track = 'left', encoder_counts = 1 }", r"can\.drives\.a\.travel: is missing; .*prismatic"),
        (
            f"{DRIVES}\nb = {{ node = 5, joint = 'base_link_to_flippers', encoder_counts = 1, eds = 'none.eds' }}",
            r"can\.drives\.b\.eds: .*none\.eds: cannot be read",
        ),
    ],
)
def test_drives_that_do_not_match_the_robot_are_an_error_of_the_backend_only(
    tmp_path: Path, drives: str, said: str
) -> None:
    model = robot_model(load(robot_file(tmp_path, f"[can.drives]\n{drives}")))
    with pytest.raises(ConfigError, match=said):
        find("can").open(model, "empty")


def test_a_robot_without_drives(tmp_path: Path) -> None:
    model = robot_model(load("cell"))
    with pytest.raises(ConfigError, match=r"has no table \[can\] in its file"):
        find("can").open(model, "empty")


def test_a_drive_that_does_not_match_is_reported_with_file_and_line(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(
        'extends = "inc1"\nname = "mine"\n[can.drives.arm_1]\nnode = 4\njoint = "elbow"\nencoder_counts = 4096\n'
    )
    reported = robot_model(load(file)).can
    assert isinstance(reported, str)
    assert reported.startswith(
        f"{file}: line 5: can.drives.arm_1.joint = 'elbow': is in no group; those of groups are: "
    )
