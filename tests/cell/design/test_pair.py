"""Two arms on one base: their tasks, the second beside the first, and a whole run in the simulation."""

from __future__ import annotations

import copy
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jauspy.cell.design.chains import LOAD_SIDE, RADIUS, Element, load_height, posture
from jauspy.cell.design.choice import Chooser
from jauspy.cell.design.pair import APART, Pair, build_pairs, with_two_arms
from jauspy.cell.design.search import Design, Neighbour, Search, check, parse_costs
from jauspy.cell.design.surroundings import LOAD, LOAD_ROOM, furnished
from jauspy.cell.design.tasks import DesignTask, load_task, parse_task
from jauspy.cell.scene import cell_of
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files

FILE = Path(__file__).parents[3] / "docs" / "tasks" / "two_arms.json"
BASE = "platform_1"
LEFT = ("x5_9_inline", "x8_9_elbow", "tube_long", "x5_9_elbow")
MASS = 0.2
"""Kilograms at the tip of each arm."""
RIGHT = ("x5_4_inline", "x8_9_elbow", "tube_short", "x5_4_elbow")


@pytest.fixture(scope="module")
def task() -> DesignTask:
    return load_task(FILE)


@pytest.fixture(scope="module")
def paired() -> RobotModel:
    """The cell with a platform for two arms in place of the first one."""
    return robot_files.robot_model(with_two_arms(robot_files.load("cell"), BASE))


def designed(
    model: RobotModel, task: DesignTask, arm: str, types: tuple[str, ...], load: float = 0.0, **given: Any
) -> Design:
    search = Search(
        cell_of(model), task.of(arm), f"{BASE}/{arm}", load=load, weights=parse_costs("mass"), seed=0, **given
    )
    found = search._evaluate(tuple(Element(name) for name in types))
    assert isinstance(found, Design), found
    return found


# --- tasks --------------------------------------------------------------------------------------------------------


def test_goals_name_the_connectors_whose_arms_reach_them(task: DesignTask) -> None:
    assert task.arms == ("left", "right")
    left = task.of("left")
    assert left.name == "two_arms/left"
    assert [goal.name for goal in left.goals] == ["0", "2"]
    assert left.obstacles == task.obstacles


@pytest.mark.parametrize(
    ("arms", "sentence"),
    [
        (["left", None, "left", "right"], "either none has an arm, or each has one of 2"),
        (["left", "left", "left", "left"], "either none has an arm, or each has one of 2"),
        (["left", "right", "middle", "left"], "either none has an arm, or each has one of 2"),
        (["left", 7, "left", "right"], r"goals\[1\].arm: must be the name of a connector"),
        (["left", "x" * 81, "left", "right"], r"goals\[1\].arm: must be the name of a connector"),
        (["left", ["right"], "left", "right"], r"goals\[1\].arm: must be the name of a connector"),
    ],
)
def test_a_task_whose_arms_are_unclear_is_refused(arms: list[Any], sentence: str) -> None:
    document = copy.deepcopy(json.loads(FILE.read_text()))
    for goal, arm in zip(document["goals"], arms, strict=True):
        del goal["arm"]
        if arm is not None:
            goal["arm"] = arm
    with pytest.raises(ConfigError, match=sentence):
        parse_task(document)


def test_an_arm_on_a_connector_that_the_base_does_not_have_is_refused(paired: RobotModel, task: DesignTask) -> None:
    lost = replace(task, goals=tuple(replace(goal, arm="../top") for goal in task.goals))
    chooser = Chooser(paired, parse_costs("mass"), 0, 0.0, 1, 1.0, False, lambda _: None)
    with pytest.raises(ConfigError, match=r"base 'platform_1/\.\./top': must be a connector of a base"):
        chooser.choose(lost, BASE)


# --- the cell -----------------------------------------------------------------------------------------------------


def test_the_cell_gets_a_platform_for_two_and_a_second_arm() -> None:
    config = robot_files.load("cell")
    changed = with_two_arms(config, BASE)
    assert changed.cell is not None
    assert list(changed.cell.type_of(BASE).connectors) == ["left", "right"]
    assert changed.cell.second_arm == "arm_2"
    module = changed.modules[-1]
    assert (module.type, module.part, module.node, module.component) == ("CM-ARM", "arm_2", 3, 2)
    assert with_two_arms(changed, BASE) == changed, "one that has both is not changed"
    with pytest.raises(ConfigError, match="base 'shelf': is not a part of the cell"):
        with_two_arms(config, "shelf")


def test_a_load_lies_ready_for_each_arm(paired: RobotModel, task: DesignTask) -> None:
    cell = furnished(cell_of(paired), [task], BASE, MASS)
    loads = [part for part in cell.parts if part.type == LOAD]
    assert [part.name for part in loads] == ["load", "load_2"]
    first, second = (part.pose for part in loads)
    assert second.y - first.y == pytest.approx(LOAD_SIDE + LOAD_ROOM)
    platform = next(part.pose for part in cell.parts if part.name == "platform_2")
    assert (first.y + second.y) / 2.0 == pytest.approx(platform.y)
    alone = replace(task, goals=tuple(replace(goal, arm="") for goal in task.goals))
    cell = furnished(cell_of(paired), [alone], BASE, MASS)
    assert [part.name for part in cell.parts if part.type == LOAD] == ["load"]


# --- designs ------------------------------------------------------------------------------------------------------


def test_distances_between_chains_are_those_of_their_surfaces(paired: RobotModel) -> None:
    types = cell_of(paired).types
    chain = posture(Transform(), (Element("tube_long"),), types, [])
    beside = np.array([[0.5, 0.0, 0.05]])
    assert chain.clearance_from(beside) == pytest.approx(np.hypot(0.5, 0.01) - 2.0 * RADIUS, abs=0.01)
    assert chain.clearance_from(np.empty((0, 3))) == np.inf
    loaded = posture(Transform(), (Element("tube_long"),), types, [], 1.0)
    above = np.array([[0.0, 0.0, loaded.tip.position[2] + load_height(1.0) + 0.2]])
    assert loaded.clearance_from(above) == pytest.approx(0.2 - 2.0 * RADIUS)
    assert chain.clearance_from(above) == pytest.approx(0.2 + load_height(1.0) - 2.0 * RADIUS)


def test_the_second_arm_has_neither_the_parts_nor_the_place_of_the_first(paired: RobotModel, task: DesignTask) -> None:
    cell = cell_of(paired)
    left = designed(paired, task, "left", LEFT)
    beside = Neighbour.of(cell, f"{BASE}/left", left)
    right = designed(paired, task, "right", RIGHT, beside=beside)
    assert check(cell, task.of("right"), f"{BASE}/right", right, load=0.0, beside=beside) == []
    assert right.clearance > 0.0
    same_parts = replace(right, elements=(Element("x5_9_inline"), *right.elements[1:]))
    wrong = check(cell, task.of("right"), f"{BASE}/right", same_parts, load=0.0, beside=beside)
    assert wrong == ["x5_9_inline: 1 used, 0 in the cell"]
    here = replace(beside, middle_lines=np.array([task.of("right").goals[0].pose.position]))
    wrong = check(cell, task.of("right"), f"{BASE}/right", right, load=0.0, beside=here)
    assert wrong == ["goal 1: collision"]


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.timeout(900)
async def test_two_arms_are_built_beside_each_other_and_carry_loads_to_their_goals(
    paired: RobotModel, task: DesignTask
) -> None:
    cell = cell_of(paired)
    left = designed(paired, task, "left", LEFT, MASS)
    beside = Neighbour.of(cell, f"{BASE}/left", left, MASS)
    right = designed(paired, task, "right", RIGHT, MASS, beside=beside)
    found = await build_pairs([Pair(task, {"left": left, "right": right})], BASE, load=MASS, seed=0)
    assert [one.task for one in found] == ["two_arms/left", "two_arms/right"]
    for one in found:
        values = one.values
        assert one.success, one.failure
        assert one.rows[len(LEFT)]["slot"] == LOAD, "the last part that was joined"
        assert values["goals_reached"] == values["goals"] == 2.0
        assert values["largest_error"] < 2e-3 * 3.0**0.5
        assert values["contacts"] == 0.0
        assert 0.0 < values["clearance"] < 0.5, "the other arm is measured, too"
        assert values["rounds_together"] == values["rounds"] == 2.0
        assert values["planned_apart"] > APART
        assert values["put_down"] == 0.0
    assert {one.rows[len(LEFT)]["part"] for one in found} == {"load", "load_2"}
    assert values["time_of_both"] < sum(one.values["cyc"] for one in found), "with a rest at each goal, too"
