"""Routes of joints on which links do not touch."""

from __future__ import annotations

import itertools
import math

import pytest

from jauspy.geometry import joint_routes
from jauspy.geometry.joint_routes import MARGIN, STEP, ReachablePositions, RouteSearch, positions_between
from jauspy.geometry.link_clearances import LinkClearances
from jauspy.platform.link_clearances import clearances_of
from jauspy.robot.robot_files import load, robot_model

INC1 = robot_model(load("inc1"))
ARM = INC1.groups["arm"].joints
POSES = {pose.name: tuple(pose.positions[name] for name in ARM) for pose in INC1.poses}
CLEARANCES = clearances_of(INC1, ARM)
BESIDE_A_FLIPPER = (2.381, 1.333, -2.272, 0.279, 1.237)
"""The gripper is beside the left flipper, where the direct way to `stow` leads through that."""
OTHERS = {"base_link_to_flippers": 1.65}


def search(start, goal, others, by=()) -> RouteSearch:
    found = RouteSearch(ReachablePositions(CLEARANCES, ARM, start, others), start, goal, by)
    for _ in range(1000):
        if found.is_finished:
            return found
        found.advance(20)
    raise AssertionError("the search does not end")


def least_clearance(start, route, others) -> float:
    """The least clearance on a route, measured in steps a quarter of those of the search."""
    least = math.inf
    for one, other in itertools.pairwise((start, *route)):
        for positions in positions_between(one, other, STEP / 4.0):
            found = CLEARANCES.at({**others, **dict(zip(ARM, positions, strict=True))}, MARGIN)
            least = min(least, *found.values(), MARGIN)
    return least


@pytest.mark.slow
@pytest.mark.parametrize(("start", "goal"), list(itertools.permutations(POSES, 2)))
def test_direct_ways_connect_the_poses_of_inc1(start: str, goal: str) -> None:
    found = search(POSES[start], POSES[goal], {"base_link_to_flippers": 2.2})
    assert found.route == (POSES[goal],)
    assert found.obstacle is None
    assert least_clearance(POSES[start], found.route, {"base_link_to_flippers": 2.2}) > MARGIN / 2.0


@pytest.mark.slow
def test_a_route_leads_around_what_is_on_the_direct_way() -> None:
    found = search(BESIDE_A_FLIPPER, POSES["stow"], OTHERS, [POSES["inspect"]])
    assert found.obstacle == ("left_flipper", "gripper_link")
    assert found.route is not None
    assert len(found.route) > 1
    assert found.route[-1] == POSES["stow"]
    assert least_clearance(BESIDE_A_FLIPPER, (POSES["stow"],), OTHERS) < 0.0, "the direct way would touch"
    assert least_clearance(BESIDE_A_FLIPPER, found.route, OTHERS) > MARGIN / 2.0
    again = search(BESIDE_A_FLIPPER, POSES["stow"], OTHERS, [POSES["inspect"]])
    assert again.route == found.route


def test_no_route_into_a_contact() -> None:
    into_the_deck = (0.0, -0.4, 0.0, 0.0, 0.0)
    found = search(POSES["inspect"], into_the_deck, {})
    assert found.route is None
    assert found.obstacle is not None


def test_a_search_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(joint_routes, "MAX_CHECKS", 30)
    found = search(POSES["stow"], POSES["reach_low"], {})
    assert found.is_finished
    assert found.route is None


def test_no_way_is_a_route() -> None:
    found = search(POSES["stow"], POSES["stow"], {})
    assert found.route == (POSES["stow"],)


def test_links_that_begin_too_near_may_part_but_come_no_nearer() -> None:
    class OneClearance(LinkClearances):
        def __init__(self) -> None:
            """A link whose clearance from the wall is its position."""

        def at(self, positions, below):
            return {("link", "wall"): positions["x"]} if positions["x"] < below else {}

    reachable = ReachablePositions(OneClearance(), ["x"], (0.003,), {})
    assert reachable.obstacle((0.0025,)) is None, "rounding"
    assert reachable.obstacle((0.02,)) is None
    assert reachable.obstacle((0.001,)) == ("link", "wall")
    assert reachable.obstacle_on((0.02,), ((0.1,), (-0.1,))) == ("link", "wall")
    assert ReachablePositions(OneClearance(), ["x"], (0.02,), {}).obstacle((0.007,)) == ("link", "wall")
