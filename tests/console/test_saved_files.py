"""Named poses from a file that an operator gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.console.saved_files import read_poses
from jauspy.errors import ConfigError


def test_poses_of_several_robots_are_read(tmp_path: Path) -> None:
    file = tmp_path / "poses.toml"
    file.write_text('[inc1.stowed]\nelbow = 2\n[inc1."look ahead"]\nturn = 0.3\n[cell.up]\nservo_1 = -0.5\n')
    assert read_poses(file) == {
        "inc1": {"stowed": {"elbow": 2.0}, "look ahead": {"turn": 0.3}},
        "cell": {"up": {"servo_1": -0.5}},
    }


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[inc1]\nelbow = 2.0\n", r"poses.toml: inc1.elbow: expected a table \[ROBOT.POSE\]"),
        ("[inc1.up]\nelbow = nan\n", "poses.toml: inc1.up.elbow: expected a table"),
        ('[inc1."<b>"]\nelbow = 1.0\n', "poses.toml: '<b>': a name is 1 to 40 letters"),
        ("[inc1", "poses.toml: is not TOML"),
    ],
)
def test_a_mistake_is_reported_with_its_place(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "poses.toml"
    file.write_text(text)
    with pytest.raises(ConfigError, match=said):
        read_poses(file)
