"""`jauspy cell`: what the verbs print and write, with results that are given."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from typer.testing import CliRunner

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("matplotlib", reason="needs the extra `plot`")

from jauspy.cell import swing, tasks, trials
from jauspy.cell.design import build, choice
from jauspy.cell.iso9283 import measurement, page
from jauspy.cell.measurements import Measured
from jauspy.cell.session import Session
from jauspy.cell.story import Stage
from jauspy.cli.main import app

FIGURES = {"score": 12.0, "order_time": 30.0, "build_time": 55.0, "largest_error": 0.001, "most_points": 12.0} | {
    "settled_sooner": 7.4,
    "settled_model": 0.39,
    "settled_pid": 2.87,
    "overshoot_ratio": 0.28,
    "improvement": 450.0,
    "improvement on reports": 1.3,
}
runner = CliRunner()


@pytest.fixture
def given(monkeypatch: pytest.MonkeyPatch) -> dict[str, bool]:
    """Whether each task succeeds; all do at first."""
    succeeds: dict[str, bool] = {}

    def result(task: str, seed: int) -> Measured:
        good = succeeds.get(task, True)
        faster = {"order_time": 20.0} if task == "kitting-arm" else {}
        return Measured(seed, task, good, "" if good else "the box is lost", 10.0, 2.0, FIGURES | faster)

    async def run_one(task: str, seed: int, *_: Any, **__: Any) -> Measured:
        return result(task, seed)

    def run_trials(task: str, seeds: range, *_: Any, **__: Any) -> Iterator[Measured]:
        yield from (result(task, seed) for seed in seeds)

    class Given:
        def __init__(self, task: str) -> None:
            self.task = task

        def measured(self, seed: int) -> Measured:
            return result(self.task, seed)

    async def compare(*_: Any) -> Given:
        return Given("swing")

    async def measure(*_: Any, **__: Any) -> Given:
        return Given("iso9283")

    monkeypatch.setattr(swing, "compare", compare)
    monkeypatch.setattr(swing, "plot_swing", lambda *_: None)
    monkeypatch.setattr(measurement, "measure", measure)
    monkeypatch.setattr(page, "write_report", lambda *_: "iso9283.html")
    monkeypatch.setattr(tasks, "run_one", run_one)
    monkeypatch.setattr(trials, "run_trials", run_trials)
    return succeeds


def test_a_task_that_succeeds(given: dict[str, bool]) -> None:
    found = runner.invoke(app, ["cell", "lift", "--seed", "3"])
    assert found.exit_code == 0
    assert "lift, seed 3" in found.stdout


def test_a_task_that_fails_says_why(given: dict[str, bool]) -> None:
    given["step"] = False
    found = runner.invoke(app, ["cell", "step"])
    assert found.exit_code == 1
    assert "the box is lost" in found.output


@pytest.mark.parametrize("task", ["assemble", "lift", "step", "take-apart", "car", "demo"])
def test_an_incomplete_film_is_said_once(given: dict[str, bool], monkeypatch: pytest.MonkeyPatch, task: str) -> None:
    async def run_one(task: str, seed: int, *_: Any, **__: Any) -> Measured:
        return Measured(seed, task, success=True, film_problem="the film x.mp4 is incomplete")

    monkeypatch.setattr(tasks, "run_one", run_one)
    for more in ([], ["--json"]):
        found = runner.invoke(app, ["cell", task, *more])
        assert found.exit_code == 1
        assert found.output.count("the film x.mp4 is incomplete") == 1


@pytest.mark.slow
def test_trials_need_a_rate(given: dict[str, bool], tmp_path: Path) -> None:
    arguments = ["cell", "trials", "lift", "--seeds", "4", "--out", str(tmp_path)]
    found = runner.invoke(app, arguments)
    assert found.exit_code == 0
    assert "4 of 4" in found.stdout
    assert (tmp_path / "trials-lift.json").exists()
    assert (tmp_path / "trials-lift.svg").exists()
    given["lift"] = False
    assert runner.invoke(app, arguments).exit_code == 1


def test_an_unknown_task_is_named(given: dict[str, bool]) -> None:
    found = runner.invoke(app, ["cell", "trials", "sing"])
    assert found.exit_code == 2
    assert "is not a task" in found.output


def test_kitting_says_from_when_on_building_pays(given: dict[str, bool], tmp_path: Path) -> None:
    found = runner.invoke(app, ["cell", "kitting", "--seeds", "2", "--out", str(tmp_path)])
    assert found.exit_code == 0
    assert "worth it from 6 orders on" in found.stdout, "55 s to build, 10 s saved an order"


@pytest.mark.parametrize(("verb", "file"), [("kpi", "swing.json"), ("iso9283", "iso9283.json")])
def test_measurements(given: dict[str, bool], tmp_path: Path, verb: str, file: str) -> None:
    found = runner.invoke(app, ["cell", verb, "--out", str(tmp_path)])
    assert found.exit_code == 0, found.output
    assert (tmp_path / file).exists()
    given[file.partition(".")[0]] = False
    assert runner.invoke(app, ["cell", verb, "--out", str(tmp_path)]).exit_code == 1


@pytest.mark.slow
def test_everything_once(given: dict[str, bool], tmp_path: Path) -> None:
    arguments = ["cell", "all", "--seeds", "2", "--no-films", "--out", str(tmp_path)]
    found = runner.invoke(app, arguments)
    assert found.exit_code == 0, found.output
    assert "NOT KEPT" not in found.stdout
    page = (tmp_path / "index.html").read_text()
    assert "not kept" not in page
    assert "worth it from 6 orders on" in page
    assert "7.4 times sooner (0.39 s, not 2.87 s), 0.28 of the overshoot" in page
    assert ">1 mm<" in page, "figures have units"
    assert "https://" not in page.replace("http://www.w3.org", ""), "it opens without a network"
    given["car"] = False
    found = runner.invoke(app, arguments)
    assert found.exit_code == 1
    assert "NOT KEPT" in found.stdout


@pytest.mark.slow
def test_stories_that_were_run_before_are_on_the_page(given: dict[str, bool], tmp_path: Path) -> None:
    evil = "<script>alert(1)</script>"
    stories = [Measured(seed, "demo", success=seed > 0, failure="" if seed else evil) for seed in range(20)]
    (tmp_path / "trials-demo.json").write_text(json.dumps([asdict(story) for story in stories]))
    arguments = ["cell", "all", "--seeds", "2", "--no-films", "--out", str(tmp_path)]
    assert runner.invoke(app, arguments).exit_code == 0
    page = (tmp_path / "index.html").read_text()
    assert "20 whole stories" in page
    assert "19 of 20" in page
    assert "<script" not in page
    assert "&lt;script&gt;" in page
    (tmp_path / "trials-demo.json").write_text("{}")
    found = runner.invoke(app, arguments)
    assert found.exit_code == 1
    assert "is no file of results" in " ".join(found.output.split())


@pytest.fixture
def story(monkeypatch: pytest.MonkeyPatch) -> list[Stage]:
    """The stages of `demo`, which may be changed; they run without a cell."""
    stages = [stage("assemble", "The UR10 builds an arm"), stage("car", "The car drives off")]
    monkeypatch.setattr(tasks, "STAGES", stages)

    async def run_one(task: str, seed: int, *_: Any, run: Any, **__: Any) -> Measured:
        session: Any = SimpleNamespace(judge=None, cell=SimpleNamespace(now=lambda: 0.0))
        return await run(session, seed)

    monkeypatch.setattr(tasks, "run_one", run_one)
    return stages


def stage(name: str, title: str, failure: str = "") -> Stage:
    async def run(_session: Session, seed: int) -> Measured:
        return Measured(seed, name, not failure, failure, 12.0, values={"clearance": 0.004})

    return Stage(name, title, run)


def test_a_story_is_printed_as_it_goes(story: list[Stage]) -> None:
    found = runner.invoke(app, ["cell", "demo", "--seed", "3"])
    assert found.exit_code == 0, found.output
    lines = [line.strip() for line in found.output.splitlines()]
    assert lines.index("The UR10 builds an arm …") < lines.index("assemble: done in 12.0 s; clearance 4 mm")
    assert "the whole story succeeded: 0.0 s of the cell's time" in lines


def test_a_stage_that_fails_is_named(story: list[Stage]) -> None:
    story[1] = stage("car", "The car drives off", "it stands still")
    found = runner.invoke(app, ["cell", "demo"])
    assert found.exit_code == 1
    assert "car: FAILED (it stands still) in 12.0 s; clearance 4 mm" in found.output
    assert "demo: car: it stands still" in found.output


def test_a_story_as_json_is_json_alone(story: list[Stage]) -> None:
    found = runner.invoke(app, ["cell", "demo", "--json"])
    assert found.exit_code == 0
    assert json.loads(found.stdout)["values"] == {"assemble.clearance": 0.004, "car.clearance": 0.004, "stages": 2.0}


def test_what_was_put_in_place_is_printed(given: dict[str, bool], monkeypatch: pytest.MonkeyPatch) -> None:
    async def run_one(task: str, seed: int, *_: Any, **__: Any) -> Measured:
        return Measured(seed, task, success=True, written=("servo_1", "bracket_1"))

    monkeypatch.setattr(tasks, "run_one", run_one)
    found = runner.invoke(app, ["cell", "lift"])
    assert "put in place by writing positions" in found.stdout
    assert "servo_1, bracket_1" in found.stdout


@pytest.mark.parametrize("task", ["assemble", "lift", "step", "take-apart", "car", "demo"])
def test_films_and_windows_are_of_cells_that_are_simulated_here(given: dict[str, bool], task: str) -> None:
    found = runner.invoke(app, ["cell", task, "--connect", "127.0.0.1:3990", "--view"])
    assert found.exit_code == 2
    assert "leave out --connect" in found.output


def test_films_of_designs_need_something_built(tmp_path: Path) -> None:
    task = Path(__file__).parents[2] / "docs" / "tasks" / "one_point.json"
    result = runner.invoke(app, ["cell", "design", str(task), "--record", str(tmp_path / "film.mp4")])
    assert result.exit_code == 2
    assert "add --build" in result.output + result.stderr


@pytest.mark.slow
def test_a_design_is_built_and_compared_with_what_was_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    async def build_all(designs: Any, base: str, robot: str, **given: Any) -> list[Measured]:
        asked.extend([task.name for task, _ in designs] + [base, robot, str(given["load"])])
        failed = Measured(0, designs[-1][0].name, failure="not built: joint 1")
        figures = dict.fromkeys(("cyc", "designed_cyc", "numJ", "mass", "energy_in_use", "largest_error"), 1.0)
        figures |= dict.fromkeys(("goals_reached", "goals", "clearance", "build_time"), 1.0)
        return [Measured(0, designs[0][0].name, success=True, values=figures), failed]

    monkeypatch.setattr(build, "build_all", build_all)
    monkeypatch.setattr(choice, "first_buildable", lambda layout, found, *rest, before: found.best)
    tasks = Path(__file__).parents[2] / "docs" / "tasks"
    names = ("one_point", "far")
    files = [str(tasks / f"{name}.json") for name in names]
    out = tmp_path / "designs.json"
    result = runner.invoke(
        app, ["cell", "design", *files, "--build", "--load", "0.2", "--candidates", "40", "-o", str(out)]
    )
    assert asked == [*names, "platform_1/top", "cell", "0.2"]
    assert result.exit_code == 1, "the second was not built"
    written = json.loads(out.read_text())
    assert [found["task"] for found in written] == list(names)
    assert [found["built"]["success"] for found in written] == [True, False]
    assert "not built: joint 1" in result.output
    assert "1 of 1" in result.output
