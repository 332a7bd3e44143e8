"""Paths around obstacles: length, headings, turns, and why there is none."""

import itertools
import math
import time
from dataclasses import dataclass, replace

import numpy as np
import pytest

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.geometry.poses import PlanarPose
from jauspy.planning.ground import Ground
from jauspy.planning.legs import is_leg_free, way_cost
from jauspy.planning.mobility import Mobility
from jauspy.planning.path_search import ROOMS, NoPath, find_path, find_path_with_margins
from jauspy.planning.terrain_cost import TerrainCost

MOBILITY = Mobility(front=0.4, back=0.4, half_width=0.3, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)


def terrain(*boxes: tuple[float, float, float, float], side=10.0, mobility=MOBILITY) -> TerrainCost:
    """A square map with boxes of x, y, x, y in metres."""
    count = round(side / 0.1)
    occupied = np.zeros((count, count), bool)
    for x0, y0, x1, y1 in boxes:
        low, high = ((np.array([[y0, x0], [y1, x1]]) + side / 2.0) / 0.1).round().astype(int)
        occupied[low[0] : high[0], low[1] : high[1]] = True
    return TerrainCost(mobility, occupied, np.ones_like(occupied), (-side / 2.0,) * 2, 0.1)


def assert_free(found: TerrainCost, path) -> None:
    assert all(is_leg_free(found, a, b) for a, b in zip(path.points, path.points[1:], strict=False))


def test_free_ground_is_crossed_straight():
    path = find_path(terrain(), PlanarPose(-3.0, 0.0, 0.0), (3.0, 1.0))
    assert path.length == pytest.approx(math.hypot(6.0, 1.0), abs=0.2)
    assert len(path.points) <= 4


def test_a_wall_is_passed_at_its_end():
    found = terrain((-0.2, -5.0, 0.2, 2.0))
    path = find_path(found, PlanarPose(-2.0, 0.0, 0.0), (2.0, 0.0))
    assert_free(found, path)
    shortest = 2.0 * math.hypot(2.0 - 0.2, 2.3) + 0.4
    assert path.length < 1.25 * shortest


def test_a_door_is_passed_straight():
    found = terrain((-0.1, -5.0, 0.1, -0.5), (-0.1, 0.5, 0.1, 5.0))
    path = find_path(found, PlanarPose(-2.0, -2.0, 0.0), (2.0, 2.0))
    assert_free(found, path)


def doors(cells: int, other: slice = slice(0, 0)) -> TerrainCost:
    """A wall with a door of so many cells of 5 cm, and another one in these rows."""
    occupied = np.zeros((120, 120), bool)
    occupied[:, 60] = True
    occupied[60 : 60 + cells, 60] = occupied[other, 60] = False
    return TerrainCost(MOBILITY, occupied, np.ones_like(occupied), (-3.0, -3.0), 0.05)


def crossing(path) -> float:
    """Where the wall is crossed, y in metres."""
    before, after = next(leg for leg in itertools.pairwise(path.points) if (leg[0].x < 0.0) != (leg[1].x < 0.0))
    return before.y - before.x * (after.y - before.y) / (after.x - before.x)


def test_a_wide_way_is_taken_unless_it_is_a_detour():
    """A robot that is some centimetres off its leg does not touch the end of a wall."""
    start, goal = PlanarPose(-1.5, 0.3, 0.0), (1.5, 0.3)
    crossed = {}
    for name, rows in (("near", slice(78, 110)), ("far", slice(0, 24))):
        found = doors(14, other=rows)
        path = find_path(found, start, goal)
        assert_free(found, path)
        crossed[name] = crossing(path)
    assert crossed["near"] > 0.9, "the wide door"
    assert 0.0 < crossed["far"] < 0.7, "the narrow one"


LONGER = replace(MOBILITY, front=0.5, back=0.5)
CROSSING = ((-4.0, -0.7, 4.0, -0.5), (-4.0, 0.6, -0.4, 0.8), (0.4, 0.6, 4.0, 0.8))
"""A corridor of 1.1 m with a door of 0.8 m in one wall, and open ends."""


def test_a_robot_turns_closely_where_it_would_drive_far_to_turn():
    found, start, goal = terrain(*CROSSING, mobility=LONGER), PlanarPose(0.0, 0.0, 0.0), (0.0, 2.0)
    assert find_path(found, start, goal).length > 7.0, "to the end of the corridor"
    path = find_path_with_margins(found, start, goal, backward=True, end=time.thread_time() + 10.0)
    assert found.is_exact
    assert path.length < 3.0
    assert_free(found, path)
    nearer = start._replace(x=-3.5)
    path = find_path_with_margins(found, nearer, (-3.5, 2.0), backward=True, end=time.thread_time() + 10.0)
    assert not found.is_exact, "the way around the end is not much longer"
    assert_free(found, path)


def test_a_goal_beside_a_kerb_is_reached_as_near_to_it_as_the_robot_can_stand():
    heights = np.zeros((100, 100), np.float32)
    heights[:, :50] = 0.12
    bare = terrain()
    found = TerrainCost(
        MOBILITY, bare.blocked, ~bare.blocked, (-5.0, -5.0), 0.1, ground=Ground.of(Heights(heights), MOBILITY)
    )
    beside = next(0.05 * number for number in range(20) if not found.is_astride(0.05 * number, 2.0, math.pi / 2.0))
    goal = (beside - 0.2, 2.0)
    path = find_path(found, PlanarPose(goal[0] + 0.3, -2.0, math.pi / 2.0), goal)
    assert path.expanded < 100
    end = path.points[-1]
    assert math.dist(end[:2], goal) < 0.5
    assert not found.is_astride(end.x, end.y, math.pi / 2.0)


def test_legs_are_free_from_where_the_robot_turns_onto_them():
    """A robot that turns on the spot drives a curve as two straight legs."""
    found = doors(13)
    found.is_exact = True
    assert_free(found, find_path(found, PlanarPose(-1.5, 1.5, 0.0), (1.5, -0.9)))


@dataclass
class Heights:
    heights: np.ndarray
    origin: tuple[float, float] = (-5.0, -5.0)
    resolution: float = 0.1


def with_strap(*boxes: tuple[float, float, float, float]) -> TerrainCost:
    """Ground with a strap across the way, 0.5 m long and 3 cm high, and boxes."""
    heights = np.zeros((100, 100), np.float32)
    heights[48:53, 50:52] = 0.03
    bare = terrain(*boxes)
    return TerrainCost(
        MOBILITY,
        bare.blocked,
        np.ones_like(bare.blocked),
        (-5.0, -5.0),
        0.1,
        ground=Ground.of(Heights(heights), MOBILITY),
    )


def test_what_lies_on_the_ground_is_not_driven_over_where_there_is_another_way():
    start, goal = PlanarPose(-2.0, 0.0, 0.0), (2.0, 0.0)
    end = time.thread_time() + 5.0
    found = with_strap()
    path = find_path_with_margins(found, start, goal, backward=True, end=end)
    assert abs(crossing(path)) > 0.6
    assert path.length < 5.5
    found = with_strap((-0.5, 0.5, 0.5, 5.0), (-0.5, -5.0, 0.5, -0.5))
    path = find_path_with_margins(found, start, goal, backward=True, end=end)
    assert abs(crossing(path)) < 0.2, "between walls it is driven over"
    assert_free(found, path)
    far = with_strap((-0.5, 0.5, 0.5, 5.0), (-0.5, -3.9, 0.5, -0.5))
    path = find_path_with_margins(far, start, goal, backward=True, end=end)
    assert abs(crossing(path)) < 0.2, "the way around is too long"


def test_a_narrow_door_is_passed_in_the_middle_where_it_is_wider_than_needed():
    for cells in (16, 18):
        found = doors(cells)
        path = find_path(found, PlanarPose(-1.5, 1.2, -1.5), (1.5, -0.6))
        assert crossing(path) == pytest.approx(0.025 * cells, abs=0.06)


def test_a_door_that_is_too_narrow_on_the_map_is_not_passed():
    start, goal = PlanarPose(-1.5, 0.3, 0.0), (1.5, 0.3)
    found = doors(14)
    assert_free(found, find_path_with_margins(found, start, goal, backward=True, end=time.thread_time() + 10.0))
    assert found.margin == 0.02
    with pytest.raises(NoPath, match="no way to"):
        find_path_with_margins(doors(12), start, goal, backward=True, end=time.thread_time() + 0.3)


@pytest.mark.parametrize(("other", "is_near"), [(slice(80, 110), False), (slice(0, 24), True)])
def test_less_room_is_taken_where_more_is_a_long_detour(other: slice, is_near: bool) -> None:
    """The near door leaves 2 cm on each side, the other one plenty."""
    found, start, goal = doors(14, other=other), PlanarPose(-0.8, 0.3, 0.0), (0.8, 0.3)
    path = find_path_with_margins(found, start, goal, backward=True, end=time.thread_time() + 10.0)
    assert (0.0 < crossing(path) < 0.65) is is_near
    assert found.margin == (0.02 if is_near else ROOMS[0].margin), "that of the way that was taken"
    assert_free(found, path)


def test_the_cost_of_a_way_is_that_of_its_legs_on_another_map():
    found = terrain((-0.2, -5.0, 0.2, 2.0))
    path = find_path(found, PlanarPose(-2.0, 0.0, 0.0), (2.0, 0.0))
    assert way_cost(found, path.points) == pytest.approx(path.cost, rel=0.1)
    assert way_cost(terrain(), path.points) < path.cost, "nothing is near"
    assert way_cost(found, path.points[:1]) == 0.0


@dataclass
class Kerb:
    """Ground that is 15 cm higher from x = 0 on."""

    origin: tuple[float, float] = (-4.0, -4.0)
    resolution: float = 0.1

    @property
    def heights(self) -> np.ndarray:
        return np.where(np.arange(80)[None, :] >= 40, 0.15, 0.0).repeat(80, axis=0).astype(np.float32)


def test_a_goal_astride_of_a_kerb_is_refused_with_a_place_beside_it():
    cells = np.zeros((80, 80), bool)
    found = TerrainCost(MOBILITY, cells, ~cells, (-4.0, -4.0), 0.1, ground=Ground.of(Kerb(), MOBILITY))
    start = PlanarPose(-2.0, 0.0, 0.0)
    with pytest.raises(NoPath, match=r"at the edge of a step.*nearest place where it can stand") as error:
        find_path(found, start, (0.05, 0.0))
    assert "\n" not in str(error.value)
    up = find_path(found, start, (2.0, 0.0))
    assert math.dist(up.points[-1][:2], (2.0, 0.0)) < 0.2, "up the kerb, and on"
    assert not found.is_astride(*up.points[-1][:2], 0.0)
    find_path(found, start, (-0.9, 0.0))


def test_a_chassis_that_steers_drives_curves():
    found = terrain(mobility=replace(MOBILITY, min_turn_radius=1.0))
    path = find_path(found, PlanarPose(0.0, 0.0, math.pi), (2.0, 0.0), backward=False)
    assert path.length > 4.0, "it cannot turn on the spot"


def test_the_way_out_of_a_dead_end_is_driven_backward():
    corridor = ((-4.0, 0.45, 0.0, 0.6), (-4.0, -0.6, 0.0, -0.45), (-4.1, -0.6, -4.0, 0.6))
    found = terrain(*corridor)
    path = find_path(found, PlanarPose(-3.0, 0.0, math.pi), (2.0, 0.0))
    assert path.points[1].backward
    with pytest.raises(NoPath, match="wide enough"):
        find_path(found, PlanarPose(-3.0, 0.0, math.pi), (2.0, 0.0), backward=False)


@pytest.mark.parametrize(
    ("goal", "boxes", "text"),
    [
        ((9.0, 0.0), (), "outside of the map"),
        ((2.0, 0.0), ((1.5, -0.5, 2.5, 0.5),), "choose a goal"),
        ((2.0, 0.0), ((0.0, -5.0, 0.1, 5.0),), "there is no way"),
    ],
)
def test_without_a_way_the_reason_is_named(goal, boxes, text):
    with pytest.raises(NoPath, match=text):
        find_path(terrain(*boxes), PlanarPose(-2.0, 0.0, 0.0), goal)


def test_a_large_map_is_searched_in_well_below_half_a_second():
    """40 m x 40 m in cells of 0.1 m; processor time, since the machine has other work."""
    rng = np.random.default_rng(4)
    boxes = [(x, y, x + w, y + h) for x, y, w, h in rng.uniform((-18, -18, 0.2, 0.2), (16, 16, 1.5, 1.5), (100, 4))]
    began = time.thread_time()
    found = terrain(*boxes, side=40.0)
    path = find_path(found, PlanarPose(-19.0, -19.0, 0.0), (19.0, 19.0))
    assert time.thread_time() - began < 0.5
    assert path.length < 1.25 * math.hypot(38.0, 38.0)
    assert_free(found, path)
