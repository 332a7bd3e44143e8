"""Splines near paths of straight pieces: free where the path is, within speeds and accelerations."""

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from jauspy.cell.smoothing import smoothed

SPEEDS, ACCELERATIONS = np.array([1.0, 2.0]), np.array([5.0, 5.0])
CORNER = [np.array([0.0, 0.0]), np.array([1.0, 0.0]), np.array([1.0, 1.0])]


def off_the_path(posture: np.ndarray) -> float:
    """Distance from the two straight pieces of `CORNER`."""
    x, y = posture
    return min(float(np.hypot(x - min(1.0, max(0.0, x)), y)), float(np.hypot(x - 1.0, y - min(1.0, max(0.0, y)))))


def test_it_passes_the_points_and_ends_at_the_last_one():
    points = smoothed(CORNER, SPEEDS, ACCELERATIONS, lambda _: True)
    assert [point.positions for point in points] == [(1.0, 0.0), (1.0, 1.0)]
    straight = 1.9 * (1.0 / SPEEDS[0] + 1.0 / SPEEDS[1])
    assert points[-1].time < straight, "less than with a stop at the corner"


def test_it_comes_closer_to_the_path_until_it_is_free():
    checked = []

    def is_free(postures):
        checked.append(max(map(off_the_path, postures)))
        return checked[-1] < 0.04

    points = smoothed(CORNER, SPEEDS, ACCELERATIONS, is_free)
    assert len(points) > 2
    assert checked[0] > 0.04 > checked[-1]


def test_without_a_free_spline_there_is_none():
    assert smoothed(CORNER, SPEEDS, ACCELERATIONS, lambda _: False) is None


def test_postures_are_checked_closely():
    def is_free(postures):
        assert np.abs(np.diff(postures, axis=0)).max() < 0.1
        return True

    assert smoothed(CORNER, SPEEDS, ACCELERATIONS, is_free)
