"""Histories of poses and joints, and rays of scans."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jauspy.geometry.poses import Pose, Transform
from jauspy.mapping.sensor_feed import History, interpolated, rays
from jauspy.ocu.lidar import Scan


def test_histories_interpolate_and_begin_anew_when_a_clock_was_set() -> None:
    history: History[float] = History()
    assert history.around(1.0) is None
    for number in range(1000):
        history.note(float(number), float(number))
    assert history.around(998.25) == (998.0, 999.0, 0.25)
    assert history.around(5000.0) == (999.0, 999.0, 0.0)
    assert history.around(3.0) is None, "only the last are kept"
    history.note(5.0, 1.0)
    assert history.around(998.0) == (1.0, 1.0, 0.0)


def test_poses_are_interpolated_about_one_axis() -> None:
    before, after = Transform(), Transform.from_pose(Pose(x=1.0, yaw=1.0))
    middle = interpolated(before, after, 0.25).to_pose()
    assert (middle.x, middle.yaw) == pytest.approx((0.25, 0.25))


def test_rays_without_an_echo_show_free_space() -> None:
    points, empty = rays(Scan((0.0, math.pi / 2), (2.0, math.inf), (0.0, 0.0), None))
    assert points == pytest.approx(np.array([[2.0, 0.0, 0.0]]))
    assert empty == pytest.approx(np.array([[0.0, 1.0, 0.0]]), abs=1e-9)
