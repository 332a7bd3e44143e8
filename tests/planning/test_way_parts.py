"""A way in parts: where flippers are set, and which parts are too short to be driven."""

import numpy as np
import pytest

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.planning.ground import Ground
from jauspy.planning.legs import PathPoint
from jauspy.planning.mobility import FLIPPER_ANGLE, Mobility
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.planning.way_parts import SHORT, STEP_ROOM, Part, parts, without_short_start

MOBILITY = Mobility(front=0.4, back=0.4, half_width=0.3, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)
WAY = (PathPoint(-3.0, 0.0), PathPoint(3.0, 0.0))


class Kerb:
    """0.12 m high, at x = 0."""

    origin = (-4.0, -4.0)
    resolution = 0.1
    heights = np.where(np.arange(80) >= 40, 0.12, 0.0).astype(np.float32) * np.ones((80, 1), np.float32)


def terrain(elevation=None) -> TerrainCost:
    cells = np.zeros((80, 80), bool)
    return TerrainCost(
        MOBILITY, cells, ~cells, (-4.0, -4.0), 0.1, ground=None if elevation is None else Ground.of(elevation, MOBILITY)
    )


def test_flippers_are_set_near_a_step_only():
    assert parts(WAY, terrain(), flippers=True) == [Part(WAY, None)]
    before, climb, after = parts(WAY, terrain(Kerb()), flippers=True)
    assert [part.flippers for part in (before, climb, after)] == [None, FLIPPER_ANGLE, None]
    assert before.points[-1].x == pytest.approx(-STEP_ROOM, abs=0.3)
    assert climb.points[-1].x == pytest.approx(STEP_ROOM, abs=0.3)
    assert (before.points[0], after.points[-1]) == WAY


@pytest.mark.parametrize(("length", "count"), [(SHORT - 0.05, 1), (SHORT + 0.05, 2)])
def test_a_short_part_before_a_step_is_left_out(length: float, count: int):
    """A robot that is past its end would turn back for it."""
    here, edge, beyond = PathPoint(-length, 0.1), PathPoint(0.0, 0.0), PathPoint(1.0, 0.0)
    found = without_short_start([Part((here, edge), None), Part((edge, beyond), 0.1)])
    assert len(found) == count
    assert found[0].points[0] == here
    assert found[-1].flippers == 0.1
    assert found[-1].points[-1] == beyond


def test_tight_places_are_parts_of_their_own():
    cells = np.zeros((80, 80), bool)
    cells[[34, 46], :40] = True  # walls 1.2 m apart, up to x = 0
    found = TerrainCost(MOBILITY, cells, np.ones_like(cells), (-4.0, -4.0), 0.1)
    way = tuple(PathPoint(x, 0.05) for x in (-3.0, -2.0, 1.0, 2.0, 3.0))
    assert parts(way, found, flippers=False) == [Part(way, None)], "it keeps far from where it would touch"
    found.is_exact = True
    assert parts(way, found, flippers=False) == [Part(way[:3], None, is_tight=True), Part(way[2:], None)]
    assert parts(way[:1], found, flippers=False) == [Part(way[:1], None)], "the robot is there"


def test_no_corner_is_left_out_in_a_tight_place():
    here, corner, beyond = PathPoint(0.0, 0.0), PathPoint(0.1, 0.0), PathPoint(0.1, 1.0)
    for tight in ((True, False), (False, True)):
        found = [
            Part(points, None, is_tight)
            for points, is_tight in zip(((here, corner), (corner, beyond)), tight, strict=True)
        ]
        assert without_short_start(found) == found


def test_the_last_part_is_driven_however_short_it_is():
    part = Part((PathPoint(0.0, 0.0), PathPoint(0.1, 0.0)), None)
    assert without_short_start([part]) == [part]
