"""Named poses in robots' files, and what is said about mistakes in them."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.platform.named_poses import NamedPose
from jauspy.robot.robot_files import load, robot_model

ARM = "\n".join(
    f"{name} = {angle}"
    for name, angle in {
        "base_link_to_arm_link_1": 10.0,
        "arm_link_1_to_arm_link_2": 100.0,
        "arm_link_2_to_arm_link_3": -80.0,
        "arm_link_3_to_arm_link_4": -30.0,
        "arm_link_4_to_arm_link_5": 0,
    }.items()
)
FLIPPERS = "base_link_to_flippers = 45"

Poses = Callable[[str], tuple[NamedPose, ...]]


@pytest.fixture
def poses(tmp_path: Path) -> Poses:
    """The poses of a robot that extends inc1 by this text."""

    def read(text: str) -> tuple[NamedPose, ...]:
        file = tmp_path / "robot.toml"
        file.write_text(f'extends = "inc1"\n{text}\n', encoding="utf-8")
        return robot_model(load(file)).poses

    return read


def test_inc1_has_poses_of_arm_and_flippers() -> None:
    found = robot_model(load("inc1")).poses
    assert [(pose.number, pose.name) for pose in found] == [(1, "stow"), (2, "drive"), (3, "reach_low"), (4, "inspect")]
    assert {len(pose.positions) for pose in found} == {6}


def test_angles_are_in_degrees_and_travels_in_metres(poses: Poses, tmp_path: Path) -> None:
    (pose,) = poses(f'[poses."mine ä"]\n{ARM}')
    assert (pose.number, pose.name) == (1, "mine ä")
    assert pose.positions["arm_link_1_to_arm_link_2"] == pytest.approx(math.radians(100.0))
    assert "base_link_to_flippers" not in pose.positions
    file = tmp_path / "pprm.toml"
    joints = "mast_to_arm_link_1 = 0.2\narm_link_1_to_arm_link_2 = 0.1\n"
    joints += "arm_link_2_to_arm_link_3 = 30\narm_link_3_to_arm_link_4 = 0\n"
    file.write_text(f'extends = "inc1_pprm"\n[poses.up]\n{joints}')
    (pose,) = robot_model(load(file)).poses
    assert list(pose.positions.values()) == pytest.approx([0.2, 0.1, math.radians(30.0), 0.0])


def test_poses_of_joints_that_no_module_moves_are_kept(poses: Poses) -> None:
    """A file may have other modules than the one that it extends."""
    assert len(poses("modules = [{ type = 'CM-MOB', component = 102 }]")) == 4


def test_a_robot_with_other_joints_does_not_inherit_poses(poses: Poses) -> None:
    assert robot_model(load("inc1_pprm")).poses == ()
    assert len(poses("node = 2")) == 4


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (
            "[poses.low]\nelbow = 1.0",
            r"poses\.low: no group has the joint 'elbow'; there are: base_link_to_arm",
        ),
        (
            "[poses.low]\nbase_link_to_arm_link_1 = 1.0",
            r"poses\.low: arm_link_1_to_arm_link_2 of the group arm is missing; give all joints of a group or none",
        ),
        (
            f"[poses.low]\n{ARM.replace('100.0', '170.0')}",
            r"line 4: poses\.low\.arm_link_1_to_arm_link_2 = 170: is out of range; .* from -28\.65 to 166\.2 degrees",
        ),
        (
            f"[poses.low]\n{ARM.replace('100.0', '1.7')}",
            r"poses\.low: .* would be \d+ mm in each other; the boxes around their collision shapes must be 8 mm apart",
        ),
        (
            f"[poses.low]\n{ARM.replace('100.0', '-10').replace('-80.0', '-40')}",
            r"poses\.low: .* would be",
        ),
        (
            "[poses.low]\nbase_link_to_pan_link = 0\npan_link_to_tilt_link = 0",
            r"poses\.low: a CM-VIS moves the group pan_tilt, and only CM-MAN have poses; leave its joints out",
        ),
        (
            f'[poses.low]\n{FLIPPERS[:-2]} "up"',
            r"poses\.low\.base_link_to_flippers = 'up': input should be a valid number",
        ),
        (
            f"[poses.low]\n{FLIPPERS[:-2]} nan",
            r"poses\.low\.base_link_to_flippers = nan: input should be a finite number",
        ),
        (f"[poses.low]\n{FLIPPERS[:-2]} inf", r"base_link_to_flippers = inf: input should be a finite number"),
        ("[poses.low]", r"poses\.low: it names no joint"),
        ("poses = [1]", r"poses = \[1\]: write a table, as in \[poses\]"),
        ("[poses]\nlow = 3", r"poses\.low = 3: write a table, as in \[poses\.low\]"),
        (f'[poses.""]\n{FLIPPERS}', r"poses: the name '' must have 1 to 64 printable characters"),
        (f'[poses."a\\u001b[2J"]\n{FLIPPERS}', r"poses: the name 'a\\x1b\[2J' must have"),
        (f'[poses."a\\nb"]\n{FLIPPERS}', r"poses: the name 'a\\nb' must have"),
        (f'[poses."\\u202estow"]\n{FLIPPERS}', r"poses: the name '\\u202estow' must have"),
        (f'[poses." low"]\n{FLIPPERS}', r"begin and end with none that is blank"),
        (f'[poses."{"x" * 65}"]\n{FLIPPERS}', r"must have 1 to 64 printable characters"),
        (f'[poses."低"]\n{FLIPPERS}', r"JAUS sends names in Latin-1, which has no '低'"),
        ("".join(f"[poses.p{n}]\n{FLIPPERS}\n" for n in range(33)), r"poses: 33 are too many; a robot has up to 32"),
    ],
)
def test_mistakes_are_named(poses: Poses, text: str, problem: str) -> None:
    with pytest.raises(ConfigError, match=problem) as raised:
        poses(text)
    assert str(raised.value).isprintable() or "\n" in str(raised.value)
    assert "\x1b" not in str(raised.value)


def test_markup_in_a_name_is_a_name(poses: Poses) -> None:
    (pose,) = poses(f"[poses.'<img src=x onerror=alert(1)>']\n{FLIPPERS}")
    assert pose.name == "<img src=x onerror=alert(1)>"
