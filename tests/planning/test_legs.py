"""Straight legs: few of them in place of many motions, and in the middle of narrow places."""

from __future__ import annotations

import math

import numpy as np
import pytest

pytest.importorskip("scipy", reason="needs the extra `planning`")

import itertools

from jauspy.planning.legs import Motion, PathPoint, few_legs, is_leg_free, is_way_free, way_cost, with_more_room
from jauspy.planning.mobility import Mobility
from jauspy.planning.terrain_cost import TerrainCost

MOBILITY = Mobility(front=0.4, back=0.4, half_width=0.3, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)
CELL, COUNT = 0.05, 120
LOW = -0.5 * CELL * COUNT


def terrain(door: tuple[float, float] | None = None) -> TerrainCost:
    """A map of 6 m, with a wall along y and a door in it between these coordinates."""
    occupied = np.zeros((COUNT, COUNT), bool)
    if door is not None:
        occupied[:, 58:62] = True
        first, last = (round((end - LOW) / CELL) for end in door)
        occupied[first:last, 58:62] = False
    return TerrainCost(MOBILITY, occupied, np.ones_like(occupied), (LOW, LOW), CELL)


def motions(*points: tuple[float, float]) -> list[Motion]:
    """Motions of which each costs its length."""
    costs = [0.0]
    for before, after in itertools.pairwise(points):
        costs.append(costs[-1] + math.dist(before, after))
    return [Motion(PathPoint(*point), 0.0, cost) for point, cost in zip(points, costs, strict=True)]


def test_a_straight_leg_replaces_motions() -> None:
    zigzag = motions(*((0.2 * number, 0.02 * (number % 2)) for number in range(10)))
    assert few_legs(terrain(), zigzag) == [zigzag[0].end, zigzag[-1].end]


def test_a_corner_stays_where_the_straight_leg_is_not_free() -> None:
    around = motions((-1.0, -1.0), (-0.5, 0.0), (0.0, 0.0), (0.5, 0.0), (1.0, -1.0))
    legs = few_legs(terrain((-0.5, 0.5)), around)
    assert len(legs) > 2
    assert is_way_free(terrain((-0.5, 0.5)), legs)


def test_corners_move_to_the_middle_of_a_door() -> None:
    """A door of 0.8 m, which the way passes 0.08 m beside its middle, with 0.02 m left."""
    found = terrain((-0.4, 0.4))
    way = [PathPoint(-1.5, 0.0), PathPoint(-0.5, -0.08), PathPoint(0.5, -0.08), PathPoint(1.5, 0.0)]
    assert is_way_free(found, way)
    moved = with_more_room(found, way, 0.0)
    assert is_way_free(found, moved)
    assert [abs(point.y) <= 0.03 for point in moved] == 4 * [True]
    assert (moved[0], moved[-1]) == (way[0], way[-1])
    assert way_cost(found, moved) < way_cost(found, way)


def test_on_open_ground_corners_stay() -> None:
    way = [PathPoint(-1.0, 0.0), PathPoint(0.0, 1.0), PathPoint(1.0, 0.0)]
    assert with_more_room(terrain(), way, 0.0) == way


def test_no_corner_moves_to_where_the_robot_cannot_turn() -> None:
    found = terrain((-0.45, 0.45))
    way = [PathPoint(-1.5, 0.1), PathPoint(-0.9, 0.1), PathPoint(1.2, 0.1)]
    moved = with_more_room(found, way, math.pi / 2.0)
    for before, after in itertools.pairwise(moved):
        assert is_leg_free(found, before, after)
        heading = math.atan2(after.y - before.y, after.x - before.x)
        assert found.is_free(before.x, before.y, heading, turns=True)
