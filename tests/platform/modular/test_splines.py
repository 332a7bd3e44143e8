"""Splines through points with times: values, continuity, and refusals that name joint, time and figure."""

import math

import numpy as np
import pytest

pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from jauspy.platform.modular.splines import Knots, Spline
from jauspy.platform.modular.trajectory import Limits, MotionError, Setpoint

FREE = math.nan
REST = Setpoint(np.zeros(2), np.zeros(2), np.zeros(2))
LIMITS = Limits((2.0, 2.0), (20.0, 20.0), (200.0, 200.0))


def knots(*points, velocities=None, accelerations=None):
    positions = np.array([point[1:] for point in points], dtype=float)
    free = np.full_like(positions, FREE)
    times = np.array([point[0] for point in points], dtype=float)
    return Knots(
        times,
        positions,
        free if velocities is None else np.array(velocities, dtype=float),
        free.copy() if accelerations is None else np.array(accelerations, dtype=float),
    )


POINTS = ((0.6, 0.4, -0.2), (1.1, 0.5, 0.3), (2.0, -0.1, 0.1))


def both_sides(spline, time):
    return spline.at_time(time - 1e-9), spline.at_time(time + 1e-9)


def test_cubic_passes_the_points_with_continuous_velocity_and_acceleration():
    spline = Spline(REST, knots(*POINTS))
    for time, *positions in POINTS:
        assert spline.at_time(time)[0] == pytest.approx(positions, abs=1e-12)
    for time, *_ in POINTS[:-1]:
        before, after = both_sides(spline, time)
        assert before[1] == pytest.approx(after[1], abs=1e-6)
        assert before[2] == pytest.approx(after[2], abs=1e-5)
        assert np.abs(after[1]).max() > 0.1, "it does not stop at the points"
    assert spline.at_time(0.0)[1] == pytest.approx([0.0, 0.0])
    assert spline.at_time(2.0)[1] == pytest.approx([0.0, 0.0], abs=1e-12)


def test_it_is_the_natural_choice_of_scipy():
    interpolate = pytest.importorskip("scipy.interpolate")
    spline = Spline(REST, knots(*POINTS))
    times = [0.0, *(point[0] for point in POINTS)]
    rows = np.vstack((REST.q, [point[1:] for point in POINTS]))
    expected = interpolate.CubicSpline(times, rows, bc_type="clamped")
    for time in np.linspace(0.0, 2.0, 57):
        q, v, a = spline.at_time(float(time))
        assert q == pytest.approx(expected(time), abs=1e-9)
        assert v == pytest.approx(expected(time, 1), abs=1e-9)
    assert a == pytest.approx(expected(2.0, 2), abs=1e-8)


def test_given_velocities_are_kept_and_others_are_free():
    spline = Spline(REST, knots(*POINTS, velocities=[[0.3, FREE], [FREE, -0.4], [FREE, FREE]]))
    assert spline.at_time(0.6)[1][0] == pytest.approx(0.3)
    assert spline.at_time(1.1)[1][1] == pytest.approx(-0.4)
    before, after = both_sides(spline, 0.6)
    assert before[2][1] == pytest.approx(after[2][1], abs=1e-5), "where it is free, the acceleration is continuous"
    assert before[1] == pytest.approx(after[1], abs=1e-6)


def test_given_accelerations_are_met_by_quintics():
    spline = Spline(REST, knots(*POINTS, accelerations=[[2.0, FREE], [FREE, FREE], [FREE, FREE]]))
    before, after = both_sides(spline, 0.6)
    assert before[2][0] == pytest.approx(2.0, abs=1e-5)
    assert after[2][0] == pytest.approx(2.0, abs=1e-5)
    assert spline.at_time(0.0)[2][0] == pytest.approx(0.0, abs=1e-9)
    before, after = both_sides(spline, 1.1)
    for order in (0, 1, 2):
        assert before[order] == pytest.approx(after[order], abs=1e-4)


def test_it_begins_at_the_present_velocity():
    moving = Setpoint(np.array([0.1, 0.0]), np.array([0.5, -0.2]), np.zeros(2))
    q, v, _ = Spline(moving, knots(*POINTS)).at_time(0.0)
    assert q == pytest.approx([0.1, 0.0])
    assert v == pytest.approx([0.5, -0.2])


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (knots((0.0, 0.1, 0.1)), "point 1 is at 0 s, 0 ms after the one before; it takes at least 10 ms"),
        (knots((0.5, 0.1, 0.1), (0.4, 0.1, 0.1)), "point 2 is at 0.4 s, -100 ms after"),
        (knots((0.5, 0.1, 0.1), velocities=[[0.1, 0.0]]), "the last point has a velocity"),
        (knots((0.5, 0.1, 0.1), accelerations=[[FREE, 1.0]]), "the last point has a velocity or an acceleration"),
    ],
)
def test_points_that_make_no_path(given, text):
    with pytest.raises(MotionError, match=text):
        Spline(REST, given)


@pytest.mark.parametrize(
    ("given", "torque", "text"),
    [
        (knots((1.0, 0.1, 1.5)), 0.0, r"servo_2 turns at 2\.25 rad/s at 0\.5 s; its limit is 2"),
        (knots((0.1, 0.0, 0.08), (3.0, 0.0, 0.08)), 0.0, r"servo_2 accelerates by \d+(\.\d+)? rad/s\^2 at 0 s; its"),
        (knots((1.0, 0.1, 0.1)), 8.5, r"servo_1 needs 8\.5 N m at 0 s; its limit is 8"),
    ],
)
def test_refusals_name_joint_figure_and_time(given, torque, text):
    spline = Spline(REST, given)
    with pytest.raises(MotionError, match=text):
        spline.check(("servo_1", "servo_2"), LIMITS, lambda _: np.array([torque, 0.0]), (8.0, 8.0))


def test_within_limits_nothing_is_refused():
    Spline(REST, knots(*POINTS)).check(("servo_1", "servo_2"), LIMITS, lambda _: np.array([7.9, -7.9]), (8.0, 8.0))
