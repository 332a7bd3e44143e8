"""Goals on a true map that is made up: they can be reached, and ways to them are the shortest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import pytest

pytest.importorskip("scipy", reason="needs the extra `planning`")

import numpy as np

from jauspy.geometry.poses import PlanarPose
from jauspy.navigation_trials.goals import FAR, NEAR, ROOM, TrueMap
from jauspy.planning.mobility import mobility_of
from jauspy.robot.robot_files import load, robot_model

MOBILITY = mobility_of(robot_model(load("inc1")))
SIDE, CELL = 12.0, 0.1
COUNT = round(SIDE / CELL)
HERE = PlanarPose(-4.0, 0.0, 0.0)


@dataclass
class Ground:
    """Level ground around the origin."""

    heights: Any
    origin: tuple[float, float] = (-SIDE / 2.0, -SIDE / 2.0)
    resolution: float = CELL


def ground() -> Any:
    return np.zeros((COUNT, COUNT), np.float32)


def cells(low: float, high: float) -> slice:
    return slice(round((low + SIDE / 2.0) / CELL), round((high + SIDE / 2.0) / CELL))


def shortest_to(heights: Any, x: float, y: float) -> float:
    found = TrueMap(Ground(heights), MOBILITY).shortest(HERE)
    return float(found[cells(y, y).start, cells(x, x).start])


def test_ways_on_level_ground_go_straight_and_across() -> None:
    assert shortest_to(ground(), 2.0, 0.0) == pytest.approx(6.0, abs=CELL)
    assert shortest_to(ground(), -1.0, 3.0) == pytest.approx(3.0 * math.sqrt(2.0), abs=2 * CELL)


def test_ways_go_around_a_wall_at_half_the_width_of_the_robot() -> None:
    heights = ground()
    heights[cells(-6.0, 2.0), cells(-0.1, 0.1)] = 1.0
    around = math.dist(HERE[:2], (0.0, 2.0)) + math.dist((0.0, 2.0), (4.0, 0.0))
    assert around < shortest_to(heights, 4.0, 0.0) < around + 3.0 * MOBILITY.half_width
    heights[:, cells(-0.1, 0.1)] = 1.0
    assert shortest_to(heights, 4.0, 0.0) == math.inf


def test_a_step_is_climbed_up_with_flippers_and_not_down() -> None:
    up = ground()
    up[:, cells(0.0, 6.0)] = MOBILITY.flipper_step - 0.02
    assert shortest_to(up, 4.0, 0.0) == pytest.approx(8.0, abs=0.3)
    assert shortest_to(-up, 4.0, 0.0) == math.inf


def test_goals_are_drawn_by_the_seed_and_can_be_reached() -> None:
    heights = ground()
    heights[cells(-6.0, 2.0), cells(-0.1, 0.1)] = 1.0
    heights[cells(3.0, 6.0), cells(3.0, 6.0)] = 1.0
    world = TrueMap(Ground(heights), MOBILITY)
    goals = [world.draw_goal(HERE, np.random.default_rng((1, number))) for number in (0, 1, 2, 0)]
    assert None not in goals
    assert goals[0] == goals[3]
    assert len(set(goals)) == 3
    for goal in goals:
        assert goal is not None
        assert NEAR < goal.shortest < FAR
        assert abs(goal.x) > ROOM or goal.y > 2.0
        assert goal.x < 3.0 or goal.y < 3.0
        assert goal.planned is not None
        assert goal.planned == pytest.approx(goal.shortest, rel=0.15)


@pytest.mark.parametrize(("half_width", "is_wide"), [(0.4, False), (0.8, True)])
def test_the_planned_way_turns_the_robot_which_a_corridor_may_be_too_narrow_for(
    half_width: float, is_wide: bool
) -> None:
    heights = ground()
    for side in (cells(half_width, half_width + 0.2), cells(-half_width - 0.2, -half_width)):
        heights[side] = 1.0
    heights[cells(half_width, half_width + 0.2), cells(0.0, 1.0)] = 0.0
    goal = TrueMap(Ground(heights), MOBILITY).goal_at(PlanarPose(-0.3, 0.0, 0.0), 0.5, 3.0)
    assert goal is not None
    assert goal.shortest < 3.6
    assert (goal.planned is not None) is is_wide
    assert goal.planned is None or goal.planned == pytest.approx(goal.shortest, rel=0.05)


def test_without_ground_there_is_no_goal() -> None:
    heights = np.full((COUNT, COUNT), np.nan, np.float32)
    world = TrueMap(Ground(heights), MOBILITY)
    assert world.draw_goal(HERE, np.random.default_rng(1)) is None
    assert world.draw_goal(PlanarPose(90.0, 0.0, 0.0), np.random.default_rng(1)) is None, "it has left the map"
