"""Tasks in CoBRA's format, statics by hand, and a checker that its mutants do not pass."""

from __future__ import annotations

import copy
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from jauspy.cell.design.chains import Element, posture
from jauspy.cell.design.loads import TimedMotion
from jauspy.cell.design.search import Design, Search, check, costs_of, parse_costs
from jauspy.cell.design.tasks import DesignTask, Obstacle, load_task, parse_task
from jauspy.cell.scene import cell_of
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import CellSetup

TASKS = Path(__file__).parents[3] / "docs" / "tasks"
BASE = "platform_1/top"
TUBE_MASS, ELBOW_BODY, ELBOW_OUTPUT = 0.24, 0.335, 0.12


@pytest.fixture(scope="module")
def cell(model: RobotModel) -> CellSetup:
    return cell_of(model)


@pytest.fixture(scope="module")
def task() -> DesignTask:
    return load_task(TASKS / "one_point.json")


@pytest.fixture(scope="module")
def found(cell: CellSetup, task: DesignTask) -> Design:
    search = Search(cell, task, BASE, load=0.2, weights=parse_costs("mass,numJ"), seed=1)
    best = search.run(60, 60.0).best
    assert best is not None
    return best


def test_torque_and_moments_of_a_level_arm_are_those_computed_by_hand(cell: CellSetup) -> None:
    elements = (Element("x5_4_elbow"), Element("tube_short"))
    at = posture(Transform(), elements, cell.types, [math.pi / 2], 1.0)
    moment = GRAVITY * (ELBOW_OUTPUT * 0.065 + TUBE_MASS * (0.075 + 0.075) + 1.0 * (0.075 + 0.15))
    assert at.tip.position == pytest.approx((0.225, 0.0, 0.08))
    assert at.torques() == pytest.approx([moment])
    (force, base), (_, middle), (shear, tip) = at.loads()
    assert force == pytest.approx((0.0, 0.0, GRAVITY * (ELBOW_BODY + ELBOW_OUTPUT + TUBE_MASS + 1.0)))
    assert base == pytest.approx((0.0, -moment, 0.0))
    assert middle == pytest.approx((0.0, -GRAVITY * (TUBE_MASS * 0.075 + 0.15), 0.0))
    assert shear == pytest.approx((-GRAVITY, 0.0, 0.0))  # the tip lies on its side
    assert tip == pytest.approx((0.0, 0.0, 0.0))


def test_costs_are_cobras(cell: CellSetup) -> None:
    costs = costs_of((Element("x5_4_elbow"),), cell.types, [(1.0,), (-0.5,)])
    expected = {"cyc": 2.5 / 3.435, "qDist": 2.5, "mass": ELBOW_BODY + ELBOW_OUTPUT, "numJ": 1.0}
    assert costs == pytest.approx({**expected, "effort": 0.0, "mechEnergy": 0.0})
    moved = [TimedMotion(1.5, 0.1, 0.1, 2.0, 3.0), TimedMotion(0.5, 0.1, 0.1, 1.0, 0.5)]
    costs = costs_of((Element("x5_4_elbow"),), cell.types, [(1.0,), (-0.5,)], moved)
    assert (costs["cyc"], costs["effort"], costs["mechEnergy"]) == (2.0, 3.0, 3.5)


@pytest.mark.slow
def test_the_search_finds_a_chain_that_the_checker_passes_and_again_with_the_same_seed(
    cell: CellSetup, task: DesignTask, found: Design
) -> None:
    assert check(cell, task, BASE, found, load=0.2) == []
    again = Search(cell, task, BASE, load=0.2, weights=parse_costs("mass,numJ"), seed=1).run(60, 60.0).best
    assert again == found


@pytest.mark.slow
def test_the_checker_catches_mutants(cell: CellSetup, task: DesignTask, found: Design) -> None:
    def wrong(task: DesignTask = task, load: float = 0.2, **changes: Any) -> str:
        return "; ".join(check(cell, task, BASE, replace(found, **changes), load=load))

    moved = tuple(tuple(value + 0.1 for value in row) for row in found.positions)
    assert "missed" in wrong(positions=moved)
    assert "do not match the joints" in wrong(positions=tuple(row[:-1] for row in found.positions))
    assert "0 postures" in wrong(positions=())
    assert "0 durations" in wrong(durations=())
    assert "too short" in wrong(durations=tuple(0.3 * seconds for seconds in found.durations))
    assert "in the cell" in wrong(elements=found.elements * 8)
    assert "of the limits" in wrong(load=20.0)
    wall = Obstacle("wall", task.goals[0].pose, (0.1, 0.1, 0.1))
    assert "collision" in wrong(task=replace(task, obstacles=(wall,)))


@pytest.mark.parametrize("path", sorted(TASKS.glob("*.json")), ids=lambda path: path.stem)
def test_the_included_tasks_can_be_read(path: Path) -> None:
    assert load_task(path).name == path.stem


@pytest.mark.parametrize(
    ("keys", "value", "sentence"),
    [
        (("goals",), [], "goals: there must be one at least"),
        (("goals",), [{}] * 101, "100 entries at most"),
        (("goals", 0, "type"), "pause", r"goals\[0\].type: must be at or reach"),
        (("goals", 0, "goalPose", "nominal", 0, 3), math.nan, "must be a number"),
        (("goals", 0, "goalPose", "nominal", 0, 0), 2.0, "is not a homogeneous transform"),
        (("goals", 0, "goalPose", "nominal", 0, 0), -1.0, "is not a homogeneous transform"),
        (("goals", 0, "goalPose", "toleranceProjection"), ["w"], "must be a list of"),
        (("goals", 0, "goalPose", "tolerance", 0), [1.0, -1.0], "above the upper"),
        (("obstacles",), [{"collision": {"type": "mesh", "parameters": {"file": "../../x.stl"}}}], "must be box"),
        (("header",), 3, "header: must be an object"),
    ],
)
def test_a_hostile_task_is_refused_with_its_key(keys: tuple[Any, ...], value: Any, sentence: str) -> None:
    document = json.loads((TASKS / "one_point.json").read_text())
    place = copy.deepcopy(document)
    changed = place
    for key in keys[:-1]:
        place = place[key]
    place[keys[-1]] = value
    with pytest.raises(ConfigError, match=sentence):
        parse_task(changed)


@pytest.mark.parametrize("text", ["weight", "mass_-1", "mass_nan", ""])
def test_unknown_costs_are_refused(text: str) -> None:
    with pytest.raises(ConfigError, match="must be a name of"):
        parse_costs(text)
