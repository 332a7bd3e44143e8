"""The report of trials: figures, the table, and the plot, also with texts that are meant to do harm."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from tests.helpers.trial_drives import drive

from jauspy.navigation_trials.report import ROWS, Spread, lines, new_way, plot, reported
from jauspy.navigation_trials.results import Drive, TrialPlan, TrialResults

REASON = "no way was found"
HOSTILE = "\x1b[2J$\\frac{$ <script>alert(1)</script> [red]&amp;\n\u202e"


def results(*drives: Drive, goals: int = 5, worlds: tuple[str, ...] = ("yard",)) -> TrialResults:
    return TrialResults(TrialPlan(worlds, goals, 1), drives)


def test_figures_of_a_world() -> None:
    found = reported(
        results(
            drive(number=0, way=4.0),
            drive(number=1, way=4.4, planning=0.7),
            drive(number=2, way=6.0),
            drive(number=3, way=90.0, error=REASON),
            drive(number=4, way=4.2, contacts={"sofa": 3}),
        )
    )
    (world,) = found.worlds
    assert (world.goals, world.reached, world.touched, world.too_long) == (5, 4, 1, 1)
    assert world.ratio == Spread(1.075, 1.5, 1.5), "of goals that were reached"
    assert world.planning == 0.7
    assert world.cpu == 100.0
    assert world.low < 0.8 < world.high
    assert found.rate == 0.8
    assert [(failure["number"], failure["error"], failure["contacts"]) for failure in found.failures] == [
        (3, REASON, {}),
        (4, "", {"sofa": 3}),
    ]


def test_ways_are_compared_with_those_that_were_planned_on_the_true_map() -> None:
    ways = drive(number=0, way=6.0, planned=4.0), drive(number=1, way=6.0, planned=5.0), drive(number=2, way=6.0)
    (world,) = reported(results(*ways)).worlds
    assert (world.to_planned, world.longer_than_planned) == (Spread(1.35, 1.5, 1.5), 1)
    (older,) = reported(results(drive(way=6.0))).worlds
    assert (older.to_planned, older.longer_than_planned) == (None, 0), "results of before have no such ways"


def test_the_time_to_another_way_has_that_of_the_search() -> None:
    found = reported(
        results(
            drive(number=0, thing="crate", new_way=0.3, new_way_planning=0.15),
            drive(number=1, thing="crate", new_way=0.2, new_way_planning=0.05),
            drive(number=2, thing="crate"),
        )
    )
    (world,) = found.worlds
    assert world.things == 3
    assert world.new_way == Spread(0.35, 0.45, 0.45)
    assert new_way(drive()) is None


def test_a_drive_whose_way_was_closed_is_no_failure_unless_it_touched_something() -> None:
    found = reported(
        results(
            drive(number=0, thing="crate", blocked=True, error=REASON),
            drive(number=1, thing="crate", blocked=True),
            drive(number=2, thing="crate", error=REASON),
            drive(number=3, thing="crate", blocked=True, error=REASON, contacts={"wall": 1}),
            drive(number=4, thing="crate"),
        )
    )
    (world,) = found.worlds
    assert (world.goals, world.reached, world.touched, world.things, world.blocked) == (3, 2, 1, 5, 2)
    assert [failure["number"] for failure in found.failures] == [2, 3]


def test_drives_with_a_map_are_apart(tmp_path: Path) -> None:
    plan = TrialPlan(("yard", "house"), 1, 1, again=True)
    drives = [drive(world, 0, number, way=4.0 + number, known=number > 0) for world in plan.worlds for number in (0, 1)]
    found = TrialResults(plan, tuple(drives))
    report = reported(found)
    assert [(world.world, world.known, world.ratio) for world in report.worlds] == [
        (name, known, Spread(ratio, ratio, ratio))
        for name in plan.worlds
        for known, ratio in ((False, 1.0), (True, 1.25))
    ]
    assert re.split(r"\s{2,}", lines(report)[0].strip()) == ["yard", "yard, known", "house", "house, known"]
    plot(found, report, tmp_path / "plot.svg")
    assert "house, known" in (tmp_path / "plot.svg").read_text()


@pytest.mark.parametrize(
    ("drives", "needs"),
    [
        ([drive(number=number) for number in range(5)], [0.0, 0.8, 0.95, 1.0]),
        ([drive(number=number, error="" if number else REASON) for number in range(5)], [0.0, 0.8]),
        ([drive(number=number, contacts={} if number else {"bin": 1}) for number in range(5)], []),
        ([], []),
    ],
    ids=["all reached", "one not reached", "one touched", "none driven"],
)
def test_enough_goals_are_reached_and_nothing_is_touched(drives: list[Drive], needs: list[float]) -> None:
    found = reported(results(*drives))
    assert [need for need in (0.0, 0.8, 0.95, 1.0) if found.is_good(need)] == needs


def test_the_table_has_a_column_for_each_world_and_a_line_for_each_failure() -> None:
    found = reported(
        results(
            drive("yard", 0, 0, thing="crate", new_way=0.3, new_way_planning=0.15, planned=3.2),
            drive("house", 0, 0, error=REASON, contacts={"door": 2}),
            worlds=("yard", "street", "house"),
            goals=1,
        )
    )
    *table, failure, missing = lines(found)
    heading, *figures = table
    assert heading.split() == ["yard", "house"]
    cells = [re.split(r"\s{2,}", row) for row in figures]
    assert [row[0] for row in cells] == list(ROWS)
    ways = [*3 * ["1.10"], "0", *3 * ["1.38"], "1"]
    assert [row[1] for row in cells] == ["1", "1", "21 to 100", "0", *ways, "0.12", "1", "0", *3 * ["0.45"]]
    assert [row[2] for row in cells[:4]] == ["1", "0", "0 to 79", "1"]
    assert len({len(row) for row in table}) == 1, "columns are below each other"
    assert max(map(len, table)) < 80
    assert failure == "house, group 0, goal 0: (0, 0, 0) to (3, -2): no way was found; touched door in 2 samples"
    assert missing == "not driven: 1 groups of goals"


def test_a_report_is_json() -> None:
    found = reported(results(drive(contacts={"bin": 1}), drive(number=1, error=REASON)))
    values = json.loads(json.dumps(found.values(), allow_nan=False))
    assert values["rate"] == 0.5
    assert values["worlds"][0]["new_way"] is None
    assert values["failures"][0]["contacts"] == {"bin": 1}
    assert json.loads(json.dumps(reported(results()).values(), allow_nan=False))["rate"] == 0.0


def test_the_plot_and_the_table_show_texts_of_strangers_as_text(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")
    found = results(
        drive(HOSTILE, 0, 0, error=HOSTILE, contacts={HOSTILE: 1}),
        *(drive(HOSTILE, 0, number, error=f"{REASON} {number}") for number in range(1, 40)),
        drive(HOSTILE, 1, 0, thing=HOSTILE, new_way=0.3, new_way_planning=0.1),
        worlds=(HOSTILE, "house"),
    )
    path = tmp_path / "new" / "trials.svg"
    plot(found, reported(found), path)
    text = path.read_text()
    assert "<svg" in text
    assert "<script" not in text
    assert "\x1b" not in text
    assert all(line.isprintable() for line in lines(reported(found)))


def test_a_plot_of_nothing(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")
    plot(results(), reported(results()), tmp_path / "trials.svg")
    assert "<svg" in (tmp_path / "trials.svg").read_text()
