"""The path that a vehicle has driven: its shape is kept, its size is bounded."""

from __future__ import annotations

import itertools
import math
import random
import tracemalloc

import pytest

from jauspy.geometry.poses import PlanarPoint
from jauspy.services.mobility.driven_path import MAX_POINTS, TOLERANCE, DrivenPath, PathPoint, distance_to
from jauspy.services.mobility.retrace import distance_abeam, distance_to_circle, length_of, shortened, way_back


def point(x: float, y: float, *joints: float, backward: bool = False, speed: float = 0.5) -> PathPoint:
    return PathPoint(PlanarPoint(x, y), backward=backward, speed=speed, joints=joints)


def recorded(points) -> DrivenPath:
    path = DrivenPath()
    for point in points:
        path.record(point)
    return path


def test_straight_pieces_need_few_points_and_curves_as_many_as_their_shape() -> None:
    straight = recorded(point(0.01 * n, 0.0) for n in range(1001))
    assert len(straight) == pytest.approx(11, abs=2)
    turns = [(0.5 * math.cos(a / 50.0), 0.5 * math.sin(a / 50.0)) for a in range(315)]
    circle = recorded(point(x, y) for x, y in turns)
    assert 8 < len(circle) < 40
    ends = [point.position for point in circle.points]
    for x, y in turns:
        missed = min(distance_to(a, b, PlanarPoint(x, y)) for a, b in itertools.pairwise(ends))
        assert missed < TOLERANCE + 0.02


def test_vehicle_that_stands_adds_nothing_for_hours_even_if_its_joints_move() -> None:
    path = recorded([point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0)])
    for n in range(36_000):
        path.record(point(1.0 + 0.002 * math.sin(n), 0.0, math.sin(n / 50.0)))
    assert len(path) <= 6


@pytest.mark.slow
@pytest.mark.parametrize(("points", "hour"), [(512, 4_500), pytest.param(MAX_POINTS, 36_000, marks=pytest.mark.slow)])
def test_memory_is_bounded_for_hours_and_the_newest_part_is_kept(points: int, hour: int) -> None:
    """`hour` is the number of positions in an hour, at most ten a second; a shorter path is full sooner."""
    chance, path = random.Random(1), DrivenPath(points)
    x, y, yaw, place = 0.0, 0.0, 0.0, []
    tracemalloc.start()
    try:
        for n in range(3 * hour):
            yaw += chance.uniform(-0.3, 0.3)
            x, y = x + 0.05 * math.cos(yaw), y + 0.05 * math.sin(yaw)
            path.record(point(x, y, 2.0, speed=chance.uniform(0.2, 0.8)))
            if n % hour == hour - 1:
                place.append(tracemalloc.get_traced_memory()[0])
    finally:
        tracemalloc.stop()
    assert points // 2 < len(path) <= points + 1
    assert path.points[-1].position.to(PlanarPoint(x, y))[0] <= 0.1
    assert place[-1] < place[0] * 1.1 + 100_000
    assert place[-1] < 3_000_000 * points / MAX_POINTS + 100_000


def test_reversals_and_joints_are_points() -> None:
    out = [point(0.1 * n, 0.0, 1.0) for n in range(21)]
    lowered = [point(2.0, 0.0, 1.0 + 0.1 * n) for n in range(11)]
    back = [point(2.0 - 0.1 * n, 0.0, 2.0, backward=True) for n in range(11)]
    path = recorded([*out, *lowered, *back])
    legs = way_back(path.points)
    assert length_of(legs) == pytest.approx(3.0)
    assert next(leg.backward for leg in legs) is False
    assert [leg.backward for leg in legs][-1] is True
    assert {round(leg.joints[0], 1) for leg in legs if leg.length} == {1.0, 2.0}


def test_ways_are_shortened_by_distance_point_and_circle() -> None:
    legs = way_back([point(0.0, 0.0), point(4.0, 0.0), point(4.0, 3.0)])
    assert length_of(legs) == 7.0
    assert length_of(shortened(legs, 5.0)) == 5.0
    assert shortened(legs, 5.0)[-1].line.end.to(PlanarPoint(2.0, 0.0))[0] < 1e-9
    assert shortened(legs, 0.0) == []
    assert shortened(legs, 1e6) == legs
    assert distance_abeam(legs, PlanarPoint(1.0, -5.0)) == pytest.approx(6.0)
    assert distance_to_circle(legs, PlanarPoint(0.0, 0.0), 1.0) == pytest.approx(6.0)
    assert distance_to_circle(legs, PlanarPoint(0.0, 0.0), 100.0) == 0.0
    assert distance_to_circle(legs, PlanarPoint(-50.0, 0.0), 1.0) == 7.0


def test_part_that_is_driven_back_is_cut_off() -> None:
    path = recorded(point(0.1 * n, 0.0) for n in range(41))
    before = len(path)
    path.cut(2, point(1.5, 0.1))
    assert len(path) == 3 < before
    path.record(point(1.5, 0.4))
    path.record(point(1.5, 0.8))
    assert path.points[-1].position == PlanarPoint(1.5, 0.8)
    path.cut(0, point(9.0, 9.0))
    assert [point.position for point in path.points] == [PlanarPoint(9.0, 9.0)]
