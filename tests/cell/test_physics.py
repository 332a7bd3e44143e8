"""What the simulation measured of a run: its figures, its tables, and files of results that are read again."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import pytest

from jauspy.cell.measurements import Measured
from jauspy.cell.physics import JointFigures, Meeting, Physics
from jauspy.cell.physics_tables import MOST_ROWS, energy_table, gentle, physics_tables, trials_tables
from jauspy.cell.report import Section, page
from jauspy.cell.trials import read_results
from jauspy.errors import ConfigError

EVIL = "<img src=x onerror=alert(1)>"


@dataclass
class Probe:
    attaches: list[Meeting] = field(default_factory=list)
    landings: list[Meeting] = field(default_factory=list)
    collisions: list[Meeting] = field(default_factory=list)
    joints: dict[str, JointFigures] = field(default_factory=dict)
    peaks: dict[tuple[str, str], Peak] = field(default_factory=dict)
    stops: int = 0


@dataclass
class Peak:
    utilisation: float
    part: str = "servo_1"
    time: float = 3.0
    force: tuple[float, float, float] = (0.0, 3.0, 4.0)
    moment: tuple[float, float, float] = (0.3, 0.4, 0.0)


def physics(*speeds: float, collisions: int = 0, load: float = 0.6, stops: int = 0) -> Physics:
    meetings = [Meeting(1.0, "gripper", "box_1", speed, 10.0) for speed in speeds]
    hits = [Meeting(2.0, EVIL, "bin_1", 0.1, 30.0 + number) for number in range(collisions)]
    peaks = {
        ("platform_1/top", "latch"): Peak(load),
        ("servo_1/output", "latch"): Peak(0.1),
        ("gripper", "gripper"): Peak(0.2),
    }
    joints = {"elbow": JointFigures(3.0, 50.0, 0.002, 0.0005, 7)}
    return Physics.of(Probe(meetings, [], hits, joints, peaks, stops))


def run(seed: int, *speeds: float, **fields: Any) -> Measured:
    return Measured(seed, "lift", success=True, duration=8.0, cpu=1.0, physics=physics(*speeds, **fields))


def test_the_largest_of_each_figure_counts() -> None:
    figures = physics(0.004, 0.012, collisions=2, stops=2).figures()
    assert figures["attach speed"] == 0.012
    assert figures["attachments"] == 2.0
    assert figures["collision force"] == 31.0
    assert figures["stops at contact"] == 2.0
    assert figures["tracking error"] == 0.002
    assert "landing speed" not in figures, "nothing was put down"
    assert (figures["load of the latch"], figures["load of the gripper"]) == (0.6, 0.2)


def test_gentle_runs_keep_their_promises_and_others_say_what_happened() -> None:
    assert all(promise.kept for promise in gentle(run(1, 0.004, 0.02)))
    loaded, hard, touched, stopped = gentle(run(1, 0.004, 0.111, collisions=2, stops=2))
    assert loaded.measured == "platform_1/top (latch) with servo_1: at most 60 % of its strength"
    assert (hard.kept, hard.measured) == (False, "1 of 2, at most 111.0 mm/s and 10 N")
    assert not touched.kept
    assert touched.measured.endswith("on bin_1: 31 N")
    assert stopped.kept, "there were as many contacts"


def test_a_strong_attachment_is_not_gentle() -> None:
    found = run(1, 0.004)
    assert found.physics is not None
    found.physics.attaches.append(Meeting(1.0, "gripper", "box_1", 0.001, 763.0))
    assert [promise.kept for promise in gentle(found)] == [True, False, True, True]


def test_a_stop_without_a_contact_is_a_false_alarm() -> None:
    *_, stopped = gentle(run(1, 0.004, stops=1))
    assert (stopped.kept, stopped.measured) == (False, "1 ended, 0 contacts")


def test_the_energy_of_each_task_has_its_batteries() -> None:
    battery = {"battery energy of car": 7200.0, "battery charge of car": 0.99, "battery voltage of car": 41.8}
    runs = [
        Measured(1, "lift", duration=10.0, values={"energy": 360.0}),
        Measured(1, "car", duration=100.0, values={"energy": 7000.0, **battery}),
        Measured(1, "step", failure="stopped"),
    ]
    table = energy_table(runs)
    assert table is not None
    assert list(table.rows[1:]) == [
        ("lift", "10.0", "0.100", "36.0", "none", "", "", ""),
        ("car", "100.0", "1.944", "70.0", "car", "2.000", "99.0", "41.80"),
    ]
    assert energy_table([Measured(1, EVIL)]) is None
    assert EVIL not in page(
        "t", "l", [], [Section("s", tables=[energy_table([Measured(1, EVIL, values={"energy": 1.0})])])]
    )


def test_an_overloaded_connector_breaks_its_promise() -> None:
    assert [promise.kept for promise in gentle(run(1, 0.004, load=1.02))] == [False, True, True, True]


def test_loads_are_listed_by_connector() -> None:
    (table,) = (table for table in physics_tables(physics(0.004)) if "load of each" in table.caption)
    assert table.rows[1] == ("platform_1/top", "latch", "servo_1", "60", "5.0", "0.50", "3.0")
    assert len(table.rows) == 4


def test_names_of_parts_are_text_on_the_page() -> None:
    found = physics(0.1, collisions=1)
    text = page("t", "l", gentle(Measured(1, EVIL, physics=found)), [Section("s", tables=physics_tables(found))])
    assert "<img" not in text
    assert "&lt;img src=x onerror=alert(1)&gt;" in text


def test_many_runs_have_a_median_a_largest_value_and_its_seed() -> None:
    summary, each = trials_tables([run(1, 0.001), run(2, 0.03), run(3, 0.002), Measured(4, "lift")])
    assert ("attach speed", "0.002 m/s", "0.03 m/s", "2") in summary.rows
    assert [row[0] for row in each.rows] == ["seed", "1", "2", "3"]
    assert each.folded


def test_long_tables_end_and_say_so() -> None:
    tables = physics_tables(physics(*[0.001] * (MOST_ROWS + 5)))
    (attachments,) = (table for table in tables if table.caption.endswith("attachments"))
    assert len(attachments.rows) == MOST_ROWS + 1
    assert attachments.note == "5 more are left out."


def test_results_are_read_as_they_were_written(tmp_path: Path) -> None:
    path = tmp_path / "trials-demo.json"
    runs = [run(2, 0.004, collisions=1), Measured(1, "demo", failure="fell", values={"miss": math.inf})]
    path.write_text(json.dumps([asdict(found) for found in runs]))
    assert read_results(path) == sorted(runs, key=lambda found: found.seed)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("{", "is no file of results"),
        ("[]", "has no results"),
        ('{"seed": 1}', "is no file of results"),
        ('[{"seed": "seven", "task": "demo"}]', "0.seed: Input should be a valid integer"),
        ('[{"seed": 1, "task": "demo", "physics": {"attaches": [1]}}]', "0.physics.attaches.0"),
        ("[" * 10_000, "is no file of results"),
    ],
)
def test_other_files_are_refused_in_a_sentence(tmp_path: Path, text: str, problem: str) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(ConfigError) as error:
        read_results(path)
    assert problem in str(error.value)
    assert str(error.value).startswith(str(path))
    assert "\n" not in str(error.value)


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read"):
        read_results(tmp_path / "none.json")
