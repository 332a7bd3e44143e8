"""Results of trials: groups that are resumed, in any order, and files of strangers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.trial_drives import drive, driven

from jauspy.errors import ConfigError
from jauspy.navigation_trials.results import TrialPlan, TrialResults, resumed, write_trials

PLAN = TrialPlan(("yard", "house"), 12, 7)


def whole(plan: TrialPlan) -> TrialResults:
    results = TrialResults(plan, ())
    for group in plan.groups():
        results = results.with_drives(driven(plan, group))
    return results


def test_goals_are_divided_into_groups() -> None:
    found = [(group.world, group.number, group.goals) for group in PLAN.groups()]
    assert found == [
        *[("yard", 0, 5), ("yard", 1, 5), ("yard", 2, 2)],
        *[("house", 0, 5), ("house", 1, 5), ("house", 2, 2)],
    ]


def test_results_do_not_depend_on_the_order_in_which_groups_are_done() -> None:
    results = TrialResults(PLAN, ())
    for group in reversed(list(PLAN.groups())):
        results = results.with_drives(driven(PLAN, group))
    assert results == whole(PLAN)
    assert results.missing() == []


def test_an_interrupted_campaign_continues_with_the_groups_that_it_lacks(tmp_path: Path) -> None:
    path, groups = tmp_path / "trials.json", list(PLAN.groups())
    results = TrialResults(PLAN, ())
    for group in (groups[4], groups[1]):
        results = results.with_drives(driven(PLAN, group))
    write_trials(path, results)
    found = resumed(path, PLAN)
    assert found == results
    assert found.missing() == [groups[0], groups[2], groups[3], groups[5]]


def test_a_group_of_which_a_drive_is_missing_is_driven_again(tmp_path: Path) -> None:
    path = tmp_path / "trials.json"
    write_trials(path, TrialResults(PLAN, whole(PLAN).drives[1:]))
    assert [(group.world, group.number) for group in resumed(path, PLAN).missing()] == [("yard", 0)]


def test_results_of_fewer_goals_and_worlds_are_continued(tmp_path: Path) -> None:
    path = tmp_path / "trials.json"
    before = TrialPlan(("house",), 7, 7)
    write_trials(path, whole(before), {"rate": 1.0})
    found = resumed(path, PLAN)
    assert [(drive.world, drive.group, drive.number) for drive in found.drives] == [
        ("house", 0, number) for number in range(5)
    ]
    assert len(found.missing()) == 5, "the second group had two goals, and now has five"


@pytest.mark.parametrize(
    ("other", "reason"),
    [
        (TrialPlan(("yard",), 12, 8), "results of seed 8, not 7; leave out --resume"),
        (TrialPlan(("yard",), 12, 7, moved=True), "results of moved True, not False"),
        (TrialPlan(("yard",), 12, 7, again=True), "results of again True, not False"),
        (TrialPlan(("yard",), 12, 7, blind=True), "results of blind True, not False"),
        (TrialPlan(("yard",), 12, 7, group=3), "results of group 3, not 5"),
        (TrialPlan(("yard",), 13, 7), "results of 13 goals in yard; ask for at least these"),
        (TrialPlan(("street",), 12, 7), "results of 12 goals in street; ask for at least these"),
    ],
)
def test_results_of_other_options_are_refused(tmp_path: Path, other: TrialPlan, reason: str) -> None:
    path = tmp_path / "trials.json"
    write_trials(path, TrialResults(other, ()))
    with pytest.raises(ConfigError) as caught:
        resumed(path, PLAN)
    assert str(caught.value).startswith(f"{path}: has ")
    assert reason in str(caught.value)


def damaged(**changes: Any) -> Any:
    """A file with one drive, of which some values are others."""
    row = json.loads(json.dumps(drive().__dict__))
    return {"plan": {"worlds": ["yard"], "goals": 12, "seed": 7}, "drives": [{**row, **changes}]}


HOSTILE = {
    "a list": [],
    "a number": 7,
    "null": None,
    "no plan": {"drives": []},
    "no drives": {"plan": {"worlds": ["yard"], "goals": 12, "seed": 7}},
    "no worlds": {"plan": {"worlds": [], "goals": 12, "seed": 7}, "drives": []},
    "worlds that are a text": {"plan": {"worlds": "yard", "goals": 12, "seed": 7}, "drives": []},
    "goals without end": {"plan": {"worlds": ["yard"], "goals": 10**12, "seed": 7}, "drives": []},
    "a group of none": {"plan": {"worlds": ["yard"], "goals": 12, "seed": 7, "group": 0}, "drives": []},
    "a truth that is a number": {"plan": {"worlds": ["yard"], "goals": 12, "seed": 7, "moved": 1}, "drives": []},
    "a negative seed": {"plan": {"worlds": ["yard"], "goals": 12, "seed": -1}, "drives": []},
    "a drive that is a list": {"plan": {"worlds": ["yard"], "goals": 12, "seed": 7}, "drives": [[1, 2]]},
    "a goal of three numbers": damaged(goal=[1.0, 2.0, 3.0]),
    "a goal of texts": damaged(goal=["1", "2"]),
    "a goal that is no number": damaged(goal=[float("nan"), 0.0]),
    "a goal at the end of the world": damaged(goal=[1e300, 0.0]),
    "an endless way": damaged(way=float("inf")),
    "a negative way": damaged(way=-1.0),
    "a shortest way of nothing": damaged(shortest=0.0),
    "an error that is a list": damaged(error=["none"]),
    "an error of megabytes": damaged(error="x" * 1_000_000),
    "contacts that are a list": damaged(contacts=["sofa"]),
    "contacts that are texts": damaged(contacts={"sofa": "many"}),
    "a fraction of a group": damaged(group=0.5),
    "a negative number": damaged(number=-1),
    "a number of 400 digits": damaged(number=10**400),
    "a further key": damaged(__class__="os.system"),
}


@pytest.mark.parametrize("content", HOSTILE.values(), ids=HOSTILE)
def test_a_file_with_wrong_values_is_refused_in_one_sentence(tmp_path: Path, content: Any) -> None:
    path = tmp_path / "trials.json"
    path.write_text(json.dumps(content))
    with pytest.raises(ConfigError) as caught:
        resumed(path, PLAN)
    text = str(caught.value)
    assert text.startswith(f"{path}: is no file of results of `jauspy navigate-trials`: ")
    assert "\n" not in text
    assert len(text) < 600


@pytest.mark.parametrize("data", [b"", b"{", b"\xff\xfe", b"[" * 100_000, b'{"plan": ' * 5000])
def test_a_file_that_is_no_json_is_refused_in_one_sentence(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "trials.json"
    path.write_bytes(data)
    with pytest.raises(ConfigError, match=r"is no file of results of `jauspy navigate-trials`: the whole: [^\n]+$"):
        resumed(path, PLAN)


def test_a_drive_that_is_there_twice_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "trials.json"
    write_trials(path, TrialResults(PLAN, (drive(), drive(way=5.0))))
    with pytest.raises(ConfigError, match="it has two drives of one number"):
        resumed(path, PLAN)


def test_a_drive_that_was_not_asked_for_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / "trials.json"
    write_trials(path, TrialResults(PLAN, (drive("moon"), drive("yard", 900), drive("yard", 0, 77))))
    assert resumed(path, PLAN) == TrialResults(PLAN, ())
