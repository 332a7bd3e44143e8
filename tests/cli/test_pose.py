"""`jauspy pose` beside a robot on the kinematic backend."""

from __future__ import annotations

import json
import math

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread

from jauspy.cli import pose as verb

SHOULDER = "arm_link_1_to_arm_link_2"


@pytest.fixture(scope="module")
def robot():
    """Where a robot listens."""
    with robot_in_thread() as running:
        yield ["--connect", running.local]


def said(run) -> str:
    return " ".join(run.stderr.split())


@pytest.mark.slow
def test_poses_are_listed_and_moved_to(robot):
    run = jauspy("pose", "101", *robot)
    assert run.stdout.splitlines()[0].split() == ["pose", "moves", "in", "it", "now"]
    assert [line.split()[0] for line in run.stdout.splitlines()[1:]] == ["stow", "drive", "reach_low", "inspect"]
    run = jauspy("pose", "101", "drive", *robot)
    assert run.stdout == "101 is in the pose drive\n"
    rows = [json.loads(line) for line in jauspy("pose", "101", "--json", *robot).stdout.splitlines()]
    both = ["101.1.103", "101.1.104"]
    assert [row["held_by"] for row in rows] == [[], both, [], []]
    assert all(row["components"] == both for row in rows)
    run = jauspy("pose", "101.1.104", "inspect", "--json", *robot)
    result = json.loads(run.stdout)
    assert result["pose"] == "inspect"
    assert result["joints"][SHOULDER] == pytest.approx(math.radians(100.0), abs=0.012)
    rows = [json.loads(line) for line in jauspy("pose", "101.1.103", "--json", *robot).stdout.splitlines()]
    assert [row["held_by"] for row in rows] == [[], ["101.1.103"], [], []], "the flippers have not moved"
    status = json.loads(jauspy("query", "101.1.104", "QueryControl", *robot).stdout)["fields"]
    assert status["subsystem_id"] == 0, "control is released"


@pytest.mark.slow
def test_what_cannot_be_is_named(robot):
    run = jauspy("pose", "101", "park\x1b[2J", *robot, status=1)
    assert r"subsystem 101 has no pose 'park\x1b[2J'; its poses are: stow, drive, reach_low, inspect" in said(run)
    assert "\x1b" not in run.stderr
    run = jauspy("pose", "101.1.102", "stow", *robot, status=1)
    assert "101.1.102 has no pose 'stow'; its poses are: none" in said(run)
    for name in ((), ("stow",)):
        run = jauspy("pose", "101.1.99", *name, *robot, status=1)
        assert "subsystem 101 has no component 101.1.99; it has 101.1.102, " in said(run)
    assert "it knows no poses" in said(jauspy("pose", "101.1.102", *robot))
    run = jauspy("pose", "77", "--timeout", "0.5", *robot, status=1)
    assert "77" in said(run)


@pytest.mark.parametrize(
    ("target", "problem"),
    [
        ("101.1.255", "has wildcards; name a robot, as in 101, or one component"),
        ("0", "is not the id of a component"),
        ("70000", "70000"),
        ("inc1", "inc1"),
    ],
)
def test_targets_that_are_none(target, problem):
    run = jauspy("pose", target, status=1)
    assert problem in said(run)


def test_names_of_robots_are_printed_as_text(capsys: pytest.CaptureFixture[str]):
    row = {"pose": "[red]a\x1b[2J\u202eb[/]", "components": ["90.1.5"], "held_by": []}
    verb._print([row], as_json=False)
    verb._print([row], as_json=True)
    table, line = capsys.readouterr().out.rsplit("\n", 2)[0:2]
    assert r"[red]a\x1b[2J\u202eb[/]" in table
    assert "\x1b" not in table + line
    assert json.loads(line) == row
