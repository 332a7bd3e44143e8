"""The path of a leader: lengths along it, places beside it, leaders that turn, stand and drive back, and its bounds."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, strategies as st

from jauspy.geometry.poses import PlanarPoint
from jauspy.services.iop.leader_path import MAX_POINTS, SPACING, LeaderPath


def driven(*points: tuple[float, float], step: float = 0.1) -> LeaderPath:
    """The follower at the first point; the leader drove along the others, `step` metres each 0.1 s."""
    first, second, *rest = points
    path = LeaderPath(PlanarPoint(*first), PlanarPoint(*second), 0.0)
    now, x, y = 0.0, *second
    for target in rest:
        length = math.hypot(target[0] - x, target[1] - y)
        heading = math.atan2(target[1] - y, target[0] - x)
        for _ in range(round(length / step)):
            now += 0.1
            x, y = x + step * math.cos(heading), y + step * math.sin(heading)
            path.extend(PlanarPoint(x, y), heading, now)
    return path


def test_lengths_are_those_along_the_path_and_not_of_the_chord() -> None:
    path = driven((0, 0), (1, 0), (4, 0), (4, 3))
    assert path.leader.along == pytest.approx(7.0)
    place = path.follower(PlanarPoint(0.5, 0.2))
    assert (place.along, place.aside) == pytest.approx((0.5, 0.2))
    assert place.direction == pytest.approx(0.0)


def test_point_ahead_is_on_the_path_and_beyond_the_leader_straight_on() -> None:
    path = driven((0, 0), (1, 0), (4, 0), (4, 3))
    point, direction = path.point(5.0)
    assert (point.x, point.y, direction) == pytest.approx((4.0, 1.0, math.pi / 2))
    point, direction = path.point(8.0)
    assert (point.x, point.y, direction) == pytest.approx((4.0, 4.0, math.pi / 2))


def test_where_the_leader_was_at_a_time() -> None:
    path = driven((0, 0), (1, 0), (4, 0))
    assert path.passed(1.05) == pytest.approx(1.0 + 1.05)
    assert path.passed(-5.0) == 0.0
    assert path.passed(99.0) == pytest.approx(4.0)


def test_a_leader_that_stands_adds_nothing_but_time() -> None:
    path = driven((0, 0), (1, 0), (4, 0))
    count = len(path)
    for number in range(100):
        path.extend(PlanarPoint(4.0 + 0.01 * (-1) ** number, 0.005), 0.0, 4.0 + 0.1 * number)
    assert path.leader.along == pytest.approx(4.0, abs=0.05)
    assert len(path) <= count + 1
    assert path.leader.time == pytest.approx(13.9)


def test_a_leader_that_drives_back_shortens_the_path() -> None:
    path = driven((0, 0), (1, 0), (4, 0))
    for number in range(1, 21):
        path.extend(PlanarPoint(4.0 - 0.1 * number, 0.0), 0.0, 4.0 + 0.1 * number)
    assert path.leader.along == pytest.approx(2.0, abs=SPACING)


def test_a_leader_that_turned_round_and_drives_ahead_prolongs_the_path() -> None:
    path = driven((0, 0), (1, 0), (4, 0))
    for number in range(1, 21):
        path.extend(PlanarPoint(4.0 - 0.1 * number, 0.0), math.pi, 4.0 + 0.1 * number)
    assert path.leader.along == pytest.approx(6.0, abs=2.5 * SPACING)


def test_a_follower_is_not_looked_for_on_a_later_part_that_comes_near() -> None:
    path = driven((0, 0), (1, 0), (6, 0), (6, 0.5), (0, 0.5))
    assert path.follower(PlanarPoint(0.5, 0.45)).along == pytest.approx(0.5)


def test_places_never_go_back() -> None:
    path = driven((0, 0), (1, 0), (4, 0))
    assert path.follower(PlanarPoint(1.2, 0.0)).along == pytest.approx(1.2)
    assert path.follower(PlanarPoint(0.7, 0.0)).along == pytest.approx(1.2)


def test_the_path_is_bounded_and_forgets_what_is_behind() -> None:
    path = driven((0, 0), (1, 0), (2 * MAX_POINTS * 0.1, 0), step=0.11)
    assert len(path) == MAX_POINTS
    assert path.is_full
    for x in range(40):
        path.follower(PlanarPoint(float(x), 0.0))
    assert len(path) < MAX_POINTS - 300
    assert not path.is_full


@given(st.lists(st.tuples(*[st.floats(-50.0, 50.0)] * 2, st.floats(-math.pi, math.pi)), max_size=60))
def test_any_poses_leave_a_path_whose_lengths_grow(poses: list[tuple[float, float, float]]) -> None:
    path = LeaderPath(PlanarPoint(0.0, 0.0), PlanarPoint(2.0, 0.0), 0.0)
    for number, (x, y, heading) in enumerate(poses):
        path.extend(PlanarPoint(x, y), heading, 0.1 * number)
        place = path.follower(PlanarPoint(0.1 * number, 0.0))
        assert all(math.isfinite(value) for value in (place.along, place.direction, place.aside, path.leader.along))
        point, direction = path.point(place.along + 0.6)
        assert all(map(math.isfinite, (point.x, point.y, direction)))
        lengths = [point.along for point in path._points]
        assert lengths == sorted(lengths)
