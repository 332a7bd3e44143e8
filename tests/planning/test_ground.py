"""What an elevation grid tells of the ground, and what is remembered of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

pytest.importorskip("scipy", reason="needs the extra `planning`")

from jauspy.planning.ground import Ground, GroundMemory
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

    What is `hidden` is taken for low ground, or stays unknown.
    """
    first = [round(value / SIDE) - CELLS // 2 for value in (x, y)]
    xs, ys = ((number + np.arange(CELLS) + 0.5) * SIDE for number in first)
    heights = np.array([[height(a, b) for a in xs] for b in ys], np.float32)
    elevation = Elevation(heights, (first[0] * SIDE, first[1] * SIDE))
    return Ground.of(elevation, MOBILITY, np.full(heights.shape, hidden))


def kerb(x: float, _: float) -> float:
    return 0.1 if x > 0.0 else 0.0


def at(ground: Ground, layer: str, x: float, y: float) -> float:
    found = ground.resampled((x - 0.05, y - 0.05), SIDE, (1, 1))
    return float(getattr(found, layer)[0, 0])


@pytest.fixture
def memory() -> GroundMemory:
    return GroundMemory(-10.0, 20.0)


def test_an_edge_is_remembered_where_the_grid_has_forgotten_it(memory: GroundMemory) -> None:
    assert at(memory.completed(seen(kerb)), "steps", 0.05, 0.5) == pytest.approx(0.1)
    forgotten = memory.completed(seen(lambda _, y: math.nan if y > 0.0 else 0.0, y=-3.0))
    assert at(forgotten, "steps", 0.05, 0.5) == pytest.approx(0.1)
    assert at(forgotten, "slope_x", 0.05, 0.5) > 0.1
    assert at(forgotten, "heights", 0.55, 0.5) == pytest.approx(0.1)
    assert (at(forgotten, "old", 0.05, 0.5), at(forgotten, "old", 0.05, -3.0)) == (1.0, 0.0)


def test_an_edge_stays_when_the_cells_beside_it_are_forgotten_one_by_one(memory: GroundMemory) -> None:
    memory.completed(seen(kerb))
    upper = memory.completed(seen(lambda x, y: 0.1 if x > 0.0 else math.nan))
    assert at(upper, "steps", 0.05, 0.5) == pytest.approx(0.1)


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


@pytest.mark.parametrize("place", [(9.0, -9.0), (30.0, 0.0), (-11.9, 4.0), (0.0, -1e6)])
def test_ground_beyond_the_memory_is_left_out(memory: GroundMemory, place: tuple[float, float]) -> None:
    found = memory.completed(seen(kerb, *place))
    assert found.heights.shape == (200, 200)
    inside = abs(place[0]) < 10.0 and abs(place[1]) < 10.0
    assert bool(np.isfinite(found.heights).any()) is (inside or place[0] == -11.9)
