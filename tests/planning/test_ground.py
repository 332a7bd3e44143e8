"""What an elevation grid tells of the ground, and what is remembered of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

pytest.importorskip("scipy", reason="needs the extra `planning`")

from jauspy.planning.ground import SIZE, Ground, GroundMemory
from jauspy.planning.mobility import mobility_of
from jauspy.robot.robot_files import load, robot_model

SIDE = 0.1
CELLS = 40
MOBILITY = mobility_of(robot_model(load("inc1")))


@dataclass
class Elevation:
    heights: np.ndarray
    origin: tuple[float, float]
    resolution: float = SIDE


def seen(height, x: float = 0.0, y: float = 0.0, *, hidden: bool = True) -> Ground:
    """The ground of an elevation grid of 4 m around a point, with the heights that a function of x and y returns.

    What is unknown is hidden, so that it is taken for low ground, or was seen before.
    """
    first = [round(value / SIDE) - CELLS // 2 for value in (x, y)]
    xs, ys = ((number + np.arange(CELLS) + 0.5) * SIDE for number in first)
    heights = np.array([[height(a, b) for a in xs] for b in ys], np.float32)
    elevation = Elevation(heights, (first[0] * SIDE, first[1] * SIDE))
    return Ground.of(elevation, MOBILITY, np.isnan(heights) & hidden)


def kerb(x: float, _: float) -> float:
    return 0.1 if x > 0.0 else 0.0


def at(ground: Ground, layer: str, x: float, y: float) -> float:
    found = ground.resampled((x - 0.05, y - 0.05), SIDE, (1, 1))
    return float(getattr(found, layer)[0, 0])


@pytest.fixture
def memory() -> GroundMemory:
    return GroundMemory()


def test_an_edge_is_remembered_where_the_grid_has_left_it(memory: GroundMemory) -> None:
    assert at(memory.completed(seen(kerb)), "steps", 0.05, 0.5) == pytest.approx(0.1)
    elsewhere = memory.completed(seen(lambda x, y: 0.0, y=-4.0))
    assert at(elsewhere, "steps", 0.05, 0.5) == pytest.approx(0.1)
    assert at(elsewhere, "slope_x", 0.05, 0.5) > 0.1
    assert at(elsewhere, "heights", 0.55, 0.5) == pytest.approx(0.1)
    assert [at(elsewhere, "old", *place) for place in ((0.05, 0.5), (0.05, -4.0), (9.0, 0.0))] == [1, 0, 0]


def test_an_edge_stays_when_the_cells_beside_it_are_forgotten_one_by_one(memory: GroundMemory) -> None:
    memory.completed(seen(kerb))

    def kerb_from(least: float):
        return lambda x, y: math.nan if x < least else kerb(x, y)

    for column in range(CELLS):
        found = memory.completed(seen(kerb_from(-2.0 + SIDE * column), hidden=False))
        assert at(found, "steps", 0.05, 0.5) == pytest.approx(0.1)
    assert at(found, "old", 0.05, 0.5) == 1.0


@pytest.mark.parametrize("hidden", [True, False])
def test_a_thing_stays_when_it_is_forgotten_between_ground_that_is_seen(memory: GroundMemory, *, hidden: bool) -> None:
    """Also if it were taken for low ground."""
    crate = seen(lambda x, y: 0.25 if 0.0 < x < 0.5 and abs(y) < 0.3 else 0.0)
    memory.completed(crate)
    found = memory.completed(seen(lambda x, y: math.nan if -0.1 < x < 0.6 and abs(y) < 0.4 else 0.0, hidden=hidden))
    assert at(found, "walls", 0.05, 0.05) == pytest.approx(0.25)
    assert at(found, "heights", 0.25, 0.05) == pytest.approx(0.25)


def test_pavement_that_is_forgotten_makes_no_other_edge(memory: GroundMemory) -> None:
    memory.completed(seen(kerb))
    found = memory.completed(seen(lambda x, y: math.nan if 0.0 < x < 1.0 else kerb(x, y), hidden=False))
    assert at(found, "steps", 0.05, 0.5) == pytest.approx(0.1)
    assert at(found, "steps", 1.05, 0.5) == 0.0


def test_what_is_seen_again_is_as_it_is_now(memory: GroundMemory) -> None:
    memory.completed(seen(kerb))
    now = memory.completed(seen(lambda x, y: 0.0))
    assert at(now, "steps", 0.05, 0.5) == 0.0
    assert at(now, "old", 0.05, 0.5) == 0.0


def test_a_crate_that_has_come_is_there_although_it_hides_what_is_behind_it(memory: GroundMemory) -> None:
    memory.completed(seen(lambda x, y: 0.0))

    def crate(x: float, y: float) -> float:
        return 0.0 if x < 0.5 or abs(y) > 0.3 + 0.2 * (x - 0.5) else 0.25 if x < 0.6 else math.nan

    now = memory.completed(seen(crate, hidden=False))
    assert at(now, "walls", 0.55, 0.05) == pytest.approx(0.25)
    assert at(now, "heights", 0.55, 0.05) == pytest.approx(0.25)
    assert at(now, "old", 0.85, 0.05) == 1.0
    gone = memory.completed(seen(lambda x, y: 0.0))
    assert at(gone, "walls", 0.55, 0.05) == 0.0


def test_heights_of_different_times_make_no_step(memory: GroundMemory) -> None:
    """Poses drift: the ground was at 0 m, and what is beside it is at 0.1 m when it is seen later."""
    memory.completed(seen(lambda x, y: 0.0 if x < 0.0 else math.nan))
    later = memory.completed(seen(lambda x, y: 0.1 if x > 0.0 else math.nan))
    for x in (-0.15, -0.05, 0.05, 0.15):
        assert at(later, "steps", x, 0.5) == 0.0
        assert at(later, "walls", x, 0.5) == 0.0


def test_things_are_those_of_now(memory: GroundMemory) -> None:
    strap = seen(lambda x, y: 0.03 if abs(x) < 0.1 and abs(y) < 0.2 else 0.0)
    assert at(memory.completed(strap), "things", 0.05, 0.05) == 1.0
    assert at(memory.completed(seen(lambda x, y: 0.0, y=-5.0)), "things", 0.05, 0.05) == 0.0


def test_it_follows_the_robot_and_forgets_what_is_far_away(memory: GroundMemory) -> None:
    memory.completed(seen(kerb, y=4.0))
    for number in range(60):
        found = memory.completed(seen(lambda x, y: 0.0, y=-1.0 * number))
        assert found.heights.size <= (SIZE / SIDE) ** 2
        assert at(found, "heights", 0.05, -1.0 * number) == 0.0
        if number < 15:
            assert at(found, "steps", 0.05, 5.5) == pytest.approx(0.1)
    assert np.isnan(at(found, "heights", 0.05, 5.5))
    assert at(found, "heights", 0.05, -50.0) == 0.0
    jumped = memory.completed(seen(kerb, 1e5, -1e6))
    assert at(jumped, "heights", 1e5, -1e6) == pytest.approx(0.1)
    assert np.isfinite(jumped.heights).sum() == CELLS**2


def test_a_ground_that_was_told_does_not_change(memory: GroundMemory) -> None:
    """Threads still read it."""
    first = memory.completed(seen(kerb))
    before = first.steps.copy()
    memory.completed(seen(lambda x, y: 0.0))
    assert np.array_equal(first.steps, before)
