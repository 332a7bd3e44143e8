"""Trajectories: checks, files, and the program that is exported."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from jauspy.console.manipulators import JointInfo
from jauspy.console.saved_files import SavedFiles, checked_name
from jauspy.console.trajectory import MAX_ROWS, Trajectory, TrajectoryRow
from jauspy.console.users import LOCAL
from jauspy.errors import ConfigError
from jauspy.ocu.motion_limits import MotionLimits
from jauspy.testing import VirtualNetwork

TURN, ELBOW = "base_link_to_arm_link_1", "arm_link_2_to_arm_link_3"
JOINTS = (
    JointInfo("turn", True, -math.inf, math.inf, MotionLimits(1.0, 2.0, 2.0)),
    JointInfo("lift", False, 0.0, 0.5, MotionLimits(0.1)),
)
NOW = {"turn": 0.0, "lift": 0.1}


def trajectory(*rows: tuple[float, float, float]) -> Trajectory:
    return Trajectory(("turn", "lift"), [TrajectoryRow(seconds, [turn, lift]) for seconds, turn, lift in rows])


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([], "there are no rows: add the present positions first"),
        ([(2.0, 1.0, 0.2), (0.0, 9.0, 0.6)], "row 2: lift can be 0..0.5 m, not 0.6"),
        ([(2.0, 1.0, 0.2), (2.0, 1.0, 0.5)], "row 2: lift needs at least 3.00 s, not 2 s"),
        ([(1.0, 1.0, 0.1)], "row 1: turn needs at least 1.50 s, not 1 s"),
        ([(2.0, 1.0, 0.2), (0.0, 9.0, 0.5), (1.0, 9.0, 0.5)], ""),
    ],
)
def test_what_is_wrong_is_reported_with_the_row(rows: list[tuple[float, float, float]], said: str) -> None:
    assert trajectory(*rows).problem(JOINTS, NOW) == said


def test_a_joint_that_has_gone_is_reported() -> None:
    assert "no joint lift" in trajectory((2.0, 1.0, 0.2)).problem(JOINTS[:1], NOW)


def test_rows_move_and_are_bounded() -> None:
    found = trajectory((1.0, 0.1, 0.0), (2.0, 0.2, 0.0), (3.0, 0.3, 0.0))
    found.move(0, 1)
    found.move(2, 1)
    found.move(0, -1)
    assert [row.seconds for row in found.rows] == [2.0, 1.0, 3.0]
    for _ in range(MAX_ROWS - 3):
        found.add([0.0, 0.0])
    with pytest.raises(ConfigError, match=f"at most {MAX_ROWS}"):
        found.add([0.0, 0.0])


def test_a_file_is_read_as_it_was_written() -> None:
    before = trajectory((1.0, 0.1, 0.05), (0.0, -2.5, 0.4))
    after = Trajectory.from_json(before.to_json("inc1"))
    assert after == before


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "mine.json: the whole: Invalid JSON"),
        ('{"joints": ["a"], "rows": [{"seconds": -1, "positions": [0]}]}', "rows.0.seconds"),
        ('{"joints": ["a"], "rows": [{"seconds": 1, "positions": [1e999]}]}', "rows.0.positions.0"),
        ('{"joints": ["a"], "rows": [{"seconds": 1, "positions": [0, 1]}]}', "row 1 has 2 positions for 1 joints"),
        ('{"joints": ["a", "a"], "rows": []}', "a name is there twice"),
        ('{"joints": [], "rows": []}', "joints"),
        ("9" * 2_000_000, "has more than 1 MiB"),
    ],
)
def test_files_that_cannot_be_read_are_reported(text: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        Trajectory.from_json(text, "mine.json")


@pytest.mark.slow
async def test_the_exported_program_moves_the_arm(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot() as runner, virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        made = Trajectory((TURN, ELBOW), [TrajectoryRow(2.0, [0.4, -2.4]), TrajectoryRow(0.0, [0.2, -2.0])])
        names: dict[str, object] = {"__name__": "exported"}
        exec(compile(made.program(101, "101.1.104", modular=False), "exported.py", "exec"), names)
        await names["play"](robot)  # type: ignore[operator] - a function of that program
        assert runner.snapshot is not None
        there = runner.snapshot.joints["arm"].positions
        assert there[0] == pytest.approx(0.2, abs=0.02)
        assert there[2] == pytest.approx(-2.0, abs=0.02)


def test_the_program_of_a_modular_arm_is_python() -> None:
    text = trajectory((1.0, 0.1, 0.05)).program(201, "201.3.1", modular=True)
    compile(text, "exported.py", "exec")
    assert "arm.follow(" in text


def test_poses_and_trajectories_are_kept_by_robot(tmp_path: Path) -> None:
    kept = saved(tmp_path)
    kept.save_pose("101.1.104", "stow", {"elbow": -0.0})
    kept.save_pose("101.1.104", "up", {"elbow": 1.23456})
    found = saved(tmp_path).poses("101.1.104")
    assert {name: pose.positions for name, pose in found.items()} == {"stow": {"elbow": 0.0}, "up": {"elbow": 1.2346}}
    assert SavedFiles(102, "inc1", LOCAL, print, tmp_path).poses("101.1.104") == {}
    kept.delete_pose("101.1.104", "stow")
    assert list(kept.poses("101.1.104")) == ["up"]
    made = trajectory((1.0, 0.1, 0.05))
    kept.save_trajectory("wave 2", made, "inc1")
    assert kept.trajectories() == ["wave 2"]
    assert kept.trajectory("wave 2") == made
    kept.delete_trajectory("wave 2")
    assert kept.trajectories() == []


def saved(root: Path) -> SavedFiles:
    return SavedFiles(101, "inc1", LOCAL, lambda _: None, root)


@pytest.mark.parametrize("name", ["", "../../etc/passwd", "a/b", ".hidden", "x" * 41, "a\nb"])
def test_names_that_could_be_other_files_are_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="a name is"):
        checked_name(name)
    with pytest.raises(ConfigError, match="a name is"):
        saved(tmp_path).save_trajectory(name, Trajectory(), "inc1")


def test_a_damaged_file_of_poses_is_reported(tmp_path: Path) -> None:
    (tmp_path / "101-inc1").mkdir()
    (tmp_path / "101-inc1" / "poses.json").write_text('{"poses": {"101.1.104": {"stow": {"elbow": "x"}}}}')
    with pytest.raises(ConfigError, match=r"poses\.json: poses.101.1.104.stow.elbow: .*correct or delete"):
        saved(tmp_path).poses("101.1.104")
