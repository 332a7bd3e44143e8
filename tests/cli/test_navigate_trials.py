"""`jauspy navigate-trials`: what it writes and prints, how it ends, and that it continues; without physics."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result
from typer.testing import CliRunner

from jauspy.cli.main import app

pytest.importorskip("scipy", reason="needs the extra `planning`")
pytest.importorskip("mujoco", reason="needs the extra `sim`")
pytest.importorskip("matplotlib", reason="needs the extra `plot`")

from tests.helpers.trial_drives import drive, driven

from jauspy.errors import ConfigError
from jauspy.navigation_trials import groups
from jauspy.navigation_trials.results import Drive, GoalGroup, TrialPlan


def trials(out: Path, *arguments: str) -> Result:
    return CliRunner().invoke(app, ["navigate-trials", "-o", str(out), "--jobs", "1", *arguments])


@pytest.fixture
def done(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, int]]:
    """The groups that are driven, each goal of which is reached."""
    found: list[tuple[str, int]] = []

    def drive_group(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
        found.append((group.world, group.number))
        return driven(plan, group)

    monkeypatch.setattr(groups, "drive_group", drive_group)
    return found


def test_all_goals_reached_is_success(done: list[tuple[str, int]], tmp_path: Path) -> None:
    found = trials(tmp_path / "new", "--goals", "7", "--world", "yard", "--world", "house", "--world", "yard")
    assert found.exit_code == 0, found.output
    assert done == [("yard", 0), ("yard", 1), ("house", 0), ("house", 1)]
    assert [line.split() for line in found.stdout.splitlines()][:3] == [
        *[["yard", "house"], ["goals", "7", "7"], ["reached", "7", "7"]]
    ]
    written = json.loads((tmp_path / "new" / "navigate-trials.json").read_text())
    assert len(written["drives"]) == 14
    assert written["plan"]["worlds"] == ["yard", "house"]
    assert written["report"]["rate"] == 1.0
    assert "<svg" in (tmp_path / "new" / "navigate-trials.svg").read_text()


@pytest.mark.parametrize(
    ("changes", "need", "status"),
    [({"error": "no way"}, "0.8", 0), ({"error": "no way"}, "0.95", 1), ({"contacts": {"sofa": 1}}, "0.0", 1)],
)
def test_too_few_goals_or_a_touch_is_a_failure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any], need: str, status: int
) -> None:
    def drive_group(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
        return [*driven(plan, group)[:-1], drive(group.world, group.number, group.goals - 1, **changes)]

    monkeypatch.setattr(groups, "drive_group", drive_group)
    found = trials(tmp_path, "--goals", "5", "--world", "yard", "--need", need, "--json")
    assert found.exit_code == status, found.output
    (line,) = found.stdout.splitlines()
    report = json.loads(line)
    assert report["rate"] == (0.8 if "error" in changes else 1.0)
    assert report["failures"][0]["number"] == 4


def test_an_interrupted_run_continues(
    done: list[tuple[str, int]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = groups.drive_group

    def interrupted(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
        if group.number == 2:
            raise KeyboardInterrupt
        return whole(plan, group)

    monkeypatch.setattr(groups, "drive_group", interrupted)
    arguments = ("--goals", "20", "--world", "yard")
    assert trials(tmp_path, *arguments).exit_code == 130
    monkeypatch.setattr(groups, "drive_group", whole)
    assert trials(tmp_path, *arguments, "--resume").exit_code == 0
    assert done == [("yard", number) for number in range(4)]
    written = json.loads((tmp_path / "navigate-trials.json").read_text())
    assert trials(tmp_path / "other", *arguments).exit_code == 0
    assert json.loads((tmp_path / "other" / "navigate-trials.json").read_text()) == written


def test_nothing_is_left_to_do(done: list[tuple[str, int]], tmp_path: Path) -> None:
    assert trials(tmp_path, "--goals", "5", "--world", "yard").exit_code == 0
    assert trials(tmp_path, "--goals", "5", "--world", "yard", "--resume").exit_code == 0
    assert done == [("yard", 0)]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--goals", "0"], "--goals"),
        (["--goals", "many"], "--goals"),
        (["--group", "0"], "--group"),
        (["--seed", "-1"], "--seed"),
        (["--need", "1.5"], "--need"),
        (["--jobs", "0"], "--jobs"),
    ],
)
def test_a_wrong_option_is_named(arguments: list[str], sentence: str, tmp_path: Path) -> None:
    found = CliRunner().invoke(app, ["navigate-trials", "-o", str(tmp_path), *arguments])
    assert found.exit_code == 2
    assert sentence in found.output
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "content", ["[]", '{"plan": 3, "drives": "all"}', "\x00", '{"plan": {"worlds": ["\\u001b[2J"]}}']
)
def test_a_file_of_something_else_is_refused_in_one_sentence(
    done: list[tuple[str, int]], tmp_path: Path, content: str
) -> None:
    path = tmp_path / "navigate-trials.json"
    path.write_text(content)
    found = trials(tmp_path, "--resume")
    assert found.exit_code == 2
    assert "is no file of results of `jauspy navigate-trials`" in found.stderr
    assert len(found.stderr.splitlines()) == 1
    assert "\x1b" not in found.stderr
    assert done == []
    assert path.read_text() == content


def test_a_directory_that_cannot_be_written_is_said_before_anything_is_driven(
    done: list[tuple[str, int]], tmp_path: Path
) -> None:
    (tmp_path / "file").touch()
    found = trials(tmp_path / "file" / "below")
    assert found.exit_code == 2
    assert "cannot be written" in found.stderr
    assert done == []


def test_an_error_of_a_world_ends_with_its_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def drive_group(plan: TrialPlan, group: GoalGroup) -> list[Drive]:
        raise ConfigError(f"the world {group.world} has no goal in {plan.goals}")

    monkeypatch.setattr(groups, "drive_group", drive_group)
    found = trials(tmp_path, "--world", "cell")
    assert found.exit_code == 2
    assert found.stderr.splitlines()[-1].endswith("the world cell has no goal in 50")


def test_an_unknown_world_is_refused_with_those_there_are(tmp_path: Path) -> None:
    found = trials(tmp_path, "--world", "moon", "--goals", "1")
    assert found.exit_code == 2
    assert "has no world 'moon'; it has: " in found.stderr


def test_without_dask_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr("jauspy.cluster.import_module", missing)
    found = trials(tmp_path, "--cluster", "local", "--goals", "1", "--world", "yard")
    assert found.exit_code == 2
    assert "pip install 'jauspy[cell-cluster]'" in found.stderr


def test_without_matplotlib_nothing_is_driven(
    done: list[tuple[str, int]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("jauspy.plots.find_spec", lambda _: None)
    found = trials(tmp_path)
    assert found.exit_code == 2
    assert "pip install 'jauspy[plot]'" in found.stderr
    assert done == []
