"""Designs that are built: what stands around them, how they are loaded in motion, and whole runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jauspy.cell.design import build
from jauspy.cell.design.build import build_all
from jauspy.cell.design.chains import Element, placed, posture
from jauspy.cell.design.kinematics import ChainKinematics
from jauspy.cell.design.loads import LoadedChain
from jauspy.cell.design.rehearsal import slots_of, why_not_buildable
from jauspy.cell.design.search import Design, Search, parse_costs
from jauspy.cell.design.surroundings import ASIDE, LOAD, furnished, set_up
from jauspy.cell.design.tasks import DesignTask, Obstacle, load_task
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout, cell_of
from jauspy.cell.session import UNDISTURBED, simulated
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.holding import CUP, LATCH, SAFETY
from jauspy.platform.modular.parts import CellSetup

TASKS = Path(__file__).parents[3] / "docs" / "tasks"
BASE = "platform_1/top"
ELBOW = (Element("x8_9_elbow"), Element("tube_long"))
CHAIN = ("x5_9_inline", "x8_9_elbow", "tube_long", "x5_9_elbow")
"""A chain that the UR10 builds easily: nothing has to be turned where it cannot reach."""


@pytest.fixture(scope="module")
def cell(model: RobotModel) -> CellSetup:
    return cell_of(model)


@pytest.fixture(scope="module")
def wall() -> DesignTask:
    return load_task(TASKS / "over_a_wall.json")


def designed(cell: CellSetup, task: DesignTask, load: float) -> Design:
    search = Search(cell, task, BASE, load=load, weights=parse_costs("mass"), seed=0)
    found = search._evaluate(tuple(Element(name) for name in CHAIN))
    assert isinstance(found, Design)
    return found


def loaded(cell: CellSetup, elements: Sequence[Element], mass: float) -> LoadedChain:
    """A chain on a connector at the world's origin."""
    return LoadedChain.of(Transform(), placed(elements, cell.types), mass, cell.limits)


# --- loads --------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_slow_loads_are_those_at_rest(cell: CellSetup) -> None:
    """A chain on its side: gravity about the elbow, and what its base's latch bears."""
    mass = 1.0
    chain = loaded(cell, ELBOW, mass)
    level = np.array([math.pi / 2.0])
    at_rest = posture(Transform(), ELBOW, cell.types, level.tolist(), mass)
    servo = cell.types["x8_9_elbow"].servo
    assert servo is not None
    found = chain.timed(level, level + 0.001, 60.0)
    down = abs(at_rest.torques()[0]) - servo.friction  # which helps to lower it
    assert found.torque == pytest.approx(down / servo.max_torque, rel=0.01)
    *latched, tip = at_rest.loads()
    assert CUP.utilisation(*tip) < max(LATCH.utilisation(*load) for load in latched)
    assert found.connector == pytest.approx(max(LATCH.utilisation(*load) for load in latched), rel=0.01)


def test_motions_are_slowed_until_modules_and_connectors_bear_them(cell: CellSetup) -> None:
    start, goal = np.array([-1.2]), np.array([1.2])
    light = loaded(cell, ELBOW, 0.0).shortest(start, goal)
    heavy = loaded(cell, ELBOW, 3.6).shortest(start, goal)
    assert light.bearable
    assert heavy.bearable
    assert heavy.duration > light.duration
    with pytest.raises(NoPath, match="of a torque"):
        loaded(cell, ELBOW, 12.0).shortest(start, goal)


def test_the_cup_at_the_tip_bears_the_load_and_its_acceleration(cell: CellSetup) -> None:
    """Turning about the vertical axis, nothing but the load's own lever and speed act."""
    chain = loaded(cell, (Element("x5_1_inline"), Element("bracket_angled")), 0.5)
    still = chain._loads(np.zeros(1), np.zeros(1), np.zeros(1))[1]
    turning = chain._loads(np.zeros(1), np.array([20.0]), np.zeros(1))[1]
    weight = 0.5 * GRAVITY
    assert still == pytest.approx(CUP.utilisation((-weight, 0.0, 0.0), (0.0, 0.0, 0.0)), rel=1e-6)
    pull = 0.5 * 20.0**2 * 0.03  # 30 mm from the axis
    assert turning == pytest.approx(CUP.utilisation((-weight, 0.0, -pull), (0.0, 0.0, 0.0)), rel=1e-6)
    assert SAFETY > 1.0


def test_effort_and_energy_are_cobras(cell: CellSetup) -> None:
    """A light chain that turns about the vertical axis: nothing but friction, damping and inertia of the rotor."""
    elements = (Element("x5_4_inline"), Element("bracket_straight"))
    servo = cell.types["x5_4_inline"].servo
    assert servo is not None
    slow = loaded(cell, elements, 0.0).timed(np.zeros(1), np.ones(1), 20.0)
    assert slow.effort == pytest.approx(servo.friction * 20.0, rel=0.1)
    assert slow.energy == pytest.approx(servo.friction * 1.0 + servo.damping * 1.0 / 20.0, rel=0.05)


# --- surroundings -------------------------------------------------------------------------------------------------


@pytest.mark.slow
async def test_obstacles_stand_in_the_simulation_where_the_task_has_them(wall: DesignTask) -> None:
    post = load_task(TASKS / "beside_a_post.json")
    tasks = [wall, post]

    def change(model: RobotModel) -> RobotModel:
        return replace(model, cell=furnished(cell_of(model), tasks, BASE, 0.3))

    async with simulated(0, UNDISTURBED, change=change) as session:
        truth = session.true._truth
        assert truth.frame("task_1_box_1").position == pytest.approx(wall.obstacles[0].pose.position)
        assert truth.frame("task_2_box_1").position[0] > ASIDE / 2.0
        data, model = session.true._robot.data, session.true._robot.model
        geom = model.geom("task_1_box_1.0").id
        assert 2.0 * model.geom_size[geom] == pytest.approx(wall.obstacles[0].size)
        assert model.body_mass[model.body(LOAD).id] == pytest.approx(0.3)
        set_up(session, tasks, 1)
        await session.cell.sleep(0.1)
        assert truth.frame("task_1_box_1").position[0] > ASIDE / 2.0
        assert data.geom_xpos[model.geom("task_2_box_1.0").id] == pytest.approx(post.obstacles[0].pose.position)
        scene = session.layout.scene()
        assert scene.poses["task_2_box_1"].translation == pytest.approx(post.obstacles[0].pose.position)


# --- building -----------------------------------------------------------------------------------------------------


def test_half_a_turn_of_an_elbow_is_as_good_and_reverses_its_joint(cell: CellSetup) -> None:
    elements = (Element("x5_9_inline"), Element("x8_9_elbow"), Element("tube_long"))
    slots = slots_of(elements, cell.types, 0.3)
    assert [len(slot.turns) for slot in slots] == [4, 2, 4, 4]
    half = [
        (Transform(), cell.types["x5_9_inline"]),
        (Transform(((-1, 0, 0), (0, -1, 0), (0, 0, 1))), cell.types["x8_9_elbow"]),
    ]
    at = posture(Transform(), elements, cell.types, [0.0, 0.0])
    assert build._senses(ChainKinematics(Transform(), half).axes(), at) == pytest.approx([1.0, -1.0])


@pytest.mark.slow
def test_what_cannot_be_built_is_named(model: RobotModel, cell: CellSetup, wall: DesignTask) -> None:
    design = designed(cell, wall, 0.0)
    layout = Layout(replace(model, cell=furnished(cell, [wall], BASE, 0.0)))
    assert why_not_buildable(layout, design, BASE, 0.0) == ""
    none = replace(design, elements=(Element("x5_9_inline"), *design.elements))
    assert why_not_buildable(layout, none, BASE, 0.0) == "joint 2: none is left"
    over = Obstacle("lid", Transform(position=(0.6, 0.22, 0.32)), (0.4, 0.4, 0.02))
    layout = Layout(replace(model, cell=furnished(cell, [replace(wall, obstacles=(over,))], BASE, 0.0)))
    assert why_not_buildable(layout, design, BASE, 0.0).startswith("joint 1: servo_1: ")


@pytest.mark.slow
@pytest.mark.timeout(900)
async def test_a_design_is_built_does_its_task_with_its_load_and_is_taken_apart(
    cell: CellSetup, wall: DesignTask
) -> None:
    (found,) = await build_all([(wall, designed(cell, wall, 0.3))], BASE, load=0.3, seed=0)
    values = found.values
    assert found.success, found.failure
    assert values["goals_reached"] == values["goals"] == 1.0
    assert values["largest_error"] < 2e-3 * math.sqrt(3.0)
    assert values["contacts"] == 0.0
    assert values["clearance"] > 0.005
    assert values["torque"] < 1.0
    assert values["cyc"] > values["designed_cyc"]
    assert values["energy"] > values["energy_in_use"] > 0.0
    assert values["put_down"] == 0.0


@pytest.mark.slow
@pytest.mark.timeout(900)
async def test_a_missed_goal_fails(cell: CellSetup, wall: DesignTask, monkeypatch: pytest.MonkeyPatch) -> None:
    solve = ChainKinematics.solve

    def bent(self: ChainKinematics, *given: Any) -> Any:
        q = solve(self, *given)
        return None if q is None else q + 0.01

    design = designed(cell, wall, 0.0)
    monkeypatch.setattr(ChainKinematics, "solve", bent)
    (found,) = await build_all([(wall, design)], BASE, load=0.0, seed=0)
    assert not found.success
    assert found.failure == "outside of the tolerance: 0"
