"""Where a robot may stand and drive: footprint, unknown space, slopes, steps, tipping."""

import math
from dataclasses import dataclass

import numpy as np
import pytest

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.geometry.poses import PlanarPose
from jauspy.planning.ground import Ground, GroundMemory
from jauspy.planning.mobility import Mobility
from jauspy.planning.terrain_cost import THING_COST, TerrainCost

MOBILITY = Mobility(front=0.4, back=0.4, half_width=0.3, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)
SHAPE = (80, 80)
ORIGIN = (-4.0, -4.0)


@dataclass
class Elevation:
    heights: np.ndarray
    origin: tuple[float, float] = ORIGIN
    resolution: float = 0.1


def ground(height) -> Elevation:
    """Ground with the height that a function of x and y returns."""
    places = -4.0 + (np.arange(80) + 0.5) * 0.1
    return Elevation(np.array([[height(x, y) for x in places] for y in places], np.float32))


def terrain(elevation=None, occupied=(), *, known=True, hidden=None, ages=None, **options) -> TerrainCost:
    cells = np.zeros(SHAPE, bool)
    for row, column in occupied:
        cells[row, column] = True
    found = None if elevation is None else Ground.of(elevation, MOBILITY, hidden, ages)
    return TerrainCost(MOBILITY, cells, np.full(SHAPE, known), ORIGIN, 0.1, ground=found, **options)


def test_a_gap_that_fits_lengthwise_does_not_fit_across():
    wall = [(row, 40) for row in range(80) if abs(row - 40) > 4]  # 0.9 m between the centres of occupied cells
    found = terrain(occupied=wall)
    assert found.is_free(0.05, 0.05, 0.0)
    assert not found.is_free(0.05, 0.05, math.pi / 2.0)


def test_the_robot_may_leave_where_it_stands_too_near():
    found = terrain(occupied=[(40, 45)])
    pose = PlanarPose(0.08, 0.05, 0.0)
    assert not found.is_free(*pose)
    found.start_at(pose)
    assert found.is_free(*pose)
    assert not found.is_free(pose.x + 0.1, pose.y, 0.0), "it may not come nearer"


def test_unknown_space_costs_more_or_is_forbidden():
    assert terrain(known=False).cost_at(0.0, 0.0) > terrain().cost_at(0.0, 0.0)
    assert terrain(known=False).is_free(0.0, 0.0, 0.0)
    assert not terrain(known=False, allow_unknown=False).is_free(0.0, 0.0, 0.0)


def test_outside_of_the_map_nothing_is_free():
    assert not terrain().is_free(5.0, 0.0, 0.0)
    assert math.isinf(terrain().cost_at(5.0, 0.0))


@pytest.mark.parametrize(("grade", "ahead", "across"), [(0.15, True, True), (0.4, True, False), (0.8, False, False)])
def test_a_slope_is_driven_up_but_not_across_where_it_would_tip(grade, ahead, across):
    found = terrain(ground(lambda x, _: grade * max(0.0, x)))
    assert found.is_free(2.0, 0.0, 0.0) is ahead
    assert found.is_free(2.0, 0.0, math.pi / 2.0) is across


def test_a_low_step_is_ground_a_high_one_a_wall():
    assert terrain(ground(lambda x, _: 0.06 * (x > 0.0))).is_free(0.0, 0.0, 0.0)
    assert not terrain(ground(lambda x, _: 0.35 * (x > 0.0))).is_free(0.0, 0.0, 0.0)


def test_flippers_climb_a_step_straight_and_never_down():
    found = terrain(ground(lambda x, _: 0.15 * (x > 0.0)))
    assert found.needs_flippers(0.05, 0.0)
    assert found.is_free(0.05, 0.0, 0.0)
    assert not found.is_free(0.05, 0.0, math.radians(60.0)), "askew"
    assert not found.is_free(0.05, 0.0, math.pi), "down the kerb"


def test_a_step_that_is_seen_in_part_of_a_cell_is_one():
    kerb = ground(lambda x, _: 0.12 if x > 0.1 else 0.06 if x > 0.0 else 0.0)
    assert terrain(kerb).needs_flippers(0.05, 0.0)
    ramp = terrain(ground(lambda x, _: min(0.6, 0.5 * max(0.0, x))))
    assert not any(ramp.needs_flippers(x / 10.0 + 0.05, 0.0) for x in range(-10, 20))


def test_what_is_seen_of_a_wall_from_the_ground_up_is_no_step():
    seen = ground(lambda x, y: 0.15 if abs(x) < 0.1 and abs(y) < 0.6 else 0.0)
    wall = [(row, 40) for row in range(80)]
    assert terrain(seen).needs_flippers(-0.05, 0.0)
    assert not terrain(seen, wall).needs_flippers(-0.05, 0.0)
    kerb = terrain(ground(lambda x, _: 0.15 * (x > 0.0)), [(row, 60) for row in range(80)])
    assert kerb.needs_flippers(0.05, 0.0), "a wall two metres behind it"


def test_clearances_change_steadily_along_a_leg():
    found = terrain(occupied=[(60, column) for column in range(80)])
    xs = np.zeros(20)
    ys = np.linspace(0.5, 1.5, 20)
    clear = found.clearances(xs, ys, 0.0)
    assert np.diff(clear) == pytest.approx(np.full(19, -1.0 / 19.0), abs=0.002)
    assert clear[0] == pytest.approx(found.clearance(0.0, 0.5, 0.0), abs=0.06)
    assert found.clearances(np.array([9.0]), np.zeros(1), 0.0)[0] == -math.inf


def test_no_part_of_the_robot_is_on_a_step_that_it_does_not_climb_straight():
    found = terrain(ground(lambda x, _: 0.15 * (x > 0.0)))
    assert not found.is_free(-0.2, 0.0, math.pi / 2.0), "along the kerb, with a track on it"
    assert found.is_free(-0.6, 0.0, math.pi / 2.0)
    assert found.is_free(-0.2, 0.0, 0.0)
    assert found.is_free(-0.2, 0.0, 0.0, backward=True), "away from its foot"
    assert not found.is_free(0.05, 0.0, 0.0, backward=True), "down"
    beside = PlanarPose(-0.2, 0.0, math.pi / 2.0)
    found.start_at(beside)
    assert found.is_free(*beside), "it may leave"


def test_ground_beside_a_wall_is_driven_and_the_edge_above_it_is_not():
    found = terrain(ground(lambda x, _: 0.5 * (x > 0.0)))
    assert found.cell(-0.05, 0.0) is not None
    assert not found.blocked[found.cell(-0.05, 0.0)]
    assert found.blocked[found.cell(0.05, 0.0)]
    assert not found.needs_flippers(-0.05, 0.0)


def test_ground_that_an_edge_hides_is_taken_for_as_low_as_what_is_beyond():
    seen = ground(lambda x, _: 0.5 if x < 0.0 else math.nan if x < 1.0 else 0.0)
    assert not terrain(seen).is_free(0.0, 0.0, 0.0)
    walls = terrain(ground(lambda x, _: 1.0 if 0.6 < abs(x) < 0.8 else 0.0 if abs(x) > 0.8 else math.nan))
    assert not walls.blocked[walls.cell(0.0, 0.0)], "between two walls nothing is known"
    level = ground(lambda x, _: math.nan if 0.0 < x < 1.0 else 0.0)
    assert terrain(level).is_free(0.0, 0.0, 0.0)


def test_ground_is_taken_for_hidden_only_where_the_robot_was_near():
    """A road, and single places of a pavement 10 cm above it, which are all that is seen of it from afar."""

    def seen(x: float, y: float) -> float:
        if x < 0.0:
            return 0.0
        return 0.1 if x > 1.0 and (round(10.0 * x) + round(10.0 * y)) % 3 == 0 else math.nan

    known = ground(seen)
    far, near = (terrain(known, hidden=np.isnan(known.heights) & is_near) for is_near in (False, True))
    beside = [(1.05 + 0.1 * step, 0.05) for step in range(10)]
    assert not any(far.needs_flippers(*place) for place in beside)
    assert any(near.needs_flippers(*place) or near.clearance(*place, 0.0) < 0.0 for place in beside)


def crate(x: float, y: float) -> float:
    """A crate of 0.6 m x 0.6 m, of which only the side at x = 0 and some of the top are seen."""
    if x < 0.0 or abs(y) > 0.3:
        return math.nan if x > 0.6 and abs(y) < 0.6 else 0.0
    return 0.4 if x < 0.2 else math.nan


@pytest.mark.parametrize(("scan_height", "is_hidden"), [(0.6, True), (0.44, True), (0.3, False)])
def test_what_a_low_thing_hides_may_be_a_part_of_it(scan_height: float, is_hidden: bool) -> None:
    """A lidar that sees the thing also sees how long it is; that of inc1 has its plane 0.44 m up."""
    found = terrain(ground(crate), scan_height=scan_height)
    seen = terrain(ground(lambda x, y: 0.4 if 0.0 <= x < 0.2 and abs(y) <= 0.3 else 0.0), scan_height=scan_height)
    assert found.blocked[found.cell(0.05, 0.05)]
    for beside in ((0.65, 0.05), (0.75, 0.05)):
        assert (found.cost_at(*beside) > 4.0 + seen.cost_at(*beside)) is is_hidden
    for away in ((1.25, 0.05), (0.35, 1.05), (-0.65, 0.05)):
        assert found.cost_at(*away) < 1.0 + seen.cost_at(*away)


@pytest.mark.parametrize(("since", "is_shadow"), [(5.0, True), (0.5, False)])
def test_ground_behind_a_thing_that_was_seen_before_it_may_be_a_part_of_it(*, since: float, is_shadow: bool) -> None:
    """A crate that was put where the floor was known: the floor below its far side is still the one of then."""
    face = ground(lambda x, y: 0.4 if 0.0 <= x < 0.2 and abs(y) <= 0.3 else 0.0)
    ages = ground(lambda x, y: since if x > 0.2 and abs(y) < 0.3 else 0.0).heights
    found, new = terrain(face, ages=ages, scan_height=0.6), terrain(face, ages=0.0 * ages, scan_height=0.6)
    for beside in ((0.65, 0.05), (0.75, 0.05)):
        assert (found.cost_at(*beside) > 4.0 + new.cost_at(*beside)) is is_shadow
    assert found.cost_at(-0.65, 0.05) == new.cost_at(-0.65, 0.05)


@pytest.mark.parametrize(
    ("height", "scan_height", "is_blocked"), [(0.4, 0.44, True), (0.25, 0.44, True), (0.6, 0.44, False)]
)
def test_a_remembered_thing_is_left_to_the_lidar_only_if_it_sees_it(
    height: float, scan_height: float, is_blocked: bool
) -> None:
    memory = GroundMemory()
    seen = ground(lambda x, y: height if 0.0 <= x < 0.2 and abs(y) <= 0.3 else 0.0)
    memory.completed(Ground.of(seen, MOBILITY))
    forgotten = ground(lambda x, y: math.nan if x > -1.0 else 0.0)
    found = memory.completed(Ground.of(forgotten, MOBILITY, np.zeros(SHAPE, bool)))
    cells = np.zeros(SHAPE, bool)
    cost = TerrainCost(MOBILITY, cells, ~cells, ORIGIN, 0.1, ground=found, scan_height=scan_height)
    assert bool(cost.blocked[cost.cell(0.05, 0.05)]) is is_blocked


def test_a_thing_that_the_tracks_would_pass_is_rather_left_beside():
    found = terrain(ground(lambda x, y: 0.06 * (abs(x) < 0.1 and abs(y) < 0.1)))
    assert found.is_free(0.0, 0.0, 0.0)
    assert found.cost_at(0.05, 0.25) > 2.0 + found.cost_at(2.0, 2.0), "a track is on it"
    assert found.cost_at(0.05, 0.65) == found.cost_at(2.0, 2.0)


def test_a_wall_is_where_the_lidar_saw_it():
    """Heights, whose cells are coarser, make a door narrower by a cell at each side."""
    posts = ground(lambda x, y: 1.0 if abs(x) < 0.1 and abs(y - 0.05) > 0.25 else 0.0)
    wall = [(row, 40) for row in range(80) if abs(row - 40) > 3]
    assert terrain(posts, wall, scan_height=0.44).is_free(0.05, 0.05, 0.0)
    assert not terrain(posts, scan_height=0.44).is_free(0.05, 0.05, 0.0), "not seen by the lidar"


def test_a_ramp_that_the_lidar_takes_for_a_wall_is_ground():
    ramp = ground(lambda x, _: min(0.6, 0.3 * max(0.0, x)))
    wall = [(row, 55) for row in range(80)]  # x = 1.5, where the ramp is 0.45 m high
    assert terrain(ramp, wall, scan_height=0.44).is_free(1.5, 0.0, 0.0)
    assert not terrain(None, wall, scan_height=0.44).is_free(1.5, 0.0, 0.0)


def test_echoes_block_at_once():
    found = terrain(points=np.array([[1.0, 0.0], [9.0, 9.0], [-1e9, 0.0]]))
    assert not found.is_free(1.0, 0.0, 0.0)
    assert found.is_free(-1.0, 0.0, 0.0)


@pytest.mark.parametrize("slope", [0.0, 0.15])
def test_what_lies_on_the_ground_is_driven_around_and_a_sill_is_not(slope):
    base = ground(lambda x, y: slope * x + (0.03 if max(abs(x), abs(y)) < 0.18 else 0.0))
    sill = ground(lambda x, y: slope * x + (0.03 if abs(x) < 0.18 else 0.0))
    rough = ground(lambda x, y: slope * x + 0.005 * math.sin(40.0 * x) * math.sin(30.0 * y))
    plain = terrain(ground(lambda x, _: slope * x)).cost_at(0.0, 0.0)
    assert terrain(base).cost_at(0.0, 0.0) == pytest.approx(plain + THING_COST, abs=0.1)
    assert terrain(base).cost_at(0.0, 0.45) > plain + THING_COST - 0.1, "a track would pass it"
    assert terrain(base).cost_at(0.0, 1.0) == pytest.approx(plain, abs=0.1)
    assert terrain(sill).cost_at(0.0, 0.0) == pytest.approx(plain, abs=0.1)
    assert terrain(rough).cost_at(0.0, 0.0) == pytest.approx(plain, abs=0.1)
    assert terrain(base).is_free(0.0, 0.0, 0.0), "where there is no other way"


def test_the_base_of_a_cone_beside_its_body_is_avoided_too():
    def cone(base: float):
        return ground(lambda x, y: 0.45 if (out := max(abs(x), abs(y))) < 0.1 else base * (out < 0.2))

    assert terrain(cone(0.03)).cost_at(0.15, 0.45) > terrain(cone(0.0)).cost_at(0.15, 0.45) + 4.0


def test_what_lies_on_the_ground_is_an_obstacle_where_it_is_to_be():
    found = terrain(ground(lambda x, y: 0.03 if max(abs(x), abs(y)) < 0.18 else 0.0))
    assert found.has_things
    for keep_off in (True, False):
        found.keep_off_things(keep_off)
        assert found.is_free(0.0, 0.0, 0.0) is not keep_off
        assert found.is_free(1.0, 0.0, 0.0) is True
    assert not terrain(ground(lambda x, y: 0.0)).has_things


def test_a_kerb_that_is_seen_in_parts_is_nothing_that_lies_there():
    """From the road, some cells of a pavement are seen between others that are not."""
    seen = ground(lambda x, _: 0.12 if x > 1.0 else 0.0)
    columns, rows = np.meshgrid(np.arange(80), np.arange(80))
    seen.heights[(columns > 51) & ((columns + 2 * rows) % 5 > 1)] = np.nan
    assert not terrain(seen).has_things
